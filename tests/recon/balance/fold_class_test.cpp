#include "recon/balance/fold_class.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "recon/core/operations.h"
#include "shared/io/lines/text_points.h"
#include "tests/recon/shapes.h"
#include "tests/support/corpus.h"

namespace recon::balance {
namespace {

geom::Polyline parabola(double height, double lift) {
  geom::Polyline line;
  for (int i = -400; i <= 400; ++i) {
    const double x = i / 100.0;
    line.points.push_back({x, lift - height * x * x / 16.0});
  }
  return line;
}

TEST(FoldClass, AParallelFoldIsClass1B) {
  const geom::Polyline upper = parabola(3.0, 0.0);
  const auto found = fold_class(upper, test::parallel(upper, 0.5));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, RamsayClass::Class1B);
  EXPECT_NEAR(found->index, 0.0, 1e-3);
  EXPECT_NEAR(found->hinge_thickness, 0.5, 1e-3);
}

TEST(FoldClass, ASimilarFoldIsClass2UpAndDown) {
  const auto found = fold_class(parabola(3.0, 0.0), parabola(3.0, -1.0));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, RamsayClass::Class2);
  EXPECT_NEAR(found->index, 1.0, 1e-3);
  const auto down = fold_class(parabola(-3.0, 0.0), parabola(-3.0, -1.0));
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->index, 1.0, 1e-3);
  EXPECT_NEAR(down->hinge_thickness, 1.0, 1e-9);
}

TEST(FoldClass, AFoldThatGetsTighterUpwardsIsClass3AndDownwardsClass1A) {
  const auto tighter_above = fold_class(parabola(3.5, 0.0), parabola(2.5, -1.6));
  ASSERT_TRUE(tighter_above);
  EXPECT_EQ(tighter_above->value, RamsayClass::Class3);
  const auto tighter_below = fold_class(parabola(2.0, 0.0), parabola(6.0, -0.6));
  ASSERT_TRUE(tighter_below);
  EXPECT_EQ(tighter_below->value, RamsayClass::Class1A);
}

TEST(FoldClass, StraightBedsHaveNoClass) {
  EXPECT_FALSE(fold_class({{{0, 0}, {5, 0}, {9, 0}}, false}, {{{0, -1}, {5, -1}, {9, -1}}, false}));
}

TEST(FoldClass, TheIsogonFoldHasClasses3And1BAnd2FromTheTop) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  std::vector<geom::Polyline> surfaces;
  for (const int number : {4, 3, 2, 1}) {
    const auto read = dobra::io::lines::read_text_points(data->string() + "/sections/ragan_isogon_fold/layer" +
                                                         std::to_string(number) + ".txt");
    ASSERT_TRUE(read) << to_string(read.error());
    surfaces.push_back(read->lines.front());
  }
  const std::vector<RamsayClass> expected = {RamsayClass::Class3, RamsayClass::Class1B, RamsayClass::Class2};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = fold_class(surfaces[i], surfaces[i + 1]);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->value, expected[i]) << "layer " << i << " index " << found->index;
  }
}

}  // namespace
}  // namespace recon::balance
