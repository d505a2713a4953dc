#pragma once
// How wrong a solution is, in the energy norm: recovered stresses against those of the elements.
//   ||e||^2 = sum of the integrals of (s* - s_h) D^-1 (s* - s_h) t,   eta = ||e|| / sqrt(||u_h||^2 + ||e||^2).
// Page: docs/algorithms/estimate.md. Source: [zienkiewicz1987], [zienkiewicz1992spr].

#include <span>
#include <vector>

#include "shared/fem/error/recover.h"
#include "shared/fem/error/singular_field.h"

namespace dobra::fem::error {

/// A neighbourhood that an estimate leaves out: that of a force at a point, where the energy is infinite.
struct Disc {
  geom::Point centre;
  double radius = 0.0;  ///< m
  [[nodiscard]] bool holds(geom::Point p) const { return distance(p, centre) < radius; }
};

struct ErrorEstimate {
  std::vector<double> elements;  ///< ||e|| of each element, sqrt(J).
  double error = 0.0;            ///< ||e||, sqrt(J).
  double norm = 0.0;             ///< ||u_h||, sqrt(J): the root of twice the strain energy.
  double eta = 0.0;              ///< 0..1
  double left_out = 0.0;         ///< Share of the energy in what is left out, 0..1; `norm` is of the rest.
};

/// @param zones     elements in them are held against the zone's stress, which is infinite at its vertex.
/// @param left_out  integration points in these count neither for the error nor for the energy.
/// @cost O(n), in parallel
ErrorEstimate estimate_error(const mesh::ElementMesh& mesh, const Materials& materials, std::span<const geom::Vector> u,
                             const RecoveredStress& recovered, std::span<const SingularZone> zones = {},
                             std::span<const Disc> left_out = {});

/// The true ||e|| of a solution under loads alone (supports that do not move), from the exact strain energy, sqrt(J).
double true_error(double exact_energy, double energy);

}  // namespace dobra::fem::error
