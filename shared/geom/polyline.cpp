#include "shared/geom/polyline.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "shared/geom/predicates.h"

namespace dobra::geom {
namespace {

/// Neumaier's compensated sum.
class Sum {
 public:
  void add(double term) {
    const double next = total_ + term;
    correction_ += std::abs(total_) >= std::abs(term) ? (total_ - next) + term : (term - next) + total_;
    total_ = next;
  }
  [[nodiscard]] double value() const { return total_ + correction_; }

 private:
  double total_ = 0.0;
  double correction_ = 0.0;
};

}  // namespace

double length(const Polyline& polyline) {
  Sum sum;
  for (std::size_t i = 0; i < polyline.segment_count(); ++i) sum.add(polyline.segment(i).length());
  return sum.value();
}

double signed_area(const Polyline& polyline) {
  if (!polyline.closed || polyline.points.size() < 3) return 0.0;
  // From the first point, so that large coordinates do not cancel.
  const Point origin = polyline.points.front();
  Sum sum;
  for (std::size_t i = 1; i + 1 < polyline.points.size(); ++i) {
    sum.add(cross(polyline.points[i] - origin, polyline.points[i + 1] - origin));
  }
  return 0.5 * sum.value();
}

Polyline reversed(Polyline polyline) {
  std::reverse(polyline.points.begin(), polyline.points.end());
  return polyline;
}

std::vector<double> arc_lengths(const Polyline& polyline) {
  std::vector<double> arc;
  arc.reserve(polyline.segment_count() + 1);
  Sum sum;
  arc.push_back(0.0);
  for (std::size_t i = 0; i < polyline.segment_count(); ++i) {
    sum.add(polyline.segment(i).length());
    arc.push_back(sum.value());
  }
  return arc;
}

Point point_at(const Polyline& polyline, const std::vector<double>& arc, double s) {
  DOBRA_CHECK(polyline.segment_count() > 0);
  const auto after = std::upper_bound(arc.begin() + 1, arc.end() - 1, s);
  std::size_t i = static_cast<std::size_t>(after - arc.begin()) - 1;
  // Repeated points at an end give segments of zero length there: take the nearest one that has a direction.
  while (arc[i + 1] == arc[i] && s <= arc[i] && i + 2 < arc.size()) ++i;
  while (arc[i + 1] == arc[i] && i > 0) --i;
  if (arc[i + 1] == arc[i]) return polyline.points.front();
  const Segment segment = polyline.segment(i);
  return interpolate(segment.from, segment.to, (s - arc[i]) / (arc[i + 1] - arc[i]));
}

double distance(const Polyline& polyline, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polyline.segment_count(); ++i) least = std::min(least, distance(polyline.segment(i), p));
  return least;
}

Polyline without_repeated_points(Polyline polyline) {
  auto& points = polyline.points;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (polyline.closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
  return polyline;
}

base::Result<void> validate(const Polyline& polyline) {
  for (std::size_t i = 0; i < polyline.points.size(); ++i) {
    if (!is_finite(polyline.points[i])) {
      return base::Error{base::ErrorCode::NotFinite,
                         fmt::format("point {} is not a finite number; remove or correct it", i + 1)};
    }
  }
  const std::size_t distinct = without_repeated_points(polyline).points.size();
  const std::size_t wanted = polyline.closed ? 3 : 2;
  if (distinct < wanted) {
    base::Place place;
    if (!polyline.points.empty()) {
      place.x = polyline.points.front().x;
      place.y = polyline.points.front().y;
    }
    return base::Error{base::ErrorCode::DegenerateCurve,
                       fmt::format("a {} needs at least {} distinct points and has {}",
                                   polyline.closed ? "closed contour" : "line", wanted, distinct),
                       place};
  }
  return {};
}

Side locate(const Polyline& contour, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < contour.segment_count(); ++i) {
    const auto [a, b] = contour.segment(i);
    const Sign side = orient2d(a, b, p);
    if (side == Sign::Zero && contour.segment(i).box().contains(p)) return Side::Boundary;
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if ((side == Sign::Positive) == (a.y <= p.y)) inside = !inside;
  }
  return inside ? Side::Inside : Side::Outside;
}

}  // namespace dobra::geom
