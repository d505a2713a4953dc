// Outlines that stay open, and loops that reach across an outline, in files that tell no roles.

#include "quebra/domain/open_outline.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/drawn_file.h"

namespace quebra::domain {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using std::numbers::pi;
using test::area_of;

class OpenOutline : public test::DrawnFile {
 protected:
  /// A file of that name is read, by default with repair.
  [[nodiscard]] std::string use(const std::string& name, const std::string& text,
                                const std::string& more = "repair = \"yes\"\n") const {
    write(name, text);
    return "file = \"" + name + "\"\n" + more;
  }
};

/// A plate of 100 x 80 whose left side stops `gap` before the corner at (0, 0).
std::string gaping_plate(double gap) {
  return test::dxf_line(0, 0, 100, 0) + test::dxf_line(100, 80, 100, 0) + test::dxf_line(100, 80, 0, 80) +
         test::dxf_line(0, 80, 0, gap);
}
std::string circle(double x, double y, double radius) {
  return "0\nCIRCLE\n8\nhole\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n40\n" +
         std::to_string(radius) + "\n";
}
std::string square_between(double low, double high) {
  return test::dxf_line(low, low, high, low) + test::dxf_line(high, low, high, high) +
         test::dxf_line(high, high, low, high) + test::dxf_line(low, high, low, low);
}

TEST_F(OpenOutline, IsNeverReplacedByAHole) {
  const std::string drawing = test::dxf(gaping_plate(0.4) + circle(40, 40, 10));
  // The diagonal is 128.06.
  EXPECT_THAT(
      refusal(use("gap.dxf", drawing)),
      AllOf(HasSubstr("an outline stays open"), HasSubstr("a gap of 0.4 m between (0, 0)"), HasSubstr("and (0, 0.4)"),
            HasSubstr("closes gaps up to 0.128 m"), HasSubstr("--gap (gap in [input]) of 0.4")));
  EXPECT_THAT(refusal(use("gap.dxf", drawing, "")),
              AllOf(HasSubstr("a gap of 0.4 m between (0, 0)"), HasSubstr("give --repair"), HasSubstr("--gap")));
  EXPECT_NEAR(area_of(good(use("gap.dxf", drawing, "repair = \"yes\"\ngap = 0.41\n"))), 8000.0 - 100.0 * pi, 0.1);
}

TEST_F(OpenOutline, InTwoPartsIsToldByItsWidestGap) {
  const std::string two = test::dxf_line(0, 0.3, 0, 80) + test::dxf_line(0, 80, 100, 80) +
                          test::dxf_line(100, 79.5, 100, 0) + test::dxf_line(100, 0, 0, 0);
  EXPECT_THAT(refusal(use("two.dxf", test::dxf(two + square_between(20, 40)))),
              AllOf(HasSubstr("a gap of 0.5 m"), HasSubstr("(100, 80)"), HasSubstr("(100, 79.5)"),
                    HasSubstr("the widest of 2")));
  EXPECT_NEAR(area_of(good(use("two.dxf", test::dxf(two + square_between(20, 40)), "repair = \"yes\"\ngap = 0.5\n"))),
              7600.0, 25.5);
}

TEST_F(OpenOutline, ThatLacksAWholeSideIsOneToo) {
  const std::string open = R"({"type":"FeatureCollection","features":[
    {"type":"Feature","geometry":{"type":"LineString","coordinates":[[0,80],[0,0],[100,0],[100,80]]}},
    {"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[20,20],[40,20],[40,40],[20,40],[20,20]]]}}]})";
  EXPECT_THAT(refusal(use("side.geojson", open)),
              AllOf(HasSubstr("a gap of 100 m between (0, 80)"), HasSubstr("(100, 80)"), HasSubstr("close it by hand"),
                    Not(HasSubstr("--gap"))));
}

TEST_F(OpenOutline, OfAnArcThatCannotMoveIsRefusedWithItsHole) {
  const std::string half_disc = "0\nARC\n8\n0\n10\n0\n20\n0\n40\n10\n50\n0\n51\n180\n" + test::dxf_line(-10, 0, 9.7, 0);
  EXPECT_THAT(refusal(use("arc.dxf", test::dxf(half_disc + circle(0, 4, 1)))),
              AllOf(HasSubstr("a gap of 0.3 m"), HasSubstr("(10, 0)"), HasSubstr("(9.7, 0)")));
}

TEST_F(OpenOutline, OfASecondPartIsNoStrayLine) {
  const std::string second = test::dxf_line(200, 0, 300, 0) + test::dxf_line(300, 0, 300, 80) +
                             test::dxf_line(300, 80, 200, 80) + test::dxf_line(200, 80, 200, 2);
  EXPECT_THAT(refusal(use("parts.dxf", test::dxf(gaping_plate(0) + second))),
              AllOf(HasSubstr("a gap of 2 m between (200, 0)"), HasSubstr("(200, 2)")));
}

TEST_F(OpenOutline, IsNoneWhereALineIsPlainlyStray) {
  const std::string bent =
      test::dxf_line(120, 0, 150, 0) + test::dxf_line(150, 0, 150, 40) + test::dxf_line(150, 40, 130, 70);
  const model::Model model = good(use("stray.dxf", test::dxf(gaping_plate(0) + bent)));
  EXPECT_NEAR(area_of(model), 8000.0, 1e-6);
  EXPECT_THAT(model.remarks, Contains(HasSubstr("line outside")));
  EXPECT_EQ(good(use("whole.dxf", test::dxf(gaping_plate(0) + circle(40, 40, 10)))).findings.size(), 0U);
}

TEST_F(OpenOutline, GapsAreToldWithBothEndsAndTheLimit) {
  EXPECT_THAT(good(use("closed.dxf", test::dxf(gaping_plate(0.1)))).remarks,
              Contains(AllOf(HasSubstr("a gap of 0.1 m between (0, 0)"), HasSubstr("(0, 0.1)"),
                             HasSubstr("gaps up to 0.128 m are closed"))));
  EXPECT_THAT(refusal(use("none.dxf", test::dxf(gaping_plate(0.1)), "")),
              AllOf(HasSubstr("a gap of 0.1 m between (0, 0)"), HasSubstr("(0, 0.1)"), HasSubstr("up to 0.128 m")));
  EXPECT_THAT(refusal(use("wide.dxf", test::dxf(gaping_plate(0.4)))),
              AllOf(HasSubstr("no curve closes"), HasSubstr("a gap of 0.4 m between (0, 0)"), HasSubstr("0.128 m"),
                    Not(HasSubstr("or give --repair"))));
}

TEST_F(OpenOutline, TheLimitOfGapsIsOfRepairAndOfTheDrawing) {
  EXPECT_THAT(refusal(use("a.dxf", test::dxf(gaping_plate(0.4)), "gap = 1.0\n")), HasSubstr("give --repair"));
  EXPECT_THAT(refusal(use("a.dxf", test::dxf(gaping_plate(0.4)), "repair = \"yes\"\ngap = 13.0\n")),
              AllOf(HasSubstr("`gap` is 13 m"), HasSubstr("12.8062 m")));
}

// --- loops across an outline
// ----------------------------------------------------------------------------------------------

TEST_F(OpenOutline, ACircleAcrossTheEdgeBitesANotch) {
  struct Case {
    double x, y, bitten;
  };
  // Nearly inside (a segment of the circle stays out), on the edge, on the corner.
  const double r = 10.0, d = 4.0, segment = r * r * std::acos(d / r) - d * std::sqrt(r * r - d * d);
  for (const auto& [x, y, bitten] :
       {Case{96, 40, pi * r * r - segment}, Case{100, 40, 0.5 * pi * r * r}, Case{100, 80, 0.25 * pi * r * r}}) {
    const model::Model model = good(use("notch.dxf", test::dxf(gaping_plate(0) + circle(x, y, r))));
    EXPECT_NEAR(area_of(model), 8000.0 - bitten, 2e-3 * bitten) << x;
    EXPECT_THAT(model.remarks, Contains(AllOf(HasSubstr("for a hole across it and cut out"),
                                              HasSubstr("the area was 8000 m2 and is 7"))));
  }
}

TEST_F(OpenOutline, ASquareAcrossTheEdgeOfASvgBitesANotch) {
  const model::Model model = good(use(
      "notch.svg",
      R"(<svg xmlns="http://www.w3.org/2000/svg"><polygon id="plate" points="0,0 100,0 100,80 0,80"/><rect id="hole" x="90" y="20" width="20" height="20"/></svg>)"));
  EXPECT_NEAR(area_of(model), 8000.0 - 200.0, 1e-9);
  EXPECT_THAT(model.remarks,
              Contains(AllOf(HasSubstr("'hole' (400 m2, 200 m2 of it inside)"), HasSubstr("is 7800 m2"))));
}

TEST_F(OpenOutline, TwoNotchesAndTwoHolesThatOverlapAreCutOutOnce) {
  const std::string drawing =
      test::dxf(square_between(0, 100) + square_between(95, 103) + test::dxf_line(40, 96, 50, 96) +
                test::dxf_line(50, 96, 50, 103) + test::dxf_line(50, 103, 40, 103) + test::dxf_line(40, 103, 40, 96));
  EXPECT_NEAR(area_of(good(use("two.dxf", drawing))), 10000.0 - 25.0 - 40.0, 1e-9);
}

TEST_F(OpenOutline, WhatLooksLikeMaterialIsUnitedAndTheAreaTold) {
  // A lug: a disc on the edge with a bore. A plate beside a plate of the same size. A boss that lies mostly outside.
  const model::Model lug = good(use("lug.dxf", test::dxf(gaping_plate(0) + circle(100, 40, 20) + circle(105, 40, 5))));
  EXPECT_NEAR(area_of(lug), 8000.0 + 200.0 * pi - 25.0 * pi, 1.0);
  const model::Model two = good(use("two.dxf", test::dxf(square_between(0, 10) + square_between(6, 16))));
  EXPECT_NEAR(area_of(two), 200.0 - 16.0, 1e-9);
  EXPECT_THAT(two.remarks, Contains(AllOf(HasSubstr("taken for outlines and united"), HasSubstr("the area was 100 m2"),
                                          HasSubstr("is 184 m2"))));
  const model::Model boss = good(use("boss.dxf", test::dxf(square_between(0, 100) + square_between(98, 108))));
  EXPECT_NEAR(area_of(boss), 10000.0 + 100.0 - 4.0, 1e-9);
}

TEST_F(OpenOutline, HolePointsSayWhatALoopAcrossTheEdgeOfAPolyIs) {
  const std::string points =
      "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 3 1\n6 6 1\n7 6 2\n8 3 2\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 "
      "7\n7 7 8\n8 8 5\n";
  EXPECT_NEAR(area_of(good(use("hole.poly", points + "1\n1 3.5 1.5\n"))), 15.0, 1e-12);
  EXPECT_NEAR(area_of(good(use("boss.poly", points + "0\n"))), 18.0, 1e-12);
}

}  // namespace
}  // namespace quebra::domain
