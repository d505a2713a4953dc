#include "quebra/repair/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/quebra_scenarios.h"

namespace quebra::repair {
namespace {

using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Polyline;

sketch::Curve polygon(const std::string& name, std::vector<Point> points, sketch::Role role = sketch::Role::Boundary) {
  return {name, role, Polyline{std::move(points), true}, {}};
}
sketch::Curve line(const std::string& name, std::vector<Point> points) {
  return {name, sketch::Role::Boundary, Polyline{std::move(points), false}, {}};
}

Repaired mended(std::vector<sketch::Curve> curves) {
  sketch::Sketch sketch;
  sketch.places.resize(curves.size());
  sketch.curves = std::move(curves);
  return repair(std::move(sketch)).value();
}

std::vector<sketch::Wrong> kinds(const Repaired& repaired) {
  std::vector<sketch::Wrong> result;
  for (const sketch::Finding& finding : repaired.findings) result.push_back(finding.wrong);
  return result;
}

/// Area of the material of the domain that the mended sketch makes.
double area_of(const Repaired& repaired) {
  const auto domain = domain::make_domain(repaired.sketch);
  EXPECT_TRUE(domain.ok()) << (domain ? "" : to_string(domain.error()));
  double area = 0.0;
  if (domain) {
    for (const domain::Face& face : domain->faces) area += face.area;
  }
  return area;
}

TEST(Repair, GoodGeometryStaysAsItIs) {
  const auto arc =
      Arc::from_angles({0, 0}, 1.0, dobra::base::Angle::from_degrees(0), dobra::base::Angle::from_degrees(180)).value();
  const Repaired same = mended({{"arc", sketch::Role::Boundary, arc, {}},
                                line("chord", {{-1, 0}, {1, 0}}),
                                polygon("hole", {{-0.1, 0.2}, {0.1, 0.2}, {0, 0.5}})});
  EXPECT_TRUE(same.findings.empty());
  EXPECT_EQ(same.sketch.curves.size(), 3U);
}

TEST(Repair, RepeatedPointsSpikesAndDoublesGo) {
  const Repaired repaired =
      mended({polygon("a", {{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4 + 1e-9}, {0, 4}, {0, 2}, {-3, 2}, {0, 2}, {0, 0}}),
              polygon("again", {{0, 4}, {4, 4}, {4, 0}, {0, 0}, {0, 2}}), line("dot", {{1, 1}, {1, 1}})});
  EXPECT_EQ(kinds(repaired),
            (std::vector{sketch::Wrong::RepeatedPoint, sketch::Wrong::NearlyRepeatedPoint, sketch::Wrong::RepeatedPoint,
                         sketch::Wrong::Spike, sketch::Wrong::RepeatedPoint, sketch::Wrong::RepeatedPoint,
                         sketch::Wrong::NoExtent, sketch::Wrong::CurveTwice}));
  EXPECT_EQ(repaired.findings[3].at, (Point{-3, 2}));
}

TEST(Repair, GapsAreClosedAtTheirPlace) {
  const Repaired repaired = mended({line("a", {{0, 0}, {4, 0}, {4, 4}}), line("b", {{4.001, 4}, {0, 4}, {0, 0.002}})});
  EXPECT_EQ(kinds(repaired), (std::vector{sketch::Wrong::Gap, sketch::Wrong::Gap}));
  EXPECT_NEAR(area_of(repaired), 16.0, 1e-12);
  const Repaired open = mended({line("c", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0.001}})});
  EXPECT_NEAR(area_of(open), 16.0, 1e-12);
  EXPECT_TRUE(mended({line("wide", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}})}).findings.empty())
      << "a gap that wide is meant, or an error";
}

TEST(Repair, AGapAtASplineIsClosedAndOneAtAnArcIsNamed) {
  using dobra::geom::CubicPath;
  const auto bow = [](Point to) {
    return sketch::Smooth::make(CubicPath({{{4, 0}, to, {0, 6}, {-6, 0}}}, {0.0, 1.0})).value();
  };
  const Repaired spline = mended(
      {line("a", {{0, 0}, {4, 0}}), {"bow", sketch::Role::Boundary, bow({0.001, 4}), {}}, line("b", {{0, 4}, {0, 0}})});
  EXPECT_EQ(kinds(spline), (std::vector{sketch::Wrong::Gap}));
  EXPECT_GT(area_of(spline), 8.0);
  const Repaired two =
      mended({{"bow", sketch::Role::Boundary, bow({0.001, 4}), {}},
              {"back",
               sketch::Role::Boundary,
               sketch::Smooth::make(CubicPath({{{0, 4}, {4, 0}, {0, -4}, {4, 0}}}, {0.0, 1.0})).value(),
               {}}});
  EXPECT_EQ(kinds(two), (std::vector{sketch::Wrong::Gap}));
  EXPECT_GT(area_of(two), 1.0);
  const auto arc = [](double radius) {
    return Arc::from_angles({0, 0}, radius, dobra::base::Angle::from_degrees(0), dobra::base::Angle::from_degrees(180))
        .value();
  };
  const Repaired arcs = mended(
      {{"arc", sketch::Role::Boundary, arc(1.0), {}},
       {"lower",
        sketch::Role::Boundary,
        Arc::from_angles({0.001, 0}, 1.0, dobra::base::Angle::from_degrees(180), dobra::base::Angle::from_degrees(180))
            .value(),
        {}}});
  ASSERT_EQ(kinds(arcs), (std::vector{sketch::Wrong::Gap, sketch::Wrong::Gap}));
  EXPECT_NE(arcs.findings[0].mend.find("left as it is"), std::string::npos);
}

TEST(Repair, OverlappingOutlinesAreUnitedAndHolesCutOut) {
  const Repaired united =
      mended({polygon("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon("b", {{2, 2}, {6, 2}, {6, 6}, {2, 6}})});
  EXPECT_EQ(kinds(united), (std::vector{sketch::Wrong::Crossing}));
  EXPECT_NEAR(area_of(united), 28.0, 1e-12);
  const Repaired cut = mended({polygon("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}),
                               polygon("hole", {{3, 1}, {5, 1}, {5, 2}, {3, 2}}, sketch::Role::Hole)});
  EXPECT_NEAR(area_of(cut), 15.0, 1e-12);
  const Repaired holes =
      mended({polygon("a", {{0, 0}, {9, 0}, {9, 9}, {0, 9}}), polygon("h", {{1, 1}, {3, 1}, {3, 3}, {1, 3}}),
              polygon("i", {{2, 2}, {4, 2}, {4, 4}, {2, 4}})});
  EXPECT_NEAR(area_of(holes), 81.0 - 7.0, 1e-12);
}

TEST(Repair, ABowTieBecomesTwoLoopsThatTouch) {
  const Repaired repaired = mended({polygon("bow", {{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  ASSERT_EQ(kinds(repaired), (std::vector{sketch::Wrong::Crossing}));
  EXPECT_EQ(repaired.findings[0].at, (Point{1, 1}));
  EXPECT_EQ(repaired.sketch.curves.size(), 2U);
  EXPECT_NEAR(area_of(repaired), 2.0, 1e-12);
}

/// A closed spline round (4, 2), alike on both sides of x = 4.
sketch::Curve blob(sketch::Role role) {
  const std::vector<Point> through{{3, 2}, {4, 1}, {5, 2}, {4, 3}};
  using dobra::geom::SplineEnds;
  auto path =
      dobra::geom::cubic_spline(through, dobra::geom::uniform_knots(4, SplineEnds::Closed), SplineEnds::Closed).value();
  return {"blob", role, sketch::Smooth::make(std::move(path)).value(), {}};
}

TEST(Repair, ArcsAndSplinesThatCrossStayWhatTheyAre) {
  const sketch::Curve square = polygon("a", {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto circle = [](sketch::Role role) {
    return sketch::Curve{"circle", role, Arc::circle({4, 2}, 1.0).value(), {}};
  };
  constexpr double half_disc = 1.5707963267948966;
  constexpr double traced = 3e-4;  // areas are those of chords
  const Repaired united = mended({square, circle(sketch::Role::Boundary)});
  ASSERT_EQ(kinds(united), (std::vector{sketch::Wrong::Crossing}));
  EXPECT_NEAR(area_of(united), 16.0 + half_disc, traced);
  std::size_t arcs = 0;
  for (const sketch::Curve& curve : united.sketch.curves) {
    const auto* arc = std::get_if<Arc>(&curve.shape);
    if (arc == nullptr) continue;
    ++arcs;
    EXPECT_NEAR(arc->length(), 2.0 * half_disc, 1e-9);
  }
  EXPECT_EQ(arcs, 1U);
  EXPECT_NEAR(area_of(mended({square, circle(sketch::Role::Hole)})), 16.0 - half_disc, traced);
  const double half_blob = 0.5 * std::abs(signed_area(trace(blob(sketch::Role::Hole)).line));
  EXPECT_NEAR(area_of(mended({square, blob(sketch::Role::Boundary)})), 16.0 + half_blob, traced);
  EXPECT_NEAR(area_of(mended({square, blob(sketch::Role::Hole)})), 16.0 - half_blob, traced);
}

TEST(Repair, LoopsOfSeveralCurvesThatCrossAreRebuilt) {
  const Repaired repaired = mended({line("low", {{0, 0}, {4, 0}, {4, 4}}),
                                    line("high", {{4, 4}, {0, 4}, {0, 0}}),
                                    {"disc", sketch::Role::Boundary, Arc::circle({0, 2}, 1.0).value(), {}}});
  EXPECT_EQ(kinds(repaired), (std::vector{sketch::Wrong::Crossing}));
  EXPECT_NEAR(area_of(repaired), 16.0 + 1.5707963267948966, 3e-4);
}

TEST(Repair, CurvesWhoseChordsAloneCrossAreNone) {
  // The chords of the inner circle reach over those of the outer one, turned by half a chord, by less than they stand
  // off it.
  using dobra::base::Angle;
  const auto outer = Arc::circle({0, 0}, 1.0).value();
  const auto inner = Arc::from_angles({0, 0}, 0.99998, Angle::from_degrees(0.7), Angle::from_degrees(360)).value();
  const Repaired repaired =
      mended({{"outer", sketch::Role::Boundary, outer, {}}, {"inner", sketch::Role::Hole, inner, {}}});
  EXPECT_TRUE(repaired.findings.empty());
  EXPECT_EQ(repaired.sketch.curves.size(), 2U);
}

TEST(Repair, WhatItCannotMendIsNamedAndLeft) {
  const Repaired repaired =
      mended({polygon("a", {{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}), line("bar", {{-3, 0}, {3, 0}})});
  ASSERT_EQ(kinds(repaired), (std::vector{sketch::Wrong::Crossing}));
  EXPECT_EQ(repaired.findings[0].curve, "a, bar");
  EXPECT_NE(repaired.findings[0].mend.find("left as it is"), std::string::npos);
  EXPECT_EQ(repaired.sketch.curves.size(), 2U);
}

TEST(Repair, ADomainThatVanishesTellsWhatWasRepaired) {
  const std::string thin =
      "[[input.curve]]\nname = \"thin\"\nkind = \"polygon\"\npoints = [[0, 0], [1, 0], [1, 1e-9]]\n";
  const std::string message = test::trouble("[input]\nrepair = \"yes\"\n" + thin);
  EXPECT_NE(message.find("repaired before: "), std::string::npos) << message;
  EXPECT_NE(message.find("of thin: "), std::string::npos) << message;
}

TEST(Repair, WhatRepairLeavesIsNotOfferedToRepair) {
  const std::string open =
      "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n"
      "[[input.curve]]\nname = \"ring\"\nkind = \"line\"\nrole = \"internal\"\npoints = [[1, 1], [3, 1], [3, 3], [1, "
      "3], [1, 1.02]]\n";
  for (const std::string repair : {"no", "yes"}) {
    const auto run = test::run("[input]\nrepair = \"" + repair + "\"\n" + open);
    ASSERT_TRUE(run.complete());
    ASSERT_EQ(test::last(run).findings.size(), 1U);
    const std::string& mend = test::last(run).findings[0].mend;
    EXPECT_EQ(mend.starts_with("not repaired: "), repair == "yes") << mend;
    EXPECT_EQ(mend.find("or give --repair") == std::string::npos, repair == "yes") << mend;
  }
}

TEST(Repair, ACircleDrawnTwiceIsOne) {
  const std::string circle = "kind = \"circle\"\nradius = 1.0\ncentre = [0, 0]\n";
  const auto run = test::run("[input]\nrepair = \"yes\"\n[[input.curve]]\nname = \"one\"\n" + circle +
                             "[[input.curve]]\nname = \"two\"\n" + circle);
  ASSERT_TRUE(run.complete()) << (run.error ? to_string(*run.error) : "");
  EXPECT_EQ(test::last(run).domain.curves.size(), 1U);
  ASSERT_EQ(test::last(run).findings.size(), 1U);
  EXPECT_EQ(test::last(run).findings[0].wrong, sketch::Wrong::CurveTwice);
}

/// The same of lines of a file that tells no roles.
Repaired mended_lines(std::vector<sketch::Curve> curves) {
  sketch::Sketch sketch;
  sketch.places.resize(curves.size());
  for (const sketch::Curve& curve : curves) sketch.without_role.insert(curve.name);
  sketch.curves = std::move(curves);
  return repair(std::move(sketch)).value();
}

TEST(Repair, SidesDrawnPastTheirCornersBoundTheDomain) {
  const std::vector<sketch::Curve> frame{line("s", {{-1, 0}, {5, 0}}), line("e", {{4, -1}, {4, 3}}),
                                         line("n", {{5, 2}, {-1, 2}}), line("w", {{0, 3}, {0, -1}})};
  const Repaired repaired = mended_lines(frame);
  EXPECT_DOUBLE_EQ(area_of(repaired), 8.0);
  EXPECT_EQ(kinds(repaired), std::vector(8, sketch::Wrong::Outside));
  // One line that crosses itself where it was to close, and a frame with a line across it.
  const Repaired lasso = mended_lines({line("l", {{0, -1}, {0, 3}, {3, 3}, {3, 0}, {-1, 0}})});
  EXPECT_DOUBLE_EQ(area_of(lasso), 9.0);
  std::vector<sketch::Curve> divided = frame;
  divided.push_back(line("seam", {{2, -0.5}, {2, 2.5}}));
  EXPECT_DOUBLE_EQ(area_of(mended_lines(divided)), 8.0);
  EXPECT_EQ(domain::make_domain(mended_lines(divided).sketch)->faces.size(), 2U);
}

TEST(Repair, StrayLinesAndDanglingEdgesOutsideAreLeftOutAndTold) {
  const sketch::Curve plate = polygon("plate", {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const sketch::Curve hole = polygon("hole", {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  struct Case {
    std::vector<Point> stray;
    double left;  ///< Length of what stays.
  };
  // Outside, in the hole, across the rim, from a corner outwards, right through plate and hole; inside.
  for (const auto& [stray, left] : std::vector<Case>{{{{5, 0}, {6, 1}}, 0.0},
                                                     {{{1.2, 1.2}, {1.8, 1.8}}, 0.0},
                                                     {{{3, 3}, {3, 6}}, 1.0},
                                                     {{{4, 4}, {5, 5}}, 0.0},
                                                     {{{-1, 1.5}, {5, 1.5}}, 3.0},
                                                     {{{3, 1}, {3, 3}}, 2.0}}) {
    const Repaired repaired = mended_lines({plate, hole, line("stray", stray)});
    double kept = 0.0;
    for (const sketch::Curve& curve : repaired.sketch.curves)
      kept += curve.name.starts_with("stray") ? length(curve) : 0.0;
    EXPECT_NEAR(kept, left, 1e-12);
    EXPECT_DOUBLE_EQ(area_of(repaired), 15.0);
    const bool touched = left != 2.0;
    EXPECT_EQ(kinds(repaired), touched ? std::vector{sketch::Wrong::Outside} : std::vector<sketch::Wrong>{});
    if (touched) {
      EXPECT_EQ(repaired.findings[0].curve, "stray");
    }
  }
  // What the user calls internal is meant.
  sketch::Curve meant = line("meant", {{3, 3}, {3, 6}});
  meant.role = sketch::Role::Internal;
  const Repaired as_it_is = mended({plate, meant});
  EXPECT_TRUE(as_it_is.findings.empty());
  EXPECT_FALSE(domain::make_domain(as_it_is.sketch).ok());
}

TEST(Repair, IdenticalCurvesAreCalledIdenticalAndOtherOnesAreNot) {
  const sketch::Curve plate = polygon("plate", {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const auto circle = [](const std::string& name, double radius, dobra::geom::Orientation way) {
    return sketch::Curve{name, sketch::Role::Boundary, Arc::circle({2, 2}, radius, way).value(), {}};
  };
  using dobra::geom::Orientation;
  const std::vector<std::vector<sketch::Curve>> doubles{
      {plate, polygon("again", {{0, 4}, {4, 4}, {4, 0}, {0, 0}})},
      {plate, circle("c", 1.0, Orientation::Anticlockwise), circle("d", 1.0, Orientation::Clockwise)},
      {line("a", {{0, 0}, {4, 0}}), line("b", {{4, 0}, {4, 4}, {0, 0}}), line("c", {{4, 0}, {0, 0}})},
      {plate, line("seam", {{1, 0}, {1, 4}}), line("twin", {{1, 4}, {1, 0}})}};
  for (const auto& curves : doubles) {
    sketch::Sketch sketch;
    sketch.places.resize(curves.size());
    sketch.curves = curves;
    if (curves.back().name == "twin") sketch.curves[1].role = sketch.curves[2].role = sketch::Role::Internal;
    const auto domain = domain::make_domain(sketch);
    ASSERT_FALSE(domain.ok());
    EXPECT_NE(domain.error().message.find("are identical"), std::string::npos) << domain.error().message;
    EXPECT_EQ(kinds(repair(sketch).value()), std::vector{sketch::Wrong::CurveTwice});
  }
  // The same points in another order are another curve.
  EXPECT_NE(shape_key(plate), shape_key(polygon("bow", {{0, 0}, {4, 4}, {4, 0}, {0, 4}})));
  const auto half = [](double start) {
    return sketch::Curve{
        "h",
        sketch::Role::Boundary,
        Arc::from_angles({0, 0}, 1.0, dobra::base::Angle::from_degrees(start), dobra::base::Angle::from_degrees(180))
            .value(),
        {}};
  };
  EXPECT_NE(shape_key(half(0)), shape_key(half(180)));
}

}  // namespace
}  // namespace quebra::repair
