#include "shared/fem/stress.h"

#include "shared/base/parallel.h"

namespace dobra::fem {
namespace {

constexpr std::size_t grain = 256;

/// Reference coordinates of the nodes.
std::array<double, 2> reference_node(ElementType type, std::size_t i) {
  constexpr std::array<std::array<double, 2>, 6> triangle{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  constexpr std::array<std::array<double, 2>, 8> square{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  return mesh::corner_count(type) == 3 ? triangle[i] : square[i];
}

}  // namespace

Gradient gradient_at(const ElementGeometry& element, const Mapped& mapped, std::span<const geom::Vector> u) {
  Gradient g{};
  for (std::size_t a = 0; a < element.count; ++a) {
    const geom::Vector v = u[element.nodes[a]];
    g[0] += mapped.d_x[a] * v.x;
    g[1] += mapped.d_y[a] * v.x;
    g[2] += mapped.d_x[a] * v.y;
    g[3] += mapped.d_y[a] * v.y;
  }
  return g;
}

Voigt stress_at(const ElementGeometry& element, const Elasticity& elasticity, const Mapped& mapped,
                std::span<const geom::Vector> u) {
  return stress_of(elasticity, strain_of(gradient_at(element, mapped, u)));
}

std::vector<double> element_energies(const mesh::ElementMesh& mesh, const Materials& materials,
                                     std::span<const geom::Vector> u) {
  return base::parallel_map<double>(
      mesh.element_count(),
      [&](std::size_t e) {
        const ElementGeometry element = geometry_of(mesh, e);
        const Material& material = materials.at(mesh.regions[e]);
        const Elasticity d = elasticity(material);
        const Rule rule = stiffness_rule(element);  // the energy that the stiffness has
        const auto points = integration_points(element.type, rule);
        const auto shapes = shapes_at(element.type, rule);
        double energy = 0.0;
        for (std::size_t g = 0; g < points.size(); ++g) {
          const Mapped m = map(element.points(), shapes[g]);
          const Voigt strain = strain_of(gradient_at(element, m, u));
          const Voigt stress = stress_of(d, strain);
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
        const Elasticity d = elasticity(materials.at(mesh.regions[e]));
        for (std::size_t a = 0; a < element.count; ++a) {
          const auto [xi, eta] = reference_node(element.type, a);
          stresses[mesh.first[e] + a] =
              stress_at(element, d, map(element.points(), shape_at(element.type, xi, eta)), u);
        }
      },
      grain);
  return stresses;
}

}  // namespace dobra::fem
