#include "quebra/core/sketch_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "quebra/core/geo_sketch.h"
#include "quebra/core/svg_sketch.h"
#include "shared/base/text.h"
#include "shared/io/curves.h"
#include "shared/io/file.h"
#include "shared/io/mesh_file.h"
#include "shared/io/poly.h"
#include "shared/topo/insert.h"

namespace quebra::core {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Polyline;

/// The segments of a file joined into chains wherever just two with the same marker meet.
class Chains {
 public:
  explicit Chains(const dobra::io::PolyFile& file) : file_(file), used_(file.segments.size(), false) {
    for (std::size_t i = 0; i < file.segments.size(); ++i) {
      for (const std::uint32_t node : file.segments[i]) at_[node].push_back(i);
    }
  }

  /// Of each curve that curves() returned.
  [[nodiscard]] const std::vector<std::int64_t>& markers() const { return markers_; }

  std::vector<Curve> curves() {
    std::vector<Curve> result;
    // Chains with ends first, so that what is left over is closed.
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      for (const std::uint32_t node : file_.segments[i]) {
        if (!used_[i] && !goes_on(node, i)) result.push_back(follow(i, node, result.size()));
      }
    }
    for (std::size_t i = 0; i < file_.segments.size(); ++i) {
      if (!used_[i]) result.push_back(follow(i, file_.segments[i][0], result.size()));
    }
    return result;
  }

 private:
  [[nodiscard]] std::int64_t marker(std::size_t segment) const {
    return file_.segment_markers.empty() ? 0 : file_.segment_markers[segment];
  }

  /// The other segment of the chain at `node`, if the chain goes on there.
  [[nodiscard]] std::optional<std::size_t> goes_on(std::uint32_t node, std::size_t segment) const {
    const auto& meeting = at_.at(node);
    if (meeting.size() != 2) return std::nullopt;
    const std::size_t other = meeting[0] == segment ? meeting[1] : meeting[0];
    if (marker(other) != marker(segment)) return std::nullopt;
    return other;
  }

  Curve follow(std::size_t segment, std::uint32_t node, std::size_t number) {
    Polyline line;
    const std::uint32_t first = node;
    line.points.push_back(file_.nodes.points[node]);
    for (std::optional<std::size_t> next = segment; next && !used_[*next];) {
      segment = *next;
      used_[segment] = true;
      const auto& nodes = file_.segments[segment];
      node = nodes[0] == node ? nodes[1] : nodes[0];
      line.points.push_back(file_.nodes.points[node]);
      next = goes_on(node, segment);
    }
    if (node == first) {
      line.closed = true;
      line.points.pop_back();
    }
    markers_.push_back(marker(segment));
    return {fmt::format("curve_{}_marker_{}", number + 1, marker(segment)), Role::Boundary, std::move(line), {}};
  }

  const dobra::io::PolyFile& file_;
  std::vector<std::int64_t> markers_;
  std::vector<bool> used_;
  std::map<std::uint32_t, std::vector<std::size_t>> at_;
};

/// Number of the innermost contour that holds p; nothing if none does.
std::optional<std::size_t> innermost(const Domain& domain, const std::vector<Polyline>& contours, Point p) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (found && domain.loops[*found].depth > domain.loops[i].depth) continue;
    if (locate(contours[i], p) == dobra::geom::Side::Inside) found = i;
  }
  return found;
}

/// In a .poly file a loop inside a loop is a hole only where a hole point says so; else it divides material from material.
Result<void> apply_holes(std::vector<Curve>& curves, const dobra::io::PolyFile& file, const Place& place) {
  DOBRA_TRY(const Domain domain, make_domain({curves, std::vector<Place>(curves.size(), place), {}, {}, {}}));
  std::vector<Polyline> contours;
  for (const auto& loop : domain.loops) contours.push_back(contour(domain, loop));
  std::vector<bool> is_void(domain.loops.size(), false);
  for (const Point hole : file.holes) {
    const auto loop = innermost(domain, contours, hole);
    if (!loop) {
      Place at = place;
      at.x = hole.x;
      at.y = hole.y;
      return Error{ErrorCode::OutsideDomain, "a hole point lies outside every loop; move it inside or remove it", at};
    }
    is_void[*loop] = true;
  }
  for (std::size_t i = 0; i < domain.loops.size(); ++i) {
    bool surrounded_by_void = true;
    int depth = -1;
    for (std::size_t j = 0; j < domain.loops.size(); ++j) {
      if (j == i || domain.loops[j].depth >= domain.loops[i].depth || domain.loops[j].depth < depth) continue;
      if (locate(contours[j], contours[i].points.front()) != dobra::geom::Side::Inside) continue;
      depth = domain.loops[j].depth;
      surrounded_by_void = is_void[j];
    }
    if (surrounded_by_void != is_void[i]) continue;
    for (const auto& side : domain.loops[i].sides) curves[side.curve].role = Role::Internal;
  }
  return {};
}

Result<Sketch> from_poly(const std::string& path) {
  DOBRA_TRY(const dobra::io::PolyFile file, dobra::io::read_poly(path));
  Sketch sketch;
  sketch.curves = Chains(file).curves();
  Place place;
  place.file = path;
  if (!sketch.curves.empty()) DOBRA_TRY_VOID(apply_holes(sketch.curves, file, place));
  for (const auto& region : file.regions) sketch.regions.push_back({fmt::format("region_{}", dobra::base::number_text(region.attribute)), region.at});
  return sketch;
}

// --- curves without roles -----------------------------------------------------------------------------------------------

/// Open curves whose ends all meet one other curve bound the domain; chains with a free end do not.
void find_roles(std::vector<Curve>& curves) {
  std::map<Point, std::vector<std::size_t>> at;
  const auto ends = [&](std::size_t i) {
    const auto& points = std::get<Polyline>(curves[i].shape).points;
    return std::array{points.front(), points.back()};
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (closed(curves[i])) continue;
    for (const Point end : ends(i)) at[end].push_back(i);
  }
  std::vector<std::size_t> loose;
  const auto drop = [&](std::size_t i) {
    curves[i].role = Role::Internal;
    for (const Point end : ends(i)) {
      auto& meeting = at[end];
      meeting.erase(std::find(meeting.begin(), meeting.end(), i));
      if (meeting.size() == 1) loose.push_back(meeting.front());
    }
  };
  for (const auto& [end, meeting] : at) {
    if (meeting.size() == 1) loose.push_back(meeting.front());
  }
  while (!loose.empty()) {
    const std::size_t i = loose.back();
    loose.pop_back();
    if (curves[i].role == Role::Boundary) drop(i);
  }
  // Where three or more still meet, what borders on the outside bounds the domain and the rest divides it.
  std::set<std::size_t> branched;
  for (const auto& [end, meeting] : at) {
    if (meeting.size() > 2) branched.insert(meeting.begin(), meeting.end());
  }
  if (branched.empty()) return;
  dobra::topo::Subdivision subdivision;
  std::map<std::size_t, dobra::topo::HalfEdgeId> half;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].role != Role::Boundary) continue;
    const auto inserted = insert(subdivision, std::get<Polyline>(curves[i].shape));
    if (inserted && !inserted->path.empty()) half[i] = inserted->path.front();
  }
  for (const auto& [i, h] : half) {
    if (closed(curves[i]) || !subdivision.contains(dobra::topo::Subdivision::edge(h))) continue;
    const auto outside = dobra::topo::Subdivision::unbounded();
    const bool chain_of_loop = !branched.contains(i) && subdivision.face(h) != subdivision.face(dobra::topo::Subdivision::twin(h));
    const bool rim = subdivision.face(h) == outside || subdivision.face(dobra::topo::Subdivision::twin(h)) == outside;
    if (!rim && !chain_of_loop) curves[i].role = Role::Internal;
  }
}

Result<Sketch> from_curves(const std::string& path) {
  DOBRA_TRY(dobra::io::Curves read, dobra::io::read_curves(path));
  Sketch sketch;
  sketch.remarks = std::move(read.remarks);
  std::map<std::string, int> used;
  for (auto& curve : read.curves) {
    // Names may repeat in a file; sets of the mesh must not.
    const int number = ++used[curve.name];
    if (number > 1) curve.name += fmt::format(" ({})", number);
    sketch.curves.push_back({std::move(curve.name), Role::Boundary, std::move(curve.line), {}});
  }
  find_roles(sketch.curves);
  return sketch;
}

// --- meshes ---------------------------------------------------------------------------------------------------------------

/// The boundary of a mesh, its internal sets and its cracks; regions by a point of one of their elements.
Sketch from_mesh(const dobra::mesh::ElementMesh& mesh) {
  using dobra::mesh::ElementSide;
  Sketch sketch;
  dobra::io::PolyFile file;
  file.nodes.points = mesh.points;
  std::vector<std::string> names{"boundary"};
  std::map<ElementSide, std::int64_t> set_of;
  std::set<std::int64_t> lips;
  for (const auto& [name, sides] : mesh.side_sets) {
    const bool left = name.ends_with("_left") && mesh.side_sets.contains(name.substr(0, name.size() - 5) + "_right");
    const bool right = name.ends_with("_right") && mesh.side_sets.contains(name.substr(0, name.size() - 6) + "_left");
    const auto number = static_cast<std::int64_t>(names.size());
    for (const ElementSide& side : sides) set_of.emplace(side, right ? -1 : number);
    if (left) lips.insert(number);
    names.push_back(left ? name.substr(0, name.size() - 5) : name);
  }
  const auto outer = dobra::mesh::boundary_sides(mesh);
  std::set<std::int64_t> internal;
  const auto add = [&](const ElementSide& side, std::int64_t set) {
    const auto nodes = side_nodes(mesh, side);
    file.segments.push_back({static_cast<std::uint32_t>(nodes[0].index()), static_cast<std::uint32_t>(nodes[1].index())});
    file.segment_markers.push_back(set);
  };
  for (const ElementSide& side : outer) {
    const auto set = set_of.find(side);
    const std::int64_t number = set == set_of.end() ? 0 : set->second;
    if (number >= 0) add(side, number);
  }
  for (const auto& [side, number] : set_of) {
    if (std::binary_search(outer.begin(), outer.end(), side)) continue;
    internal.insert(number);
    add(side, number);
  }
  std::map<std::int64_t, int> used;
  std::size_t at = 0;
  Chains chains(file);
  for (Curve& curve : chains.curves()) {
    const std::int64_t set = chains.markers()[at++];
    curve.role = lips.contains(set) ? Role::Crack : internal.contains(set) ? Role::Internal : Role::Boundary;
    const int number = ++used[set];
    curve.name = names[static_cast<std::size_t>(set)] + (number == 1 ? "" : fmt::format("_{}", number));
    sketch.curves.push_back(std::move(curve));
  }
  for (const auto& [tag, name] : mesh.region_names) {
    const auto element = std::find(mesh.regions.begin(), mesh.regions.end(), tag);
    if (element == mesh.regions.end()) continue;
    const auto nodes = mesh.nodes_of(dobra::mesh::ElementId(static_cast<std::size_t>(element - mesh.regions.begin())));
    const Point a = mesh.point(nodes[0]), b = mesh.point(nodes[1]), c = mesh.point(nodes[2]);
    sketch.regions.push_back({name, {(a.x + b.x + c.x) / 3.0, (a.y + b.y + c.y) / 3.0}});
  }
  return sketch;
}

Result<Sketch> read_by_ending(const std::string& path) {
  const std::string ending = dobra::io::ending_of(path);
  if (ending == ".poly") return from_poly(path);
  if (ending == ".geo") return read_geo_sketch(path);
  if (ending == ".svg") return read_svg_sketch(path);
  if (!dobra::io::is_mesh_ending(ending)) return from_curves(path);
  DOBRA_TRY(auto contents, dobra::io::read_mesh(path));
  Sketch sketch = from_mesh(contents.mesh);
  sketch.remarks = std::move(contents.remarks);
  return sketch;
}

}  // namespace

Result<Sketch> read_sketch(const std::string& path) {
  DOBRA_TRY(Sketch sketch, read_by_ending(path));
  Place place;
  place.file = path;
  if (sketch.places.empty()) sketch.places.assign(sketch.curves.size(), place);
  return sketch;
}

}  // namespace quebra::core
