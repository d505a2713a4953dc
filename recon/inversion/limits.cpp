#include "recon/inversion/limits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "recon/inversion/invert.h"

namespace recon::inversion {

const char* name_of(InvertMethod method) { return method == InvertMethod::Trishear ? "trishear" : "shear"; }

base::Result<Unknown> unknown_of(const char* key, const char* unit, const std::vector<double>& given,
                                 std::vector<double> otherwise) {
  const std::vector<double>& numbers = given.empty() ? otherwise : given;
  if (numbers.size() > 2 || (numbers.size() == 2 && !(numbers[0] < numbers[1]))) {
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("'{}' is one number, which fixes it, or two limits, the lesser one first, not [{}]",
                                   key, fmt::join(numbers, ", "))};
  }
  return Unknown{key, unit, numbers.front(), numbers.back()};
}

base::Result<void> check_keys(const InvertParams& params) {
  const bool trishear = params.method == InvertMethod::Trishear;
  const auto useless = [&](const char* key) {
    return base::Error{
        base::ErrorCode::BadValue,
        fmt::format("'{}' is of {}; the method {} has no use for it, so leave it out", key,
                    name_of(trishear ? InvertMethod::Shear : InvertMethod::Trishear), name_of(params.method))};
  };
  if (trishear) {
    if (!params.angle.empty()) return useless("angle");
    return {};
  }
  for (const auto& [key, given] : {std::pair{"tip_x", &params.tip_x},
                                   {"tip_z", &params.tip_z},
                                   {"ramp", &params.ramp},
                                   {"propagation", &params.propagation},
                                   {"apical", &params.apical},
                                   {"concentration", &params.concentration}}) {
    if (!given->empty()) return useless(key);
  }
  if (params.fault.empty())
    return base::Error{base::ErrorCode::BadValue, "shear goes over a fault that is known; name it as 'fault'"};
  return {};
}

}  // namespace recon::inversion
