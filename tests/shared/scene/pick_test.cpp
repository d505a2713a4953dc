#include "shared/scene/pick.h"

#include <gtest/gtest.h>

namespace dobra::scene {
namespace {

const Style plain{};

geom::Polyline square(double low, double high) { return {{{low, low}, {high, low}, {high, high}, {low, high}}, true}; }

Layer lines_layer() {
  return {"lines", "Lines", plain,
          Lines{{{{{0.0, 0.0}, {10.0, 0.0}}, false}, {{{0.0, 5.0}, {10.0, 5.0}}, false}}, {7, 9}}};
}

TEST(Pick, ALineIsFoundWithinTheToleranceAndNamedByItsId) {
  const Panel panel{"p", "", {}, {lines_layer()}};
  EXPECT_EQ(pick(panel, {5.0, 4.8}, 0.3), (Pick{"lines", 9}));
  EXPECT_EQ(pick(panel, {5.0, 0.2}, 0.3), (Pick{"lines", 7}));
  EXPECT_EQ(pick(panel, {5.0, 2.0}, 0.3), std::nullopt);
}

TEST(Pick, TheNearestOfSeveralMarkersWins) {
  const Panel panel{"p", "", {}, {{"m", "", plain, Markers{{{0.0, 0.0}, {1.0, 0.0}}, {}}}}};
  EXPECT_EQ(pick(panel, {0.6, 0.0}, 5.0), (Pick{"m", 1}));
}

TEST(Pick, AFilledRegionIsFoundInsideButNotInItsHole) {
  Style filled;
  filled.fill = Color{1, 2, 3};
  const Panel panel{"p", "", {}, {{"r", "", filled, Regions{{{{square(0.0, 10.0), square(4.0, 6.0)}}}, {3}}}}};
  EXPECT_EQ(pick(panel, {2.0, 2.0}, 0.1), (Pick{"r", 3}));
  EXPECT_EQ(pick(panel, {5.0, 5.0}, 0.1), std::nullopt);
  EXPECT_EQ(pick(panel, {11.0, 5.0}, 0.1), std::nullopt);
}

TEST(Pick, AnUnfilledRegionIsFoundOnItsOutlineOnly) {
  const Panel panel{"p", "", {}, {{"r", "", plain, Regions{{{{square(0.0, 10.0)}}}, {}}}}};
  EXPECT_EQ(pick(panel, {2.0, 2.0}, 0.1), std::nullopt);
  EXPECT_EQ(pick(panel, {0.05, 2.0}, 0.1), (Pick{"r", 0}));
}

TEST(Pick, ATriangleIsFoundWhicheverWayItTurns) {
  Mesh mesh;
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 2}};
  const Panel panel{"p", "", {}, {{"mesh", "", plain, mesh}}};
  EXPECT_EQ(pick(panel, {0.8, 0.2}, 0.0), (Pick{"mesh", 0}));
  EXPECT_EQ(pick(panel, {0.2, 0.8}, 0.0), (Pick{"mesh", 1}));
  EXPECT_EQ(pick(panel, {2.0, 0.8}, 0.0), std::nullopt);
}

TEST(Pick, TheTopmostVisibleLayerWins) {
  Layer above = lines_layer();
  above.key = "above";
  Panel panel{"p", "", {}, {lines_layer(), above}};
  EXPECT_EQ(pick(panel, {5.0, 0.0}, 0.1), (Pick{"above", 7}));
  panel.layers[1].visible = false;
  EXPECT_EQ(pick(panel, {5.0, 0.0}, 0.1), (Pick{"lines", 7}));
}

TEST(Pick, TheToleranceIsACircleOnAnExaggeratedPage) {
  Panel panel{"p", "", {}, {lines_layer()}};
  EXPECT_TRUE(pick(panel, {5.0, -0.2}, 0.3));
  panel.vertical_exaggeration = 2.0;  // 0.2 m are now as long on the page as 0.4 m along x
  EXPECT_FALSE(pick(panel, {5.0, -0.2}, 0.3));
}

}  // namespace
}  // namespace dobra::scene
