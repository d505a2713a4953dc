#include "recon/section/file_rounding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace recon::section {
namespace {

Section of(std::vector<geom::Point> bed, std::vector<geom::Point> fault = {{0, 0}, {10, 20}}) {
  Section section;
  section.horizons = {{HorizonId(0), "bed", {std::move(bed), false}, {}}};
  section.lines = {{LineId(0), LineKind::Fault, "F", {std::move(fault), false}, {}}};
  return section;
}

TEST(FileRounding, ComputedCoordinatesHaveNoLastDecimal) {
  EXPECT_EQ(last_decimal(of({{0, 0}, {1.0 / 3.0, 1}})), std::nullopt);
  EXPECT_EQ(last_decimal(of({{0, 0}, {std::sqrt(2.0), std::sqrt(3.0)}, {1000, 0.25}})), std::nullopt);
  const double angle = 0.3;
  EXPECT_EQ(last_decimal(of({{0, 0}, {12.25 * std::cos(angle), 3.5 * std::sin(angle)}})), std::nullopt);
  EXPECT_EQ(rounding_of_coordinates(of({{0, 0}, {1.0 / 3.0, 1}})), 0.0);
  EXPECT_EQ(rounding_of_coordinates(Section{}), 0.0);
  // Places on a map of which only doubles are left: nothing is known of them, whatever they look like.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0.0, 9e6);
  std::vector<geom::Point> places;
  for (int i = 0; i < 50; ++i) places.push_back({any(random), any(random)});
  EXPECT_EQ(last_decimal(of(places)), std::nullopt);
}

TEST(FileRounding, AllCoordinatesTogetherHaveIt) {
  EXPECT_EQ(last_decimal(of({{0, 0}, {1200, -7}})), 1.0);
  EXPECT_EQ(last_decimal(of({{0, 0}, {1200.5, -7}})), 0.1);
  EXPECT_EQ(last_decimal(of({{0, 0}, {1200, -7}}, {{1, 1}, {2, 3.125}})), 0.001);  // one line alone is in round numbers
  EXPECT_EQ(last_decimal(of({{0, 0}, {1e-9, 1}})), 1e-9);
  for (int decimals = 0; decimals <= 6; ++decimals) {
    const double scale = std::pow(10.0, decimals);
    std::mt19937 random(static_cast<unsigned>(decimals));
    std::uniform_real_distribution<double> any(-5e5, 5e5);
    std::vector<geom::Point> places;
    for (int i = 0; i < 200; ++i)
      places.push_back({std::round(any(random) * scale) / scale, std::round(any(random) * scale) / scale});
    EXPECT_NEAR(*last_decimal(of(places)) * scale, 1.0, 1e-12) << decimals;
    // Depths in kilometres, under a reference.
    Section section = of(places);
    section.convention = {VerticalAxis::Down, 1234.5, LengthUnit::Kilometre, 1.0};
    for (geom::Point& p : section.horizons[0].line.points) p = to_section(p, section.convention);
    section.lines.clear();
    if (decimals >= 3) {
      EXPECT_NEAR(*last_decimal(section) * scale, 1000.0, 1e-9) << decimals;
    }
  }
}

std::vector<geom::Point> places_on(double step, unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(-5000000, 5000000);
  std::vector<geom::Point> places;
  for (int i = 0; i < count; ++i) places.push_back({any(random) * step, any(random) * step});
  return places;
}

TEST(FileRounding, TheGridMayBeInFeet) {
  for (const bool is_said : {true, false}) {  // files of lines have units of their own
    for (const double step : {1.0, 0.1, 0.01}) {
      Section section = of(places_on(1.0, 5, 300));
      if (is_said) section.convention.unit = LengthUnit::Foot;
      for (geom::Point& p : section.horizons[0].line.points)
        p = {0.3048 * (std::round(p.x) / std::round(1.0 / step)), 0.3048 * (std::round(p.y) / std::round(1.0 / step))};
      section.lines.clear();
      EXPECT_NEAR(last_decimal(section).value_or(0.0), 0.3048 * step, 1e-12) << step;
      EXPECT_EQ(grid_of_files(section)->odd, 0U);
    }
  }
  // Depths in feet under a reference, exaggerated twice: cells are half as high.
  Section section;
  section.convention = {VerticalAxis::Down, 812.3, LengthUnit::Foot, 2.0};
  Horizon horizon;
  std::mt19937 random(2);
  std::uniform_int_distribution<int> any(-90000, 90000);
  for (int i = 0; i < 200; ++i)
    horizon.line.points.push_back(to_section({any(random) / 10.0, any(random) / 10.0}, section.convention));
  section.horizons = {horizon};
  EXPECT_NEAR(grid_of_files(section)->cell, 0.3048 * std::hypot(0.1, 0.05), 1e-12);
}

TEST(FileRounding, OnePointInFiftyMayLieOffTheGrid) {
  std::vector<geom::Point> places = places_on(0.01, 6, 100);
  for (geom::Point& p : places) p = {std::round(100.0 * p.x) / 100.0, std::round(100.0 * p.y) / 100.0};
  ASSERT_EQ(last_decimal(of(places)), 0.01);
  places[31].y += 0.1234567;
  places[77].x += 1.0 / 3.0;
  const auto grid = grid_of_files(of(places));
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->step, 0.01);
  EXPECT_EQ(grid->odd, 2U);
  EXPECT_EQ(grid->odd_place, places[31]);
  EXPECT_THAT(grid->odd_line, testing::StartsWith("horizon '"));
  EXPECT_EQ(grid->points, of(places).horizons[0].line.points.size() + of(places).lines[0].line.points.size());
  places[2].x += 1.0 / 3.0;
  places[3].x += 1.0 / 3.0;
  EXPECT_EQ(last_decimal(of(places)), std::nullopt);
  // A line of its own is no odd point: 400 points in metres say nothing of a fault in centimetres.
  std::vector<geom::Point> metres = places_on(1.0, 7, 400);
  EXPECT_EQ(last_decimal(of(metres, {{0.25, 0.5}, {1.75, 2.25}, {3.25, 4.5}})), 0.01);
  EXPECT_EQ(last_decimal(of(metres, {{0.25, 0.5}, {1, 2}, {3, 4}})), 1.0);
}

TEST(FileRounding, ItIsTheDiagonalOfACellAndNeverMoreThanATenThousandthOfTheSection) {
  EXPECT_NEAR(rounding_of_coordinates(of({{0, 0}, {3000.01, 4000}})), 0.01 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(rounding_of_coordinates(of({{0, 0}, {30, 40}})), 1e-4 * 50.0, 1e-12);
}

/// The bound is one: an end between two points of a line, all of them rounded, the worst of many.
TEST(FileRounding, NoEndIsFartherFromItsLine) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  double most = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const geom::Point a{1000 * any(random), 1000 * any(random)}, b{1000 * any(random), 1000 * any(random)};
    const geom::Point end = geom::interpolate(a, b, any(random));
    const auto rounded = [](geom::Point p) { return geom::Point{std::round(p.x), std::round(p.y)}; };
    most = std::max(most, geom::distance(geom::Segment{rounded(a), rounded(b)}, rounded(end)));
  }
  EXPECT_LT(most, std::sqrt(2.0));
  EXPECT_GT(most, 1.1);
}

}  // namespace
}  // namespace recon::section
