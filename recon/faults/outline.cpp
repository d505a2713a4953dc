// 1. The faces between horizons, extended and trimmed to the faults, are rock.
// 2. From stretches of horizons without rock over them a look upwards: where the underside of another horizon faces
//    them, rock is missing between the two.
// 3. The cells between the faults in which that happens are closed from their own beds.

#include "recon/faults/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "recon/faults/cell_rock.h"
#include "recon/faults/cutoffs.h"
#include "recon/faults/parting.h"
#include "recon/section/face_contours.h"
#include "recon/section/section_faces.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"
#include "shared/topo/region.h"

namespace recon::faults {

namespace {

using section::HorizonId;

/// A place on a horizon over which there is no rock, though another horizon lies above.
struct MissingRock {
  HorizonId horizon;
  geom::Point at;
};

bool in_any(const std::vector<geom::Polyline>& rings, geom::Point p) {
  return std::any_of(rings.begin(), rings.end(), [&](const geom::Polyline& ring) {
    return ring.box().contains(p) && geom::locate(ring, p) == geom::Side::Inside;
  });
}

/// Finds them.
class MissingRocks {
 public:
  MissingRocks(const section::Section& section, const std::vector<geom::Polyline>& faults)
      : section_(section), faults_(faults), size_(box_of(section).diagonal()) {
    for (const section::Horizon& horizon : section.horizons) boxes_.push_back(horizon.line.box());
  }

  /// @param rings  what is rock, beside the faces between horizons.
  [[nodiscard]] std::vector<MissingRock> beneath(const std::vector<section::BareStretch>& bare,
                                                 const std::vector<geom::Polyline>& rings) const {
    std::vector<MissingRock> open;
    for (const section::BareStretch& stretch : bare) {
      const std::vector<double> arcs = geom::arc_lengths(stretch.line);
      if (arcs.back() <= 1e-6 * size_) continue;  // what is past a fault
      constexpr int samples = 16;
      for (int k = 0; k < samples; ++k) {
        const double s = arcs.back() * (k + 0.5) / samples;
        const auto i = static_cast<std::size_t>(std::upper_bound(arcs.begin(), arcs.end() - 1, s) - arcs.begin()) - 1;
        const geom::Segment segment = stretch.line.segment(i);
        const geom::Point p = geom::point_at(stretch.line, arcs, s);
        const geom::Vector up = geom::normalised(geom::left_of(segment.to - segment.from));
        if (under_another(stretch.horizon, p, up) && !in_any(rings, p + 1e-6 * size_ * up)) {
          open.push_back({stretch.horizon, p});
        }
      }
    }
    return open;
  }

 private:
  /// Whether the first line over a place is the underside of another horizon.
  [[nodiscard]] bool under_another(HorizonId horizon, geom::Point p, geom::Vector up) const {
    geom::Segment way{p + 1e-9 * size_ * up, p + 2.0 * size_ * up};
    const std::string& own = whole_name(*find_horizon(section_, horizon));
    std::vector<std::size_t> met;  // by their boxes
    bool other = false;
    for (std::size_t h = 0; h < boxes_.size(); ++h) {
      if (!boxes_[h].overlaps(way.box())) continue;
      met.push_back(h);
      other = other || whole_name(section_.horizons[h]) != own;
    }
    if (!other) return false;
    bool found = false;
    const auto meet = [&](const geom::Segment& line, bool underside) {
      if (!line.box().overlaps(way.box())) return;
      const geom::Intersection hit = geom::intersect(way, line);
      if (hit.kind == geom::IntersectionKind::None) return;
      way.to = hit.start.point;
      found = underside;
    };
    for (const std::size_t h : met) {
      const bool is_other = whole_name(section_.horizons[h]) != own;
      const geom::Polyline& line = section_.horizons[h].line;
      for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const geom::Segment segment = line.segment(i);
        meet(segment, is_other && geom::cross(segment.to - segment.from, up) > 0.0);
      }
    }
    for (const geom::Polyline& fault : faults_) {
      for (std::size_t i = 0; i < fault.segment_count(); ++i) meet(fault.segment(i), false);
    }
    return found;
  }

  const section::Section& section_;
  const std::vector<geom::Polyline>& faults_;
  double size_;
  std::vector<geom::Box> boxes_;
};

/// The cells between faults that have one of the places.
class OpenCells {
 public:
  OpenCells(const section::Section& section, const section::Arrangement& arrangement, std::size_t parting)
      : section_(section), arrangement_(arrangement), parting_(parting), cells_(cells_of(arrangement, parting)) {}

  std::vector<Cell> with(const std::vector<MissingRock>& places, const geom::Polyline& frame, double tolerance) {
    std::map<std::size_t, Cell> found;
    const double near = 1e-7 * box_of(section_).diagonal();
    for (std::size_t h = 0; h < section_.horizons.size(); ++h) {
      for (auto& [cell, line] : stretches_of(h)) {
        found[cell].stretches.push_back({whole_name(section_.horizons[h]), line});
        const auto lies_on = [&, part = &line](const MissingRock& place) {
          return place.horizon == section_.horizons[h].id && geom::distance(*part, place.at) <= near;
        };
        if (std::any_of(places.begin(), places.end(), lies_on)) wanted_.insert(cell);
      }
    }
    std::vector<Cell> open;
    for (const std::size_t cell : wanted_) {
      if (cells_.root(topo::Structure::unbounded().index()) == cell) continue;
      Cell& made = found[cell];
      made.contours = contours(cell);
      made.frame = frame;
      made.tolerance = tolerance;
      open.push_back(std::move(made));
    }
    return open;
  }

 private:
  /// The parts of a horizon by cell, in its order.
  std::vector<std::pair<std::size_t, geom::Polyline>> stretches_of(std::size_t horizon) {
    const topo::Subdivision& sub = arrangement_.subdivision();
    std::vector<std::pair<std::size_t, geom::Polyline>> parts;
    bool goes_on = false;
    geom::Point last;
    const auto finish = [&] {
      if (goes_on) parts.back().second.points.push_back(last);
      goes_on = false;
    };
    for (const topo::HalfEdgeId h : arrangement_.path(static_cast<std::uint32_t>(parting_ + 1 + horizon))) {
      const std::vector<std::uint32_t>& lines = arrangement_.lines_on(topo::Structure::edge(h));
      const std::size_t cell = cells_.root(sub.face(h).index());
      const bool along_fault = lines.front() <= parting_;
      if (along_fault || (goes_on && parts.back().first != cell)) finish();
      last = sub.point(sub.target(h));
      if (along_fault) continue;
      if (!goes_on) parts.push_back({cell, {}});
      goes_on = true;
      arrangement_.append(h, parts.back().second.points);
    }
    finish();
    return parts;
  }

  std::vector<geom::Polyline> contours(std::size_t cell) {
    std::vector<topo::FaceId> faces;
    for (const topo::FaceId f : arrangement_.subdivision().faces()) {
      if (cells_.root(f.index()) == cell) faces.push_back(f);
    }
    return section::contours_round(arrangement_, faces, [&](topo::FaceId f) { return cells_.root(f.index()) == cell; });
  }

  const section::Section& section_;
  const section::Arrangement& arrangement_;
  std::size_t parting_;  ///< How many lines of the arrangement are faults.
  base::DisjointSets cells_;
  std::set<std::size_t> wanted_;
};

std::string remark_on(const Closing& closing) {
  const geom::Point at = geom::midpoint(closing.line.from, closing.line.to);
  return fmt::format(
      "horizon '{}' leaves the rock open at {}: a straight line of {:.4g} m closes it for the blocks and their areas; "
      "close the gap (--join-gaps, a larger tolerance), or give a border ([[input.border]])",
      closing.bed, at, geom::distance(closing.line.from, closing.line.to));
}

std::string remark_on(const section::Section& section, const MissingRock& place) {
  return fmt::format(
      "rock is missing over horizon '{}' at {}, though another horizon lies above: what encloses it is open, so that a "
      "block lacks it or is missing, and areas there are too small; give a border ([[input.border]])",
      find_horizon(section, place.horizon)->name, place.at);
}

/// Rock over or under all beds, which faults alone enclose.
void remark_on_faults_alone(const section::SectionFaces& faces, const section::Section& section, Outline& outline) {
  for (const section::RockUnit& unit : faces.units) {
    if ((unit.top && unit.base) || unit.contours.empty() || unit.area <= 1e-6 * faces.area) continue;
    const section::Horizon& bed = section.horizons[unit.top ? *unit.top : *unit.base];
    const geom::Point at = unit.contours.front().points.front();
    outline.remarks.push_back(
        fmt::format("{} horizon '{}' {:.6g} m2 count as rock that no other horizon but faults close off, by {}; give a "
                    "border ([[input.border]]) if blocks are to end at the horizon",
                    unit.top ? "under" : "over", bed.name, unit.area, at));
  }
}

/// Ends of beds at the section's side that stand back from those of their neighbours.
void remark_on_notches(const section::Section& section, const std::vector<geom::Polyline>& faults, double tolerance,
                       Outline& outline) {
  for (const section::LineEnd side : {section::LineEnd::First, section::LineEnd::Last}) {
    std::vector<std::pair<const section::Horizon*, geom::Point>> ends;
    for (const std::size_t i : stack_order(section)) {
      const section::Horizon& horizon = section.horizons[i];
      if (!is_outermost(section, horizon, side)) continue;
      const std::vector<geom::Point>& points = horizon.line.points;
      const geom::Point end = side == section::LineEnd::First ? points.front() : points.back();
      const auto near = [&](const geom::Polyline& fault) { return geom::distance(fault, end) <= tolerance; };
      if (std::none_of(faults.begin(), faults.end(), near)) ends.emplace_back(&horizon, end);
    }
    for (std::size_t i = 1; i + 1 < ends.size(); ++i) {
      const geom::Vector way = ends[i + 1].second - ends[i - 1].second;
      const double twice = geom::cross(way, ends[i].second - ends[i - 1].second);
      const double depth = (side == section::LineEnd::First ? twice : -twice) / geom::length(way);
      if (!(depth > 2.0 * tolerance)) continue;
      outline.remarks.push_back(
          fmt::format("horizon '{}' ends {:.4g} m inside the section's side at {}: the rock ends at straight lines to "
                      "that place, which leave out {:.6g} m2; draw it to the side, or give a border ([[input.border]])",
                      ends[i].first->name, depth, ends[i].second, 0.5 * std::abs(twice)));
    }
  }
}

/// Adds the rock of cells that the faces leave open.
base::Result<void> close_cells(const section::Section& section, std::vector<Fault> faults,
                               const std::vector<MissingRock>& places, double tolerance, Outline& outline) {
  const double size = box_of(section).diagonal();
  for (Fault& fault : faults)
    fault.lower.kind = fault.upper.kind = EndKind::Border;  // a tip's straight on parts no bed
  std::vector<geom::Polyline> lines = parting_lines(faults, size);
  const std::size_t parting = lines.size();
  const geom::Polyline frame = frame_of(box_of(section), size);
  lines.push_back(frame);
  for (const section::Horizon& horizon : section.horizons) lines.push_back(horizon.line);
  DOBRA_TRY(const section::Arrangement arrangement, section::Arrangement::make(std::move(lines)));
  for (const Cell& cell : OpenCells(section, arrangement, parting).with(places, frame, tolerance)) {
    DOBRA_TRY(CellRock rock, rock_of(cell));
    outline.rings.insert(outline.rings.end(), rock.rings.begin(), rock.rings.end());
    if (!rock.closings.empty() && geom::distance(rock.closings[0].line.from, rock.closings[0].line.to) > 1e-6 * size)
      outline.remarks.push_back(remark_on(rock.closings[0]));
  }
  return {};
}

}  // namespace

base::Result<Outline> outline_of(const section::Section& section, std::vector<Fault> faults,
                                 const FaultOptions& options) {
  Outline made;
  if (section.border) {
    made.rings = {*section.border};
    return made;
  }
  for (Fault& fault : faults) fault.undecided.reset();
  section::Section tidy = section;
  const double past = 1e-9 * box_of(section).diagonal();
  const std::vector<FaultCutoffs> cutoffs = cutoffs_of(section, faults, options);
  for (section::Horizon& horizon : tidy.horizons) reach_faults(cutoffs, past, horizon);
  DOBRA_TRY(const section::SectionFaces faces, faces_of(tidy));
  for (const section::RockUnit& unit : faces.units)
    made.rings.insert(made.rings.end(), unit.contours.begin(), unit.contours.end());
  for (const section::Unit& unit : section.units) made.rings.push_back(unit.contour);

  std::vector<geom::Polyline> fault_lines;
  for (const Fault& fault : faults) fault_lines.push_back(own_line(fault));
  remark_on_faults_alone(faces, tidy, made);
  remark_on_notches(tidy, fault_lines, tolerance_of(section, options), made);
  const MissingRocks look(tidy, fault_lines);
  std::vector<MissingRock> open = look.beneath(faces.bare, made.rings);
  const bool air = std::any_of(section.lines.begin(), section.lines.end(), [](const section::SectionLine& line) {
    return line.kind == section::LineKind::Topography;
  });
  if (!open.empty() && !air) {
    DOBRA_TRY_VOID(close_cells(tidy, faults, open, tolerance_of(section, options), made));
    open = look.beneath(faces.bare, made.rings);
  }
  std::set<HorizonId> told;
  for (const MissingRock& place : open) {
    if (told.insert(place.horizon).second) made.remarks.push_back(remark_on(section, place));
  }
  if (made.rings.empty()) return made;
  DOBRA_TRY(made.rings, dobra::topo::region(made.rings, dobra::topo::Inside::Positive));
  return made;
}

}  // namespace recon::faults
