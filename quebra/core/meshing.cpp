#include "quebra/core/meshing.h"

#include <fmt/format.h>

#include <map>

#include "quebra/core/domain.h"
#include "shared/mesh/triangulate.h"

namespace quebra::core {
namespace {

using dobra::base::Result;
using dobra::geom::Point;
using dobra::mesh::EdgeKind;
using dobra::mesh::MeshInput;
using dobra::mesh::NodeId;

/// Builds the input of the mesher; equal points become one node.
class InputBuilder {
 public:
  std::uint32_t add_set(std::string name, EdgeKind kind) {
    input_.sets.push_back({std::move(name), kind});
    return static_cast<std::uint32_t>(input_.sets.size() - 1);
  }
  NodeId node(Point p) {
    const auto [at, added] = nodes_.try_emplace(p, input_.points.size());
    if (added) input_.points.push_back(p);
    return at->second;
  }
  void edge(Point from, Point to, std::uint32_t set) {
    const NodeId a = node(from);
    const NodeId b = node(to);
    if (a != b) input_.edges.push_back({{a, b}, set});
  }
  MeshInput take() { return std::move(input_); }

 private:
  MeshInput input_;
  std::map<Point, NodeId> nodes_;
};

std::vector<Stop> stops_on(std::size_t curve, const std::vector<Constraint>& constraints) {
  std::vector<Stop> stops;
  for (const Constraint& constraint : constraints) {
    for (const auto& foot : constraint.feet) {
      if (foot.curve == curve) stops.push_back({foot.s, constraint.spacing});
    }
  }
  return stops;
}

MeshInput mesh_input(const Domain& domain, const std::vector<Constraint>& constraints, const DivideOptions& options) {
  InputBuilder builder;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const Curve& curve = domain.curves[c];
    const auto set = builder.add_set(curve.name, curve.role == Role::Internal ? EdgeKind::Interface : EdgeKind::Boundary);
    const std::vector<double> nodes = divide(curve, stops_on(c, constraints), options);
    Point from = point(curve, nodes.front());
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const bool back_at_start = closed(curve) && i + 1 == nodes.size();
      const Point to = point(curve, back_at_start ? 0.0 : nodes[i]);
      builder.edge(from, to, set);
      from = to;
    }
  }
  for (const Constraint& constraint : constraints) {
    const auto set = builder.add_set(constraint.name, EdgeKind::Constraint);
    for (std::size_t i = 0; i < constraint.line.segment_count(); ++i) {
      const auto [from, to] = constraint.line.segment(i);
      builder.edge(from, to, set);
    }
  }
  return builder.take();
}

}  // namespace

Result<Model> add_mesh(const Model& model, const MeshParams& params, const dobra::scenario::Context&,
                       const dobra::base::Progress& progress) {
  const double size = params.size > 0.0 ? params.size : model.domain.box().diagonal() / 20.0;
  const std::vector<Constraint> none;
  const auto& constraints = params.constraints == UseConstraints::Yes ? model.constraints : none;
  const MeshInput input =
      mesh_input(model.domain, constraints, {.size = size, .turn = params.turn, .growth = params.growth});

  dobra::mesh::MeshOptions options;
  options.sizes.growth = params.growth;
  options.sizes.max_size = params.size;
  options.smoothing.passes = params.smoothing;
  options.points.max_triangles = static_cast<std::size_t>(params.max_elements);
  DOBRA_TRY(dobra::mesh::TriangleMesh mesh, dobra::mesh::triangulate(input, options, progress));

  auto meshed = std::make_shared<Meshed>();
  meshed->name = !params.label.empty() ? params.label : fmt::format("Mesh {}", model.meshes.size() + 1);
  meshed->quality = dobra::mesh::quality_of(mesh);
  meshed->mesh = std::move(mesh);
  meshed->constraints = constraints.size();
  Model result = model;
  result.meshes.push_back(std::move(meshed));
  return result;
}

}  // namespace quebra::core
