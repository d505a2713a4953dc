#include "recon/faults/cutoffs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/faults/displacement.h"
#include "recon/faults/report.h"
#include "tests/recon/faults/sections.h"

namespace recon::faults {
namespace {

using test::faulted;
using test::item;

struct Found {
  std::vector<Fault> faults;
  std::vector<FaultCutoffs> cutoffs;
};

Found found_in(const section::Section& section, double tolerance = 0.0) {
  auto faults = faults_of(section, {tolerance});
  EXPECT_TRUE(faults) << to_string(faults.error());
  Found found{*faults, {}};
  found.cutoffs = cutoffs_of(section, found.faults, {tolerance});
  return found;
}

bool tells_of(const FaultCutoffs& cutoffs, const std::string& text) {
  for (const std::string& remark : cutoffs.remarks) {
    if (remark.find(text) != std::string::npos) return true;
  }
  return false;
}

void expect_pair(const CutoffPair& pair, const std::string& horizon, geom::Point hanging, geom::Point foot) {
  EXPECT_EQ(pair.horizon, horizon);
  ASSERT_TRUE(pair.hanging_wall && pair.footwall);
  EXPECT_NEAR(geom::distance(pair.hanging_wall->at, hanging), 0.0, 1e-9);
  EXPECT_NEAR(geom::distance(pair.footwall->at, foot), 0.0, 1e-9);
}

TEST(Cutoffs, NormalFaultHasItsSlipOnBothBedsHoweverItIsTurned) {
  for (const double mirror : {1.0, -1.0}) {
    const Found found = found_in(test::normal_fault(100, mirror));
    ASSERT_EQ(found.cutoffs[0].pairs.size(), 2U);
    expect_pair(found.cutoffs[0].pairs[0], "A", {mirror * 600, -100}, {mirror * 500, 0});
    expect_pair(found.cutoffs[0].pairs[1], "B", {mirror * 900, -400}, {mirror * 800, -300});
    for (const CutoffPair& pair : found.cutoffs[0].pairs) {
      EXPECT_NEAR(*pair.separation, 100 * std::sqrt(2.0), 1e-9);
      EXPECT_NEAR(*pair.throw_, 100, 1e-9);
      EXPECT_NEAR(*pair.heave, 100, 1e-9);
      EXPECT_NEAR(*pair.gap, 100, 1e-9);
      EXPECT_EQ(*pair.overlap, 0.0);
    }
    EXPECT_NEAR(found.cutoffs[0].pairs[0].distance, 150 * std::sqrt(2.0), 1e-9);
    EXPECT_EQ(found.cutoffs[0].sense, Sense::Normal);
    EXPECT_TRUE(found.cutoffs[0].remarks.empty()) << found.cutoffs[0].remarks.front();
  }
}

TEST(Cutoffs, BedsThatRunPastTheFaultAtALowAngleAreTrimmed) {
  // A fault of 30 degrees; the ends are 4.5 m from it, but 9 m of each bed lie behind it.
  const double slope = std::tan(3.14159265358979323846 / 6);
  const auto on_fault = [&](double z) { return 1000 - z / slope; };
  const Found found = found_in(faulted({{"A/1", {{0, 0}, {on_fault(0) + 9, 0}}},
                                        {"A/2", {{on_fault(-100) - 9, -100}, {2000, -100}}},
                                        {"B/1", {{0, -300}, {on_fault(-300) + 9, -300}}},
                                        {"B/2", {{on_fault(-400) - 9, -400}, {2000, -400}}}},
                                       {item("F", {{on_fault(100), 100}, {on_fault(-600), -600}})}),
                               5.0);
  ASSERT_EQ(found.cutoffs[0].pairs.size(), 2U);
  for (const CutoffPair& pair : found.cutoffs[0].pairs) {
    ASSERT_TRUE(pair.separation);
    EXPECT_NEAR(*pair.separation, 200.0, 1e-9);
    EXPECT_NEAR(pair.hanging_wall->extended, -9.0, 1e-9);
    EXPECT_FALSE(pair.footwall->passes);
  }
  EXPECT_TRUE(tells_of(found.cutoffs[0], "trimmed by 9 m"));
}

TEST(Cutoffs, ThrustIsNegative) {
  for (const double mirror : {1.0, -1.0}) {
    const Found found = found_in(test::normal_fault(-80, mirror));
    ASSERT_EQ(found.cutoffs[0].pairs.size(), 2U);
    EXPECT_NEAR(*found.cutoffs[0].pairs[0].separation, -80 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(*found.cutoffs[0].pairs[0].throw_, -80, 1e-9);
    EXPECT_NEAR(*found.cutoffs[0].pairs[0].overlap, 80, 1e-9);
    EXPECT_EQ(found.cutoffs[0].sense, Sense::Reverse);
  }
}

TEST(Cutoffs, HangingWallSaidOtherwiseTurnsTheSigns) {
  section::Section section = test::normal_fault(100);
  section.lines[0].hanging_wall = section::HangingWall::Left;
  EXPECT_NEAR(*found_in(section).cutoffs[0].pairs[0].separation, -100 * std::sqrt(2.0), 1e-9);
}

TEST(Cutoffs, EndsNearTheFaultAreExtendedAndTrimmedAlongTheBed) {
  // The tolerance is 10 m; the bed is level, so that both meet the fault where the exact one does.
  for (const auto& [footwall, hanging, told] :
       {std::tuple(497.0, 604.0, "extended by 3 m"), std::tuple(506.0, 591.0, "trimmed by 6 m")}) {
    const auto section = faulted(
        {{"A/1", {{0, 0}, {footwall, 0}}}, {"A/2", {{hanging, -100}, {1500, -100}}}, {"B", {{0, -900}, {1500, -900}}}},
        {item("F", {{400, 100}, {1200, -700}})});
    const Found found = found_in(section, 10.0);
    ASSERT_EQ(found.cutoffs[0].pairs.size(), 1U);
    expect_pair(found.cutoffs[0].pairs[0], "A", {600, -100}, {500, 0});
    EXPECT_TRUE(tells_of(found.cutoffs[0], told)) << found.cutoffs[0].remarks.front();
  }
}

TEST(Cutoffs, ABedThatStopsFarShortIsNamedWithItsPlace) {
  const auto section =
      faulted({{"A/1", {{0, 0}, {465, 0}}}, {"A/2", {{600, -100}, {1500, -100}}}, {"B", {{0, -900}, {1500, -900}}}},
              {item("F", {{400, 100}, {1200, -700}})});
  const Found found = found_in(section, 10.0);
  ASSERT_EQ(found.cutoffs[0].pairs.size(), 1U);
  EXPECT_FALSE(found.cutoffs[0].pairs[0].footwall);
  EXPECT_FALSE(found.cutoffs[0].pairs[0].separation);
  EXPECT_TRUE(tells_of(found.cutoffs[0], "stops 25 m short of fault 'F' at (465, 0)"));
  EXPECT_TRUE(tells_of(found.cutoffs[0], "has no cutoff on the footwall of fault 'F' for the one at (600, -100)"));
}

TEST(Cutoffs, AToleranceIsAdvisedOnlyIfItReachesNoOtherBed) {
  const auto ending_at = [](double x, double other) {
    const auto section =
        faulted({{"A/1", {{0, 0}, {x, 0}}}, {"A/2", {{600, -100}, {1500, -100}}}, {"B", {{0, other}, {1500, other}}}},
                {item("F", {{400, 100}, {1200, -700}})});
    return found_in(section, 10.0).cutoffs[0];
  };
  EXPECT_TRUE(tells_of(ending_at(465, -900), "tolerance = 25 (--tolerance) takes it to the fault"));
  EXPECT_TRUE(tells_of(ending_at(465, -40), "stops 25 m short of fault 'F' at (465, 0); draw it to the fault"));
  EXPECT_FALSE(tells_of(ending_at(465, -40), "--tolerance"));
}

TEST(Cutoffs, APieceBehindWhichItsBedGoesOnDoesNotStopShort) {
  const auto section = faulted({{"A/1", {{0, 0}, {440, 0}}},
                                {"A/2", {{460, 0}, {500, 0}}},
                                {"A/3", {{600, -100}, {1500, -100}}},
                                {"B", {{0, -900}, {1500, -900}}}},
                               {item("F", {{400, 100}, {1200, -700}})});
  const Found found = found_in(section, 10.0);
  EXPECT_FALSE(tells_of(found.cutoffs[0], "short of fault"));
}

TEST(Cutoffs, AFaultThatCrossesItselfIsRefusedWithThePlace) {
  const std::vector<std::vector<geom::Point>> loops{
      {{400, 100}, {700, -200}, {760, -200}, {700, -260}, {640, -140}, {1200, -700}},  // a slip of the pen
      {{400, 100}, {900, -400}, {700, -200}, {1200, -700}},                            // back on itself
      {{400, 100}, {900, -400}, {900, 100}, {400, -400}}};                             // two faults in one
  for (const std::vector<geom::Point>& loop : loops) {
    const auto section = faulted({{"A", {{0, 0}, {1500, 0}}}, {"B", {{0, -900}, {1500, -900}}}}, {item("F", loop)});
    const auto refused = faults_of(section, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::ErrorCode::BadSection);
    EXPECT_NE(refused.error().message.find("the fault crosses itself"), std::string::npos);
    ASSERT_TRUE(refused.error().place);
    EXPECT_EQ(refused.error().place->item, "fault 'F'");
    EXPECT_TRUE(refused.error().place->x);
  }
}

TEST(Cutoffs, ABedThatRunsAcrossIsOnBothWallsAtOnePlaceAndTold) {
  const auto section =
      faulted({{"A", {{0, 0}, {1500, 0}}}, {"B", {{0, -900}, {1500, -900}}}}, {item("F", {{400, 100}, {1200, -700}})});
  const Found found = found_in(section);
  ASSERT_EQ(found.cutoffs[0].pairs.size(), 1U);
  expect_pair(found.cutoffs[0].pairs[0], "A", {500, 0}, {500, 0});
  EXPECT_TRUE(found.cutoffs[0].pairs[0].hanging_wall->passes);
  EXPECT_EQ(*found.cutoffs[0].pairs[0].separation, 0.0);
  EXPECT_TRUE(tells_of(found.cutoffs[0], "crosses fault 'F' at (500, 0) without being cut"));
  EXPECT_EQ(found.cutoffs[0].sense, Sense::None);
}

TEST(Cutoffs, ABedDrawnInOneLineAlongTheFaultHasBothCutoffs) {
  const auto section = faulted({{"A", {{0, 0}, {500, 0}, {600, -100}, {1500, -100}}}, {"B", {{0, -900}, {1500, -900}}}},
                               {item("F", {{400, 100}, {1200, -700}})});
  const Found found = found_in(section);
  ASSERT_EQ(found.cutoffs[0].pairs.size(), 1U);
  expect_pair(found.cutoffs[0].pairs[0], "A", {600, -100}, {500, 0});
}

TEST(Cutoffs, SeveralOnOneWallAreListedAndPairedFromAbove) {
  // A folded bed that meets the footwall twice and the hanging wall once.
  const auto section = faulted({{"A/1", {{0, 0}, {500, 0}}},
                                {"A/2", {{700, -200}, {550, -250}, {800, -300}}},
                                {"A/3", {{600, -100}, {1500, -100}}},
                                {"B", {{0, -900}, {1500, -900}}}},
                               {item("F", {{400, 100}, {1200, -700}})});
  const Found found = found_in(section);
  ASSERT_EQ(found.cutoffs[0].pairs.size(), 3U);
  expect_pair(found.cutoffs[0].pairs[0], "A", {600, -100}, {500, 0});
  EXPECT_FALSE(found.cutoffs[0].pairs[1].hanging_wall);
  EXPECT_TRUE(tells_of(found.cutoffs[0], "3 cutoffs on the footwall"));
}

TEST(Cutoffs, EndsThatMissTheFaultByTheRoundingOfAFileAreNotTold) {
  section::Section section = test::normal_fault(100);
  section.horizons[0].line.points.back().x -= 1e-5;
  section.horizons[2].line.points.back().x += 1e-5;
  EXPECT_TRUE(found_in(section).cutoffs[0].remarks.empty());
  section.horizons[0].line.points.back().x -= 1e-2;
  EXPECT_TRUE(tells_of(found_in(section).cutoffs[0], "extended by 0.01001 m"));
}

TEST(Faults, ThoseThatCrossWithoutOffsetAreToldUnlessTheirAgesSayWhichIsYounger) {
  const std::vector<test::NamedPoints> beds{{"A", {{0, 0}, {3000, 0}}}, {"B", {{0, -900}, {3000, -900}}}};
  const auto told = [&](input::FaultInput one, input::FaultInput other) {
    const auto report = report_faults(faulted(beds, {one, other}), {});
    EXPECT_TRUE(report) << to_string(report.error());
    return std::count_if(report->remarks.begin(), report->remarks.end(), [](const std::string& remark) {
      return remark.find("'F' and 'G' cross at (1500, -400)") != std::string::npos;
    });
  };
  input::FaultInput one = item("F", {{1000, 100}, {2000, -900}});
  input::FaultInput other = item("G", {{2000, 100}, {1000, -900}});
  EXPECT_EQ(told(one, other), 1);
  one.age = 1;
  EXPECT_EQ(told(one, other), 1);
  other.age = 1;
  EXPECT_EQ(told(one, other), 1);
  other.age = 2;
  EXPECT_EQ(told(one, other), 0);
  EXPECT_EQ(told(one, item("G", {{2000, 100}, {1500, -400}})), 0);  // it ends there
  EXPECT_EQ(told(one, item("G", {{2600, 100}, {2500, -900}})), 0);
}

TEST(Faults, AnUprightFaultHasNoHangingWallUntilItIsSaid) {
  section::Section section =
      faulted({{"A/1", {{0, 0}, {500, 0}}}, {"A/2", {{500, -40}, {900, -40}}}, {"B", {{0, -900}, {900, -900}}}},
              {item("F", {{500, 100}, {500, -1000}})});
  const Found silent = found_in(section);
  ASSERT_TRUE(silent.faults[0].undecided);
  EXPECT_NE(silent.faults[0].undecided->message.find("hanging_wall = \"left\""), std::string::npos);
  EXPECT_TRUE(silent.cutoffs[0].pairs.empty());
  section.lines[0].hanging_wall = section::HangingWall::Right;
  const Found said = found_in(section);
  EXPECT_FALSE(said.faults[0].undecided);
  EXPECT_NEAR(*said.cutoffs[0].pairs[0].throw_, 40, 1e-12);
  section.lines[0].hanging_wall = section::HangingWall::Above;
  EXPECT_FALSE(faults_of(section, {}));
}

TEST(Faults, ALevelFaultHasItsHangingWallAboveAndNoLeft) {
  section::Section section =
      faulted({{"A", {{0, 0}, {900, 0}}}, {"B", {{0, -900}, {900, -900}}}}, {item("D", {{1000, -500}, {-100, -500}})});
  const Found found = found_in(section);
  EXPECT_TRUE(found.faults[0].path.level);
  EXPECT_EQ(kinematics::wall_of(found.faults[0].path, {400, -400}), kinematics::Wall::Hanging);
  section.lines[0].hanging_wall = section::HangingWall::Left;
  EXPECT_FALSE(faults_of(section, {}));
}

TEST(Faults, ARampGoesOnAlongTheDetachmentThatItJoins) {
  const auto section =
      faulted({{"A", {{0, 0}, {3000, 0}}}, {"B", {{0, -900}, {3000, -900}}}},
              {item("D", {{-100, -500}, {1500, -510}, {3100, -500}}), item("R", {{1003, -505}, {1600, 100}})});
  const Found found = found_in(section);
  const Fault& ramp = **find_fault(found.faults, "R");
  EXPECT_EQ(ramp.lower.kind, EndKind::Branch);
  EXPECT_EQ(ramp.lower.on, "D");
  EXPECT_EQ(ramp.upper.kind, EndKind::Border);
  EXPECT_EQ(ramp.path.line.points.front(), geom::Point({-100, -500}));
  EXPECT_EQ(ramp.path.line.points.back(), geom::Point({1600, 100}));
  EXPECT_EQ(own_line(ramp).points.size(), 2U);
  EXPECT_EQ(own_line(ramp).points.front(), geom::Point({1003, -505}));
}

TEST(Faults, EndsInRockAreTips) {
  const auto section = faulted({{"A", {{0, 0}, {3000, 0}}}, {"B", {{0, -900}, {3000, -900}}}},
                               {item("F", {{500, -1000}, {1100, -400}})});
  const Found found = found_in(section);
  EXPECT_EQ(found.faults[0].lower.kind, EndKind::Border);
  EXPECT_EQ(found.faults[0].upper.kind, EndKind::Tip);
  EXPECT_TRUE(found.faults[0].path.tip_at_end);
}

TEST(Faults, PiecesThatMeetAreOneAndOthersStandAlone) {
  input::FaultInput upper = item("F/1", {{1000, 100}, {1300, -500}});
  input::FaultInput lower = item("F/2", {{1300, -500}, {1500, -1000}});
  upper.age = lower.age = 2;
  input::FaultInput cutter = item("G", {{0, -400}, {3100, -600}});
  const std::vector<test::NamedPoints> beds{{"A", {{0, 0}, {3000, 0}}}, {"B", {{0, -900}, {3000, -900}}}};
  cutter.age = 1;
  auto found = found_in(faulted(beds, {upper, lower}));
  ASSERT_EQ(found.faults.size(), 1U);
  EXPECT_EQ(found.faults[0].name, "F");
  EXPECT_EQ(found.faults[0].path.line.points.size(), 3U);
  // Moved apart by 200 m along the younger one.
  upper.points = {{1000, 100}, {1300, -483.870967741935}};
  lower.points = {{1500, -496.774193548387}, {1700, -1000}};
  found = found_in(faulted(beds, {upper, lower, cutter}));
  ASSERT_EQ(found.faults.size(), 3U);
  EXPECT_EQ(found.faults[0].name, "G");
  EXPECT_EQ(found.faults[1].name, "F/1");
  EXPECT_EQ(found.faults[1].lower.kind, EndKind::Cut);
  EXPECT_EQ(found.faults[2].upper.kind, EndKind::Cut);
  EXPECT_NE(find_fault(found.faults, "F").error().message.find("do not meet"), std::string::npos);
  EXPECT_EQ(find_fault(found.faults, "H").error().message,
            "the section has no fault 'H'; its faults are 'G', 'F/1', 'F/2'");
  // The other way round the ages contradict the cutting.
  cutter.age = 3;
  const auto refused = faults_of(faulted(beds, {upper, lower, cutter}), {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("correct order"), std::string::npos);
  EXPECT_TRUE(refused.error().place && refused.error().place->x);
}

FaultCutoffs profile_with(const std::vector<double>& separations) {
  FaultCutoffs cutoffs;
  for (std::size_t i = 0; i < separations.size(); ++i) {
    CutoffPair pair;
    pair.separation = separations[i];
    pair.distance = 100.0 * static_cast<double>(i);
    cutoffs.pairs.push_back(pair);
  }
  return cutoffs;
}

TEST(Displacement, SmoothProfilesHaveNoMarks) {
  for (const auto& separations :
       {std::vector<double>{10, 40, 60, 70, 60, 40, 10}, {70, 70.5, 69.8, 70}, {10, 20, 30, 40, 50}, {-10, -30, -20}}) {
    for (const ProfilePoint& point : profile_of(profile_with(separations)))
      EXPECT_EQ(point.mark, ProfileMark::None) << point.distance;
  }
}

TEST(Displacement, AStepOfThreeBedsIsMarkedWhereOnlyOneOfThemIsOff) {
  const auto mark = [](const std::vector<double>& separations, std::size_t at) {
    return profile_of(profile_with(separations))[at].mark;
  };
  EXPECT_EQ(mark({100, 100, 60}, 2), ProfileMark::Step);
  EXPECT_EQ(mark({100, 98, 70}, 2), ProfileMark::Step);
  EXPECT_EQ(mark({-100, -98, -70}, 2), ProfileMark::Step);
  EXPECT_EQ(mark({100, 98, 70}, 1), ProfileMark::None);
  EXPECT_EQ(mark({100, 60, 58}, 1), ProfileMark::Step);
  // No: it falls off evenly, or by less than a tenth, or as fast over a longer way.
  EXPECT_EQ(mark({100, 80, 60}, 2), ProfileMark::None);
  EXPECT_EQ(mark({100, 99, 92}, 2), ProfileMark::None);
  FaultCutoffs far = profile_with({100, 90, 50});
  far.pairs[2].distance = 500.0;
  EXPECT_EQ(profile_of(far)[2].mark, ProfileMark::None);
}

TEST(Displacement, StepsAndReversalsAreMarkedWhereTheyAre) {
  const auto step = profile_of(profile_with({10, 20, 30, 90, 100, 110}));
  EXPECT_EQ(step[3].mark, ProfileMark::Step);
  EXPECT_EQ(step[2].mark, ProfileMark::None);
  const auto dip = profile_of(profile_with({10, 40, 25, 70, 60}));
  EXPECT_EQ(dip[2].mark, ProfileMark::Reversal);
  const auto sign = profile_of(profile_with({60, 30, 10, -20}));
  EXPECT_EQ(sign[3].mark, ProfileMark::Reversal);
}

}  // namespace
}  // namespace recon::faults
