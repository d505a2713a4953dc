#include "shared/offset/types/distances.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/base/text.h"

namespace dobra::offset {
inline namespace types {

base::Result<std::vector<double>> distances(const DistanceRule& rule) {
  const auto invalid = [](std::string message) {
    return base::Error{base::ErrorCode::InvalidOption, std::move(message)};
  };
  if (rule.count < 1) return invalid("the number of offset curves is 0; ask for at least 1");
  if (rule.count > 100000)
    return invalid(fmt::format("{} offset curves are too many; ask for at most 100000", rule.count));
  if (!(rule.initial > 0.0) || !std::isfinite(rule.initial)) {
    return invalid("the initial distance is " + base::number_text(rule.initial) + "; it must be above 0");
  }
  if (!(rule.factor > 0.0) || !std::isfinite(rule.factor)) {
    return invalid("the factor is " + base::number_text(rule.factor) + "; it must be above 0 (1 gives equal gaps)");
  }
  std::vector<double> all;
  double distance = 0.0;
  for (std::size_t k = 1; k <= rule.count; ++k) {
    // Equal gaps are multiplied rather than added up, so that curve k is at k d0 without drift.
    const double next =
        rule.factor == 1.0 ? static_cast<double>(k) * rule.initial : rule.factor * distance + rule.initial;
    if (!std::isfinite(next) || !(next > distance)) {
      return invalid(fmt::format("curve {} would be at distance {}; take fewer curves or a factor nearer to 1", k,
                                 base::number_text(next)));
    }
    distance = next;
    all.push_back(distance);
  }
  return all;
}

}  // namespace types
}  // namespace dobra::offset
