// Sections that meet at their ends, whose lines are written to some decimals: a slanted trace has an irrational length,
// so that the lines end a little before or behind the place where the traces meet.
#include <gtest/gtest.h>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

double hills(double x, double y) { return 100.0 * std::sin(x / 900.0) + 60.0 * std::cos(y / 1100.0); }

double to_decimals(double number, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return std::round(number * unit) / unit;
}

/// A section from a to b with two horizons 150 m apart, written to some decimals.
loft::Section written(const std::string& name, Point a, Point b, int decimals, int n = 40) {
  loft::Section made = section(name, {a, b});
  for (const double down : {0.0, 150.0}) {
    geom::Polyline line = sampled(
        made, [&](double x, double y) { return hills(x, y) - down; }, n);
    for (Point& p : line.points) p = {to_decimals(p.x, decimals), to_decimals(p.y, decimals)};
    add(made, down == 0.0 ? "top" : "base", std::move(line));
  }
  return made;
}

/// Sections along the sides of a polygon.
std::vector<loft::Section> round_about(const std::vector<Point>& corners, int decimals, int n = 40) {
  std::vector<loft::Section> sections;
  for (std::size_t k = 0; k < corners.size(); ++k)
    sections.push_back(written("S" + std::to_string(k), corners[k], corners[(k + 1) % corners.size()], decimals, n));
  return sections;
}

double shoelace(const std::vector<Point>& corners) {
  double twice = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point p = corners[k], q = corners[(k + 1) % corners.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * std::abs(twice);
}

const loft::NamedSurface* named(const loft::Surfaces& made, const std::string& name) {
  for (const auto& surface : made.surfaces) {
    if (surface.name == name) return &surface;
  }
  return nullptr;
}

/// Both horizons are patches over the whole of the area, and the volume between them is 150 m times that.
/// @param measured  how well the area on the map is measured
void expect_filled(const loft::Surfaces& made, double area, double rounding, double measured = 1e-9) {
  const loft::NamedSurface *top = named(made, "top"), *base = named(made, "base");
  ASSERT_TRUE(top && base);
  EXPECT_NEAR(loft::measures(*top).plan, area, measured * area);
  EXPECT_NEAR(loft::measures(*base).plan, area, measured * area);
  const auto volume = loft::volume_between(*top, *base, made.surfaces).value();
  EXPECT_NEAR(volume.value, 150.0 * area, (rounding + 150.0 * measured) * area);
  for (const char* code : {"left_out", "turns_back", "near_miss", "beyond_cells", "no_surface", "no_patch"})
    EXPECT_EQ(finding(made.findings, code), nullptr) << code;
}

const std::vector<Point> four_corners{{0.0, 0.0}, {4000.0, 300.0}, {3700.0, 3100.0}, {-200.0, 2800.0}};

TEST(LoftCorners, AQuadrilateralIsFilledToTheDecimalsItIsWrittenTo) {
  for (const int decimals : {14, 6, 3, 2, 1, 0}) {
    SCOPED_TRACE(decimals);
    const auto made = through(round_about(four_corners, decimals));
    expect_filled(made, shoelace(four_corners), std::pow(10.0, -decimals));
    EXPECT_EQ(made.misties.size(), 8u);
    // Ends that are off by more than rounding of numbers makes are told, no others.
    if (decimals >= 3) {
      EXPECT_EQ(finding(made.findings, "end_moved"), nullptr);
    }
    if (decimals <= 1) {
      const loft::Finding* moved = finding(made.findings, "end_moved");
      ASSERT_NE(moved, nullptr);
      EXPECT_NE(moved->message.find("'S"), std::string::npos) << moved->message;
      EXPECT_TRUE(moved->place.x && moved->place.y && moved->place.z);
    }
  }
}

TEST(LoftCorners, ATriangleIsFilledWithNoSectionLeftOut) {
  const std::vector<Point> corners{{0.0, 0.0}, {4000.0, 0.0}, {1500.0, 3000.0}};
  // Gauss's rule misses the area of a triangular patch by 4e-9, at 14 decimals too, where no end is moved.
  for (const int decimals : {14, 4, 2}) {
    SCOPED_TRACE(decimals);
    const auto made = through(round_about(corners, decimals, 100));
    expect_filled(made, shoelace(corners), 2.0 * std::pow(10.0, -decimals), 1e-8);
    // Own lines come back, but for what was carried on or cut off at their ends.
    for (const loft::Section& own : made.sections) {
      const auto cut = loft::cut_along(made.surfaces, own.trace, made.size);
      for (const loft::SectionLine& line : own.lines) {
        double least = INFINITY;
        for (const loft::CutLine& other : cut.lines) {
          if (other.name == line.name) least = std::min(least, away(line.line, other.line));
        }
        EXPECT_LE(least, 1e-9 * made.size) << own.name << " " << line.name;
      }
    }
  }
}

TEST(LoftCorners, EndsOnOtherTracesReachThem) {
  // Two long sections and two between them, like rungs of a ladder: the ends of these lie on the traces of those.
  for (const int decimals : {2, 1}) {
    SCOPED_TRACE(decimals);
    std::vector<loft::Section> sections{written("S0", {0.0, 0.0}, {4000.0, 300.0}, decimals),
                                        written("S1", {0.0, 3000.0}, {4000.0, 3200.0}, decimals),
                                        written("S2", {500.0, 37.5}, {700.0, 3035.0}, decimals),
                                        written("S3", {3000.0, 225.0}, {3300.0, 3165.0}, decimals)};
    const auto made = through(std::move(sections));
    const loft::NamedSurface *top = named(made, "top"), *base = named(made, "base");
    ASSERT_TRUE(top && base);
    const double area = shoelace({{500.0, 37.5}, {3000.0, 225.0}, {3300.0, 3165.0}, {700.0, 3035.0}});
    EXPECT_NEAR(loft::measures(*top).plan, area, 1e-9 * area);
    EXPECT_EQ(made.misties.size(), 8u);
    EXPECT_EQ(finding(made.findings, "left_out"), nullptr);
    // The long ones do go on beyond the rungs.
    EXPECT_NE(finding(made.findings, "beyond_cells"), nullptr);
  }
}

/// Square of 1000 m whose southern section ends before its eastern corner.
std::vector<loft::Section> short_of_the_corner(double gap) {
  const std::vector<Point> corners{{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 1000.0}, {0.0, 1000.0}};
  std::vector<loft::Section> sections = round_about(corners, 14);
  for (loft::SectionLine& line : sections[0].lines) {
    Point& end = line.line.points.back();
    const Point before = line.line.points[line.line.points.size() - 2];
    if (gap < end.x - before.x) {
      end = geom::interpolate(before, end, (end.x - gap - before.x) / (end.x - before.x));
      continue;
    }
    while (line.line.points.back().x > 1000.0 - gap + 1e-6) line.line.points.pop_back();
  }
  return sections;
}

TEST(LoftCorners, AnEndThatIsLedOnToACrossingGoesStraightOnAndIsTold) {
  const auto sections = short_of_the_corner(0.09);
  const auto made = through(sections);
  expect_filled(made, 1e6, 1e-2);
  const Point before = sections[0].lines[0].line.points[39], end = sections[0].lines[0].line.points[40];
  const Point led = made.sections[0].lines[0].line.points.back();
  EXPECT_EQ(made.sections[0].lines[0].line.points.size(), 41u);
  EXPECT_NEAR(led.x, 1000.0, 1e-9);
  // Straight on, then by half the mis-tie that is left.
  const double straight = end.y + (end.y - before.y) / (end.x - before.x) * 0.09;
  const double other = sections[1].lines[0].line.points.front().y;
  EXPECT_NEAR(led.y, 0.5 * (straight + other), 1e-9);
  const loft::Finding* moved = finding(made.findings, "end_moved");
  ASSERT_NE(moved, nullptr);
  for (const char* part : {"'top'", "'S0'", "'S1'", "0.09"})
    EXPECT_NE(moved->message.find(part), std::string::npos) << moved->message;
  EXPECT_NEAR(*moved->place.x, 1000.0, 1e-9);
  EXPECT_NEAR(*moved->place.y, 0.0, 1e-9);
}

TEST(LoftCorners, AnEndJustBehindACrossingIsCutThereAndOneFartherBehindIsNot) {
  for (const double over : {0.05, 30.0}) {
    SCOPED_TRACE(over);
    const std::vector<Point> corners{{0.0, 0.0}, {1000.0, 0.0}, {1000.0, 1000.0}, {0.0, 1000.0}};
    std::vector<loft::Section> sections = round_about(corners, 14);
    for (loft::SectionLine& line : sections[0].lines)
      line.line.points.push_back({1000.0 + over, line.line.points.back().y});
    const auto made = through(sections);
    const double end = made.sections[0].lines[0].line.points.back().x;
    const bool cut = over < 1.0;
    EXPECT_NEAR(end, cut ? 1000.0 : 1030.0, 1e-9);
    EXPECT_EQ(finding(made.findings, "end_moved") != nullptr, cut);
    EXPECT_EQ(finding(made.findings, "beyond_cells") == nullptr, cut);
    EXPECT_NEAR(loft::measures(*named(made, "top")).plan, 1e6, 1e-3);
  }
}

TEST(LoftCorners, AnEndFartherBeforeACrossingStaysAndItIsToldWhatMissesWhat) {
  const auto made = through(short_of_the_corner(10.0));
  EXPECT_NEAR(made.sections[0].lines[0].line.points.back().x, 990.0, 1e-9);
  EXPECT_EQ(finding(made.findings, "end_moved"), nullptr);
  std::size_t count = 0;
  for (const loft::Finding& f : made.findings) {
    if (f.code == "near_miss") ++count;
    // No advice that would not mend it.
    EXPECT_EQ(f.message.find("draw a section there"), std::string::npos) << f.message;
    EXPECT_EQ(f.message.find("no cell of crossing sections"), std::string::npos) << f.message;
  }
  EXPECT_EQ(count, 2u);  // top and base
  const loft::Finding* missed = finding(made.findings, "near_miss");
  ASSERT_NE(missed, nullptr);
  for (const char* part : {"'top'", "'S0'", "'S1'", "10 m"})
    EXPECT_NE(missed->message.find(part), std::string::npos) << missed->message;
  EXPECT_NEAR(*missed->place.x, 1000.0, 1e-9);
  EXPECT_NEAR(*missed->place.y, 0.0, 1e-9);
}

TEST(LoftCorners, AnEndFarFromACrossingIsNeitherPulledOutNorTold) {
  const auto made = through(short_of_the_corner(50.0));  // 5 %
  EXPECT_NEAR(made.sections[0].lines[0].line.points.back().x, 950.0, 1e-9);
  EXPECT_EQ(finding(made.findings, "end_moved"), nullptr);
  EXPECT_EQ(finding(made.findings, "near_miss"), nullptr);
}

TEST(LoftCorners, AHorizonThatEndsAtAFaultBesideACrossingStaysThere) {
  // A fault crosses the southern section 10 m before the corner; beyond it is no horizon.
  auto sections = short_of_the_corner(10.0);
  const double z = sections[0].lines[0].line.points.back().y;
  add(sections[0], "fault", {{{985.0, z + 300.0}, {995.0, z - 300.0}}, false}, loft::LineKind::Fault);
  std::erase_if(sections[0].lines, [](const loft::SectionLine& line) { return line.name == "base"; });
  const auto made = through(std::move(sections));
  EXPECT_NEAR(made.sections[0].lines[0].line.points.back().x, 990.0, 1e-9);
  EXPECT_EQ(finding(made.findings, "near_miss"), nullptr);
}

TEST(LoftCorners, TwoTracesThatMissEachOtherAreToldOnce) {
  std::vector<loft::Section> sections{section("a", {{0.0, 0.0}, {1000.0, 0.0}}),
                                      section("b", {{3.0, 5.0}, {800.0, 700.0}})};
  for (auto& s : sections) add(s, "top", sampled(s, hills, 10));
  const auto tied = loft::tie(sections);
  ASSERT_TRUE(tied);
  std::size_t count = 0;
  for (const loft::Finding& f : tied->findings) count += f.code == "near_miss" ? 1 : 0;
  EXPECT_EQ(count, 1u);
}

}  // namespace
}  // namespace dobra::test
