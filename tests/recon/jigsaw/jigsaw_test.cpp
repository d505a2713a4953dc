// Sections that are restored block by block, against blocks that the test has cut and moved itself.

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <numbers>
#include <random>

#include "recon/jigsaw/slide.h"
#include "recon/jigsaw/wall.h"
#include "shared/base/parallel.h"
#include "tests/recon/jigsaw/stacks.h"

namespace recon::jigsaw {
namespace {

/// Every bed is level at its depth below the datum, of length l0, and no fault gapes or overlaps.
void expect_stack(const Blockwise& made, double tolerance = 1e-9) {
  const double size = right_end - left_end;
  EXPECT_NEAR(made.widths.after, size, tolerance * size);
  for (const RestoredFault& fault : made.faults) {
    EXPECT_TRUE(fault.measured) << fault.name;
    EXPECT_LT(fault.opening.gap, tolerance * size * 900.0) << fault.name;
    EXPECT_LT(fault.opening.overlap, tolerance * size * 900.0) << fault.name;
  }
  for (const section::Horizon& horizon : made.section.horizons) {
    const double depth = levels[static_cast<std::size_t>(whole_name(horizon)[0] - 'A')];
    for (const geom::Point p : horizon.line.points)
      EXPECT_NEAR(p.y - made.blocks[0].datum, depth, tolerance * size) << horizon.name;
  }
  for (const balance::LineLength& row : made.lengths)
    EXPECT_NEAR(row.length_after, row.length_before, tolerance * size) << row.name;
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::Balanced) << made.remarks.back();
}

TEST(Jigsaw, GrabenAndImbricateReturnTheirWidthWithoutGapsByEveryMethodAndFit) {
  using unfold::RestoreMethod;
  for (const RestoreMethod method : {RestoreMethod::Constant, RestoreMethod::Variable, RestoreMethod::Proportional,
                                     RestoreMethod::Flexural, RestoreMethod::Shear, RestoreMethod::LineLength}) {
    for (const Fit fit : {Fit::Walls, Fit::Top}) {
      unfold::RestoreParams params;
      params.method = method;
      SCOPED_TRACE(unfold::method_name(method));
      expect_stack(restored(graben(), jigsaw_by(fit), params));
      expect_stack(restored(imbricate(), jigsaw_by(fit), params));
    }
  }
}

TEST(Jigsaw, ShiftsDipsAndShorteningAreThoseOfTheCuts) {
  const Blockwise normal = restored(graben(), jigsaw_by(Fit::Walls));
  const double heave = along(east, 250).x;
  ASSERT_EQ(normal.rows.size(), 3U);
  EXPECT_NEAR(*normal.rows[0].shift, 0.0, 1e-9);
  EXPECT_NEAR(*normal.rows[1].shift, -heave, 1e-6);
  EXPECT_NEAR(*normal.rows[2].shift, -2 * heave, 1e-6);
  ASSERT_EQ(normal.faults.size(), 2U);
  for (const RestoredFault& fault : normal.faults) {
    EXPECT_NEAR(*fault.dip, 60.0, 1e-6);
    EXPECT_NEAR(*fault.shortening, -heave, 1e-6);
  }
  EXPECT_NEAR(normal.widths.shortening(), -2 * heave, 1e-6);
  EXPECT_NEAR(normal.widths.folding(), 0.0, 1e-6);
  // The mean wall is the plane itself.
  for (const section::SectionLine& line : normal.section.lines) {
    const Plane& plane = line.name == "F1" ? east : west;
    ASSERT_GE(line.line.points.size(), 2U);
    for (const geom::Point p : line.line.points) EXPECT_NEAR(p.x, plane.x(p.y), 1e-6);
    EXPECT_NEAR(line.line.points.back().y, 0.0, 1e-5);
    EXPECT_NEAR(line.line.points.front().y, -900.0, 1e-5);
  }
  const Blockwise thrust = restored(imbricate(), jigsaw_by(Fit::Walls));
  for (const RestoredFault& fault : thrust.faults) {
    EXPECT_NEAR(*fault.dip, 30.0, 1e-6);
    EXPECT_NEAR(*fault.shortening, 300.0 * std::cos(std::numbers::pi / 6), 1e-6);
  }
}

TEST(Jigsaw, ThePinnedBlockStaysAndThePinChoosesIt) {
  BlockwiseParams how = jigsaw_by(Fit::Walls);
  how.pin = 3000.0;
  how.elevation = -40.0;
  const Blockwise made = restored(graben(), how);
  EXPECT_NEAR(*made.rows[2].shift, 0.0, 1e-12);
  EXPECT_NEAR(*made.rows[0].shift, 2 * along(east, 250).x, 1e-6);
  expect_stack(made);
  EXPECT_NEAR(made.blocks[2].forward({3000, 0}).x, 3000.0, 1e-9);
  EXPECT_NEAR(made.blocks[2].datum, -40.0, 1e-12);
  how.pin = 9000.0;
  const auto beside = restore_blockwise(graben(), how, {}, {});
  ASSERT_FALSE(beside);
  EXPECT_EQ(beside.error().code, base::ErrorCode::BadValue);
}

/// Kinks: parallel beds bend by `angle` about the bisector through (x, 0) on both sides of a level middle, so that
/// every bed keeps its length and the layers their thickness. Flexural slip with its pin in the middle, written down
/// anew.
Motion kinked(double low, double high, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return [=](geom::Point p) -> geom::Point {
    // A bed at depth d = -z bends where it meets the bisector, at x = high + d tan(angle / 2).
    const double depth = -p.y;
    const double more = depth * std::tan(0.5 * angle);
    const geom::Point right{high - more, p.y}, left{low + more, p.y};
    if (p.x > right.x) return right + (p.x - right.x) * geom::Vector{std::cos(angle), -std::sin(angle)};
    if (p.x < left.x) return left + (p.x - left.x) * geom::Vector{std::cos(angle), std::sin(angle)};
    return p;
  };
}

TEST(Jigsaw, BlocksFoldedByFlexuralSlipReturnTheLevelStack) {
  // Three blocks whose flanks bend down by 12 degrees, moved apart; faults stand where each block's own walls went, as
  // wide gaps of today, with the fault on one of them.
  const Plane first{-1500.0, 0.3}, second{1600.0, -0.25};
  const auto folded = [](double low, double high, double dx, double dz) -> Motion {
    return [=, kink = kinked(low, high, 12.0)](geom::Point p) {
      const geom::Point q = kink(p);
      return geom::Point{q.x + dx, q.y + dz};
    };
  };
  const std::vector<Motion> motions{by(0, 0), folded(-600, 700, 30.0, -200.0), by(-140.0, 0.0)};
  Section section = stack({first, second}, motions, false, 51);
  // The faults as the walls of the middle block, which touch its beds.
  for (std::size_t k = 0; k < 2; ++k) {
    const Plane& plane = k == 0 ? first : second;
    geom::Polyline line;
    for (double z = -900.0; z <= 0.0; z += 100.0) line.points.push_back(motions[1]({plane.x(z), z}));
    const geom::Vector up = line.points.back() - line.points[line.points.size() - 2];
    const geom::Vector down = line.points.front() - line.points[1];
    line.points.push_back(line.points.back() + 10.0 * up);
    line.points.insert(line.points.begin(), line.points.front() + 10.0 * down);
    section.lines[k].line = line;
  }
  // The beds beside it stop short of these faults, by more than any tolerance; only the middle is restored.
  for (section::Horizon& horizon : section.horizons) {
    if (horizon.name.find("(2)") != std::string::npos) {  // with its kinks as vertices
      const double z = levels[static_cast<std::size_t>(horizon.name[0] - 'A')];
      const double more = -z * std::tan(6.0 * std::numbers::pi / 180.0);
      horizon.line.points.clear();
      for (const double x : {first.x(z), -600 + more, 10.0, 700 - more, second.x(z)})
        horizon.line.points.push_back(motions[1]({x, z}));
    }
    if (horizon.name.find("(1)") != std::string::npos) {
      while (horizon.line.points.back().x > -2400.0) horizon.line.points.pop_back();
    } else if (horizon.name.find("(3)") != std::string::npos) {
      while (horizon.line.points.front().x < 2500.0) horizon.line.points.erase(horizon.line.points.begin());
    }
  }
  section.border = geom::Polyline{{{-5000, -2000}, {5000, -2000}, {5000, 500}, {-5000, 500}}, true};
  unfold::RestoreParams params;
  params.method = unfold::RestoreMethod::Flexural;
  params.beds = unfold::SlipBeds::Parallel;
  BlockwiseParams how;
  how.block = {"block 2"};
  how.top = "A";
  how.elevation = 0.0;
  how.pin = 60.0;
  const Blockwise made = restored(section, how, params);
  ASSERT_EQ(made.blocks.size(), 1U);
  std::size_t seen = 0;
  for (const section::Horizon& horizon : made.section.horizons) {
    if (horizon.name.find("(2)") == std::string::npos) continue;
    const double depth = levels[static_cast<std::size_t>(horizon.name[0] - 'A')];
    EXPECT_NEAR(horizon.line.points.front().x, first.x(depth) + 30.0, 1e-6) << horizon.name;
    EXPECT_NEAR(horizon.line.points.back().x, second.x(depth) + 30.0, 1e-6) << horizon.name;
    for (const geom::Point p : horizon.line.points) EXPECT_NEAR(p.y, depth, 1e-6);
    ++seen;
  }
  EXPECT_EQ(seen, 4U);
  // The rest is as it was, bit for bit.
  for (std::size_t i = 0; i < section.horizons.size(); ++i) {
    if (section.horizons[i].name.find("(2)") != std::string::npos) continue;
    const auto& before = section.horizons[i].line.points;
    const auto& after = made.section.horizons[i].line.points;
    ASSERT_EQ(before.size(), after.size());
    EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(geom::Point)), 0);
  }
  EXPECT_EQ(made.section.lines[0].line.points, section.lines[0].line.points);
}

TEST(Jigsaw, GapsAndOverlapsAreNotNettedAndTheVerdictIsNo) {
  // The right wall is a straight plane, the left one bulges over it below and stands back above: walls by hand.
  const Branch left{true, {{0, -1000}, {100, -500}, {-100, 0}}};
  const Branch right{true, {{0, -1000}, {0, 0}}};
  const Opening opening = opening_of(pair_of(left, right));
  // Overlap: over 500 m up to 100 m, then down to nothing over 250 m; gap: from there to 100 m over 250 m.
  EXPECT_NEAR(opening.overlap, 0.5 * 100 * 750, 1e-9);
  EXPECT_NEAR(opening.gap, 0.5 * 100 * 250, 1e-9);
  EXPECT_EQ(opening.overlap_at.y, -500.0);
  EXPECT_EQ(opening.gap_at.y, 0.0);

  // Half-way down the middle block reaches 150 m farther to the left than its wall of before: today's fault runs there,
  // but the wall of the left block, 250 m up the fault, was straight.
  Section section = graben();
  const geom::Vector slip = along(east, 250);
  const geom::Polyline bent{{{east.x(-1500), -1500}, {east.x(-450) - 150.0, -450}, {east.x(900), 900}}, false};
  section.lines[0].line = bent;
  const auto on_fault = [&](double z) {
    for (std::size_t i = 0; i < bent.segment_count(); ++i) {
      const auto [a, b] = bent.segment(i);
      if (z >= a.y && z <= b.y) return a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y);
    }
    return 0.0;
  };
  for (section::Horizon& horizon : section.horizons) {
    std::vector<geom::Point>& points = horizon.line.points;
    if (horizon.name.find("(1)") != std::string::npos) points.back().x = on_fault(points.back().y);
    if (horizon.name.find("(2)") != std::string::npos) points.front().x = on_fault(points.front().y);
  }
  // Brute force: both walls as they are restored, the right one back by the slip and by what makes their mean distance
  // nothing.
  double mean = 0.0, gap = 0.0, overlap = 0.0;
  const auto apart = [&](double z) { return (on_fault(z + slip.y) - slip.x) - on_fault(z); };
  constexpr int steps = 90000;
  for (int i = 0; i < steps; ++i) mean += apart(-900.0 * (i + 0.5) / steps) / steps;
  for (int i = 0; i < steps; ++i) {
    const double d = apart(-900.0 * (i + 0.5) / steps) - mean;
    (d > 0.0 ? gap : overlap) += std::abs(d) * 900.0 / steps;
  }
  unfold::RestoreParams params;
  params.tolerance = 1.0;
  const Blockwise made = restored(section, jigsaw_by(Fit::Walls), params);
  ASSERT_EQ(made.faults.size(), 2U);
  EXPECT_GT(gap, 5000.0);
  EXPECT_NEAR(made.faults[0].opening.gap, gap, 0.01);
  EXPECT_NEAR(made.faults[0].opening.overlap, overlap, 0.01);
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::NotBalanced) << made.remarks.back();
  EXPECT_EQ(made.worst_fault, "F1");
}

TEST(Jigsaw, ABedThatStandsLowerInOneBlockIsNotBalanced) {
  Section section = graben();
  const geom::Vector down = along(east, 250);
  for (section::Horizon& horizon : section.horizons) {
    if (horizon.name != "C (2)") continue;
    horizon.line.points = {geom::Point{east.x(-750), -750} + down, geom::Point{west.x(-750), -750} + down};
  }
  const Blockwise made = restored(section, jigsaw_by(Fit::Walls));
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::NotBalanced);
  EXPECT_EQ(made.worst_offset, "C");
  EXPECT_NEAR(made.greatest_offset_percent, 100.0 * 150.0 / 900.0, 1e-6);
  const auto tells = [](const std::string& remark) {
    return remark.find("horizon 'C' stands 150 m higher") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(made.remarks.begin(), made.remarks.end(), tells), 2);
}

TEST(Jigsaw, ABlockWithoutTheTopIsRefusedAndOneWithoutTheBedsStays) {
  Section section = graben();
  std::erase_if(section.horizons, [](const section::Horizon& h) { return h.name == "A (2)"; });
  const auto refused = restore_blockwise(section, jigsaw_by(Fit::Walls), {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_NE(to_string(refused.error()).find("block 2"), std::string::npos) << to_string(refused.error());
  EXPECT_NE(to_string(refused.error()).find("B, C, D"), std::string::npos) << to_string(refused.error());
  BlockwiseParams how = jigsaw_by(Fit::Walls);
  how.top = "B";
  const Blockwise made = restored(section, how);
  EXPECT_NEAR(made.widths.after, 10000.0, 1e-5);
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::Balanced) << made.remarks.back();
}

TEST(Jigsaw, ATopInTwoPiecesWithinABlockIsJoinedAcrossItsGap) {
  Section section = graben();
  const auto top = std::find_if(section.horizons.begin(), section.horizons.end(),
                                [](const section::Horizon& h) { return h.name == "A (2)"; });
  const geom::Point left = top->line.points.front(), right = top->line.points.back();
  top->line.points.back() = {800.0, left.y};
  section::Horizon rest = *top;
  rest.id = section::HorizonId(section.horizons.size());
  rest.name = "A (4)";
  rest.line.points = {right, {920.0, left.y}};  // drawn the other way
  section.horizons.push_back(rest);
  for (const Fit fit : {Fit::Walls, Fit::Top}) {
    const Blockwise made = restored(section, jigsaw_by(fit));
    expect_stack(made);
    const auto tells = [](const std::string& remark) {
      return remark.find("joined straight across a gap of 120 m") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(made.remarks.begin(), made.remarks.end(), tells), 1);
    EXPECT_EQ(made.section.horizons.size(), section.horizons.size() - 1);
  }
  // No: a sheet that lies over the other is no continuation of it.
  section.horizons.back().line.points = {right, {600.0, left.y - 40.0}};
  const auto refused = restore_blockwise(section, jigsaw_by(Fit::Walls), {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_NE(to_string(refused.error()).find("lie over each other"), std::string::npos) << to_string(refused.error());
}

TEST(Jigsaw, RoughPicksHardlyChangeTheShiftsOfTheWalls) {
  const double heave = along(east, 250).x;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  double worst = 0.0;
  for (int draw = 0; draw < 10; ++draw) {
    const geom::Vector slip = along(east, 250);
    Section section = stack({east, west}, {by(0, 0), by(slip.x, slip.y), by(2 * slip.x, 0)}, true, 41);
    for (section::Horizon& horizon : section.horizons) {
      for (geom::Point& p : horizon.line.points) p.y += noise(random);
    }
    const Blockwise made = restored(section, jigsaw_by(Fit::Walls));
    worst = std::max({worst, std::abs(*made.rows[1].shift + heave), std::abs(*made.rows[2].shift + 2 * heave)});
  }
  EXPECT_LT(worst, 5.0) << worst;
  EXPECT_GT(worst, 0.01);
}

TEST(Jigsaw, ErrorsOfShiftsAreOfTheSizeOfWhatNoiseDoesToThem) {
  const double heave = along(east, 250).x;
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (const Fit fit : {Fit::Walls, Fit::Top}) {
    double true_errors = 0.0, told_errors = 0.0;
    for (int draw = 0; draw < 8; ++draw) {
      const geom::Vector slip = along(east, 250);
      Section section = stack({east, west}, {by(0, 0), by(slip.x, slip.y), by(2 * slip.x, 0)}, true, 41);
      for (section::Horizon& horizon : section.horizons) {
        for (geom::Point& p : horizon.line.points) p.y += noise(random);
      }
      const Blockwise made = restored(section, jigsaw_by(fit));
      EXPECT_EQ(made.rows[0].shift_error, 0.0);
      for (const int block : {1, 2}) {
        const BlockRow& row = made.rows[static_cast<std::size_t>(block)];
        true_errors += std::pow(*row.shift + block * heave, 2);
        told_errors += std::pow(row.shift_error.value(), 2);
      }
      const double first = made.faults[0].slide_error.value(), second = made.faults[1].slide_error.value();
      EXPECT_GT(made.faults[0].misfit.value(), 0.0);
      EXPECT_NEAR(made.rows[1].shift_error.value(), first, 1e-9);  // from block to block
      EXPECT_NEAR(made.rows[2].shift_error.value(), std::hypot(first, second), 1e-9);
    }
    const double ratio = std::sqrt(told_errors / true_errors);
    EXPECT_GT(ratio, 0.5) << static_cast<int>(fit);
    EXPECT_LT(ratio, 4.0) << static_cast<int>(fit) << ' ' << ratio;
  }
}

TEST(Walls, TheSlideErrorIsTheirMeanSquareDistanceWithoutNoise) {
  // Apart by 0 at the datum and, 900 m below, by 9 m at the first fault and 18 m at the second.
  std::vector<UnfoldedBlock> blocks(3);
  std::vector<FacingWalls> facing;
  std::vector<RestoredFault> faults(3);
  for (std::size_t i = 0; i < 2; ++i) {
    WallPair pair;
    pair.pieces = {{-900, 0, 100, 100, 100 + 9.0 * static_cast<double>(i + 1), 100}};
    facing.push_back({i, i, i + 1, pair});
    faults[i].measured = true;
  }
  add_slide_errors(facing, blocks, 10000.0, faults);
  EXPECT_NEAR(faults[0].slide_error.value(), 9.0 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(faults[1].slide_error.value(), 18.0 / std::sqrt(3.0), 1e-12);
  EXPECT_FALSE(faults[2].slide_error);
}

TEST(Jigsaw, ASlipOfThePenInTheMiddleOfATopTiltsNoBlockAndIsToldWhereThePinIsPutOnIt) {
  const geom::Vector slip = along(east, 250);
  // Steep little stretches in the middle of the top of the second block, down, up, and one that leans back.
  for (const geom::Vector off : {geom::Vector{7, -4}, {7, 5}, {5, 6}}) {
    Section section = stack({east, west}, {by(0, 0), by(slip.x, slip.y), by(2 * slip.x, 0)}, true, 41);
    const auto top = std::find_if(section.horizons.begin(), section.horizons.end(),
                                  [](const section::Horizon& h) { return h.name == "A (2)"; });
    const geom::Point middle = top->line.points[20];
    top->line.points[20] = middle - 0.5 * off;
    top->line.points.insert(top->line.points.begin() + 21, middle + 0.5 * off);
    BlockwiseParams how = jigsaw_by(Fit::Walls);
    unfold::RestoreParams params;
    params.method = unfold::RestoreMethod::Flexural;
    const auto jigsaw = restore_blockwise(section, how, params, {});
    ASSERT_TRUE(jigsaw) << to_string(jigsaw.error());
    const Blockwise& made = *jigsaw;
    const double longer = 2.0 * geom::length(off);  // at most, by what the top has got longer
    EXPECT_NEAR(*made.rows[1].shift, -slip.x, longer) << off.x;
    how.jigsaw = false;
    how.fit.reset();
    how.block = {made.rows[1].name};
    how.pin = middle.x;
    const auto alone = restore_blockwise(section, how, {}, {});
    ASSERT_TRUE(alone) << to_string(alone.error());
    const Blockwise& pinned = *alone;
    const auto tells = [](const std::string& remark) {
      return remark.find("degrees off its dip on both sides") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(made.remarks.begin(), made.remarks.end(), tells), 0);
    EXPECT_EQ(std::count_if(pinned.remarks.begin(), pinned.remarks.end(), tells), 1);
  }
}

TEST(Walls, DistanceIsWeightedByDepthAsBruteForceHasIt) {
  const Branch left{true, {{0, -1000}, {100, -500}, {-100, 0}}};
  const Branch right{true, {{50, -1000}, {70, 0}}};
  const WallPair pair = pair_of(left, right);
  for (const double lean : {0.0, 0.001, 0.05}) {
    double height = 0.0, moment = 0.0;
    constexpr int steps = 400000;
    for (int i = 0; i < steps; ++i) {
      const double z = -1000.0 + 1000.0 * (i + 0.5) / steps;
      const double l = z < -500 ? 100.0 * (z + 1000) / 500 : 100.0 - 200.0 * (z + 500) / 500;
      const double d = 1.0 + lean * lean * (z - 20.0) * (z - 20.0), w = 1.0 / (d * d);
      height += w * 1000.0 / steps;
      moment += w * (50.0 + 20.0 * (z + 1000.0) / 1000.0 - l) * 1000.0 / steps;
    }
    const Distance found = distance_of(pair, {20.0, lean});
    EXPECT_NEAR(found.height, height, 1e-4 * height) << lean;
    EXPECT_NEAR(found.moment, moment, 1e-4 * std::abs(moment) + 1e-3) << lean;
  }
}

TEST(Jigsaw, BasementBelowADetachmentStaysAndIsSaid) {
  Section section = stack({east}, {by(0, 0), by(along(east, 200).x, along(east, 200).y)}, false);
  section.border = geom::Polyline{{{-5000, -2000}, {5000, -2000}, {5000, 300}, {-5000, 300}}, true};
  section.lines[0].line = {{{east.x(-1200), -1200}, {east.x(900), 900}}, false};
  section.lines.push_back({section::LineId(1), LineKind::Fault, "floor", {{{-5500, -1200}, {5500, -1200}}, false}, {}});
  const Blockwise made = restored(section, jigsaw_by(Fit::Walls));
  ASSERT_EQ(made.rows.size(), 3U);
  EXPECT_EQ(std::count_if(made.rows.begin(), made.rows.end(), [](const auto& row) { return !row.shift; }), 1);
  EXPECT_NEAR(*made.rows[2].shift, -along(east, 200).x, 1e-6);
  EXPECT_LT(made.faults[0].opening.gap + made.faults[0].opening.overlap, 1e-6);
  EXPECT_NEAR(*made.faults[0].dip, 60.0, 1e-6);
  EXPECT_FALSE(made.faults[1].measured);
  EXPECT_EQ(made.section.lines[1].line.points, section.lines[1].line.points);
  EXPECT_NE(made.remarks.front().find("it stays as it is"), std::string::npos);
}

TEST(Jigsaw, ABedThatOneBlockLacksDoesNotMatter) {
  for (const char* missing : {"B (1)", "C (2)", "D (3)"}) {
    Section section = graben();
    section.border = geom::Polyline{{{-5000, -1200}, {5300, -1200}, {5300, 300}, {-5000, 300}}, true};
    std::erase_if(section.horizons, [&](const section::Horizon& h) { return h.name == missing; });
    const Blockwise made = restored(section, jigsaw_by(Fit::Walls));
    EXPECT_NEAR(made.widths.after, 10000.0, 1e-5) << missing;
    for (const RestoredFault& fault : made.faults) EXPECT_LT(fault.opening.gap + fault.opening.overlap, 1e-2);
  }
}

TEST(Jigsaw, AFaultThatEndsInRockPartsNoBlocksAndGoesAlong) {
  Section section = graben();
  section.lines.push_back({section::LineId(2), LineKind::Fault, "tip", {{{-3000, -700}, {-2600, -100}}, false}, {}});
  section.lines.push_back({section::LineId(3), LineKind::Fault, "tip 2", {{{900, -700}, {1000, -400}}, false}, {}});
  const Blockwise made = restored(section, jigsaw_by(Fit::Walls));
  expect_stack([&] {
    Blockwise two = made;
    two.faults.resize(2);
    return two;
  }());
  EXPECT_FALSE(made.faults[2].measured);
  const geom::Vector moved{-along(east, 250).x, -along(east, 250).y};
  const geom::Point end = made.section.lines[3].line.points.front();
  EXPECT_LT(geom::distance(end, geom::Point{900, -700} + moved), 1e-6);
}

TEST(Jigsaw, BlocksThatNothingJoinsAreNamed) {
  const std::vector<Tie> ties{{0, 1, 1.0, 5.0}};
  const auto shifts = slide({"west", "middle", "east"}, 0, ties);
  ASSERT_FALSE(shifts);
  EXPECT_NE(shifts.error().message.find("'east'"), std::string::npos);
  EXPECT_EQ(shifts.error().message.find("'middle'"), std::string::npos);
}

TEST(Jigsaw, ARingOfBlocksIsClosedByLeastSquares) {
  // Three ties round a ring that miss each other by 9 m: each takes a third.
  const auto shifts = slide({"a", "b", "c"}, 1, {{0, 1, 2.0, 10.0}, {1, 2, 2.0, 20.0}, {0, 2, 2.0, 39.0}});
  ASSERT_TRUE(shifts) << to_string(shifts.error());
  EXPECT_NEAR((*shifts)[1], 0.0, 0.0);
  EXPECT_NEAR((*shifts)[1] - (*shifts)[0], 13.0, 1e-9);
  EXPECT_NEAR((*shifts)[2] - (*shifts)[1], 23.0, 1e-9);
}

TEST(Jigsaw, ALevelPieceOfAWallIsAJumpAndATurningWallFallsIntoBranches) {
  const geom::Polyline flat{{{0, -100}, {50, -50}, {450, -50}, {500, 0}}, false};
  const std::vector<Branch> one = branches_of(flat, 1e-9);
  ASSERT_EQ(one.size(), 1U);
  const Branch upright{true, {{0, -100}, {0, 0}}};
  const WallPair pair = pair_of(upright, one[0]);
  EXPECT_NEAR(pair.height(), 100.0, 1e-12);
  EXPECT_NEAR(distance_of(pair, {}).moment, 0.5 * 50 * 50 + 0.5 * (450 + 500) * 50, 1e-9);
  const geom::Polyline turns{{{0, -100}, {50, -20}, {80, -60}, {100, 0}}, false};
  const std::vector<Branch> three = branches_of(turns, 1e-9);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_TRUE(three[0].climbs && !three[1].climbs && three[2].climbs);
  EXPECT_EQ(three[1].points.front(), (geom::Point{80, -60}));
}

TEST(Jigsaw, PointsAndLinesGoThereAndBack) {
  const Blockwise made = restored(imbricate(), jigsaw_by(Fit::Walls));
  for (const geom::Point p :
       {geom::Point{-3000, 100}, geom::Point{400, 100}, geom::Point{1700, -100}, geom::Point{4000, -500}})
    EXPECT_LT(geom::distance(made.inverse(made.forward(p)), p), 1e-6);
  const geom::Polyline top{{{-4000, made.blocks[0].datum - 50}, {5000, made.blocks[0].datum - 50}}, false};
  const geom::Polyline there = made.inverse(top);
  EXPECT_NEAR(geom::length(there), 9000.0 + 3 * 300.0, 1e-3);
  int jumps = 0;
  for (std::size_t i = 0; i < there.segment_count(); ++i) {
    const geom::Segment piece = there.segment(i);
    if (std::abs(piece.from.y - piece.to.y) > 1e-6) {  // along a fault
      EXPECT_NEAR(piece.length(), 300.0, 1e-3);
      ++jumps;
      continue;
    }
    const geom::Polyline back = made.forward(geom::Polyline{{piece.from, piece.to}, false});
    for (const geom::Point p : back.points) EXPECT_NEAR(p.y, top.points[0].y, 1e-6);
    EXPECT_NEAR(geom::length(back), piece.length(), 1e-6);
  }
  EXPECT_EQ(jumps, 3);
}

TEST(Jigsaw, IsTheSameAtAnyNumberOfThreads) {
  base::set_thread_count(1);
  const Blockwise one = restored(imbricate(), jigsaw_by(Fit::Walls));
  base::set_thread_count(0);
  const Blockwise all = restored(imbricate(), jigsaw_by(Fit::Walls));
  ASSERT_EQ(one.section.horizons.size(), all.section.horizons.size());
  for (std::size_t i = 0; i < one.section.horizons.size(); ++i)
    EXPECT_EQ(one.section.horizons[i].line.points, all.section.horizons[i].line.points);
}

TEST(Jigsaw, ParametersThatContradictEachOtherAreRefused) {
  const auto code = [](const BlockwiseParams& how) {
    const auto made = check_params(how);
    return made ? base::ErrorCode::Cancelled : made.error().code;
  };
  BlockwiseParams both = jigsaw_by(Fit::Top);
  both.block = {"block 1"};
  EXPECT_EQ(code(both), base::ErrorCode::BadValue);
  BlockwiseParams fit;
  fit.fit = Fit::Top;
  EXPECT_EQ(code(fit), base::ErrorCode::BadValue);
  BlockwiseParams pin;
  pin.pin = 3.0;
  EXPECT_EQ(code(pin), base::ErrorCode::BadValue);
  BlockwiseParams unknown;
  unknown.block = {"blok 1"};
  const auto made = restore_blockwise(graben(), unknown, {}, {});
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("block 1"), std::string::npos);
  Section whole = graben();
  whole.lines.clear();
  EXPECT_FALSE(restore_blockwise(whole, jigsaw_by(Fit::Walls), {}, {}));
}

TEST(Jigsaw, FaultsThatPartNoBlocksAreRefused) {
  // Two beds that stop 100 m short of the only fault enclose nothing with it.
  Section open = graben();
  open.horizons.resize(2);
  open.horizons[0].line = {{{0, 0}, {100, 0}}, false};
  open.horizons[1].line = {{{0, -300}, {40, -300}}, false};
  open.lines.resize(1);
  open.faces.reset();
  const auto made = restore_blockwise(open, jigsaw_by(Fit::Walls), {}, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, base::ErrorCode::BadSection);
}

}  // namespace
}  // namespace recon::jigsaw
