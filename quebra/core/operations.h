#pragma once
// The table of everything that QUEBRA can do.

#include "shared/scenario/program.h"

namespace quebra::core {

const dobra::scenario::Program& program();

}  // namespace quebra::core
