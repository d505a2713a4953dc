#include "quebra/core/adaptivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "shared/fem/exact_fields.h"
#include "shared/fem/new_sizes.h"

namespace quebra::core {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Vector;

/// Interior angles above this are corners where the stresses are infinite, and not a curve followed by sides.
constexpr double least_corner = 210.0 * std::numbers::pi / 180.0;
/// A cycle that lowers the error by less has stalled.
constexpr double least_gain = 0.02;

/// Tips, and corners of the boundary that point into the material.
std::vector<fem::SingularVertex> singular_vertices(const mesh::ElementMesh& mesh) {
  std::vector<fem::SingularVertex> singular;
  std::set<mesh::NodeId> tips;
  for (const mesh::CrackTip& tip : mesh.tips) {
    tips.insert(tip.node);
    singular.push_back({tip.node, 0.5});
  }
  struct Ends {
    Vector in;
    Vector out;
  };
  std::map<mesh::NodeId, Ends> corners;
  for (const mesh::ElementSide side : boundary_sides(mesh)) {
    const auto [from, to, middle] = side_nodes(mesh, side);
    const auto towards = [&](mesh::NodeId a, mesh::NodeId b) {
      // The tangent at a of the parabola a, middle, b; of a straight side the chord.
      if (!middle.valid()) return mesh.point(b) - mesh.point(a);
      return 4.0 * (mesh.point(middle) - mesh.point(a)) - (mesh.point(b) - mesh.point(a));
    };
    corners[from].out = towards(from, to);
    corners[to].in = towards(to, from);
  }
  for (const auto& [node, ends] : corners) {
    if (tips.contains(node)) continue;
    // The material lies on the left of the boundary: from `out` anticlockwise to `in`.
    double angle = std::atan2(cross(ends.out, ends.in), dot(ends.out, ends.in));
    if (angle <= 0.0) angle += 2.0 * std::numbers::pi;
    if (angle > least_corner) singular.push_back({node, fem::corner_exponent(dobra::base::Angle::from_radians(angle))});
  }
  return singular;
}

/// Elements that touch a tip: with a rosette they stay as they are.
std::vector<std::uint8_t> touching_tips(const mesh::ElementMesh& mesh) {
  std::set<mesh::NodeId> tips;
  for (const mesh::CrackTip& tip : mesh.tips) tips.insert(tip.node);
  std::vector<std::uint8_t> frozen(mesh.element_count(), 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.nodes_of(mesh::ElementId(e));
    frozen[e] = std::any_of(nodes.begin(), nodes.end(), [&](mesh::NodeId node) { return tips.contains(node); }) ? 1 : 0;
  }
  return frozen;
}

Result<std::vector<mesh::SizeRequest>> next_sizes(const Analysis& analysis, const AdaptParams& params, double first_size) {
  const mesh::ElementMesh& own = analysis.meshed->mesh;
  fem::NewSizeOptions options{.target = params.target / 100.0,
                              .rule = params.rule == RuleOfSizes::Optimal ? fem::SizeRule::Optimal : fem::SizeRule::EqualError,
                              .min_size = params.min_size,
                              .max_size = std::max(first_size, params.min_size)};
  if (params.rosettes == UseRosettes::Yes) options.frozen = touching_tips(own);
  const auto singular = singular_vertices(own);
  std::vector<double> least(own.element_count(), options.max_size);
  for (const CaseFields& fields : analysis.fields) {
    DOBRA_TRY(const auto sizes, fem::new_sizes(own, fields.estimate, singular, options));
    for (std::size_t e = 0; e < sizes.size(); ++e) least[e] = std::min(least[e], sizes[e]);
  }
  std::vector<mesh::SizeRequest> requests;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    if (!options.frozen.empty() && options.frozen[e] != 0) continue;
    Vector sum;
    const auto nodes = own.nodes_of(mesh::ElementId(e));
    const std::size_t corners = mesh::corner_count(own.types[e]);
    for (std::size_t i = 0; i < corners; ++i) sum = sum + (own.point(nodes[i]) - dobra::geom::Point{});
    requests.push_back({dobra::geom::Point{} + sum / static_cast<double>(corners), least[e]});
  }
  return requests;
}

}  // namespace

Result<Model> adapt(const Model& model, const AdaptParams& params, const dobra::scenario::Context&, const dobra::base::Progress& progress) {
  if (!model.problem) return Error{ErrorCode::BadValue, "there is nothing to analyse: put a step 'problem' with materials, supports and loads before"};
  Model result = model;
  const double size = params.size > 0.0 ? params.size : model.domain.box().diagonal() / 8.0;
  MeshParams meshing{.label = {}, .size = size, .turn = params.turn, .growth = params.growth, .constraints = params.constraints, .order = params.order, .rosettes = params.rosettes};
  std::vector<mesh::SizeRequest> sizes;
  double before = 1.0;
  for (int cycle = 1;; ++cycle) {
    const auto part = progress.part((cycle - 1.0) / params.max_cycles, static_cast<double>(cycle) / params.max_cycles);
    meshing.label = fmt::format("Cycle {}", cycle);
    DOBRA_TRY(Meshed meshed, mesh_domain(result, meshing, sizes, result.remarks, part.part(0.0, 0.3)));
    result.meshes.push_back(std::make_shared<const Meshed>(std::move(meshed)));
    DOBRA_TRY(Analysis analysis, analyse(result.meshes.back(), *model.problem, 0.0, part.part(0.3, 1.0)));
    analysis.cycle = cycle;
    const double eta = analysis.eta;
    result.analyses.push_back(std::make_shared<const Analysis>(std::move(analysis)));
    if (100.0 * eta <= params.target) return result;
    if (cycle > 1 && eta > (1.0 - least_gain) * before) {
      result.remarks.push_back(fmt::format("the error stalls at {:.3g} %, above the {:.3g} % asked for; allow smaller elements", 100.0 * eta, params.target));
      return result;
    }
    if (cycle == params.max_cycles) {
      result.remarks.push_back(fmt::format("after {} cycles the error is {:.3g} %, above the {:.3g} % asked for; allow more", cycle, 100.0 * eta, params.target));
      return result;
    }
    before = eta;
    DOBRA_TRY(sizes, next_sizes(*result.analyses.back(), params, size));
  }
}

}  // namespace quebra::core
