#pragma once
// Stress intensity factors of the last analysis, at every crack tip and for every load case.
// Page: docs/algorithms/crack.md.

#include "quebra/core/analysis.h"

namespace quebra::core {

struct FractureParams {
  std::optional<double> contour;

  template <class D>
  static void describe(D& d) {
    d.field("contour", &FractureParams::contour, {.title = "Contour", .help = "Outer radius of the ring of the integrals; by default the largest that fits.", .unit = "m", .above = 0});
  }
};

/// @error BadValue: no analysis, or no tip in its mesh; those of fem::crack_tips.
dobra::base::Result<Model> add_tips(const Model& model, const FractureParams& params, const dobra::scenario::Context& context,
                                    const dobra::base::Progress& progress);

}  // namespace quebra::core
