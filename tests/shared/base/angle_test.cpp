#include "shared/base/angle.h"

#include <gtest/gtest.h>

namespace dobra::base {
namespace {

TEST(Angle, HalfTurnIsPi) {
  EXPECT_EQ(Angle::from_degrees(180).radians(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(Angle::from_radians(std::numbers::pi / 6).degrees(), 30.0);
  EXPECT_EQ(Angle().radians(), 0.0);
}

TEST(Angle, SumsDifferencesMultiplesAndOrderAreThoseOfTheValues) {
  const Angle a = Angle::from_radians(0.5);
  const Angle b = Angle::from_radians(0.25);
  EXPECT_EQ(a + b, Angle::from_radians(0.75));
  EXPECT_EQ(a - b, b);
  EXPECT_EQ(2.0 * b, a);
  EXPECT_EQ(-a, Angle::from_radians(-0.5));
  EXPECT_LT(b, a);
}

}  // namespace
}  // namespace dobra::base
