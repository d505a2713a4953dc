#include "recon/block/block.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <random>
#include <set>

#include "shared/solid/check/validate.h"
#include "shared/solid/measure.h"
#include "shared/topo/adjacency.h"
#include "tests/recon/block/sections.h"

namespace recon::block {
namespace {

using test::find;
using test::horizon;
using test::line;
using test::Point;
using test::told;
using test::unit;
using Rational = boost::multiprecision::cpp_rational;

/// Of a contour by the rule of the surveyor, in fractions.
Rational exact_area(const std::vector<Point>& points) {
  Rational sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    const Point q = points[(i + 1) % points.size()];
    sum += Rational(p.x) * Rational(q.y) - Rational(p.y) * Rational(q.x);
  }
  return abs(sum) / 2;
}
double nearest(const Rational& value) {
  using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>>;
  return static_cast<double>(Wide(numerator(value)) / Wide(denominator(value)));
}

/// Every face of a unit is its own, or that of one neighbour, turned over; and the solids are sound.
void expect_conforming(const Block& block) {
  std::map<std::vector<std::array<double, 3>>, std::vector<std::size_t>> faces;
  double sum = 0.0;
  for (std::size_t u = 0; u < block.units.size(); ++u) {
    EXPECT_TRUE(dobra::solid::check::violations(block.units[u].solid).empty()) << block.units[u].name;
    sum += block.units[u].volume;
    const auto& mesh = block.units[u].shape.mesh;
    for (const auto& face : mesh.faces) {
      std::vector<std::array<double, 3>> corners;
      for (const auto& loop : face) {
        for (const std::uint32_t p : loop) corners.push_back({mesh.points[p].x, mesh.points[p].y, mesh.points[p].z});
      }
      std::sort(corners.begin(), corners.end());
      faces[corners].push_back(u);
    }
  }
  for (const auto& [corners, units] : faces) {
    EXPECT_LE(units.size(), 2U);
    EXPECT_TRUE(units.size() < 2 || units[0] != units[1]);
  }
  EXPECT_NEAR(sum, block.volume, 1e-12 * block.volume);
  // Two units that overlapped would have faces within each other: the plane half way has their areas once.
  const auto half = block.sections->cut({0.0, -1.0, 0.0, 0.5 * block.length});
  ASSERT_TRUE(half);
  double area = 0.0;
  for (const dobra::topo::FaceId f : half->plane.faces()) {
    if (half->plane.attribute(f).has_value()) area += dobra::topo::area(half->plane, f);
  }
  EXPECT_NEAR(area, block.area, 1e-12 * block.area);
}

TEST(Block, LayersShareFacesAndHaveTheirAreaTimesTheLength) {
  const Block block = test::block(test::layers(), 30.0);
  ASSERT_EQ(block.units.size(), 2U);
  EXPECT_EQ(block.units[0].name, "top - middle");
  EXPECT_EQ(block.units[1].name, "middle - base");
  EXPECT_EQ(block.units[0].volume, 1200.0 * 30.0);
  EXPECT_EQ(block.units[1].volume, 1000.0 * 30.0);
  EXPECT_EQ(block.volume, 2200.0 * 30.0);
  EXPECT_EQ(block.area, 2200.0);
  // By hand: seven corners a side of the block; the point on the straight base is none.
  EXPECT_EQ(block.counts.vertices, 14U);
  EXPECT_EQ(block.counts.edges, 8U + 8U + 7U);
  EXPECT_EQ(block.counts.faces, 8U + 2U + 2U);
  EXPECT_TRUE(block.findings.empty());
  expect_conforming(block);
}

TEST(Block, FacesAreCalledAfterTheirLines) {
  const Block block = test::block(test::faulted(), 30.0);
  std::map<std::string, std::set<std::string>> names;
  for (const BlockUnit& unit : block.units) names[unit.name].insert(unit.shape.names.begin(), unit.shape.names.end());
  ASSERT_TRUE(names.contains("top - base"));
  const std::set<std::string> expected{
      "end", "horizon base (1)", "horizon base (2)", "horizon top (1)", "horizon top (2)", "side", "start", "fault F"};
  EXPECT_EQ(names["top - base"], expected);
  for (dobra::solid::FaceId f(0); f.index() < block.units[0].solid.face_count();
       f = dobra::solid::FaceId(f.index() + 1))
    EXPECT_TRUE(names["top - base"].contains(block.units[0].solid.name(f)));
}

TEST(Block, AUnitOnBothSidesOfAFaultIsOneSolid) {
  const Block block = test::block(test::faulted(), 30.0);
  const BlockUnit* const whole = find(block, "top - base");
  ASSERT_NE(whole, nullptr);
  EXPECT_EQ(whole->parts, 1U);
  expect_conforming(block);
}

TEST(Block, VolumesAreTheExactAreaTimesTheLengthRoundedOnce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    std::vector<Point> top;
    std::vector<Point> base;
    for (int i = 0; i <= 30; ++i) {
      top.push_back({i * 1e3 / 7.0 + 20.0 * draw(random), 1e4 + 100.0 * draw(random)});
      base.push_back({i * 1e3 / 7.0 + 20.0 * draw(random), 1e4 - 500.0 + 100.0 * draw(random)});
    }
    section::Section section;
    section.horizons = {horizon("top", top), horizon("base", base)};
    const double length = 777.7 + draw(random);
    const Block block = test::block(test::made(section), length);
    ASSERT_EQ(block.units.size(), 1U);
    std::vector<Point> contour = top;
    contour.insert(contour.end(), base.rbegin(), base.rend());
    EXPECT_EQ(block.units[0].area, nearest(exact_area(contour)));
    EXPECT_EQ(block.units[0].volume, nearest(exact_area(contour) * Rational(length)));
    EXPECT_EQ(block.volume, block.units[0].volume);
  }
}

TEST(Block, PolygonsWithAnotherOneDrawnUponThemHaveAHole) {
  section::Section section;
  section.units = {unit("salt", {{0, -10}, {10, -10}, {10, 0}, {0, 0}}),
                   unit("lens", {{4, -6}, {6, -6}, {6, -4}, {4, -4}})};
  const Block block = test::block(test::made(section), 5.0);
  ASSERT_EQ(block.units.size(), 2U);
  EXPECT_EQ(find(block, "salt")->volume, 96.0 * 5.0);
  EXPECT_EQ(find(block, "lens")->volume, 4.0 * 5.0);
  EXPECT_EQ(find(block, "salt")->solid.counts().handles, 1);
  EXPECT_EQ(block.volume, 500.0);
  expect_conforming(block);
}

TEST(Block, ALensThatTouchesTheOuterContourInAVertexIsSound) {
  section::Section section;
  section.units = {unit("salt", {{0, -10}, {10, -10}, {10, 0}, {5, 0}, {0, 0}}),
                   unit("lens", {{5, 0}, {4, -4}, {6, -4}})};
  const Block block = test::block(test::made(section), 5.0);
  EXPECT_EQ(find(block, "salt")->volume, 96.0 * 5.0);
  expect_conforming(block);
}

TEST(Block, PartsOfAUnitThatTouchInAVertexAreParts) {
  section::Section section;
  section.units = {unit("a", {{0, 0}, {2, 0}, {1, 1}}), unit("b", {{1, 1}, {2, 2}, {0, 2}})};
  section.units[0].piece_of = section.units[1].piece_of = "all";
  const Block block = test::block(test::made(section), 3.0);
  ASSERT_EQ(block.units.size(), 1U);
  EXPECT_EQ(block.units[0].name, "all");
  EXPECT_EQ(block.units[0].parts, 2U);
  EXPECT_EQ(block.units[0].volume, 6.0);
  expect_conforming(block);
}

TEST(Block, OverlapsAndGapsOfPolygonsAreTold) {
  section::Section section;
  section.units = {unit("a", {{0, 0}, {5, 0}, {5, 5}, {0, 5}}), unit("b", {{4, 0}, {9, 0}, {9, 5}, {4, 5}}),
                   unit("c", {{0, 5}, {3, 5}, {4, 6}, {5, 5}, {9, 5}, {9, 9}, {0, 9}})};
  const Block block = test::block(test::made(section), 1.0);
  EXPECT_TRUE(told(block.findings, "overlap"));
  EXPECT_TRUE(told(block.findings, "gap"));
  EXPECT_EQ(find(block, "a")->volume, 20.0);  // the later one has what both hold
  EXPECT_EQ(find(block, "b")->volume, 25.0);
  expect_conforming(block);
}

TEST(Block, AnEndThatRoundingLeftBesideItsFaultIsToldAndOneOnItOrPastItIsNot) {
  const auto shifted = [](double by) {
    section::Section section = test::faulted();
    section.faces = nullptr;
    section.horizons[0].line.points.back().x += by;  // the end of "top (1)" at F
    return test::block(test::made(section), 5.0);
  };
  const auto at_ends = [](const Block& block) {
    std::vector<Point> places;
    for (const base::Finding& finding : block.findings) {
      if (finding.code == "open_end") places.push_back({*finding.place.x, *finding.place.y});
    }
    return places;
  };
  EXPECT_TRUE(at_ends(shifted(0.0)).empty());
  EXPECT_TRUE(at_ends(shifted(2e-5)).empty());
  EXPECT_EQ(at_ends(shifted(-2e-5)), (std::vector<Point>{{40.0 - 2e-5, 0.0}}));
  EXPECT_EQ(at_ends(shifted(-0.5)).size(), 1U);               // as centimetres in a section of kilometres do
  EXPECT_TRUE(at_ends(shifted(-5.0)).empty());                // told when the section is read
  EXPECT_GT(shifted(0.0).area, shifted(-2e-5).area + 100.0);  // what lies there is open
}

TEST(Block, HorizonsThatRunTogetherShareTheirFaces) {
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {100, 0}}), horizon("cut", {{0, -10}, {50, -20}, {100, -20}}),
                      horizon("base", {{0, -20}, {50, -20}, {100, -20}})};
  const Block block = test::block(test::made(section), 4.0);
  EXPECT_EQ(block.volume, 2000.0 * 4.0);
  double sum = 0.0;
  for (const BlockUnit& unit : block.units) sum += unit.volume;
  EXPECT_EQ(sum, block.volume);
  expect_conforming(block);
}

TEST(Block, SectionsThatBoundNothingAndBadLengthsAreRefused) {
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {100, 0}})};
  const auto nothing = extrude(test::made(section), {10.0});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, base::ErrorCode::BadSection);
  for (const double length : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto refused = extrude(test::layers(), {length});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::ErrorCode::InvalidOption);
  }
}

TEST(Block, RandomStacksWithFaultsConform) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    const auto draw = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    section::Section section;
    for (int k = 0; k < 5; ++k) {
      std::vector<Point> points;
      for (int i = 0; i <= 25; ++i)
        points.push_back(
            {i + (i == 0 || i == 25 ? draw(-0.3, 0.3) : 0.0), 2.0 * std::sin(0.4 * i) - 1.5 * k + draw(-0.2, 0.2)});
      section.horizons.push_back(horizon("h" + std::to_string(k), points));
    }
    section.lines = {line(section::LineKind::Fault, "F", {{draw(5, 12), 4}, {draw(12, 20), -9}}),
                     line(section::LineKind::Fault, "G", {{draw(5, 20), draw(-3, 2)}, {draw(5, 20), draw(-9, -3)}})};
    const Block block = test::block(test::made(section), draw(1.0, 50.0));
    EXPECT_GE(block.units.size(), 4U);
    expect_conforming(block);
  }
}

TEST(Block, ASideThatIsDrawnAslantIsTold) {
  section::Section section;
  section.horizons = {horizon("A", {{0, 100}, {1000, 100}}), horizon("B", {{0, 0}, {600, 0}})};
  const Block slanted = test::block(test::made(section), 100.0);
  ASSERT_TRUE(told(slanted.findings, "slanted_side"));
  const auto& side = *std::find_if(slanted.findings.begin(), slanted.findings.end(),
                                   [](const auto& f) { return f.code == "slanted_side"; });
  EXPECT_NEAR(*side.place.x, 800.0, 1e-9);
  EXPECT_NE(side.message.find("400 m apart"), std::string::npos) << side.message;
  EXPECT_FALSE(told(test::block(test::layers(), 100.0).findings, "slanted_side"));
  section.border = geom::Polyline{{{0, 0}, {1000, 0}, {1000, 100}, {0, 100}}, true};
  EXPECT_FALSE(told(test::block(test::made(section), 100.0).findings, "slanted_side"));
}

}  // namespace
}  // namespace recon::block
