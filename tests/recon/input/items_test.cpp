#include "recon/input/items.h"

#include <gtest/gtest.h>

#include "tests/recon/shapes.h"

namespace recon::input {
namespace {

using test::item;

SectionInput one_horizon() {
  SectionInput input;
  input.horizons = {item("top", {{0, 0}, {100, 10}})};
  return input;
}

base::Error error_of(const SectionInput& input) {
  const auto read = read_section(input, {}, {});
  EXPECT_FALSE(read);
  return read ? base::Error{base::ErrorCode::Cancelled, ""} : read.error();
}

TEST(Items, FaultsPinsPolygonsAndMarkersHaveIdsAndNames) {
  SectionInput input = one_horizon();
  input.faults = {item("F1", {{10, 0}, {20, -50}}), item("F2", {{30, 0}, {40, -50}})};
  input.pins = {item("pin", {{0, 10}, {0, -60}})};
  input.loose_lines = {item("end", {{100, 10}, {100, -60}})};
  input.units = {item("sand", {{0, 0}, {100, 0}, {100, -20}, {0, -20}})};
  input.markers = {item("well", {{50, -10}}), item("picks", {{1, -1}, {2, -2}})};
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read) << to_string(read.error());
  const section::Section& section = read->section;
  ASSERT_EQ(section.lines.size(), 4u);
  EXPECT_EQ(section.lines[1].name, "F2");
  EXPECT_EQ(section.lines[2].kind, section::LineKind::Pin);
  EXPECT_EQ(section.lines[3].kind, section::LineKind::Loose);
  EXPECT_EQ(section.lines[3].id, section::LineId(3));
  ASSERT_EQ(section.units.size(), 1u);
  EXPECT_EQ(geom::signed_area(section.units[0].contour), 2000.0);  // clockwise as given, anticlockwise as held
  ASSERT_EQ(section.markers.size(), 2u);
  EXPECT_EQ(section.markers[0].points.size(), 1u);
  EXPECT_EQ(section.markers[1].points.size(), 2u);
}

TEST(Items, APolygonThatDoesNotCloseIsRefusedWithItsPlace) {
  SectionInput input = one_horizon();
  input.units = {item("sand", {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {30, -5}})};
  const base::Error error = error_of(input);
  EXPECT_NE(error.message.find("does not close"), std::string::npos);
  EXPECT_EQ(error.place->item, "unit 'sand'");
  EXPECT_EQ(*error.place->x, 30.0);
  EXPECT_EQ(*error.place->y, -5.0);
}

TEST(Items, APolygonThatCrossesItselfIsRefusedWithItsPlace) {
  SectionInput input = one_horizon();
  input.units = {item("bow", {{0, 0}, {10, 10}, {10, 0}, {0, 10}})};
  const base::Error error = error_of(input);
  EXPECT_NE(error.message.find("crosses"), std::string::npos);
  EXPECT_NEAR(*error.place->x, 5.0, 1e-12);
}

TEST(Items, MetresAndKilometresMixedAreRefusedWithTheHorizon) {
  SectionInput input;
  input.horizons = {item("top", {{0, 0}, {12000, 100}}), item("base", {{0, -1}, {12.1, -1.2}})};
  const base::Error error = error_of(input);
  EXPECT_NE(error.message.find("kilometres"), std::string::npos);
  EXPECT_EQ(error.place->item, "horizon 'base'");
}

TEST(Items, TheSameNameTwiceInAKindIsRefused) {
  SectionInput input = one_horizon();
  input.faults = {item("F", {{0, 0}, {1, 1}}), item("F", {{2, 0}, {3, 1}})};
  EXPECT_EQ(error_of(input).place->item, "fault 'F'");
}

}  // namespace
}  // namespace recon::input
