#include "recon/input/unit_gaps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "recon/input/input.h"
#include "tests/recon/shapes.h"

namespace recon::input {
namespace {

/// Units 100 m wide and 50 m thick; contours anticlockwise.
section::Section section_with(const std::vector<std::pair<std::string, std::vector<geom::Point>>>& units) {
  section::Section section;
  for (const auto& [name, points] : units)
    section.units.push_back({section::UnitId(section.units.size()), name, {points, true}, {}, {}});
  return section;
}

const std::vector<geom::Point> upper{{0, 0}, {100, 0}, {100, 50}, {0, 50}};
const std::vector<geom::Point> lower{{0, -60}, {100, -60}, {100, -10}, {0, -10}};

TEST(UnitGaps, AGapAlongAWholeContactIsToldWithBothNamesAndItsHeight) {
  const std::vector<std::string> told = wide_gaps(section_with({{"K2", lower}, {"K3", upper}}), 2.0);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].rfind("units 'K3' and 'K2' face each other over 100 m without an edge in common, 10 to 10 m", 0),
            0u)
      << told[0];
}

TEST(UnitGaps, AWedgeIsToldWithWhereItIsLeastHigh) {
  // 5 m at the left, 25 m at the right; places a two-hundredth of the width apart, from its half on.
  const std::vector<geom::Point> wedge{{0, -60}, {100, -60}, {100, -25}, {0, -5}};
  const std::vector<std::string> told = wide_gaps(section_with({{"K3", upper}, {"K2", wedge}}), 2.0);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("5.05 to 24.95 m apart, least at (0.25, 0)"), std::string::npos) << told[0];
}

TEST(UnitGaps, ANarrowUnitFacingTheMiddleOfAWideOneIsTold) {
  const std::vector<geom::Point> narrow{{30, -60}, {50, -60}, {50, -10}, {30, -10}};
  EXPECT_EQ(wide_gaps(section_with({{"K3", upper}, {"lens", narrow}}), 2.0).size(), 1u);
}

TEST(UnitGaps, WhatIsNoWideGapBetweenTwoUnitsIsNotTold) {
  const std::vector<geom::Point> touching{{0, -60}, {100, -60}, {100, 0}, {0, 0}};
  const std::vector<geom::Point> between{{0, -10}, {100, -10}, {100, 0}, {0, 0}};
  const std::vector<geom::Point> over{{0, -60}, {100, -60}, {100, 10}, {0, 10}};
  const std::vector<geom::Point> half{{0, -60}, {100, -60}, {100, -10}, {45, -10}, {40, 0}, {0, 0}};
  const std::vector<geom::Point> notch{{0, -60}, {100, -60}, {100, 0}, {60, 0}, {60, -9}, {30, -9}, {30, 0}, {0, 0}};
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", touching}}), 2.0).empty());
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", lower}}), 12.0).empty());  // bridged
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", between}, {"C", lower}}), 2.0).empty());
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", over}}), 2.0).empty());
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", over}}), 12.0).empty());
  EXPECT_TRUE(wide_gaps(section_with({{"A", upper}, {"B", notch}}), 2.0).empty());  // a notch, 30 of 100 m
  EXPECT_EQ(wide_gaps(section_with({{"A", upper}, {"B", half}}), 2.0).size(), 1u);  // 56 of 100 m
  section::Section faulted = section_with({{"A", upper}, {"B", lower}});
  faulted.lines.push_back({section::LineId(0), section::LineKind::Fault, "F", {{{-10, -4}, {110, -6}}, false}, {}});
  EXPECT_TRUE(wide_gaps(faulted, 2.0).empty());
}

TEST(UnitGaps, ASectionOfUnitsWithAWideGapReadsWithTheRemark) {
  SectionInput input;
  input.horizons_from_units = true;
  input.units = {test::item("K3", upper), test::item("K2", lower),
                 test::item("K1", {{0, -100}, {100, -100}, {100, -60}, {0, -60}})};
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(horizon_names(read->section), std::vector<std::string>{"K1"});
  EXPECT_TRUE(std::any_of(read->remarks.begin(), read->remarks.end(), [](const std::string& remark) {
    return remark.find("units 'K3' and 'K2' face each other") != std::string::npos;
  }));
}

}  // namespace
}  // namespace recon::input
