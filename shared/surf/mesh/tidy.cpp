#include "shared/surf/mesh/tidy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dobra::surf::mesh {

using Kernel = ChartSpace::Kernel;
using Vertex = Kernel::Vertex;
using Half = Kernel::Half;
using Cell = Kernel::Cell;
using geom::Vector3;

namespace {

constexpr double hopeless = 0.25;  ///< Loss after a sweep from which the next ones do not bring it back.
constexpr double poor = 0.9;       ///< Alpha below which a triangle counts twice, and more flips are tried.
double alpha_of(geom::Point3 a, geom::Point3 b, geom::Point3 c) {
  const Vector3 u = b - a, v = c - b, w = a - c;
  const Vector3 area = geom::cross(u, v);
  return 2.0 * std::numbers::sqrt3 * std::sqrt(dot(area, area)) / (dot(u, u) + dot(v, v) + dot(w, w));
}

class Tidier {
 public:
  Tidier(Kernel& kernel, ChartSpace& space, std::span<const std::uint8_t> fixed, const TidyOptions& options)
      : kernel_(kernel),
        space_(space),
        fixed_(fixed),
        options_(options),
        degree_(kernel.vertex_count(), 0),
        ideal_(kernel.vertex_count(), 6.0F),
        vertex_seen_(kernel.vertex_count(), 0),
        cell_seen_(kernel.cell_count(), 0) {
    for (Cell c = 0; c < kernel.cell_count(); ++c) {
      if (kernel.cell(c).region < 0) continue;
      for (const Vertex v : kernel.cell(c).vertex) ++degree_[v];
    }
    // A node that stays should have as many triangles as its angle holds of 60 degrees.
    for (Vertex v = 0; v < kernel.vertex_count(); ++v) {
      if (fixed[v] != 0) ideal_[v] = 0.0F;
    }
    for (Cell c = 0; c < kernel.cell_count(); ++c) {
      if (kernel.cell(c).region < 0) continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Half e = Kernel::half(c, i);
        const Vertex v = kernel.origin(e);
        if (fixed[v] == 0) continue;
        const Vector3 u = space.at(kernel.target(e)) - space.at(v), w = space.at(kernel.apex(e)) - space.at(v);
        const double angle = std::acos(std::clamp(dot(u, w) / std::sqrt(dot(u, u) * dot(w, w)), -1.0, 1.0));
        ideal_[v] += static_cast<float>(angle * 3.0 / std::numbers::pi);
      }
      const auto& v = kernel.cell(c).vertex;
      if (alpha_of(space.at(v[0]), space.at(v[1]), space.at(v[2])) < poor)
        todo_.insert(todo_.end(), v.begin(), v.end());
    }
    for (Vertex v = 0; v < kernel.vertex_count(); ++v) {
      if (odd(v, 0) >= 0.5F) todo_.push_back(v);
    }
  }

  /// One round over what there is to do; what is round the flips that it kept is to be done next.
  void sweep() {
    std::sort(todo_.begin(), todo_.end());
    todo_.erase(std::unique(todo_.begin(), todo_.end()), todo_.end());
    const std::vector<Vertex> now = std::exchange(todo_, {});
    for (const Vertex v : now) {
      if (kernel_.half_of(v) == Kernel::none || (odd(v, 0) < 0.5F && !is_poor(v))) continue;
      if (improve_round(v)) todo_.insert(todo_.end(), nodes_.begin(), nodes_.end());
    }
  }
  [[nodiscard]] const std::vector<Vertex>& todo() const { return todo_; }

 private:
  struct Star {
    double lost = 0.0;  ///< Sum of 1 - alpha.
    double least = 2.0;
  };

  /// Whether a triangle round v is so.
  [[nodiscard]] bool is_poor(Vertex v) const {
    const Half first = kernel_.half_of(v);
    Half e = first;
    do {
      if (kernel_.cell(Kernel::cell_of(e)).region >= 0 &&
          alpha_of(space_.at(v), space_.at(kernel_.target(e)), space_.at(kernel_.apex(e))) < poor)
        return true;
      e = kernel_.around(e);
    } while (e != first);
    return false;
  }

  /// Tries the sides of the triangles round v.
  bool improve_round(Vertex v) {
    sides_.clear();
    const Half first = kernel_.half_of(v);
    Half e = first;
    do {
      sides_.push_back(e);
      sides_.push_back(Kernel::next(e));
      e = kernel_.around(e);
    } while (e != first);
    for (const Half side : sides_) {
      if (try_flip(side)) return true;
    }
    return false;
  }

  /// How far a node is from the number of triangles that it should have, squared.
  [[nodiscard]] float odd(Vertex v, int change) const {
    const float off = static_cast<float>(static_cast<int>(degree_[v]) + change) - ideal_[v];
    return off * off;
  }

  bool try_flip(Half e) {
    const Half f = kernel_.twin(e);
    if (f == Kernel::none || kernel_.mark(e) != 0) return false;
    if (kernel_.cell(Kernel::cell_of(e)).region < 0 || kernel_.cell(Kernel::cell_of(f)).region < 0) return false;
    const Vertex a = kernel_.origin(e), b = kernel_.target(e), c = kernel_.apex(e), d = kernel_.apex(f);
    if ((fixed_[a] == 0 && degree_[a] <= 4) || (fixed_[b] == 0 && degree_[b] <= 4)) return false;
    const float before = odd(a, 0) + odd(b, 0) + odd(c, 0) + odd(d, 0);
    const float after = odd(a, -1) + odd(b, -1) + odd(c, 1) + odd(d, 1);
    const auto alpha = [&](Vertex p, Vertex q, Vertex r) { return alpha_of(space_.at(p), space_.at(q), space_.at(r)); };
    if (after > before + 0.5F && alpha(a, b, c) >= poor && alpha(b, a, d) >= poor) return false;
    if (after > before + 4.5F) return false;
    if (!space_.turns_left(kernel_.point(a), kernel_.point(d), kernel_.point(c)) ||
        !space_.turns_left(kernel_.point(d), kernel_.point(b), kernel_.point(c)))
      return false;
    if (!gather({a, b, c, d})) return false;
    const Star now = star();
    kernel_.flip(e);
    Star then;
    for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
      relax();
      then = star();
      if (then.lost > now.lost + hopeless) break;
    }
    if (is_better(now, then) && settle(now)) {
      --degree_[a];
      --degree_[b];
      ++degree_[c];
      ++degree_[d];
      return true;
    }
    put_back();
    kernel_.flip(e);
    return false;
  }

  /// The nodes that a flip moves, and their triangles. @return whether these are few enough to be worth it
  bool gather(const std::array<Vertex, 4>& seeds) {
    ++visit_;
    nodes_.clear();
    cells_.clear();
    std::uint32_t triangles = 0;
    const auto add = [&](Vertex v) {
      if (vertex_seen_[v] == visit_ || fixed_[v] != 0) return;
      vertex_seen_[v] = visit_;
      nodes_.push_back(v);
      triangles += degree_[v];
    };
    for (const Vertex v : seeds) add(v);
    if (triangles > options_.most_around) return false;
    const std::size_t inner = nodes_.size();
    for (std::size_t k = 0; k < inner; ++k) {
      const Half first = kernel_.half_of(nodes_[k]);
      Half e = first;
      do {
        add(kernel_.target(e));
        e = kernel_.around(e);
      } while (e != first);
    }
    if (triangles > options_.most_around) return false;
    for (const Vertex v : nodes_) {
      const Half first = kernel_.half_of(v);
      Half e = first;
      do {
        const Cell c = Kernel::cell_of(e);
        if (cell_seen_[c] != visit_) {
          cell_seen_[c] = visit_;
          cells_.push_back(c);
        }
        e = kernel_.around(e);
      } while (e != first);
    }
    given_.clear();
    for (const Vertex v : nodes_) given_.push_back(space_.place(v));
    return true;
  }

  [[nodiscard]] Star star() const {
    Star star;
    for (const Cell c : cells_) {
      const auto& v = kernel_.cell(c).vertex;
      const double alpha = alpha_of(space_.at(v[0]), space_.at(v[1]), space_.at(v[2]));
      star.lost += 1.0 - alpha + std::max(0.0, poor - alpha);
      star.least = std::min(star.least, alpha);
    }
    return star;
  }

  /// Each node goes to the mean of the tops of equilateral triangles over the sides around it.
  void relax() {
    for (const Vertex v : nodes_) {
      const auto frame = space_.frame(v);
      const geom::Point3 here = space_.at(v);
      Vector3 sum;
      double weights = 0.0;
      const Half first = kernel_.half_of(v);
      Half e = first;
      do {
        const geom::Point3 p = space_.at(kernel_.target(e)), q = space_.at(kernel_.apex(e));
        const Vector3 base = q - p;
        const double weight = 1.0 / dot(base, base);
        const Vector3 top = geom::midpoint(p, q) - here + 0.5 * std::numbers::sqrt3 * space_.left_of(frame, base);
        sum = sum + weight * top;
        weights += weight;
        e = kernel_.around(e);
      } while (e != first);
      space_.move(v, space_.moved(space_.place(v), sum / weights));
    }
  }

  /// Puts the nodes on the surface. @return whether all is well there
  bool settle(const Star& before) {
    for (const Vertex v : nodes_) {
      ChartSpace::Place place = space_.place(v);
      place.grounded = false;
      if (!space_.ground(place)) return false;
      space_.move(v, place);
    }
    for (const Cell c : cells_) {
      const auto& v = kernel_.cell(c).vertex;
      if (!space_.turns_left(kernel_.point(v[0]), kernel_.point(v[1]), kernel_.point(v[2]))) return false;
    }
    return is_better(before, star());
  }

  [[nodiscard]] bool is_better(const Star& before, const Star& then) const {
    return then.lost < before.lost - options_.least_gain && then.least >= std::min(before.least, options_.spared);
  }

  void put_back() {
    for (std::size_t k = 0; k < nodes_.size(); ++k) space_.move(nodes_[k], given_[k]);
  }

  Kernel& kernel_;
  ChartSpace& space_;
  std::span<const std::uint8_t> fixed_;
  const TidyOptions& options_;
  std::vector<std::uint32_t> degree_;  ///< Triangles of each vertex.
  std::vector<float> ideal_;           ///< How many there should be.
  std::vector<std::uint32_t> vertex_seen_, cell_seen_;
  std::uint32_t visit_ = 0;
  std::vector<Vertex> todo_;  ///< To be looked at in the next round.
  std::vector<Half> sides_;
  std::vector<Vertex> nodes_;
  std::vector<Cell> cells_;
  std::vector<ChartSpace::Place> given_;
};

}  // namespace

base::Result<std::vector<Vertex>> tidy(Kernel& kernel, ChartSpace& space, std::span<const std::uint8_t> fixed,
                                       const TidyOptions& options, const base::Progress& progress) {
  Tidier tidier(kernel, space, fixed, options);
  std::vector<Vertex> changed;
  for (int round = 0; round < options.rounds; ++round) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(round) / options.rounds, "nodes with six neighbours");
    tidier.sweep();
    if (tidier.todo().empty()) break;
    changed.insert(changed.end(), tidier.todo().begin(), tidier.todo().end());
  }
  return changed;
}

}  // namespace dobra::surf::mesh
