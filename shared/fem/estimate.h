#pragma once
// How wrong a solution is, in the energy norm: recovered stresses against those of the elements.
//   ||e||^2 = sum of the integrals of (s* - s_h) D^-1 (s* - s_h) t,   eta = ||e|| / sqrt(||u_h||^2 + ||e||^2).
// Page: docs/algorithms/estimate.md. Source: [zienkiewicz1987], [zienkiewicz1992spr].

#include <span>
#include <vector>

#include "shared/fem/recover.h"
#include "shared/fem/singular_field.h"

namespace dobra::fem {

struct ErrorEstimate {
  std::vector<double> elements;  ///< ||e|| of each element, sqrt(J).
  double error = 0.0;            ///< ||e||, sqrt(J).
  double norm = 0.0;             ///< ||u_h||, sqrt(J): the root of twice the strain energy.
  double eta = 0.0;              ///< 0..1
};

/// @param zones  elements in them are held against the zone's stress, which is infinite at its vertex.
/// @cost O(n), in parallel
ErrorEstimate estimate_error(const mesh::ElementMesh& mesh, const Materials& materials, std::span<const geom::Vector> u,
                             const RecoveredStress& recovered, std::span<const SingularZone> zones = {});

/// The true ||e|| of a solution under loads alone (supports that do not move), from the exact strain energy, sqrt(J).
double true_error(double exact_energy, double energy);

}  // namespace dobra::fem
