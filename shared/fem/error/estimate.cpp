#include "shared/fem/error/estimate.h"

#include <algorithm>
#include <cmath>

#include "shared/base/parallel.h"
#include "shared/fem/stress.h"

namespace dobra::fem::error {

ErrorEstimate estimate_error(const mesh::ElementMesh& mesh, const Materials& materials, std::span<const geom::Vector> u,
                             const RecoveredStress& recovered, std::span<const SingularZone> zones,
                             std::span<const Disc> left_out) {
  ErrorEstimate estimate;
  std::vector<const SingularZone*> zone_of(mesh.element_count(), nullptr);
  for (const SingularZone& zone : zones) {
    for (const std::uint32_t e : zone.elements) zone_of[e] = &zone;
  }
  struct Sums {
    double error = 0.0;
    double left_out = 0.0;
  };
  const auto sums = base::parallel_map<Sums>(
      mesh.element_count(),
      [&](std::size_t e) {
        const ElementGeometry element = geometry_of(mesh, e);
        const Material& material = materials.at(mesh.regions[e]);
        const Elasticity d = elasticity(material);
        const ElementSolution solution(element, material, u);
        const auto points = integration_points(element.type, Rule::Curved);
        const auto shapes = shapes_at(element.type, Rule::Curved);
        Sums sum;
        for (std::size_t g = 0; g < points.size(); ++g) {
          const Mapped m = map(element.points(), shapes[g]);
          const Voigt own = solution.stress(m);
          const double weight = m.determinant * points[g].weight * material.thickness;
          if (std::any_of(left_out.begin(), left_out.end(), [&](const Disc& disc) { return disc.holds(m.at); })) {
            sum.left_out += weight * energy_product(d, own, own);
            continue;
          }
          Voigt difference = zone_of[e] != nullptr ? zone_of[e]->stress(m.at) : Voigt{};
          for (std::size_t k = 0; k < 3; ++k) {
            difference[k] -= own[k];
            if (zone_of[e] != nullptr) continue;
            for (std::size_t a = 0; a < element.count; ++a)
              difference[k] += m.n[a] * recovered.at_element_nodes[mesh.first[e] + a][k];
          }
          sum.error += weight * energy_product(d, difference, difference);
        }
        return sum;
      },
      64);
  double error = 0.0;
  double without = 0.0;
  for (const Sums& sum : sums) {
    estimate.elements.push_back(std::sqrt(sum.error));
    error += sum.error;
    without += sum.left_out;
  }
  double energy = 0.0;
  for (const double e : element_energies(mesh, materials, u)) energy += e;
  if (without > 0.0) {
    estimate.left_out = std::min(1.0, without / energy);
    energy = std::max(0.0, energy - without);
  }
  estimate.error = std::sqrt(error);
  estimate.norm = std::sqrt(energy);
  estimate.eta = energy + error > 0.0 ? std::sqrt(error / (energy + error)) : 0.0;
  return estimate;
}

double true_error(double exact_energy, double energy) { return std::sqrt(2.0 * std::max(0.0, exact_energy - energy)); }

}  // namespace dobra::fem::error
