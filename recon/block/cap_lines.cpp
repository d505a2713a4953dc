#include "recon/block/cap_lines.h"

#include <algorithm>

#include "recon/block/unit_map.h"
#include "shared/geom/contour.h"

namespace recon::block {
namespace {

using geom::Point;
using geom::Polyline;

/// Lines that meet end to end, two in a place, become one; those that close become loops. The first keeps its way.
/// @param turnable  whether a line may be joined the other way round
std::vector<Polyline> joined(std::vector<Polyline> lines, bool turnable) {
  using Key = std::pair<double, double>;
  const auto key = [](Point p) { return Key{p.x, p.y}; };
  struct End {
    std::size_t line;
    bool first;
  };
  std::map<Key, std::vector<End>> ends;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].closed) continue;
    ends[key(lines[i].points.front())].push_back({i, true});
    ends[key(lines[i].points.back())].push_back({i, false});
  }
  std::vector<Polyline> made;
  std::vector<bool> used(lines.size(), false);
  /// The points of what follows on from the end of a line that has been used.
  const auto append = [&](Polyline& whole) {
    while (true) {
      const std::vector<End>& here = ends.at(key(whole.points.back()));
      if (here.size() != 2) return;
      const End next = used[here[0].line] ? here[1] : here[0];
      if (used[next.line] || (!turnable && !next.first)) return;
      used[next.line] = true;
      std::vector<Point>& points = lines[next.line].points;
      if (!next.first) std::reverse(points.begin(), points.end());
      whole.points.insert(whole.points.end(), points.begin() + 1, points.end());
    }
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    Polyline whole = lines[i];
    if (!whole.closed) {
      append(whole);
      if (turnable) {
        whole = geom::reversed(std::move(whole));
        append(whole);
        whole = geom::reversed(std::move(whole));
      }
      if (whole.points.size() > 3 && whole.points.front() == whole.points.back()) {
        whole.points.pop_back();
        whole.closed = true;
      }
    }
    made.push_back(std::move(whole));
  }
  return made;
}

}  // namespace

std::vector<Polyline> loops_of(const dobra::solid::CapRegion& region, const dobra::solid::SectionFrame& from,
                               const CutFrame& to) {
  std::vector<Polyline> loops;
  const Point* start = nullptr;
  for (const geom::Segment& side : region.sides) {
    if (start == nullptr) {
      start = &side.from;
      loops.push_back({{}, true});
    }
    const geom::Vector3 p = from.in_space(side.from) - to.origin;
    loops.back().points.push_back({dot(p, to.along), dot(p, to.up)});
    if (side.to == *start) start = nullptr;
  }
  if (dot(from.along, to.along) < 0.0) {  // seen from behind
    for (Polyline& loop : loops) loop = geom::reversed(std::move(loop));
  }
  return loops;
}

CapLines lines_of(const dobra::solid::Cap& cap, const CutFrame& to) {
  const bool behind = dot(cap.frame.along, to.along) < 0.0;
  CapLines made;
  std::map<std::string, std::vector<Polyline>> pieces;
  std::vector<Polyline> outer;
  for (const dobra::solid::CapLine& line : cap.lines) {
    Polyline course{{}, line.line.closed};
    for (const Point p : line.line.points) {
      const geom::Vector3 from = cap.frame.in_space(p) - to.origin;
      course.points.push_back({dot(from, to.along), dot(from, to.up)});
    }
    if (behind) course = geom::reversed(std::move(course));
    if (line.right == dobra::solid::outside) outer.push_back(course);  // the rock is on its left
    const auto name = std::min_element(line.names.begin(), line.names.end(),
                                       [](const auto& a, const auto& b) { return rank_of(a) < rank_of(b); });
    if (name != line.names.end()) pieces[*name].push_back(std::move(course));
  }
  for (auto& [name, lines] : pieces) made.named[name] = joined(std::move(lines), true);
  for (Polyline& loop : joined(std::move(outer), false)) {
    if (loop.closed && geom::signed_area(loop) > 0.0) made.border.push_back(std::move(loop));
  }
  for (const dobra::solid::CapRegion& region : cap.regions) {
    for (Polyline& loop : loops_of(region, cap.frame, to)) {
      if (geom::signed_area(loop) > 0.0) made.contours.emplace_back(region.solid, std::move(loop));
    }
  }
  return made;
}

}  // namespace recon::block
