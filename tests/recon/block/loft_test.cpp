// Blocks lofted between sections: refusals, sections drawn and ordered otherwise, and volumes by closed forms.

#include "recon/block/loft.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "recon/block/block_mesh.h"
#include "shared/solid/check/validate.h"
#include "shared/solid/measure.h"
#include "shared/solid/mesh_solid.h"
#include "tests/recon/block/sections.h"

namespace recon::block::loft_test {
namespace {

using dobra::io::lines::Trace;
using geom::Point;
using testing::HasSubstr;

/// Two layers that lie level, of a width, the beds at these heights.
section::Section level(double width, std::array<double, 3> z, const std::string& middle = "middle") {
  section::Section section;
  section.horizons = {test::horizon("top", {{0, z[0]}, {width, z[0]}}),
                      test::horizon(middle, {{0, z[1]}, {0.3 * width, z[1]}, {width, z[1]}}),
                      test::horizon("base", {{0, z[2]}, {width, z[2]}})};
  return test::made(std::move(section));
}

Trace trace(double x, double y, double degrees = 0.0) {
  const double a = degrees * std::acos(-1.0) / 180.0;
  return {x, y, degrees == 0.0 ? 1.0 : std::cos(a), degrees == 0.0 ? 0.0 : std::sin(a)};
}

/// The section drawn from its other end, along the trace from there.
LoftedSection turned_round(LoftedSection placed) {
  const double width = box_of(placed.section).high.x;
  const auto turn = [width](geom::Polyline& line) {
    for (Point& p : line.points) p.x = width - p.x;
  };
  for (auto& horizon : placed.section.horizons) {
    turn(horizon.line);
    horizon.line = geom::reversed(std::move(horizon.line));  // as reading has them
  }
  for (auto& line : placed.section.lines) turn(line.line);
  placed.section = test::made(std::move(placed.section));
  Trace& t = placed.trace;
  t = {t.x + width * t.east, t.y + width * t.north, -t.east, -t.north};
  return placed;
}

Block lofted(const std::vector<LoftedSection>& sections) {
  auto made = loft(sections);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  return made ? std::move(*made) : Block{};
}

base::Error refused(const std::vector<LoftedSection>& sections) {
  const auto made = loft(sections);
  EXPECT_FALSE(made);
  return made ? base::Error{} : made.error();
}

TEST(LoftedBlock, SectionsThatDoNotAgreeAreRefusedWithTheirNamesAndThePlaceOnTheMap) {
  const LoftedSection south{"South", level(100, {0, -10, -20}), trace(500, 900)};
  const base::Error other = refused({south, {"North", level(100, {0, -10, -20}, "other"), trace(500, 960)}});
  EXPECT_THAT(other.message, HasSubstr("the same units in the same order"));
  ASSERT_TRUE(other.place && other.place->x && other.place->y);
  EXPECT_THAT(other.place->item, testing::AllOf(HasSubstr("South"), HasSubstr("North")));
  EXPECT_GE(*other.place->x, 499.0);
  EXPECT_GE(*other.place->y, 899.0);
  // Across each other, one on the other, one alone.
  EXPECT_THAT(refused({south, {"North", level(100, {0, -10, -20}), trace(550, 850, 90)}}).message, HasSubstr("cross"));
  (void)refused({south, {"North", level(100, {0, -10, -20}), trace(500, 900)}});
  EXPECT_THAT(refused({south}).message, HasSubstr("two sections"));
  // Upside down: the same lines, their order turned.
  (void)refused({south, {"North", level(100, {-20, -10, 0}), trace(500, 960)}});
}

TEST(LoftedBlock, EqualSectionsMakeWhatASectionMakesAlongStrike) {
  const section::Section section = test::faulted();
  const Block extruded = test::block(section, 64.0);
  const Block block = lofted({{"a", section, trace(0, 0)}, {"b", section, trace(0, 64)}});
  ASSERT_EQ(block.units.size(), extruded.units.size());
  for (std::size_t u = 0; u < block.units.size(); ++u) {
    EXPECT_EQ(block.units[u].name, extruded.units[u].name);
    EXPECT_NEAR(block.units[u].volume, extruded.units[u].volume, 1e-9);
    EXPECT_NEAR(block.units[u].area, extruded.units[u].area, 1e-9);
    EXPECT_TRUE(dobra::solid::check::violations(block.units[u].solid).empty());
  }
  EXPECT_NEAR(block.volume, extruded.volume, 1e-9);
  EXPECT_EQ(block.length, 64.0);
}

/// Widths w and thicknesses t change evenly from 1 to 2: the integral of w t is L (2 w1 t1 + w1 t2 + w2 t1 + 2 w2
/// t2)/6.
double wedge(double length, double w1, double t1, double w2, double t2) {
  return length * (2 * w1 * t1 + w1 * t2 + w2 * t1 + 2 * w2 * t2) / 6.0;
}

TEST(LoftedBlock, VolumesAreThoseOfTheClosedForm) {
  const LoftedSection a{"a", level(100, {0, -10, -30}), trace(0, 0)};
  const LoftedSection b{"b", level(160, {40, 20, 15}), trace(0, 60)};
  const Block block = lofted({a, b});
  ASSERT_EQ(block.units.size(), 2U);
  EXPECT_NEAR(block.units[0].volume, wedge(60, 100, 10, 160, 20), 1e-9);
  EXPECT_NEAR(block.units[1].volume, wedge(60, 100, 20, 160, 5), 1e-9);
  EXPECT_NEAR(block.volume, block.units[0].volume + block.units[1].volume, 1e-9);
  EXPECT_NEAR(block.units[0].area, 1000.0, 1e-9);
}

TEST(LoftedBlock, OrderAndEndsOfSectionsDoNotMatter) {
  const LoftedSection a{"a", level(100, {0, -10, -30}), trace(7, 11, 33)};
  const auto beside = [&](double along, const section::Section& section, const char* name) {
    const Trace& t = a.trace;
    return LoftedSection{name, section, {t.x - along * t.north, t.y + along * t.east, t.east, t.north}};
  };
  const LoftedSection b = beside(50, level(120, {5, -8, -20}), "b"), c = beside(90, level(90, {9, 0, -20}), "c");
  const double first = wedge(50, 100, 10, 120, 13) + wedge(40, 120, 13, 90, 9);
  const double second = wedge(50, 100, 20, 120, 12) + wedge(40, 120, 12, 90, 20);
  for (const auto& sections : std::vector<std::vector<LoftedSection>>{{a, b, c},
                                                                      {c, a, b},
                                                                      {a, turned_round(b), c},
                                                                      {turned_round(a), b, c},
                                                                      {turned_round(c), turned_round(b), a}}) {
    const Block block = lofted(sections);
    ASSERT_EQ(block.units.size(), 2U);
    EXPECT_NEAR(block.units[0].volume, first, 1e-8);
    EXPECT_NEAR(block.units[1].volume, second, 1e-8);
    EXPECT_NEAR(block.length, 90.0, 1e-9);
    // On the map, as it is written.
    const auto mesh = mesh_of(block, 1000);
    ASSERT_TRUE(mesh);
    for (const geom::Point3 p : mesh->mesh.points) {
      const double along = -(p.x - 7) * a.trace.north + (p.y - 11) * a.trace.east;
      EXPECT_TRUE(std::abs(along) < 1e-9 || std::abs(along - 50) < 1e-9 || std::abs(along - 90) < 1e-9) << along;
    }
  }
}

TEST(LoftedBlock, ObliqueSectionsFarFromTheOriginBoundWhatLiesBetweenThem) {
  // Level beds: the volume is the area on the map between the traces times the thickness.
  const LoftedSection a{"a", level(100, {0, -10, -30}), trace(5e5, 7e6)};
  const LoftedSection b{"b", level(120, {0, -10, -30}), trace(5e5 - 10, 7e6 + 60, 20)};
  const Block block = lofted({a, b});
  const Point p{-10, 60}, q{-10 + 120 * std::cos(std::acos(-1.0) / 9), 60 + 120 * std::sin(std::acos(-1.0) / 9)};
  const double area = geom::signed_area({{{0, 0}, {100, 0}, q, p}, true});
  EXPECT_NEAR(block.units[0].volume, 10 * area, 1e-5);
  EXPECT_NEAR(block.units[1].volume, 20 * area, 1e-5);
}

TEST(LoftedBlock, UnitsThatWouldCrossBetweenSectionsAreRefused) {
  // Polygons apart from each other that change places.
  const auto two = [](double left, double right) {
    section::Section section;
    const auto square = [](double x, double z) {
      return std::vector<Point>{{x, z}, {x + 10, z}, {x + 10, z + 10}, {x, z + 10}};
    };
    section.units = {test::unit("A", square(left, 0)), test::unit("B", square(right, 0))};
    return test::made(std::move(section));
  };
  const Block apart = lofted({{"a", two(0, 40), trace(0, 0)}, {"b", two(5, 45), trace(0, 50)}});
  ASSERT_EQ(apart.units.size(), 2U);
  EXPECT_NEAR(apart.volume, 2 * 100 * 50, 1e-9);
  const base::Error crossed = refused({{"a", two(0, 40), trace(0, 0)}, {"b", two(40, 0), trace(0, 50)}});
  ASSERT_TRUE(crossed.place);
}

}  // namespace
}  // namespace recon::block::loft_test
