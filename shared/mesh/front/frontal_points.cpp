#include "shared/mesh/front/frontal_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

// Notation: h wanted size; R circumradius; a cell is accepted once sqrt(3) R <= accept * h, given up when no point can
// be put for it; both let the front pass. Active: neither, but beside a marked side or a cell that lets the front pass.
// 1. Rate all cells; queue the active ones.
// 2. Take the worst active cell; for its active sides, shortest first, compute the ideal point, check that it keeps
// clear
//    of vertices and marked sides, insert it; rate the cells round it. If no side gives a point, give the cell up.
// 3. For cells given up that are still too large, try their circumcentre.

namespace dobra::mesh::front {

using base::Progress;
using base::Result;
using geom::Point;
using Kernel = delaunay::DelaunayKernel;

namespace {

/// Centre of the circle through three points; not finite where they are collinear.
Point circumcentre(Point a, Point b, Point c) {
  const geom::Vector u = b - a;
  const geom::Vector v = c - a;
  const double twice = 2.0 * geom::cross(u, v);
  const double uu = geom::length_squared(u);
  const double vv = geom::length_squared(v);
  return {a.x + (v.y * uu - u.y * vv) / twice, a.y + (u.x * vv - v.x * uu) / twice};
}

class PointPlacer final : public FillEngine {
 public:
  PointPlacer(Kernel& kernel, const sizing::SizeField& field, const FrontalOptions& options);

  Result<void> step(std::size_t count, const Progress& progress) override;
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
    return {kernel_.point(v[0]), kernel_.point(v[1]), kernel_.point(v[2])};
  }
  void rate(Kernel::Cell c);
  [[nodiscard]] bool lets_front_pass(Kernel::Half side) const;
  [[nodiscard]] bool active(Kernel::Cell c) const;
  void enqueue(Kernel::Cell c);
  [[nodiscard]] Point ideal_point(Kernel::Half side);
  bool advance(Kernel::Cell c);
  bool try_point(Point p, Kernel::Cell near);
  bool keeps_clear(Point p, Kernel::Cell start, double size);
  void update_star(Kernel::Vertex v);
  void give_up(Kernel::Cell c);
  bool try_circumcentres();

  Kernel& kernel_;
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
  int rounds_ = 0;  ///< Of circumcentres tried.
  bool done_ = false;
};

PointPlacer::PointPlacer(Kernel& kernel, const sizing::SizeField& field, const FrontalOptions& options)
    : kernel_(kernel), sizes_(field), options_(options) {
  const auto initial = static_cast<Kernel::Cell>(kernel_.cell_count());
  const std::size_t expected = make_room(kernel, field, options);
  state_.reserve(expected);
  ratio_.reserve(expected);
  version_.reserve(expected);
  visited_.reserve(expected);
  for (Kernel::Cell c = 0; c < initial; ++c) rate(c);
  for (Kernel::Cell c = 0; c < initial; ++c) enqueue(c);
}

void PointPlacer::rate(Kernel::Cell c) {
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
  const auto [a, b, d] = corners(c);
  const Point middle{(a.x + b.x + d.x) / 3.0, (a.y + b.y + d.y) / 3.0};
  const double radius = std::sqrt(geom::length_squared(circumcentre(a, b, d) - a));
  ratio_[c] = std::numbers::sqrt3 * radius / sizes_.at(middle);
  state_[c] = ratio_[c] <= options_.accept ? State::Accepted : State::Large;
}

bool PointPlacer::lets_front_pass(Kernel::Half side) const {
  if (kernel_.mark(side) != 0) return true;
  const State other = state_[Kernel::cell_of(kernel_.twin(side))];
  return other != State::Large;
}

bool PointPlacer::active(Kernel::Cell c) const {
  if (state_[c] != State::Large) return false;
  return lets_front_pass(Kernel::half(c, 0)) || lets_front_pass(Kernel::half(c, 1)) ||
         lets_front_pass(Kernel::half(c, 2));
}

void PointPlacer::enqueue(Kernel::Cell c) {
  if (!active(c)) return;
  queue_.push({ratio_[c], c, version_[c]});
}

/// Beyond the middle of `side`, into its cell, so that the new triangle has the circumradius wanted there; never beyond
/// the circumcentre of the cell, where a point would be nearer to other vertices.
Point PointPlacer::ideal_point(Kernel::Half side) {
  const Point a = kernel_.point(kernel_.origin(side));
  const Point b = kernel_.point(kernel_.target(side));
  const Point centre = circumcentre(a, b, kernel_.point(kernel_.apex(side)));
  const Point middle = geom::midpoint(a, b);
  const geom::Vector inward = geom::normalised(geom::left_of(b - a));
  const double p = 0.5 * geom::distance(a, b);
  const double q = geom::dot(centre - middle, inward);
  double size = sizes_.at(middle);
  double height = 0.0;
  for (int round = 0; round < 2; ++round) {
    const double most = q > 0.0 ? (p * p + q * q) / (2.0 * q) : 0.0;
    const double radius = std::min(std::max(size / std::numbers::sqrt3, p), std::max(most, p));
    height = radius + std::sqrt(std::max(0.0, radius * radius - p * p));
    // The size where the point would stand counts as much as the size at the side.
    size = sizes_.at(middle + 0.67 * height * inward);
  }
  return middle + height * inward;
}

bool PointPlacer::keeps_clear(Point p, Kernel::Cell start, double size) {
  const double spacing = options_.least_spacing * size;
  ++visit_;
  cavity_.assign(1, start);
  visited_[start] = visit_;
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const Kernel::Cell c = cavity_[k];
    for (const Point corner : corners(c)) {
      if (geom::length_squared(corner - p) < spacing * spacing) return false;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (kernel_.mark(e) != 0) {
        const geom::Segment wall{kernel_.point(kernel_.origin(e)), kernel_.point(kernel_.target(e))};
        if (geom::distance(wall, p) < options_.least_wall * std::min(size, wall.length())) return false;
        continue;
      }
      const Kernel::Cell other = Kernel::cell_of(kernel_.twin(e));
      if (visited_[other] == visit_ || !kernel_.in_circle(other, p)) continue;
      visited_[other] = visit_;
      cavity_.push_back(other);
    }
  }
  return true;
}

void PointPlacer::update_star(Kernel::Vertex v) {
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

bool PointPlacer::try_point(Point p, Kernel::Cell near) {
  if (!geom::is_finite(p)) return false;
  const Kernel::Location at = kernel_.locate(p, near, Kernel::Walls::Stop);
  if (at.where != Kernel::Where::Inside && at.where != Kernel::Where::OnSide) return false;
  if (at.where == Kernel::Where::OnSide && kernel_.mark(at.half) != 0) return false;
  if (!keeps_clear(p, Kernel::cell_of(at.half), sizes_.at(p))) return false;
  update_star(kernel_.insert(p, at));
  ++inserted_;
  return true;
}

bool PointPlacer::advance(Kernel::Cell c) {
  struct Side {
    double length = std::numeric_limits<double>::infinity();
    Kernel::Half half = Kernel::none;
  };
  std::array<Side, 3> sides{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Kernel::Half e = Kernel::half(c, i);
    if (!lets_front_pass(e)) continue;
    sides[i] = {geom::distance(kernel_.point(kernel_.origin(e)), kernel_.point(kernel_.target(e))), e};
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

void PointPlacer::give_up(Kernel::Cell c) {
  state_[c] = State::GivenUp;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Kernel::Half e = Kernel::half(c, i);
    if (kernel_.mark(e) == 0) enqueue(Kernel::cell_of(kernel_.twin(e)));
  }
}

/// The cells given up that are still too large. @return whether a point was inserted
bool PointPlacer::try_circumcentres() {
  const std::size_t before = inserted_;
  for (Kernel::Cell c = 0; c < kernel_.cell_count(); ++c) {
    if (state_[c] != State::GivenUp) continue;
    const auto [a, b, d] = corners(c);
    try_point(circumcentre(a, b, d), c);
  }
  return inserted_ > before;
}

Result<void> PointPlacer::step(std::size_t count, const Progress& progress) {
  DOBRA_TRY_VOID(progress.check());
  progress.report(1.0 - 1.0 / (1.0 + 1e-5 * static_cast<double>(inserted_)),
                  fmt::format("{} points placed", inserted_));
  for (; count > 0 && !queue_.empty(); --count) {
    const Entry entry = queue_.top();
    queue_.pop();
    if (entry.version != version_[entry.cell] || state_[entry.cell] != State::Large) continue;
    if (!advance(entry.cell)) give_up(entry.cell);
    DOBRA_TRY_VOID(check_limit(kernel_.cell_count(), options_));
  }
  constexpr int most_rounds = 8;
  if (queue_.empty()) done_ = rounds_++ == most_rounds || !try_circumcentres();
  return {};
}

std::vector<geom::Segment> PointPlacer::front() const {
  std::vector<geom::Segment> sides;
  for (Kernel::Half e = 0; e < 4 * kernel_.cell_count(); ++e) {
    if ((e & 3U) == 3U || state_[Kernel::cell_of(e)] != State::Large || !lets_front_pass(e)) continue;
    sides.push_back({kernel_.point(kernel_.origin(e)), kernel_.point(kernel_.target(e))});
  }
  return sides;
}

}  // namespace

std::unique_ptr<FillEngine> frontal_points(Kernel& kernel, const sizing::SizeField& field,
                                           const FrontalOptions& options) {
  return std::make_unique<PointPlacer>(kernel, field, options);
}

}  // namespace dobra::mesh::front
