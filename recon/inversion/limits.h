#pragma once
// Values as the user gives them: one number fixes one, two are the limits between which it is sought.

#include "recon/inversion/fit.h"
#include "recon/inversion/invert_params.h"

namespace recon::inversion {

/// @error BadValue: neither one number nor two that ascend.
base::Result<Unknown> unknown_of(const char* key, const char* unit, const std::vector<double>& given,
                                 std::vector<double> otherwise);

/// That nothing is given which the method has no use for.  @error BadValue
base::Result<void> check_keys(const InvertParams& params);

}  // namespace recon::inversion
