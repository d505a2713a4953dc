#pragma once
// Percents as they are told: with four figures, and 0 where nothing but rounding is left.

#include <string>

namespace recon::balance {

/// "4.08", "0"; 0 below 5e-7.
std::string percent_text(double value);

/// 0 of a whole that is 0.
double percent(double part, double whole);

}  // namespace recon::balance
