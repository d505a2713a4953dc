#pragma once
// Closed elastic solutions: loads of validation problems by name, and the auxiliary fields of the crack integrals.
// Page: docs/algorithms/crack.md. Source: [timoshenko1970] (Kirsch), [szabo1991fem] (corner), [williams1957] (tip),
// [kfouri1986] (line force, for the T-stress).

#include <cstdint>
#include <numbers>

#include "shared/base/angle.h"
#include "shared/fem/stress.h"

namespace dobra::fem::error {

/// Kirsch: an infinite plate with a hole of radius `radius` at the origin under sigma_x = `tension` far away.
Voigt kirsch_stress(geom::Point at, double radius = 1.0, double tension = 1.0);

/// The exponent lambda of the displacements r^lambda at a corner with free faces, interior angle above 180 degrees: the
/// least positive root of sin(lambda w) + lambda sin(w) = 0 (opening), or - (sliding). 0.5 for a crack.
enum class CornerMode : std::uint8_t { Opening, Sliding };
double corner_exponent(base::Angle interior, CornerMode mode = CornerMode::Opening);

/// The opening mode at a re-entrant corner of 270 degrees at the origin, with amplitude A = 1 [szabo1991fem].
/// @param bisector  direction, from x, in which the bisector of the interior points.
Voigt l_corner_stress(geom::Point at, base::Angle bisector);

/// A field round a crack tip at the origin, the crack along the negative x axis.
struct TipField {
  Voigt stress;       ///< Pa
  Gradient gradient;  ///< Of the displacements.
};
enum class TipLoad : std::uint8_t {
  Opening,  ///< K_I = 1
  Sliding,  ///< K_II = 1
  Force,    ///< A force of 1 N/m at the tip along x, ahead.
};
/// @pre at is not the origin. On the crack itself y = +0 is the upper lip, -0 the lower one.
TipField tip_field(geom::Point at, TipLoad load, const Material& material);
/// Displacement of the two modes, m; for prescribing them.
geom::Vector tip_displacement(geom::Point at, TipLoad mode, const Material& material);

}  // namespace dobra::fem::error
