#include "recon/section/section_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recon/input/items.h"
#include "recon/section/section_check.h"
#include "shared/geom/contour.h"
#include "tests/recon/shapes.h"

namespace recon::section {
namespace {

using geom::Point;
using geom::Polyline;

SectionFaces faces(const Section& section) {
  auto made = faces_of(section);
  EXPECT_TRUE(made) << to_string(made.error());
  return made ? std::move(*made) : SectionFaces{};
}

double sum_of(const SectionFaces& made) {
  double sum = 0.0;
  for (const RockUnit& unit : made.units) sum += unit.area;
  return sum;
}

SectionLine fault(std::vector<Point> points) {
  return {LineId(0), LineKind::Fault, "F", {std::move(points), false}, {}};
}

/// Horizons one under the other, wavy and steep, their ends ragged.
Section wavy(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  const double height = draw(0.5, 6.0);
  std::vector<Polyline> lines;
  for (int k = 0; k < count; ++k) {
    Polyline line;
    for (int i = 0; i <= 80; ++i) {
      const double x = 0.25 * i + (i == 0 || i == 80 ? draw(-0.3, 0.3) : 0.0);
      line.points.push_back({x, height * std::sin(x) - 1.5 * k + draw(-0.2, 0.2)});
    }
    lines.push_back(std::move(line));
  }
  return test::section_of(lines);
}

TEST(SectionFaces, EndsThatRoundingPartsFromAFaultPartUnitsThere) {
  // x of the fault where z is 0 and -1, to the last digits of a double off it on either side.
  const auto on_fault = [](double z) { return 4.1 + (z + 2.7) * 1.2 / 3.7; };
  for (const double off : {0.0, 3e-13, -3e-13, 4e-9}) {
    Section section = test::section_of({{{{0, 0}, {on_fault(0) - off, 0}}, false},
                                        {{{on_fault(0) + off, 0}, {10, 0}}, false},
                                        {{{0, -1}, {on_fault(-1) - off, -1}}, false},
                                        {{{on_fault(-1) + off, -1}, {10, -1}}, false}});
    section.lines.push_back(fault({{4.1, -2.7}, {5.3, 1}}));
    const SectionFaces made = faces(section);
    ASSERT_EQ(made.units.size(), 2u) << off;
    const double left = 0.5 * (on_fault(0) + on_fault(-1));
    EXPECT_NEAR(std::min(made.units[0].area, made.units[1].area), left, 1e-8);
    EXPECT_NEAR(std::max(made.units[0].area, made.units[1].area), 10 - left, 1e-8);
  }
  // Two ends that meet on a vertex of the fault but for a rounding.
  Section met = test::section_of({{{{0, 0}, {5, 0}}, false},
                                  {{{5, 1e-15}, {10, 0}}, false},
                                  {{{0, -1}, {4, -1}}, false},
                                  {{{4, -1}, {10, -1}}, false}});
  met.lines.push_back(fault({{3, -2}, {4, -1}, {5, 0}, {6, 1}}));
  EXPECT_EQ(faces(met).units.size(), 2u);
  // Beds of one wall end exactly on the fault, those of the other but for a rounding, which gives it vertices.
  Section carried = test::section_of({{{{0, 0}, {500, 0}}, false},
                                      {{{635.3553390593273, -135.35533905932732}, {1500, -135.35533905932732}}, false},
                                      {{{0, -300}, {800, -300}}, false},
                                      {{{935.3553390593274, -435.3553390593274}, {1500, -435.3553390593274}}, false}});
  carried.lines.push_back(fault({{400, 100}, {1200, -700}}));
  EXPECT_EQ(faces(carried).units.size(), 2u);
  // A gap that is seen is left as it is drawn: then the units run together.
  Section open = test::section_of({{{{0, 0}, {on_fault(0) - 0.01, 0}}, false}, {{{0, -1}, {10, -1}}, false}});
  open.lines.push_back(fault({{4.1, -2.7}, {5.3, 1}}));
  const auto before = open.horizons[0].line.points;
  faces(open);
  EXPECT_EQ(open.horizons[0].line.points, before);
}

TEST(SectionFaces, UnitsOfAStackLieBetweenNeighboursFromTheTopDown) {
  Section section = test::section_of(
      {{{{0, -2}, {10, -2}}, false}, {{{0, 0}, {5, 1}, {10, 0}}, false}, {{{0, -5}, {10, -4}}, false}});
  EXPECT_EQ(stack_order(section), (std::vector<std::size_t>{1, 0, 2}));
  const SectionFaces made = faces(section);
  ASSERT_EQ(made.units.size(), 2u);
  EXPECT_EQ(made.units[0].name, "bed1 - top");
  EXPECT_DOUBLE_EQ(made.units[0].area, 25.0);
  EXPECT_TRUE(made.units[0].whole);
  EXPECT_EQ(made.units[1].name, "top - bed2");
  EXPECT_DOUBLE_EQ(made.units[1].area, 25.0);
  EXPECT_DOUBLE_EQ(made.area, 50.0);
  EXPECT_TRUE(made.meetings.empty());
}

TEST(SectionFaces, AreasOfTheUnitsAddUpToTheSection) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Section section = wavy(seed, 6);
    section.lines = {fault({{3.0, 12.0}, {9.0, -4.0}, {14.0, -25.0}}), fault({{1.0, 0.0}, {18.0, -3.0}})};
    const SectionFaces made = faces(section);
    EXPECT_NEAR(sum_of(made) / made.area, 1.0, 1e-12) << "seed " << seed;
    EXPECT_TRUE(made.open.empty()) << "seed " << seed;
    section.border = Polyline{{{1, -14}, {19, -14}, {19, 9}, {1, 9}}, true};
    const SectionFaces bordered = faces(section);
    EXPECT_EQ(bordered.area, 18.0 * 23.0);
    EXPECT_NEAR(sum_of(bordered) / bordered.area, 1.0, 1e-12) << "seed " << seed;
  }
}

TEST(SectionFaces, AUnitBetweenTwoHorizonsHasTheAreaOfTheirContour) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Section section = wavy(seed, 4);
    const SectionFaces made = faces(section);
    for (const RockUnit& unit : made.units) {
      if (!unit.whole) continue;
      const Polyline contour = contour_between(section.horizons[*unit.top].line, section.horizons[*unit.base].line);
      EXPECT_NEAR(unit.area / std::abs(geom::signed_area(contour)), 1.0, 1e-12);
    }
  }
}

TEST(SectionFaces, AFaultCutsAUnitIntoFacesWithTheSameArea) {
  Section section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  section.lines = {fault({{4, 2}, {6, -6}}), fault({{8, 1}, {8, -2}})};  // the second ends within the unit
  const SectionFaces made = faces(section);
  ASSERT_EQ(made.units.size(), 1u);
  EXPECT_EQ(made.units[0].faces, 2u);
  EXPECT_TRUE(made.units[0].whole);
  EXPECT_DOUBLE_EQ(made.units[0].area, 40.0);
  double area = 0.0;
  for (const Polyline& contour : made.units[0].contours) area += geom::signed_area(contour);
  EXPECT_DOUBLE_EQ(area, 40.0);
}

TEST(SectionFaces, ATruncatedBedBelongsToItsOwnUnitAndTheUnconformityLiesOnIt) {
  // bed1 ends at the top (an unconformity): under it lies "bed1 - bed2", under the top alone "top - bed2".
  Section section =
      test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -2}, {5, 0}}, false}, {{{0, -6}, {10, -6}}, false}});
  const SectionFaces made = faces(section);
  ASSERT_EQ(made.meetings.size(), 1u);
  EXPECT_EQ(made.meetings[0].meeting.crossings, 0u);
  double under_bed = 0.0;
  for (const RockUnit& unit : made.units) {
    if (unit.top && *unit.top == 1) under_bed = unit.area;
  }
  EXPECT_DOUBLE_EQ(under_bed, 55.0);
  EXPECT_DOUBLE_EQ(sum_of(made), 60.0);
  EXPECT_TRUE(refuse_crossings(section, made));
}

TEST(SectionFaces, TheBorderAddsWhatLiesAboveTheFirstHorizonAndUnderTheLast) {
  Section section = test::section_of({{{{-1, 0}, {11, 0}}, false}, {{{-1, -4}, {11, -4}}, false}});
  section.border = Polyline{{{0, -5}, {10, -5}, {10, 2}, {0, 2}}, true};
  const SectionFaces made = faces(section);
  ASSERT_EQ(made.units.size(), 3u);
  EXPECT_EQ(made.units[0].name, "above top");
  EXPECT_DOUBLE_EQ(made.units[0].area, 20.0);
  EXPECT_EQ(made.units[1].name, "top - bed1");
  EXPECT_EQ(made.units[2].name, "bed1");
  EXPECT_DOUBLE_EQ(made.units[2].area, 10.0);
}

TEST(SectionFaces, GapsAndOverlapsOfPolygonsAreTold) {
  Section section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  section.units = {{UnitId(0), "A", {{{0, -2}, {10, -2}, {10, 0}, {0, 0}}, true}, {}},
                   {UnitId(1), "B", {{{0, -4}, {10, -4}, {10, -2}, {5, -2.5}, {0, -2}}, true}, {}}};
  const SectionFaces gap = faces(section);
  ASSERT_EQ(gap.misfits.size(), 1u);
  EXPECT_EQ(gap.misfits[0].what, "gap");
  EXPECT_EQ(gap.misfits[0].between, "A, B");
  EXPECT_DOUBLE_EQ(gap.misfits[0].area, 2.5);
  section.units[1].contour.points[3] = {5, -1.5};
  const SectionFaces overlap = faces(section);
  ASSERT_EQ(overlap.misfits.size(), 1u);
  EXPECT_EQ(overlap.misfits[0].what, "overlap");
  EXPECT_DOUBLE_EQ(overlap.misfits[0].area, 2.5);
  section.units[1].contour.points.erase(section.units[1].contour.points.begin() + 3);
  EXPECT_TRUE(faces(section).misfits.empty());
  section.border = Polyline{{{0, -4}, {10, -4}, {10, 1}, {0, 1}}, true};
  const SectionFaces left_out = faces(section);
  ASSERT_EQ(left_out.misfits.size(), 1u);
  EXPECT_DOUBLE_EQ(left_out.misfits[0].area, 10.0);
}

TEST(SectionFaces, HorizonsThatCrossAreRefusedWithBothNamesAndThePlace) {
  const Section section = test::section_of({{{{0, 0}, {4, 4}}, false}, {{{0, 4}, {4, 0}}, false}});
  const SectionFaces made = faces(section);
  const auto refused = refuse_crossings(section, made);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::BadSection);
  const std::string text = to_string(refused.error());
  EXPECT_NE(text.find("horizon 'top'"), std::string::npos) << text;
  EXPECT_NE(text.find("'bed1'"), std::string::npos) << text;
  EXPECT_NE(text.find("(at 2, 2)"), std::string::npos) << text;
  EXPECT_NEAR(sum_of(made) / made.area, 1.0, 1e-12);
}

TEST(SectionFaces, APinLineBesideTheSectionIsRefused) {
  Section section = test::section_of({{{{0, 0}, {10, 1}}, false}});
  section.lines = {{LineId(0), LineKind::Pin, "P", {{{5, 3}, {5, -3}}, false}, {}}};
  EXPECT_TRUE(refuse_lines_outside(section));
  section.lines[0].line.points = {{15, 3}, {15, -3}};
  const auto refused = refuse_lines_outside(section);
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()).find("pin line 'P': it lies outside"), 0u) << to_string(refused.error());
}

TEST(SectionFaces, AThousandTimesTooSmallIsAnotherUnitOnlyWhereItWouldFit) {
  const geom::Box section{{0, -2000}, {12000, 500}};
  EXPECT_TRUE(input::seems_of_another_unit({{1, -1.2}, {11, 0.1}}, section));
  EXPECT_TRUE(input::seems_of_another_unit({{1e6, -1.2e6}, {11e6, 0.1e6}}, section));
  EXPECT_FALSE(
      input::seems_of_another_unit({{5000, -300}, {5010, -290}}, section));  // a short fault far from the origin
  EXPECT_FALSE(input::seems_of_another_unit({{100, -300}, {4000, 0}}, section));
}

TEST(SectionFaces, PiecesOfAFaultedHorizonBoundTheUnitsOfTheirBlocks) {
  // Top whole, a bed and a base cut by a vertical fault at x = 6 with a throw of 1; blocks 6 and 4 wide.
  Section section = test::section_of({{{{0, 0}, {10, 0}}, false},
                                      {{{0, -2}, {6, -2}}, false},
                                      {{{6, -3}, {10, -3}}, false},
                                      {{{0, -4}, {6, -4}}, false},
                                      {{{6, -5}, {10, -5}}, false}});
  const char* names[] = {"top", "bed (1)", "bed (2)", "base (1)", "base (2)"};
  for (std::size_t i = 0; i < 5; ++i) {
    section.horizons[i].name = names[i];
    if (i > 0) section.horizons[i].piece_of = i < 3 ? "bed" : "base";
  }
  section.lines.push_back(fault({{6, 0}, {6, -5}}));
  const SectionFaces made = faces(section);
  EXPECT_NEAR(made.area, 6.0 * 4.0 + 4.0 * 5.0, 1e-12);
  EXPECT_NEAR(sum_of(made), made.area, 1e-12);
  const auto area_of = [&](const std::string& name) {
    for (const RockUnit& unit : made.units) {
      if (unit.name == name) return unit.area;
    }
    return -1.0;
  };
  EXPECT_NEAR(area_of("bed (1) - base (1)"), 12.0, 1e-12);
  EXPECT_NEAR(area_of("bed (2) - base (2)"), 8.0, 1e-12);
}

double area_named(const SectionFaces& made, const std::string& name) {
  for (const RockUnit& unit : made.units) {
    if (unit.name == name) return unit.area;
  }
  return -1.0;
}

/// Three horizons at 0, -4 and -9, from x = 0 to 10.
Section three_flat(std::vector<SectionLine> lines = {}) {
  Section section =
      test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}, {{{0, -9}, {10, -9}}, false}});
  section.lines = std::move(lines);
  return section;
}

bool tells_open(const SectionFaces& made, const Section& section) {
  const std::vector<std::string> remarks = remarks_of(made, section);
  return std::any_of(remarks.begin(), remarks.end(),
                     [](const std::string& r) { return r.find("nothing closes the section") != std::string::npos; });
}

void expect_areas(const Section& section, double upper, double lower) {
  const SectionFaces made = faces(section);
  EXPECT_NEAR(area_named(made, "top - bed1"), upper, 1e-12);
  EXPECT_NEAR(area_named(made, "bed1 - bed2"), lower, 1e-12);
  EXPECT_FALSE(tells_open(made, section));
}

TEST(SectionFaces, AnEndThatOnlyTouchesTheEndOfAFaultIsAnEndOfTheSection) {
  for (const auto& course : std::vector<std::vector<Point>>{{{10, 0}, {7, -2}},
                                                            {{10, 0}, {12, 3}},
                                                            {{10, 0}, {8, -4}},
                                                            {{10, 0}, {6, -9}},
                                                            {{-2, 2}, {0, 0}},
                                                            {{10, -4}, {7, -7}},
                                                            {{10, -4}, {13, -6}},
                                                            {{2, -2}, {0, -4}},
                                                            {{10, -9}, {11, -12}}}) {
    SCOPED_TRACE(course.front().x);
    expect_areas(three_flat({fault(course)}), 40.0, 50.0);
  }
}

TEST(SectionFaces, AFaultFromTheEndOfOneHorizonToTheNextIsTheBorder) {
  expect_areas(three_flat({fault({{10, 0}, {11, -2}, {10, -4}})}), 42.0, 50.0);
  expect_areas(three_flat({fault({{10, -4}, {9, -2}, {10, 0}})}), 38.0, 50.0);
}

TEST(SectionFaces, AFaultThatGoesOnBoundsTheSection) {
  // x = 10 - z / 2, in one line or two; all horizons end on it.
  const std::vector<SectionLine> whole{fault({{9.5, 1}, {15, -10}})};
  const std::vector<SectionLine> parts{fault({{9.5, 1}, {10, 0}}), fault({{10, 0}, {15, -10}})};
  for (const auto& lines : {whole, parts}) {
    Section section = three_flat(lines);
    section.horizons[1].line.points.back().x = 12.0;
    section.horizons[2].line.points.back().x = 14.5;
    expect_areas(section, 44.0, 66.25);
  }
}

TEST(SectionFaces, HorizonsThatEndTogetherDoNotOpenTheBorderBelow) {
  Section section = three_flat();
  section.horizons[1].line.points.back() = {10, 0};
  expect_areas(section, 20.0, 70.0);
  // A horizon that crops out at the corner of the section.
  Section corner = test::section_of({{{{0, 0}, {10, -4}}, false}, {{{0, -9}, {10, -9}}, false}});
  corner.lines = {fault({{0, 0}, {10, 0}})};
  corner.lines[0].kind = LineKind::Topography;
  const SectionFaces made = faces(corner);
  EXPECT_NEAR(area_named(made, "above top"), 20.0, 1e-12);
  EXPECT_NEAR(area_named(made, "top - bed1"), 70.0, 1e-12);
}

TEST(SectionFaces, ABorderThatStaysOpenIsToldWithThePlace) {
  // The top ends on a fault that goes on and does not come to the next horizon.
  const Section section = three_flat({fault({{9, 2}, {11, -2}})});
  const SectionFaces made = faces(section);
  EXPECT_NEAR(area_named(made, "bed1 - bed2"), 50.0, 1e-12);
  ASSERT_EQ(made.open.size(), 1U);
  EXPECT_EQ(made.open[0].under, section.horizons[0].id);
  EXPECT_EQ(made.open[0].place, (Point{10, 0}));
  EXPECT_TRUE(tells_open(made, section));
  // The others end on a fault that does not come up to the top.
  Section below = three_flat({fault({{9.5, -2}, {9.5, -12}})});
  for (const std::size_t i : {1U, 2U}) below.horizons[i].line.points.back().x = 9.5;
  const SectionFaces open = faces(below);
  ASSERT_EQ(open.open.size(), 1U);
  EXPECT_EQ(open.open[0].place, (Point{10, 0}));
  EXPECT_NEAR(area_named(open, "bed1 - bed2"), 47.5, 1e-12);
}

TEST(SectionFaces, APartUnderAFaultIsNamedByTheHorizonOverTheFault) {
  // A and B flat, 4 apart; a fault between them from side to side, along the crests of A, in steps, and two faults.
  const Section layer = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  for (const auto& course : std::vector<std::vector<Point>>{
           {{-1, -2}, {11, -2}}, {{-1, -1}, {11, -3.5}}, {{-1, -2}, {4, -2}, {4.5, -3}, {11, -3}}}) {
    Section section = layer;
    section.border = Polyline{{{0, -6}, {10, -6}, {10, 2}, {0, 2}}, true};
    section.lines.push_back(fault(course));
    const SectionFaces one = faces(section);
    EXPECT_NEAR(area_named(one, "top - bed1"), 40.0, 1e-9);
    EXPECT_NEAR(area_named(one, "above top"), 20.0, 1e-9);
    EXPECT_NEAR(area_named(one, "bed1"), 20.0, 1e-9);
    section.lines.push_back(fault({{-1, -3.6}, {11, -3.6}}));
    EXPECT_NEAR(area_named(faces(section), "top - bed1"), 40.0, 1e-9);
  }
  Section folded = test::section_of({{{{0, 0}, {2, 2}, {4, 0}, {6, 2}, {8, 0}, {10, 2}, {12, 0}}, false},
                                     {{{0, -4}, {2, -2}, {4, -4}, {6, -2}, {8, -4}, {10, -2}, {12, -4}}, false}});
  folded.lines.push_back(fault({{-1, -2}, {13, -2}}));  // along the crests of the lower one
  EXPECT_NEAR(area_named(faces(folded), "top - bed1"), 48.0, 1e-9);
  folded.lines.back() = fault({{-1, 2}, {11, 2}});  // and of the upper one
  EXPECT_NEAR(area_named(faces(folded), "top - bed1"), 48.0, 1e-9);
  folded.lines.back() = fault({{-1, -1}, {13, -1}});  // through the limbs
  EXPECT_NEAR(area_named(faces(folded), "top - bed1"), 48.0, 1e-9);
}

TEST(SectionFaces, ABedOverAFaultNamesNothingUnderItThatIsYoungerOrOpenAbove) {
  // A thrust that carries B over A: what lies on A below the thrust is above A.
  Section section =
      test::section_of({{{{0, 4}, {10, 4}}, false}, {{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  section.horizons[0].name = "B (2)";
  section.horizons[1].name = "A";
  section.horizons[2].name = "B (1)";
  for (const std::size_t i : {0u, 2u}) section.horizons[i].piece_of = "B";
  section.border = Polyline{{{0, -6}, {10, -6}, {10, 6}, {0, 6}}, true};
  section.lines.push_back(fault({{-1, 1}, {11, 3}}));
  EXPECT_NEAR(area_named(faces(section), "A - B (1)"), 40.0, 1e-9);
  EXPECT_EQ(area_named(faces(section), "B (2) - A"), -1.0);
  EXPECT_NEAR(area_named(faces(section), "B (2)"), 20.0, 1e-9);
  // A block under a steep fault and mostly under open sky, beside a block where A is higher.
  Section block = test::section_of({{{{3.3, 3}, {10, 3}}, false}, {{{0, -4}, {10, -4}}, false}});
  block.border = section.border;
  block.lines.push_back(fault({{4, -6}, {4, -4}, {3.3, 3}, {3, 6}}));
  EXPECT_NEAR(area_named(faces(block), "top - bed1"), 7.0 * (6.0 + 6.7) / 2.0, 1e-9);
}

TEST(SectionFaces, ManyMisfitsAreToldInOneLineWithTheGreatest) {
  Section section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  section.units = {{UnitId(0), "A", {{{0, -2}, {10, -2}, {10, 0}, {0, 0}}, true}, {}},
                   {UnitId(1), "B", {{{0, -4}, {10, -4}, {10, -2}, {8, -2.5}, {6, -2}, {4, -3}, {0, -2}}, true}, {}}};
  const std::vector<MisfitRemark> told = misfit_remarks(faces(section));
  ASSERT_EQ(told.size(), 1u);
  // Triangles of bases 4 and 6, heights 0.5 and 1.
  EXPECT_EQ(told[0].text.find("2 gaps of 4 m2 in all; the greatest: gap of 3 m2 between the units A, B at"), 0u)
      << told[0].text;
}

}  // namespace
}  // namespace recon::section
