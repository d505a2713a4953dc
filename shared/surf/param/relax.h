#pragma once
// The border of a chart set free: places move until triangles have the shapes and sizes that they have in space, as far
// as the sheet can be laid flat at all. Page: docs/algorithms/relaxed_chart.md.
// Sources: [rabinovich2017slim] (the steps), [smith2015bijective] (the energy, and steps that keep every triangle).

#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/surf/param/sheet.h"

namespace dobra::surf::param {

struct RelaxOptions {
  int steps = 60;        ///< At most.
  double enough = 0.01;  ///< Three steps that each take less than this part off what is above the least end it.
};

struct Relaxed {
  /// Mean over the area of a^2 + b^2 + 1 / a^2 + 1 / b^2 for the greatest and the least length a and b in the chart of
  /// a unit in space; 4 where every triangle keeps its shape and size.
  double energy_before = 0.0, energy = 0.0;
  int steps = 0;
  bool held_by_border = false;  ///< A step was shortened, or left out, since borders would cross.
};

/// @param uv  one a point, m after it: a unit of the chart is one of space. Scaled before the first step.
/// @pre no triangle is flipped, no borders cross; both hold after it too
/// @error Cancelled: uv is as it was before the step
/// @cost  O(n^1.5) a step, a sparse solution
base::Result<Relaxed> relax(const Sheet& sheet, std::vector<geom::Point>& uv, const RelaxOptions& options = {},
                            const base::Progress& progress = {});

/// Two sides of the border meet anywhere but in the point that they share. @cost O(n log n)
bool borders_cross(const Sheet& sheet, const std::vector<geom::Point>& uv);

}  // namespace dobra::surf::param
