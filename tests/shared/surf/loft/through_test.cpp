// The untidy first: mis-ties, missing lines, pieces, lines the other way, sections that cannot be joined.
#include "shared/surf/loft/through.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/surf/loft/measures.h"
#include "shared/surf/triangular_patch.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

using loft::LineKind;

double wavy(double x, double y) { return -100.0 + 20.0 * std::sin(x / 150.0) * std::cos(y / 200.0); }

/// Two sections along x and two along y round a square of 1000 m, each going on by 100 m.
std::vector<loft::Section> square(const Height& height, int n = 60) {
  std::vector<loft::Section> sections{
      section("south", {{-100.0, 0.0}, {1100.0, 0.0}}), section("north", {{-100.0, 1000.0}, {1100.0, 1000.0}}),
      section("west", {{0.0, -100.0}, {0.0, 1100.0}}), section("east", {{1000.0, -100.0}, {1000.0, 1100.0}})};
  for (auto& s : sections) add(s, "top", sampled(s, height, n));
  return sections;
}

TEST(LoftUntidy, MistiesAreListedWithPlaceAndSharedOut) {
  auto sections = square(wavy);
  for (Point& p : sections[0].lines[0].line.points) p.y += 6.0;  // the southern section is 6 m too high
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.misties.size(), 4u);
  int of_south = 0;
  for (const loft::Mistie& m : made.misties) {
    const bool south = m.first == 0 || m.second == 0;
    of_south += south ? 1 : 0;
    EXPECT_NEAR(std::abs(m.difference), south ? 6.0 : 0.0, 0.05);
    EXPECT_NEAR(m.at.y, south ? 0.0 : 1000.0, 1e-9);
  }
  EXPECT_EQ(of_south, 2);
  // Both lines are at the mean of both heights where they cross.
  const auto south = loft::passages(made.sections[0].lines[0].line, 100.0, 1e-9);
  const auto west = loft::passages(made.sections[2].lines[0].line, 100.0, 1e-9);
  ASSERT_EQ(south.size(), 1u);
  EXPECT_NEAR(south[0].z, west[0].z, 1e-9);
  EXPECT_NEAR(south[0].z, wavy(0.0, 0.0) + 3.0, 0.05);
  ASSERT_EQ(made.surfaces.size(), 1u);
  EXPECT_EQ(made.surfaces[0].patches.size(), 1u);
  EXPECT_NE(finding(made.findings, "beyond_cells"), nullptr);
}

TEST(LoftUntidy, AMistieAboveTheToleranceIsRefusedWithItsPlace) {
  auto sections = square(wavy);
  for (Point& p : sections[3].lines[0].line.points) p.y -= 6.0;
  loft::ThroughOptions options;
  options.ties.most = 5.0;
  const auto refused = loft::surfaces_through(sections, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::BadSection);
  EXPECT_NE(refused.error().message.find("'top' is"), std::string::npos) << refused.error().message;
  EXPECT_NEAR(*refused.error().place->x, 1000.0, 1e-9);
  options.ties.most = 7.0;
  EXPECT_TRUE(loft::surfaces_through(sections, options));
}

TEST(LoftUntidy, ThreeTracesThroughOnePlaceComeToOneHeight) {
  std::vector<loft::Section> sections{section("a", {{-500.0, 0.0}, {500.0, 0.0}}),
                                      section("b", {{0.0, -500.0}, {0.0, 500.0}}),
                                      section("c", {{-400.0, -400.0}, {400.0, 400.0}})};
  for (int k = 0; k < 3; ++k)
    add(sections[static_cast<std::size_t>(k)], "top",
        sampled(
            sections[static_cast<std::size_t>(k)], [&](double, double) { return 3.0 * k; }, 10));
  const auto tied = loft::tie(std::move(sections));
  ASSERT_TRUE(tied) << tied.error().message;
  EXPECT_EQ(tied->misties.size(), 3u);
  for (const auto& s : tied->sections) {
    const auto over = loft::passages(s.lines[0].line, 0.5 * s.trace.length(), 1e-9);
    ASSERT_EQ(over.size(), 1u) << s.name;
    EXPECT_NEAR(over[0].z, 3.0, 1e-9) << s.name;
  }
}

TEST(LoftUntidy, AHorizonMissingOnASectionIsToldAndPassesWithout) {
  auto sections = row(5, 1000.0, 800.0, wavy, 40);
  sections[2].lines.clear();
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1u);
  EXPECT_EQ(made.surfaces[0].patches[0].sections, (std::vector<std::size_t>{0, 1, 3, 4}));
  const auto* told = finding(made.findings, "missing");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("'S3'"), std::string::npos) << told->message;
}

TEST(LoftUntidy, AHorizonOfOneSectionGivesNoSurfaceAndIsToldWithPlace) {
  auto sections = row(3, 1000.0, 800.0, wavy, 40);
  add(sections[1], "lens",
      sampled(
          sections[1], [](double, double) { return -300.0; }, 5));
  const auto made = through(std::move(sections));
  EXPECT_EQ(made.surfaces.size(), 1u);
  const auto* told = finding(made.findings, "single");
  ASSERT_NE(told, nullptr);
  EXPECT_EQ(*told->place.y, 400.0);
}

TEST(LoftUntidy, LinesAndTracesDigitisedInOppositeDirectionsGiveTheSameSurface) {
  const auto tidy = through(row(4, 1000.0, 600.0, wavy, 50));
  auto sections = row(4, 1000.0, 600.0, wavy, 50);
  sections[1].lines[0].line = geom::reversed(sections[1].lines[0].line);
  // The same section with its trace the other way.
  sections[2] = section("S3", {{1000.0, 400.0}, {0.0, 400.0}});
  add(sections[2], "top", sampled(sections[2], wavy, 50));
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1u);
  EXPECT_NEAR(loft::measures(made.surfaces[0]).area, loft::measures(tidy.surfaces[0]).area, 1e-6);
  EXPECT_NEAR(loft::measures(made.surfaces[0]).plan, 600'000.0, 1e-6);
}

TEST(LoftUntidy, LinesOfUnequalExtentAreJoinedEndToEndAndTold) {
  auto sections = row(
      3, 1000.0, 400.0, [](double, double) { return 0.0; }, 10);
  sections[1].lines[0].line = sampled(
      sections[1], [](double, double) { return 0.0; }, 10, 0.25, 0.75);
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1u);
  EXPECT_NE(finding(made.findings, "uneven"), nullptr);
  // Straight from end to end: what is cut off on each side is a triangle of 400 m by 250 m.
  EXPECT_NEAR(loft::measures(made.surfaces[0]).plan, 400'000.0 - 400.0 * 250.0, 1e-6);
}

/// Along the trace of x at a height y of the map.
void expect_heights(const loft::Surfaces& made, double y, double from, double to,
                    const std::function<double(double)>& height) {
  const auto cut = loft::cut_along(made.surfaces, trace({{0.0, y}, {2000.0, y}}), made.size);
  ASSERT_EQ(cut.lines.size(), 1U);
  const geom::Polyline& line = cut.lines[0].line;
  for (double x = from; x <= to; x += 10.0) {
    const auto over = loft::passages(line, x, 1e-9);
    ASSERT_EQ(over.size(), 1U) << x;
    EXPECT_NEAR(over[0].z, height(x), 1e-9) << "x " << x << ", y " << y;
  }
}

TEST(LoftUntidy, LinesOfUnequalExtentAreMatchedByPlace) {
  // A fold along y, 20 m from vertex to vertex; the second section is half as long, or shifted.
  const auto fold = [](double x, double) { return 100.0 * std::sin(x / 200.0); };
  const auto height = [&](double x) {
    const double low = 20.0 * std::floor(x / 20.0), part = (x - low) / 20.0;
    return (1.0 - part) * fold(low, 0.0) + part * fold(low + 20.0, 0.0);
  };
  for (const auto& [from, to] : {std::pair(500.0, 1500.0), {0.0, 1000.0}, {1000.0, 2000.0}, {400.0, 2400.0}}) {
    for (const bool turned : {false, true}) {
      std::vector<loft::Section> sections{section("long", {{0.0, 0.0}, {2000.0, 0.0}})};
      add(sections[0], "top", sampled(sections[0], fold, 100));
      sections.push_back(turned ? section("other", {{to, 800.0}, {from, 800.0}})
                                : section("other", {{from, 800.0}, {to, 800.0}}));
      add(sections[1], "top", sampled(sections[1], fold, static_cast<int>((to - from) / 20.0)));
      const auto made = through(sections);
      ASSERT_EQ(made.surfaces.size(), 1U);
      for (const double y : {100.0, 400.0, 750.0}) expect_heights(made, y, from, std::min(to, 2000.0), height);
      // Their own lines come back whole.
      for (const auto& s : sections) {
        const auto own = loft::cut_along(made.surfaces, s.trace, made.size);
        ASSERT_EQ(own.lines.size(), 1U);
        EXPECT_LT(away(own.lines[0].line, s.lines[0].line), 1e-9 * made.size);
        EXPECT_LT(away(s.lines[0].line, own.lines[0].line), 1e-9 * made.size);
      }
    }
  }
}

TEST(LoftUntidy, HeightsBeyondAShorterLineAreTold) {
  // A fold that is the same all along its strike: the surface beyond an end is off by what a cut of it shows.
  const auto fold = [](double x, double) { return 200.0 * std::sin(x / 800.0); };
  for (const auto& [from, to] : {std::pair(0.0, 5500.0), {0.0, 4000.0}, {1200.0, 6000.0}, {2500.0, 3500.0}}) {
    auto sections = row(2, 6000.0, 1000.0, fold, 240);
    sections[1].lines[0].line = sampled(sections[1], fold, 240, from / 6000.0, to / 6000.0);
    const auto made = through(sections);
    for (const bool high : {false, true}) {
      double worst = 0.0;
      for (const double part : {0.25, 0.5, 0.75}) {
        const double y = 1000.0 * part;
        const auto cut = loft::cut_along(made.surfaces, trace({{0.0, y}, {6000.0, y}}), made.size);
        ASSERT_EQ(cut.lines.size(), 1U);
        for (const geom::Point p : cut.lines[0].line.points) {
          if (high ? p.x > to : p.x < from) worst = std::max(worst, std::abs(p.y - fold(p.x, y)));
        }
      }
      const auto told = std::find_if(made.findings.begin(), made.findings.end(), [&](const loft::Finding& one) {
        return one.code == "uneven" && (high ? *one.place.x > to : *one.place.x < from);
      });
      ASSERT_EQ(told != made.findings.end(), worst > 0.65) << from << ' ' << to << ' ' << high << ' ' << worst;
      if (worst <= 0.65) continue;
      const std::size_t at = told->message.find("up to about ");
      ASSERT_NE(at, std::string::npos) << told->message;
      EXPECT_NEAR(std::stod(told->message.substr(at + 12)), worst, 0.05 * worst) << from << ' ' << to << ' ' << high;
      EXPECT_THAT(told->message, testing::HasSubstr(high ? fmt::format("{:.6g} m farther", 6000.0 - to)
                                                         : fmt::format("{:.6g} m farther", from)));
    }
  }
  // Nothing is guessed on a plane, and little where ends are nearly beside each other.
  const auto plane = [](double x, double y) { return 0.1 * x + 0.05 * y; };
  auto flat = row(2, 6000.0, 1000.0, plane, 24);
  flat[1].lines[0].line = sampled(flat[1], plane, 24, 0.0, 0.8);
  EXPECT_EQ(finding(through(flat).findings, "uneven"), nullptr);
  auto near = row(2, 6000.0, 1000.0, fold, 240);
  near[1].lines[0].line = sampled(near[1], fold, 240, 0.0, 5990.0 / 6000.0);
  EXPECT_EQ(finding(through(near).findings, "uneven"), nullptr);
}

TEST(LoftUntidy, AFreeEndIsMatchedByPlaceThoughTheOtherIsAtAFault) {
  const auto fold = [](double x, double) { return 100.0 * std::sin(x / 200.0); };
  std::vector<loft::Section> sections;
  for (const double y : {0.0, 800.0}) {
    sections.push_back(section("S" + std::to_string(static_cast<int>(y)), {{0.0, y}, {2000.0, y}}));
    add(sections.back(), "top", sampled(sections.back(), fold, y > 0.0 ? 50 : 75, y > 0.0 ? 0.25 : 0.0, 0.75));
    add(sections.back(), "F", {{{1500.0, 400.0}, {1500.0, -400.0}}, false}, LineKind::Fault);
  }
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 2U);
  const auto& top = made.surfaces[made.surfaces[0].name == "top" ? 0 : 1];
  ASSERT_EQ(top.patches[0].high_fault, "F");
  for (const auto p : top.patches[0].points) {
    const double low = 20.0 * std::floor(p.x / 20.0 + 1e-9), part = (p.x - low) / 20.0;
    if (p.x < 500.0) continue;
    EXPECT_NEAR(p.z, (1.0 - part) * fold(low, 0.0) + part * fold(low + 20.0, 0.0), 1e-9) << p.x;
  }
}

TEST(LoftUntidy, TheExtentOfALineInPiecesIsFromEndToEnd) {
  // Pieces of 500 and 350 m with a gap of 150 m at the fault reach 1000 m; the other section is drawn for 500 m.
  std::vector<loft::Section> sections{section("a", {{0.0, 0.0}, {1000.0, 0.0}}),
                                      section("b", {{0.0, 400.0}, {1000.0, 400.0}})};
  for (auto& s : sections) {
    add(s, "F", {{{450.0, 100.0}, {500.0, 0.0}, {650.0, 0.0}, {700.0, -100.0}}, false}, LineKind::Fault);
    add(s, "top", {{{0.0, 0.0}, {500.0, 0.0}}, false});
  }
  add(sections[0], "top", {{{650.0, 0.0}, {1000.0, 0.0}}, false});
  const auto made = through(std::move(sections));
  const loft::Finding* told = finding(made.findings, "uneven");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("reaches 500 m in section 'b' and 1000 m in 'a'"), std::string::npos) << told->message;
}

TEST(LoftUntidy, UnequalExtentsOfLinesThatTurnBackAreTold) {
  std::vector<loft::Section> sections{section("a", {{0.0, 0.0}, {2000.0, 0.0}}),
                                      section("b", {{0.0, 800.0}, {2000.0, 800.0}})};
  add(sections[0], "top", {{{0.0, 0.0}, {1200.0, 0.0}, {1000.0, 200.0}, {2000.0, 300.0}}, false});
  add(sections[1], "top", {{{0.0, 0.0}, {1200.0, 0.0}, {1000.0, 200.0}, {1900.0, 290.0}}, false});
  auto told = through(sections);
  ASSERT_NE(finding(told.findings, "uneven"), nullptr);
  EXPECT_NEAR(*finding(told.findings, "uneven")->place.x, 2000.0, 1e-9);
  sections[1].lines = sections[0].lines;
  told = through(sections);
  EXPECT_EQ(finding(told.findings, "uneven"), nullptr);
}

TEST(LoftUntidy, FaultsPartHorizonsAndTheirPiecesAreJoinedByTheFaultsAtTheirEnds) {
  auto sections = row(
      4, 1000.0, 600.0, [](double, double) { return 0.0; }, 1, "none");
  for (auto& s : sections) {
    s.lines.clear();
    // The fault dips to the east; the horizon is 50 m lower there.
    add(s, "F", {{{450.0, 200.0}, {650.0, -200.0}}, false}, LineKind::Fault);
    add(s, "top", {{{0.0, 0.0}, {550.0, 0.0}}, false});
    add(s, "top", {{{575.0, -50.0}, {1000.0, -50.0}}, false});
  }
  // One of them is drawn through the fault.
  sections[1].lines[1].line.points = {{0.0, 0.0}, {550.0, 0.0}, {575.0, -50.0}, {1000.0, -50.0}};
  sections[1].lines.pop_back();
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 2u);
  const auto& top = made.surfaces[1];
  ASSERT_EQ(top.name, "top");
  std::vector<std::pair<std::string, std::string>> ends;
  for (const auto& patch : top.patches) ends.emplace_back(patch.low_fault, patch.high_fault);
  EXPECT_NE(std::find(ends.begin(), ends.end(), std::pair<std::string, std::string>{"", "F"}), ends.end());
  EXPECT_NE(std::find(ends.begin(), ends.end(), std::pair<std::string, std::string>{"F", ""}), ends.end());
  // A cut between the sections has both pieces, with their ends at the fault.
  const auto cut = loft::cut_along(made.surfaces, trace({{0.0, 250.0}, {1000.0, 250.0}}), made.size);
  int at_fault = 0;
  for (const auto& line : cut.lines) {
    if (line.kind != LineKind::Horizon) continue;
    if (line.last_fault == "F") {
      EXPECT_NEAR(line.line.points.back().x, 550.0, 1e-6);
      ++at_fault;
    }
    if (line.first_fault == "F") {
      EXPECT_NEAR(line.line.points.front().x, 575.0, 1e-6);
      ++at_fault;
    }
  }
  EXPECT_EQ(at_fault, 2);
}

TEST(LoftUntidy, HorizonsAreLedToCurvedFaultsBetweenTheSections) {
  // The fault is curved along strike and in depth; lines of the horizon end on it, and nowhere else is it known.
  const auto fault_x = [](double y, double z) { return 500.0 + 60.0 * std::sin(0.006 * y) + 0.5 * z + 1e-3 * z * z; };
  const auto top = [](double x, double y) { return 0.1 * x + 30.0 * std::sin(0.005 * y); };
  auto sections = row(4, 1000.0, 600.0, top, 1, "none");
  for (auto& s : sections) {
    s.lines.clear();
    const double y = s.trace.corners()[0].y;
    geom::Polyline fault;
    for (int i = 0; i <= 40; ++i) fault.points.push_back({fault_x(y, 300.0 - 15.0 * i), 300.0 - 15.0 * i});
    add(s, "F", fault, LineKind::Fault);
    double end = 500.0;
    for (int i = 0; i < 50; ++i) end = fault_x(y, top(end, y));
    add(s, "top", sampled(s, top, 40, 0.0, end / 1000.0));
  }
  const auto made = through(sections);
  const auto& surface =
      *std::find_if(made.surfaces.begin(), made.surfaces.end(), [](const auto& s) { return s.name == "top"; });
  const auto& fault =
      *std::find_if(made.surfaces.begin(), made.surfaces.end(), [](const auto& s) { return s.name == "F"; });
  ASSERT_EQ(surface.patches.size(), 1u);
  ASSERT_EQ(surface.patches[0].high_fault, "F");
  EXPECT_EQ(made.surfaces[0].name, "F");
  for (const double y : {70.0, 100.0, 300.0, 520.0}) {
    const auto cut = loft::cut_along({fault, surface}, trace({{0.0, y}, {1000.0, y}}), made.size);
    ASSERT_EQ(cut.lines.size(), 2u);
    EXPECT_LT(geom::distance(cut.lines[0].line, cut.lines[1].line.points.back()), 0.2) << y;
  }
  // The lines of the sections stay.
  for (const auto& s : sections) {
    const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
    ASSERT_EQ(cut.lines.size(), 2u);
    for (std::size_t l = 0; l < 2; ++l) EXPECT_LT(away(s.lines[l].line, cut.lines[l].line), 1e-9 * made.size);
  }
}

TEST(LoftUntidy, AFaultThatEndsBetweenSectionsEndsThePiecesThere) {
  auto sections = row(
      4, 1000.0, 600.0, [](double, double) { return 0.0; }, 4);
  for (int k = 0; k < 2; ++k)
    add(sections[static_cast<std::size_t>(k)], "F", {{{500.0, 200.0}, {520.0, -200.0}}, false}, LineKind::Fault);
  const auto made = through(std::move(sections));
  const auto top =
      std::find_if(made.surfaces.begin(), made.surfaces.end(), [](const auto& s) { return s.name == "top"; });
  ASSERT_NE(top, made.surfaces.end());
  EXPECT_EQ(top->patches.size(), 3u);  // two beside the fault, one where there is none
  EXPECT_NEAR(loft::measures(*top).plan, 2.0 * 200.0 * 1000.0, 1.0);
}

TEST(LoftUntidy, SectionsBehindEachOtherGiveNoSurface) {
  std::vector<loft::Section> sections{section("a", {{0.0, 0.0}, {400.0, 0.0}}),
                                      section("b", {{500.0, 10.0}, {900.0, 10.0}})};
  for (auto& s : sections) add(s, "top", sampled(s, wavy, 10));
  const auto made = through(std::move(sections));
  EXPECT_TRUE(made.surfaces.empty());
  ASSERT_NE(finding(made.findings, "end_to_end"), nullptr);
  EXPECT_TRUE(finding(made.findings, "end_to_end")->place.x);
}

TEST(LoftUntidy, TracesAlongOneAnotherAreRefusedAndThoseThatStopShortAreTold) {
  std::vector<loft::Section> along{section("a", {{0.0, 0.0}, {400.0, 0.0}}),
                                   section("b", {{200.0, 0.0}, {900.0, 0.0}})};
  for (auto& s : along) add(s, "top", sampled(s, wavy, 10));
  const auto refused = loft::surfaces_through(along);
  ASSERT_FALSE(refused);
  EXPECT_EQ(*refused.error().place->x, 200.0);

  std::vector<loft::Section> touch{section("a", {{0.0, 0.0}, {400.0, 0.0}}),
                                   section("b", {{200.0, 0.0}, {200.0, 400.0}}),
                                   section("c", {{300.0, 3.0}, {300.0, 400.0}})};
  for (auto& s : touch) add(s, "top", sampled(s, wavy, 10));
  const auto tied = loft::tie(touch);
  ASSERT_TRUE(tied);
  ASSERT_EQ(tied->crossings.size(), 1u);  // b touches a; c stops short of it
  EXPECT_EQ(tied->misties.size(), 1u);
  ASSERT_NE(finding(tied->findings, "near_miss"), nullptr);
  EXPECT_EQ(*finding(tied->findings, "near_miss")->place.x, 300.0);
}

TEST(LoftUntidy, ACellOfFiveSectionsStaysOpenAndIsTold) {
  std::vector<loft::Section> sections;
  for (int k = 0; k < 5; ++k) {
    const double a = k * 1.2566370614359172, b = a + 1.2566370614359172;
    const Point p{500.0 * std::cos(a), 500.0 * std::sin(a)}, q{500.0 * std::cos(b), 500.0 * std::sin(b)};
    const geom::Vector way = 0.1 * (q - p);
    sections.push_back(section("s" + std::to_string(k), {p - way, q + way}));
    add(sections.back(), "top", sampled(sections.back(), wavy, 20));
  }
  const auto made = through(std::move(sections));
  ASSERT_NE(finding(made.findings, "cell_open"), nullptr);
  EXPECT_NEAR(*finding(made.findings, "cell_open")->place.x, 0.0, 1e-6);
}

TEST(LoftUntidy, TwoSectionsThatCrossAloneAreTold) {
  std::vector<loft::Section> sections{section("a", {{-500.0, 0.0}, {500.0, 0.0}}),
                                      section("b", {{0.0, -500.0}, {0.0, 500.0}})};
  for (auto& s : sections) add(s, "top", sampled(s, wavy, 10));
  const auto made = through(std::move(sections));
  EXPECT_TRUE(made.surfaces.empty());
  EXPECT_NE(finding(made.findings, "no_surface"), nullptr);
}

TEST(LoftUntidy, ATieLineOverARowIsToldWithItsDistanceFromTheSurface) {
  auto sections = row(
      4, 1000.0, 600.0, [](double, double) { return 0.0; }, 10);
  sections.push_back(section("tie", {{500.0, -50.0}, {500.0, 650.0}}));
  // It ties, and rises by 8 m between the second and the third.
  add(sections.back(), "top", {{{0.0, 0.0}, {250.0, 0.0}, {350.0, 8.0}, {450.0, 0.0}, {700.0, 0.0}}, false});
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1u);
  const auto* told = finding(made.findings, "left_out");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("'tie' is up to 8 m"), std::string::npos) << told->message;
}

TEST(LoftUntidy, ANameThatIsAFaultHereAndAHorizonThereIsToldWithPlace) {
  auto sections = row(3, 1000.0, 800.0, wavy, 10);
  sections[1].lines[0].kind = LineKind::Fault;
  const auto made = through(sections);
  const auto* told = finding(made.findings, "kinds_differ");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("horizon in section 'S1' and a fault in 'S2'"), std::string::npos) << told->message;
  EXPECT_EQ(*told->place.y, 400.0);
  sections[1].lines[0].kind = LineKind::Horizon;
  EXPECT_EQ(finding(through(sections).findings, "kinds_differ"), nullptr);
}

TEST(LoftUntidy, ALineThatTheSurfaceDoesNotReachIsToldWithItsPlace) {
  auto sections = row(
      3, 1000.0, 600.0, [](double, double) { return 0.0; }, 10);
  for (auto& s : sections) s.lines[0].line = {{{100.0, 0.0}, {600.0, 0.0}}, false};
  // Its trace touches those of the row, and its line meets a line of the row at its end alone.
  sections.push_back(section("off", {{600.0, 0.0}, {900.0, -300.0}}));
  add(sections.back(), "top", {{{0.0, 0.0}, {400.0, 0.0}}, false});
  const auto made = through(std::move(sections));
  const auto* told = finding(made.findings, "left_out");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("does not reach the line of 'off'"), std::string::npos) << told->message;
  EXPECT_EQ(*told->place.x, 600.0);
}

TEST(LoftUntidy, ThreeCurvesThatDoNotMeetAreRefusedWithTheGap) {
  const auto line = [](geom::Point3 a, geom::Point3 b) { return surf::Curve::line(a, b).value(); };
  const auto made = surf::TriangularPatch::make(line({0, 0, 0}, {1, 0, 0}), line({1, 0, 0.25}, {0, 1, 0}),
                                                line({0, 1, 0}, {0, 0, 0}));
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("0.25"), std::string::npos) << made.error().message;
}

TEST(LoftNetwork, FourSectionsRoundASquareGiveACoonsPatchOnTheirLines) {
  const auto made = through(square(wavy));
  ASSERT_EQ(made.surfaces.size(), 1u);
  ASSERT_EQ(made.surfaces[0].patches.size(), 1u);
  EXPECT_NEAR(loft::measures(made.surfaces[0]).plan, 1e6, 1e-3);
  for (const auto& s : made.sections) {
    const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
    ASSERT_EQ(cut.lines.size(), 1u) << s.name;
    EXPECT_LT(away(cut.lines[0].line, s.lines[0].line), 1e-9 * made.size) << s.name;
    EXPECT_NEAR(cut.lines[0].line.points.back().x - cut.lines[0].line.points.front().x, 1000.0, 1e-6);
  }
}

TEST(LoftNetwork, SectionsWithinANetworkReturnTheirLines) {
  // A lattice of three by three, and a diagonal that parts one of its cells: borders of two and of three patches.
  for (const bool diagonal : {false, true}) {
    std::vector<loft::Section> sections;
    for (const double at : {0.0, 500.0, 1000.0}) {
      sections.push_back(section("x" + std::to_string(static_cast<int>(at)), {{-100.0, at}, {1100.0, at}}));
      sections.push_back(section("y" + std::to_string(static_cast<int>(at)), {{at, -100.0}, {at, 1100.0}}));
    }
    if (diagonal) sections.push_back(section("d", {{0.0, 0.0}, {500.0, 500.0}}));
    for (auto& s : sections) add(s, "top", sampled(s, wavy, 60));
    const auto made = through(std::move(sections));
    ASSERT_EQ(made.surfaces.size(), 1U);
    EXPECT_EQ(made.surfaces[0].patches.size(), diagonal ? 5U : 4U);
    for (const auto& s : made.sections) {
      const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
      ASSERT_EQ(cut.lines.size(), 1U) << s.name;
      const geom::Polyline& line = cut.lines[0].line;
      EXPECT_LT(away(line, s.lines[0].line), 1e-9 * made.size) << s.name;
      const double from = s.name == "d" ? 0.0 : 100.0;
      EXPECT_NEAR(line.points.front().x, from, 1e-9);
      EXPECT_NEAR(line.points.back().x, s.trace.length() - from, 1e-9);
      for (std::size_t i = 1; i < line.points.size(); ++i) EXPECT_GT(line.points[i].x, line.points[i - 1].x) << s.name;
    }
  }
}

TEST(LoftNetwork, ThreeSectionsGiveATriangularPatchOnTheirLines) {
  std::vector<loft::Section> sections{section("a", {{0.0, 0.0}, {1000.0, 0.0}}),
                                      section("b", {{1000.0, 0.0}, {400.0, 800.0}}),
                                      section("c", {{400.0, 800.0}, {0.0, 0.0}})};
  for (auto& s : sections) add(s, "top", sampled(s, wavy, 30));
  const auto made = through(std::move(sections));
  ASSERT_EQ(made.surfaces.size(), 1u);
  EXPECT_NEAR(loft::measures(made.surfaces[0]).plan, 400'000.0, 4.0);  // Gauss's rule over kinks
  for (const auto& s : made.sections) {
    const auto cut = loft::cut_along(made.surfaces, s.trace, made.size);
    ASSERT_EQ(cut.lines.size(), 1u) << s.name;
    EXPECT_LT(away(cut.lines[0].line, s.lines[0].line), 1e-9 * made.size) << s.name;
    EXPECT_LT(away(s.lines[0].line, cut.lines[0].line), 1e-9 * made.size) << s.name;
  }
}

TEST(LoftNetwork, APlaneIsAPlaneWhateverTheSectionsAre) {
  const auto plane = [](double x, double y) { return 0.3 * x - 0.2 * y + 7.0; };
  for (const auto& made : {through(square(plane, 3)), through(row(5, 1000.0, 800.0, plane, 7))}) {
    ASSERT_EQ(made.surfaces.size(), 1u);
    for (const auto& patch : made.surfaces[0].patches) {
      for (const auto p : patch.points) EXPECT_NEAR(p.z, plane(p.x, p.y), 1e-9);
    }
    const auto measured = loft::measures(made.surfaces[0]);
    EXPECT_NEAR(measured.area, measured.plan * std::sqrt(1.0 + 0.09 + 0.04), 1e-5);
    EXPECT_NEAR(measured.dip_mean.degrees(), std::atan(std::sqrt(0.13)) * 57.29577951308232, 1e-9);
  }
}

}  // namespace
}  // namespace dobra::test
