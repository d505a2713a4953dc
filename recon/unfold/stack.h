#pragma once
// Methods that take the horizons as beds: flexural slip along horizons, line length, proportional thickness. Each
// horizon is laid out on the target by its own arc length from the pin. Points between two horizons go along rulings
// (ruled_map.h). Pages: docs/algorithms/flexural_slip.md, docs/algorithms/thickness.md

#include "recon/unfold/methods.h"

namespace recon::unfold {

/// The map of such a method and the horizons' own images.
/// @param on_the_way  for states below 100 %: the target's columns, matched with those of the source.
/// @error as make_method_map.
base::Result<MethodMap> make_stack_map(const section::Section& section, const SourceGrid& source, const Target& target,
                                       const MethodParams& params, std::optional<maps::Columns> on_the_way);

}  // namespace recon::unfold
