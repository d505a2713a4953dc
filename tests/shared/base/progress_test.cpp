#include "shared/base/progress.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace dobra::base {
namespace {

TEST(Progress, PartsAreNestedFractionsOfTheWhole) {
  std::vector<double> seen;
  const Progress progress(CancelToken{}, [&](double fraction, const std::string&) { seen.push_back(fraction); });
  progress.report(0.25);
  const Progress second_half = progress.part(0.5, 1.0);
  second_half.report(0.0);
  second_half.report(0.5);
  second_half.part(0.5, 1.0).report(0.5);
  second_half.report(1.0);
  EXPECT_EQ(seen, (std::vector<double>{0.25, 0.5, 0.75, 0.875, 1.0}));
}

TEST(Progress, TextReachesTheListener) {
  std::string seen;
  const Progress progress(CancelToken{}, [&](double, const std::string& what) { seen = what; });
  progress.part(0, 0.5).report(0, "meshing");
  EXPECT_EQ(seen, "meshing");
}

TEST(Progress, CancelStopsEveryPartAndEveryCopy) {
  const CancelToken token;
  const Progress progress(token, nullptr);
  const Progress part = progress.part(0.1, 0.2);
  EXPECT_TRUE(part.check().ok());
  token.cancel();
  EXPECT_TRUE(progress.cancelled());
  ASSERT_FALSE(part.check().ok());
  EXPECT_EQ(part.check().error().code, ErrorCode::Cancelled);
}

TEST(Progress, DefaultOneNeitherListensNorStops) {
  const Progress progress;
  progress.report(0.5, "nobody hears");
  EXPECT_TRUE(progress.check().ok());
}

}  // namespace
}  // namespace dobra::base
