// Lofts: sections that do not agree are refused with the place; then volumes by formulas of their own, and parts that
// meet in the same triangles.

#include "shared/solid/shape/loft.h"

#include <gmock/gmock.h>

#include <optional>
#include <random>
#include <set>

#include "shared/solid/check/validate.h"
#include "shared/solid/shape/instance.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shape;
using base::ErrorCode;
using geom::Point;
using geom::Point3;
using shapes::euler_holds;
using testing::HasSubstr;
using testing::IsEmpty;

/// Upright, x along, seen from the south, at a place to the north.
SectionFrame upright(double north) { return {{0, north, 0}, {1, 0, 0}, {0, 0, 1}}; }

/// Two beds in a box from x = 0 to 4, z = 0 to 3; the horizon between them runs through the given points.
LoftSection beds(double north, const std::vector<Point>& horizon) {
  const Point west = horizon.front();
  const Point east = horizon.back();
  return {upright(north),
          {{{{west, {0, 0}, {4, 0}, east}, false}, "border", "lower", ""},
           {{{east, {4, 3}, {0, 3}, west}, false}, "border", "upper", ""},
           {{horizon, false}, "top_of_lower", "upper", "lower"}}};
}

std::vector<Solid> solids_of(const std::vector<LoftPart>& parts) {
  std::vector<Solid> solids;
  for (const LoftPart& part : parts) {
    auto solid = solid_of(part.shape, "");
    EXPECT_TRUE(solid) << part.name << ": " << (solid ? "" : solid.error().message);
    EXPECT_THAT(check::violations(*solid), IsEmpty());
    EXPECT_TRUE(euler_holds(solid->counts()));
    solids.push_back(*solid);
  }
  return solids;
}

TEST(LoftSections, UnitsInAnotherOrderAreRefusedWithThePlace) {
  const LoftSection first = beds(0, {{0, 1}, {4, 2}});
  LoftSection second = beds(5, {{0, 1}, {4, 2}});
  for (LoftLine& line : second.lines) {
    for (std::string* side : {&line.left, &line.right}) {
      if (!side->empty()) *side = *side == "upper" ? "lower" : "upper";
    }
  }
  // Turned upside down as a map it would agree, but for the horizon's direction; a bed more does not.
  LoftSection third = beds(5, {{0, 1}, {4, 2}});
  third.lines.push_back({{{{1, 2}, {2, 2}, {2, 2.5}}, true}, "lens", "sand", "upper"});
  const auto more = loft_sections(std::vector{first, third});
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().code, ErrorCode::InvalidOption);
  EXPECT_THAT(more.error().message, HasSubstr("section 2: line 'lens' between 'sand' and 'upper' is not in section 1"));
  EXPECT_EQ(more.error().place->y, 5.0);
  const auto less = loft_sections(std::vector{third, beds(9, {{0, 1}, {4, 2}})});
  ASSERT_FALSE(less);
  EXPECT_THAT(less.error().message, HasSubstr("is not in section 2"));
  // Three beds whose upper two have changed places.
  const auto three = [](double north, const char* middle, const char* top) {
    return LoftSection{upright(north),
                       {{{{{0, 1}, {0, 0}, {4, 0}, {4, 1}}, false}, "border", "a", ""},
                        {{{{4, 1}, {4, 2}}, false}, "border", middle, ""},
                        {{{{0, 2}, {0, 1}}, false}, "border", middle, ""},
                        {{{{4, 2}, {4, 3}, {0, 3}, {0, 2}}, false}, "border", top, ""},
                        {{{{0, 1}, {4, 1}}, false}, "h", middle, "a"},
                        {{{{0, 2}, {4, 2}}, false}, "h", top, middle}}};
  };
  EXPECT_TRUE(loft_sections(std::vector{three(0, "b", "c"), three(1, "b", "c")}));
  const auto swapped = loft_sections(std::vector{three(0, "b", "c"), three(1, "c", "b")});
  ASSERT_FALSE(swapped);
  EXPECT_THAT(swapped.error().message, HasSubstr("section"));
  EXPECT_TRUE(swapped.error().place.has_value());
}

TEST(LoftSections, SectionsThatCrossOrLookBackAreRefused) {
  const LoftSection first = beds(0, {{0, 1}, {4, 2}});
  EXPECT_FALSE(loft_sections(std::vector{first}));
  LoftSection back = beds(5, {{0, 1}, {4, 2}});
  back.frame.along = {-1, 0, 0};
  EXPECT_THAT(loft_sections(std::vector{first, back}).error().message, HasSubstr("from the other side"));
  LoftSection across = beds(0, {{0, 1}, {4, 2}});
  across.frame = {{0, -1, 0}, {0.8, 0.6, 0}, {0, 0, 1}};
  const auto crossed = loft_sections(std::vector{first, across});
  ASSERT_FALSE(crossed);
  EXPECT_THAT(crossed.error().message, HasSubstr("crosses or touches section"));
  EXPECT_TRUE(crossed.error().place->y.has_value());
  EXPECT_FALSE(loft_sections(std::vector{first, first}));
  const auto order = loft_sections(std::vector{first, beds(5, {{0, 1}, {4, 2}}), beds(3, {{0, 1}, {4, 2}})});
  ASSERT_FALSE(order);
  EXPECT_THAT(order.error().message, HasSubstr("in the order in which they stand"));
}

TEST(LoftSections, LinesThatDisagreeAreRefusedWithThePlace) {
  LoftSection wrong = beds(0, {{0, 1}, {4, 2}});
  std::swap(wrong.lines[2].left, wrong.lines[2].right);
  const auto sides = loft_sections(std::vector{wrong, beds(1, {{0, 1}, {4, 2}})});
  ASSERT_FALSE(sides);
  EXPECT_THAT(sides.error().message, HasSubstr("section 1: between the lines"));
  EXPECT_TRUE(sides.error().place->x == 0.0 || sides.error().place->x == 4.0);
  LoftSection twice = beds(0, {{0, 1}, {2, 1}, {2, 1}, {4, 2}});
  EXPECT_EQ(loft_sections(std::vector{twice, beds(1, {{0, 1}, {4, 2}})}).error().code, ErrorCode::DegenerateCurve);
  LoftSection endless = beds(0, {{0, 1}, {NAN, 1}, {4, 2}});
  EXPECT_EQ(loft_sections(std::vector{endless, beds(1, {{0, 1}, {4, 2}})}).error().code, ErrorCode::NotFinite);
  LoftSection floating = beds(0, {{0, 1}, {4, 2}});
  floating.lines.push_back({{{{1, 0.2}, {2, 0.2}, {2, 0.5}}, true}, "lens", "sand", "upper"});
  EXPECT_THAT(loft_sections(std::vector{floating, floating}).error().message, HasSubstr("lies in 'lower'"));
}

TEST(LoftSections, EqualSectionsMakeTheExtrusion) {
  const std::vector<Point> horizon{{0, 1}, {1, 1.5}, {2.5, 0.5}, {4, 2}};
  const auto parts = loft_sections(std::vector{beds(0, horizon), beds(10, horizon)});
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 2U);
  const auto solids = solids_of(*parts);
  // Below the horizon by trapezes: 1.25 + 1.5 + 1.875.
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_DOUBLE_EQ(volume(solids[i]), 10.0 * ((*parts)[i].name == "lower" ? 4.625 : 12.0 - 4.625));
  EXPECT_EQ(solids[0].counts().faces, 3U + 3U + 2U);  // the border is merged where it is plane
}

TEST(LoftSections, LinesMayHaveOtherNumbersOfPointsAndPartsShareTriangles) {
  const std::vector<LoftSection> sections{beds(0, {{0, 1}, {1, 1.5}, {2.5, 0.5}, {4, 2}}), beds(4, {{0, 1.5}, {4, 1}}),
                                          beds(7, {{0, 0.5}, {2, 2}, {4, 1.5}})};
  const auto parts = loft_sections(sections);
  ASSERT_TRUE(parts);
  const auto solids = solids_of(*parts);
  EXPECT_NEAR(volume(solids[0]) + volume(solids[1]), 7 * 12.0, 1e-12);
  using Corners = std::multiset<std::array<double, 3>>;
  std::array<std::multiset<Corners>, 2> bands;
  for (std::size_t i = 0; i < 2; ++i) {
    const Shape& shape = (*parts)[i].shape;
    for (std::size_t f = 0; f < shape.names.size(); ++f) {
      if (shape.names[f] != "top_of_lower") continue;
      Corners corners;
      for (const std::uint32_t c : shape.mesh.faces[f][0]) {
        const Point3 p = shape.mesh.points[c];
        corners.insert({p.x, p.y, p.z});
      }
      bands[i].insert(corners);
    }
  }
  EXPECT_GT(bands[0].size(), 3U + 1U + 1U + 2U);
  EXPECT_EQ(bands[0], bands[1]);
  const Combined both = shapes::combined(solids, Operation::Union);
  EXPECT_EQ(both.contact, Contact::Face);
  EXPECT_EQ(both.solid.shell_count(), 1U);
}

/// Where a line is after this part of its length.
Point after(const std::vector<Point>& line, double part) {
  double whole = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    whole += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  double left = part * whole;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    if (left <= step || i + 1 == line.size()) {
      const double t = std::min(1.0, left / step);
      return {line[i - 1].x + t * (line[i].x - line[i - 1].x), line[i - 1].y + t * (line[i].y - line[i - 1].y)};
    }
    left -= step;
  }
  return line.back();
}

/// Under the surface of straight lines from each place of one horizon to the one as far along the next: the areas of
/// plane sections go as a square does, so Simpson's rule is exact.
double under_ruled(double length, const std::vector<Point>& a, const std::vector<Point>& b) {
  std::set<double> parts{0.0, 1.0};
  for (const auto* line : {&a, &b}) {
    double whole = 0.0;
    std::vector<double> at{0.0};
    for (std::size_t i = 1; i < line->size(); ++i)
      at.push_back(whole += std::hypot((*line)[i].x - (*line)[i - 1].x, (*line)[i].y - (*line)[i - 1].y));
    for (const double s : at) parts.insert(s / whole);
  }
  const auto area = [&](double y) {
    double sum = 0.0;
    std::optional<Point> last;
    for (const double part : parts) {
      const Point p = after(a, part);
      const Point q = after(b, part);
      const Point r{(1 - y) * p.x + y * q.x, (1 - y) * p.y + y * q.y};
      if (last) sum += 0.5 * (r.x - last->x) * (r.y + last->y);
      last = r;
    }
    return sum;
  };
  return length / 6.0 * (area(0) + 4 * area(0.5) + area(1));
}

TEST(LoftSections, LinesOfOtherNumbersOfPointsHaveTheVolumeUnderTheRuledSurface) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  // Too flat for corners.
  const auto horizon = [&](int inner) {
    std::vector<Point> line{{0, 1 + 0.15 * uniform(random)}};
    for (int i = 1; i <= inner; ++i)
      line.push_back({4.0 * (i + 0.5 * uniform(random) - 0.25) / (inner + 1), 1 + 0.15 * uniform(random)});
    line.push_back({4, 1 + 0.15 * uniform(random)});
    return line;
  };
  for (int run = 0; run < 40; ++run) {
    const auto a = horizon(run % 4), b = horizon(run / 4 % 5), c = horizon(run % 3);
    const auto parts = loft_sections(std::vector{beds(0, a), beds(3, b), beds(10, c)});
    ASSERT_TRUE(parts) << parts.error().message;
    const auto solids = solids_of(*parts);
    const double below = under_ruled(3, a, b) + under_ruled(7, b, c);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(volume(solids[i]), (*parts)[i].name == "lower" ? below : 120.0 - below, 1e-11) << run;
  }
}

TEST(LoftSections, CornersOfABorderAreJoinedHoweverFarAlongTheyAre) {
  // The sides of the box have other lengths in each section, and one has a notch that the other has not.
  const auto section = [](double north, double west, double east, bool notch) {
    LoftSection made = beds(north, {{0, west}, {4, east}});
    if (notch) made.lines[0].line.points = {{0, west}, {0, 0}, {1, 0}, {1, 0.1}, {2, 0.1}, {2, 0}, {4, 0}, {4, east}};
    return made;
  };
  for (const bool notch : {false, true}) {
    const auto parts = loft_sections(std::vector{section(0, 0.1, 2.9, false), section(6, 2.9, 0.1, notch)});
    ASSERT_TRUE(parts);
    const auto solids = solids_of(*parts);
    // The notch is a ridge that grows from nothing to 0.1 m. Of 4.2 m along the bottom it has 0.1, 1 and 0.1, so that
    // on the other section it stands on 4 * 1.2 / 4.2, with 4 / 4.2 on top.
    const double ridge = 6.0 * 0.1 * ((8.0 / 7 + 20.0 / 21) / 2 / 6 + 1.0 / 3);
    EXPECT_NEAR(volume(solids[0]) + volume(solids[1]), 72.0 - (notch ? ridge : 0.0), 1e-12);
  }
}

TEST(LoftSections, TwistedBedsHaveTheVolumeOfTheBilinearSurface) {
  // Between two points each: the mean of the four heights times the base.
  for (const auto& [west_0, east_0, west_1, east_1] :
       {std::array{1.0, 2.0, 2.5, 0.25}, std::array{2.5, 0.25, 1.0, 2.0}, std::array{0.5, 2.75, 2.75, 0.5}}) {
    const std::vector<LoftSection> sections{beds(0, {{0, west_0}, {4, east_0}}), beds(6, {{0, west_1}, {4, east_1}})};
    const auto parts = loft_sections(sections);
    ASSERT_TRUE(parts);
    const auto solids = solids_of(*parts);
    const double below = 6.0 * west_0 + 6.0 * east_0 + 6.0 * west_1 + 6.0 * east_1;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(volume(solids[i]), (*parts)[i].name == "lower" ? below : 72.0 - below, 1e-13);
    for (const Solid& solid : solids) EXPECT_EQ(solid.counts().faces, 4U + 5U);
  }
}

TEST(LoftSections, APlaneBetweenSectionsStaysAPlane) {
  // Vertices at other places of one plane do not cut it apart.
  const auto level = loft_sections(std::vector{beds(0, {{0, 2}, {1, 2}, {4, 2}}), beds(8, {{0, 2}, {3, 2}, {4, 2}})});
  ASSERT_TRUE(level);
  for (const Solid& solid : solids_of(*level)) EXPECT_EQ(solid.counts(), (Counts{8, 12, 6, 0, 1, 0}));
}

TEST(LoftSections, SeenFromTheOtherSideTheSolidsAreTheSame) {
  std::vector<LoftSection> sections{beds(0, {{0, 1}, {4, 2}}), beds(4, {{0, 1.5}, {4, 1}})};
  const auto forth = loft_sections(sections);
  std::reverse(sections.begin(), sections.end());
  const auto back = loft_sections(sections);
  ASSERT_TRUE(forth && back);
  const auto a = solids_of(*forth);
  const auto b = solids_of(*back);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(volume(a[i]), 0.0);
    EXPECT_NEAR(volume(a[i]), volume(b[i]), 1e-12);
  }
}

/// A fault with the same two beds on both sides, a lens in one of them; lines in any order, direction and pieces.
LoftSection faulted(double north, double fault, double throw_, std::mt19937& random) {
  const Point foot{fault, 0};
  const Point head{fault + 1, 4};
  const auto on_fault = [&](double z) { return Point{fault + z / 4, z}; };
  const Point west = on_fault(2);
  const Point east = on_fault(2 - throw_);
  std::vector<LoftLine> lines{{{{{0, 2}, {0, 0}, foot}, false}, "border", "lower", ""},
                              {{{foot, {10, 0}, {10, 2 - throw_}}, false}, "border", "lower", ""},
                              {{{{10, 2 - throw_}, {10, 4}, head}, false}, "border", "upper", ""},
                              {{{head, {0, 4}, {0, 2}}, false}, "border", "upper", ""},
                              {{{{0, 2}, {2, 2.2}, west}, false}, "top", "upper", "lower"},
                              {{{east, {8, 2.1 - throw_}, {10, 2 - throw_}}, false}, "top", "upper", "lower"},
                              {{{foot, east}, false}, "fault", "lower", "lower"},
                              {{{east, west}, false}, "fault", "lower", "upper"},
                              {{{west, head}, false}, "fault", "upper", "upper"},
                              {{{{1, 1}, {2, 1}, {2, 1.5}, {1.2, 1.6}}, true}, "lens", "sand", "lower"},
                              {{{{9, 0.2}, {9.5, 0.7}}, false}, "tip", "lower", "lower"}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].line.points.size() >= 3 && !lines[i].line.closed && random() % 2 == 0) {
      LoftLine rest = lines[i];
      rest.line.points.erase(rest.line.points.begin());
      lines[i].line.points.resize(2);
      lines.push_back(rest);
    }
    if (random() % 2 == 0) {
      lines[i].line = geom::reversed(lines[i].line);
      std::swap(lines[i].left, lines[i].right);
    }
  }
  std::shuffle(lines.begin(), lines.end(), random);
  return {upright(north), lines};
}

TEST(LoftSections, FaultsWithTheSameUnitsOnBothSidesAreToldApartWhateverTheOrderOfLines) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<LoftSection> sections{faulted(0, 4, 1, random), faulted(5, 5, 0.5, random)};
    const auto parts = loft_sections(sections);
    ASSERT_TRUE(parts) << parts.error().message;
    ASSERT_EQ(parts->size(), 5U);
    const auto solids = solids_of(*parts);
    double sum = 0.0;
    std::multiset<std::string> names;
    for (std::size_t i = 0; i < 5; ++i) {
      sum += volume(solids[i]);
      names.insert((*parts)[i].name);
    }
    EXPECT_NEAR(sum, 10.0 * 4.0 * 5.0, 1e-11);
    EXPECT_EQ(names, (std::multiset<std::string>{"lower", "lower", "sand", "upper", "upper"}));
    const Combined all = shapes::combined(solids, Operation::Union);
    EXPECT_EQ(all.contact, Contact::Face);
    EXPECT_EQ(all.solid.shell_count(), 1U);
    EXPECT_NEAR(volume(all.solid), sum, 1e-11);
  }
}

TEST(LoftSections, ACutBetweenGivesTheRegionsBack) {
  std::mt19937 random(3);
  const std::vector<LoftSection> sections{faulted(0, 4, 1, random), faulted(5, 4, 1, random)};
  const auto parts = loft_sections(sections).value();
  const auto solids = solids_of(parts);
  std::vector<std::string> names;
  for (const LoftPart& part : parts) names.push_back(part.name);
  const Cap cap = cap_of(Sections(solids).cut({0, -1, 0, 2.5}).value());
  const LoftSection between = loft_section(cap, names);
  std::multiset<std::string> lines;
  for (const LoftLine& line : between.lines) lines.insert(line.name);
  EXPECT_EQ(lines.count("top"), 2U);
  EXPECT_EQ(lines.count("fault"), 3U);
  EXPECT_EQ(lines.count("lens"), 1U);
  const auto again = loft_sections(std::vector{sections[0], between, sections[1]});
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_EQ(again->size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ((*again)[i].name, parts[i].name);
    EXPECT_NEAR(volume(solid_of((*again)[i].shape).value()), volume(solids[i]), 1e-12);
  }
}

PlacedProfile square(double half, double z) {
  return {{{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true}, {}}, moved_by({0, 0, z})};
}

TEST(Loft, ProfilesThatDoNotFollowEachOtherAreRefused) {
  EXPECT_FALSE(loft(std::vector{square(1, 0)}));
  EXPECT_THAT(loft(std::vector{square(1, 0), square(1, 0)}).error().message, HasSubstr("not in front of"));
  EXPECT_FALSE(loft(std::vector{square(1, 0), square(1, -1)}));
  EXPECT_FALSE(loft(std::vector{square(1, 0), square(1, 2), square(1, 1)}));
  PlacedProfile tilted = square(1, 0.5);
  tilted.place = product(moved_by({0, 0, 0.5}), turned({}, {1, 0, 0}, 45));
  const auto crossing = loft(std::vector{square(1, 0), tilted});
  ASSERT_FALSE(crossing);
  EXPECT_TRUE(crossing.error().place->z.has_value());
  PlacedProfile hollow = square(1, 1);
  hollow.profile.holes.push_back({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}}, true});
  EXPECT_THAT(loft(std::vector{square(1, 0), hollow}).error().message, HasSubstr("holes"));
}

/// Rock 'a' from x = 0 to 1 and rock 'b' to x = 4 beside an upright fault; z from 0 to 3.
LoftSection beside(double north) {
  return {upright(north),
          {{{{{1, 3}, {0, 3}, {0, 0}, {1, 0}}, false}, "border", "a", ""},
           {{{{1, 0}, {4, 0}, {4, 3}, {1, 3}}, false}, "border", "b", ""},
           {{{{1, 0}, {1, 3}}, false}, "fault", "a", "b"}}};
}
/// As if the trace had been drawn from its other end; the frame is left as it is.
LoftSection digitised_back(LoftSection section) {
  for (LoftLine& line : section.lines) {
    for (Point& p : line.line.points) p.x = 4.0 - p.x;
    std::swap(line.left, line.right);
  }
  return section;
}

TEST(LoftSections, ASectionThatIsTurnedAgainstTheOtherIsRefusedWithThePlace) {
  // One section digitised the other way: as maps the two agree, and 'a' would cross 'b'.
  for (const bool second : {false, true}) {
    const LoftSection there = digitised_back(beside(second ? 5 : 0));
    const auto turned = loft_sections(second ? std::vector{beside(0), there} : std::vector{there, beside(5)});
    ASSERT_FALSE(turned);
    EXPECT_EQ(turned.error().code, ErrorCode::InvalidOption);
    EXPECT_THAT(turned.error().message, HasSubstr("section 2: its lines are turned against those of section 1"));
    EXPECT_EQ(turned.error().place->y, 5.0);
  }
  // Seen from the other side as well it is the same section.
  LoftSection seen_back = digitised_back(beside(5));
  seen_back.frame = {{4, 5, 0}, {-1, 0, 0}, {0, 0, 1}};
  const auto looks_back = loft_sections(std::vector{beside(0), seen_back});
  ASSERT_FALSE(looks_back);
  EXPECT_THAT(looks_back.error().message, HasSubstr("from the other side"));
  EXPECT_EQ(looks_back.error().place->y, 5.0);
  // Upside down.
  LoftSection upside_down = beside(5);
  upside_down.frame = {{4, 5, 3}, {-1, 0, 0}, {0, 0, -1}};
  EXPECT_THAT(loft_sections(std::vector{beside(0), upside_down}).error().message, HasSubstr("turned against"));
  // The third alone.
  const auto third = loft_sections(std::vector{beside(0), beside(2), digitised_back(beside(5))});
  ASSERT_FALSE(third);
  EXPECT_THAT(third.error().message, HasSubstr("section 3: its lines are turned against those of section 2"));
}

TEST(LoftSections, SectionsThatAreDigitisedTheSameWayAreJoinedWhicheverItIs) {
  for (const bool back : {false, true}) {
    const auto section = [&](double north) { return back ? digitised_back(beside(north)) : beside(north); };
    const auto parts = loft_sections(std::vector{section(0), section(5)});
    ASSERT_TRUE(parts) << parts.error().message;
    const auto solids = solids_of(*parts);
    ASSERT_EQ(solids.size(), 2U);
    EXPECT_NEAR(volume(solids[0]), 15.0, 1e-12);
    EXPECT_NEAR(volume(solids[1]), 45.0, 1e-12);
  }
  // Beds that lie on each other are the same from either end, with the other dip: the volume below by Simpson's rule.
  const auto parts = loft_sections(std::vector{beds(0, {{0, 1}, {4, 2}}), digitised_back(beds(6, {{0, 1}, {4, 2}}))});
  ASSERT_TRUE(parts) << parts.error().message;
  const auto solids = solids_of(*parts);
  EXPECT_NEAR(volume(solids[0]) + volume(solids[1]), 72.0, 1e-12);
  // A section askew by 80 degrees is no section that is turned round.
  LoftSection askew = beside(9);
  askew.frame.along = {std::cos(1.4), std::sin(1.4), 0};
  EXPECT_TRUE(loft_sections(std::vector{beside(0), askew}));
}

TEST(Loft, AProfileTurnedByHalfATurnIsRefusedWithThePlace) {
  for (const int corners : {3, 4, 7}) {
    std::vector<Point> outline;
    for (const auto& [x, y] : shapes::regular(corners, 2)) outline.push_back({x, y});
    const PlacedProfile low{{{outline, true}, {}}, identity};
    PlacedProfile high{{{outline, true}, {}}, product(moved_by({5, 0, 3}), turned({}, {0, 0, 1}, 180))};
    const auto folded = loft(std::vector{low, high});
    ASSERT_FALSE(folded) << corners;
    EXPECT_EQ(folded.error().code, ErrorCode::InvalidOption);
    EXPECT_THAT(folded.error().message, HasSubstr("profile 2 is turned by half a turn against profile 1"));
    EXPECT_EQ(folded.error().place->z, 3.0);
    // As large, and turned by less.
    high.place = product(moved_by({5, 0, 3}), turned({}, {0, 0, 1}, 30));
    EXPECT_TRUE(loft(std::vector{low, high}));
  }
  // Another corner is the first: a square that looks the same.
  PlacedProfile other = square(1, 2);
  std::rotate(other.profile.outline.points.begin(), other.profile.outline.points.begin() + 2,
              other.profile.outline.points.end());
  EXPECT_FALSE(loft(std::vector{square(2, 0), other}));
}

TEST(Loft, AFrustumHasItsVolumeAndFaces) {
  const Solid frustum = solid_of(loft(std::vector{square(2, 0), square(1, 3)}).value()).value();
  EXPECT_THAT(check::violations(frustum), IsEmpty());
  EXPECT_NEAR(volume(frustum), 3.0 / 3.0 * (16 + 8 + 4), 1e-13);
  EXPECT_EQ(frustum.counts(), (Counts{8, 12, 6, 0, 1, 0}));
  // A contour that runs the other way but begins at the same corner is the same.
  PlacedProfile clockwise = square(1, 3);
  std::reverse(clockwise.profile.outline.points.begin() + 1, clockwise.profile.outline.points.end());
  const Solid same = solid_of(loft(std::vector{square(2, 0), clockwise}).value()).value();
  EXPECT_EQ(volume(same), volume(frustum));
  EXPECT_EQ(same.counts(), frustum.counts());
}

TEST(Loft, ProfilesWithOtherNumbersOfCornersAndHolesAreJoined) {
  const auto ring = [](int corners, double radius) {
    geom::Polyline line{{}, true};
    for (const auto& [x, y] : shapes::regular(corners, radius)) line.points.push_back({x, y});
    return line;
  };
  const PlacedProfile low{{ring(4, 2), {ring(4, 1)}}, identity};
  const PlacedProfile high{{ring(64, 2), {ring(32, 0.5)}}, moved_by({1, 0, 4})};
  const Solid tube = solid_of(loft(std::vector{low, high}).value()).value();
  EXPECT_THAT(check::violations(tube), IsEmpty());
  EXPECT_EQ(tube.counts().handles, 1);
  std::set<std::string> names;
  for (std::size_t f = 0; f < tube.face_count(); ++f) names.insert(tube.name(FaceId(f)));
  EXPECT_EQ(names, (std::set<std::string>{"start", "end", "side", "hole_1"}));
}

}  // namespace
}  // namespace dobra::solid
