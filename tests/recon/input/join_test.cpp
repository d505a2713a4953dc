#include "recon/input/join.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/recon/faults/sections.h"

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

// --- faults between pieces

using testing::AllOf;
using testing::Not;

/// Beds at 0, -200, -400 and -600, parted by a fault of 45 degrees through (500, 0) that dips to +x; the hanging wall
/// has gone along it by `slip(bed)` metres. Picks stop `short_of` metres before the fault, along the bed.
section::Section cut_beds(const std::function<double(int)>& slip, double short_of = 0.0) {
  section::Section section;
  for (int bed = 0; bed < 4; ++bed) {
    const std::string name(1, static_cast<char>('A' + bed));
    const double z = -200.0 * bed, x = 500.0 + 200.0 * bed, by = slip(bed) / std::sqrt(2.0);
    add_piece(name, 1, {{0, z}, {0.5 * x, z}, {x - short_of, z}}, section);
    add_piece(name, 2, {{x + by + short_of, z - by}, {1500, z - by}, {2500, z - by}}, section);
  }
  section::SectionLine fault;
  fault.id = section::LineId(0);
  fault.name = "F";
  fault.line.points = {{300, 200}, {1400, -900}};
  section.lines.push_back(fault);
  return section;
}

TEST(JoinPieces, BedsThatAFaultStillDisplacesAreNotJoinedWhateverTheToleranceAndItIsToldWithPlaceAndSeparation) {
  for (const double short_of : {0.0, 8.0}) {
    for (const double slip : {100.0, -100.0, 20.0}) {
      const auto section = cut_beds([&](int) { return slip; }, short_of);
      const JoinedPieces joined = join_pieces(section, within(150.0)).value();
      EXPECT_TRUE(joined.joins.empty());
      EXPECT_EQ(joined.section.horizons.size(), 8U);
      EXPECT_THAT(joined.remarks,
                  Contains(AllOf(HasSubstr("horizon 'A': the ends of two pieces at ("), HasSubstr("are not joined"),
                                 HasSubstr("fault 'F' lies between them and still displaces the bed by " +
                                           std::to_string(static_cast<int>(std::abs(slip))) + " m"))))
          << short_of << ' ' << slip;
    }
  }
}

TEST(JoinPieces, BedsThatMeetAtAFaultAreJoinedAlsoWhereTheirPicksStopShortOfIt) {
  for (const double short_of : {0.0, 3.0, 8.0, 40.0}) {
    const auto section = cut_beds([](int) { return 0.0; }, short_of);
    const JoinedPieces joined = join_pieces(section, within(150.0)).value();
    EXPECT_EQ(joined.joins.size(), 4U) << short_of;
    EXPECT_EQ(joined.section.horizons.size(), 4U) << short_of;
  }
}

TEST(JoinPieces, WhatAMoveThatClosedOneBedLeavesOpenInTheOthersIsJoinedAndToldButNotALargePartOfTheNextBed) {
  // A is closed; B, C and D miss each other by 3, -2 and 4 m of 283 m to the next bed along the fault.
  const auto misfit = [](double greatest) {
    return [=](int bed) { return std::vector<double>{0.0, 3.0, -2.0, greatest}[static_cast<std::size_t>(bed)]; };
  };
  const JoinedPieces small = join_pieces(cut_beds(misfit(4.0)), within(150.0)).value();
  EXPECT_EQ(small.joins.size(), 4U);
  EXPECT_THAT(small.remarks, Contains(HasSubstr("across fault 'F', along which its cutoffs are 3 m apart")));
  const JoinedPieces large = join_pieces(cut_beds(misfit(60.0)), within(150.0)).value();
  EXPECT_EQ(large.joins.size(), 3U);
  EXPECT_THAT(large.remarks, Contains(HasSubstr("still displaces the bed by 60 m")));
}

TEST(JoinPieces, PiecesThatNoFaultPartsAreJoinedBesideADisplacedFault) {
  section::Section section = cut_beds([](int) { return 100.0; });
  section::Horizon& left = section.horizons[0];  // A (1) falls into two, 20 m apart
  left.line.points = {{0, 0}, {240, 0}};
  add_piece("A", 3, {{260, 0}, {500, 0}}, section);
  const JoinedPieces joined = join_pieces(section, within(150.0)).value();
  ASSERT_EQ(joined.joins.size(), 1U);
  EXPECT_NEAR(joined.joins[0].gap, 20.0, 1e-12);
}

TEST(JoinPieces, JoinsAroundTheTipOfAFaultAreNoneAcrossIt) {
  section::Section section = cut_beds([](int) { return 0.0; });
  section.lines[0].line.points = {{900, -400}, {1400, -900}};  // begins at C: A and B pass above it
  section.horizons[0].line.points.back() = {490, 6};
  const JoinedPieces joined = join_pieces(section, within(20.0)).value();
  EXPECT_EQ(joined.joins.size(), 4U);
}

// --- pieces that overlap

/// The line goes on to the right from point to point.
bool goes_on(const section::Horizon& horizon) {
  for (std::size_t i = 1; i < horizon.line.points.size(); ++i) {
    if (horizon.line.points[i].x <= horizon.line.points[i - 1].x) return false;
  }
  return true;
}

TEST(JoinPieces, PiecesOfWhichOneRunsOverTheOtherAreNotJoinedAndToldWithThePlace) {
  for (const double above : {0.5, 4.0, 10.0}) {
    section::Section section;
    add_piece("A", 1, {{0, 0}, {50, 0}, {100, 0}}, section);
    add_piece("A", 2, {{70, above}, {110, above}, {200, above}}, section);
    const JoinedPieces joined = join_pieces(section, within(60.0)).value();
    EXPECT_TRUE(joined.joins.empty());
    EXPECT_THAT(joined.remarks, Contains(AllOf(HasSubstr("(100, 0)"), HasSubstr("are not joined: the pieces overlap by "
                                                                                "30 m"))));
  }
}

TEST(JoinPieces, EndsThatPassEachOtherALittleMeetHalfway) {
  section::Section section;
  add_piece("A", 1, {{0, 0}, {50, 0}, {100, 0}}, section);
  add_piece("A", 2, {{99, 6}, {150, 6}, {200, 6}}, section);
  const JoinedPieces joined = join_pieces(section, within(20.0)).value();
  ASSERT_EQ(joined.joins.size(), 1U);
  EXPECT_TRUE(goes_on(joined.section.horizons[0]));
  const std::vector<geom::Point> line{{0, 0}, {50, 0}, {99.5, 3}, {150, 6}, {200, 6}};
  EXPECT_EQ(joined.section.horizons[0].line.points, line);
}

TEST(JoinPieces, OnAFaultThatIsTakenBackTheLineDoesNotTurnBackEither) {
  // The hanging wall has come back a little too far: its end overlaps that of the footwall.
  const auto section = cut_beds([](int bed) { return bed == 0 ? 0.0 : -3.0; });
  const JoinedPieces joined = join_pieces(section, within(20.0)).value();
  EXPECT_EQ(joined.joins.size(), 4U);
  for (const section::Horizon& bed : joined.section.horizons) EXPECT_TRUE(goes_on(bed)) << bed.name;
}

TEST(JoinPieces, GapsOfTheInputAreJoinedByTheSameRule) {
  input::SectionInput input;
  for (const section::Horizon& piece : cut_beds([](int) { return 100.0; }).horizons) {
    input.horizons.push_back(test::item(piece.name, piece.line.points));
    input.horizons.back().piece_of = piece.piece_of;
    input.horizons.back().join_gaps = 150.0;
  }
  input.faults = {test::item("F", {{300, 200}, {1400, -900}})};
  const ReadSection displaced = read_section(input, {}, {}).value();
  EXPECT_EQ(displaced.section.horizons.size(), 8U);
  EXPECT_THAT(displaced.remarks, Contains(HasSubstr("still displaces the bed by 100 m")));
  input.faults.clear();
  EXPECT_EQ(read_section(input, {}, {}).value().section.horizons.size(), 4U);
}

}  // namespace
}  // namespace recon::input
