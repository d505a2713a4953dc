#include "shared/mesh/delaunay/planar_domain.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/text.h"
#include "shared/geom/intersect.h"
#include "shared/mesh/delaunay/insertion_order.h"

// 1. Validate. 2. Insert the points, in a good order. 3. Insert the edges. 4. Flood from infinity: every boundary edge
// passed toggles inside and outside. 5. Flood from seeds: regions and holes.

namespace dobra::mesh::delaunay {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Progress;
using base::Result;
using geom::Point;
using Kernel = DelaunayKernel;

namespace {

Error error_at(ErrorCode code, std::string message, Point at, std::string item = {}) {
  Place place;
  place.item = std::move(item);
  place.x = at.x;
  place.y = at.y;
  return Error{code, std::move(message), place};
}

std::string set_text(const MeshInput& input, const InputEdge& edge) {
  return fmt::format("edge set '{}'", input.sets[edge.set].name);
}

Result<void> validate(const MeshInput& input) {
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    if (!geom::is_finite(input.points[i])) {
      return Error{ErrorCode::NotFinite, fmt::format("point {} of the mesh input is not finite", i)};
    }
  }
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    const InputEdge& edge = input.edges[i];
    const bool good = edge.set < input.sets.size() && edge.nodes[0].valid() && edge.nodes[1].valid() &&
                      edge.nodes[0].index() < input.points.size() && edge.nodes[1].index() < input.points.size();
    if (!good) {
      return Error{ErrorCode::InvalidOption,
                   fmt::format("edge {} refers to a point or an edge set that does not exist", i)};
    }
  }
  for (const auto& [name, nodes] : input.node_sets) {
    for (const NodeId node : nodes) {
      if (node.valid() && node.index() < input.points.size()) continue;
      return Error{ErrorCode::InvalidOption, fmt::format("node set '{}' refers to a point that does not exist", name)};
    }
  }
  return {};
}

/// Starts with the first three points of `order` that are not collinear, then inserts all others.
Result<void> insert_points(const MeshInput& input, PlanarDomain& domain, const Progress& progress) {
  const std::vector<Point>& points = input.points;
  const std::vector<std::uint32_t> order = insertion_order(points);
  domain.vertex_of_point.assign(points.size(), Kernel::none);
  std::size_t second = 1;
  while (second < order.size() && points[order[second]] == points[order[0]]) ++second;
  std::size_t third = second + 1;
  geom::Sign turn = geom::Sign::Zero;
  for (; third < order.size(); ++third) {
    turn = geom::orient2d(points[order[0]], points[order[second]], points[order[third]]);
    if (turn != geom::Sign::Zero) break;
  }
  if (turn == geom::Sign::Zero) {
    return Error{ErrorCode::CannotMesh,
                 "the points lie on one line or are fewer than three: give points that span an area"};
  }
  std::array<std::uint32_t, 3> first{order[0], order[second], order[third]};
  if (turn == geom::Sign::Negative) std::swap(first[1], first[2]);
  Kernel& kernel = domain.kernel;
  kernel.reserve(points.size(), 2 * points.size() + 2);
  kernel.start(points[first[0]], points[first[1]], points[first[2]]);
  for (std::uint32_t i = 0; i < 3; ++i) domain.vertex_of_point[first[i]] = i;
  Kernel::Cell near = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k % 4096 == 0) {
      DOBRA_TRY_VOID(progress.check());
      progress.report(static_cast<double>(k) / static_cast<double>(order.size()), "inserting points");
    }
    const std::uint32_t i = order[k];
    if (domain.vertex_of_point[i] != Kernel::none) continue;
    const Kernel::Location at = kernel.locate(points[i], near, Kernel::Walls::Ignore);
    const Kernel::Vertex vertex =
        at.where == Kernel::Where::OnVertex ? kernel.origin(at.half) : kernel.insert(points[i], at);
    domain.vertex_of_point[i] = vertex;
    near = Kernel::cell_of(kernel.half_of(vertex));
  }
  return {};
}

Kernel::Mark mark_of(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Boundary:
      return Kernel::fixed | Kernel::parity;
    case EdgeKind::Interface:
      return Kernel::fixed | Kernel::interface;
    case EdgeKind::Constraint:
      break;
  }
  return Kernel::fixed;
}

Error crossing_error(const MeshInput& input, const InputEdge& edge, Point a, Point b, Point c, Point d) {
  const geom::Intersection meeting = geom::intersect({a, b}, {c, d});
  const Point at = meeting.kind == geom::IntersectionKind::None ? geom::midpoint(a, b) : meeting.start.point;
  return error_at(
      ErrorCode::SelfIntersection,
      fmt::format("edges ({}, {})-({}, {}) and ({}, {})-({}, {}) cross: cut them at a common point or move one",
                  base::number_text(a.x), base::number_text(a.y), base::number_text(b.x), base::number_text(b.y),
                  base::number_text(c.x), base::number_text(c.y), base::number_text(d.x), base::number_text(d.y)),
      at, set_text(input, edge));
}

Result<void> insert_edges(const MeshInput& input, PlanarDomain& domain, const Progress& progress) {
  std::vector<Kernel::Vertex> chain;
  domain.chain_first.assign(1, 0);
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    if (i % 1024 == 0) DOBRA_TRY_VOID(progress.check());
    const InputEdge& edge = input.edges[i];
    const Kernel::Vertex a = domain.vertex_of_point[edge.nodes[0].index()];
    const Kernel::Vertex b = domain.vertex_of_point[edge.nodes[1].index()];
    if (a != b) {
      const auto crossing = domain.kernel.insert_constraint(a, b, mark_of(input.sets[edge.set].kind), chain);
      if (crossing) {
        const Kernel& kernel = domain.kernel;
        return crossing_error(input, edge, kernel.point(a), kernel.point(b), kernel.point(crossing->from),
                              kernel.point(crossing->to));
      }
      domain.chain.insert(domain.chain.end(), chain.begin(), chain.end());
    }
    domain.chain_first.push_back(domain.chain.size());
  }
  return {};
}

/// Every vertex must have an even number of boundary sides, or inside and outside are not told apart.
Result<void> check_closed(const MeshInput& input, const PlanarDomain& domain) {
  const Kernel& kernel = domain.kernel;
  std::vector<std::uint8_t> odd(kernel.vertex_count(), 0);
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if ((kernel.mark(e) & Kernel::parity) != 0) odd[kernel.origin(e)] ^= 1U;
    }
  }
  for (std::size_t p = 0; p < input.points.size(); ++p) {
    if (odd[domain.vertex_of_point[p]] == 0) continue;
    return error_at(ErrorCode::CannotMesh, "the boundary is not closed: it ends here; join it to the other end",
                    input.points[p], "boundary");
  }
  return {};
}

void flood_from_infinity(Kernel& kernel) {
  constexpr std::int32_t unknown = -2;
  std::vector<Kernel::Cell> todo;
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    kernel.set_region(c, kernel.is_ghost(c) ? -1 : unknown);
    if (kernel.is_ghost(c)) todo.push_back(c);
  }
  while (!todo.empty()) {
    const Kernel::Cell c = todo.back();
    todo.pop_back();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      const Kernel::Cell other = Kernel::cell_of(kernel.twin(e));
      if (kernel.cell(other).region != unknown) continue;
      const std::int32_t here = kernel.cell(c).region;
      kernel.set_region(other, (kernel.mark(e) & Kernel::parity) != 0 ? -1 - here : here);
      todo.push_back(other);
    }
  }
}

/// Gives regions to parts of the domain, one seed after the other; each costs what it covers.
class SeedFlood {
 public:
  explicit SeedFlood(PlanarDomain& domain) : kernel_(domain.kernel), seen_(domain.kernel.cell_count(), 0) {}

  /// The cells round `seed` get `region`, up to boundary and interface sides.
  Result<void> run(Point seed, std::int32_t region, const char* what) {
    const Kernel::Location at = geom::is_finite(seed) ? kernel_.locate(seed, near_, Kernel::Walls::Ignore)
                                                      : Kernel::Location{Kernel::Where::Blocked, Kernel::none};
    const bool found = at.where != Kernel::Where::Outside && at.where != Kernel::Where::Blocked;
    if (!found || kernel_.cell(Kernel::cell_of(at.half)).region < 0) {
      return error_at(ErrorCode::OutsideDomain,
                      fmt::format("the {} seed lies outside the boundary: move it inside", what), seed);
    }
    near_ = Kernel::cell_of(at.half);
    ++stamp_;
    todo_.assign(1, near_);
    seen_[near_] = stamp_;
    while (!todo_.empty()) {
      const Kernel::Cell c = todo_.back();
      todo_.pop_back();
      kernel_.set_region(c, region);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Kernel::Half e = Kernel::half(c, i);
        const Kernel::Cell other = Kernel::cell_of(kernel_.twin(e));
        if ((kernel_.mark(e) & (Kernel::parity | Kernel::interface)) != 0 || seen_[other] == stamp_) continue;
        if (kernel_.cell(other).region < 0) continue;
        seen_[other] = stamp_;
        todo_.push_back(other);
      }
    }
    return {};
  }

 private:
  Kernel& kernel_;
  std::vector<std::uint32_t> seen_;  ///< The seed that last came by.
  std::vector<Kernel::Cell> todo_;
  std::uint32_t stamp_ = 0;
  Kernel::Cell near_ = 0;
};

/// Internal edges and free points must lie inside; nothing is dropped without a word.
Result<void> check_inside(const MeshInput& input, const PlanarDomain& domain) {
  const Kernel& kernel = domain.kernel;
  std::vector<std::uint8_t> inside(kernel.vertex_count(), 0);
  std::size_t count = 0;
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    if (kernel.cell(c).region < 0) continue;
    ++count;
    for (const Kernel::Vertex v : kernel.cell(c).vertex) inside[v] = 1;
  }
  if (count == 0) {
    return Error{ErrorCode::CannotMesh, "the boundary encloses no area: give a closed loop of at least three points"};
  }
  for (std::size_t p = 0; p < input.points.size(); ++p) {
    if (inside[domain.vertex_of_point[p]] != 0) continue;
    return error_at(ErrorCode::OutsideDomain, "a point lies outside the boundary: remove it or enclose it",
                    input.points[p], fmt::format("point {}", p));
  }
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    for (std::size_t k = domain.chain_first[i]; k + 1 < domain.chain_first[i + 1]; ++k) {
      const Kernel::Half e = kernel.find(domain.chain[k], domain.chain[k + 1]);
      if (kernel.cell(Kernel::cell_of(e)).region >= 0) continue;
      if (kernel.cell(Kernel::cell_of(kernel.twin(e))).region >= 0) continue;
      return error_at(ErrorCode::OutsideDomain, "an edge lies outside the domain: trim it at the boundary",
                      geom::midpoint(kernel.point(domain.chain[k]), kernel.point(domain.chain[k + 1])),
                      set_text(input, input.edges[i]));
    }
  }
  return {};
}

}  // namespace

Result<PlanarDomain> build_domain(const MeshInput& input, Outside outside, const Progress& progress) {
  DOBRA_TRY_VOID(validate(input));
  PlanarDomain domain;
  DOBRA_TRY_VOID(insert_points(input, domain, progress.part(0.0, 0.7)));
  DOBRA_TRY_VOID(insert_edges(input, domain, progress.part(0.7, 0.9)));
  Kernel& kernel = domain.kernel;
  if (outside == Outside::KeepHull) {
    for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) kernel.set_region(c, kernel.is_ghost(c) ? -1 : 0);
    return domain;
  }
  DOBRA_TRY_VOID(check_closed(input, domain));
  flood_from_infinity(kernel);
  SeedFlood flood(domain);
  for (const Point hole : input.holes) DOBRA_TRY_VOID(flood.run(hole, -1, "hole"));
  for (const RegionSeed& seed : input.regions) {
    if (seed.region < 0) return error_at(ErrorCode::InvalidOption, "a region tag must not be negative", seed.at);
    DOBRA_TRY_VOID(flood.run(seed.at, seed.region, "region"));
  }
  DOBRA_TRY_VOID(check_inside(input, domain));
  return domain;
}

namespace {

/// Sides of the domain run with the domain on their left, whatever the direction in the input.
void add_edge(const Kernel& kernel, Kernel::Vertex a, Kernel::Vertex b, EdgeKind kind, std::vector<Edge>& set,
              const std::vector<NodeId>& node_of_vertex) {
  const bool turn = kind == EdgeKind::Boundary && kernel.cell(Kernel::cell_of(kernel.find(a, b))).region < 0;
  if (turn) std::swap(a, b);
  set.push_back({node_of_vertex[a], node_of_vertex[b]});
}

std::vector<NodeId> number_nodes(const PlanarDomain& domain, TriangleMesh& mesh) {
  const Kernel& kernel = domain.kernel;
  std::vector<std::uint8_t> used(kernel.vertex_count(), 0);
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    if (kernel.cell(c).region < 0) continue;
    for (const Kernel::Vertex v : kernel.cell(c).vertex) used[v] = 1;
  }
  std::vector<NodeId> node_of_vertex(kernel.vertex_count());
  const auto number = [&](Kernel::Vertex v) {
    if (used[v] == 0 || node_of_vertex[v].valid()) return;
    node_of_vertex[v] = NodeId(mesh.points.size());
    mesh.points.push_back(kernel.point(v));
  };
  for (const Kernel::Vertex v : domain.vertex_of_point) number(v);
  for (std::size_t v = 0; v < kernel.vertex_count(); ++v) number(static_cast<Kernel::Vertex>(v));
  return node_of_vertex;
}

}  // namespace

ExtractedMesh extract(const PlanarDomain& domain, const MeshInput& input) {
  const Kernel& kernel = domain.kernel;
  ExtractedMesh result;
  TriangleMesh& mesh = result.mesh;
  result.node_of_vertex = number_nodes(domain, mesh);
  const std::vector<NodeId>& node_of_vertex = result.node_of_vertex;
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const Kernel::Triangle& cell = kernel.cell(c);
    if (cell.region < 0) continue;
    mesh.triangles.push_back(
        {node_of_vertex[cell.vertex[0]], node_of_vertex[cell.vertex[1]], node_of_vertex[cell.vertex[2]]});
    mesh.regions.push_back(cell.region);
  }
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    const InputSet& set = input.sets[input.edges[i].set];
    auto& sets = set.kind == EdgeKind::Boundary ? mesh.boundary_sets : mesh.constraint_sets;
    std::vector<Edge>& edges = sets[set.name];
    for (std::size_t k = domain.chain_first[i]; k + 1 < domain.chain_first[i + 1]; ++k) {
      add_edge(kernel, domain.chain[k], domain.chain[k + 1], set.kind, edges, node_of_vertex);
    }
  }
  result.node_of_point.reserve(input.points.size());
  for (const Kernel::Vertex v : domain.vertex_of_point) result.node_of_point.push_back(node_of_vertex[v]);
  for (const auto& [name, nodes] : input.node_sets) {
    for (const NodeId node : nodes) {
      const NodeId found = result.node_of_point[node.index()];
      if (found.valid()) mesh.node_sets[name].push_back(found);
    }
  }
  return result;
}

}  // namespace dobra::mesh::delaunay
