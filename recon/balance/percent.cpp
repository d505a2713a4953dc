#include "recon/balance/percent.h"

#include <fmt/format.h>

#include <cmath>

namespace recon::balance {

std::string percent_text(double value) { return std::abs(value) < 5e-7 ? "0" : fmt::format("{:.4g}", value); }

double percent(double part, double whole) { return whole == 0.0 ? 0.0 : 100.0 * part / whole; }

}  // namespace recon::balance
