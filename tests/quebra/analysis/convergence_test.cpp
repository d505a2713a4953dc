#include "quebra/analysis/convergence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace test;
namespace scene = dobra::scene;
using testing::HasSubstr;
using testing::StartsWith;

const std::string l_shape = sheared_l + "[[step]]\noperation = \"adapt\"\ntarget = 3.0\n";

const scene::Layer& layer(const scene::Panel& panel, const std::string& key) {
  return *std::find_if(panel.layers.begin(), panel.layers.end(),
                       [&](const scene::Layer& own) { return own.key == key; });
}

TEST(Convergence, TheCurveHasAPointForEveryCycleAndTheBestRateItsSlope) {
  const auto done = run(l_shape);
  const model::Model& model = last(done);
  ASSERT_GE(model.analyses.size(), 3u);
  const scene::Picture picture = convergence_picture(model);
  const scene::Panel& panel = picture.panels.front();
  EXPECT_EQ(panel.axes.scale, scene::AxisScale::Log10);
  const auto& curve = std::get<scene::Lines>(layer(panel, "curve").content).lines.front().points;
  ASSERT_EQ(curve.size(), model.analyses.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_DOUBLE_EQ(std::pow(10.0, curve[i].x), static_cast<double>(model.analyses[i]->solution.statistics.unknowns));
    EXPECT_DOUBLE_EQ(std::pow(10.0, curve[i].y), 100.0 * model.analyses[i]->eta);
  }
  const auto& rate = std::get<scene::Lines>(layer(panel, "rate").content).lines.front().points;
  EXPECT_NEAR((rate[1].y - rate[0].y) / (rate[1].x - rate[0].x), -1.0, 1e-12);  // T6: N^(-p/2)
  EXPECT_EQ(rate[1], curve.back());
  EXPECT_TRUE(panel.extent->contains(rate[0]) && panel.extent->contains(curve.front()));
}

TEST(Convergence, EveryCycleCanBeDrawn) {
  const std::string view = "[[step]]\noperation = \"view\"\ncycle = ";
  const auto done = run(l_shape + view + "1\n" + view + "2\n" + view + "0\n");
  const scene::Picture picture = core::program().picture_of(done.states.back());
  ASSERT_EQ(picture.panels.size(), 3u);
  EXPECT_THAT(picture.panels[0].title, StartsWith("Cycle 1, "));
  EXPECT_THAT(picture.panels[1].title, StartsWith("Cycle 2, "));
  const auto triangles = [&](std::size_t i) {
    return std::get<scene::Mesh>(layer(picture.panels[i], "field").content).triangles.size();
  };
  EXPECT_LT(triangles(0), triangles(1));
  EXPECT_EQ(triangles(0), 4 * last(done).meshes[0]->mesh.element_count());
  EXPECT_EQ(triangles(2), 4 * last(done).meshes.back()->mesh.element_count());
  EXPECT_THAT(trouble(l_shape + view + "40\n"), HasSubstr("there is no cycle 40: the last is"));
}

}  // namespace
}  // namespace quebra::analysis
