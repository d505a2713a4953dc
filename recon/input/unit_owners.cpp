#include "recon/input/unit_owners.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "recon/section/section_faces.h"
#include "shared/geom/place.h"
#include "shared/geom/spatial_index.h"
#include "shared/scene/unit_colors.h"

namespace recon::input {

using topo::EdgeId;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Structure;
using topo::Subdivision;

namespace {

/// A straight line from one ring to another.
struct Bridge {
  geom::Polyline line;
  std::size_t from = 0;
  std::size_t to = 0;
};

/// From vertices that lie near another ring straight to it, so that open gaps fall into thin faces.
std::vector<Bridge> bridges(const std::vector<geom::Polyline>& rings, double tolerance) {
  std::vector<geom::Segment> segments;
  std::vector<std::size_t> ring_of;
  std::vector<geom::Box> boxes;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t k = 0; k < rings[i].segment_count(); ++k) {
      segments.push_back(rings[i].segment(k));
      ring_of.push_back(i);
      boxes.push_back(segments.back().box());
    }
  }
  const geom::SpatialIndex index(boxes);
  std::vector<Bridge> made;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (const geom::Point p : rings[i].points) {
      std::map<std::size_t, std::pair<double, std::size_t>> nearest;  // of each other ring
      index.for_each_overlapping(geom::Box{p, p}.grown(tolerance), [&](std::size_t s) {
        const double d = geom::distance(segments[s], p);
        if (ring_of[s] == i || d > tolerance) return;
        const auto [known, is_new] = nearest.try_emplace(ring_of[s], d, s);
        if (!is_new && std::pair(d, s) < known->second) known->second = {d, s};
      });
      for (const auto& [ring, at] : nearest) {
        const geom::Segment& s = segments[at.second];
        const double part = geom::nearest_fraction(s, p);
        geom::Point to = part <= 0.0 ? s.from : part >= 1.0 ? s.to : geom::interpolate(s.from, s.to, part);
        if (to == p) continue;
        if (part > 0.0 && part < 1.0) to = to + 1e-6 * (to - p);  // across the edge, whatever is rounded
        if (to != p) made.push_back({{{p, to}, false}, i, ring});
      }
    }
  }
  return made;
}

}  // namespace

base::Result<UnitOwners> UnitOwners::make(const section::Section& section, double tolerance) {
  UnitOwners made;
  made.tolerance_ = tolerance;
  DOBRA_TRY_VOID(made.draw(section));
  DOBRA_TRY_VOID(made.find_holders(section));
  made.give_faces();
  made.tell_covered(section);
  made.unite_pieces(section);
  return made;
}

base::Result<void> UnitOwners::draw(const section::Section& section) {
  std::vector<geom::Polyline> rings;
  for (const section::Unit& unit : section.units) {
    rings.push_back(unit.contour);
    areas_.push_back(geom::signed_area(unit.contour));
  }
  polygons_ = rings.size();
  for (const section::SectionLine& line : section.lines) {
    if (line.kind == section::LineKind::Fault || line.kind == section::LineKind::Topography)
      barriers_.push_back(line.line);
  }
  std::vector<geom::Polyline> lines = rings;
  lines.insert(lines.end(), barriers_.begin(), barriers_.end());
  for (Bridge& bridge : bridges(rings, tolerance_)) {
    lines.push_back(std::move(bridge.line));
    bridged_.emplace_back(bridge.from, bridge.to);
  }
  DOBRA_TRY(arrangement_, section::Arrangement::make(std::move(lines)));
  return {};
}

base::Result<void> UnitOwners::find_holders(const section::Section& section) {
  DOBRA_TRY(holders_, arrangement_.holders(0, unit_labels(section)));
  owner_.assign(holders_.size(), nobody);
  common_.assign(polygons_, std::vector<double>(polygons_, 0.0));
  for (const FaceId f : arrangement_.subdivision().faces()) {
    const std::vector<std::uint32_t>& holders = holders_[f.index()];
    if (holders.size() < 2) continue;
    const double area = arrangement_.area(f);
    for (const std::uint32_t i : holders) {
      for (const std::uint32_t j : holders) common_[i][j] += area;
    }
  }
  return {};
}

/// A polygon that lies within another is drawn upon it. Others that overlap are untidy edges: the later one counts.
std::size_t UnitOwners::innermost(const std::vector<std::uint32_t>& holders) const {
  std::size_t best = nobody;
  for (const std::uint32_t i : holders) {
    const bool inside = std::any_of(holders.begin(), holders.end(), [&](std::uint32_t j) {
      return i != j && areas_[i] < areas_[j] && common_[i][j] > 0.5 * areas_[i];
    });
    if (inside && (best == nobody || areas_[i] < areas_[best])) best = i;
  }
  return best == nobody ? holders.back() : best;
}

/// About how thick a face is, m: 2 area / perimeter.
double UnitOwners::width(FaceId face) const {
  const Subdivision& sub = arrangement_.subdivision();
  double perimeter = 0.0;
  for (const topo::LoopId loop : sub.loops(face)) {
    for (const HalfEdgeId h : sub.half_edges(loop)) perimeter += geom::length(geom::Polyline{course(h), false});
  }
  return 2.0 * arrangement_.area(face) / perimeter;
}

void UnitOwners::give_faces() {
  std::vector<FaceId> gaps;
  for (const FaceId f : arrangement_.subdivision().faces()) {
    if (f == Structure::unbounded()) continue;
    const std::vector<std::uint32_t>& holders = holders_[f.index()];
    if (holders.empty() && width(f) <= tolerance_) gaps.push_back(f);
    if (!holders.empty()) owner_[f.index()] = holders.size() == 1 ? holders.front() : innermost(holders);
  }
  give_gaps(gaps);
}

/// The first polygon beside a gap. One with a single polygon beside it is the end of a gap between those that the
/// bridges round it join.
std::size_t UnitOwners::first_beside(FaceId gap) const {
  const Subdivision& sub = arrangement_.subdivision();
  std::set<std::size_t> beside;
  std::set<std::size_t> joined;
  for (const topo::LoopId loop : sub.loops(gap)) {
    for (const HalfEdgeId h : sub.half_edges(loop)) {
      const std::size_t owner = owner_[sub.face(Structure::twin(h)).index()];
      if (owner != nobody) beside.insert(owner);
      for (const std::uint32_t line : arrangement_.lines_on(Structure::edge(h))) {
        if (line < polygons_ + barriers_.size()) continue;
        const auto [from, to] = bridged_[line - polygons_ - barriers_.size()];
        joined.insert({from, to});
      }
    }
  }
  if (beside.size() < 2) beside.insert(joined.begin(), joined.end());
  return beside.empty() ? nobody : *beside.begin();
}

/// To the first polygon beside it: the edge of the later one is the one that counts, as where they overlap.
void UnitOwners::give_gaps(const std::vector<FaceId>& gaps) {
  const Subdivision& sub = arrangement_.subdivision();
  std::vector<std::size_t> given(gaps.size(), nobody);
  double area = 0.0;
  geom::Point place;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    given[i] = first_beside(gaps[i]);
    if (area == 0.0) place = sub.point(sub.origin(sub.first(sub.outer_loop(gaps[i]))));
    area += arrangement_.area(gaps[i]);
  }
  for (std::size_t i = 0; i < gaps.size(); ++i) owner_[gaps[i].index()] = given[i];
  if (gaps.empty()) return;
  remarks_.push_back(
      fmt::format("gaps thinner than {:.4g} m between units ({:.4g} m2 in all, the first at {}) are bridged for the "
                  "horizons; share_edges closes them",
                  tolerance_, area, place));
}

/// Units all of whose faces belong to others.
void UnitOwners::tell_covered(const section::Section& section) {
  const std::set<std::size_t> seen(owner_.begin(), owner_.end());
  for (std::uint32_t i = 0; i < polygons_; ++i) {
    if (seen.contains(i)) continue;
    std::set<std::size_t> over;
    for (std::size_t f = 0; f < holders_.size(); ++f) {
      if (std::binary_search(holders_[f].begin(), holders_[f].end(), i)) over.insert(owner_[f]);
    }
    std::vector<std::string> names;
    for (const std::size_t j : over) names.push_back('\'' + section.units[j].name + '\'');
    const geom::Point at = section.units[i].contour.points.front();
    remarks_.push_back(fmt::format("unit '{}' at {} lies wholly under {} and gets no horizon", section.units[i].name,
                                   at, fmt::join(names, ", ")));
  }
}

/// Polygons of one name, of one piece_of, and "K2p_1", "K2p_2" where no two of them have an edge in common.
void UnitOwners::unite_pieces(const section::Section& section) {
  const Subdivision& sub = arrangement_.subdivision();
  std::map<std::pair<std::size_t, std::size_t>, double> shared;
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Structure::half_edge(e);
    const std::size_t a = owner_[sub.face(h).index()];
    const std::size_t b = owner_[sub.face(Structure::twin(h)).index()];
    if (a == b || a == nobody || b == nobody || on_barrier(e) || near_barrier(e)) continue;
    shared[std::minmax(a, b)] += geom::length(geom::Polyline{course(h), false});
  }
  std::vector<std::string> drawn;
  for (const section::Unit& unit : section.units) drawn.push_back(unit.piece_of.empty() ? unit.name : unit.piece_of);
  const std::vector<std::string> wholes = dobra::scene::whole_names(drawn);
  std::map<std::string, std::vector<std::size_t>> by_name;
  for (std::size_t i = 0; i < polygons_; ++i) by_name[wholes[i]].push_back(i);
  std::vector<std::string> name(polygons_);
  for (const auto& named : by_name) {
    const auto& members = named.second;
    const auto touch = std::find_if(shared.begin(), shared.end(), [&](const auto& pair) {
      const auto has = [&](std::size_t i) { return std::find(members.begin(), members.end(), i) != members.end(); };
      return pair.second > 3.0 * tolerance_ && has(pair.first.first) && has(pair.first.second);
    });
    const auto is_said = [&](std::size_t i) { return drawn[i] == drawn[members.front()]; };
    const bool said = std::all_of(members.begin(), members.end(), is_said);
    const bool one = members.size() > 1 && (said || touch == shared.end());
    for (const std::size_t i : members) name[i] = one ? named.first : drawn[i];
    if (members.size() < 2) continue;
    std::vector<std::string> told;
    for (const std::size_t i : members) told.push_back('\'' + section.units[i].name + '\'');
    if (one) remarks_.push_back(fmt::format("{} are taken as pieces of unit '{}'", fmt::join(told, ", "), named.first));
  }
  unit_of_polygon_.resize(polygons_);
  for (std::size_t i = 0; i < polygons_; ++i) {
    const auto known = std::find(names_.begin(), names_.end(), name[i]);
    unit_of_polygon_[i] = static_cast<std::size_t>(known - names_.begin());
    if (known == names_.end()) names_.push_back(name[i]);
  }
}

std::size_t UnitOwners::unit(FaceId face) const {
  const std::size_t polygon = owner_[face.index()];
  return polygon == nobody ? nobody : unit_of_polygon_[polygon];
}

bool UnitOwners::on_barrier(EdgeId edge) const {
  const std::vector<std::uint32_t>& lines = arrangement_.lines_on(edge);
  return std::any_of(lines.begin(), lines.end(),
                     [&](std::uint32_t line) { return line >= polygons_ && line < polygons_ + barriers_.size(); });
}

bool UnitOwners::near_barrier(EdgeId edge) const {
  const std::vector<geom::Point> points = course(Structure::half_edge(edge));
  return std::any_of(barriers_.begin(), barriers_.end(), [&](const geom::Polyline& barrier) {
    const auto is_near = [&](geom::Point p) { return geom::distance(barrier, p) <= tolerance_; };
    if (!barrier.box().grown(tolerance_).contains(points.front())) return false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!is_near(points[i]) || (i > 0 && !is_near(geom::midpoint(points[i - 1], points[i])))) return false;
    }
    return true;
  });
}

std::vector<geom::Point> UnitOwners::course(HalfEdgeId h) const {
  std::vector<geom::Point> points;
  arrangement_.append(h, points);
  const Subdivision& sub = arrangement_.subdivision();
  points.push_back(sub.point(sub.target(h)));
  return points;
}

}  // namespace recon::input
