#include "shared/fem/stress.h"

#include <utility>

#include "shared/base/parallel.h"

namespace dobra::fem {
namespace {

constexpr std::size_t grain = 256;

}  // namespace

ElementSolution::ElementSolution(const ElementGeometry& element, const Material& material,
                                 std::span<const geom::Vector> u)
    : element_(element), elasticity_(elasticity(material)) {
  for (std::size_t a = 0; a < element.count; ++a) own_[a] = u[element.nodes[a]];
  if (!mesh::is_quadratic(element.type) || !nearly_incompressible(material)) return;
  const auto own = std::span(std::as_const(own_)).first(element.count);
  mixed_.emplace(element, material);
  bubble_ = mixed_->bubble(own);
  dilatation_ = mixed_->dilatation(own, bubble_);
}

Gradient ElementSolution::gradient(const Mapped& mapped) const {
  Gradient g{};
  const auto add = [&](geom::Vector v, double d_x, double d_y) {
    g[0] += d_x * v.x;
    g[1] += d_y * v.x;
    g[2] += d_x * v.y;
    g[3] += d_y * v.y;
  };
  for (std::size_t a = 0; a < element_.count; ++a) add(own_[a], mapped.d_x[a], mapped.d_y[a]);
  if (mixed_) {
    const geom::Vector slope = bubble_slope(element_.type, reference_at(element_, mapped));
    add(bubble_, slope.x, slope.y);
  }
  return g;
}

Voigt ElementSolution::stress(const Mapped& mapped) const {
  const Voigt strain = strain_of(gradient(mapped));
  if (!mixed_) return stress_of(elasticity_, strain);
  const double mean = elasticity_.xy * mixed_->dilatation_at(dilatation_, mapped.at);
  const double mu = elasticity_.shear;
  return {mean + 2.0 * mu * strain[0], mean + 2.0 * mu * strain[1], mu * strain[2]};
}

Rule ElementSolution::rule() const { return mixed_ ? Rule::Curved : stiffness_rule(element_); }

std::vector<double> element_energies(const mesh::ElementMesh& mesh, const Materials& materials,
                                     std::span<const geom::Vector> u) {
  return base::parallel_map<double>(
      mesh.element_count(),
      [&](std::size_t e) {
        const ElementGeometry element = geometry_of(mesh, e);
        const Material& material = materials.at(mesh.regions[e]);
        const ElementSolution solution(element, material, u);
        const Rule rule = solution.rule();  // the energy that the stiffness has
        const auto points = integration_points(element.type, rule);
        const auto shapes = shapes_at(element.type, rule);
        double energy = 0.0;
        for (std::size_t g = 0; g < points.size(); ++g) {
          const Mapped m = map(element.points(), shapes[g]);
          const Voigt strain = strain_of(solution.gradient(m));
          const Voigt stress = solution.stress(m);
          energy += m.determinant * points[g].weight * material.thickness *
                    (stress[0] * strain[0] + stress[1] * strain[1] + stress[2] * strain[2]);
        }
        return energy;
      },
      grain);
}

std::vector<Voigt> element_stresses(const mesh::ElementMesh& mesh, const Materials& materials,
                                    std::span<const geom::Vector> u) {
  std::vector<Voigt> stresses(mesh.nodes.size());
  base::parallel_for(
      mesh.element_count(),
      [&](std::size_t e) {
        const ElementGeometry element = geometry_of(mesh, e);
        const ElementSolution solution(element, materials.at(mesh.regions[e]), u);
        for (std::size_t a = 0; a < element.count; ++a) {
          const auto [xi, eta] = reference_node(element.type, a);
          stresses[mesh.first[e] + a] = solution.stress(map(element.points(), shape_at(element.type, xi, eta)));
        }
      },
      grain);
  return stresses;
}

}  // namespace dobra::fem
