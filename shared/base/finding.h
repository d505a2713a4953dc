#pragma once
// What a computation has to say beside its answer.

#include <string>

#include "shared/base/error.h"

namespace dobra::base {

/// What was mended, or what an answer leaves open; it stands beside an answer, never instead of one.
struct Finding {
  std::string code;     ///< Stable, for scripts: "gap_closed", "loop_turned", "kink".
  std::string message;  ///< One line.
  Place place;          ///< x, y, z and u, v; or file and line.
};

}  // namespace dobra::base
