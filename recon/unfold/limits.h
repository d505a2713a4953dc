#pragma once
// What a restoration must be to be handed out: finite, and within the limits of its method.
// Page: docs/algorithms/thickness.md

#include "recon/unfold/restore.h"

namespace recon::unfold {

/// @error CannotRestore with the place of the first point whose image is not finite.
base::Result<void> refuse_not_finite(const section::Section& section, const Restoration& restoration);

/// Variable thickness keeps areas where the columns of the top stay open: det F must lie between 1 / greatest_factor
/// and greatest_factor in every unit, and the length of no bed may change by more than that factor.
/// @error CannotRestore with the place that is farthest beyond, and a method that restores this section, if there is
/// one.
base::Result<void> refuse_beyond_limits(const section::Section& section, const SourceGrid& source, const Target& target,
                                        const Restoration& restoration);

}  // namespace recon::unfold
