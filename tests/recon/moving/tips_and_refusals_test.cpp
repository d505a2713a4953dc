// Tips that cut beds, faults at the end of a section, and what a move refuses: each with its place.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "recon/moving/move_section.h"
#include "shared/base/parallel.h"
#include "tests/recon/faults/sections.h"

namespace recon::moving {
namespace {

MoveParams move_of(MoveMethod method, double slip, const char* fault = "F") {
  MoveParams params;
  params.fault = fault;
  params.method = method;
  if (slip != 0.0) params.slip = slip;
  return params;
}

MoveParams to_close(MoveMethod method, std::vector<std::string> horizons) {
  MoveParams params = move_of(method, 0.0);
  params.close = std::move(horizons);
  return params;
}

/// Code, words and place, each "" or no place where that does not matter.
void expect_refused(const section::Section& section, const MoveParams& params, base::ErrorCode code,
                    const std::string& words, std::optional<geom::Point> place = std::nullopt) {
  const auto moved = move_block(section, params, {});
  ASSERT_FALSE(moved) << words;
  EXPECT_EQ(moved.error().code, code) << to_string(moved.error());
  EXPECT_NE(moved.error().message.find(words), std::string::npos) << to_string(moved.error());
  if (!place) return;
  const base::Place at = moved.error().place.value_or(base::Place());
  ASSERT_TRUE(at.x && at.y) << to_string(moved.error());
  EXPECT_NEAR(*at.x, place->x, 1e-6);
  EXPECT_NEAR(*at.y, place->y, 1e-6);
}

/// Beds over a ramp of 30 degrees whose tip is at (500, 500 tan 30) from the origin.
section::Section tip_inside() {
  const double rise = std::tan(3.14159265358979323846 / 6.0);
  return test::faulted({{"A", {{-2000, 250}, {3000, 250}}}, {"B", {{-2000, 400}, {3000, 400}}}},
                       {test::item("F", {{-1200, -1200 * rise}, {500, 500 * rise}})},
                       test::box(-2000, -700, 3000, 900));
}

MoveParams trishear_of(double slip, double propagation) {
  MoveParams params = move_of(MoveMethod::Trishear, slip);
  params.apical = base::Angle::from_degrees(50.0);
  params.propagation = propagation;
  return params;
}

TEST(MoveWithATip, BedsThatTheTipPassesFallIntoPiecesThatMeetAgain) {
  MoveParams forward = trishear_of(250.0, 2.0);
  forward.direction = Direction::Forward;
  const auto moved = move_block(tip_inside(), forward, {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  ASSERT_EQ(moved->section.horizons.size(), 4U);  // A was cut before, B is now
  const geom::Polyline& fault = moved->section.lines[0].line;
  ASSERT_EQ(fault.points.size(), 2U);  // it goes on straight, without a vertex where the tip was
  for (const section::Horizon& piece : moved->section.horizons) {
    // No piece runs along the fault.
    const double off =
        std::min(geom::distance(fault, piece.line.points.front()), geom::distance(fault, piece.line.points.back()));
    EXPECT_LT(off, 1e-6) << piece.name;
    const std::vector<geom::Point>& points = piece.line.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      EXPECT_GT(geom::distance(fault, geom::midpoint(points[i], points[i + 1])), 1e-8) << piece.name;
  }
  const auto back = move_block(moved->section, trishear_of(-250.0, 2.0), {});
  ASSERT_TRUE(back) << to_string(back.error());
  EXPECT_EQ(back->opened.gap, 0.0);
  EXPECT_EQ(back->opened.overlap, 0.0);
  for (const section::Horizon& piece : back->section.horizons) {
    for (const geom::Point p : piece.line.points)
      EXPECT_NEAR(p.y, whole_name(piece) == "A" ? 250.0 : 400.0, 2e-2) << piece.name;  // chords beside the cut
  }
  for (const Misfit& misfit : back->misfit) EXPECT_NEAR(misfit.along + misfit.gap + misfit.overlap, 0.0, 1e-6);
}

TEST(MoveWithATip, TheTipStaysInTheSection) {
  MoveParams forward = trishear_of(900.0, 3.0);
  forward.direction = Direction::Forward;
  const double rise = std::tan(3.14159265358979323846 / 6.0);
  expect_refused(tip_inside(), forward, base::ErrorCode::CannotRestore, "would leave the section at",
                 geom::Point{500, 500 * rise});
  expect_refused(tip_inside(), trishear_of(-700.0, 3.0), base::ErrorCode::CannotRestore, "smaller propagation");
}

TEST(MoveWithATip, AnEndThatLeavesTheSectionIsTakenForTheTipWithARemark) {
  const auto moved = move_block(test::normal_fault(100.0), trishear_of(50.0, 1.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  bool told = false;
  for (const std::string& remark : moved->remarks) told = told || remark.find("taken for its tip") != std::string::npos;
  EXPECT_TRUE(told);
  EXPECT_EQ(moved->opened.overlap, 0.0);
}

TEST(Move, ABedDrawnAlongTheFaultFromWallToWallLosesWhatIsOfTheFault) {
  section::Section section = test::normal_fault(100.0);
  section.horizons.clear();
  section.horizons.push_back({section::HorizonId(0), "A", {{{0, 0}, {500, 0}, {600, -100}, {1500, -100}}, false}, {}});
  section.horizons.push_back({section::HorizonId(1), "B", {{{0, -300}, {800, -300}}, false}, {}});
  section.horizons.push_back({section::HorizonId(2), "C", {{{900, -400}, {1500, -400}}, false}, {}});
  const auto moved = move_block(section, move_of(MoveMethod::Rigid, 100.0 * std::sqrt(2.0)), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  ASSERT_EQ(moved->section.horizons.size(), 4U);
  for (const section::Horizon& piece : moved->section.horizons) EXPECT_EQ(piece.line.points.size(), 2U) << piece.name;
  EXPECT_NEAR(moved->misfit[0].along, 0.0, 1e-9);
}

TEST(Move, AfterAForwardMoveOfASectionWithoutABorderTheFaultStillPartsIt) {
  for (const double mirror : {1.0, -1.0}) {
    const auto at = [&](double x, double z) { return geom::Point{mirror * x, z}; };
    const auto line = [&](std::vector<geom::Point> points) {
      if (mirror < 0.0) std::reverse(points.begin(), points.end());
      return points;
    };
    const section::Section section =
        test::faulted({{"A", line({at(-5000, 300), at(8000, 300)})}, {"B", line({at(-5000, 1200), at(8000, 1200)})}},
                      {test::item("F", {at(-5000, 0), at(0, 0), at(1374, 500), at(8000, 500)})});
    MoveParams forward = move_of(MoveMethod::FaultBendFold, 700.0);
    forward.direction = Direction::Forward;
    const auto thrust = move_block(section, forward, {});
    ASSERT_TRUE(thrust) << to_string(thrust.error());
    const auto back = move_block(thrust->section, to_close(MoveMethod::FaultBendFold, {"A"}), {});
    ASSERT_TRUE(back) << to_string(back.error());
    EXPECT_NEAR(back->motion.slip, -700.0, 1e-6);
  }
}

TEST(Move, PathsBeyondTheEndOfAFaultGoOnStraightWithARemark) {
  const auto moved = move_block(test::normal_fault(100.0), move_of(MoveMethod::FaultParallelFlow, 900.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  ASSERT_FALSE(moved->remarks.empty());
  EXPECT_NE(moved->remarks[0].find("beyond the higher end"), std::string::npos) << moved->remarks[0];
  EXPECT_EQ(moved->opened.gap + moved->opened.overlap, 0.0);
}

TEST(Move, SameBitsAtOneAndTwoThreads) {
  std::vector<section::Section> made;
  for (const unsigned threads : {1U, 2U}) {
    base::set_thread_count(threads);
    MoveParams params = to_close(MoveMethod::Shear, {"A", "B"});
    params.angle = base::Angle::from_degrees(12.0);
    const auto moved = move_block(test::normal_fault(77.7), params, {});
    ASSERT_TRUE(moved) << to_string(moved.error());
    made.push_back(moved->section);
    MoveParams forward = trishear_of(200.0, 1.5);
    forward.direction = Direction::Forward;
    made.push_back(move_block(tip_inside(), forward, {}).value().section);
  }
  base::set_thread_count(0);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(made[k].horizons.size(), made[k + 2].horizons.size());
    for (std::size_t i = 0; i < made[k].horizons.size(); ++i) {
      const auto& a = made[k].horizons[i].line.points;
      const auto& b = made[k + 2].horizons[i].line.points;
      ASSERT_EQ(a.size(), b.size());
      EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(geom::Point)), 0);
    }
  }
}

TEST(MoveRefusals, AFaultThatPartsNothingMovesNoBlockThatIsNamedEither) {
  const double rise = std::tan(3.14159265358979323846 / 6.0);
  for (const char* block : {"", "block 1"}) {
    MoveParams params = move_of(MoveMethod::Rigid, 50.0);
    if (*block != '\0') params.block = {block};
    expect_refused(tip_inside(), params, base::ErrorCode::BadSection, "parts no block", geom::Point{500, 500 * rise});
  }
}

TEST(MoveWithATip, ARigidBlockGoesAlongItsOwnFaultAndNotAlongWhatThatJoins) {
  // F dips 45 degrees; G, 60 degrees, joins it below the beds.
  const auto on_f = [](double z) { return 200.0 - z; };
  const auto on_g = [](double z) { return 700.0 + (100.0 - z) / std::sqrt(3.0); };
  const double junction = -(on_g(0) - 200.0) / (1.0 - 1.0 / std::sqrt(3.0));
  const section::Section section = test::faulted(
      {{"A/1", {{-2000, 0}, {on_f(0), 0}}},
       {"A/2", {{on_f(0), 0}, {on_g(0), 0}}},
       {"A/3", {{on_g(0), 0}, {4000, 0}}},
       {"B/1", {{-2000, -400}, {on_f(-400), -400}}},
       {"B/2", {{on_f(-400), -400}, {on_g(-400), -400}}},
       {"B/3", {{on_g(-400), -400}, {4000, -400}}}},
      {test::item("F", {{on_f(100), 100}, {on_f(-2500), -2500}}),
       test::item("G", {{on_g(100), 100}, {on_g(junction + 200.0), junction + 200.0}, {on_f(junction), junction}})});
  const auto moved = move_block(section, move_of(MoveMethod::Rigid, 40.0, "G"), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  ASSERT_EQ(moved->pieces.size(), 2U);
  for (const MovedPiece& piece : moved->pieces) {
    const geom::Point end = std::max(piece.after.points.front(), piece.after.points.back());
    EXPECT_NEAR(end.x, 4000.0 - 20.0, 1e-6) << piece.name;
    EXPECT_NEAR(std::remainder(end.y, 400.0), 40.0 * std::sqrt(0.75), 1e-6) << piece.name;
  }
}

TEST(MoveRefusals, AnUprightFaultUntilItsHangingWallIsSaid) {
  section::Section section =
      test::faulted({{"A/1", {{0, 0}, {500, 0}}}, {"A/2", {{500, -40}, {900, -40}}}, {"B", {{0, -900}, {900, -900}}}},
                    {test::item("F", {{500, 100}, {500, -1000}})});
  expect_refused(section, move_of(MoveMethod::Rigid, 40.0), base::ErrorCode::BadSection, "stands upright",
                 geom::Point{500, -450});
  section.lines[0].hanging_wall = section::HangingWall::Right;
  const auto moved = move_block(section, to_close(MoveMethod::Rigid, {"A"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  EXPECT_NEAR(moved->motion.slip, 40.0, 1e-9);
}

TEST(MoveRefusals, SeveralCutoffsOnAWallOnlyWhereSlipIsSolvedFromThem) {
  section::Section section = test::normal_fault(100.0);
  section.horizons.push_back({section::HorizonId(4), "A (3)", {{{700, -200}, {1500, -220}}, false}, {}, "A"});
  expect_refused(section, to_close(MoveMethod::Rigid, {"A"}), base::ErrorCode::BadSection, "(700, -200)");
  EXPECT_TRUE(move_block(section, to_close(MoveMethod::Rigid, {"B"}), {}));
  EXPECT_TRUE(move_block(section, move_of(MoveMethod::Shear, 50.0), {}));
}

TEST(MoveRefusals, CutoffsThatCannotMeetWithTheBestMisfit) {
  // A normal fault that is to be closed by a fold of a thrust.
  expect_refused(test::normal_fault(100.0), to_close(MoveMethod::FaultBendFold, {"A"}), base::ErrorCode::CannotRestore,
                 "141.4", geom::Point{500, 0});
  expect_refused(test::normal_fault(100.0), to_close(MoveMethod::FaultBendFold, {"A", "B"}),
                 base::ErrorCode::CannotRestore, "root mean square");
}

TEST(MoveRefusals, ShearAlongTheFaultAndFaultsThatFoldBackInIt) {
  MoveParams along = move_of(MoveMethod::Shear, 10.0);
  along.angle = base::Angle::from_degrees(-45.0);
  expect_refused(test::normal_fault(100.0), along, base::ErrorCode::CannotRestore, "direction of shear");
  section::Section folded = test::normal_fault(100.0);
  folded.lines[0].line.points = {{400, 100}, {900, -400}, {850, -700}, {1400, -900}};
  expect_refused(folded, move_of(MoveMethod::Shear, 10.0), base::ErrorCode::CannotRestore, "single-valued",
                 geom::Point{900, -400});
}

TEST(MoveRefusals, AgesThatContradictTheCutting) {
  section::Section section =
      test::faulted({{"A", {{0, 0}, {1500, 0}}}, {"B", {{0, -500}, {1500, -500}}}},
                    {test::item("F", {{400, 100}, {1200, -700}}), test::item("O/1", {{100, -600}, {700, -200}}),
                     test::item("O/2", {{800, -300}, {1400, 100}})});
  section.lines[0].order = 2;
  section.lines[1].order = section.lines[2].order = 1;
  expect_refused(section, move_of(MoveMethod::Rigid, 10.0), base::ErrorCode::BadSection, "not younger");
  section.lines[0].order = 1;
  section.lines[1].order = section.lines[2].order = 2;
  EXPECT_TRUE(move_block(section, move_of(MoveMethod::Rigid, 10.0), {}));
  expect_refused(section, move_of(MoveMethod::Rigid, 10.0, "O/1"), base::ErrorCode::BadSection,
                 "move on that one first");
}

TEST(MoveRefusals, PolygonsOfTheBlockThatLieOverTheRest) {
  input::SectionInput input;
  input.horizons = {test::item("A", {{0, 0}, {1500, 0}})};
  input.faults = {test::item("F", {{400, 100}, {1200, -700}})};
  input.borders = {test::item("border", test::box(0, -600, 1500, 100))};
  const auto unit = [&](const char* name, std::vector<geom::Point> points) {
    input.units.push_back(test::item(name, std::move(points)));
  };
  unit("east", {{900, -300}, {1400, -300}, {1400, -100}, {750, -100}, {900, -300}});
  unit("west", {{100, -300}, {980, -300}, {980, -250}, {100, -250}, {100, -300}});
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read) << to_string(read.error());
  const auto moved = move_block(read->section, move_of(MoveMethod::Rigid, 10.0), {});
  if (!moved) {
    EXPECT_EQ(moved.error().code, base::ErrorCode::BadSection);
    EXPECT_NE(moved.error().message.find("over each other"), std::string::npos) << to_string(moved.error());
  }
  EXPECT_FALSE(moved);
}

}  // namespace
}  // namespace recon::moving
