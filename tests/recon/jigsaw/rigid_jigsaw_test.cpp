// Jigsaws of rigid blocks that turn and shift, against blocks that the test has cut and turned itself.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "recon/jigsaw/rigid_fit.h"
#include "tests/recon/jigsaw/stacks.h"

namespace recon::jigsaw {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
const std::vector<double> depths{-200.0, -500.0, -800.0, -1100.0};
constexpr double west_end = -4000.0, east_end = 7000.0, rock_size = 1e4;

/// Anticlockwise about a point, written down anew.
struct Turn {
  geom::Point about;
  double degrees = 0.0;
  [[nodiscard]] geom::Point of(geom::Point p) const {
    const double c = std::cos(degrees * degree), s = std::sin(degrees * degree);
    const double x = p.x - about.x, y = p.y - about.y;
    return {about.x + c * x - s * y, about.y + s * x + c * y};
  }
};

geom::Point of_all(const std::vector<Turn>& turns, geom::Point p) {
  for (const Turn& turn : turns) p = turn.of(p);
  return p;
}

/// A listric fault: the polygon of a circle with a corner every two degrees, so that turns by even angles take it onto
/// itself.
std::vector<geom::Point> listric(geom::Point centre) {
  std::vector<geom::Point> points;
  for (int k = 90; k <= 131; ++k)
    points.push_back({centre.x + 2000.0 * std::cos(2 * k * degree), centre.y + 2000.0 * std::sin(2 * k * degree)});
  return points;
}

double x_at(const std::vector<geom::Point>& line, double z) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (line[i].y >= z && z >= line[i + 1].y)
      return line[i].x + (line[i + 1].x - line[i].x) * (z - line[i].y) / (line[i + 1].y - line[i].y);
  }
  return NAN;
}

/// Level beds cut by listric faults about centres at z = 200; what lies to the right of each turns on it.
struct Listric {
  std::vector<geom::Point> centres;
  std::vector<double> degrees;
  double lower_c = 0.0;  ///< By so much C of the second block lies too low.

  /// The turns that a block has made, the last first.
  [[nodiscard]] std::vector<Turn> turns(std::size_t block) const {
    std::vector<Turn> made;
    for (std::size_t k = block; k-- > 0;) made.push_back({centres[k], degrees[k]});
    return made;
  }
  [[nodiscard]] Section section() const {
    Section made;
    for (std::size_t bed = 0; bed < depths.size(); ++bed) {
      for (std::size_t block = 0; block <= centres.size(); ++block) {
        const double z = depths[bed] - (bed == 2 && block == 1 ? lower_c : 0.0);
        const double from = block == 0 ? west_end : x_at(listric(centres[block - 1]), z);
        const double to = block == centres.size() ? east_end : x_at(listric(centres[block]), z);
        geom::Polyline line;
        for (int i = 0; i <= 4; ++i) line.points.push_back(of_all(turns(block), {from + (to - from) * i / 4, z}));
        const std::string name(1, static_cast<char>('A' + bed));
        made.horizons.push_back(
            {section::HorizonId(made.horizons.size()), name + " (" + std::to_string(block + 1) + ")", line, {}, name});
      }
    }
    for (std::size_t k = 0; k < centres.size(); ++k) {
      geom::Polyline line{listric(centres[k]), false};
      for (geom::Point& p : line.points) p = of_all(turns(k), p);
      made.lines.push_back({section::LineId(k), LineKind::Fault, "F" + std::to_string(k + 1), line, {}});
    }
    return made;
  }
};

const Listric three_blocks{{{0, 200}, {3000, 200}}, {4.0, 6.0}};

BlockwiseParams rotating(Fit fit = Fit::Walls) {
  BlockwiseParams how;
  how.jigsaw = true;
  how.constraint = Constraint::Rotation;
  how.fit = fit;
  return how;
}

TEST(RigidJigsaw, ListricBlocksTurnBackByTheirAnglesAndLeaveNoGap) {
  for (const Fit fit : {Fit::Walls, Fit::Top}) {
    const Blockwise made = restored(three_blocks.section(), rotating(fit));
    ASSERT_EQ(made.rows.size(), 3U);
    EXPECT_EQ(*made.rows[0].turn, 0.0);
    EXPECT_NEAR(*made.rows[1].turn, -4.0, 1e-9);
    EXPECT_NEAR(*made.rows[2].turn, -10.0, 1e-9);
    for (const section::Horizon& horizon : made.section.horizons) {
      const double z = depths[static_cast<std::size_t>(whole_name(horizon)[0] - 'A')];
      for (const geom::Point p : horizon.line.points) EXPECT_NEAR(p.y, z, 1e-9 * rock_size) << horizon.name;
    }
    EXPECT_NEAR(made.widths.after, east_end - west_end, 1e-9 * rock_size);
    for (const RestoredFault& fault : made.faults) {
      EXPECT_TRUE(fault.measured);
      EXPECT_LT(fault.opening.gap + fault.opening.overlap, 1e-9 * rock_size * rock_size) << fault.name;
    }
    for (const balance::LineLength& row : made.lengths)
      EXPECT_NEAR(row.length_after, row.length_before, 1e-9 * rock_size);
    EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::Balanced) << made.remarks.back();
  }
}

TEST(RigidJigsaw, ThePinnedBlockStaysAndTheOthersTurnToIt) {
  BlockwiseParams how = rotating();
  const Section section = three_blocks.section();
  how.pin = section.horizons[1].line.points[2].x;  // A of the second block
  const Blockwise made = restored(section, how);
  EXPECT_EQ(*made.rows[1].turn, 0.0);
  EXPECT_EQ(*made.rows[1].shift, 0.0);
  EXPECT_NEAR(*made.rows[0].turn, 4.0, 1e-9);
  EXPECT_NEAR(*made.rows[2].turn, -6.0, 1e-9);
  for (std::size_t i = 0; i < section.horizons.size(); ++i) {
    const double z = depths[i / 3];
    for (const geom::Point p : made.section.horizons[i].line.points) {
      const geom::Point level = Turn{three_blocks.centres[0], -4.0}.of(p);  // the second block's own turn
      EXPECT_NEAR(level.y, z, 1e-9 * rock_size) << section.horizons[i].name;
    }
  }
  // Points there and back.
  for (const geom::Point p : {geom::Point{-3000, -400}, {500, -600}, {6000, -300}})
    EXPECT_LT(geom::distance(made.inverse(made.forward(p)), p), 1e-9 * rock_size);
}

TEST(RigidJigsaw, DominoesSlideBackAlongTheirFaultsAndKeepTheirTilt) {
  // Four dominoes between planes of 60 degrees, each 150 m down the plane from the one before, all turned by 20
  // degrees: their beds come back to straight lines of that dip.
  const double lean = 1.0 / std::tan(60.0 * degree);
  const geom::Vector slip{150.0 * std::cos(60.0 * degree), -150.0 * std::sin(60.0 * degree)};
  const Turn tilt{{0, 0}, 20.0};
  Section section;
  for (std::size_t bed = 0; bed < depths.size(); ++bed) {
    for (int block = 0; block < 4; ++block) {
      const double z = depths[bed];
      const double from = block == 0 ? west_end : 1200.0 * block - lean * z;
      const double to = block == 3 ? east_end : 1200.0 * (block + 1) - lean * z;
      const auto at = [&](double x) { return tilt.of(geom::Point{x, z} + static_cast<double>(block) * slip); };
      const std::string name(1, static_cast<char>('A' + bed));
      section.horizons.push_back({section::HorizonId(section.horizons.size()),
                                  name + std::to_string(block),
                                  {{at(from), at(to)}, false},
                                  {},
                                  name});
    }
  }
  for (int k = 1; k < 4; ++k) {
    const geom::Vector down = static_cast<double>(k) * slip;
    geom::Polyline line{{tilt.of(geom::Point{1200.0 * k + lean * 2500.0, -2500.0} + down),
                         tilt.of(geom::Point{1200.0 * k - lean * 1500.0, 1500.0} + down)},
                        false};
    section.lines.push_back(
        {section::LineId(section.lines.size()), LineKind::Fault, "F" + std::to_string(k), line, {}});
  }
  const Blockwise made = restored(section, rotating());
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(*made.rows[k].turn, 0.0, 1e-9);
    const geom::Point back = tilt.of({-static_cast<double>(k) * slip.x, -static_cast<double>(k) * slip.y});
    EXPECT_NEAR(*made.rows[k].shift, back.x, 1e-9 * rock_size);
    EXPECT_NEAR(*made.rows[k].raise, back.y, 1e-9 * rock_size);
  }
  for (const section::Horizon& horizon : made.section.horizons) {
    const double z = depths[static_cast<std::size_t>(whole_name(horizon)[0] - 'A')];
    for (const geom::Point p : horizon.line.points)
      EXPECT_NEAR((Turn{{0, 0}, -20.0}.of(p).y), z, 1e-9 * rock_size) << horizon.name;
  }
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::Balanced) << made.remarks.back();
}

TEST(RigidJigsaw, ABedThatDoesNotFitIsNotBalancedAndToldWithItsPlace) {
  Listric off = three_blocks;
  off.lower_c = 150.0;
  const Blockwise made = restored(off.section(), rotating());
  EXPECT_EQ(made.balance.verdict, balance::BalanceVerdict::NotBalanced) << made.remarks.back();
  EXPECT_EQ(made.worst_offset, "C");
  const auto tells = [](const std::string& remark) {
    return remark.find("the cutoffs of horizon 'C' on fault 'F1' stay") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(made.remarks.begin(), made.remarks.end(), tells), 1);
}

TEST(RigidJigsaw, BlocksThatShareNoBedWithTheOthersAreNamed) {
  Section section = three_blocks.section();
  for (section::Horizon& horizon : section.horizons) {
    if (horizon.name.find("(3)") != std::string::npos) horizon.name = horizon.piece_of = "other " + horizon.piece_of;
  }
  const auto refused = restore_blockwise(section, rotating(), {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_NE(to_string(refused.error()).find("'block 3'"), std::string::npos) << to_string(refused.error());
}

TEST(RigidJigsaw, WhatBelongsToADatumIsRefused) {
  BlockwiseParams how = rotating();
  how.elevation = 0.0;
  EXPECT_FALSE(restore_blockwise(three_blocks.section(), how, {}, {}));
  how = rotating();
  how.jigsaw = false;
  how.block = {"block 1"};
  how.fit.reset();
  EXPECT_FALSE(restore_blockwise(three_blocks.section(), how, {}, {}));
  unfold::RestoreParams params;
  params.method = unfold::RestoreMethod::Flexural;
  EXPECT_FALSE(restore_blockwise(three_blocks.section(), rotating(), params, {}));
}

TEST(TurnAndShift, FindsKnownMotionsAndElseTheLeastSumOfSquares) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3000.0, 3000.0), angle(-60.0, 60.0), noise(-20.0, 20.0);
  for (const double rough : {0.0, 1.0}) {
    // Places that were one, each in the frames of two blocks of a ring of six.
    constexpr std::size_t count = 6;
    std::vector<Turn> turns;
    std::vector<std::string> names;
    for (std::size_t b = 0; b < count; ++b) {
      turns.push_back({{place(random), place(random)}, b == 0 ? 0.0 : angle(random)});
      names.push_back(std::to_string(b));
    }
    std::vector<Match> matches;
    for (std::size_t b = 0; b < count; ++b) {
      const std::size_t next = (b + 1) % count;
      for (int k = 0; k < 5; ++k) {
        const geom::Point p{place(random), place(random)};
        const geom::Vector off{rough * noise(random), rough * noise(random)};
        matches.push_back({b, next, turns[b].of(p), turns[next].of(p) + off, 1.0 + k});
      }
    }
    const auto motions = turn_and_shift(names, 0, matches, rock_size);
    ASSERT_TRUE(motions) << to_string(motions.error());
    const auto sum = [&](const std::vector<RigidMotion>& of) {
      double total = 0.0;
      for (const Match& m : matches) {
        const double d = geom::distance(of[m.left].forward(m.at_left), of[m.right].forward(m.at_right));
        total += m.weight * d * d;
      }
      return total;
    };
    if (rough == 0.0) {
      for (std::size_t b = 0; b < count; ++b) {
        const geom::Point p{100.0, 200.0};
        EXPECT_LT(geom::distance((*motions)[b].forward(turns[b].of(p)), p), 1e-9 * rock_size);
      }
    }
    // No motion nearby does better.
    for (std::size_t b = 1; b < count; ++b) {
      for (const double by : {-1e-3, 1e-3}) {
        for (int which = 0; which < 3; ++which) {
          std::vector<RigidMotion> other = *motions;
          if (which == 0) other[b].turn += by;
          if (which == 1) other[b].by.x += 1e3 * by;
          if (which == 2) other[b].by.y += 1e3 * by;
          EXPECT_GT(sum(other), sum(*motions));
        }
      }
    }
  }
}

}  // namespace
}  // namespace recon::jigsaw
