#pragma once
// The sign of slip on a fault: a half-arrow on each wall, the barb away from the fault.

#include <string>

#include "recon/faults/fault.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// Which way the hanging wall went along the path.
enum class SlipSign { Down, Up };

/// Beside the middle of the fault's own part.
/// @param size  of the section, m.
dobra::scene::Layer slip_arrows(const std::string& key, const faults::Fault& fault, SlipSign sign, double size);

}  // namespace recon::core
