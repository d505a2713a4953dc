#pragma once
// Curves and surfaces of a boundary model as those of shared/surf, in the parameters that the file gives them.
// Page: docs/algorithms/import_of_faces.md.

#include <functional>
#include <limits>

#include "shared/geom/box.h"
#include "shared/io/brep/brep.h"
#include "shared/surf/surface.h"

namespace dobra::io::faces {

inline constexpr double endless = std::numeric_limits<double>::infinity();

/// What a curve is without being cut: from -endless to endless for a line.
struct CurveRange {
  double low = -endless, high = endless;
  double period = 0.0;  ///< 0: it does not close.
};
/// @error those of to_curve
base::Result<CurveRange> range_of(const brep::Curve& curve);
/// A part of it. Beyond the range a closed curve goes round again, the end pieces of an open one go on.
/// @error those of surf::Curve's makers
base::Result<surf::Curve> to_curve(const brep::Curve& curve, double from, double to);
surf::Curve placed(const surf::Curve& curve, const brep::Placement& placement);

/// A surface in the world that nobody has cut yet.
struct WholeSurface {
  geom::Box range;  ///< Of the parameters; -endless .. endless where it has no end.
  double period_u = 0.0, period_v = 0.0;
  /// Values of u (v) at which it is one point: the poles of a sphere, the apex of a cone.
  std::vector<double> points_u = {}, points_v = {};
  bool flat = false;
  /// The part over a finite chart. Within `range`, but for a parameter with a period, which may go round.
  std::function<base::Result<surf::Surface>(const geom::Box& chart)> over;
  /// Where a point in space is near, for one on the surface; nothing where no formula says it.
  std::function<std::optional<geom::Point>(geom::Point3)> place_of;
};
/// @error those of surf::Surface's makers, with what is wrong: a radius that is not positive, knots, weights
base::Result<WholeSurface> whole_surface(const brep::Surface& surface, const brep::Placement& placement);

}  // namespace dobra::io::faces
