#include "quebra/core/adaptivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shared/fem/singular_vertices.h"

namespace quebra::core {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Vector;

/// A cycle that lowers the error by less has stalled.
constexpr double least_gain = 0.02;
/// The sizes aim this much lower than the error asked for: what the mesher makes of them comes out a little above.
constexpr double aim = 0.95;

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
  fem::NewSizeOptions options{.target = aim * params.target / 100.0,
                              .rule = params.rule == RuleOfSizes::Optimal ? fem::SizeRule::Optimal : fem::SizeRule::EqualError,
                              .min_size = params.min_size,
                              .max_size = std::max(first_size, params.min_size)};
  if (params.rosettes == UseRosettes::Yes) options.frozen = touching_tips(own);
  const auto singular = fem::singular_vertices(own, analysis.problem);
  std::vector<double> least(own.element_count(), options.max_size);
  for (const CaseFields& fields : analysis.fields) {
    DOBRA_TRY(const auto sizes, fem::new_sizes(own, fields.estimate, singular, options));
    for (std::size_t e = 0; e < sizes.size(); ++e) least[e] = std::min(least[e], sizes[e]);
  }
  // The elements round a singular vertex ask there, and all for the least of their sizes: the field is alike all round.
  std::set<mesh::NodeId> vertices;
  for (const fem::SingularVertex& vertex : singular) vertices.insert(vertex.node);
  std::map<mesh::NodeId, double> at_vertices;
  std::vector<mesh::SizeRequest> requests;
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    if (!options.frozen.empty() && options.frozen[e] != 0) continue;
    Vector sum;
    const auto nodes = own.nodes_of(mesh::ElementId(e));
    const std::size_t corners = mesh::corner_count(own.types[e]);
    const auto touched = std::find_if(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners), [&](mesh::NodeId node) { return vertices.contains(node); });
    if (touched != nodes.begin() + static_cast<std::ptrdiff_t>(corners)) {
      double& size = at_vertices.try_emplace(*touched, least[e]).first->second;
      size = std::min(size, least[e]);
      continue;
    }
    for (std::size_t i = 0; i < corners; ++i) sum = sum + (own.point(nodes[i]) - dobra::geom::Point{});
    requests.push_back({dobra::geom::Point{} + sum / static_cast<double>(corners), least[e]});
  }
  for (const auto& [node, size] : at_vertices) requests.push_back({own.point(node), size});
  return requests;
}

}  // namespace

Result<Model> adapt(const Model& model, const AdaptParams& params, const dobra::scenario::Context&, const dobra::base::Progress& progress) {
  if (!model.problem) return Error{ErrorCode::BadValue, "there is nothing to analyse: put a step 'problem' with materials, supports and loads before"};
  Model result = model;
  const double size = params.size > 0.0 ? params.size : model.domain.box().diagonal() / 8.0;
  MeshParams meshing{.label = {}, .size = size, .division = params.division, .turn = params.turn, .growth = params.growth, .constraints = params.constraints, .order = params.order, .rosettes = params.rosettes};
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
