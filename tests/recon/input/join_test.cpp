#include "recon/input/join.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace recon::input {
namespace {

using testing::Contains;
using testing::HasSubstr;

void add_piece(const std::string& whole, int number, std::vector<geom::Point> points, section::Section& section) {
  section::Horizon piece;
  piece.id = section::HorizonId(section.horizons.size());
  piece.name = whole + " (" + std::to_string(number) + ")";
  piece.piece_of = whole;
  piece.line.points = std::move(points);
  section.horizons.push_back(std::move(piece));
}

/// Two beds in three pieces each; A has gaps of 0.5 and 0, B of 5 and 2 m.
section::Section three_blocks() {
  section::Section section;
  add_piece("A", 1, {{0, 0}, {50, 1}, {100, 0}}, section);
  add_piece("A", 2, {{100.3, 0.4}, {200, 0}}, section);
  add_piece("A", 3, {{200, 0}, {300, 2}}, section);
  add_piece("B", 1, {{0, -50}, {100, -50}}, section);
  add_piece("B", 2, {{104, -47}, {200, -50}}, section);
  add_piece("B", 3, {{202, -50}, {300, -50}}, section);
  return section;
}

JoinParams within(double tolerance) {
  JoinParams params;
  params.tolerance = tolerance;
  return params;
}

TEST(JoinPieces, EndsWithinTheToleranceBecomeOneLineUnderTheNameOfTheWhole) {
  const JoinedPieces joined = join_pieces(three_blocks(), within(1.0)).value();
  ASSERT_EQ(joined.section.horizons.size(), 4U);
  const section::Horizon& bed = joined.section.horizons[0];
  EXPECT_EQ(bed.name, "A");
  EXPECT_TRUE(bed.piece_of.empty());
  EXPECT_EQ(bed.id, section::HorizonId(0));
  const std::vector<geom::Point> line{{0, 0}, {50, 1}, {100, 0}, {100.3, 0.4}, {200, 0}, {300, 2}};
  EXPECT_EQ(bed.line.points, line);
  ASSERT_EQ(joined.joins.size(), 2U);
  EXPECT_NEAR(joined.joins[0].gap + joined.joins[1].gap, 0.5, 1e-12);
  EXPECT_TRUE(joined.section.faces);
  // B is as it was, and the remark says what it would take.
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(joined.section.horizons[i].name, three_blocks().horizons[i + 2].name);
    EXPECT_EQ(joined.section.horizons[i].line, three_blocks().horizons[i + 2].line);
  }
  EXPECT_THAT(joined.remarks, Contains(HasSubstr("horizon 'B' is still in 3 pieces; their nearest ends are 2 m apart, "
                                                 "at (200, -50)")));
}

TEST(JoinPieces, WhatIsLeftOfAPartlyJoinedHorizonKeepsNamesOfPieces) {
  const JoinedPieces joined = join_pieces(three_blocks(), within(3.0)).value();
  ASSERT_EQ(joined.section.horizons.size(), 3U);
  EXPECT_EQ(joined.section.horizons[1].name, "B (1)");
  EXPECT_EQ(joined.section.horizons[2].name, "B (2)");
  EXPECT_EQ(joined.section.horizons[2].piece_of, "B");
  EXPECT_EQ(joined.section.horizons[2].line.points.back(), geom::Point(300, -50));
}

TEST(JoinPieces, PiecesThatRunAgainstEachOtherComeOutFromLeftToRight) {
  section::Section section;
  add_piece("A", 2, {{300, 0}, {200, 1}, {100.1, 0}}, section);
  add_piece("A", 1, {{100, 0}, {0, 3}}, section);
  const JoinedPieces joined = join_pieces(section, {}).value();
  ASSERT_EQ(joined.section.horizons.size(), 1U);
  const std::vector<geom::Point> line{{0, 3}, {100, 0}, {100.1, 0}, {200, 1}, {300, 0}};
  EXPECT_EQ(joined.section.horizons[0].line.points, line);
}

TEST(JoinPieces, OnlyTheHorizonsAskedForAreJoinedAndOneThatIsNotThereIsRefused) {
  JoinParams params = within(10.0);
  params.horizon = {"B"};
  const JoinedPieces joined = join_pieces(three_blocks(), params).value();
  EXPECT_EQ(joined.section.horizons.size(), 4U);
  EXPECT_EQ(joined.section.horizons[3].name, "B");
  params.horizon = {"Bb"};
  const auto refused = join_pieces(three_blocks(), params);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::BadSection);
  EXPECT_THAT(refused.error().message, HasSubstr("no horizon 'Bb'"));
}

TEST(JoinPieces, PiecesThatOverlapAreRefusedWithThePlaceWhereTheyWouldCross) {
  section::Section section;
  add_piece("A", 1, {{0, 0}, {100, 2}, {110, -2}}, section);
  add_piece("A", 2, {{102, -2}, {104, 2}, {200, 0}}, section);
  const auto refused = join_pieces(section, within(20.0));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::BadSection);
  EXPECT_THAT(refused.error().message, HasSubstr("smaller tolerance"));
  ASSERT_TRUE(refused.error().place);
  EXPECT_NEAR(*refused.error().place->x, 103.0, 3.0);
}

TEST(JoinPieces, ASectionOfWholeHorizonsStaysAsItIs) {
  section::Section section;
  section.horizons.push_back({section::HorizonId(0), "A", {{{0, 0}, {1, 1}}, false}, {}});
  const JoinedPieces joined = join_pieces(section, {}).value();
  EXPECT_TRUE(joined.joins.empty());
  EXPECT_TRUE(joined.remarks.empty());
  EXPECT_EQ(joined.section.horizons[0].line, section.horizons[0].line);
}

}  // namespace
}  // namespace recon::input
