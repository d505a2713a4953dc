#include "recon/section/file_rounding.h"

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
