#include "recon/block/unit_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "recon/input/unit_owners.h"
#include "recon/section/face_contours.h"
#include "recon/section/file_rounding.h"
#include "recon/section/rejoin.h"
#include "recon/section/section_faces.h"
#include "shared/geom/contour.h"
#include "shared/geom/place.h"

// 1. The faces of the subdivision are given to units: by their horizons, or by the polygons that hold them. 2. Every
// edge is called after the line that runs along it; of several, by what decides most about a side: a fault, a horizon,
// the topography, the border. 3. A unit's faces that hang together over edges are a part; its contours are split where
// they come to a vertex twice.

namespace recon::block {

int rank_of(const std::string& name) {
  int rank = 0;
  for (const char* kind : {"fault ", "horizon ", "topography ", "border"}) {
    if (name.starts_with(kind)) return rank;
    ++rank;
  }
  return rank;
}

namespace {

using topo::FaceId;
using topo::HalfEdgeId;
using topo::Structure;
using topo::Subdivision;

void name_edges(const std::vector<std::string>& lines, UnitMap& map) {
  const Subdivision& sub = map.arrangement.subdivision();
  for (const topo::EdgeId e : sub.edges()) {
    if (map.edge_names.size() <= e.index()) map.edge_names.resize(e.index() + 1);
    std::string& name = map.edge_names[e.index()];
    for (const std::uint32_t line : map.arrangement.lines_on(e)) {
      const std::string& other = lines[line];
      if (!other.empty() && (name.empty() || rank_of(other) < rank_of(name))) name = other;
    }
  }
}

void spread_units(UnitMap& map) {
  std::size_t highest = 0;
  for (const FaceId f : map.arrangement.subdivision().faces()) highest = std::max(highest, f.index());
  map.unit_of.assign(highest + 1, UnitMap::nobody);
  for (std::size_t unit = 0; unit < map.faces.size(); ++unit) {
    for (const FaceId f : map.faces[unit]) map.unit_of[f.index()] = unit;
  }
}

/// "A - B" of pieces "A (1)" and "B (2)".
std::string whole_unit_name(const section::Section& section, const section::RockUnit& unit) {
  const auto whole = [&](std::size_t horizon) { return whole_name(section.horizons[horizon]); };
  return unit.top && unit.base ? fmt::format("{} - {}", whole(*unit.top), whole(*unit.base))
         : unit.top            ? whole(*unit.top)
         : unit.base           ? "above " + whole(*unit.base)
                               : unit.name;
}

/// Ends of horizons that rounding or drawing left beside their fault: short of it the units above and below run
/// together.
void tell_rounded_ends(const section::Section& section, UnitMap& map) {
  const Subdivision& sub = map.arrangement.subdivision();
  std::map<std::pair<double, double>, topo::VertexId> loose;
  for (const topo::VertexId v : sub.vertices()) {
    if (sub.degree(v) == 1) loose[{sub.point(v).x, sub.point(v).y}] = v;
  }
  const double near = rounding_of_files(section);
  constexpr double beside = 0.01;  // of the section: what is farther off was drawn so
  const double far = beside * box_of(section).diagonal();
  for (const section::Horizon& horizon : section.horizons) {
    for (const section::LineEnd end : {section::LineEnd::First, section::LineEnd::Last}) {
      const geom::Point p = end == section::LineEnd::First ? horizon.line.points.front() : horizon.line.points.back();
      const auto at = loose.find({p.x, p.y});
      if (at == loose.end()) continue;
      const topo::VertexId next = sub.target(sub.round(at->second).front());
      if (sub.degree(next) > 2 && geom::distance(sub.point(next), p) <= near) continue;  // it goes on past the fault
      if (const auto overshoot = overshoot_of(section, horizon, end, far)) {
        map.findings.push_back({"overshoot", words_of(*overshoot), geom::place_at(p)});
        continue;
      }
      const section::SectionLine* nearest = nullptr;
      double gap = far;
      for (const section::SectionLine& line : section.lines) {
        const double distance = geom::distance(line.line, p);
        if (line.kind == section::LineKind::Fault && distance <= gap) nearest = &line, gap = distance;
      }
      if (nearest == nullptr || is_outermost(section, horizon, end)) continue;
      map.findings.push_back(
          {"open_end",
           fmt::format("horizon '{}' ends {:.4g} m beside fault '{}', so that the units above and below it run "
                       "together there and may be open; snap_to_faults of {:g} m (--snap) moves its end onto the fault",
                       horizon.name, gap, nearest->name, section::tolerance_above(gap)),
           geom::place_at(p)});
    }
  }
}

/// Sides that the program draws between ends of horizons that are not above each other.
void tell_slanted_sides(const std::vector<geom::Segment>& sides, double width, UnitMap& map) {
  constexpr double upright = 0.1;  // of the width of the section: ends of drawings are ragged
  for (const geom::Segment& side : sides) {
    const double apart = std::abs(side.to.x - side.from.x);
    if (apart <= upright * width) continue;
    map.findings.push_back({"slanted_side",
                            fmt::format("the side of the section is drawn aslant from ({:.6g}, {:.6g}) to ({:.6g}, "
                                        "{:.6g}), as horizons end {:.6g} m apart there: units end at that line; give a "
                                        "border, or draw the horizons to one end",
                                        side.from.x, side.from.y, side.to.x, side.to.y, apart),
                            geom::place_at(geom::midpoint(side.from, side.to))});
  }
}

base::Result<UnitMap> by_horizons(const section::Section& section) {
  DOBRA_TRY(section::UnitFaces faces, unit_faces_of(section));
  UnitMap map;
  map.arrangement = std::move(faces.arrangement);
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < faces.faces.size(); ++i) {
    std::string name = whole_unit_name(section, faces.found.units[i]);
    const auto [at, is_new] = numbers.try_emplace(name, map.units.size());
    if (is_new) {
      map.units.push_back(std::move(name));
      map.faces.emplace_back();
    }
    std::vector<FaceId>& all = map.faces[at->second];
    all.insert(all.end(), faces.faces[i].begin(), faces.faces[i].end());
  }
  for (const section::OpenPlace& open : faces.found.open) {
    map.findings.push_back({"open_side",
                            fmt::format("nothing closes the section at its side under the end of horizon '{}': what "
                                        "lies there is in no unit of the block; give a border",
                                        find_horizon(section, open.under)->name),
                            geom::place_at(open.place)});
  }
  tell_slanted_sides(faces.found.sides, box_of(section).width(), map);
  tell_rounded_ends(section, map);
  name_edges(faces.lines, map);
  spread_units(map);
  return map;
}

/// Edges of polygons along which nothing else runs are called after the horizon that has the same two points one after
/// the other, such as those that were made of the polygons.
class HorizonSegments {
 public:
  explicit HorizonSegments(const section::Section& section) {
    for (const section::Horizon& horizon : section.horizons) {
      for (std::size_t i = 0; i + 1 < horizon.line.points.size(); ++i)
        names_.try_emplace(key(horizon.line.points[i], horizon.line.points[i + 1]), &horizon.name);
    }
  }
  [[nodiscard]] const std::string* find(geom::Point a, geom::Point b) const {
    const auto at = names_.find(key(a, b));
    return at == names_.end() ? nullptr : at->second;
  }

 private:
  using Key = std::array<double, 4>;
  static Key key(geom::Point a, geom::Point b) {
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    return {a.x, a.y, b.x, b.y};
  }
  std::map<Key, const std::string*> names_;
};

base::Result<UnitMap> by_polygons(const section::Section& section) {
  DOBRA_TRY(const input::UnitOwners owners, input::UnitOwners::make(section, 0.0));
  UnitMap map;
  map.arrangement = owners.arrangement();
  map.units = owners.names();
  map.faces.resize(map.units.size());
  const Subdivision& sub = map.arrangement.subdivision();
  for (const FaceId f : sub.faces()) {
    if (f == Structure::unbounded()) continue;
    if (const std::size_t unit = owners.unit(f); unit != input::UnitOwners::nobody) map.faces[unit].push_back(f);
  }
  std::vector<std::string> lines(section.units.size());
  for (const section::SectionLine& line : section.lines) {
    const bool fault = line.kind == section::LineKind::Fault;
    if (fault || line.kind == section::LineKind::Topography)
      lines.push_back((fault ? "fault " : "topography ") + line.name);
  }
  name_edges(lines, map);
  spread_units(map);
  const HorizonSegments horizons(section);
  for (const topo::EdgeId e : sub.edges()) {
    const HalfEdgeId h = Structure::half_edge(e);
    std::string& name = map.edge_names[e.index()];
    if (!name.empty()) continue;
    std::vector<geom::Point> course;
    map.arrangement.append(h, course);
    course.push_back(sub.point(sub.target(h)));
    const std::string* const horizon = horizons.find(course[0], course[1]);
    const bool outer = map.unit_of[sub.face(h).index()] == UnitMap::nobody ||
                       map.unit_of[sub.face(Structure::twin(h)).index()] == UnitMap::nobody;
    name = horizon != nullptr ? "horizon " + *horizon : outer ? "side" : "contact";
  }
  for (const std::string& remark : owners.remarks()) map.findings.push_back({"polygons", remark, {}});
  if (section.faces) {
    for (const section::Misfit& misfit : section.faces->misfits) {
      map.findings.push_back(
          {misfit.what,
           fmt::format("{}: {}", words_of(misfit),
                       misfit.what != "gap" ? "the block has the one that is drawn upon the other"
                       : misfit.upright ? "no unit of the block is there; draw a unit there, or draw these up to each "
                                          "other; where it is air, a topography says so"
                                        : "no unit of the block is there; draw a unit there, or draw these up to each "
                                          "other"),
           geom::place_at(misfit.place)});
    }
  }
  return map;
}

/// Splits a loop where it comes to a vertex again.
void split(const Subdivision& sub, const std::vector<HalfEdgeId>& loop, PartLoops& loops) {
  std::vector<HalfEdgeId> open;
  std::map<topo::VertexId, std::size_t> at;  // where the half-edge that leaves a vertex stands in `open`
  for (const HalfEdgeId h : loop) {
    at[sub.origin(h)] = open.size();
    open.push_back(h);
    const auto again = at.find(sub.target(h));
    if (again == at.end()) continue;
    const auto first = open.begin() + static_cast<std::ptrdiff_t>(again->second);
    loops.emplace_back(first, open.end());
    for (auto i = first; i != open.end(); ++i) at.erase(sub.origin(*i));
    open.erase(first, open.end());
  }
}

template <class Within>
std::vector<PartLoops> parts_within(const UnitMap& map, const std::vector<FaceId>& faces, Within&& within) {
  const Subdivision& sub = map.arrangement.subdivision();
  std::map<FaceId, std::size_t> part_of;
  std::size_t count = 0;
  for (const FaceId seed : faces) {
    if (part_of.contains(seed)) continue;
    std::vector<FaceId> open{seed};
    part_of[seed] = count;
    while (!open.empty()) {
      const FaceId f = open.back();
      open.pop_back();
      for (const topo::LoopId loop : sub.loops(f)) {
        for (const HalfEdgeId h : sub.half_edges(loop)) {
          const FaceId beyond = sub.face(Structure::twin(h));
          if (within(beyond) && part_of.try_emplace(beyond, count).second) open.push_back(beyond);
        }
      }
    }
    ++count;
  }
  std::vector<PartLoops> parts(count);
  for (const auto& loop : loops_round(map.arrangement, faces, within))
    split(sub, loop, parts[part_of.at(sub.face(loop.front()))]);
  for (PartLoops& part : parts) {
    const auto outer = std::find_if(part.begin(), part.end(), [&](const std::vector<HalfEdgeId>& loop) {
      geom::Polyline contour{{}, true};
      for (const HalfEdgeId h : loop) map.arrangement.append(h, contour.points);
      return geom::signed_area(contour) > 0.0;
    });
    if (outer != part.end()) std::iter_swap(part.begin(), outer);
  }
  return parts;
}

}  // namespace

bool is_told(const base::Place& place, const std::vector<base::Finding>& findings) {
  return place.x && place.y && std::any_of(findings.begin(), findings.end(), [&](const base::Finding& finding) {
           const bool alike = finding.code == "open_end" || finding.code == "overshoot" || finding.code == "gap" ||
                              finding.code == "overlap";
           return alike && finding.place.x == place.x && finding.place.y == place.y;
         });
}

base::Result<UnitMap> unit_map(const section::Section& section) {
  DOBRA_TRY(UnitMap map, section.units.empty() ? by_horizons(section) : by_polygons(section));
  const bool any = std::any_of(map.faces.begin(), map.faces.end(), [](const auto& faces) { return !faces.empty(); });
  if (any) return map;
  return base::Error{base::ErrorCode::BadSection,
                     "nothing bounds a unit: draw a second horizon or a border, or give the units as polygons",
                     base::Place{.item = "section"}};
}

std::vector<PartLoops> parts_of(const UnitMap& map, std::size_t unit) {
  return parts_within(map, map.faces[unit], [&](FaceId f) { return map.unit_of[f.index()] == unit; });
}

std::vector<PartLoops> parts_of_all(const UnitMap& map) {
  std::vector<FaceId> all;
  for (const auto& faces : map.faces) all.insert(all.end(), faces.begin(), faces.end());
  return parts_within(map, all, [&](FaceId f) { return map.unit_of[f.index()] != UnitMap::nobody; });
}

}  // namespace recon::block
