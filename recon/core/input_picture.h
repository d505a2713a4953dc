#pragma once
// The lines of an input whose section is refused.

#include "recon/input/input.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// Every line that can be read, a layer each, whatever is wrong with it; no panel where there is none.
void draw_lines(const input::SectionInput& input, const dobra::scenario::Context& context,
                dobra::scene::Picture& picture);

}  // namespace recon::core
