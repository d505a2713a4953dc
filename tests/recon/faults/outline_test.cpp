#include "recon/faults/outline.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recon/faults/blocks.h"
#include "tests/recon/faults/sections.h"

namespace recon::faults {
namespace {

using test::faulted;
using test::item;
using test::NamedPoints;

struct Shown {
  std::vector<double> areas;  ///< Of the blocks, from the left, m2.
  std::vector<std::string> remarks;
};

Shown blocks_in(const section::Section& section) {
  const auto faults = faults_of(section, {});
  EXPECT_TRUE(faults) << to_string(faults.error());
  const auto blocks = Blocks::make(section, *faults, {});
  EXPECT_TRUE(blocks) << to_string(blocks.error());
  Shown shown;
  for (const Block& block : blocks->all()) shown.areas.push_back(block.area);
  shown.remarks = blocks->remarks_on_beds(section);
  return shown;
}

/// Level beds at 0, -200 and -400 in two walls of a fault that dips 60 degrees to +x; the hanging wall lies 150 down.
/// Pieces of a bed stop where the fault cuts them.
double fault_x(double z) { return 500.0 - z / std::sqrt(3.0); }
const std::vector<input::FaultInput> normal{item("F", {{fault_x(100), 100}, {fault_x(-900), -900}})};
constexpr double drop = 150.0;
NamedPoints left_piece(const std::string& name, double z, double from = 0.0, double to = -1.0) {
  return {name, {{from, z}, {to < 0.0 ? fault_x(z) : to, z}}};
}
NamedPoints right_piece(const std::string& name, double z, double from = -1.0, double to = 2000.0) {
  return {name, {{from < 0.0 ? fault_x(z - drop) : from, z - drop}, {to, z - drop}}};
}
const double left_area = 400.0 * 0.5 * (fault_x(0) + fault_x(-400));
const double right_area = 400.0 * (2000.0 - 0.5 * (fault_x(-150) + fault_x(-550)));

/// Between its first and its last point a piece is cut, and the cut parts stand `gap` apart.
std::vector<NamedPoints> with_gap(std::vector<NamedPoints> beds, const std::string& piece, double at, double gap) {
  std::vector<NamedPoints> made;
  for (const NamedPoints& bed : beds) {
    if (bed.first != piece) {
      made.push_back(bed);
      continue;
    }
    const double z = bed.second.front().y;
    made.push_back({piece, {bed.second.front(), {at, z}}});
    made.push_back({piece + "b", {{at + gap, z}, bed.second.back()}});
  }
  return made;
}

const std::vector<NamedPoints> whole{left_piece("A/1", 0),     right_piece("A/2", 0),   left_piece("B/1", -200),
                                     right_piece("B/2", -200), left_piece("C/1", -400), right_piece("C/2", -400)};

TEST(RockOutline, GapsOfBedsLeaveTheBlocksWhole) {
  const Shown tidy = blocks_in(faulted(whole, normal));
  ASSERT_EQ(tidy.areas.size(), 2U);
  EXPECT_NEAR(tidy.areas[0], left_area, 1e-6 * left_area);
  EXPECT_NEAR(tidy.areas[1], right_area, 1e-6 * right_area);
  EXPECT_TRUE(tidy.remarks.empty());
  for (const double gap : {1e-9, 0.5, 5.0, 150.0}) {
    for (const std::vector<std::string>& cut : std::vector<std::vector<std::string>>{
             {"A/1"}, {"C/1"}, {"A/2"}, {"C/2"}, {"A/1", "C/1"}, {"A/1", "A/2", "B/1", "C/1", "C/2"}}) {
      std::vector<NamedPoints> beds = whole;
      for (const std::string& piece : cut) beds = with_gap(beds, piece, piece.back() == '1' ? 230.0 : 1300.0, gap);
      const Shown open = blocks_in(faulted(beds, normal));
      ASSERT_EQ(open.areas.size(), 2U) << cut[0] << ' ' << gap;
      EXPECT_NEAR(open.areas[0], left_area, 1e-6 * left_area) << cut[0] << ' ' << gap;
      EXPECT_NEAR(open.areas[1], right_area, 1e-6 * right_area) << cut[0] << ' ' << gap;
      if (gap > 1.0 && cut.size() == 1) {
        ASSERT_EQ(open.remarks.size(), 1U) << cut[0] << ' ' << gap;
        const geom::Point at{(cut[0].back() == '1' ? 230.0 : 1300.0) + 0.5 * gap, 0.0};
        EXPECT_NE(open.remarks[0].find(fmt::format("open at ({:.6g}", at.x)), std::string::npos) << open.remarks[0];
      }
    }
  }
}

TEST(RockOutline, AFaultThatEndsAboveTheLowestBedsPartsThem) {
  // The fault is drawn down to -450 only: the lowest bed of the hanging wall, at -550, ends in line with it.
  const std::vector<input::FaultInput> shallow{item("F", {{fault_x(100), 100}, {fault_x(-450), -450}})};
  const Shown shown = blocks_in(faulted(whole, shallow));
  ASSERT_EQ(shown.areas.size(), 2U);
  EXPECT_NEAR(shown.areas[0], left_area, 1e-4 * left_area);
  EXPECT_NEAR(shown.areas[1], right_area, 1e-4 * right_area);
}

TEST(RockOutline, AHighestBedThatStopsFarShortOfTheFaultLosesNoMoreThanItsCorner) {
  std::vector<NamedPoints> beds = whole;
  beds[0] = left_piece("A/1", 0, 0.0, 200.0);  // 300 m short
  const Shown shown = blocks_in(faulted(beds, normal));
  ASSERT_EQ(shown.areas.size(), 2U);
  // What is certain: the triangle between the end of the bed, and the cutoffs of the next one and its own is missing.
  const double corner = 0.5 * 300.0 * 200.0;
  EXPECT_NEAR(shown.areas[0], left_area - corner, 1e-6 * left_area);
  EXPECT_NEAR(shown.areas[1], right_area, 1e-6 * right_area);
  const bool told = std::any_of(shown.remarks.begin(), shown.remarks.end(),
                                [](const std::string& r) { return r.find("open at") != std::string::npos; });
  EXPECT_TRUE(told);
}

TEST(RockOutline, AirStaysAir) {
  // The highest bed is left as two hills, whose slopes end on the bed below; between them lies no rock.
  const std::vector<NamedPoints> hills{{"A/1", {{0, 0}, {150, 0}, {300, -200}}},
                                       {"A/2", {{1600, -200}, {1700, 0}, {2000, 0}}},
                                       {"B", {{0, -200}, {2000, -200}}},
                                       {"C", {{0, -400}, {2000, -400}}}};
  const double known = 0.5 * 200.0 * (150.0 + 300.0) + 0.5 * 200.0 * (300.0 + 400.0) + 200.0 * 2000.0;
  const std::vector<input::FaultInput> none{item("F", {{500, -900}, {600, -800}})};  // below all beds
  const Shown shown = blocks_in(faulted(hills, none));
  ASSERT_EQ(shown.areas.size(), 1U);
  EXPECT_NEAR(shown.areas[0], known, 1e-6 * known);
  // A gap in the lowest bed opens the rock above it: that is closed, the valley is not.
  const Shown open = blocks_in(faulted(
      {hills[0], hills[1], hills[2], {"C/1", {{0, -400}, {900, -400}}}, {"C/2", {{940, -400}, {2000, -400}}}}, none));
  ASSERT_EQ(open.areas.size(), 1U);
  EXPECT_NEAR(open.areas[0], known, 1e-6 * known);
  EXPECT_THAT(open.remarks, testing::SizeIs(1));
}

TEST(RockOutline, AnOverturnedTopHasNoRockOverIt) {
  // The top leans over itself; the air under its overhang faces the same bed.
  const std::vector<geom::Point> top{{0, 0},     {900, 0},    {900, 300}, {600, 300},
                                     {600, 400}, {1000, 400}, {1000, 0},  {2000, 0}};
  const std::vector<NamedPoints> beds{{"A", top}, {"B", {{0, -200}, {2000, -200}}}};
  const double known = 2000.0 * 200.0 + 100.0 * 400.0 + 300.0 * 100.0;
  const Shown shown = blocks_in(faulted(beds, {item("F", {{500, -900}, {600, -800}})}));
  ASSERT_EQ(shown.areas.size(), 1U);
  EXPECT_NEAR(shown.areas[0], known, 1e-6 * known);
  EXPECT_TRUE(shown.remarks.empty());
}

TEST(RockOutline, WhatTheLinesLeaveOpenToDoubtIsTold) {
  const auto told = [](const section::Section& section, const std::string& what) {
    for (const std::string& remark : blocks_in(section).remarks) {
      if (remark.find(what) != std::string::npos) return true;
    }
    return false;
  };
  // A middle bed that is not drawn to the section's side: the straight sides cut a triangle of 300 m by 400 m / 2 out.
  std::vector<NamedPoints> beds = whole;
  EXPECT_FALSE(told(faulted(beds, normal), "inside the section's side"));
  beds[2] = left_piece("B/1", -200, 300.0);
  EXPECT_TRUE(told(faulted(beds, normal), "'B/1' ends 300 m inside the section's side at (300, -200)"));
  EXPECT_TRUE(told(faulted(beds, normal), "leave out 60000 m2"));
  // Two faults that cross above a horst close air off.
  const std::vector<NamedPoints> horst{{"A/1", {{0, -100}, {400, -100}}},    {"A/2", {{500, 0}, {700, 0}}},
                                       {"A/3", {{800, -100}, {1200, -100}}}, {"B/1", {{0, -300}, {200, -300}}},
                                       {"B/2", {{300, -200}, {900, -200}}},  {"B/3", {{1000, -300}, {1200, -300}}}};
  const std::vector<input::FaultInput> crossing{item("F", {{650, 150}, {50, -450}}),
                                                item("G", {{550, 150}, {1150, -450}})};
  EXPECT_TRUE(told(faulted(horst, crossing), "over horizon 'A/2' 10000 m2 count as rock"));
}

TEST(RockOutline, AFaultThatRunsPastTheOneItEndsOnMakesNoBlockOfItsOwn) {
  for (const double past : {0.0, 3.0, 8.0}) {
    const std::vector<NamedPoints> plain{{"A", {{0, 0}, {1000, 0}}}, {"B", {{0, -400}, {1000, -400}}}};
    const Shown shown = blocks_in(
        faulted(plain, {item("F", {{50, 50}, {600, -500}}), item("G", {{650, 50}, {350 - past, -250 - past}})}));
    ASSERT_EQ(shown.areas.size(), 3U) << past;
    // Over G's foot at (350, -250): the triangle between both faults and the top.
    EXPECT_NEAR(*std::min_element(shown.areas.begin(), shown.areas.end()), 0.5 * 500.0 * 250.0, 20.0) << past;
  }
}

TEST(RockOutline, DominoesDrawnInShortPiecesKeepTheirBlocks) {
  // Four blocks between faults of 60 degrees, four beds, dropped by known amounts; each piece of a bed is drawn in up
  // to ten parts with gaps of up to 8 m between them, and stops up to 5 m short of the faults.
  std::mt19937 random(20);
  for (int draw = 0; draw < 40; ++draw) {
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const std::vector<double> drops{0.0, number(20, 180), number(20, 180), number(20, 180)};
    const auto wall = [&](std::size_t k, double z) { return 800.0 * static_cast<double>(k) - z / std::sqrt(3.0); };
    std::vector<NamedPoints> beds;
    std::vector<double> known(4, 0.0);
    double down = 0.0;
    for (std::size_t block = 0; block < 4; ++block) {
      down += drops[block];
      std::vector<double> widths;
      for (int bed = 0; bed < 4; ++bed) {
        const double z = -150.0 * bed - down;
        const double from = block == 0 ? 0.0 : wall(block, z), to = block == 3 ? 4000.0 : wall(block + 1, z);
        widths.push_back(to - from);
        const int parts = 1 + static_cast<int>(number(0, 9.99));
        double x = from + (block == 0 ? 0.0 : number(0, 5));
        const double last = to - (block == 3 ? 0.0 : number(0, 5));
        const double step = (last - x) / parts;
        for (int part = 0; part < parts; ++part) {
          const double end = part + 1 == parts ? last : x + step - number(0, 8);
          const std::string name = fmt::format("{}/{}-{}", static_cast<char>('A' + bed), block, part);
          beds.push_back({name, {{x, z}, {end, z}}});
          x += step;
        }
      }
      for (int bed = 0; bed < 3; ++bed) known[block] += 150.0 * 0.5 * (widths[bed] + widths[bed + 1]);
    }
    std::vector<input::FaultInput> faults;
    for (std::size_t k = 1; k < 4; ++k)
      faults.push_back(item(fmt::format("F{}", k), {{wall(k, 200), 200}, {wall(k, -1500), -1500}}));
    const Shown shown = blocks_in(faulted(beds, faults));
    ASSERT_EQ(shown.areas.size(), 4U) << draw;
    for (std::size_t block = 0; block < 4; ++block)
      EXPECT_NEAR(shown.areas[block], known[block], 1e-3 * known[block]) << draw << ' ' << block;
  }
}

}  // namespace
}  // namespace recon::faults
