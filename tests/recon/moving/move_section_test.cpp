// Blocks moved along faults. Expectations are closed forms: sections with a known displacement, made by hand.

#include "recon/moving/move_section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <set>

#include "recon/faults/blocks.h"
#include "recon/faults/cutoffs.h"
#include "recon/section/section_faces.h"

namespace recon::moving {
namespace {

using section::LineKind;

/// A normal fault from (0, 0) down to (-1000, -1000), its hanging wall on the left, and two beds at z = -300 and -600
/// that it has brought down along itself by `down` m each in the hanging wall.
section::Section planar(double down = 100.0) {
  const double d = down / std::numbers::sqrt2;
  section::Section section;
  const auto bed = [&](const char* name, const char* whole, std::vector<geom::Point> points) {
    section.horizons.push_back(
        {section::HorizonId(section.horizons.size()), name, {std::move(points), false}, {}, whole});
  };
  bed("A (1)", "A", {{-2000, -300 - d}, {-1000, -300 - d}, {-300 - d, -300 - d}});
  bed("A (2)", "A", {{-300, -300}, {1000, -300}});
  bed("B (1)", "B", {{-2000, -600 - d}, {-600 - d, -600 - d}});
  bed("B (2)", "B", {{-600, -600}, {1000, -600}});
  section.lines.push_back({section::LineId(0), LineKind::Fault, "F", {{{0, 0}, {-1000, -1000}}, false}, {}});
  section.border = geom::Polyline{{{-2000, -1000}, {1000, -1000}, {1000, 0}, {-2000, 0}}, true};
  return section;
}

MoveParams params_of(MoveMethod method, std::optional<double> slip = std::nullopt) {
  MoveParams params;
  params.fault = "F";
  params.method = method;
  params.slip = slip;
  return params;
}

MoveParams closing(MoveMethod method, std::vector<std::string> horizons) {
  MoveParams params = params_of(method);
  params.close = std::move(horizons);
  return params;
}

const section::Horizon& horizon(const section::Section& section, const std::string& name) {
  const section::Horizon* found = find_horizon(section, name);
  if (found == nullptr) throw std::runtime_error("no horizon " + name);
  return *found;
}

bool same_bits(const geom::Polyline& a, const geom::Polyline& b) {
  return a.points.size() == b.points.size() &&
         std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof(geom::Point)) == 0;
}

double farthest(const geom::Polyline& a, const geom::Polyline& b) {
  if (a.points.size() != b.points.size()) return INFINITY;
  double most = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) most = std::max(most, geom::distance(a.points[i], b.points[i]));
  return most;
}

TEST(Move, AllMethodsOnAPlanarFaultCloseByTheDisplacementThatItHas) {
  for (const MoveMethod method :
       {MoveMethod::Rigid, MoveMethod::Shear, MoveMethod::FaultParallelFlow, MoveMethod::FlexuralSlip}) {
    SCOPED_TRACE(method_name(method));
    const section::Section section = planar();
    for (const auto& close : {std::vector<std::string>{"A"}, {"B"}, {"A", "B"}}) {
      const auto moved = move_block(section, closing(method, close), {});
      ASSERT_TRUE(moved) << to_string(moved.error());
      EXPECT_NEAR(moved->motion.slip, 100.0, 1e-9);
      ASSERT_EQ(moved->misfit.size(), 2U);
      for (const Misfit& misfit : moved->misfit) {
        EXPECT_NEAR(misfit.along, 0.0, 1e-9) << misfit.horizon;
        EXPECT_NEAR(misfit.gap + misfit.overlap, 0.0, 1e-9);
      }
      const geom::Polyline& a = horizon(moved->section, "A (1)").line;
      EXPECT_NEAR(a.points.front().y, -300.0, 1e-9);
      EXPECT_LT(geom::distance(a.points.back(), {-300, -300}), 1e-9);
      EXPECT_TRUE(same_bits(horizon(moved->section, "A (2)").line, section.horizons[1].line));
      EXPECT_TRUE(same_bits(horizon(moved->section, "B (2)").line, section.horizons[3].line));
      EXPECT_TRUE(same_bits(moved->section.lines[0].line, section.lines[0].line));
      EXPECT_NEAR(moved->opened.gap, 0.0, 1e-6);
      EXPECT_NEAR(moved->opened.overlap, 0.0, 1e-6);
    }
  }
}

/// As planar(), with an older fault O in the hanging wall, between whose sides B is offset: its upper piece ends on O,
/// `short_of` m along it from F, and its lower piece on F.
section::Section planar_with_an_older_fault(double short_of) {
  section::Section section = planar();
  const geom::Vector along = geom::normalised(geom::Vector{-1000, -300});
  const geom::Point on_f{-600, -600};
  const geom::Point end = on_f + short_of * along;
  section.horizons[2].line.points = {{-2000, end.y}, end};
  const double low = -600 - 100.0 / std::numbers::sqrt2;
  section.horizons.push_back(
      {section::HorizonId(4), "B (3)", {{{on_f.x + (low - on_f.y) / 0.3, low}, {low, low}}, false}, {}, "B"});
  section.lines[0].order = 1;
  section.lines.push_back({section::LineId(1), LineKind::Fault, "O", {{on_f + 1400 * along, on_f}, false}, {}});
  section.lines[1].order = 2;
  return section;
}

TEST(Move, TellsTheSamePairsAsFaultsAndThoseThatBelongTogether) {
  for (const double short_of : {6.0, 11.0, 100.0}) {
    SCOPED_TRACE(short_of);
    const section::Section section = planar_with_an_older_fault(short_of);
    const auto moved = move_block(section, closing(MoveMethod::Rigid, {"A"}), {});
    ASSERT_TRUE(moved) << to_string(moved.error());
    ASSERT_EQ(moved->misfit.size(), 2U);
    for (const Misfit& misfit : moved->misfit) EXPECT_NEAR(misfit.along, 0.0, 1e-9) << misfit.horizon;
    const auto faults = faults::faults_of(section, {});
    ASSERT_TRUE(faults);
    for (const faults::CutoffPair& pair : faults::cutoffs_at(section, *faults, 0, {}).pairs) {
      ASSERT_TRUE(pair.separation) << pair.horizon;
      EXPECT_NEAR(*pair.separation, 100.0, 1e-9);
    }
  }
}

/// Three beds, C to E, offset by a thrust O and then by a normal fault F, both parted as a forward model left them: the
/// ends lie beside F by their last bits, so that nothing encloses the upper sheet of the hanging wall.
section::Section of_a_forward_model() {
  section::Section section;
  const auto bed = [&](const char* name, const char* whole, std::vector<geom::Point> points) {
    section.horizons.push_back(
        {section::HorizonId(section.horizons.size()), name, {std::move(points), false}, {}, whole});
  };
  const auto fault = [&](const char* name, const char* whole, int order, std::vector<geom::Point> points) {
    section.lines.push_back(
        {section::LineId(section.lines.size()), LineKind::Fault, name, {std::move(points), false}, whole});
    section.lines.back().order = order;
  };
  bed("C (1)", "C", {{-1676.923076923077, -65.38461538461539}, {43.90532544378699, -65.38461538461539}});
  bed("D (1)", "D", {{-1676.923076923077, -365.38461538461536}, {90.05917159763314, -365.38461538461536}});
  bed("E (1)", "E", {{-1676.923076923077, -665.3846153846154}, {-396.9230769230769, -665.3846153846154}});
  bed("C (2)", "C", {{750.4114368507883, -397.67433953012346}, {2030.4114368507883, -397.67433953012346}});
  bed("D (2)", "D", {{0.0, -500.0}, {110.76923076923079, -500.0}});
  bed("E (2)", "E", {{-720.0, -800.0}, {156.92307692307693, -800.0}});
  bed("C (3)", "C", {{74.31676229457521, -263.0589549147388}, {1073.4883599277114, -263.0589549147388}});
  bed("D (3)", "D", {{120.47060844842136, -563.0589549147388}, {353.4883599277113, -563.0589549147388}});
  bed("D (4)", "D", {{141.180667620019, -697.6743395301235}, {2030.4114368507883, -697.6743395301235}});
  bed("E (3)", "E", {{187.33451377386515, -997.6743395301235}, {2030.4114368507883, -997.6743395301235}});
  fault("O (1)", "O", 2, {{-1200.0, -1000.0}, {104.09638554216869, -456.6265060240964}});
  fault("F", "", 1, {{203.0769230769231, -1100.0}, {3.07692307692308, 200.0}});
  fault("O (2)", "O", 2, {{134.5078223929569, -654.3008455542199}, {1230.4114368507883, -197.67433953012346}});
  return section;
}

TEST(Move, ABedOfTheHangingWallThatNoBlockHoldsIsTold) {
  section::Section section = of_a_forward_model();
  const auto told = [&] {
    MoveParams params = params_of(MoveMethod::Rigid, 200.0);
    const auto moved = move_block(section, params, {});
    EXPECT_TRUE(moved) << to_string(moved.error());
    return moved && std::any_of(moved->remarks.begin(), moved->remarks.end(), [](const std::string& remark) {
             return remark.find("horizon 'C (3)' ends in the hanging wall of fault 'F'") != std::string::npos;
           });
  };
  EXPECT_FALSE(told());
  std::erase_if(section.horizons, [](const section::Horizon& horizon) { return horizon.name == "D (3)"; });
  section.horizons[6].line.points.back().x = 800.0;
  EXPECT_TRUE(told());  // what C (3) lay on is gone, and the rock between them
  section.border = geom::Polyline{{{-2000, -1050}, {2100, -1050}, {2100, 100}, {-2000, 100}}, true};
  EXPECT_FALSE(told());
  section = planar();
  EXPECT_FALSE(told());
}

TEST(Move, BlocksMovedBackOneAfterTheOtherStayWholeWithoutABorder) {
  // Four blocks between faults of 60 degrees, drawn to the millimetre as in a file; the faults are closed in any order.
  std::mt19937 random(7);
  for (int draw = 0; draw < 12; ++draw) {
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto rounded = [](double x, double z) {
      return geom::Point{1e-3 * std::round(1e3 * x), 1e-3 * std::round(1e3 * z)};
    };
    const auto wall = [](int k, double z) { return 800.0 * k - z / std::numbers::sqrt3; };
    section::Section section;
    std::vector<double> areas;
    double down = 0.0;
    for (int block = 0; block < 4; ++block) {
      if (block > 0) down += number(20.0, 180.0);
      double widths = 0.0;
      for (int bed = 0; bed < 4; ++bed) {
        const double z = -150.0 * bed - down;
        const double from = block == 0 ? 0.0 : wall(block, z), to = block == 3 ? 4000.0 : wall(block + 1, z);
        const std::string whole(1, static_cast<char>('A' + bed));
        section.horizons.push_back({section::HorizonId(section.horizons.size()),
                                    whole + std::to_string(block),
                                    {{rounded(from, z), rounded(0.5 * (from + to), z), rounded(to, z)}, false},
                                    {},
                                    whole});
        widths += (bed == 0 || bed == 3 ? 0.5 : 1.0) * (to - from);
      }
      areas.push_back(150.0 * widths);
    }
    std::vector<std::string> names{"F1", "F2", "F3"};
    for (int k = 1; k < 4; ++k) {
      section.lines.push_back({section::LineId(section.lines.size()),
                               LineKind::Fault,
                               names[static_cast<std::size_t>(k - 1)],
                               {{rounded(wall(k, 200), 200), rounded(wall(k, -1500), -1500)}, false},
                               {}});
    }
    std::shuffle(names.begin(), names.end(), random);
    for (const std::string& fault : names) {
      MoveParams params = closing(MoveMethod::Rigid, {"A"});
      params.fault = fault;
      auto moved = move_block(section, params, {});
      ASSERT_TRUE(moved) << draw << ' ' << fault << ": " << to_string(moved.error());
      section = std::move(moved->section);
      const auto faults = faults::faults_of(section, {});
      ASSERT_TRUE(faults) << to_string(faults.error());
      const auto blocks = faults::Blocks::make(section, *faults, {});
      ASSERT_TRUE(blocks) << to_string(blocks.error());
      ASSERT_EQ(blocks->all().size(), 4U) << draw << ' ' << fault;
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(blocks->all()[i].area, areas[i], 1e-4 * areas[i]) << draw;
    }
    for (const section::Horizon& horizon : section.horizons)
      EXPECT_NEAR(horizon.line.points.front().y, -150.0 * (horizon.piece_of[0] - 'A'), 0.01) << draw << horizon.name;
  }
}

TEST(Move, AStubOfABedShorterThanTheToleranceMovesWithItsBlock) {
  // 10 m of B lie beside the fault in the hanging wall, then a gap of 60 m; the stub begins a hair past the fault.
  section::Section section = planar(100.0);
  section.border.reset();
  const double d = 100.0 / std::numbers::sqrt2;
  section.horizons[2].line.points = {{-2000, -600 - d}, {-670 - d, -600 - d}};
  section.horizons.push_back(
      {section::HorizonId(9), "B (3)", {{{-610 - d, -600 - d}, {-600 - d + 2e-4, -600 - d}}, false}, {}, "B"});
  const auto moved = move_block(section, closing(MoveMethod::Rigid, {"A"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  const geom::Polyline stub = horizon(moved->section, "B (3)").line;
  EXPECT_NEAR(stub.points.front().x, -610.0, 1e-6);
  EXPECT_NEAR(stub.points.front().y, -600.0, 1e-6);
  EXPECT_NEAR(stub.points.back().x, -600.0, 1e-3);
}

TEST(Move, OfBlocksThatAreNamedTheMisfitIsWhatTheyLeave) {
  // Two faults with 100 m each: the block between them lies in the footwall of the second one.
  section::Section section = planar(100.0);
  const double d = 100.0 / std::numbers::sqrt2;
  section.horizons.erase(section.horizons.begin() + 1);  // A (2) and B (2) are cut again at x = 400
  section.horizons.erase(section.horizons.begin() + 2);
  const auto bed = [&](const char* name, const char* whole, std::vector<geom::Point> points) {
    section.horizons.push_back(
        {section::HorizonId(20 + section.horizons.size()), name, {std::move(points), false}, {}, whole});
  };
  bed("A (2)", "A", {{-300, -300}, {400, -300}});
  bed("A (3)", "A", {{400 + d, -300 + d}, {1000, -300 + d}});
  bed("B (2)", "B", {{-600, -600}, {100, -600}});
  bed("B (3)", "B", {{100 + d, -600 + d}, {1000, -600 + d}});
  section.lines.push_back({section::LineId(1), LineKind::Fault, "G", {{{700, 0}, {-300, -1000}}, false}, {}});
  const auto blocks = faults::Blocks::make(section, faults::faults_of(section, {}).value(), {}).value();
  MoveParams params = closing(MoveMethod::Rigid, {"A"});
  for (const double x : {-1500.0, 0.0, 900.0}) {  // hanging wall, between, footwall of both
    params.block = {blocks.all()[blocks.at({x, -350}).index()].name};
    const auto moved = move_block(section, params, {});
    ASSERT_TRUE(moved) << to_string(moved.error());
    const double left = x < -1000.0 ? 0.0 : x < 100.0 ? 200.0 : 100.0;  // m along F
    EXPECT_EQ(moved->whole_wall, x < -1000.0);
    for (const Misfit& misfit : moved->misfit) EXPECT_NEAR(std::abs(misfit.along), left, 1e-6) << x << misfit.horizon;
  }
}

TEST(Move, FurtherPiecesHaveIdsThatNothingElseHas) {
  section::Section section = planar();
  section.horizons.push_back({section::HorizonId(5), "C", {{{-2000, -900}, {1000, -900}}, false}, {}, {}});
  const auto moved = move_block(section, closing(MoveMethod::Rigid, {"A"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  std::set<section::HorizonId> ids;
  for (const section::Horizon& horizon : moved->section.horizons) ids.insert(horizon.id);
  EXPECT_EQ(moved->section.horizons.size(), 6U);
  EXPECT_EQ(ids.size(), 6U);
}

TEST(Move, APieceWithoutAPartnerIsToldAndTheOtherIsPaired) {
  section::Section section = planar();
  // A second sheet of B above the first, which the hanging wall alone has.
  section.horizons.push_back({section::HorizonId(4), "B (3)", {{{-2000, -500}, {-500, -500}}, false}, {}, "B"});
  const auto moved = move_block(section, closing(MoveMethod::Rigid, {"A"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  ASSERT_EQ(moved->misfit.size(), 2U);
  for (const Misfit& misfit : moved->misfit) EXPECT_NEAR(misfit.along, 0.0, 1e-9) << misfit.horizon;
  EXPECT_EQ(std::count(moved->remarks.begin(), moved->remarks.end(),
                       "horizon 'B' has no cutoff on the footwall of fault 'F' for the one at (-500, -500)"),
            1);
  const auto unsure = move_block(section, closing(MoveMethod::Rigid, {"B"}), {});
  ASSERT_FALSE(unsure);
  EXPECT_NE(to_string(unsure.error()).find("several cutoffs"), std::string::npos);
}

TEST(Move, HeaveAndThrowAreThoseOfTheHangingWallAndOneSignRaisesIt) {
  const section::Section section = planar();
  const double diagonal = 1.0 / std::numbers::sqrt2;
  for (const MoveMethod method : {MoveMethod::Rigid, MoveMethod::Shear, MoveMethod::FaultParallelFlow}) {
    for (const double sign : {1.0, -1.0}) {
      MoveParams heave = params_of(method);
      heave.heave = sign * 100.0 * diagonal;
      MoveParams upward = params_of(method);
      upward.throw_ = sign * 100.0 * diagonal;
      for (const MoveParams& params : {heave, upward, params_of(method, sign * 100.0)}) {
        const auto moved = move_block(section, params, {});
        ASSERT_TRUE(moved) << to_string(moved.error());
        EXPECT_NEAR(moved->motion.slip, sign * 100.0, 1e-9);
        const geom::Point end = horizon(moved->section, "A (1)").line.points.back();
        const double down = 100.0 - sign * 100.0;
        EXPECT_NEAR(end.x, -300.0 - down * diagonal, 1e-9) << method_name(method);
        EXPECT_NEAR(end.y, -300.0 - down * diagonal, 1e-9) << method_name(method);
      }
    }
  }
}

TEST(Move, OfAFaultThatDipsTheOtherWayTheHangingWallRisesTowardsTheOtherSide) {
  section::Section section = planar();
  const auto mirror = [](geom::Polyline& line) {
    for (geom::Point& p : line.points) p.x = -p.x;
    line = geom::reversed(line);
  };
  for (section::Horizon& h : section.horizons) mirror(h.line);
  for (section::SectionLine& l : section.lines) mirror(l.line);
  mirror(*section.border);
  const auto moved = move_block(section, closing(MoveMethod::Shear, {"A"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  EXPECT_NEAR(moved->motion.slip, 100.0, 1e-9);
  EXPECT_LT(geom::distance(horizon(moved->section, "A (1)").line.points.front(), {300, -300}), 1e-9);
}

TEST(Move, TwoHorizonsThatCannotBothMeetAreClosedInTheMean) {
  section::Section section = planar();
  for (geom::Point& p : section.horizons[2].line.points) p.y -= 60.0;  // B is 60 m lower, along the fault too
  section.horizons[2].line.points.back().x -= 60.0;
  const auto moved = move_block(section, closing(MoveMethod::Rigid, {"A", "B"}), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  const double more = 60.0 * std::numbers::sqrt2;
  EXPECT_NEAR(moved->motion.slip, 100.0 + 0.5 * more, 1e-9);
  EXPECT_NEAR(moved->misfit[0].along, -0.5 * more, 1e-9);
  EXPECT_NEAR(moved->misfit[1].along, 0.5 * more, 1e-9);
}

/// Beds that nothing has cut yet, with a fold in them, a marker, a pin, a polygon and an older fault on both sides.
section::Section uncut() {
  section::Section section = planar(0.0);
  section.horizons.clear();
  geom::Polyline bed;
  for (int i = 0; i <= 60; ++i) bed.points.push_back({-2000.0 + 50.0 * i, -310.0 + 40.0 * std::sin(0.3 * i)});
  section.horizons.push_back({section::HorizonId(0), "A", bed, {}});
  section.horizons.push_back({section::HorizonId(1), "B", {{{-2000, -605}, {1000, -611}}, false}, {}});
  section.horizons.push_back({section::HorizonId(2), "east", {{{200, -200}, {1000, -210}}, false}, {}});
  section.lines.push_back({section::LineId(1), LineKind::Fault, "G", {{{-1500, -900}, {-100, -500}}, false}, {}});
  section.lines.back().order = 2;
  section.lines.front().order = 1;
  section.lines.push_back({section::LineId(2), LineKind::Datum, "sea", {{{-2000, 0}, {1000, 0}}, false}, {}});
  section.units.push_back(
      {section::UnitId(0), "Q", {{{-1500, -850}, {500, -850}, {500, -700}, {-1500, -700}}, true}, {}});
  section.units.push_back({section::UnitId(1), "R", {{{0, -950}, {500, -950}, {500, -900}, {0, -900}}, true}, {}});
  section.markers.push_back({section::MarkerId(0), "picks", {{-900.5, -200.25}, {500.125, -200.5}}, {}});
  return section;
}

TEST(Move, WhatLiesOutsideTheBlockKeepsItsBitsAndTheWayBackIsExact) {
  const section::Section section = uncut();
  const auto moved = move_block(section, params_of(MoveMethod::Shear, -137.3), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  const section::Section& after = moved->section;
  EXPECT_TRUE(same_bits(horizon(after, "east").line, section.horizons[2].line));
  EXPECT_TRUE(same_bits(after.lines[2].line, section.lines[2].line));
  EXPECT_TRUE(same_bits(after.units[1].contour, section.units[1].contour));
  EXPECT_EQ(after.markers[0].points[1], section.markers[0].points[1]);
  EXPECT_NE(after.markers[0].points[0], section.markers[0].points[0]);
  const geom::Polyline& rest = horizon(after, "A (2)").line;
  EXPECT_EQ(rest.points.back(), section.horizons[0].line.points.back());
  EXPECT_EQ(std::memcmp(&rest.points[1], &section.horizons[0].line.points[61 - rest.points.size() + 1],
                        (rest.points.size() - 1) * sizeof(geom::Point)),
            0);
  const auto back = move_block(after, params_of(MoveMethod::Shear, 137.3), {});
  ASSERT_TRUE(back) << to_string(back.error());
  const geom::Polyline& home = horizon(back->section, "A (1)").line;
  for (const geom::Point p : home.points) EXPECT_LT(geom::distance(section.horizons[0].line, p), 1e-9);
  EXPECT_LT(geom::distance(home.points.front(), section.horizons[0].line.points.front()), 1e-9);
  EXPECT_LT(geom::distance(back->section.markers[0].points[0], section.markers[0].points[0]), 1e-9);
}

TEST(Move, LinesAndPolygonsAcrossTheFaultFallIntoPiecesOfOneWhole) {
  const section::Section section = uncut();
  const auto moved = move_block(section, params_of(MoveMethod::Rigid, -100.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  const section::Section& after = moved->section;
  ASSERT_EQ(after.horizons.size(), 5U);
  for (const char* name : {"A (1)", "A (2)", "B (1)", "B (2)"})
    EXPECT_EQ(whole_name(horizon(after, name)), std::string(1, name[0]));
  EXPECT_EQ(after.horizons[3].id, section::HorizonId(3));
  ASSERT_EQ(after.lines.size(), 4U);
  EXPECT_EQ(after.lines[1].name, "G (1)");
  EXPECT_EQ(after.lines[3].piece_of, "G");
  EXPECT_EQ(after.lines[3].order, 2);
  ASSERT_EQ(after.units.size(), 3U);
  EXPECT_EQ(after.units[2].piece_of, "Q");
  double area = geom::signed_area(after.units[0].contour) + geom::signed_area(after.units[2].contour);
  EXPECT_NEAR(area, 2000.0 * 150.0, 1e-6);
  EXPECT_NEAR(moved->units[0].area_after, moved->units[0].area_before, 1e-6);
  // A rigid block: every piece that moved is the same line, 100 m down the fault.
  const double d = 100.0 / std::numbers::sqrt2;
  geom::Polyline expected = section.horizons[1].line;
  const double x = (-605.0 + 2000.0 * -6.0 / 3000.0) / (1.0 + 6.0 / 3000.0);  // z = x meets the bed
  expected.points.back() = {x, x};
  for (geom::Point& p : expected.points) p = {p.x - d, p.y - d};
  EXPECT_LT(farthest(horizon(after, "B (1)").line, expected), 1e-9);
  for (const balance::LineLength& row : moved->lengths) EXPECT_NEAR(row.length_after, row.length_before, 1e-9);
}

TEST(Move, PointsAndLinesAreCarriedThereAndBack) {
  const section::Section section = uncut();
  const auto moved = move_block(section, params_of(MoveMethod::FaultParallelFlow, -80.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  for (const geom::Point p : {geom::Point{-900, -300}, geom::Point{400, -300}, geom::Point{-1900, -20}})
    EXPECT_LT(geom::distance(moved->inverse(moved->forward(p)), p), 1e-9);
  EXPECT_EQ(moved->forward(geom::Point{400, -300}), (geom::Point{400, -300}));
  const geom::Polyline line{{{-1200, -400}, {500, -400}}, false};
  const geom::Polyline there = moved->forward(line);
  ASSERT_EQ(there.points.size(), 4U);  // it jumps at the fault
  EXPECT_LT(geom::distance(there.points[2], {-400, -400}), 1e-9);
  EXPECT_NEAR(geom::distance(there.points[1], there.points[2]), 80.0, 1e-9);
}

TEST(Move, AHorizonThatReachesALittleAcrossTheFaultIsTrimmedWhereItMoves) {
  section::Section section = planar();
  section.horizons[0].line.points.back().x += 8.0;   // of the hanging wall, into the footwall
  section.horizons[3].line.points.front().x -= 8.0;  // of the footwall, into the hanging wall
  const auto moved = move_block(section, params_of(MoveMethod::Rigid, 100.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  EXPECT_EQ(moved->section.horizons.size(), 4U);
  EXPECT_LT(geom::distance(horizon(moved->section, "A (1)").line.points.back(), {-300, -300}), 1e-9);
  EXPECT_TRUE(same_bits(horizon(moved->section, "B (2)").line, section.horizons[3].line));
}

TEST(Move, ARigidBlockOnABentFaultTellsWhatItOpensAndWhere) {
  section::Section section = planar(0.0);
  section.horizons.clear();
  section.horizons.push_back({section::HorizonId(0), "A", {{{-2000, -100}, {1000, -100}}, false}, {}});
  section.lines[0].line.points = {{0, 0}, {-500, -600}, {-1500, -1000}};
  const auto moved = move_block(section, params_of(MoveMethod::Rigid, -100.0), {});
  ASSERT_TRUE(moved) << to_string(moved.error());
  // The chord of both legs is shifted along itself: the triangle over the chord, less itself moved, on both sides of
  // the bend. Brute force: the area between both lines, column by column.
  const geom::Vector by = (100.0 / std::hypot(1500.0, 1000.0)) * geom::Vector{-1500, -1000};
  const auto height = [](double x) { return x < -500.0 ? -600.0 + (x + 500.0) * 0.4 : x * 1.2; };
  double gap = 0.0, overlap = 0.0;
  const double low = -1500.0, high = by.x, step = 1e-3;
  for (double x = low + 0.5 * step; x < high; x += step) {
    const double up = height(x - by.x) + by.y - height(x);
    (up > 0.0 ? gap : overlap) += std::abs(up) * step;
  }
  EXPECT_GT(gap + overlap, 1000.0);
  EXPECT_NEAR(moved->opened.gap, gap, 0.02 * gap + 2000.0);
  EXPECT_GT(moved->opened.gap + moved->opened.overlap, 0.9 * (gap + overlap));
}

TEST(Move, RefusesWhatCannotBeDoneWithThePlace) {
  const auto refused = [](const section::Section& section, const MoveParams& params, base::ErrorCode code,
                          const char* words) {
    const auto moved = move_block(section, params, {});
    ASSERT_FALSE(moved) << words;
    EXPECT_EQ(moved.error().code, code) << to_string(moved.error());
    EXPECT_NE(moved.error().message.find(words), std::string::npos) << to_string(moved.error());
  };
  const section::Section section = planar();
  MoveParams both = params_of(MoveMethod::Rigid, 10.0);
  both.heave = 10.0;
  refused(section, both, base::ErrorCode::BadValue, "several");
  refused(section, params_of(MoveMethod::Shear), base::ErrorCode::BadValue, "none");
  MoveParams useless = params_of(MoveMethod::FaultParallelFlow, 10.0);
  useless.angle = base::Angle::from_degrees(10.0);
  refused(section, useless, base::ErrorCode::BadValue, "no use for it");
  MoveParams pivot = params_of(MoveMethod::Rigid);
  pivot.angle = base::Angle::from_degrees(10.0);
  refused(section, pivot, base::ErrorCode::BadValue, "pivot");
  refused(section, closing(MoveMethod::Rigid, {"C"}), base::ErrorCode::BadSection, "'C'");
  section::Section alone = section;
  alone.horizons.erase(alone.horizons.begin() + 1);
  refused(alone, closing(MoveMethod::Rigid, {"A"}), base::ErrorCode::BadSection, "no cutoff on the footwall");
  MoveParams along = params_of(MoveMethod::Shear, 10.0);
  along.angle = base::Angle::from_degrees(45.0);
  refused(section, along, base::ErrorCode::CannotRestore, "direction");
  MoveParams towards = params_of(MoveMethod::Rigid, 10.0);
  towards.towards = Towards::PlusX;
  refused(section, towards, base::ErrorCode::BadValue, "level");
  section::Section tip = section;
  tip.lines[0].line.points.back() = {-700, -700};
  refused(tip, params_of(MoveMethod::Rigid, 10.0), base::ErrorCode::BadSection, "parts no");
  section::Section level = section;
  level.lines[0].line.points = {{-2000, -800}, {1000, -800}};
  refused(level, params_of(MoveMethod::Rigid, 10.0), base::ErrorCode::BadValue, "--towards");
}

}  // namespace
}  // namespace recon::moving
