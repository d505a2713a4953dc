#include "shared/surf/loft/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/box3.h"
#include "shared/geom/intersect.h"

namespace dobra::surf::loft {

using base::Error;
using base::ErrorCode;
using geom::Point;

const char* kind_name(LineKind kind) { return kind == LineKind::Horizon ? "horizon" : "fault"; }

namespace {

base::Place on_map_at(Point p) { return {.x = p.x, .y = p.y}; }

/// Pieces that follow each other share their corner and nothing else; others share nothing.
base::Result<void> check_simple(const geom::Polyline& trace) {
  for (std::size_t i = 0; i < trace.segment_count(); ++i) {
    for (std::size_t j = i + 1; j < trace.segment_count(); ++j) {
      const geom::Intersection met = geom::intersect(trace.segment(i), trace.segment(j));
      const bool corner = j == i + 1 && met.kind == geom::IntersectionKind::Point;
      if (met.kind == geom::IntersectionKind::None || corner) continue;
      return Error{ErrorCode::DegenerateCurve,
                   "the trace meets itself; a section has one place for each distance along it, so part it in two",
                   on_map_at(met.start.point)};
    }
  }
  return {};
}

}  // namespace

base::Result<PlanTrace> PlanTrace::make(std::vector<Point> corners) {
  for (const Point p : corners) {
    if (!geom::is_finite(p)) return Error{ErrorCode::NotFinite, "a corner of the trace is not finite"};
  }
  if (corners.size() < 2)
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("the trace has {} corners; give two at least, x0, y0, x1, y1", corners.size())};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i] == corners[i - 1])
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("corners {} and {} of the trace are in one place; leave one out", i, i + 1),
                   on_map_at(corners[i])};
  }
  const geom::Polyline line{corners, false};
  DOBRA_TRY_VOID(check_simple(line));
  const double length = geom::length(line);
  double most = 0.0;
  for (const Point p : corners) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  if (!(most * std::numeric_limits<double>::epsilon() <= 1e-6 * length))
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("the trace is {:.6g} m long and so far from the origin that numbers tell its places no "
                             "longer apart; correct its corners",
                             length),
                 on_map_at(corners.front())};
  return PlanTrace(std::move(corners), geom::arc_lengths(line));
}

std::vector<geom::Point3> in_space(const PlanTrace& trace, const geom::Polyline& line) {
  std::vector<geom::Point3> made;
  const std::vector<double>& bends = trace.distances();
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point q = line.points[i];
    if (i > 0) {
      const Point p = line.points[i - 1];
      std::vector<double> between;
      for (std::size_t k = 1; k + 1 < bends.size(); ++k) {
        if ((bends[k] - p.x) * (bends[k] - q.x) < 0.0) between.push_back(bends[k]);
      }
      if (p.x > q.x) std::reverse(between.begin(), between.end());
      for (const double s : between) made.push_back(trace.in_space({s, p.y + (s - p.x) / (q.x - p.x) * (q.y - p.y)}));
    }
    made.push_back(trace.in_space(q));
  }
  return made;
}

double size_of(const std::vector<Section>& sections) {
  geom::Box3 box;
  for (const Section& section : sections) {
    for (const SectionLine& line : section.lines) {
      for (const geom::Point3 p : in_space(section.trace, line.line)) box.add(p);
    }
  }
  return box.diagonal();
}

}  // namespace dobra::surf::loft
