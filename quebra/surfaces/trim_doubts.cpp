#include "quebra/surfaces/trim_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "shared/geom/predicates.h"
#include "shared/surf/trim/finding.h"

namespace quebra::surfaces {

using namespace dobra;
using geom::Point;
using geom::Point3;
using surf::mesh::Finding;
using surf::trim::ChartEdge;
using surf::trim::OnCrack;
using surf::trim::TrimmedSurface;

namespace {

/// Whether a place lies inside a closed way, by how often a ray to the right crosses it.
bool encloses(const std::vector<Point>& way, Point p) {
  bool in = false;
  for (std::size_t i = 0, j = way.size() - 1; i < way.size(); j = i++) {
    const Point low = way[i].y < way[j].y ? way[i] : way[j], high = way[i].y < way[j].y ? way[j] : way[i];
    if ((low.y > p.y) == (high.y > p.y)) continue;
    in ^= geom::orient2d(low, high, p) == geom::Sign::Positive;
  }
  return in;
}

class Doubts {
 public:
  Doubts(const surf::Surface& surface, std::span<const DrawnTrim> drawn, std::span<const TrimmedSurface> parts,
         const TrimmedSurface& left, std::span<const OnCrack> on_cracks, const DoubtOptions& options)
      : surface_(surface), drawn_(drawn), left_(left), on_cracks_(on_cracks), options_(options) {
    for (const DrawnTrim& trim : drawn) boxes_.push_back(geom::box_of(trim.places));
    for (const TrimmedSurface& part : parts) {
      for (const auto& loop : part.loops) add(loop.edges, true);
      for (const auto& line : part.lines) add(line.edges, false);
    }
  }

  std::vector<Finding> run() {
    std::set<std::string> told;
    for (const DrawnTrim& trim : drawn_) {
      if (is_loop(trim.role)) continue;
      say_short(trim);
      if (told.insert(trim.name).second) say_useless(trim);
    }
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      if (!is_loop(drawn_[i].role)) continue;
      // Several of one name are the rings of one cut, which touch where the surfaces do.
      const auto of_name = [&](const DrawnTrim& other) { return other.name == drawn_[i].name; };
      if (std::count_if(drawn_.begin(), drawn_.end(), of_name) == 1) say_self_crossing(drawn_[i]);
      if (told.insert(drawn_[i].name).second) say_idle(drawn_[i]);
      for (std::size_t k = i + 1; k < drawn_.size(); ++k) {
        if (is_loop(drawn_[k].role) && !of_name(drawn_[k])) say_crossing(drawn_[i], drawn_[k]);
      }
    }
    say_on_cracks();
    return std::move(findings_);
  }

 private:
  /// A piece of a trim, or of a side of the chart, between places where it was cut; once.
  struct Piece {
    std::string name;
    Point from, middle, to;
    std::vector<Point3> at;  ///< Along it, in space.
    bool parting = false;    ///< Different parts on its two sides, or nothing on one.
  };

  void add(const std::vector<ChartEdge>& edges, bool parting) {
    for (const ChartEdge& edge : edges) {
      Piece piece{edge.name, edge.start(), edge.at(0.5 * (edge.from + edge.to)), edge.end(), {}, parting};
      std::vector<std::size_t>& own = of_[piece.name];
      const bool known =
          std::any_of(own.begin(), own.end(), [&](std::size_t i) { return same(pieces_[i].middle, piece.middle); });
      if (known) continue;
      constexpr int samples = 32;
      for (int i = 0; i <= samples; ++i)
        piece.at.push_back(surface_.at(edge.at(std::lerp(edge.from, edge.to, static_cast<double>(i) / samples))));
      own.push_back(pieces_.size());
      pieces_.push_back(std::move(piece));
    }
  }

  [[nodiscard]] bool same(Point a, Point b) const {
    const geom::Box& box = surface_.chart();
    return std::abs(a.x - b.x) <= options_.same * box.width() && std::abs(a.y - b.y) <= options_.same * box.height();
  }
  /// A side at which the surface closes is no border.
  [[nodiscard]] bool is_seam(const Piece& piece) const {
    const geom::Box& box = surface_.chart();
    const auto at = [](double a, double b, double end) { return a == end && b == end; };
    return piece.name.empty() && ((surface_.closed_u() && (at(piece.from.x, piece.to.x, box.low.x) ||
                                                           at(piece.from.x, piece.to.x, box.high.x))) ||
                                  (surface_.closed_v() && (at(piece.from.y, piece.to.y, box.low.y) ||
                                                           at(piece.from.y, piece.to.y, box.high.y))));
  }
  [[nodiscard]] bool meets_another(Point p, const std::string& name) const {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
      return piece.name != name && (same(piece.from, p) || same(piece.to, p));
    });
  }
  void say(const char* code, std::string message, Point uv) {
    findings_.push_back({code, std::move(message), surf::trim::place_of(surface_, uv)});
  }

  /// How near another line or border comes to a place, m.
  struct Near {
    double distance = std::numeric_limits<double>::infinity();
    std::string name;
  };
  [[nodiscard]] Near nearest(Point p, const std::string& name) const {
    Near best;
    const Point3 at = surface_.at(p);
    for (const Piece& piece : pieces_) {
      if (piece.name == name || is_seam(piece)) continue;
      for (std::size_t i = 1; i < piece.at.size(); ++i) {
        const Point3 last = piece.at[i - 1], next = piece.at[i];
        const geom::Vector3 way = next - last;
        const double square = dot(way, way);
        const double t = square > 0.0 ? std::clamp(dot(at - last, way) / square, 0.0, 1.0) : 0.0;
        const double distance = geom::distance(at, last + t * way);
        if (distance < best.distance) best = {distance, piece.name};
      }
    }
    return best;
  }

  void say_short(const DrawnTrim& trim) {
    if (trim.closed) return;
    for (const Point end : {trim.places.front(), trim.places.back()}) {
      if (meets_another(end, trim.name)) continue;
      const Near near = nearest(end, trim.name);
      constexpr double rounding = 1e-12;  // what is one place in space may be two in the chart, as beside a pole
      if (near.distance >= options_.shy * surface_.size() || near.distance <= rounding * surface_.size()) continue;
      if (near.name.empty()) {
        say("line_short",
            fmt::format("'{}' ends {:.3g} m from the border and does not meet it: end it there, or farther off",
                        trim.name, near.distance),
            end);
      } else {
        say("line_short",
            fmt::format("'{}' ends {:.3g} m from '{}' and does not meet it: end it there, or farther off", trim.name,
                        near.distance, near.name),
            end);
      }
    }
  }

  void say_useless(const DrawnTrim& trim) {
    const Point middle = trim.places[trim.places.size() / 2];
    const auto named = [&](const ChartEdge& edge) { return edge.name == trim.name; };
    const auto in_lines = [&] {
      return std::any_of(left_.lines.begin(), left_.lines.end(),
                         [&](const auto& line) { return std::any_of(line.edges.begin(), line.edges.end(), named); });
    };
    const auto in_loops = [&] {
      return std::any_of(left_.loops.begin(), left_.loops.end(),
                         [&](const auto& loop) { return std::any_of(loop.edges.begin(), loop.edges.end(), named); });
    };
    const auto on_seam = [&] {
      return std::any_of(left_.loops.begin(), left_.loops.end(), [&](const auto& loop) {
        return std::any_of(loop.edges.begin(), loop.edges.end(),
                           [&](const ChartEdge& edge) { return named(edge) && edge.crack != ChartEdge::Crack::None; });
      });
    };
    if (trim.role == TrimRole::Cut) {
      const std::vector<std::size_t>& own = of_[trim.name];
      const bool parts = std::any_of(own.begin(), own.end(), [&](std::size_t i) { return pieces_[i].parting; });
      if (parts) return;
      const bool open = !meets_another(trim.places.front(), trim.name);
      say("cut_divides_nothing",
          fmt::format("the cut '{}' divides nothing: it must go from border to border, or from cut to cut", trim.name),
          open ? trim.places.front() : trim.places.back());
    } else if (lies_on_crack(trim.name)) {
      return;
    } else if (trim.role == TrimRole::Crack) {
      if (in_lines() || on_seam()) return;
      say("crack_opens_nothing",
          fmt::format("the crack '{}' opens nothing: it lies on a border, or outside what is left of the surface",
                      trim.name),
          middle);
    } else if (!in_lines() && !in_loops()) {
      say("line_left_out", fmt::format("the line '{}' lies outside what is left of the surface", trim.name), middle);
    }
  }

  [[nodiscard]] bool lies_on_crack(const std::string& name) const {
    return std::any_of(on_cracks_.begin(), on_cracks_.end(), [&](const OnCrack& piece) {
      return std::find(piece.others.begin(), piece.others.end(), name) != piece.others.end();
    });
  }
  /// Lines that run along cracks, each pair once.
  void say_on_cracks() {
    std::set<std::pair<std::string, std::string>> told;
    for (const OnCrack& piece : on_cracks_) {
      for (const std::string& other : piece.others) {
        if (!told.emplace(piece.crack, other).second) continue;
        say("line_on_crack",
            fmt::format("'{}' runs along the crack '{}' here: the mesh is opened, and these sides are in the set of "
                        "'{}' alone",
                        other, piece.crack, piece.crack),
            piece.at);
      }
    }
  }

  [[nodiscard]] bool bounds(const std::string& name) const {
    return std::any_of(left_.loops.begin(), left_.loops.end(), [&](const auto& loop) {
      return std::any_of(loop.edges.begin(), loop.edges.end(),
                         [&](const ChartEdge& edge) { return edge.name == name; });
    });
  }
  /// Every place of it that was looked at lies in the other one, or on it.
  [[nodiscard]] bool lies_within(const DrawnTrim& trim, const DrawnTrim& other) const {
    return std::all_of(trim.places.begin(), trim.places.end(), [&](Point p) {
      return within(other, p) ||
             std::any_of(other.places.begin(), other.places.end(), [&](Point q) { return same(p, q); });
    });
  }
  /// A hole or an outline of which nothing bounds what is left: its set is empty.
  void say_idle(const DrawnTrim& trim) {
    if (bounds(trim.name)) return;
    std::string around;
    bool outlined = false, outlines = false;
    for (const DrawnTrim& other : drawn_) {
      if (!is_loop(other.role) || other.name == trim.name) continue;
      const bool inside = lies_within(trim, other);
      if (other.role == trim.role && inside) around = other.name;
      if (other.role == TrimRole::Outline) outlines = true, outlined = outlined || inside;
    }
    const bool outside = trim.role == TrimRole::Hole && outlines && !outlined;
    say("loop_bounds_nothing",
        outside ? fmt::format("'{}' has no effect and its set is empty: it lies outside the outlines", trim.name)
        : around.empty() ? fmt::format("'{}' has no effect and its set is empty: it lies outside what is left of the "
                                       "surface",
                                       trim.name)
                         : fmt::format("'{}' has no effect and its set is empty: it lies in '{}'", trim.name, around),
        trim.places.front());
  }

  /// Where more than two of its pieces meet.
  void say_self_crossing(const DrawnTrim& trim) {
    const std::vector<std::size_t>& own = of_[trim.name];
    for (const std::size_t i : own) {
      for (const Point p : {pieces_[i].from, pieces_[i].to}) {
        int ends = 0;
        for (const std::size_t k : own) ends += (same(pieces_[k].from, p) ? 1 : 0) + (same(pieces_[k].to, p) ? 1 : 0);
        if (ends <= 2) continue;
        say("trims_cross",
            fmt::format("'{}' crosses itself here: inside is what it goes round an odd number of times", trim.name), p);
        return;
      }
    }
  }

  void say_crossing(const DrawnTrim& first, const DrawnTrim& second) {
    std::optional<Point> in, out;
    for (const std::size_t i : of_[second.name]) {
      (within(first, pieces_[i].middle) ? in : out) = pieces_[i].from;
      if (in && out) break;
    }
    if (!in || !out) return;
    const bool holes = first.role == TrimRole::Hole && second.role == TrimRole::Hole;
    say("trims_cross",
        holes
            ? fmt::format("the holes '{}' and '{}' cross: what lies in either is taken away", first.name, second.name)
            : fmt::format("'{}' and '{}' cross: what stays lies in an outline and in no hole", first.name, second.name),
        *in);
  }

  /// Whole periods beside it too, where the surface closes.
  [[nodiscard]] bool within(const DrawnTrim& trim, Point p) const {
    const geom::Box& box = surface_.chart();
    const geom::Box& round = boxes_[static_cast<std::size_t>(&trim - drawn_.data())];
    const double round_u = surface_.closed_u() ? box.width() : 0.0, round_v = surface_.closed_v() ? box.height() : 0.0;
    for (const double u : {0.0, -round_u, round_u}) {
      for (const double v : {0.0, -round_v, round_v}) {
        const Point there = p + geom::Vector{u, v};
        if (round.contains(there) && encloses(trim.places, there)) return true;
      }
    }
    return false;
  }

  const surf::Surface& surface_;
  std::span<const DrawnTrim> drawn_;
  const TrimmedSurface& left_;
  std::span<const OnCrack> on_cracks_;
  DoubtOptions options_;
  std::vector<geom::Box> boxes_;  ///< One a trim.
  std::vector<Piece> pieces_;
  std::map<std::string, std::vector<std::size_t>> of_;  ///< Pieces by the names of their trims.
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> trim_doubts(const surf::Surface& surface, std::span<const DrawnTrim> drawn,
                                 std::span<const TrimmedSurface> parts, const TrimmedSurface& left,
                                 std::span<const OnCrack> on_cracks, const DoubtOptions& options) {
  return Doubts(surface, drawn, parts, left, on_cracks, options).run();
}

}  // namespace quebra::surfaces
