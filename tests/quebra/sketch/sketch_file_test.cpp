// Files of geometry as users draw them: what becomes of gaps, neighbours, units and outlines that do not close.

#include "quebra/sketch/sketch_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "quebra/core/operations.h"
#include "quebra/sketch/specimen.h"
#include "tests/support/corpus.h"
#include "tests/support/drawn_file.h"

namespace quebra::sketch {
namespace {

using namespace dobra;
using namespace test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<std::string> names_of(const model::Model& model, Role role) {
  std::vector<std::string> names;
  for (const Curve& curve : model.domain.curves) {
    if (curve.role == role) names.push_back(curve.name);
  }
  return names;
}

std::string dxf_square(double low, double high, double gap, const std::string& layer) {
  return dxf_line(low, low, high, low, layer) + dxf_line(high, low + gap, high, high, layer) +
         dxf_line(high, high, low, high, layer) + dxf_line(low, high, low, low, layer);
}

const std::string square_csv = "0,0\n1,0\n1,1\n0,1\n";

// --- gaps
// -----------------------------------------------------------------------------------------------------------------

TEST_F(DrawnFile, EndsThatDifferByRoundingCloseAHole) {
  write("hole.dxf", dxf(dxf_square(0, 100, 0, "plate") + dxf_square(40, 60, 1e-9, "hole")));
  const model::Model model = good("file = \"hole.dxf\"\n");
  EXPECT_NEAR(area_of(model), 9600.0, 1e-6);
  EXPECT_THAT(names_of(model, Role::Internal), IsEmpty());
  EXPECT_THAT(model.findings, IsEmpty());
  EXPECT_NEAR(area_of(good("file = \"hole.dxf\"\nrepair = \"yes\"\n")), 9600.0, 1e-6);
}

TEST_F(DrawnFile, AGapThatIsNoRoundingIsNamedWithItsPlaceAndRepaired) {
  write("hole.dxf", dxf(dxf_square(0, 100, 0, "plate") + dxf_square(40, 60, 0.01, "hole")));
  const model::Model model = good("file = \"hole.dxf\"\n");
  EXPECT_NEAR(area_of(model), 10000.0, 1e-6);
  EXPECT_THAT(model.remarks, Contains(testing::AllOf(HasSubstr("gap at (60, 40"), HasSubstr("hole, hole 2"),
                                                     HasSubstr("0.01 m"), HasSubstr("--repair"))));
  const model::Model mended = good("file = \"hole.dxf\"\nrepair = \"yes\"\n");
  EXPECT_NEAR(area_of(mended), 9600.0, 1.0);
  EXPECT_THAT(names_of(mended, Role::Internal), IsEmpty());
}

TEST_F(DrawnFile, AnArcWhoseEndsAreRoundedJoinsItsLines) {
  write("arc.dxf", dxf(dxf_line(10, 0, 50, 0) + dxf_line(50, 0, 50, 50) + dxf_line(50, 50, 0, 50) +
                       dxf_line(0, 50, 0, 10) + "0\nARC\n8\n0\n10\n0\n20\n0\n40\n10\n50\n0\n51\n90\n"));
  EXPECT_NEAR(area_of(good("file = \"arc.dxf\"\n")), 2500.0 - 25.0 * std::numbers::pi, 0.05);
}

TEST_F(DrawnFile, AnOutlineThatDoesNotCloseIsRefusedWithThePlaceOrMended) {
  write("gap.geojson", R"({"type":"LineString","coordinates":[[0,0],[1,0],[1,1],[0,1],[0,0.001]]})");
  const std::string text = refusal("file = \"gap.geojson\"\n");
  EXPECT_THAT(text, HasSubstr("a gap of 0.001 m between (0, 0) of 'curve 1' and (0, 0.001) of 'curve 1'"));
  EXPECT_THAT(text, HasSubstr("--repair"));
  EXPECT_NEAR(area_of(good("file = \"gap.geojson\"\nrepair = \"yes\"\n")), 1.0, 1e-12);
}

TEST_F(DrawnFile, ALineThatDividesTheDomainStaysInternalUnderRepair) {
  write("two.dxf", dxf(dxf_line(0, 0, 2, 0) + dxf_line(2, 0, 4, 0) + dxf_line(4, 0, 4, 2) + dxf_line(4, 2, 2, 2) +
                       dxf_line(2, 2, 0, 2) + dxf_line(0, 2, 0, 0) + dxf_line(2, 0, 2, 2, "seam")));
  for (const char* repair : {"no", "yes"}) {
    const model::Model model = good(std::string("file = \"two.dxf\"\nrepair = \"") + repair + "\"\n");
    EXPECT_THAT(names_of(model, Role::Internal), ElementsAre("seam")) << repair;
    EXPECT_EQ(model.domain.faces.size(), 2U) << repair;
    EXPECT_THAT(model.findings, IsEmpty()) << repair;
  }
}

// --- arcs of drawings
// ------------------------------------------------------------------------------------------------------

TEST_F(DrawnFile, ArcsOfADrawingStayArcs) {
  const std::string circle = "0\nCIRCLE\n8\nhole\n10\n50\n20\n50\n40\n20\n";
  write("plate.dxf",
        dxf(dxf_square(0, 100, 0, "plate") + circle, "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"));
  const model::Model model = good("file = \"plate.dxf\"\nunit = \"mm\"\n");
  const auto* arc = std::get_if<geom::Arc>(&model.domain.curves.back().shape);
  ASSERT_NE(arc, nullptr);
  EXPECT_NEAR(arc->radius(), 0.02, 1e-15);
  EXPECT_THAT(model.remarks, testing::Each(testing::Not(HasSubstr("chords"))));
  const model::Model meshed =
      good("file = \"plate.dxf\"\nunit = \"mm\"\n[[step]]\noperation = \"mesh\"\nsize = 0.02\norder = \"2\"\n");
  EXPECT_NEAR(mesh::area(meshed.meshes[0]->mesh), 0.01 - std::numbers::pi * 0.0004, 1e-7);
  EXPECT_LT(meshed.meshes[0]->mesh.element_count(), 300U);
}

TEST_F(DrawnFile, BulgesAndMirroredArcsAreTrueArcs) {
  // A slot: two straight sides and two half circles, and the same seen from below, where x runs to the left.
  const std::string vertices = "90\n4\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n42\n1\n10\n4\n20\n2\n10\n0\n20\n2\n42\n1\n";
  for (const char* plane : {"", "210\n0\n220\n0\n230\n-1\n"}) {
    write("slot.dxf", dxf("0\nLWPOLYLINE\n8\nslot\n" + vertices + plane));
    const model::Model model = good("file = \"slot.dxf\"\n[[step]]\noperation = \"mesh\"\nsize = 0.2\norder = \"2\"\n");
    EXPECT_NEAR(mesh::area(model.meshes.at(0)->mesh), 8.0 + std::numbers::pi, 1e-4) << plane;
    const double middle = 0.5 * (model.domain.box().low.x + model.domain.box().high.x);
    EXPECT_NEAR(middle, *plane == 0 ? 2.0 : -2.0, 1e-9);
  }
}

TEST_F(DrawnFile, AnEllipseIsFollowedByCubics) {
  write("ellipse.dxf",
        dxf("0\nELLIPSE\n8\n0\n10\n1\n20\n2\n30\n0\n11\n3\n21\n0\n31\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n"));
  const model::Model model =
      good("file = \"ellipse.dxf\"\n[[step]]\noperation = \"mesh\"\nsize = 0.2\norder = \"2\"\n");
  EXPECT_NEAR(mesh::area(model.meshes.at(0)->mesh), std::numbers::pi * 4.5, 1e-4);
}

/// The B-spline of the cubic polynomial through knots: x = t, and y = t (4 - t) / 2 at t of 0 to 4, by its blossom.
std::string dxf_spline(std::size_t degree, const std::vector<double>& knots, const std::string& weights = "") {
  std::string text = "0\nSPLINE\n8\narch\n210\n0\n220\n0\n230\n1\n70\n8\n71\n" + std::to_string(degree) + "\n";
  for (const double knot : knots) text += "40\n" + std::to_string(knot) + "\n";
  text += weights;
  for (std::size_t i = 1; i + degree < knots.size(); ++i) {
    double sum = 0.0, products = 0.0;
    for (std::size_t j = i; j < i + degree; ++j) {
      sum += knots[j];
      for (std::size_t k = j + 1; k < i + degree; ++k) products += knots[j] * knots[k];
    }
    const double n = static_cast<double>(degree);
    char point[96];
    std::snprintf(point, sizeof point, "10\n%.17g\n20\n%.17g\n30\n0\n", sum / n,
                  2.0 * sum / n - products / (n * (n - 1.0)));
    text += point;
  }
  return text;
}

TEST_F(DrawnFile, SplinesOfADrawingStaySplines) {
  for (const std::size_t degree : {2U, 3U}) {
    std::vector<double> knots(degree + 1, 0.0);
    knots.insert(knots.end(), {1.0, 2.5, 3.0});
    knots.insert(knots.end(), degree + 1, 4.0);
    write("arch.dxf", dxf(dxf_spline(degree, knots) + dxf_line(4, 0, 0, 0)));
    const model::Model model =
        good("file = \"arch.dxf\"\n[[step]]\noperation = \"mesh\"\nsize = 0.25\norder = \"2\"\n");
    ASSERT_EQ(model.domain.curves.size(), 2U) << "one curve over all knots";
    const auto* smooth = std::get_if<Smooth>(&model.domain.curves[0].shape);
    ASSERT_NE(smooth, nullptr);
    for (const double s : {0.3, 1.9, 3.3, 4.8}) {
      const geom::Point p = smooth->point(s);
      EXPECT_NEAR(p.y, 0.5 * p.x * (4.0 - p.x), 1e-12) << degree;
    }
    EXPECT_NEAR(mesh::area(model.meshes.at(0)->mesh), 16.0 / 3.0, 1e-4);
    EXPECT_THAT(model.remarks, testing::Each(testing::Not(HasSubstr("chords"))));
  }
}

TEST_F(DrawnFile, ASplineThatIsNoCubicIsReadAsChordsAndSaysSo) {
  const std::vector<double> knots{0, 0, 0, 0, 4, 4, 4, 4};
  const std::string weights = "41\n1\n41\n2\n41\n2\n41\n1\n";
  write("arch.dxf", dxf(dxf_spline(3, knots, weights) + dxf_line(4, 0, 0, 0)));
  EXPECT_THAT(good("file = \"arch.dxf\"\n").remarks, testing::Contains(HasSubstr("arcs or splines read as chords")));
}

// --- .poly
// ----------------------------------------------------------------------------------------------------------------

TEST_F(DrawnFile, RepairRunsBeforeTheHolesOfAPolyAreLookedAt) {
  write("bow.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  EXPECT_THAT(refusal("file = \"bow.poly\"\n"), HasSubstr("crosses"));
  EXPECT_NEAR(area_of(good("file = \"bow.poly\"\nrepair = \"yes\"\n")), 0.5, 1e-12);
  write("dup.poly",
        "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 1 1\n5 0 1\n6 0.0000000001 0\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 "
        "1\n0\n");
  const model::Model dup = good("file = \"dup.poly\"\nrepair = \"yes\"\n");
  EXPECT_NEAR(area_of(dup), 1.0, 1e-9);
  EXPECT_EQ(dup.findings.size(), 2U);
}

TEST_F(DrawnFile, HolesOfAPolyAreHolesAfterRepairToo) {
  write("hole.poly",
        "8 2 0 0\n1 0 0\n2 4 0\n3 4 4\n4 0 4\n5 1 1\n6 2 1\n7 2 2\n8 1 2\n8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 "
        "7\n7 7 8\n8 8 5\n1\n1 1.5 1.5\n");
  for (const char* repair : {"no", "yes"})
    EXPECT_NEAR(area_of(good(std::string("file = \"hole.poly\"\nrepair = \"") + repair + "\"\n")), 15.0, 1e-12);
}

// --- slivers
// --------------------------------------------------------------------------------------------------------------

const std::string sliver =
    "[[input.curve]]\nname = \"p\"\nkind = \"polygon\"\npoints = [[0, 0], [1, 0], [1, 1], [0, 1]]\n"
    "[[input.curve]]\nname = \"h\"\nkind = \"polygon\"\n";

TEST_F(DrawnFile, ASliverBetweenTwoLoopsIsNamedWithItsPlace) {
  const model::Model model = good(sliver + "points = [[0.2, 1e-5], [0.8, 1e-5], [0.8, 0.5], [0.2, 0.5]]\n");
  ASSERT_EQ(model.findings.size(), 1U);
  EXPECT_EQ(model.findings[0].wrong, Wrong::Sliver);
  EXPECT_EQ(model.findings[0].curve, "p, h");
  EXPECT_NEAR(model.findings[0].at.y, 0.0, 1.1e-5);
  EXPECT_THAT(model.remarks, Contains(HasSubstr("come within 1e-05 m")));
}

TEST_F(DrawnFile, ASliverThatNothingFitsIntoIsMendedByRepair) {
  const std::string hole = "points = [[0.2, 1e-7], [0.8, 1e-7], [0.8, 0.5], [0.2, 0.5]]\n";
  EXPECT_THAT(good(sliver + hole).remarks, Contains(HasSubstr("sliver at (")));
  const model::Model mended = good("repair = \"yes\"\n" + sliver + hole);
  EXPECT_NEAR(area_of(mended), 1.0 - 0.6 * 0.5, 1e-6);
  ASSERT_FALSE(mended.findings.empty());
  EXPECT_EQ(mended.findings[0].wrong, Wrong::Sliver);
  for (const Finding& finding : mended.findings)
    EXPECT_EQ(finding.mend.find("left as it is"), std::string::npos) << finding.mend;
}

TEST_F(DrawnFile, ACircleThatNearlyTouchesTheEdgeIsASliverByItsTrueDistance) {
  const std::string plate =
      "[[input.curve]]\nname = \"p\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, "
      "4]]\n[[input.curve]]\nname = \"c\"\nkind = \"circle\"\n";
  const model::Model near = good(plate + "centre = [2, 1.000001]\nradius = 1\n");
  ASSERT_EQ(near.findings.size(), 1U);
  EXPECT_THAT(near.findings[0].mend, HasSubstr("come within 1e-06 m"));
  EXPECT_THAT(good(plate + "centre = [2, 1.01]\nradius = 1\n").findings, IsEmpty());
}

TEST_F(DrawnFile, GoodDrawingsHaveNoFlaws) {
  for (const std::string& specimen : specimen_names()) {
    if (specimen == "none") continue;
    EXPECT_THAT(good("specimen = \"" + specimen + "\"\n").findings, IsEmpty()) << specimen;
  }
}

// --- neighbours
// -----------------------------------------------------------------------------------------------------------

std::string polygon(const std::string& name, const std::string& rings) {
  return R"({"type":"Feature","properties":{"name":")" + name + R"("},"geometry":{"type":"Polygon","coordinates":[)" +
         rings + "]}}";
}
std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

TEST_F(DrawnFile, PolygonsThatShareASideAreRegionsWithAnInterface) {
  write("touch.geojson", collection(polygon("a", "[[0,0],[2,0],[2,2],[0,2],[0,0]]") + "," +
                                    polygon("b", "[[2,0],[4,0],[4,2],[2,2],[2,0]]")));
  for (const char* repair : {"no", "yes"}) {
    const model::Model model = good(std::string("file = \"touch.geojson\"\nrepair = \"") + repair + "\"\n");
    EXPECT_NEAR(area_of(model), 8.0, 1e-12);
    ASSERT_EQ(model.domain.faces.size(), 2U);
    EXPECT_EQ(model.domain.region_names, (std::map<std::int32_t, std::string>{{1, "a"}, {2, "b"}}));
    for (const domain::Face& face : model.domain.faces)
      EXPECT_EQ(model.domain.region_names.at(face.region), face.inside.x < 2 ? "a" : "b");
    EXPECT_THAT(names_of(model, Role::Boundary), UnorderedElementsAre("a", "b"));
    EXPECT_THAT(names_of(model, Role::Internal), ElementsAre("a_b"));
  }
}

TEST_F(DrawnFile, NeighboursMayMeetInTheMiddleOfASideAndFillHoles) {
  // a has c beside it along half a side (whose ends are off by rounding), and d fills the hole of a.
  write("map.geojson", collection(polygon("a", "[[0,0],[3,0],[3,3],[0,3],[0,0]],[[1,1],[1,2],[2,2],[2,1],[1,1]]") +
                                  "," + polygon("c", "[[3.0000000001,1],[4,1],[4,2],[3,2],[3.0000000001,1]]") + "," +
                                  polygon("d", "[[1,1],[2,1],[2,2],[1,2],[1,1]]")));
  const model::Model model = good("file = \"map.geojson\"\n");
  EXPECT_NEAR(area_of(model), 10.0, 1e-9);
  EXPECT_EQ(model.domain.faces.size(), 3U);
  EXPECT_THAT(names_of(model, Role::Internal), UnorderedElementsAre("a_c", "a_d"));
  EXPECT_EQ(model.domain.region_names.size(), 3U);
}

TEST_F(DrawnFile, ShapesOfASvgThatShareASideAreRegions) {
  write(
      "adj.svg",
      R"(<svg xmlns="http://www.w3.org/2000/svg"><rect id="a" x="0" y="0" width="2" height="2"/><rect id="b" x="2" y="0" width="2" height="2"/></svg>)");
  const model::Model model = good("file = \"adj.svg\"\n");
  EXPECT_THAT(names_of(model, Role::Internal), ElementsAre("a_b"));
  EXPECT_EQ(model.domain.region_names.size(), 2U);
}

TEST_F(DrawnFile, PolygonsThatOverlapAreStillRefused) {
  write("over.geojson", collection(polygon("a", "[[0,0],[2,0],[2,2],[0,2],[0,0]]") + "," +
                                   polygon("b", "[[1,0],[4,0],[4,2],[1,2],[1,0]]")));
  EXPECT_THAT(refusal("file = \"over.geojson\"\n"), HasSubstr("'a' and 'b' cross or overlap"));
}

// --- outlines in pieces, loops apart ---

TEST_F(DrawnFile, LinesOfAPictureThatCloseAnOutlineBoundTheDomain) {
  const auto svg = [](const std::string& elements) { return "<svg>" + elements + "</svg>"; };
  write("lines.svg", svg("<line x1=\"0\" y1=\"0\" x2=\"2\" y2=\"0\"/><line x1=\"2\" y1=\"0\" x2=\"2\" y2=\"1\"/><line "
                         "x1=\"2\" y1=\"1\" x2=\"0\" y2=\"1\"/><line x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\"/>"));
  EXPECT_NEAR(area_of(good("file = \"lines.svg\"\n")), 2.0, 1e-12);
  write("half.svg", svg("<path d=\"M 1 0 A 1 1 0 0 1 -1 0\"/><path d=\"M -1 0 L 1 0\"/>"));
  EXPECT_NEAR(area_of(good("file = \"half.svg\"\n")), 0.5 * std::numbers::pi, 2e-3);
  // A hole in pieces, and a line that ends inside.
  write("hole.svg", svg("<rect x=\"0\" y=\"0\" width=\"4\" height=\"4\"/><polyline points=\"1,1 2,1 2,2\"/><polyline "
                        "points=\"2,2 1,2 1,1\"/><line id=\"slit\" x1=\"3\" y1=\"0\" x2=\"3\" y2=\"2\"/>"));
  const model::Model model = good("file = \"hole.svg\"\n");
  EXPECT_NEAR(area_of(model), 15.0, 1e-12);
  EXPECT_THAT(names_of(model, Role::Internal), ElementsAre("slit"));
  write("open.svg", svg("<polyline points=\"0,0 1,0 1,1\"/>"));
  EXPECT_THAT(refusal("file = \"open.svg\"\n"), HasSubstr("no curve closes"));
}

TEST_F(DrawnFile, ALoopOutsideThePlateIsTold) {
  const std::string plate = dxf_square(0, 100, 0, "plate");
  const auto circle = [](const std::string& layer, double x, double radius) {
    return "0\nCIRCLE\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n50\n40\n" + std::to_string(radius) + "\n";
  };
  write("outside.dxf", dxf(plate + circle("hole", 150, 20)));
  const model::Model model = good("file = \"outside.dxf\"\n");
  EXPECT_THAT(model.remarks, Contains(testing::AllOf(HasSubstr("loop outside"), HasSubstr("of hole: "),
                                                     HasSubstr("outside 'plate"), HasSubstr("no hole"))));
  write("two.dxf", dxf(plate + circle("a", 150, 20) + circle("b", 250, 10) + circle("in", 50, 10)));
  EXPECT_THAT(good("file = \"two.dxf\"\n").remarks,
              Contains(testing::AllOf(HasSubstr("a, b: "), testing::Not(HasSubstr("in,")))));
  write("inside.dxf", dxf(plate + circle("hole", 50, 20)));
  EXPECT_THAT(good("file = \"inside.dxf\"\n").remarks, testing::Each(testing::Not(HasSubstr("loop outside"))));
}

// --- units and outlines
// ---------------------------------------------------------------------------------------------------

TEST_F(DrawnFile, ADrawingInMillimetresIsScaledAndToldAndTheOptionGoesBeforeIt) {
  write("mm.dxf", dxf(dxf_square(0, 100, 0, "plate"), "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"));
  const model::Model taken = good("file = \"mm.dxf\"\n");
  EXPECT_NEAR(area_of(taken), 0.01, 1e-15);
  EXPECT_THAT(taken.remarks, Contains(HasSubstr("its unit is 0.001 m, as the file says")));
  EXPECT_NEAR(area_of(good("file = \"mm.dxf\"\nunit = \"mm\"\n")), 0.01, 1e-15);
  EXPECT_NEAR(area_of(good("file = \"mm.dxf\"\nunit = \"in\"\n")), 100 * 100 * 0.0254 * 0.0254, 1e-9);
}

TEST_F(DrawnFile, AThirdColumnIsAskedAbout) {
  write("three.csv", "0,0,5\n1,0,5\n1,1,6\n0,1,6\n0,0,5\n");
  EXPECT_THAT(refusal("file = \"three.csv\"\n"), HasSubstr("--columns"));
  EXPECT_NEAR(area_of(good("file = \"three.csv\"\ncolumns = \"1,2\"\n")), 1.0, 1e-12);
  EXPECT_THAT(refusal("file = \"three.csv\"\nformat = \"cad\"\n"), HasSubstr("dxf"));
}

TEST_F(DrawnFile, AnOpenContourIsClosedWhereThatIsAsked) {
  write("square.csv", square_csv);
  EXPECT_THAT(refusal("file = \"square.csv\"\n"), HasSubstr("--closed"));
  EXPECT_NEAR(area_of(good("file = \"square.csv\"\nclosed = \"yes\"\n")), 1.0, 1e-12);
  write("square.poly", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
  EXPECT_THAT(refusal("file = \"square.poly\"\nclosed = \"yes\"\n"), HasSubstr("leave these options out"));
}

TEST_F(DrawnFile, TextsWithHolesAndWithCountsAreRead) {
  write("holes.dat", "0 0\n4 0\n4 4\n0 4\nHOLE\n1 1\n2 1\n2 2\n1 2\n");
  EXPECT_NEAR(area_of(good("file = \"holes.dat\"\nclosed = \"yes\"\n")), 15.0, 1e-12);
  write("graph.txt", "4 4\n0 0\n3 0\n3 3\n0 3\n0 1\n1 2\n2 3\n3 0\n");
  EXPECT_NEAR(area_of(good("file = \"graph.txt\"\n")), 9.0, 1e-12);
}

TEST_F(DrawnFile, WhatIsNotThereOrNoFileIsSaid) {
  EXPECT_THAT(refusal("file = \"nofile\"\n"), HasSubstr("there is no such file"));
  fs::create_directory(folder_ / "folder");
  EXPECT_THAT(refusal("file = \"folder\"\n"), HasSubstr("is a folder"));
  write("x.abc", "0 0\n");
  EXPECT_THAT(refusal("file = \"x.abc\"\n"), testing::AllOf(HasSubstr(".poly"), HasSubstr(".geo "), HasSubstr(".svg"),
                                                            HasSubstr(".msh"), HasSubstr(".dxf")));
}

TEST_F(DrawnFile, EveryContourOfTheCorpusCanBeMeshed) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  const fs::path corpus = *data / "contours";
  int meshed = 0;
  for (const auto& file : fs::directory_iterator(corpus)) {
    const std::string ending = file.path().extension().string();
    if (ending == ".md") continue;
    const std::string closed = ending == ".dat" ? "closed = \"yes\"\n" : "";
    const model::Model model =
        good("file = \"" + file.path().string() + "\"\n" + closed + "[[step]]\noperation = \"mesh\"\n");
    ASSERT_EQ(model.meshes.size(), 1U) << file.path();
    EXPECT_NEAR(mesh::area(model.meshes[0]->mesh), area_of(model), 0.02 * area_of(model)) << file.path();
    ++meshed;
  }
  EXPECT_GE(meshed, 8);
}

}  // namespace
}  // namespace quebra::sketch
