// Drawings as they come: each is a text, and its area and the length of its boundary are computed by hand.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/drawn_file.h"

namespace quebra::repair {
namespace {

using test::area_of;
using test::dxf;
using test::dxf_line;
using testing::HasSubstr;

using std::numbers::pi;

class UntidyDrawings : public test::DrawnFile {};

struct Drawing {
  std::string name, file, text;
  std::string more;                       ///< Of the input: repair, cracks.
  double area = 0.0, perimeter = 0.0;     ///< By hand; what stays when the drawing is taken.
  std::vector<std::string> refused = {};  ///< What the refusal names; empty: it is taken.
  double bend = 1e-9;                     ///< Of the area: by how much chords and elements of first order may miss it.
};

std::string svg(const std::string& shapes) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + shapes + "</svg>\n";
}
std::string crack(const std::string& name, const std::string& points) {
  return "[[input.crack]]\nname = \"" + name + "\"\npoints = [" + points + "]\n";
}
std::string entity(const char* kind, const std::string& codes) {
  return std::string("0\n") + kind + "\n8\n0\n" + codes;
}
std::string circle(double x, double y, double r) {
  return entity("CIRCLE", fmt::format("10\n{}\n20\n{}\n40\n{}\n", x, y, r));
}
std::string box(double x0, double y0, double x1, double y1) {
  return dxf_line(x0, y0, x1, y0) + dxf_line(x1, y0, x1, y1) + dxf_line(x1, y1, x0, y1) + dxf_line(x0, y1, x0, y0);
}

const std::string plate_polygon = "<polygon id=\"plate\" points=\"0,0 10,0 10,8 0,8\"/>\n";  // in an SVG y points down
const std::string plate_csv = "0,0\n10,0\n10,8\n0,8\n0,0\n";
const std::string mend = "repair = \"yes\"\n";

std::vector<Drawing> drawings() {
  const std::string holes = plate_polygon +
                            "<rect id=\"a\" x=\"2\" y=\"3\" width=\"2\" height=\"2\"/>\n<rect id=\"b\" x=\"6\" y=\"3\" "
                            "width=\"2\" height=\"2\"/>\n";
  const std::string twice = svg(plate_polygon + "<polygon id=\"again\" points=\"10,8 0,8 0,0 10,0\"/>\n");
  const std::string hole_twice = svg(
      plate_polygon + "<circle id=\"a\" cx=\"5\" cy=\"4\" r=\"2\"/>\n<circle id=\"b\" cx=\"5\" cy=\"4\" r=\"2\"/>\n");
  const std::string at_edge = svg(plate_polygon + "<rect id=\"hole\" x=\"0\" y=\"3\" width=\"2\" height=\"2\"/>\n");
  const std::string at_point = svg(plate_polygon + "<polygon id=\"hole\" points=\"0,4 2,3 4,4 2,5\"/>\n");
  const std::string bow = "0,0\n2,2\n2,0\n0,2\n0,0\n";
  const std::string bow_svg = svg("<polygon id=\"bow\" points=\"0,0 2,2 2,0 0,2\"/>\n");
  const double diamond = 4.0 * std::sqrt(5.0);
  return {
      {"outline twice", "a.svg", twice, "", 0, 0, {"'plate' and 'again' are identical", "(at 10, -8)"}},
      {"outline twice, mended", "a.svg", twice, mend, 80, 36},
      {"hole twice", "a.svg", hole_twice, "", 0, 0, {"'a_1' and 'b_1' are identical", "(at 7, -4)"}},
      {"hole twice, mended", "a.svg", hole_twice, mend, 80 - 4 * pi, 36 + 4 * pi, {}, 1e-2},
      {"hole with a side on the outline", "a.svg", at_edge, "", 0, 0, {"plate", "hole", "(at 0, "}},
      {"hole with a side on the outline, mended", "a.svg", at_edge, mend, 76, 40},
      {"hole that touches in a point", "a.svg", at_point, "", 0, 0, {"(at 0, -4)"}},
      {"hole that touches in a point, mended", "a.svg", at_point, mend, 76, 36 + diamond},
      {"holes that share a side, mended", "a.svg",
       svg(plate_polygon + "<rect id=\"a\" x=\"2\" y=\"3\" width=\"2\" height=\"2\"/>\n<rect id=\"b\" x=\"4\" y=\"3\" "
                           "width=\"2\" height=\"2\"/>\n"),
       mend, 80 - 8, 36 + 12},
      {"crack along the outline", "a.csv", plate_csv, crack("c", "[2, 0], [4, 0]"), 0, 0, {"'c'", "(at 2, 0)"}},
      {"crack on a hole's rim", "a.svg", svg(holes), crack("c", "[4, -4], [5, -4]"), 72, 52},
      {"crack from hole to hole", "a.svg", svg(holes), crack("c", "[4, -4], [6, -4]"), 72, 52},
      {"crack out of the solid",
       "a.csv",
       plate_csv,
       crack("c", "[8, 4], [12, 4]"),
       0,
       0,
       {"crack 'c' lies outside the domain in part", "(at 11, 4)"}},
      {"crack through a hole",
       "a.svg",
       svg(holes),
       crack("c", "[1, -4], [5, -4]"),
       0,
       0,
       {"'c' lies outside", "(at 3, -4)"}},
      {"cracks that cross at their tips", "a.csv", plate_csv,
       crack("c", "[2, 4], [5, 4]") + crack("d", "[5, 4], [5, 6]"), 80, 36},
      {"three cracks that meet", "a.csv", plate_csv,
       crack("c", "[2, 4], [5, 4]") + crack("d", "[5, 4], [7, 6]") + crack("e", "[5, 4], [7, 2]"), 80, 36},
      {"cracks that cross", "a.csv", plate_csv, crack("c", "[2, 4], [8, 4]") + crack("d", "[5, 2], [5, 6]"), 80, 36},
      {"crack drawn twice",
       "a.csv",
       plate_csv,
       crack("c", "[2, 4], [5, 4]") + crack("d", "[5, 4], [2, 4]"),
       0,
       0,
       {"'c' and 'd' are identical"}},
      {"cracks that overlap",
       "a.csv",
       plate_csv,
       crack("c", "[2, 4], [5, 4]") + crack("d", "[4, 4], [7, 4]"),
       0,
       0,
       {"'c'", "'d'", "(at 4, 4)"}},
      {"repeated points", "a.csv", "0,0\n0,0\n10,0\n10,8\n10,8\n10,8\n0,8\n0,0\n", mend, 80, 36},
      {"segments of 1e-12", "a.csv", "0,0\n1e-12,0\n10,0\n10,8\n10,8.000000000001\n0,8\n0,0\n", mend, 80, 36},
      {"clockwise outline", "a.csv", "0,0\n0,8\n10,8\n10,0\n0,0\n", "", 80, 36},
      {"clockwise outline, anticlockwise hole", "a.geojson",
       R"({"type":"Polygon","coordinates":[[[0,0],[0,8],[10,8],[10,0],[0,0]],[[2,2],[4,2],[4,4],[2,4],[2,2]]]})", "",
       76, 44},
      {"nested islands", "a.dxf", dxf(box(0, 0, 10, 10) + box(1, 1, 9, 9) + box(2, 2, 8, 8) + box(3, 3, 7, 7)), "",
       100 - 64 + 36 - 16, 4 * (10 + 8 + 6 + 4)},
      {"halves of different directions", "a.geojson",
       R"({"type":"MultiLineString","coordinates":[[[0,0],[10,0],[10,8]],[[0,0],[0,8],[10,8]]]})", "", 80, 36},
      {"bow-tie whose halves cancel", "a.csv", bow, "", 0, 0, {"crosses or touches itself", "(at 1, 1)"}},
      {"bow-tie", "a.svg", bow_svg, "", 0, 0, {"crosses", "(at 1, -1)"}},
      {"bow-tie, mended", "a.svg", bow_svg, mend, 2, 4 + 4 * std::sqrt(2.0)},
      {"circle", "a.dxf", dxf(circle(3, 4, 2)), "", 4 * pi, 4 * pi, {}, 1e-1},
      {"arc of 360 degrees",
       "a.dxf",
       dxf(entity("ARC", "10\n3\n20\n4\n40\n2\n50\n0\n51\n360\n")),
       "",
       4 * pi,
       4 * pi,
       {},
       1e-1},
      {"arc of 360 degrees from 90",
       "a.dxf",
       dxf(entity("ARC", "10\n3\n20\n4\n40\n2\n50\n90\n51\n450\n")),
       "",
       4 * pi,
       4 * pi,
       {},
       1e-1},
      {"half disc of arc and line",
       "a.dxf",
       dxf(entity("ARC", "10\n0\n20\n0\n40\n2\n50\n0\n51\n180\n") + dxf_line(2, 0, -2, 0)),
       "",
       2 * pi,
       2 * pi + 4,
       {},
       1e-1},
      {"half disc by a bulge",
       "a.dxf",
       dxf(entity("LWPOLYLINE", "90\n2\n70\n1\n10\n2\n20\n0\n42\n1\n10\n-2\n20\n0\n42\n0\n")),
       "",
       2 * pi,
       2 * pi + 4,
       {},
       1e-1},
      {"lens of two quadratic curves",
       "a.svg",
       svg("<path id=\"p\" d=\"M0,0 Q2,2 4,0 Q2,-2 0,0 Z\"/>\n"),
       "",
       2.0 * 8.0 / 3.0,
       2.0 * (2.0 * std::sqrt(2.0) + 2.0 * std::asinh(1.0)),
       {},
       1e-1},
      {"inches", "a.dxf", dxf(box(0, 0, 10, 8), "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n"), "",
       80 * 0.0254 * 0.0254, 36 * 0.0254},
      {"inches that are millimetres", "a.dxf",
       dxf(box(0, 0, 10, 8), "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n"), "unit = \"mm\"\n", 80e-6,
       36e-3},
      {"file in mm, crack in m", "a.dxf",
       dxf(box(0, 0, 10000, 8000), "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"),
       crack("c", "[0, 4], [5, 4]"), 80, 36},
      {"UTM", "a.csv", "350000,7000000\n350010,7000000\n350010,7000008\n350000,7000008\n350000,7000000\n", "", 80, 36},
      {"UTM with an arc",
       "a.dxf",
       dxf(circle(350000, 7000000, 2) + box(349990, 6999990, 350010, 7000010)),
       "",
       400 - 4 * pi,
       80 + 4 * pi,
       {},
       1e-2},
      {"tiny", "a.csv", "0,0\n1e-6,0\n1e-6,8e-7\n0,8e-7\n0,0\n", "", 8e-13, 3.6e-6},
      {"hole outside", "a.svg", svg(plate_polygon + "<rect id=\"h\" x=\"12\" y=\"0\" width=\"2\" height=\"2\"/>\n"), "",
       84, 44},
      {"outlines of lines that touch in a corner",
       "a.dxf",
       dxf(box(0, 0, 4, 4) + box(4, 4, 8, 8)),
       mend,
       0,
       0,
       {"4 boundary curves meet in one point", "(at 4, 4)"}},
      {"outlines that touch in a corner", "a.geojson",
       R"({"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[4,4],[0,4],[0,0]]],[[[4,4],[8,4],[8,8],[4,8],[4,4]]]]})",
       mend, 32, 32},
      {"line that ends on the outline", "a.dxf", dxf(box(0, 0, 10, 8) + dxf_line(5, 0, 5, 4)), "", 80, 36},
      {"sides past their corners", "a.dxf",
       dxf(dxf_line(-1, 0, 11, 0) + dxf_line(10, -1, 10, 9) + dxf_line(11, 8, -1, 8) + dxf_line(0, 9, 0, -1)), mend, 80,
       36},
      {"spike", "a.csv", "0,0\n10,0\n10,8\n5,8\n5,12\n5,8\n0,8\n0,0\n", mend, 80, 36},
  };
}

TEST_F(UntidyDrawings, HaveTheAreaAndTheBoundaryOfTheirClosedForm) {
  for (const Drawing& drawing : drawings()) {
    SCOPED_TRACE(drawing.name);
    write(drawing.file, drawing.text);
    const std::string mesh = "[[step]]\noperation = \"mesh\"\n";
    const auto run = run_of("file = \"" + drawing.file + "\"\n" + drawing.more + mesh);
    if (!drawing.refused.empty()) {
      ASSERT_TRUE(run.error) << drawing.name;
      for (const std::string& wanted : drawing.refused) EXPECT_THAT(to_string(*run.error), HasSubstr(wanted));
      continue;
    }
    EXPECT_FALSE(run.error) << to_string(*run.error);
    if (run.error) continue;
    const model::Model& model = dobra::scenario::model_of<model::Model>(run.states.back());
    double perimeter = 0.0, meshed = 0.0;
    for (const sketch::Curve& curve : model.domain.curves)
      perimeter += curve.role == sketch::Role::Boundary || curve.role == sketch::Role::Hole ? length(curve) : 0.0;
    for (const auto& quantity : core::program().quantities_of(run.states.back()))
      meshed = quantity.name == "area" ? quantity.value : meshed;
    EXPECT_NEAR(perimeter, drawing.perimeter, 1e-8 * drawing.perimeter);
    EXPECT_NEAR(area_of(model), drawing.area, drawing.bend * drawing.area);
    EXPECT_NEAR(meshed, drawing.area, drawing.bend * drawing.area);
  }
}

}  // namespace
}  // namespace quebra::repair
