#include "shared/base/short_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace dobra::base {
namespace {

TEST(ShortNumber, ComesBackFromOtherUnits) {
  for (const double factor : {0.3048, 1000.0, 0.0254, 1200.0 / 3937.0}) {
    for (int i = -3000; i <= 3000; i += 7) {
      const double written = i / 10.0;
      EXPECT_EQ(without_rounding((written * factor) / factor), written) << i << " by " << factor;
    }
  }
}

TEST(ShortNumber, LeavesWhatIsNotShort) {
  std::uint64_t state = 7;
  int changed = 0;
  for (int i = 0; i < 10000; ++i) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    const double value = static_cast<double>(state >> 11U) * 0x1p-40;
    const double taken = without_rounding(value);
    changed += taken != value ? 1 : 0;
    EXPECT_NEAR(taken, value, 4.0 * std::numeric_limits<double>::epsilon() * value);
  }
  EXPECT_LE(changed, 3);
  EXPECT_EQ(without_rounding(1.0 / 3.0), 1.0 / 3.0);
  EXPECT_EQ(without_rounding(2250.00000001), 2250.00000001);
}

TEST(ShortNumber, TakesZeroAndWhatIsNoNumber) {
  EXPECT_EQ(without_rounding(0.0), 0.0);
  EXPECT_EQ(without_rounding(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(without_rounding(std::nan(""))));
  EXPECT_EQ(without_rounding(std::numeric_limits<double>::denorm_min()), std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace dobra::base
