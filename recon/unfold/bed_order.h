#pragma once
// Which of the beds of a section lies above which, by their depth below the top. Page: docs/algorithms/unfold.md

#include <vector>

#include "recon/maps/columns.h"
#include "recon/section/section.h"

namespace recon::unfold {

/// A bed with the names that its points have in the columns of the top.
struct NamedBed {
  section::HorizonId id;
  std::vector<maps::ColumnPoint> names;  ///< Along the bed; none: it is the top itself.
};

/// From the top down, those above it first. Two beds that reach over one stretch of the top are compared by their mean
/// depth over that stretch, others by their mean depth.
/// @cost O(n + k^2) for k beds with n points.
std::vector<section::HorizonId> in_order(const std::vector<NamedBed>& beds, const maps::Columns& top);

}  // namespace recon::unfold
