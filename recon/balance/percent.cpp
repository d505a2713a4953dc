#include "recon/balance/percent.h"

#include <fmt/format.h>

#include <cmath>

namespace recon::balance {

std::string percent_text(double value) { return std::abs(value) < 5e-7 ? "0" : fmt::format("{:.4g}", value); }

}  // namespace recon::balance
