#pragma once
// The operations of RECON, each with what it adds to pictures, numbers, tables, remarks and files. A new one is its
// parameters and function, a file ..._step.cpp, a member of Model, and a line here and in operations.cpp.

#include "shared/scenario/program.h"

namespace recon::core {

dobra::scenario::Operation grid_step();
dobra::scenario::Operation target_step();
dobra::scenario::Operation restore_step();
dobra::scenario::Operation carry_step();
dobra::scenario::Operation monte_carlo_step();
dobra::scenario::Operation balance_step();
dobra::scenario::Operation area_balance_step();
dobra::scenario::Operation offset_step();

}  // namespace recon::core
