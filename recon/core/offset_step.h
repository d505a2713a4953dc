#pragma once
// The operation `offset`: curves parallel to the lines of the section in hand, or of a file.

#include "shared/scenario/program.h"

namespace recon::core {

dobra::scenario::Operation offset_step();

}  // namespace recon::core
