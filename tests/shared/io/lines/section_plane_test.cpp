#include "shared/io/lines/section_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dobra::io::lines {
namespace {

using geom::Point;

/// Lines on the plane through (500000, 7400000) that runs towards `degrees` from the east, `off` metres beside it.
std::vector<Feature> lines_on(double degrees, double off, std::vector<Feature>* flat = nullptr) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double a = degrees * 3.14159265358979323846 / 180.0;
  std::vector<Feature> features(3);
  for (Feature& feature : features) {
    Feature in_plane;
    feature.parts.emplace_back();
    feature.heights.emplace_back();
    in_plane.parts.emplace_back();
    for (int i = 0; i < 200; ++i) {
      const double s = 50.0 * i;
      const double z = 1000.0 * uniform(random);
      const double d = off * uniform(random);
      feature.parts[0].points.push_back(
          {500000.0 + s * std::cos(a) - d * std::sin(a), 7400000.0 + s * std::sin(a) + d * std::cos(a)});
      feature.heights[0].push_back(z);
      in_plane.parts[0].points.push_back({s, z});
    }
    if (flat != nullptr) flat->push_back(in_plane);
  }
  return features;
}

TEST(SectionPlane, TheLengthIsThatOfTheSectionWhereverTheTraceBegins) {
  for (const double degrees : {0.0, 90.0, 37.0}) {
    const std::vector<Feature> features = lines_on(degrees, 0.0);
    const Trace fitted = *fit_trace(features);
    EXPECT_NEAR(length_along(fitted, features), 9950.0, 1e-5) << degrees;
    Trace from_afar = fitted;
    from_afar.x -= 1e6 * fitted.east;
    from_afar.y -= 1e6 * fitted.north;
    EXPECT_NEAR(length_along(from_afar, features), 9950.0, 1e-5) << degrees;
  }
}

TEST(SectionPlane, AnExactPlaneIsFoundAndTheLinesComeBack) {
  for (const double degrees : {0.0, 30.0, 89.9, 90.0, -45.0, 10.0}) {
    std::vector<Feature> expected;
    const std::vector<Feature> given = lines_on(degrees, 0.0, &expected);
    const auto trace = fit_trace(given);
    ASSERT_TRUE(trace.ok());
    EXPECT_NEAR(trace->east, std::cos(degrees * 3.14159265358979323846 / 180.0), 1e-9) << degrees;
    EXPECT_LT(trace->largest_misfit, 1e-8);
    std::vector<Feature> laid = given;
    ASSERT_TRUE(lay_into_plane(laid, *trace).ok());
    const double shift = laid[0].parts[0].points[0].x;  // an axis keeps its own coordinate
    for (std::size_t i = 0; i < 200; ++i) {
      EXPECT_NEAR(laid[1].parts[0].points[i].x - shift, expected[1].parts[0].points[i].x, 1e-8);
      EXPECT_EQ(laid[1].parts[0].points[i].y, expected[1].parts[0].points[i].y);
    }
    const std::vector<Feature> back = out_of_plane(laid, *trace);
    for (std::size_t i = 0; i < 200; ++i) {
      EXPECT_NEAR(geom::distance(back[2].parts[0].points[i], given[2].parts[0].points[i]), 0.0, 2e-9);
      EXPECT_EQ(back[2].heights[0][i], given[2].heights[0][i]);
    }
  }
}

TEST(SectionPlane, TheMisfitIsThatOfThePoints) {
  const auto trace = fit_trace(lines_on(30.0, 2.0));
  ASSERT_TRUE(trace.ok());
  EXPECT_NEAR(trace->largest_misfit, 2.0, 0.1);
  EXPECT_NEAR(trace->mean_misfit, 2.0 / std::sqrt(3.0), 0.05);  // of a uniform distribution
}

TEST(SectionPlane, PlanesAlongAnAxisKeepItsCoordinateToTheLastBit) {
  std::vector<Feature> features{{.parts = {{{{0.1, 7.3}, {2.0 / 3.0, 7.3}}, false}}, .heights = {{1, 2}}}};
  const auto trace = fit_trace(features);
  ASSERT_TRUE(trace.ok());
  const std::vector<Feature> given = features;
  ASSERT_TRUE(lay_into_plane(features, *trace).ok());
  EXPECT_EQ(features[0].parts[0].points, (std::vector<Point>{{0.1, 1}, {2.0 / 3.0, 2}}));
  EXPECT_EQ(out_of_plane(features, *trace), given);
  EXPECT_EQ(fit_trace({{.parts = {{{{3, 0.1}, {3, 0.7}}, false}}, .heights = {{1, 2}}}})->north, 1.0);
}

TEST(SectionPlane, PolygonsKeepContoursAndHolesFromEitherSide) {
  Feature unit{.type = FeatureType::Polygons,
               .parts = {{{{0, 0}, {4, 4}, {4, 4}, {0, 0}}, true}, {{{1, 1}, {1, 1}, {3, 3}}, true}},
               .heights = {{0, 0, 4, 4}, {1, 3, 1}}};
  ASSERT_TRUE(normalise(unit, {0, 1}).ok());
  for (const Point to : {Point{1, 1}, Point{-1, -1}}) {
    std::vector<Feature> features{unit};
    ASSERT_TRUE(lay_into_plane(features, *trace_between({0, 0}, to)).ok());
    EXPECT_GT(geom::signed_area(features[0].parts[0]), 0.0);
    EXPECT_LT(geom::signed_area(features[0].parts[1]), 0.0);
  }
}

TEST(SectionPlane, PointsOverOnePlaceHaveNoPlane) {
  EXPECT_FALSE(fit_trace({{.parts = {{{{1, 1}, {1, 1}}, false}}, .heights = {{1, 2}}}}).ok());
  EXPECT_FALSE(trace_between({1, 1}, {1, 1}).ok());
}

TEST(SectionPlane, DownThePlungeACylindricalFoldIsItsProfile) {
  // A fold with axis 120/25: the same profile at every place along it.
  const double trend = 120.0 * 3.14159265358979323846 / 180.0;
  const double plunge = 25.0 * 3.14159265358979323846 / 180.0;
  const double axis[] = {std::sin(trend) * std::cos(plunge), std::cos(trend) * std::cos(plunge), -std::sin(plunge)};
  const double level[] = {std::cos(trend), -std::sin(trend), 0.0};
  const double rise[] = {std::sin(plunge) * std::sin(trend), std::sin(plunge) * std::cos(trend), std::cos(plunge)};
  Feature feature{.parts = {{}}, .heights = {{}}};
  std::vector<Point> profile;
  for (int i = 0; i < 50; ++i) {
    const Point p{0.2 * i, std::sin(0.2 * i)};
    const double along = 40.0 * std::cos(7.0 * i);
    const auto at = [&](int k) { return p.x * level[k] + p.y * rise[k] + along * axis[k]; };
    feature.parts[0].points.push_back({at(0), at(1)});
    feature.heights[0].push_back(at(2));
    profile.push_back(p);
  }
  std::vector<Feature> features{feature};
  ASSERT_TRUE(project_along(features, {base::Angle::from_degrees(120.0), base::Angle::from_degrees(25.0)}).ok());
  ASSERT_EQ(features[0].parts[0].points.size(), profile.size());
  for (std::size_t i = 0; i < profile.size(); ++i)
    EXPECT_LT(geom::distance(features[0].parts[0].points[i], profile[i]), 1e-12);
  EXPECT_TRUE(features[0].heights.empty());
}

TEST(SectionPlane, TheEndsOfASectionHaveTheirCompassPoints) {
  using Ends = std::pair<std::string, std::string>;
  EXPECT_EQ(ends_of(base::Angle::from_degrees(90.0)), (Ends{"W", "E"}));
  EXPECT_EQ(ends_of(base::Angle::from_degrees(-170.0)), (Ends{"N", "S"}));
  EXPECT_EQ(ends_of(base::Angle::from_degrees(30.0)), (Ends{"SSW", "NNE"}));
  EXPECT_EQ(ends_of(azimuth_of(Trace{.east = 0.6, .north = -0.8})), (Ends{"NW", "SE"}));
  // Looking down a plunge to the north, x runs to the east.
  EXPECT_EQ(ends_of(azimuth_of(FoldAxis{base::Angle{}, base::Angle::from_degrees(10.0)})), (Ends{"W", "E"}));
}

}  // namespace
}  // namespace dobra::io::lines
