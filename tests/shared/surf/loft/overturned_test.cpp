// Volumes between horizons that end on an overturned limb. What is expected is the area of the polygon of both lines in
// the section, by the shoelace rule, times the length across.
#include <gtest/gtest.h>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

using Line = std::vector<Point>;
constexpr double across = 900.0;

/// An upper limb from x = 0, a half circle as hinge at x = 3000, and an inverted limb back to an x.
Line hairpin(double radius, double back_to) {
  Line line{{0.0, radius}};
  for (int k = 0; k <= 40; ++k) {
    const double angle = 1.5707963267948966 - 3.141592653589793 * k / 40.0;
    line.push_back({3000.0 + radius * std::cos(angle), radius * std::sin(angle)});
  }
  line.push_back({back_to, -radius});
  return line;
}
/// Three limbs: from x0 to x1, back to x2 and on to x3, a bed of a thickness below `down`.
Line three_limbs(std::array<double, 4> x, double down) {
  return {{x[0], -down}, {x[1], 300.0 - down}, {x[2], 600.0 - down}, {x[3], 900.0 - down}};
}

double shoelace(const Line& upper, const Line& lower) {
  Line ring = upper;
  ring.insert(ring.end(), lower.rbegin(), lower.rend());
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += geom::cross(ring[i] - Point{}, ring[(i + 1) % ring.size()] - Point{});
  return 0.5 * std::abs(twice);
}

/// @param lacks  the number of the section without the lower line
loft::Volume between(const Line& upper, const Line& lower, int lacks = -1) {
  std::vector<loft::Section> sections;
  for (const double y : {0.0, 300.0, across}) {
    sections.push_back(section("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {4000.0, y}}));
    add(sections.back(), "upper", {upper, false});
    if (static_cast<int>(sections.size()) - 1 != lacks) add(sections.back(), "lower", {lower, false});
  }
  const auto made = through(std::move(sections));
  EXPECT_EQ(made.surfaces.size(), 2U);
  if (made.surfaces.size() < 2) return {};
  return loft::volume_between(made.surfaces[0], made.surfaces[1], made.surfaces).value();
}

TEST(OverturnedEnds, TheBodyOfAHairpinIsItsSectionTimesItsLength) {
  for (const double back_to : {2500.0, 500.0, 0.0}) {
    const Line upper = hairpin(300.0, back_to), lower = hairpin(200.0, back_to);
    const auto volume = between(upper, lower);
    const double expected = across * shoelace(upper, lower);
    EXPECT_NEAR(volume.value, expected, 1e-9 * expected) << back_to;
    ASSERT_NE(finding(volume.findings, "overturned_end"), nullptr) << back_to;
    EXPECT_EQ(finding(volume.findings, "cross"), nullptr) << back_to;
    EXPECT_FALSE(volume.exact);
  }
}

TEST(OverturnedEnds, AFoldWithBothEndsOnOverturnedLimbsHasItsVolume) {
  for (const auto& x : {std::array{1000.0, 0.0, 3000.0, 2000.0}, std::array{2000.0, 0.0, 3000.0, 1000.0}}) {
    const Line upper = three_limbs(x, 0.0), lower = three_limbs(x, 40.0);
    const auto volume = between(upper, lower);
    const double expected = across * shoelace(upper, lower);
    EXPECT_NEAR(volume.value, expected, 1e-9 * expected) << x[0];
    EXPECT_NE(finding(volume.findings, "overturned_end"), nullptr) << x[0];
  }
}

TEST(OverturnedEnds, AHorizonThatASectionInTheMiddleLacksClosesTheBodyToo) {
  const Line upper = hairpin(300.0, 500.0), lower = hairpin(200.0, 500.0);
  const double expected = across * shoelace(upper, lower);
  EXPECT_NEAR(between(upper, lower, 1).value, expected, 1e-9 * expected);
}

TEST(OverturnedEnds, WhereTheBodyIsNotClosedTheVolumeIsToldToBeOff) {
  const auto volume = between(hairpin(300.0, 500.0), hairpin(200.0, 500.0), 2);
  const auto* told = finding(volume.findings, "overturned_end");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("is off"), std::string::npos) << told->message;
}

TEST(OverturnedEnds, AVolumeHearsThatItIsNotWantedAnyMore) {
  std::vector<loft::Section> sections = row(
      3, 1000.0, 400.0, [](double x, double) { return x; }, 10);
  for (auto& s : sections)
    add(s, "lower",
        sampled(
            s, [](double x, double) { return x - 10.0; }, 10));
  const auto made = through(std::move(sections));
  const base::CancelToken token;
  token.cancel();
  const auto volume = loft::volume_between(made.surfaces[0], made.surfaces[1], {}, base::Progress(token, {}));
  ASSERT_FALSE(volume);
  EXPECT_EQ(volume.error().code, base::ErrorCode::Cancelled);
}

TEST(OverturnedEnds, AFoldThatEndsOnUprightLimbsHasNone) {
  const std::array x{0.0, 2500.0, 1500.0, 4000.0};
  const auto volume = between(three_limbs(x, 0.0), three_limbs(x, 40.0));
  EXPECT_EQ(finding(volume.findings, "overturned_end"), nullptr);
  // Of vertical distance 40 m everywhere, over the map once.
  EXPECT_NEAR(volume.value, 40.0 * 4000.0 * across, 1e-6 * volume.value);
}

TEST(OverturnedEnds, ALimbThatStandsUprightAtItsEndIsNotOverturned) {
  const auto wall = [](double down) { return Line{{0.0, -down}, {2000.0, -down}, {2000.0, -500.0 - down}}; };
  EXPECT_EQ(finding(between(wall(0.0), wall(40.0)).findings, "overturned_end"), nullptr);
}

}  // namespace
}  // namespace dobra::test
