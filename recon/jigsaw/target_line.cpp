#include "recon/jigsaw/target_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace recon::jigsaw {

base::Result<TargetLine> TargetLine::make(std::vector<geom::Point> points, double beyond) {
  if (points.size() < 2)
    return base::Error{base::ErrorCode::BadValue, "the target needs two points at least",
                       base::Place{.item = "target"}};
  if (points.front().x > points.back().x) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].x > points[i - 1].x) continue;
    return base::Error{
        base::ErrorCode::BadValue,
        fmt::format("the target of a jigsaw turns back in x at {}; give a line whose x grows from point to point",
                    points[i]),
        geom::place_at(points[i], "target")};
  }
  const geom::Vector left = geom::normalised(points[0] - points[1]);
  const geom::Vector right = geom::normalised(points.back() - points[points.size() - 2]);
  TargetLine made;
  made.line_.points = std::move(points);
  made.line_.points.front() = made.line_.points.front() + beyond * left;
  made.line_.points.back() = made.line_.points.back() + beyond * right;
  return made;
}

double TargetLine::z(double x) const {
  const std::vector<geom::Point>& points = line_.points;
  std::size_t i = 1;
  while (i + 1 < points.size() && points[i].x < x) ++i;
  const geom::Point a = points[i - 1], b = points[i];
  return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

geom::Point TargetLine::slid(geom::Point from, double by, const unfold::RestoreParams& params) const {
  const bool shear = params.method == unfold::RestoreMethod::Shear;
  const double cosine = std::cos(params.angle.radians()), sine = std::sin(params.angle.radians());
  double before = 0.0, sum = 0.0;  // at the last vertex, relative to the first
  const auto along = [&](geom::Point a, geom::Point b) {
    return shear ? cosine * (b.x - a.x) - sine * (b.y - a.y) : geom::distance(a, b);
  };
  const std::vector<geom::Point>& points = line_.points;
  std::size_t holder = 1;
  while (holder + 1 < points.size() && points[holder].x < from.x) ++holder;
  for (std::size_t i = 1; i < holder; ++i) sum += along(points[i - 1], points[i]);
  const double goal = sum + along(points[holder - 1], from) + (shear ? cosine * by : by);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = along(points[i - 1], points[i]);
    if (goal <= before + length || i + 1 == points.size())
      return geom::interpolate(points[i - 1], points[i], (goal - before) / length);
    before += length;
  }
  return from;
}

geom::Polyline TargetLine::clipped(const geom::Polyline& line, section::LayerSide side) const {
  const double sign = side == section::LayerSide::Below ? 1.0 : -1.0;
  geom::Polyline longest, run;
  const auto finish = [&] {
    if (run.points.size() > 1 && (longest.points.empty() || geom::length(run) > geom::length(longest))) longest = run;
    run.points.clear();
  };
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    std::vector<geom::Point> stops{segment.from, segment.to};
    for (std::size_t k = 0; k < line_.segment_count(); ++k) {
      const geom::Intersection met = geom::intersect(segment, line_.segment(k));
      if (met.kind != geom::IntersectionKind::None) stops.push_back(met.start.point);
    }
    geom::sort_along(segment, stops);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      if (stops[k] == stops[k + 1]) continue;
      const geom::Point middle = geom::midpoint(stops[k], stops[k + 1]);
      if (sign * (z(middle.x) - middle.y) < 0.0) {
        finish();
        continue;
      }
      if (run.points.empty()) run.points.push_back(stops[k]);
      run.points.push_back(stops[k + 1]);
    }
  }
  finish();
  return longest;
}

}  // namespace recon::jigsaw
