#include "recon/section/rejoin.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "shared/geom/predicates.h"

namespace recon::section {
namespace {

struct Line {
  geom::Polyline* line;
  geom::Box box;  ///< Grown by the reach.
};

/// Whether a point lies exactly on a line.
bool is_on(const geom::Polyline& line, geom::Point p) {
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment side = line.segment(i);
    if (side.from == p || side.to == p) return true;
    if (side.box().overlaps({p, p}) && geom::orient2d(side.from, side.to, p) == geom::Sign::Zero) return true;
  }
  return false;
}

/// The segment of a line that is nearest to a point, if it is within reach.
std::optional<std::size_t> segment_near(const geom::Polyline& line, geom::Point p, double reach) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const double distance = geom::distance(line.segment(i), p);
    if (distance > reach) continue;
    reach = distance;
    nearest = i;
  }
  return nearest;
}

/// Onto a vertex that is within reach, or onto a new one.
geom::Point place_on(geom::Polyline& line, std::size_t segment, geom::Point p, double reach) {
  const geom::Segment side = line.segment(segment);
  if (geom::distance(side.from, p) <= reach) return side.from;
  if (geom::distance(side.to, p) <= reach) return side.to;
  const geom::Point at = geom::interpolate(side.from, side.to, geom::nearest_fraction(side, p));
  line.points.insert(line.points.begin() + static_cast<std::ptrdiff_t>(segment) + 1, at);
  return at;
}

/// Takes an end of `own` to the first of the others that is within reach, unless it is on one of them.
/// @return whether it is on one now.
bool rejoin_end(std::span<const Line> others, const Line& own, geom::Point& end, double reach) {
  std::vector<geom::Polyline*> near;
  for (const Line& other : others) {
    if (&other != &own && other.box.overlaps({end, end})) near.push_back(other.line);
  }
  if (std::any_of(near.begin(), near.end(), [&](const geom::Polyline* line) { return is_on(*line, end); })) return true;
  for (geom::Polyline* line : near) {
    const auto segment = segment_near(*line, end, reach);
    if (!segment) continue;
    end = place_on(*line, *segment, end, reach);
    return true;
  }
  return false;
}

}  // namespace

void rejoin_ends(Section& section, double reach) {
  std::vector<Line> lines;
  const auto add = [&](geom::Polyline& line) { lines.push_back({&line, line.box().grown(reach)}); };
  for (SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault) add(line.line);
  }
  for (Horizon& horizon : section.horizons) add(horizon.line);
  const std::size_t faults = std::count_if(section.lines.begin(), section.lines.end(),
                                           [](const SectionLine& line) { return line.kind == LineKind::Fault; });
  for (const Line& own : lines) {
    if (own.line->closed) continue;
    for (const bool first : {true, false}) {
      geom::Point end = first ? own.line->points.front() : own.line->points.back();
      // Faults part what ends on them, whatever else meets there.
      if (!rejoin_end({lines.data(), faults}, own, end, reach))
        rejoin_end({lines.data() + faults, lines.size() - faults}, own, end, reach);
      (first ? own.line->points.front() : own.line->points.back()) = end;
    }
  }
}

}  // namespace recon::section
