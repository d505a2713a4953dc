#include "recon/section/rejoin.h"

#include <optional>
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

}  // namespace

void rejoin_ends(Section& section, double reach) {
  std::vector<Line> lines;
  const auto add = [&](geom::Polyline& line) { lines.push_back({&line, line.box().grown(reach)}); };
  for (Horizon& horizon : section.horizons) add(horizon.line);
  for (SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault) add(line.line);
  }
  for (const Line& own : lines) {
    if (own.line->closed) continue;
    for (const bool first : {true, false}) {
      const auto end = [&]() -> geom::Point& { return first ? own.line->points.front() : own.line->points.back(); };
      const geom::Point p = end();
      for (const Line& other : lines) {
        if (&other == &own || !other.box.overlaps({p, p}) || is_on(*other.line, p)) continue;
        const auto segment = segment_near(*other.line, p, reach);
        if (!segment) continue;
        end() = place_on(*other.line, *segment, p, reach);
        break;
      }
    }
  }
}

}  // namespace recon::section
