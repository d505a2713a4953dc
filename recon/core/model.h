#pragma once
// The state that RECON's operations work on: the section as read, and what each step has added. A value.

#include <optional>
#include <string>
#include <vector>

#include "recon/core/grid.h"
#include "recon/core/restore.h"
#include "recon/core/section.h"
#include "recon/core/target.h"

namespace recon::core {

struct Model {
  Section section;
  std::vector<std::string> remarks;        ///< On the input.
  std::optional<SourceGrid> source;        ///< After the step grid.
  std::optional<Target> target;            ///< After the step target.
  std::optional<Restoration> restoration;  ///< After the step restore.
};

}  // namespace recon::core
