#include "shared/surf/loft/cut.h"

#include <gtest/gtest.h>

#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

/// Greatest height between the line of a cut at 30 degrees and a formula.
double miss_at_30_degrees(const std::vector<loft::Section>& sections, double width, const Height& height) {
  loft::ThroughOptions options;
  options.rows = 1;
  const auto made = through(sections, options);
  const auto along = trace({{100.0, 0.0}, {100.0 + width * std::sqrt(3.0), width}});
  const auto cut = loft::cut_along(made.surfaces, along, made.size);
  EXPECT_EQ(cut.lines.size(), 1u);
  if (cut.lines.empty()) return 1e300;
  double most = 0.0;
  for (const Point p : cut.lines[0].line.points) {
    const Point on = along.on_map(p.x);
    most = std::max(most, std::abs(p.y - height(on.x, on.y)));
  }
  EXPECT_NEAR(cut.lines[0].line.points.back().x, along.length(), 1e-6);
  return most;
}

TEST(LoftCut, FiveSectionsOfACylinderGiveItsEllipseAt30Degrees) {
  // An anticline that is a part of a circular cylinder: its axis is level and lies across the sections.
  const double radius = 1500.0;
  const auto cylinder = [&](double x, double) { return std::sqrt(radius * radius - (x - 500.0) * (x - 500.0)); };
  const auto sections = row(5, 1000.0, 500.0, cylinder, 2000);
  const double sagitta = 0.55 * 0.55 / (8.0 * radius);  // of the lines, whose points are 0.5 m apart along x
  EXPECT_LT(miss_at_30_degrees(sections, 500.0, cylinder), 1.1 * sagitta);
}

TEST(LoftCut, AnalyticFoldsAreMetWithinTheFourthOrderOfTheSpacing) {
  // A fold whose axis plunges and bends: nothing of it is straight across the sections.
  const auto fold = [](double x, double y) {
    return 80.0 * std::sin(0.003 * x + 0.4 * std::sin(0.006 * y)) * std::exp(-0.001 * y) + 0.1 * y;
  };
  const auto miss = [&](int intervals) {
    return miss_at_30_degrees(row(intervals + 1, 1000.0, 500.0, fold, 600), 500.0, fold);
  };
  const double five = miss(4), nine = miss(8), seventeen = miss(16);
  // h is 125 m; across the sections the fold waves with 0.006 / m.
  EXPECT_LT(five, 80.0 * std::pow(0.006 * 125.0, 4.0));
  // Twice as many: a sixteenth, less what the chords of the lines miss.
  EXPECT_LT(seventeen, nine / 12.0) << five << ' ' << nine << ' ' << seventeen;
}

TEST(LoftCut, ASectionCutAtItsOwnTraceReturnsItsLines) {
  const auto fold = [](double x, double y) { return 60.0 * std::sin(0.01 * x + 0.003 * y) - 0.05 * y; };
  std::vector<loft::Section> sections;
  for (int k = 0; k < 5; ++k) {
    // Not parallel, not evenly spaced, each with its own vertices.
    sections.push_back(section("S" + std::to_string(k), {{-20.0 * k, 110.0 * k + 7.0 * k * k}, {900.0, 130.0 * k}}));
    add(sections.back(), "top", sampled(sections.back(), fold, 37 + 5 * k));
    add(sections.back(), "base",
        sampled(
            sections.back(), [&](double x, double y) { return fold(x, y) - 80.0; }, 21 + k));
  }
  // An overturned one: the line turns back over itself.
  sections[2].lines[1].line.points = {{0.0, -80.0},  {300.0, -60.0}, {420.0, 0.0},
                                      {380.0, 30.0}, {520.0, 60.0},  {900.0, 10.0}};
  const auto made = through(sections);
  ASSERT_EQ(made.surfaces.size(), 2u);
  for (const auto& s : sections) {
    const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
    ASSERT_EQ(cut.lines.size(), 2u) << s.name;
    for (std::size_t l = 0; l < 2; ++l) {
      EXPECT_EQ(cut.lines[l].name, s.lines[l].name);
      EXPECT_LT(away(cut.lines[l].line, s.lines[l].line), 1e-9 * made.size) << s.name;
      EXPECT_LT(away(s.lines[l].line, cut.lines[l].line), 1e-9 * made.size) << s.name;
    }
  }
}

TEST(LoftCut, ATraceThatBendsReturnsItsLinesTooAndCutsOthersInOneLine) {
  const auto fold = [](double x, double y) { return 50.0 * std::sin(0.008 * x) + 0.02 * y; };
  std::vector<loft::Section> sections;
  for (int k = 0; k < 4; ++k) {
    const double y = 150.0 * k;
    sections.push_back(section("S" + std::to_string(k), {{0.0, y}, {400.0, y + 40.0}, {1000.0, y}}));
    add(sections.back(), "top", sampled(sections.back(), fold, 50));
  }
  const auto made = through(sections);
  for (const auto& s : sections) {
    const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
    ASSERT_EQ(cut.lines.size(), 1u) << s.name;
    EXPECT_LT(away(s.lines[0].line, cut.lines[0].line), 1e-9 * made.size) << s.name;
  }
  const auto across = loft::cut_along(made.surfaces, trace({{100.0, 60.0}, {500.0, 300.0}, {450.0, 480.0}}), made.size);
  ASSERT_EQ(across.lines.size(), 1u);
  EXPECT_NEAR(across.lines[0].line.points.front().x, 0.0, 1e-6);
  EXPECT_NEAR(across.lines[0].line.points.back().x, std::hypot(400.0, 240.0) + std::hypot(50.0, 180.0), 1e-6);
}

TEST(LoftCut, ASurfaceInThePlaneOfTheSectionIsTold) {
  auto sections = row(
      3, 1000.0, 400.0, [](double, double) { return 0.0; }, 4);
  for (auto& s : sections) add(s, "wall", {{{500.0, 100.0}, {500.0, -300.0}}, false}, loft::LineKind::Fault);
  const auto made = through(std::move(sections));
  const auto cut = loft::cut_along(made.surfaces, trace({{500.0, 0.0}, {500.0, 400.0}}), made.size);
  EXPECT_NE(finding(cut.findings, "in_plane"), nullptr);
}

TEST(LoftCut, AwayFromAllSurfacesThereIsNoLine) {
  const auto made = through(row(
      3, 1000.0, 400.0, [](double, double) { return 0.0; }, 4));
  EXPECT_TRUE(loft::cut_along(made.surfaces, trace({{0.0, 500.0}, {1000.0, 500.0}}), made.size).lines.empty());
}

TEST(LoftCut, ContoursOfAConeAreItsCircles) {
  const auto cone = [](double x, double y) { return 500.0 - std::hypot(x - 500.0, y - 500.0); };
  const auto made = through(row(41, 1000.0, 1000.0, cone, 80));
  const auto lines = loft::contours(made.surfaces[0], 100.0).value();
  const auto at = std::find_if(lines.begin(), lines.end(), [](const auto& c) { return c.level == 200.0; });
  ASSERT_NE(at, lines.end());
  ASSERT_EQ(at->lines.size(), 1u);
  EXPECT_EQ(at->lines[0].front(), at->lines[0].back());
  for (const auto p : at->lines[0]) {
    EXPECT_NEAR(p.z, 200.0, 1e-6);
    EXPECT_NEAR(std::hypot(p.x - 500.0, p.y - 500.0), 300.0, 1.5);
  }
}

TEST(LoftMeasures, DipsAndAzimuthsOfPlanes) {
  // Falls to the south-west by 30 degrees.
  const double slope = std::tan(0.5235987755982988) / std::sqrt(2.0);
  const auto made = through(row(
      3, 100.0, 100.0, [&](double x, double y) { return slope * (x + y); }, 5));
  for (const loft::Dip dip : loft::dips(made.surfaces[0].patches[0])) {
    EXPECT_NEAR(dip.dip.degrees(), 30.0, 1e-9);
    EXPECT_NEAR(dip.azimuth.degrees(), 225.0, 1e-9);
  }
}

TEST(LoftMeasures, TheVolumeBetweenTwoLoftsIsTheClosedForm) {
  const double pi = 3.14159265358979323846, a = 1000.0, b = 800.0;
  const auto upper = [&](double x, double y) { return 40.0 * std::sin(pi * x / a) + 3e-4 * y * (b - y) + 100.0; };
  const auto lower = [&](double x, double y) { return -30.0 * std::sin(pi * x / a) + 0.1 * y; };
  auto sections = row(17, a, b, upper, 2500, "upper");
  for (auto& s : sections) add(s, "lower", sampled(s, lower, 1900));
  loft::ThroughOptions options;
  options.rows = 2;
  const auto made = through(std::move(sections), options);
  const double exact = 70.0 * a * b * 2.0 / pi + 100.0 * a * b + 3e-4 * a * b * b * b / 6.0 - 0.05 * a * b * b;
  const loft::Volume volume = loft::volume_between(made.surfaces[0], made.surfaces[1]).value();
  EXPECT_TRUE(volume.exact);
  EXPECT_NEAR(volume.value / exact, 1.0, 1e-6);
  EXPECT_NEAR(volume.plan, a * b, 1e-5);
}

TEST(LoftMeasures, VolumesOfOtherBordersAreThoseOverWhatBothCover) {
  // A wedge over a level surface that reaches half as far; the wedge is below it in a quarter.
  auto upper = row(
      3, 1000.0, 400.0, [](double x, double) { return 0.1 * (x - 250.0); }, 5, "upper");
  auto lower = row(
      3, 500.0, 400.0, [](double, double) { return 0.0; }, 3, "lower");
  for (std::size_t k = 0; k < 3; ++k) add(upper[k], "lower", lower[k].lines[0].line);
  const auto made = through(std::move(upper));
  const loft::Volume volume = loft::volume_between(made.surfaces[0], made.surfaces[1]).value();
  EXPECT_FALSE(volume.exact);
  EXPECT_NEAR(volume.plan, 200'000.0, 1e-6);
  EXPECT_NEAR(volume.value, 0.0, 1e-6);
}

}  // namespace
}  // namespace dobra::test
