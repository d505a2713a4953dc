#pragma once
// Everything that a user can do to a section, listed once: the window, the command line and scenarios call these
// operations. The header of each, NAME_step.h, says what it does and which quantities it adds.

#include "shared/scenario/program.h"

namespace recon::core {

/// RECON, as the shared machinery sees it. Quantities of every section: horizons, horizon.NAME.length_before,
/// section.area, section.units_area (the sum of its units), section.misfits; from the second stage of the chain on
/// stages (earlier ones), since_input.horizon.NAME.change_percent, since_input.unit.NAME.change_percent,
/// since_input.balanced.
const dobra::scenario::Program& program();

}  // namespace recon::core
