#pragma once
// Displacement against distance along a fault: the check of a section's cutoffs. Page: docs/algorithms/cutoffs.md

#include <string>
#include <vector>

#include "recon/faults/cutoffs.h"

namespace recon::faults {

/// Step: the separation jumps where its neighbours change slowly. Reversal: it rises again after falling (or falls
/// after rising) away from its one greatest value, or changes its sign.
enum class ProfileMark { None, Step, Reversal };
/// "", "step", "reversal".
const char* name_of(ProfileMark mark);

struct ProfilePoint {
  std::string horizon;
  double distance = 0.0;                 ///< From the fault's higher end, m.
  double separation = 0.0;               ///< m
  ProfileMark mark = ProfileMark::None;  ///< Of what lies between this point and the one before it.
};

/// The pairs with both walls, from the higher end down.
std::vector<ProfilePoint> profile_of(const FaultCutoffs& cutoffs);

}  // namespace recon::faults
