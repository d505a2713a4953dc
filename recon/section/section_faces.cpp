// 1. Horizons, faults and the border become one subdivision.
// 2. Faces within the border are found; each is named by the horizons over and under it.
// 3. Faces under the same horizon become a unit.
// 4. The polygons that the user gave become a second subdivision: faces that none or several of them hold are misfits.

#include "recon/section/section_faces.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "recon/section/face_contours.h"
#include "recon/section/open_gaps.h"
#include "recon/section/rejoin.h"
#include "shared/base/parallel.h"
#include "shared/geom/contour.h"
#include "shared/geom/place.h"

namespace recon::section {

namespace {

using topo::FaceId;
using topo::HalfEdgeId;
using topo::Structure;
using topo::Subdivision;

constexpr const char* border_label = "the border";
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
constexpr double near_ends = 1e-9;  ///< Of the section's size.

/// Twice the area that the line sweeps about the origin `about`.
double swept(const geom::Polyline& line, geom::Point about) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    sum += geom::cross(line.points[i - 1] - about, line.points[i] - about);
  return sum;
}

/// The lines of a section as its arrangement numbers them: horizons, faults, topographies, the border.
struct Numbered {
  std::vector<geom::Polyline> lines;
  std::vector<std::string> names;
  std::vector<const SectionLine*> surfaces;  ///< Topographies.
  std::size_t first_surface = 0;             ///< Their first number.
};

Numbered lines_of(const Section& section) {
  Numbered numbered;
  const auto add = [&](const geom::Polyline& line, std::string name) {
    numbered.lines.push_back(line);
    numbered.names.push_back(std::move(name));
  };
  for (const Horizon& horizon : section.horizons) add(horizon.line, "horizon " + horizon.name);
  for (const SectionLine& line : section.lines) {
    if (line.kind == LineKind::Fault) add(line.line, "fault " + line.name);
  }
  numbered.first_surface = numbered.lines.size();
  for (const SectionLine& line : section.lines) {
    if (line.kind != LineKind::Topography) continue;
    numbered.surfaces.push_back(&line);
    add(line.line, "topography " + line.name);
  }
  if (section.border) add(*section.border, "border");
  return numbered;
}

/// What one line is drawn in: all faults, the pieces of a horizon, any other line by itself.
std::string whole_of(const Section& section, std::uint32_t line, std::size_t first_surface) {
  if (line < section.horizons.size()) return "horizon " + whole_name(section.horizons[line]);
  return line < first_surface ? "fault" : std::to_string(line);
}

/// An end of a line is an end of the section unless something passes there: a line, or two parts that end there.
bool is_free(const Section& section, const Arrangement& arrangement, std::size_t first_surface, geom::Point end,
             std::size_t own) {
  const Subdivision& sub = arrangement.subdivision();
  std::map<std::string, int> ways;
  for (const HalfEdgeId h : sub.round(*sub.vertex_at(end))) {
    for (const std::uint32_t line : arrangement.lines_on(Structure::edge(h))) {
      if (line != own && ++ways[whole_of(section, line, first_surface)] > 1) return false;
    }
  }
  return true;
}

/// Whether a fault leads from one place to another, so that it is the border between them.
bool fault_joins(const Section& section, geom::Point from, geom::Point to) {
  return std::any_of(section.lines.begin(), section.lines.end(), [&](const SectionLine& line) {
    const geom::Point first = line.line.points.front();
    const geom::Point last = line.line.points.back();
    return line.kind == LineKind::Fault && ((first == from && last == to) || (first == to && last == from));
  });
}

struct HorizonEnd {
  std::size_t horizon = 0;
  LineEnd end = LineEnd::First;
};

/// The border's left and right sides.
struct Sides {
  std::vector<geom::Polyline> lines;
  std::vector<HorizonEnd> loose;  ///< From which no line leads down.
};

/// Straight lines between the ends of horizons that follow each other, left and right, from the topography on. An end
/// that lies on another horizon or on a fault that goes on is no end of the section, nor is one between two pieces of a
/// horizon.
Sides sides_of(const Section& section, const std::vector<std::size_t>& order,
               const std::vector<const SectionLine*>& surfaces, std::size_t first_surface,
               const Arrangement& arrangement) {
  Sides sides;
  for (const LineEnd side : {LineEnd::First, LineEnd::Last}) {
    const auto end_of = [&](const geom::Polyline& line) {
      return side == LineEnd::First ? line.points.front() : line.points.back();
    };
    std::optional<geom::Point> last;
    std::optional<std::size_t> last_horizon;
    const auto join = [&](geom::Point end, std::size_t own) {
      if (!is_free(section, arrangement, first_surface, end, own)) return false;
      if (last && *last != end && !fault_joins(section, *last, end)) sides.lines.push_back({{*last, end}, false});
      last = end;
      return true;
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i) join(end_of(surfaces[i]->line), first_surface + i);
    for (const std::size_t index : order) {
      const Horizon& horizon = section.horizons[index];
      if (!is_outermost(section, horizon, side)) continue;
      if (join(end_of(horizon.line), index)) {
        last_horizon = index;
      } else {
        sides.loose.push_back({index, side});
      }
    }
    if (last_horizon) sides.loose.push_back({*last_horizon, side});
  }
  return sides;
}

/// Half-edges of each horizon over and under a face, by the horizon's rank in the stack, 0 the highest.
struct Bounds {
  std::map<std::size_t, std::size_t> over;
  std::map<std::size_t, std::size_t> under;
};

class Units {
 public:
  /// @param faults  lines of the arrangement that are faults: first, and one behind the last.
  Units(const Section& section, const Arrangement& arrangement, const std::vector<std::size_t>& order,
        std::pair<std::size_t, std::size_t> faults)
      : section_(section), arrangement_(arrangement), order_(order), faults_(faults) {
    const Subdivision& sub = arrangement.subdivision();
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const std::vector<HalfEdgeId> path = arrangement.path(static_cast<std::uint32_t>(order[rank]));
      lengths_.push_back(path.size());
      for (const HalfEdgeId h : path) {
        if (sub.face(h) == sub.face(Structure::twin(h))) continue;  // what ends within a face does not bound it
        ++bounds_[sub.face(h)].under[rank];
        ++bounds_[sub.face(Structure::twin(h))].over[rank];
      }
    }
  }

  /// By a horizon, the one that lies beyond all faces on one side of it; none where that differs.
  using Neighbours = std::map<std::string, std::optional<std::size_t>>;
  /// Faces of one unit, -1: without a horizon over them, else the rank of that.
  using Group = std::pair<std::ptrdiff_t, std::vector<FaceId>>;
  /// What the faces fall into, from the top down.
  [[nodiscard]] std::vector<Group> groups(const std::vector<FaceId>& faces) const {
    const std::map<FaceId, std::size_t> tops = tops_of(faces);
    std::map<std::ptrdiff_t, std::vector<FaceId>> by_top;
    for (const FaceId f : faces) {
      const auto top = tops.find(f);
      by_top[top == tops.end() ? -1 : static_cast<std::ptrdiff_t>(top->second)].push_back(f);
    }
    return {by_top.begin(), by_top.end()};
  }
  /// Where faults alone are the floor of a unit, the horizon under all other faces under its top is its base.
  [[nodiscard]] std::vector<RockUnit> of(const std::vector<Group>& groups) const {
    const Neighbours below = bases_below(groups);
    return base::parallel_map<RockUnit>(
        groups.size(), [&](std::size_t i) { return unit_of(groups[i].first, groups[i].second, below); });
  }

 private:
  /// The rank of the horizon over each face. Where faults are the roof of one, that of all other faces on its floor
  /// counts; if they differ, that of what lies over most of the faults, unless it belongs below the face.
  [[nodiscard]] std::map<FaceId, std::size_t> tops_of(const std::vector<FaceId>& faces) const {
    std::map<FaceId, std::size_t> tops;
    std::vector<FaceId> open;
    for (const FaceId f : faces) {
      const Bounds bounds = bounds_of(f);
      if (bounds.over.empty()) {
        open.push_back(f);
      } else {
        tops[f] = bounds.over.rbegin()->first;
      }
    }
    const Neighbours above = tops_above(tops);
    for (bool found = true; found;) {  // one fault after the other
      found = false;
      for (const FaceId f : open) {
        if (tops.contains(f)) continue;
        const Side roof = side_of(f, true);
        if (roof.faults < 0.9 * roof.all) continue;  // open above
        std::optional<std::size_t> top = over_faults(roof, tops);
        const Bounds bounds = bounds_of(f);
        if (!bounds.under.empty()) {
          const std::size_t floor = bounds.under.begin()->first;
          const auto other = above.find(whole(floor));
          if (other != above.end() && other->second)
            top = other->second;
          else if (top && belongs_below(*top, floor))
            continue;
        }
        if (!top) continue;
        tops[f] = *top;
        found = true;
      }
    }
    return tops;
  }

  [[nodiscard]] const std::string& whole(std::size_t rank) const { return whole_name(section_.horizons[order_[rank]]); }

  void add_neighbour(std::size_t rank, std::size_t beyond, Neighbours& neighbours) const {
    const auto [at, is_new] = neighbours.try_emplace(whole(rank), beyond);
    if (!is_new && at->second && whole(*at->second) != whole(beyond)) at->second.reset();
  }
  [[nodiscard]] Neighbours tops_above(const std::map<FaceId, std::size_t>& tops) const {
    Neighbours above;
    for (const auto& [f, top] : tops) {
      const Bounds bounds = bounds_of(f);
      if (!bounds.under.empty()) add_neighbour(bounds.under.begin()->first, top, above);
    }
    return above;
  }
  [[nodiscard]] Neighbours bases_below(const std::vector<Group>& groups) const {
    Neighbours below;
    for (const auto& [top, faces] : groups) {
      for (const FaceId f : faces) {
        const Bounds bounds = bounds_of(f);
        if (top >= 0 && !bounds.under.empty())
          add_neighbour(static_cast<std::size_t>(top), bounds.under.begin()->first, below);
      }
    }
    return below;
  }

  /// Whether a piece of the horizon lies no higher than the one that a face lies on.
  [[nodiscard]] bool belongs_below(std::size_t rank, std::size_t under) const {
    for (std::size_t k = under; k < order_.size(); ++k) {
      if (k == rank || whole(k) == whole(rank)) return true;
    }
    return false;
  }

  /// The edges of a face that have it below, or above.
  struct Side {
    double all = 0.0;                 ///< Their width.
    double faults = 0.0;              ///< That of faults.
    std::map<FaceId, double> widths;  ///< Of faults, by what lies beyond them.
  };
  [[nodiscard]] Side side_of(FaceId f, bool roof_not_floor) const {
    const Subdivision& sub = arrangement_.subdivision();
    Side side;
    for (const HalfEdgeId h : sub.half_edges(sub.outer_loop(f))) {
      const double leftwards = sub.point(sub.origin(h)).x - sub.point(sub.target(h)).x;
      const double width = roof_not_floor ? leftwards : -leftwards;
      const FaceId beyond = sub.face(Structure::twin(h));
      if (width <= 0.0 || beyond == f) continue;
      side.all += width;
      const std::vector<std::uint32_t>& lines = arrangement_.lines_on(Structure::edge(h));
      const bool fault = std::any_of(lines.begin(), lines.end(), [&](std::uint32_t line) {
        return line >= faults_.first && line < faults_.second;
      });
      if (!fault) continue;
      side.faults += width;
      side.widths[beyond] += width;
    }
    return side;
  }

  /// The top of what lies beyond more than half of a roof; of the pieces of a horizon the widest.
  [[nodiscard]] std::optional<std::size_t> over_faults(const Side& roof,
                                                       const std::map<FaceId, std::size_t>& tops) const {
    std::map<std::string, std::map<std::size_t, double>> widths;
    for (const auto& [beyond, width] : roof.widths) {
      if (const auto top = tops.find(beyond); top != tops.end()) widths[whole(top->second)][top->second] += width;
    }
    for (const auto& [name, pieces] : widths) {
      double sum = 0.0;
      for (const auto& [rank, width] : pieces) sum += width;
      if (sum <= 0.5 * roof.all) continue;
      return std::max_element(pieces.begin(), pieces.end(),
                              [](const auto& a, const auto& b) { return a.second < b.second; })
          ->first;
    }
    return std::nullopt;
  }

  [[nodiscard]] Bounds bounds_of(FaceId f) const {
    const auto found = bounds_.find(f);
    return found == bounds_.end() ? Bounds{} : found->second;
  }

  [[nodiscard]] RockUnit unit_of(std::ptrdiff_t top, const std::vector<FaceId>& faces, const Neighbours& below) const {
    RockUnit unit;
    std::size_t base = none;
    for (const FaceId f : faces) {
      const Bounds bounds = bounds_of(f);
      if (!bounds.under.empty()) base = std::min(base, bounds.under.begin()->first);
      unit.area += arrangement_.area(f);
    }
    const auto on_faults = [&](FaceId f) {
      const Side floor = side_of(f, false);
      return floor.faults >= 0.9 * floor.all;
    };
    if (top >= 0 && base == none && std::all_of(faces.begin(), faces.end(), on_faults)) {
      const auto other = below.find(whole(static_cast<std::size_t>(top)));
      if (other != below.end()) base = other->second.value_or(none);
    }
    unit.faces = faces.size();
    if (top >= 0) unit.top = order_[static_cast<std::size_t>(top)];
    if (base != none) unit.base = order_[base];
    const auto name = [&](std::size_t horizon) { return section_.horizons[horizon].name; };
    unit.name = unit.top && unit.base ? fmt::format("{} - {}", name(*unit.top), name(*unit.base))
                : unit.top            ? name(*unit.top)
                : unit.base           ? "above " + name(*unit.base)
                                      : "without a horizon";
    unit.whole = is_whole(unit, faces);
    for (const FaceId f : faces) {
      std::vector<geom::Polyline> contours = contours_of(arrangement_, f);
      unit.contours.insert(unit.contours.end(), contours.begin(), contours.end());
    }
    return unit;
  }

  /// Faults may cut it: all of the top over its faces, all of the base under them, no other horizon, no face left out.
  [[nodiscard]] bool is_whole(const RockUnit& unit, const std::vector<FaceId>& faces) const {
    Bounds all;
    for (const FaceId f : faces) {
      const Bounds bounds = bounds_of(f);
      for (const auto& [rank, count] : bounds.over) all.over[rank] += count;
      for (const auto& [rank, count] : bounds.under) all.under[rank] += count;
    }
    const auto all_of = [&](const std::map<std::size_t, std::size_t>& side) {
      return side.size() == 1 && side.begin()->second == lengths_[side.begin()->first];
    };
    if (!unit.top || !unit.base || !all_of(all.over) || !all_of(all.under)) return false;
    const geom::Polyline contour =
        contour_between(section_.horizons[*unit.top].line, section_.horizons[*unit.base].line);
    return std::abs(geom::signed_area(contour) - unit.area) <= 1e-9 * unit.area;
  }

  const Section& section_;
  const Arrangement& arrangement_;
  const std::vector<std::size_t>& order_;
  std::pair<std::size_t, std::size_t> faults_;
  std::vector<std::size_t> lengths_;  ///< Half-edges of each horizon, by rank.
  std::map<FaceId, Bounds> bounds_;
};

/// Loose ends with the outside below, but for those of the lowest horizon.
std::vector<OpenPlace> open_places(const Section& section, const Arrangement& arrangement,
                                   const std::vector<HorizonEnd>& loose, std::size_t lowest) {
  const Subdivision& sub = arrangement.subdivision();
  std::vector<OpenPlace> open;
  for (const auto& [index, end] : loose) {
    const Horizon& horizon = section.horizons[index];
    const std::vector<HalfEdgeId> path = arrangement.path(static_cast<std::uint32_t>(index));
    if (path.empty() || whole_name(horizon) == whole_name(section.horizons[lowest])) continue;
    const HalfEdgeId below = Structure::twin(end == LineEnd::First ? path.front() : path.back());
    if (sub.face(below) != Structure::unbounded()) continue;
    open.push_back({horizon.id, sub.point(end == LineEnd::First ? sub.target(below) : sub.origin(below))});
  }
  return open;
}

/// Where the outside lies over a horizon.
std::vector<BareStretch> bare_stretches(const Section& section, const Arrangement& arrangement) {
  const Subdivision& sub = arrangement.subdivision();
  std::vector<BareStretch> bare;
  for (std::size_t i = 0; i < section.horizons.size(); ++i) {
    bool goes_on = false;
    for (const HalfEdgeId h : arrangement.path(static_cast<std::uint32_t>(i))) {
      const bool open = sub.face(h) == Structure::unbounded();
      if (open && !goes_on) bare.push_back({section.horizons[i].id, {}});
      if (open) {
        arrangement.append(h, bare.back().line.points);
        bare.back().line.points.push_back(sub.point(sub.target(h)));
      }
      goes_on = open;
    }
  }
  for (BareStretch& stretch : bare) stretch.line = geom::without_repeated_points(std::move(stretch.line));
  return bare;
}

/// Pairs of horizons with a common vertex.
base::Result<std::vector<HorizonMeeting>> meetings_in(const Section& section, const Arrangement& arrangement) {
  const Subdivision& sub = arrangement.subdivision();
  const auto count = static_cast<std::uint32_t>(section.horizons.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const HalfEdgeId h : arrangement.path(i)) {
      for (const topo::VertexId v : {sub.origin(h), sub.target(h)}) {
        for (const HalfEdgeId other : sub.round(v)) {
          for (const std::uint32_t j : arrangement.lines_on(Structure::edge(other))) {
            if (i < j && j < count) pairs.insert({i, j});
          }
        }
      }
    }
  }
  std::vector<HorizonMeeting> meetings;
  for (const auto& [i, j] : pairs) {
    const Horizon& first = section.horizons[i];
    const Horizon& second = section.horizons[j];
    DOBRA_TRY(LineMeeting meeting, meeting_of(first.line, second.line));
    meetings.push_back({first.id, second.id, meeting});
  }
  return meetings;
}

/// Gaps between polygons (or, within a border, all that they leave out) and what several of them hold.
base::Result<std::vector<Misfit>> misfits_of(const Section& section) {
  std::vector<Misfit> misfits;
  if (section.units.empty()) return misfits;
  std::vector<geom::Polyline> rings;
  for (const Unit& unit : section.units) rings.push_back(unit.contour);
  std::vector<std::string> names = unit_labels(section);
  if (section.border) {
    rings.push_back(*section.border);
    names.push_back(border_label);
  }
  DOBRA_TRY(const Arrangement arrangement, Arrangement::make(std::move(rings)));
  const Subdivision& sub = arrangement.subdivision();
  DOBRA_TRY(const auto within, arrangement.holders(0, names));
  for (const FaceId f : sub.faces()) {
    if (f == Structure::unbounded()) continue;
    const std::vector<std::uint32_t>& rings_round = within[f.index()];
    if (section.border && (rings_round.empty() || rings_round.back() < section.units.size())) continue;
    std::vector<std::string> holders;
    for (const std::uint32_t i : rings_round) {
      if (i < section.units.size()) holders.push_back(section.units[i].name);
    }
    if (holders.size() == 1) continue;
    Misfit misfit{holders.empty() ? "gap" : "overlap", fmt::format("{}", fmt::join(holders, ", ")), arrangement.area(f),
                  sub.point(sub.origin(sub.first(sub.outer_loop(f))))};
    if (holders.empty()) {
      std::set<std::string> neighbours;
      for (const HalfEdgeId h : sub.half_edges(sub.outer_loop(f))) {
        for (const std::uint32_t line : arrangement.lines_on(Structure::edge(h)))
          neighbours.insert(line < section.units.size() ? section.units[line].name : std::string(border_label));
      }
      misfit.between = fmt::format("{}", fmt::join(neighbours, ", "));
    }
    misfits.push_back(std::move(misfit));
  }
  if (!section.border) {
    for (Misfit& gap : open_gaps(section, arrangement, within)) misfits.push_back(std::move(gap));
  }
  return misfits;
}

}  // namespace

std::vector<std::string> unit_labels(const Section& section) {
  std::vector<std::string> labels;
  for (const Unit& unit : section.units) labels.push_back("unit '" + unit.name + '\'');
  return labels;
}

std::vector<std::size_t> stack_order(const Section& section) {
  const std::size_t count = section.horizons.size();
  std::vector<std::size_t> order(count);
  if (count == 0) return order;
  const geom::Point about = section.horizons.front().line.points.front();
  const auto areas =
      base::parallel_map<double>(count, [&](std::size_t i) { return swept(section.horizons[i].line, about); });
  std::vector<std::size_t> over(count, 0);  // how many horizons lie over each
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const auto& a = section.horizons[i].line.points;
      const auto& b = section.horizons[j].line.points;
      // Along the one, back along the other: clockwise if the first is the upper one.
      const double ring = areas[i] - areas[j] + geom::cross(a.back() - about, b.back() - about) +
                          geom::cross(b.front() - about, a.front() - about);
      ++over[ring > 0.0 ? i : j];
    }
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return over[i] < over[j]; });
  return order;
}

base::Result<SectionFaces> faces_of(const Section& section) {
  DOBRA_TRY(UnitFaces made, unit_faces_of(section));
  return std::move(made.found);
}

base::Result<UnitFaces> unit_faces_of(const Section& as_given) {
  Section section = as_given;
  rejoin_ends(section, near_ends * box_of(section).diagonal());
  const std::vector<std::size_t> order = stack_order(section);
  Numbered numbered = lines_of(section);
  const auto& surfaces = numbered.surfaces;
  const std::size_t first_surface = numbered.first_surface;
  UnitFaces all{{}, std::move(numbered.names), {}, {}};
  DOBRA_TRY(all.arrangement, Arrangement::make(std::move(numbered.lines)));
  Arrangement& arrangement = all.arrangement;
  SectionFaces& made = all.found;
  if (!section.border) {
    Sides sides = sides_of(section, order, surfaces, first_surface, arrangement);
    all.lines.resize(all.lines.size() + sides.lines.size(), "side");
    for (const geom::Polyline& side : sides.lines) made.sides.push_back(side.segment(0));
    DOBRA_TRY_VOID(arrangement.add(std::move(sides.lines)));
    if (!order.empty()) made.open = open_places(section, arrangement, sides.loose, order.back());
  }
  const Subdivision& sub = arrangement.subdivision();
  made.bare = bare_stretches(section, arrangement);
  DOBRA_TRY(made.meetings, meetings_in(section, arrangement));
  std::set<FaceId> air;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const HalfEdgeId h : arrangement.path(static_cast<std::uint32_t>(first_surface + i))) air.insert(sub.face(h));
  }
  std::vector<FaceId> faces;
  std::vector<std::vector<std::uint32_t>> within;
  if (section.border) {
    DOBRA_TRY(within, arrangement.holders(static_cast<std::uint32_t>(first_surface + surfaces.size()), {border_label}));
  }
  made.area = section.border ? geom::signed_area(*section.border) : -arrangement.area(Structure::unbounded());
  for (const FaceId f : sub.faces()) {
    if (f == Structure::unbounded() || (section.border && within[f.index()].empty())) continue;
    if (air.count(f) > 0) {
      made.area -= arrangement.area(f);
    } else {
      faces.push_back(f);
    }
  }
  const Units units(section, arrangement, order, {section.horizons.size(), first_surface});
  std::vector<Units::Group> groups = units.groups(faces);
  made.units = units.of(groups);
  for (Units::Group& group : groups) all.faces.push_back(std::move(group.second));
  DOBRA_TRY(made.misfits, misfits_of(section));
  return all;
}

std::string words_of(const Misfit& misfit) {
  if (misfit.upright) {
    return fmt::format(
        "{} of {:.4g} m2, {:.4g} m high and open at the top or the bottom of the drawing, between the units {}",
        misfit.what, misfit.area, misfit.open_over, misfit.between);
  }
  if (misfit.open_over > 0.0) {
    return fmt::format("{} of {:.4g} m2, {:.4g} m wide and open at the side of the drawing, between the units {}",
                       misfit.what, misfit.area, misfit.open_over, misfit.between);
  }
  return fmt::format("{} of {:.4g} m2 between the units {}", misfit.what, misfit.area, misfit.between);
}

std::vector<std::string> remarks_of(const SectionFaces& faces, const Section& section) {
  std::vector<std::string> remarks;
  for (const HorizonMeeting& pair : faces.meetings) {
    const LineMeeting& meeting = pair.meeting;
    const std::size_t places = meeting.crossings > 0 ? meeting.crossings : meeting.touches;
    const std::string& first = find_horizon(section, pair.first)->name;
    const std::string& second = find_horizon(section, pair.second)->name;
    const char* const how = meeting.crossings > 0 ? "cross" : "meet";
    remarks.push_back(places == 1
                          ? fmt::format("horizons '{}' and '{}' {} at one place, {}", first, second, how, meeting.place)
                          : fmt::format("horizons '{}' and '{}' {} at {} places, the first at {}", first, second, how,
                                        places, meeting.place));
  }
  for (const OpenPlace& open : faces.open) {
    remarks.push_back(
        fmt::format("nothing closes the section at its side under the end of horizon '{}' at {}: what lies there is in "
                    "no unit of the ledger; give a border",
                    find_horizon(section, open.under)->name, open.place));
  }
  return remarks;
}

std::vector<MisfitRemark> misfit_remarks(const SectionFaces& faces) {
  std::vector<MisfitRemark> remarks;
  for (const char* what : {"gap", "overlap"}) {
    const Misfit* greatest = nullptr;
    std::size_t count = 0;
    double area = 0.0;
    for (const Misfit& misfit : faces.misfits) {
      if (misfit.what != what) continue;
      ++count;
      area += misfit.area;
      if (greatest == nullptr || misfit.area > greatest->area) greatest = &misfit;
    }
    if (count == 0) continue;
    const std::string all =
        count == 1 ? "" : fmt::format("{} {}s of {:.4g} m2 in all; the greatest: ", count, what, area);
    remarks.push_back({fmt::format("{}{} at {}", all, words_of(*greatest), greatest->place), greatest->place});
  }
  return remarks;
}

}  // namespace recon::section
