// What [input] and files say of faults and blocks.

#include <gtest/gtest.h>

#include "recon/input/import.h"
#include "tests/recon/shapes.h"

namespace recon::input {
namespace {

using dobra::io::lines::Feature;
using dobra::io::lines::FeatureType;

base::Result<ReadSection> read_faults(SectionInput input) {
  input.horizons = {test::item("A", {{0, 0}, {100, 0}})};
  return read_section(input, {}, {});
}

FaultInput fault_of(const char* name, const char* whole, int order) {
  FaultInput fault = test::item(name, {{0, 10}, {10, -10}});
  fault.piece_of = whole;
  if (order > 0) fault.age = order;
  return fault;
}

TEST(FaultInputs, AgesWallsPiecesAndBlocksReachTheSection) {
  SectionInput input;
  input.faults = {fault_of("F (1)", "F", 2), fault_of("F (2)", "F", 2), fault_of("G", "", 0)};
  input.faults[2].hanging_wall = section::HangingWall::Left;
  input.blocks = {{"graben", {5, -5}, "basin"}};
  input.y_axis = section::VerticalAxis::Down;
  const auto read = read_faults(input);
  ASSERT_TRUE(read) << to_string(read.error());
  const auto& lines = read->section.lines;
  EXPECT_EQ(whole_name(lines[0]), "F");
  EXPECT_EQ(lines[1].order, 2);
  EXPECT_EQ(lines[2].order, 0);
  EXPECT_EQ(lines[2].hanging_wall, section::HangingWall::Left);
  ASSERT_EQ(read->section.block_names.size(), 1U);
  EXPECT_EQ(read->section.block_names[0].at, geom::Point({5, 5}));
  EXPECT_EQ(read->section.block_names[0].part_of, "basin");
}

TEST(FaultInputs, ContradictionsAreRefused) {
  SectionInput input;
  input.faults = {fault_of("F (1)", "F", 2), fault_of("F (2)", "F", 1)};
  EXPECT_NE(to_string(read_faults(input).error()).find("another order or hanging_wall"), std::string::npos);
  input.faults = {fault_of("F", "", 1), fault_of("F (2)", "F", 1)};
  EXPECT_NE(to_string(read_faults(input).error()).find("which is a fault itself"), std::string::npos);
  input.faults.clear();
  input.blocks = {{"a", {1, 1}, ""}, {"a", {2, 2}, ""}};
  EXPECT_NE(to_string(read_faults(input).error()).find("two blocks have this name"), std::string::npos);
}

Feature line_called(const char* name, const char* kind) {
  Feature feature{FeatureType::Lines, {{{{0, 0}, {1, 1}}, false}}};
  feature.name = name;
  feature.kind = kind;
  return feature;
}

TEST(FaultInputs, FilesCarryThemAsProperties) {
  Feature fault = line_called("F (2)", "fault");
  fault.properties = {
      {"piece_of", std::string("F")}, {"order", std::int64_t{3}}, {"hanging_wall", std::string("left")}};
  Feature horizon = line_called("A (7)", "horizon");
  horizon.properties = {{"piece_of", std::string("A")}};
  const auto made = import_lines({fault, horizon});
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->lines[0].name, "F (2)");
  EXPECT_EQ(made->lines[0].piece_of, "F");
  EXPECT_EQ(made->lines[0].order, 3);
  EXPECT_EQ(made->lines[0].hanging_wall, section::HangingWall::Left);
  EXPECT_EQ(made->lines[1].name, "A (7)");
  EXPECT_EQ(made->lines[1].piece_of, "A");
  fault.properties[1].second = 1.5;
  EXPECT_FALSE(import_lines({fault}));
  fault.properties = {{"hanging_wall", std::string("east")}};
  EXPECT_FALSE(import_lines({fault}));
}

TEST(FaultInputs, FaultsOfOneNameArePiecesFromTheLeft) {
  Feature right = line_called("F", "fault");
  right.parts[0].points = {{50, 0}, {60, -10}};
  const auto made = import_lines({right, line_called("F", "fault"), line_called("F", "horizon")});
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->lines[0].name, "F (2)");
  EXPECT_EQ(made->lines[1].name, "F (1)");
  EXPECT_EQ(made->lines[1].piece_of, "F");
  EXPECT_EQ(made->lines[2].name, "F");  // the horizon
  EXPECT_EQ(made->lines[2].piece_of, "");
}

}  // namespace
}  // namespace recon::input
