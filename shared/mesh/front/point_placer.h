#pragma once
// Points one by one, as frontal_points.h says, in a space of its own: the plane, or a surface (space.h).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "shared/mesh/front/frontal_points.h"
#include "shared/mesh/front/space.h"

// Notation: h wanted size; R circumradius; a cell is accepted once sqrt(3) R <= accept * h, given up when no point can
// be put for it; both let the front pass. Active: neither, but beside a marked side or a cell that lets the front pass.
// 1. On a surface: halve the sides of cells over which it turns by more than 60 degrees, whose circles mean nothing.
//    Rate all cells; queue the active ones.
// 2. Take the worst active cell; for its active sides, shortest first, compute the ideal point, check that it keeps
// clear
//    of vertices and marked sides, insert it; rate the cells round it. If no side gives a point, give the cell up.
// 3. For cells given up that are still too large, try their circumcentre, and on a surface the middle of the longest
//    side. End when such a round gave up more cells than were accepted in it: there the surface turns too much.

namespace dobra::mesh::front {

template <class Space>
class PointPlacer final : public FillEngine {
 public:
  using Kernel = delaunay::DelaunayKernel;
  using Point = typename Space::Point;
  using Vector = typename Space::Vector;
  using Place = typename Space::Place;

  PointPlacer(Kernel& kernel, Space& space, const sizing::SizeField& field, const FrontalOptions& options);

  base::Result<void> step(std::size_t count, const base::Progress& progress) override;
  [[nodiscard]] bool done() const override { return done_; }
  [[nodiscard]] std::vector<geom::Segment> front() const override;

 private:
  enum class State : std::uint8_t { Outside, Large, Accepted, GivenUp };
  struct Entry {
    double key;
    Kernel::Cell cell;
    std::uint32_t version;
    bool operator<(const Entry& other) const { return key != other.key ? key < other.key : cell > other.cell; }
  };

  [[nodiscard]] std::array<Point, 3> corners(Kernel::Cell c) const {
    const auto& v = kernel_.cell(c).vertex;
    return {space_.at(v[0]), space_.at(v[1]), space_.at(v[2])};
  }
  void rate(Kernel::Cell c);
  [[nodiscard]] bool lets_front_pass(Kernel::Half side) const;
  [[nodiscard]] bool active(Kernel::Cell c) const;
  void enqueue(Kernel::Cell c);
  [[nodiscard]] Vector to_centre(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c) const;
  [[nodiscard]] Place ideal_point(Kernel::Half side);
  bool advance(Kernel::Cell c);
  bool try_point(Place p, Kernel::Cell near);
  bool keeps_clear(const Place& p, Kernel::Cell start, double size);
  [[nodiscard]] bool in_circle(Kernel::Cell c, const Place& p) const;
  void update_star(Kernel::Vertex v);
  void give_up(Kernel::Cell c);
  bool try_circumcentres();
  [[nodiscard]] std::ptrdiff_t count(State state) const { return std::count(state_.begin(), state_.end(), state); }
  [[nodiscard]] bool is_hopeless() const;
  [[nodiscard]] bool gets_worse();
  bool halve(Kernel::Cell c);
  void split_turned();

  Kernel& kernel_;
  Space& space_;
  sizing::SizeSampler sizes_;
  const FrontalOptions& options_;
  std::vector<State> state_;
  std::vector<double> ratio_;  ///< sqrt(3) R / h.
  std::vector<std::uint32_t> version_;
  std::vector<std::uint32_t> visited_;
  std::uint32_t visit_ = 0;
  std::vector<Kernel::Cell> cavity_;
  std::priority_queue<Entry> queue_;
  std::size_t inserted_ = 0;
  double most_cells_ = std::numeric_limits<double>::infinity();  ///< Beyond it the cells do not get better any more.
  int rounds_ = 0;                                               ///< Of circumcentres tried.
  std::array<std::ptrdiff_t, 2> counts_{};                       ///< Accepted and given up before the last of them.
  bool done_ = false;
};

template <class Space>
PointPlacer<Space>::PointPlacer(Kernel& kernel, Space& space, const sizing::SizeField& field,
                                const FrontalOptions& options)
    : kernel_(kernel), space_(space), sizes_(field), options_(options) {
  const auto initial = static_cast<Kernel::Cell>(kernel_.cell_count());
  const std::size_t expected = space.make_room(field, options);
  state_.reserve(expected);
  ratio_.reserve(expected);
  version_.reserve(expected);
  visited_.reserve(expected);
  if constexpr (Space::curved) {
    space.coarse();
    most_cells_ = initial + 4.0 * space.estimated_triangles(field) + 10'000.0;
    kernel.legalise_all();
  }
  for (Kernel::Cell c = 0; c < initial; ++c) rate(c);
  for (Kernel::Cell c = 0; c < initial; ++c) enqueue(c);
  if constexpr (Space::curved) split_turned();
}

/// A node in the middle of the side that is longest in the chart, if it is longer than the size wanted.
template <class Space>
bool PointPlacer<Space>::halve(Kernel::Cell c) {
  constexpr double longest = 1.5;  // of the size wanted
  const auto chart_length = [&](std::uint32_t i) {
    const Kernel::Half e = Kernel::half(c, i);
    return geom::distance(kernel_.point(kernel_.origin(e)), kernel_.point(kernel_.target(e)));
  };
  std::uint32_t side = chart_length(0) >= chart_length(1) ? 0 : 1;
  if (chart_length(2) > chart_length(side)) side = 2;
  const Kernel::Half e = Kernel::half(c, side);
  const Kernel::Vertex from = kernel_.origin(e), to = kernel_.target(e);
  Place middle = space_.between(from, to, 0.5);
  if (kernel_.mark(e) != 0 || !space_.ground(middle)) return false;
  const double way = geom::distance(space_.at(from), middle.at) + geom::distance(middle.at, space_.at(to));
  return way > longest * sizes_.at(middle.chart()) && try_point(middle, c);
}

template <class Space>
void PointPlacer<Space>::split_turned() {
  for (std::size_t before = inserted_ + 1; inserted_ != before;) {
    before = inserted_;
    const auto count = static_cast<Kernel::Cell>(kernel_.cell_count());
    if (count > most_cells_) return;
    for (Kernel::Cell c = 0; c < count; ++c) {
      const auto [a, b, d] = kernel_.cell(c).vertex;
      if (kernel_.cell(c).region >= 0 && space_.turns(a, b, d)) halve(c);
    }
  }
}

template <class Space>
void PointPlacer<Space>::rate(Kernel::Cell c) {
  if (c >= state_.size()) {
    const std::size_t size = kernel_.cell_count();
    state_.resize(size, State::Outside);
    ratio_.resize(size, 0.0);
    version_.resize(size, 0);
    visited_.resize(size, 0);
  }
  ++version_[c];
  if (kernel_.cell(c).region < 0) {
    state_[c] = State::Outside;
    return;
  }
  const auto& [a, b, d] = kernel_.cell(c).vertex;
  const geom::Point p = kernel_.point(a), q = kernel_.point(b), r = kernel_.point(d);
  const geom::Point middle{(p.x + q.x + r.x) / 3.0, (p.y + q.y + r.y) / 3.0};
  const Vector to_corner = space_.at(a) + to_centre(a, b, d) - space_.at(a);
  const double radius = std::sqrt(geom::dot(to_corner, to_corner));
  ratio_[c] = std::numbers::sqrt3 * radius / sizes_.at(middle);
  state_[c] = ratio_[c] <= options_.accept ? State::Accepted : State::Large;
}

template <class Space>
bool PointPlacer<Space>::lets_front_pass(Kernel::Half side) const {
  if (kernel_.mark(side) != 0) return true;
  const State other = state_[Kernel::cell_of(kernel_.twin(side))];
  return other != State::Large;
}

template <class Space>
bool PointPlacer<Space>::active(Kernel::Cell c) const {
  if (state_[c] != State::Large) return false;
  return lets_front_pass(Kernel::half(c, 0)) || lets_front_pass(Kernel::half(c, 1)) ||
         lets_front_pass(Kernel::half(c, 2));
}

template <class Space>
void PointPlacer<Space>::enqueue(Kernel::Cell c) {
  if (!active(c)) return;
  queue_.push({ratio_[c], c, version_[c]});
}

/// From a to the centre of the circle through three nodes; not finite where they are collinear.
template <class Space>
typename Space::Vector PointPlacer<Space>::to_centre(Kernel::Vertex a, Kernel::Vertex b, Kernel::Vertex c) const {
  const Vector u = space_.at(b) - space_.at(a);
  const Vector w = space_.at(c) - space_.at(a);
  const auto frame = space_.frame(a, b);
  return space_.to_centre(frame, u, w, geom::dot(u, u), geom::dot(w, w), space_.cross(frame, u, w));
}

/// Beyond the middle of `side`, into its cell, so that the new triangle has the circumradius wanted there; never beyond
/// the circumcentre of the cell, where a point would be nearer to other vertices.
template <class Space>
typename Space::Place PointPlacer<Space>::ideal_point(Kernel::Half side) {
  const Kernel::Vertex from = kernel_.origin(side);
  const Kernel::Vertex to = kernel_.target(side);
  const Point a = space_.at(from);
  const Point b = space_.at(to);
  const Point centre = a + to_centre(from, to, kernel_.apex(side));
  const Place middle = space_.beside(from, to, {});
  const Vector inward = geom::normalised(space_.left_of(space_.frame(from, to), b - a));
  const double p = 0.5 * geom::distance(a, b);
  const double q = geom::dot(centre - middle.at, inward);
  double size = sizes_.at(middle.chart());
  double height = 0.0;
  for (int round = 0; round < 2; ++round) {
    const double most = q > 0.0 ? (p * p + q * q) / (2.0 * q) : 0.0;
    const double radius = std::min(std::max(size / std::numbers::sqrt3, p), std::max(most, p));
    height = radius + std::sqrt(std::max(0.0, radius * radius - p * p));
    // The size where the point would stand counts as much as the size at the side.
    size = sizes_.at(space_.beside(from, to, 0.67 * height * inward).chart());
  }
  Place place = space_.beside(from, to, height * inward);
  space_.settle(from, to, height, place);  // or else it is refused when it is grounded
  return place;
}

template <class Space>
bool PointPlacer<Space>::in_circle(Kernel::Cell c, const Place& p) const {
  if constexpr (!Space::curved) {
    return kernel_.in_circle(c, p.chart());
  } else {
    if (kernel_.cell(c).region < 0) return false;
    const auto& [a, b, d] = kernel_.cell(c).vertex;
    const Vector radius = to_centre(a, b, d);
    const Vector apart = p.at - (space_.at(a) + radius);
    return geom::dot(apart, apart) < geom::dot(radius, radius);
  }
}

template <class Space>
bool PointPlacer<Space>::keeps_clear(const Place& p, Kernel::Cell start, double size) {
  const double spacing = options_.least_spacing * size;
  ++visit_;
  cavity_.assign(1, start);
  visited_[start] = visit_;
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const Kernel::Cell c = cavity_[k];
    for (const Point corner : corners(c)) {
      const Vector apart = corner - p.at;
      if (geom::dot(apart, apart) < spacing * spacing) return false;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (kernel_.mark(e) != 0) {
        const Point from = space_.at(kernel_.origin(e));
        const Point to = space_.at(kernel_.target(e));
        if (space_.to_side(from, to, p.at) < options_.least_wall * std::min(size, geom::distance(from, to)))
          return false;
        continue;
      }
      const Kernel::Cell other = Kernel::cell_of(kernel_.twin(e));
      if (visited_[other] == visit_ || !in_circle(other, p)) continue;
      visited_[other] = visit_;
      cavity_.push_back(other);
    }
  }
  return true;
}

template <class Space>
void PointPlacer<Space>::update_star(Kernel::Vertex v) {
  const Kernel::Half first = kernel_.half_of(v);
  Kernel::Half e = first;
  do {
    rate(Kernel::cell_of(e));
    e = kernel_.around(e);
  } while (e != first);
  do {
    const Kernel::Cell c = Kernel::cell_of(e);
    enqueue(c);
    if (state_[c] == State::Accepted) enqueue(Kernel::cell_of(kernel_.twin(Kernel::next(e))));
    e = kernel_.around(e);
  } while (e != first);
}

template <class Space>
bool PointPlacer<Space>::try_point(Place p, Kernel::Cell near) {
  if (!geom::is_finite(p.chart()) || !space_.ground(p)) return false;
  const Kernel::Location at = kernel_.locate(p.chart(), near, Kernel::Walls::Stop);
  if (at.where != Kernel::Where::Inside && at.where != Kernel::Where::OnSide) return false;
  if (at.where == Kernel::Where::OnSide && kernel_.mark(at.half) != 0) return false;
  if (!keeps_clear(p, Kernel::cell_of(at.half), sizes_.at(p.chart()))) return false;
  space_.announce(p);
  update_star(kernel_.insert(p.chart(), at));
  ++inserted_;
  return true;
}

template <class Space>
bool PointPlacer<Space>::advance(Kernel::Cell c) {
  struct Side {
    double length = std::numeric_limits<double>::infinity();
    Kernel::Half half = Kernel::none;
  };
  std::array<Side, 3> sides{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Kernel::Half e = Kernel::half(c, i);
    if (!lets_front_pass(e)) continue;
    sides[i] = {geom::distance(space_.at(kernel_.origin(e)), space_.at(kernel_.target(e))), e};
  }
  const auto order = [&](std::size_t i, std::size_t j) {
    if (sides[j].length < sides[i].length) std::swap(sides[i], sides[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  for (const Side& side : sides) {
    if (side.half != Kernel::none && try_point(ideal_point(side.half), c)) return true;
  }
  return false;
}

template <class Space>
void PointPlacer<Space>::give_up(Kernel::Cell c) {
  state_[c] = State::GivenUp;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Kernel::Half e = Kernel::half(c, i);
    if (kernel_.mark(e) == 0) enqueue(Kernel::cell_of(kernel_.twin(e)));
  }
}

/// The cells given up that are still too large. @return whether a point was inserted
template <class Space>
bool PointPlacer<Space>::try_circumcentres() {
  const std::size_t before = inserted_;
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (state_[c] != State::GivenUp) continue;
    const auto [a, b, d] = kernel_.cell(c).vertex;
    const bool placed = try_point(space_.in_plane(a, b, d, to_centre(a, b, d)), c);
    // Needles have their centres far away.
    if constexpr (Space::curved) {
      if (!placed) halve(c);
    }
  }
  return inserted_ > before;
}

/// Whether far more cells are given up than accepted, of many: there the surface folds over itself.
template <class Space>
bool PointPlacer<Space>::is_hopeless() const {
  if constexpr (!Space::curved) return false;
  constexpr std::ptrdiff_t many = 20'000;
  const std::ptrdiff_t given_up = count(State::GivenUp);
  return given_up > many && given_up > 2 * count(State::Accepted);
}

/// Whether the last round of circumcentres gave up more cells than were accepted in it.
template <class Space>
bool PointPlacer<Space>::gets_worse() {
  if constexpr (!Space::curved) return false;
  const std::array before = std::exchange(counts_, {count(State::Accepted), count(State::GivenUp)});
  return rounds_ > 0 && counts_[1] - before[1] > counts_[0] - before[0];
}

template <class Space>
base::Result<void> PointPlacer<Space>::step(std::size_t count, const base::Progress& progress) {
  DOBRA_TRY_VOID(progress.check());
  progress.report(1.0 - 1.0 / (1.0 + 1e-5 * static_cast<double>(inserted_)),
                  fmt::format("{} points placed", inserted_));
  if (is_hopeless()) {
    done_ = true;  // whoever asked for the mesh finds that it folds
    return {};
  }
  for (; count > 0 && !queue_.empty(); --count) {
    const Entry entry = queue_.top();
    queue_.pop();
    if (entry.version != version_[entry.cell] || state_[entry.cell] != State::Large) continue;
    if (!advance(entry.cell)) give_up(entry.cell);
    DOBRA_TRY_VOID(check_limit(kernel_.cell_count(), options_));
    if (static_cast<double>(kernel_.cell_count()) > most_cells_) {
      done_ = true;  // as above
      return {};
    }
  }
  constexpr int most_rounds = Space::curved ? 32 : 8;
  if (queue_.empty()) {
    done_ = gets_worse() || rounds_ == most_rounds || !try_circumcentres();
    ++rounds_;
  }
  return {};
}

template <class Space>
std::vector<geom::Segment> PointPlacer<Space>::front() const {
  std::vector<geom::Segment> sides;
  for (Kernel::Half e = 0; e < 4 * kernel_.cell_count(); ++e) {
    if ((e & 3U) == 3U || state_[Kernel::cell_of(e)] != State::Large || !lets_front_pass(e)) continue;
    sides.push_back({kernel_.point(kernel_.origin(e)), kernel_.point(kernel_.target(e))});
  }
  return sides;
}

}  // namespace dobra::mesh::front
