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

namespace {

/// How far a place along a trace may be from a bend that it stands for.
double rounding_of(double s, double length) {
  constexpr double rounded = 1e-6, most = 2e-5;  // of the length: 1e-5 is half a unit of the last decimal
  for (double unit = 1.0; unit > rounded * length; unit *= 0.1) {
    const bool written = std::abs(s / unit - std::round(s / unit)) <= 1e-6;
    if (written && unit <= most * length) return 0.5 * unit * (1.0 + 1e-6);
  }
  return rounded * length;
}

/// The places of vertices along the trace; of those that stand for a bend the nearest is at the bend.
std::vector<double> places_of(const PlanTrace& trace, const geom::Polyline& line) {
  std::vector<double> places;
  for (const Point p : line.points) places.push_back(p.x);
  const std::vector<double>& bends = trace.distances();
  for (std::size_t k = 1; k + 1 < bends.size(); ++k) {
    const auto away = [&](std::size_t i) { return std::abs(line.points[i].x - bends[k]); };
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (away(i) > rounding_of(line.points[i].x, trace.length())) continue;
      if ((i > 0 && away(i - 1) <= away(i)) || (i + 1 < places.size() && away(i + 1) < away(i))) continue;
      places[i] = bends[k];
    }
  }
  return places;
}

}  // namespace

std::vector<geom::Point3> in_space(const PlanTrace& trace, const geom::Polyline& line) {
  std::vector<geom::Point3> made;
  const std::vector<double>& bends = trace.distances();
  const std::vector<double> places = places_of(trace, line);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const Point q{places[i], line.points[i].y};
    if (i > 0) {
      const Point p{places[i - 1], line.points[i - 1].y};
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

std::vector<geom::Point3> without_twins(const std::vector<geom::Point3>& line, double near) {
  std::vector<geom::Point3> made;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (i == 0 || (geom::distance(line[i], made.back()) > near && geom::distance(line[i], line.back()) > near))
      made.push_back(line[i]);
  }
  if (!line.empty()) made.push_back(line.back());
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
