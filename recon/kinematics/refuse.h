#pragma once
// The error of a map that cannot be made.

#include <string>

#include "shared/base/error.h"
#include "shared/geom/place.h"

namespace recon::kinematics {

inline dobra::base::Error refused(std::string message, dobra::geom::Point at) {
  return {dobra::base::ErrorCode::CannotRestore, std::move(message), dobra::geom::place_at(at, "fault")};
}

}  // namespace recon::kinematics
