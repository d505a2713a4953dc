#include "recon/section/rejoin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"

namespace recon::section {
namespace {

struct Line {
  geom::Polyline* line;
  geom::Box box;  ///< Grown by the reach.
};

/// The segment of a line that a point lies on exactly; its ends too.
std::optional<std::size_t> segment_under(const geom::Polyline& line, geom::Point p) {
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment side = line.segment(i);
    if (side.from == p || side.to == p) return i;
    if (side.box().overlaps({p, p}) && geom::orient2d(side.from, side.to, p) == geom::Sign::Zero) return i;
  }
  return std::nullopt;
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

/// A vertex of the line where p lies on a segment, unless that has one within reach.
geom::Point place_on(geom::Polyline& line, std::size_t segment, geom::Point p, double reach) {
  const geom::Segment side = line.segment(segment);
  if (geom::distance(side.from, p) <= reach) return side.from;
  if (geom::distance(side.to, p) <= reach) return side.to;
  line.points.insert(line.points.begin() + static_cast<std::ptrdiff_t>(segment) + 1, p);
  return p;
}

/// An end, and the line that it lies on exactly, or else is within reach of.
struct LineEndAt {
  geom::Polyline* own;
  bool first;
  geom::Polyline* on = nullptr;
  geom::Polyline* near = nullptr;
  [[nodiscard]] geom::Point& point() const { return first ? own->points.front() : own->points.back(); }
};

/// Of the first of the others.  @return whether there is one.
bool find_line(std::span<const Line> others, double reach, LineEndAt& end) {
  const geom::Point p = end.point();
  for (const Line& other : others) {
    if (other.line == end.own || !other.box.overlaps({p, p})) continue;
    if (segment_under(*other.line, p)) {
      end.on = other.line;
      return true;
    }
    if (end.near == nullptr && segment_near(*other.line, p, reach)) end.near = other.line;
  }
  return end.near != nullptr;
}

/// Moves an end, and what else has a vertex there.
void move_vertices(geom::Point from, geom::Point to, std::span<const Line> lines) {
  for (const Line& line : lines) {
    if (line.box.overlaps({from, from})) std::replace(line.line->points.begin(), line.line->points.end(), from, to);
  }
}

}  // namespace

void rejoin_ends(Section& section, double reach) {
  std::vector<Line> lines;
  const auto add = [&](geom::Polyline& line) { lines.push_back({&line, line.box().grown(reach)}); };
  for (SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault) add(line.line);
  }
  const std::size_t faults = lines.size();
  for (Horizon& horizon : section.horizons) add(horizon.line);
  const std::size_t beds = lines.size();
  for (SectionLine& line : section.lines) {
    if (line.kind == LineKind::Topography) add(line.line);
  }
  if (section.border) add(*section.border);
  const std::span<const Line> all(lines);
  std::vector<LineEndAt> ends;
  for (const Line& own : all.first(beds)) {
    for (const bool first : {true, false}) {
      if (own.line->closed) continue;
      LineEndAt end{own.line, first};
      // Faults part what ends on them, whatever else meets there; what bounds the section comes last.
      if (find_line(all.first(faults), reach, end) || find_line(all.subspan(faults, beds - faults), reach, end) ||
          find_line(all.subspan(beds), reach, end))
        ends.push_back(end);
    }
  }
  if (std::all_of(ends.begin(), ends.end(), [](const LineEndAt& end) { return end.on != nullptr; })) return;
  // A line that gets a vertex no longer runs through points that it ran through, but for its vertices.
  for (const LineEndAt& end : ends) {
    if (end.on != nullptr) place_on(*end.on, *segment_under(*end.on, end.point()), end.point(), 0.0);
  }
  for (const LineEndAt& end : ends) {
    if (end.on != nullptr) continue;
    const auto segment = segment_near(*end.near, end.point(), reach);
    if (!segment) continue;
    const geom::Segment side = end.near->segment(*segment);
    const geom::Point at = geom::interpolate(side.from, side.to, geom::nearest_fraction(side, end.point()));
    move_vertices(end.point(), place_on(*end.near, *segment, at, reach), all);
  }
}

void join_at_branches(Section& section, double reach) {
  std::vector<Line> faults, all;
  for (SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault) faults.push_back({&line.line, line.line.box().grown(reach)});
  }
  all = faults;
  std::vector<geom::Point*> beds;
  for (Horizon& horizon : section.horizons) {
    all.push_back({&horizon.line, horizon.line.box().grown(reach)});
    beds.push_back(&horizon.line.points.front());
    beds.push_back(&horizon.line.points.back());
  }
  for (const Line& branch : faults) {
    for (const bool first : {true, false}) {
      const geom::Point end = first ? branch.line->points.front() : branch.line->points.back();
      const auto is_here = [&](const geom::Point* bed) { return geom::distance(*bed, end) <= reach; };
      if (std::none_of(beds.begin(), beds.end(), is_here)) continue;
      for (const Line& main : faults) {
        if (main.line == branch.line || !main.box.overlaps({end, end})) continue;
        const auto segment = segment_near(*main.line, end, reach);
        if (!segment) continue;
        const geom::Segment side = main.line->segment(*segment);
        const geom::Point at = geom::interpolate(side.from, side.to, geom::nearest_fraction(side, end));
        const geom::Point vertex = place_on(*main.line, *segment, at, reach);
        for (geom::Point* const bed : beds) {
          if (is_here(bed)) *bed = vertex;
        }
        move_vertices(end, vertex, all);
        break;
      }
    }
  }
}

std::optional<Overshoot> overshoot_of(const Section& section, const Horizon& horizon, LineEnd end, double longest) {
  geom::Polyline line = horizon.line;
  if (end == LineEnd::First) std::reverse(line.points.begin(), line.points.end());
  std::optional<Overshoot> found;
  double way = 0.0;
  for (std::size_t i = line.segment_count(); i-- > 0 && way < longest && !found;) {
    const geom::Segment side = line.segment(i);
    for (const SectionLine& fault : section.lines) {
      if (fault.kind != LineKind::Fault || !fault.line.box().overlaps(side.box())) continue;
      for (std::size_t k = 0; k < fault.line.segment_count(); ++k) {
        const geom::Intersection met = geom::intersect(side, fault.line.segment(k));
        if (met.kind == geom::IntersectionKind::None || (i == 0 && met.start.point == side.from)) continue;
        const double length = way + geom::distance(met.start.point, side.to);
        if (length > 0.0 && length < (found ? found->length : longest)) found = Overshoot{&horizon, &fault, length};
      }
    }
    way += side.length();
  }
  return found;
}

std::string words_of(const Overshoot& overshoot) {
  return fmt::format(
      "horizon '{}' goes on {:.4g} m beyond fault '{}', which it crosses, and ends there; "
      "snap_to_faults of {:g} m (--snap) cuts it back to the fault",
      overshoot.horizon->name, overshoot.length, overshoot.fault->name, tolerance_above(overshoot.length));
}

double tolerance_above(double length) {
  if (!(length > 0.0)) return 0.0;
  const double step = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  constexpr double safe = 1.0 + 1e-6;  // against the rounding of what it is compared with
  return (std::floor(safe * length / step) + 1.0) * step;
}

}  // namespace recon::section
