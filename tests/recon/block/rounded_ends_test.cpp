// Sections whose coordinates files have rounded: beds end some millimetres beside their faults, and have the volumes of
// the section that was not rounded. What was drawn apart stays apart.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "recon/block/block.h"
#include "recon/block/loft.h"
#include "recon/input/input.h"
#include "tests/recon/block/sections.h"

namespace recon::block::rounded_ends_test {
namespace {

using geom::Point;
using input::SectionInput;
using testing::HasSubstr;

constexpr double width = 1000.0;
constexpr double along = 100.0;

/// A fault as x over z, linear between its corners, from the top down.
class Fault {
 public:
  explicit Fault(std::vector<Point> corners) : corners_(std::move(corners)) {}
  [[nodiscard]] const std::vector<Point>& corners() const { return corners_; }
  [[nodiscard]] double x(double z) const {
    std::size_t i = 1;
    while (i + 1 < corners_.size() && corners_[i].y > z) ++i;
    const Point a = corners_[i - 1], b = corners_[i];
    return a.x + (b.x - a.x) * (z - a.y) / (b.y - a.y);
  }
  /// The integral of x from z = low to high: trapezoids between corners.
  [[nodiscard]] double area(double low, double high) const {
    std::vector<double> z{low, high};
    for (const Point p : corners_) {
      if (p.y > low && p.y < high) z.push_back(p.y);
    }
    std::sort(z.begin(), z.end());
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < z.size(); ++i) sum += 0.5 * (x(z[i]) + x(z[i + 1])) * (z[i + 1] - z[i]);
    return sum;
  }

 private:
  std::vector<Point> corners_;
};

/// Level beds between faults, which do not cross among the beds; each block has its own heights.
struct Exact {
  std::vector<Fault> faults;                     ///< From the left.
  std::vector<std::vector<double>> heights;      ///< Of each block: top, middle, base.
  std::vector<std::vector<Point>> passing = {};  ///< Further faults that displace nothing.
  std::vector<Point> border = {};
  double scale = 1.0;

  [[nodiscard]] double left(std::size_t block, double z) const {
    return block > 0 ? faults[block - 1].x(z) : border.empty() ? 0.0 : Fault({border[3], border[0]}).x(z);
  }
  [[nodiscard]] double right(std::size_t block, double z) const {
    return block < faults.size() ? faults[block].x(z) : border.empty() ? width : Fault({border[2], border[1]}).x(z);
  }
  /// Of the layer under bed i.
  [[nodiscard]] double area(std::size_t i) const {
    double sum = 0.0;
    for (std::size_t b = 0; b < heights.size(); ++b) {
      const double high = heights[b][i], low = heights[b][i + 1];
      const auto side = [&](std::size_t fault, bool exists, double outer, const std::vector<Point>& sides) {
        return exists          ? faults[fault].area(low, high)
               : sides.empty() ? outer * (high - low)
                               : Fault(sides).area(low, high);
      };
      const bool bordered = !border.empty();
      sum += side(b, b < faults.size(), width,
                  bordered ? std::vector<Point>{border[2], border[1]} : std::vector<Point>{}) -
             side(b - 1, b > 0, 0.0, bordered ? std::vector<Point>{border[3], border[0]} : std::vector<Point>{});
    }
    return scale * scale * sum;
  }
};

/// As a file with coordinates in whole multiples of `unit` has it.
SectionInput written(const Exact& exact, double unit) {
  SectionInput input;
  const auto line = [&](const std::string& name, std::vector<Point> points, const std::string& whole = "") {
    input::HorizonInput made;
    made.name = name;
    made.piece_of = whole;
    for (Point p : points) {
      p = {exact.scale * p.x, exact.scale * p.y};
      made.points.push_back(
          unit > 0.0 ? Point{std::round(p.x / unit) / (1.0 / unit), std::round(p.y / unit) / (1.0 / unit)} : p);
    }
    return made;
  };
  const char* const names[] = {"top", "middle", "base"};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t b = 0; b < exact.heights.size(); ++b) {
      const double z = exact.heights[b][i];
      const double from = exact.left(b, z), to = exact.right(b, z);
      input.horizons.push_back(line(std::string(names[i]) + " (" + std::to_string(b + 1) + ")",
                                    {{from, z}, {from + 0.37 * (to - from), z}, {to, z}}, names[i]));
    }
  }
  for (const Fault& fault : exact.faults)
    input.faults.emplace_back(line("F" + std::to_string(input.faults.size() + 1), fault.corners()));
  for (const auto& points : exact.passing)
    input.faults.emplace_back(line("F" + std::to_string(input.faults.size() + 1), points));
  if (!exact.border.empty()) input.borders.push_back(line("border", exact.border));
  return input;
}

input::ReadSection read(const SectionInput& input) {
  auto made = read_section(input, {}, {});
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  return made ? std::move(*made) : input::ReadSection{};
}

double volume(const Block& block, const std::string& unit) {
  const BlockUnit* const found = test::find(block, unit);
  return found == nullptr ? 0.0 : found->volume;
}

/// What rounding to `unit` changes at most: beds go up or down by half of it, faults aside by twice its diagonal.
double rounding(const Exact& exact, double unit) {
  const double faults = 100.0 * static_cast<double>(2 * exact.faults.size() + 2);
  return along * unit * (width + 3.0 * faults) * exact.scale;
}

Exact listric(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  std::vector<Point> corners;
  const double a = 300 + 100 * any(random), steep = 0.2 + 0.2 * any(random);
  for (int i = 0; i <= 12; ++i) {
    const double down = 20.0 * i;
    corners.push_back({a + steep * down + 0.004 * down * down, 30.0 + any(random) - down});
  }
  const double throws = 25 + 10 * any(random), z = -any(random);
  return {{Fault(corners)},
          {{z, z - 41.7 - any(random), z - 97.3}, {z - throws, z - throws - 41.1, z - throws - 96.6}}};
}
Exact two_faults(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  Exact made = listric(random);
  const double x = 800 + 50 * any(random), z = any(random) - 10;
  made.faults.emplace_back(std::vector<Point>{{x, 60}, {x - 20 * any(random), -60}, {x + 30 * any(random), -260}});
  made.heights.push_back({z, z - 40.9, z - 96.1});
  return made;
}
Exact reverse(std::mt19937& random) {
  std::uniform_real_distribution<double> any(0.0, 1.0);
  Exact made = listric(random);
  for (double& z : made.heights[1]) z += 60 + any(random);
  std::vector<Point> corners = made.faults[0].corners();
  corners.front() = {corners.front().x - 20, 80.0};
  made.faults = {Fault(corners)};
  return made;
}
Exact upright(std::mt19937& random) {
  Exact made = listric(random);
  const double x = made.faults[0].corners()[3].x;
  made.faults = {Fault({{x, 40}, {x, -240}})};
  return made;
}
/// The fault ends 2 cm below the deepest bed.
Exact at_tip(std::mt19937& random) {
  Exact made = listric(random);
  const double low = made.heights[1][2] - 0.02;
  std::vector<Point> corners;
  for (const Point p : made.faults[0].corners()) {
    if (p.y > low) corners.push_back(p);
  }
  corners.push_back({made.faults[0].x(low), low});
  made.faults = {Fault(corners)};
  return made;
}
/// Another fault crosses 3 cm above a cutoff.
Exact at_crossing(std::mt19937& random) {
  Exact made = listric(random);
  const double z = made.heights[0][1] + 0.03, x = made.faults[0].x(z);
  made.passing.push_back({{x + 61.3, z + 100}, {x - 73.7, z - 120.22}});
  return made;
}
Exact bordered(std::mt19937& random) {
  Exact made = listric(random);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  made.border = {
      {40 + any(random), -300}, {910 + any(random), -300}, {980 + any(random), 100}, {10 + any(random), 100}};
  return made;
}

struct Shape {
  const char* name;
  std::function<Exact(std::mt19937&)> make;
};
std::vector<Shape> shapes() {
  return {{"listric", listric}, {"two faults", two_faults},   {"reverse", reverse},  {"upright", upright},
          {"at tip", at_tip},   {"at crossing", at_crossing}, {"bordered", bordered}};
}

TEST(RoundedEnds, BlocksInCentimetresHaveTheVolumesOfTheSectionThatWasNotRounded) {
  for (const Shape& shape : shapes()) {
    int lost = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
      SCOPED_TRACE(std::string(shape.name) + ", seed " + std::to_string(seed));
      std::mt19937 random(seed);
      const Exact exact = shape.make(random);
      SectionInput input = written(exact, 0.01);
      const input::ReadSection section = read(input);
      for (const std::string& remark : section.remarks) EXPECT_THAT(remark, testing::Not(HasSubstr("run together")));
      const Block made = test::block(section.section, along);
      EXPECT_FALSE(test::told(made.findings, "open_end"));
      EXPECT_NEAR(volume(made, "top - middle"), along * exact.area(0), rounding(exact, 0.01));
      EXPECT_NEAR(volume(made, "middle - base"), along * exact.area(1), rounding(exact, 0.01));
      input.snap_to_faults = 0.0;
      const auto open = extrude(read(input).section, {along, std::nullopt});
      const double left = open ? volume(*open, "top - middle") + volume(*open, "middle - base") : 0.0;
      lost += left < along * (exact.area(0) + exact.area(1)) - 10.0 * rounding(exact, 0.01);
      const Block unrounded = test::block(read(written(exact, 0.0)).section, along);
      EXPECT_NEAR(volume(unrounded, "top - middle"), along * exact.area(0), 1e-3);
      EXPECT_NEAR(volume(unrounded, "middle - base"), along * exact.area(1), 1e-3);
    }
    if (shape.name != std::string("upright")) {
      EXPECT_GT(lost, 3) << shape.name;
    }
  }
}

TEST(RoundedEnds, HowManyHowFarAndWhereIsTold) {
  SectionInput input;
  const auto line = [](const char* name, std::vector<Point> points, const char* whole = "") {
    input::HorizonInput made;
    made.name = name, made.points = std::move(points), made.piece_of = whole;
    return made;
  };
  // The fault is at x = 500 - z / 3; 33.333.. is written 33.33, and 66.666.. is written 66.67.
  input.horizons = {line("a (1)", {{0, 0}, {500, 0}}, "a"), line("a (2)", {{516.67, -50}, {1000, -50}}, "a"),
                    line("b (1)", {{0, -100.01}, {533.33, -100.01}}, "b"),
                    line("b (2)", {{550, -150}, {1000, -150}}, "b")};
  input.faults = {line("F", {{490, 30}, {600, -300}})};
  const auto told = [&] {
    std::vector<std::string> found;
    for (const std::string& remark : read(input).remarks) {
      if (remark.find("rounded") != std::string::npos) found.push_back(remark);
    }
    return found;
  };
  ASSERT_EQ(told().size(), 1U);
  // "a (2)" is 0.01 / 3 off along x, "b (1)" is 0.02 / 3: times 3 / sqrt 10 across the fault.
  EXPECT_THAT(told()[0], HasSubstr("2 ends of lines lay beside the lines that they end on"));
  EXPECT_THAT(told()[0], HasSubstr("to 0.01 m"));
  EXPECT_THAT(told()[0], HasSubstr("moved up to 0.00632 m, the farthest at (533.336, -100.008), horizon 'b (1)'"));
  const input::ReadSection made = read(input);
  EXPECT_EQ(made.places.at(told()[0]).item, "horizon 'b (1)'");
  EXPECT_NEAR(made.places.at(told()[0]).x.value_or(0.0), 533.336, 1e-3);
  for (const double said : {0.0, 0.005}) {
    input.snap_to_faults = said;
    EXPECT_TRUE(told().empty());
    const section::Section section = read(input).section;
    EXPECT_EQ(section.horizons[2].line.points.back(), (Point{533.33, -100.01})) << said;
    EXPECT_EQ(section.lines[0].line.points.size(), said == 0.0 ? 2U : 3U);  // 0.005 takes the other one
  }
}

/// Bed "middle (1)" ends at x beside the fault at x = 500.
SectionInput gap(double x, double other) {
  SectionInput input;
  const auto line = [](const char* name, std::vector<Point> points, const char* whole = "") {
    input::HorizonInput made;
    made.name = name, made.points = std::move(points), made.piece_of = whole;
    return made;
  };
  input.horizons = {line("top (1)", {{0, 0}, {500, 0}}, "top"),
                    line("top (2)", {{500, -20}, {1000, -20}}, "top"),
                    line("middle (1)", {{0, -50}, {other, -51}, {x, -50}}, "middle"),
                    line("middle (2)", {{500, -70}, {1000, -70}}, "middle"),
                    line("base (1)", {{0, -100}, {500, -100}}, "base"),
                    line("base (2)", {{500, -120}, {1000, -120}}, "base")};
  input.faults = {line("F", {{500, 30}, {500, -200}})};
  return input;
}

TEST(RoundedEnds, WhatIsFartherThanTheRoundingStaysOpenAndIsTold) {
  struct Case {
    double end, other;
    input::LineUnit unit;
    bool joined;
  };
  for (const Case& c :
       {Case{450.0, 100.01, {}, false},        // 50 m before it
        Case{499.97, 100.001, {}, false},      // 3 cm, of coordinates in millimetres
        Case{499.98, 100.01, {}, false},       // 2 cm, of centimetres: more than sqrt 2 of them
        Case{499.99, 100.01, {}, true},        // 1 cm, of centimetres
        Case{499.99, 100.001, {}, false},      // 1 cm, of millimetres
        Case{499.999, 100.001, {}, true},      // 1 mm, of millimetres
        Case{499.0, 100.0, {}, false},         // 1 m, of metres: more than 1e-4 of the section
        Case{499.99, 100.0 / 3.0, {}, false},  // computed
        Case{499.99, 100.01, input::LineUnit::Foot, true}, Case{499.97, 100.01, input::LineUnit::Foot, false}}) {
    SCOPED_TRACE(c.end);
    SectionInput input = gap(c.end, c.other);
    if (c.unit == input::LineUnit::Foot) input.unit = section::LengthUnit::Foot;
    const double metres = c.unit == input::LineUnit::Foot ? 0.3048 : 1.0;
    const input::ReadSection made_of = read(input);
    EXPECT_EQ(made_of.section.horizons[2].line.points.back() == (Point{metres * c.end, metres * -50.0}), !c.joined);
    bool told = false;
    for (const std::string& remark : made_of.remarks) told |= remark.find("run together") != std::string::npos;
    EXPECT_EQ(told, !c.joined);
    const Block made = test::block(made_of.section, along);
    EXPECT_EQ(test::told(made.findings, "open_end"), !c.joined && c.end > 480.0);
    if (c.joined) {
      EXPECT_NEAR(volume(made, "middle - base"), metres * metres * along * (500 * 50 + 500 * 50 - 250), along * 10);
    }
  }
}

TEST(RoundedEnds, TidySectionsStayAsTheyAreBitByBit) {
  for (const Shape& shape : shapes()) {
    std::mt19937 random(7);
    for (const double unit : {0.0, 1.0}) {
      const Exact exact = shape.make(random);
      SectionInput input = unit == 0.0 ? written(exact, 0.0) : gap(500.0, 100.01);
      const section::Section said = read(input).section;
      input.snap_to_faults = 0.0;
      const section::Section unsaid = read(input).section;
      for (std::size_t i = 0; i < said.horizons.size(); ++i)
        EXPECT_EQ(said.horizons[i].line.points, unsaid.horizons[i].line.points);
      for (std::size_t i = 0; i < said.lines.size(); ++i)
        EXPECT_EQ(said.lines[i].line.points, unsaid.lines[i].line.points);
    }
  }
}

/// Of a bed that an unconformity cuts, and a fault that ends on another one, 7 mm short each.
TEST(RoundedEnds, BedsAtAnUnconformityAndFaultsAtFaultsAreJoinedToo) {
  SectionInput input;
  const auto line = [](const char* name, std::vector<Point> points, const char* whole = "") {
    input::HorizonInput made;
    made.name = name, made.points = std::move(points), made.piece_of = whole;
    return made;
  };
  input.horizons = {line("cut", {{0, 0}, {1000, -30}}), line("bed", {{0, -90}, {600.01, -18.01}}),
                    line("base", {{0, -300.5}, {1000, -300.5}})};
  input.faults = {line("main", {{300, -100}, {700, -290}}), line("branch", {{600.33, -120}, {500.5, -195.23}})};
  const input::ReadSection made = read(input);
  const auto has = [](const geom::Polyline& line_of, Point p) {
    return std::count(line_of.points.begin(), line_of.points.end(), p) == 1;
  };
  EXPECT_TRUE(has(made.section.horizons[0].line, made.section.horizons[1].line.points.back()));
  EXPECT_TRUE(has(made.section.lines[0].line, made.section.lines[1].line.points.back()));
  EXPECT_EQ(made.section.horizons[1].line.points.front(), (Point{0, -90}));
}

/// Rounding may leave a bed's end on either side of the branch that it ends on: the branch then moves with it.
TEST(RoundedEnds, ABranchMovesThoughBedsEndOnIt) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Fault main({{1000, 50}, {1037.333, -777.777}});
    const double lowest = between(-520, -400);
    const Fault branch({{between(1200, 1600), 50}, {main.x(lowest), lowest}});
    SectionInput input;
    const auto line = [](const char* name, std::vector<Point> points, const char* whole = "") {
      input::HorizonInput made;
      made.name = name, made.piece_of = whole;
      for (const Point p : points)
        made.points.push_back({std::round(p.x / 0.01) / 100.0, std::round(p.y / 0.01) / 100.0});
      return made;
    };
    const double left = between(-250, -210), middle = left - 60, right = between(-250, -210);
    input.horizons = {line("bed (1)", {{0, left}, {main.x(left), left}}, "bed"),
                      line("bed (2)", {{main.x(middle), middle}, {branch.x(middle), middle}}, "bed"),
                      line("bed (3)", {{branch.x(right), right}, {2000, right}}, "bed")};
    input.faults = {line("main", main.corners()), line("branch", branch.corners())};
    const input::ReadSection made = read(input);
    const auto is_vertex = [&](std::size_t fault, Point p) {
      const std::vector<Point>& points = made.section.lines[fault].line.points;
      return std::count(points.begin(), points.end(), p) == 1;
    };
    EXPECT_TRUE(is_vertex(0, made.section.lines[1].line.points.back()));
    EXPECT_TRUE(is_vertex(0, made.section.horizons[0].line.points.back()));
    EXPECT_TRUE(is_vertex(0, made.section.horizons[1].line.points.front()));
    EXPECT_TRUE(is_vertex(1, made.section.horizons[1].line.points.back()));
    EXPECT_TRUE(is_vertex(1, made.section.horizons[2].line.points.front()));
  }
}

input::HorizonInput line(const char* name, std::vector<Point> points, const char* whole = "") {
  input::HorizonInput made;
  made.name = name, made.points = std::move(points), made.piece_of = whole;
  return made;
}

/// Where a branch leaves its main fault, in doubles, which are beside both: a bed that ends there ends on both.
TEST(RoundedEnds, ABedThatEndsWhereAFaultBranchesOffHasBothItsSides) {
  const Fault main({{1000, 50}, {1037.333, -777.777}});
  for (int i = 0; i < 40; ++i) {
    const double z = -250.0 - 1.31 * i;
    SCOPED_TRACE(z);
    const Point place{main.x(z), z};
    const Fault branch({{1400, 50}, place});
    SectionInput input;
    const auto bed = [&](const char* name, double from, double to, double height, const char* whole) {
      input.horizons.push_back(line(name, {{from, height}, {to, height}}, whole));
    };
    bed("top (1)", 0, main.x(0), 0, "top");
    bed("top (2)", main.x(-30), branch.x(-30), -30, "top");
    bed("top (3)", branch.x(-10), 2000, -10, "top");
    bed("bed (1)", 0, main.x(-150), -150, "bed");
    bed("bed (2)", place.x, 2000, z, "bed");
    bed("base (1)", 0, main.x(-500), -500, "base");
    bed("base (2)", main.x(-560), 2000, -560, "base");
    input.faults = {line("main", main.corners()), line("branch", branch.corners())};
    const double upper =
        main.area(-150, 0) + (branch.area(z, -30) - main.area(z, -30)) + (2000.0 * (-10 - z) - branch.area(z, -10));
    const double lower = main.area(-500, -150) + (2000.0 * (z + 560) - main.area(-560, z));
    for (const bool turned : {false, true}) {
      if (turned) std::reverse(input.faults.begin(), input.faults.end());
      for (const std::optional<double> snap : {std::optional<double>(), std::optional(0.0)}) {
        input.snap_to_faults = snap;
        const section::Section section = read(input).section;
        const geom::Point end = section.lines[turned ? 0 : 1].line.points.back();
        const std::vector<Point>& of_main = section.lines[turned ? 1 : 0].line.points;
        EXPECT_EQ(std::count(of_main.begin(), of_main.end(), end), 1);
        EXPECT_EQ(section.horizons[4].line.points.front(), end);
        const Block made = test::block(section, along);
        EXPECT_TRUE(made.findings.empty());
        ASSERT_EQ(made.units.size(), 2U) << made.units[0].name << ", " << made.units[1].name << ", "
                                         << made.units[2].name;
        EXPECT_NEAR(volume(made, "top - bed"), along * upper, 1e-3);
        EXPECT_NEAR(volume(made, "bed - base"), along * lower, 1e-3);
      }
    }
  }
}

/// The bed ends 5.5 mm beyond F and 4.5 mm before G, 1 cm beyond F.
TEST(RoundedEnds, AnEndBetweenTwoFaultsIsCutBackToTheOneThatItCrosses) {
  for (const bool turned : {false, true}) {
    SectionInput input = gap(500.01, 100.01);
    input.faults = {line("F", {{500.00, 0}, {500.01, -111.11}}), line("G", {{500.01, -5}, {500.02, -105}})};
    const Fault f(input.faults[0].points), g(input.faults[1].points);
    ASSERT_NEAR(500.01 - f.x(-50), 0.0055, 1e-5);
    ASSERT_NEAR(g.x(-50) - 500.01, 0.0045, 1e-5);
    if (turned) std::reverse(input.faults.begin(), input.faults.end());
    const section::Section section = read(input).section;
    const Point end = section.horizons[2].line.points.back();
    EXPECT_NEAR(end.x, f.x(-50), 1e-4);
    EXPECT_EQ(std::count(section.lines[turned].line.points.begin(), section.lines[turned].line.points.end(), end), 1);
  }
}

/// Beyond what rounding does: both walls keep their volumes, and the finding says what to do.
TEST(RoundedEnds, AnEndFarBeyondItsFaultMixesNoWallsAndIsTold) {
  for (const double past : {0.03, 2.0}) {
    SCOPED_TRACE(past);
    SectionInput input = gap(500.0 + past, 100.01);
    const input::ReadSection made_of = read(input);
    const Block made = test::block(made_of.section, along);
    ASSERT_EQ(made.units.size(), 2U);
    // The bed sags by 1 m at x = 100.01, which takes a triangle from the one unit and gives it to the other.
    const double sag = 0.5 * 1.0 * (500.0 + past) - 0.5 * past * past / (500.0 + past - 100.01);
    EXPECT_NEAR(volume(made, "top - middle"), along * (500 * 50 + 500 * 50 + sag), along * 1e-6);
    EXPECT_NEAR(volume(made, "middle - base"), along * (500 * 50 + 500 * 50 - sag), along * 1e-6);
    ASSERT_TRUE(test::told(made.findings, "overshoot"));
    EXPECT_FALSE(test::told(made.findings, "open_end"));
    const std::string words = past == 0.03 ? "horizon 'middle (1)' goes on 0.03 m beyond fault 'F'"
                                           : "horizon 'middle (1)' goes on 2 m beyond fault 'F'";
    EXPECT_THAT(made.findings[0].message, HasSubstr(words));
    EXPECT_EQ(made.findings[0].place.x, 500.0 + past);
    EXPECT_THAT(made_of.remarks, testing::Contains(HasSubstr(words)));
    EXPECT_THAT(made_of.remarks, testing::Not(testing::Contains(HasSubstr("run together"))));
    const std::size_t at = made.findings[0].message.find("snap_to_faults of ");
    ASSERT_NE(at, std::string::npos);
    input.snap_to_faults = std::stod(made.findings[0].message.substr(at + 18));
    EXPECT_LT(*input.snap_to_faults, 1.11 * past);
    const input::ReadSection cut = read(input);
    EXPECT_EQ(cut.section.horizons[2].line.points.back().x, 500.0);
    EXPECT_TRUE(test::block(cut.section, along).findings.empty());
  }
}

/// Half a metre beside the fault, in whole metres: farther than the section's width of a pencil line.
TEST(RoundedEnds, WhatTheSizeOfTheSectionLeavesApartIsToldWithTheSnapThatJoinsIt) {
  SectionInput input = gap(499.0, 100.0);
  input.horizons[4].points.back().x = 501.0;
  input.faults = {line("F", {{500, 30}, {501, -200}})};
  const input::ReadSection made = read(input);
  std::string told;
  for (const std::string& remark : made.remarks) {
    if (remark.find("ten-thousandth") != std::string::npos) told = remark;
  }
  // The fault is at x = 500 + (30 - z) / 230, and leans by 1 in 230.
  const double across = std::hypot(1.0, 1.0 / 230.0);
  const double at_middle = (1.0 + 80.0 / 230.0) / across;
  EXPECT_THAT(told, HasSubstr("6 ends of horizons"));
  ASSERT_TRUE(made.places.contains(told));
  EXPECT_NEAR(*made.places.at(told).y, -50.0, 0.1);
  EXPECT_EQ(made.places.at(told).item, "horizon 'middle'");
  const std::size_t at = told.find("snap_to_faults of ");
  ASSERT_NE(at, std::string::npos) << told;
  const double snap = std::stod(told.substr(at + 18));
  EXPECT_GT(snap, at_middle);
  EXPECT_LT(snap, at_middle + 0.11);
  input.snap_to_faults = snap;
  const input::ReadSection joined = read(input);
  const Fault fault({{500, 30}, {501, -200}});
  for (std::size_t i = 0; i < 6; ++i) {
    const std::vector<Point>& points = joined.section.horizons[i].line.points;
    const Point end = i % 2 == 0 ? points.back() : points.front();
    EXPECT_NEAR(end.x, fault.x(end.y), 1e-9) << i;
  }
}

TEST(RoundedEnds, SectionsInFeetAndWithAnOddPointHaveTheirVolumesToo) {
  for (const Shape& shape : shapes()) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      for (const bool feet : {true, false}) {
        SCOPED_TRACE(std::string(shape.name) + (feet ? ", feet, seed " : ", odd, seed ") + std::to_string(seed));
        std::mt19937 random(seed);
        const Exact exact = shape.make(random);
        SectionInput input = written(exact, 0.01);
        const double metres = feet ? 0.3048 : 1.0;
        if (feet) input.unit = section::LengthUnit::Foot;
        // As many points as one odd one needs.
        std::vector<Point>& top = input.horizons[0].points;
        const Point from = top[0], to = top[1];
        for (int i = 1; i < 60; ++i) {
          const Point p = geom::interpolate(from, to, i / 60.0);
          top.insert(top.begin() + i, {std::round(100 * p.x) / 100.0, std::round(100 * p.y) / 100.0});
        }
        if (!feet) top[30].x += 1.0 / 3000.0;
        const input::ReadSection made_of = read(input);
        const Block made = test::block(made_of.section, along);
        EXPECT_FALSE(test::told(made.findings, "open_end"));
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_NEAR(volume(made, i == 0 ? "top - middle" : "middle - base"), metres * metres * along * exact.area(i),
                      rounding(exact, 0.01));
        }
        const auto is_odd = [](const std::string& remark) {
          return remark.find("no multiple of") != std::string::npos;
        };
        EXPECT_EQ(std::any_of(made_of.remarks.begin(), made_of.remarks.end(), is_odd),
                  !feet && made_of.remarks.size() > 1)
            << testing::PrintToString(made_of.remarks);
      }
    }
  }
}

/// Two faults cross between beds that they do not displace: what lies under both of them has the bed above for its top.
TEST(RoundedEnds, WhatLiesUnderTwoCrossingFaultsIsNamedByItsBeds) {
  for (const double lean : {0.0, 3.0, 40.0}) {
    SectionInput input;
    input.horizons = {line("top", {{0, 0}, {1000, 0}}), line("middle", {{0, -50}, {1000, -50}}),
                      line("base", {{0, -100}, {1000, -100}})};
    input.faults = {line("F", {{400, 40}, {600 + lean, -160}}), line("G", {{600, 40}, {400, -160}})};
    const Block made = test::block(read(input).section, along);
    EXPECT_EQ(made.units.size(), 2U) << lean;
    EXPECT_NEAR(volume(made, "top - middle"), along * 50000, 1e-3);
    EXPECT_NEAR(volume(made, "middle - base"), along * 50000, 1e-3);
  }
  // The right-hand block of F is down, and G cuts both its blocks without displacing them: under F and G, on the base,
  // nothing of the bed above is left.
  for (const double drop : {0.5, 30.0, 60.0, 100.0, 120.0}) {
    SCOPED_TRACE(drop);
    const Fault f({{300, 50}, {680, -330}}), g({{700, 50}, {320, -330}});
    const double heights[] = {0.0, -70.0, -200.0};
    const auto x = [&](double z) { return f.x(z); };
    SectionInput input;
    const char* const names[] = {"top", "middle", "base"};
    for (int i = 0; i < 3; ++i) {
      const double z = heights[i];
      input.horizons.push_back(line((std::string(names[i]) + " (1)").c_str(), {{0, z}, {x(z), z}}, names[i]));
      input.horizons.push_back(
          line((std::string(names[i]) + " (2)").c_str(), {{x(z - drop), z - drop}, {1000, z - drop}}, names[i]));
    }
    input.faults = {line("F", f.corners()), line("G", g.corners())};
    const Block made = test::block(read(input).section, along);
    EXPECT_EQ(made.units.size(), 2U);
    for (int i = 0; i < 2; ++i) {
      const double high = heights[i], low = heights[i + 1];
      const double area = f.area(low, high) + 1000.0 * (high - low) - f.area(low - drop, high - drop);
      EXPECT_NEAR(volume(made, i == 0 ? "top - middle" : "middle - base"), along * area, 1e-3);
    }
  }
}

TEST(RoundedEnds, SectionsInCentimetresAreLofted) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Exact front = two_faults(random);
    Exact back = front;
    back.scale = 1.2;
    const auto placed = [&](const Exact& exact, double y, std::optional<double> snap) {
      SectionInput input = written(exact, 0.01);
      input.snap_to_faults = snap;
      return LoftedSection{std::to_string(y), read(input).section, {0, y, 1, 0}};
    };
    const std::vector<LoftedSection> sections{placed(front, 0, {}), placed(back, along, {})};
    const auto made = loft(sections);
    ASSERT_TRUE(made) << to_string(made.error());
    // Everything grows evenly about the origin: a frustum.
    for (std::size_t i = 0; i < 2; ++i) {
      const double expected = along * front.area(i) * (1.0 + 1.2 + 1.44) / 3.0;
      EXPECT_NEAR(volume(*made, i == 0 ? "top - middle" : "middle - base"), expected, 2.0 * rounding(back, 0.01));
    }
    const std::vector<LoftedSection> open{placed(front, 0, 0.0), placed(back, along, 0.0)};
    EXPECT_FALSE(loft(open));
  }
}

}  // namespace
}  // namespace recon::block::rounded_ends_test
