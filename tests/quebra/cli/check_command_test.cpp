#include "quebra/cli/check_command.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <set>

#include "quebra/core/operations.h"
#include "shared/io/formats/mesh_file.h"
#include "tests/support/command_line.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using Json = nlohmann::json;

class CheckCommand : public dobra::test::CommandLine {
 protected:
  CheckCommand() : CommandLine(core::program(), {check_command()}) {}
  /// A square of four triangles round its middle.
  [[nodiscard]] std::string square(const std::string& elements) const {
    return put("square.inp",
               "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 0.5, 0.5\n*ELEMENT, TYPE=CPS3, ELSET=EALL\n" + elements +
                   "*NSET, NSET=corners\n1, 2, 3, 4\n*SURFACE, NAME=base, TYPE=ELEMENT\n1, S1\n*ELSET, "
                   "ELSET=REGION_7\n1, 2, 3, 4\n*ELSET, ELSET=plate\nREGION_7\n");
  }
};

TEST_F(CheckCommand, AnInvertedElementIsAFaultWithItsNumberAndPlace) {
  const auto told = call({"check", square("1, 1, 2, 5\n2, 2, 3, 5\n3, 4, 3, 5\n4, 4, 1, 5\n"), "--json"});
  EXPECT_EQ(told.code, 1) << told.err;
  const Json json = Json::parse(told.out);
  ASSERT_EQ(json["faults"].size(), 1u);
  EXPECT_EQ(json["faults"][0],
            "element 3 of the file: it is inverted: its corners run clockwise, those of most others anticlockwise (at "
            "0.5, 0.8333333333)");
  EXPECT_EQ(json["area"], 1.0);
}

TEST_F(CheckCommand, AGapIsClosedUpToTheLimitGiven) {
  const std::string open =
      put("open.geojson", R"({"type":"LineString","coordinates":[[0,0],[10,0],[10,8],[0,8],[0,0.5]]})");
  refuses({"check", open, "--repair"}, 3, {"a gap of 0.5 m between (0, 0)", "(0, 0.5)", "--gap"});
  refuses({"check", open, "--gap", "0.6"}, 3, {"give --repair"});
  refuses({"check", open, "--repair", "--gap", "-1"}, 3, {"'gap' must be greater than 0 m, found -1.0 m"});
  const auto told = call({"check", open, "--repair", "--gap", "0.6"});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_NE(told.err.find("the ends are joined; gaps up to 0.6 m are closed"), std::string::npos) << told.err;
}

TEST_F(CheckCommand, AClockwiseMeshIsSoundWithARemark) {
  const auto told = call({"check", square("1, 2, 1, 5\n2, 3, 2, 5\n3, 4, 3, 5\n4, 1, 4, 5\n"), "--json"});
  EXPECT_EQ(told.code, 0) << told.err;
  const Json json = Json::parse(told.out);
  EXPECT_TRUE(json["faults"].empty());
  ASSERT_EQ(json["remarks"].size(), 1u);
  EXPECT_NE(json["remarks"][0].get<std::string>().find("4 of 4 elements run clockwise"), std::string::npos);
  EXPECT_NE(told.err.find("4 of 4 elements run clockwise"), std::string::npos);
}

TEST_F(CheckCommand, NodesWithoutAnElementAreARemarkWithCountAndPlace) {
  const auto remarks = [&](const std::string& elements) {
    const auto told = call({"check", square(elements), "--json"});
    EXPECT_EQ(told.code, 0) << told.err;
    return Json::parse(told.out)["remarks"].dump();
  };
  EXPECT_EQ(remarks("1, 1, 2, 5\n2, 2, 3, 5\n3, 3, 4, 5\n4, 4, 1, 5\n"), "[]");
  const std::string file =
      put("cut.inp", "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 9, 7\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n");
  const auto told = call({"check", file});
  EXPECT_EQ(told.code, 0) << told.err;
  EXPECT_NE(told.err.find("nodes that belong to no element: 2 of 5, the first at 0, 1"), std::string::npos) << told.err;
}

TEST_F(CheckCommand, SetsAreListedWithKindAndCount) {
  const std::string file = square("1, 1, 2, 5\n2, 2, 3, 5\n3, 3, 4, 5\n4, 4, 1, 5\n");
  const auto told = call({"check", file, "--json"});
  EXPECT_EQ(told.code, 0) << told.err;
  const Json sets = Json::array({{{"name", "plate"}, {"kind", "region"}, {"count", 4}},
                                 {{"name", "base"}, {"kind", "sides"}, {"count", 1}},
                                 {{"name", "corners"}, {"kind", "nodes"}, {"count", 4}}});
  EXPECT_EQ(Json::parse(told.out)["sets"], sets);
  const auto plain = call({"check", file});
  EXPECT_NE(plain.out.find("region        4 'plate'\nsides         1 'base'\nnodes         4 'corners'\n"),
            std::string::npos)
      << plain.out;
}

TEST_F(CheckCommand, NamesOfAScenarioAreListedWithKindLengthAndPlace) {
  const std::string file = put("plate.toml", R"(dobra = 1
program = "quebra"
[[input.curve]]
name = "outline"
kind = "polygon"
points = [[0, 0], [4, 0], [4, 2], [0, 2]]
[[input.curve]]
name = "hole"
kind = "circle"
role = "hole"
centre = [1.0, 1.0]
radius = 0.5
[[input.crack]]
name = "slit"
points = [[2, 1], [3, 1]]
[[input.point]]
name = "gauge"
point = [3.5, 0.5]
[[input.region]]
name = "steel"
point = [3.5, 0.5]
[[step]]
operation = "problem"
[[step.support]]
where = "bottom"
x = 0.0
)");
  const auto told = call({"check", file, "--json", "--picture", path("names.svg")});
  ASSERT_EQ(told.code, 0) << told.err;
  const Json json = Json::parse(told.out);
  ASSERT_EQ(json["curves"].size(), 3u);
  const Json& outline = json["curves"][0];
  EXPECT_EQ(outline["name"], "outline");
  EXPECT_EQ(outline["kind"], "boundary");
  EXPECT_EQ(outline["shape"], "polygon");
  EXPECT_EQ(outline["length"], 12.0);
  ASSERT_EQ(outline["sides"].size(), 4u);
  EXPECT_EQ(outline["sides"][1], (Json{{"from", {4.0, 0.0}}, {"to", {4.0, 2.0}}}));
  EXPECT_EQ(json["curves"][1]["shape"], "circle");
  EXPECT_EQ(json["curves"][2]["lips"], (Json{"slit_left", "slit_right"}));
  EXPECT_EQ(json["curves"][2]["to"], (Json{3.0, 1.0}));
  EXPECT_EQ(json["points"], Json::array({{{"name", "gauge"}, {"at", {3.5, 0.5}}}}));
  EXPECT_EQ(json["regions"][0]["name"], "steel");
  for (const std::string name : {"outline", "hole", "slit", "gauge", "steel"})
    EXPECT_NE(text("names.svg").find(name), std::string::npos) << name;
  const auto plain = call({"check", file});
  for (const std::string line :
       {"'outline'", "side from (4, 0) to (4, 2)", "lips slit_left, slit_right", "point     at (3.5, 0.5)"})
    EXPECT_NE(plain.out.find(line), std::string::npos) << line << plain.out;
}

/// Middle of a text of an SVG picture; nothing if it is not drawn.
std::optional<std::pair<double, double>> place_of(const std::string& svg, const std::string& name) {
  const std::size_t end = svg.find('>' + name + "</text>");
  if (end == std::string::npos) return std::nullopt;
  const std::string tag = svg.substr(svg.rfind("<text", end), end - svg.rfind("<text", end));
  return std::pair{std::stod(tag.substr(tag.find(" x=\"") + 4)), std::stod(tag.substr(tag.find(" y=\"") + 4))};
}

/// Four triangles round a middle that stands one above their square: a pyramid without its floor.
mesh::ElementMesh pyramid() {
  mesh::ElementMesh mesh;
  mesh.points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  mesh.first.push_back(0);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array nodes{mesh::NodeId(i), mesh::NodeId((i + 1) % 4), mesh::NodeId(4)};
    add_element(mesh, mesh::ElementType::T3, nodes, 1);
  }
  return mesh;
}
constexpr std::array pyramid_heights{0.0, 0.0, 0.0, 0.0, 1.0};

TEST_F(CheckCommand, SurfacesInSpaceAreCheckedInEveryFormatThatWeWrite) {
  const double side = std::sqrt(3.0);  // From a corner to the middle.
  for (const std::string& ending : io::formats::endings_for(io::formats::Use::WriteSpaceMesh)) {
    const std::string file = path("pyramid" + ending);
    ASSERT_TRUE(io::formats::write_mesh(file, pyramid(), io::meshes::InpElement::Shell, pyramid_heights).ok()) << file;
    const auto told = call({"check", file, "--json"});
    ASSERT_EQ(told.code, 0) << ending << told.out << told.err;
    const Json json = Json::parse(told.out);
    EXPECT_EQ(json["points"], 5) << ending;
    EXPECT_EQ(json["faces"], 4) << ending;
    EXPECT_EQ(json["open_edges"], 4) << ending;
    EXPECT_EQ(json["borders"], 1) << ending;
    EXPECT_NEAR(json["area"].get<double>(), 4.0 * std::sqrt(2.0), 1e-6) << ending;
    EXPECT_NEAR(json["alpha_min"].get<double>(), 4.0 * std::sqrt(3.0) * std::sqrt(2.0) / (4.0 + 2.0 * side * side),
                1e-6)
        << ending;
    EXPECT_EQ(call({"check", file, "--closed"}).code, 1) << ending;
  }
}

TEST_F(CheckCommand, ATurnedElementOfASurfaceIsAFaultInEveryFormatWithItsPlace) {
  mesh::ElementMesh mesh = pyramid();
  std::swap(mesh.nodes[3], mesh.nodes[4]);
  for (const std::string& ending : io::formats::endings_for(io::formats::Use::WriteSpaceMesh)) {
    const std::string file = path("turned" + ending);
    ASSERT_TRUE(io::formats::write_mesh(file, mesh, io::meshes::InpElement::Shell, pyramid_heights).ok()) << file;
    const auto told = call({"check", file, "--json"});
    EXPECT_EQ(told.code, 1) << ending << told.err;
    const Json json = Json::parse(told.out);
    ASSERT_EQ(json["faults"].size(), 1U) << ending;
    EXPECT_EQ(json["faults"][0], "face 1 is turned against its neighbours (at 1.666666667, 1, 0.3333333333)") << ending;
  }
}

TEST_F(CheckCommand, OfASurfaceOfSecondOrderTheCornersAreJudgedAndThatIsSaid) {
  const std::string file = put("shell.inp",
                               "*NODE\n1, 0, 0, 0\n2, 2, 0, 0\n3, 0, 2, 1\n4, 1, 0, 0\n5, 1, 1, 0.5\n6, 0, 1, 0.5\n"
                               "*ELEMENT, TYPE=S6, ELSET=EALL\n1, 1, 2, 3, 4, 5, 6\n");
  const auto told = call({"check", file, "--json"});
  ASSERT_EQ(told.code, 0) << told.err;
  const Json json = Json::parse(told.out);
  EXPECT_EQ(json["points"], 3);
  EXPECT_NEAR(json["area"].get<double>(), std::sqrt(5.0), 1e-14);
  EXPECT_THAT(json["remarks"].dump(), testing::HasSubstr("mid-sides are not looked at"));
}

TEST_F(CheckCommand, NamesOfSurfacesAreListedWithAreasAndLengths) {
  const std::string file =
      put("roof.toml",
          "dobra = 1\nprogram = \"quebra\"\nunit_system = \"mm, N, MPa\"\n"
          "[[input.surface]]\nname = \"roof\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 90]\nv = [0, 3]\n"
          "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\npoints = [[45, 1], [45, 2]]\n"
          "[[input.surface_point]]\nname = \"gauge\"\nat = [0, 1]\n");
  const auto outcome = call({"check", file, "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["surfaces"].size(), 1U);
  const Json& roof = json["surfaces"][0];
  EXPECT_NEAR(roof["area"].get<double>(), 3 * std::numbers::pi, 1e-6);  // mm2
  std::map<std::string, double> lengths;
  for (const Json& line : roof["lines"]) lengths[line["name"]] = line["length"].get<double>();
  EXPECT_EQ(lengths.size(), 5U);
  EXPECT_NEAR(lengths["roof_bottom"], std::numbers::pi, 1e-9);
  EXPECT_NEAR(lengths["roof_left"], 3.0, 1e-9);
  EXPECT_NEAR(lengths["k"], 1.0, 1e-9);
  EXPECT_EQ(roof["points"][0]["name"], "gauge");
  EXPECT_NEAR(roof["points"][0]["at"][2].get<double>(), 1.0, 1e-9);
  EXPECT_THAT(call({"check", file}).out, testing::HasSubstr("'roof'        surface   area 9.42478"));
  refuses({"check", file, "--picture", path("p.svg")}, 2, {"surfaces"});
}

TEST_F(CheckCommand, EveryNameHasItsPlaceInThePicture) {
  // A region's name, a crack and a point at one place; curves whose halves of length are corners; many small ones.
  const auto curve = [](const std::string& name, const std::string& more) {
    return "[[input.curve]]\nname = \"" + name + "\"\n" + more;
  };
  const std::string head = "dobra = 1\nprogram = \"quebra\"\n";
  const std::string square = curve("outline", "kind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 4], [0, 4]]\n");
  const std::string middle =
      "[[input.crack]]\nname = \"slit\"\npoints = [[1.5, 2], [2.5, 2]]\n[[input.region]]\nname = \"steel\"\npoint = "
      "[2, 2.2]\n[[input.point]]\nname = \"gauge\"\npoint = [2, 2.3]\n";
  std::string holes;
  std::vector<std::string> many{"outline"};
  for (int i = 0; i < 5; ++i) {
    many.push_back("bore_" + std::to_string(i));
    holes += curve(many.back(), fmt::format("kind = \"circle\"\nrole = \"hole\"\ncentre = [{}, 3.0]\nradius = 0.05\n",
                                            1.0 + 0.2 * i));
  }
  for (const auto& [text_of, names] :
       {std::pair{square + middle, std::vector<std::string>{"outline", "slit", "steel", "gauge"}},
        std::pair{square + holes, many}}) {
    ASSERT_EQ(call({"check", put("names.toml", head + text_of), "--picture", path("names.svg")}).code, 0);
    const std::string svg = text("names.svg");
    std::set<std::pair<double, double>> places;
    for (const std::string& name : names) {
      const auto place = place_of(svg, name);
      ASSERT_TRUE(place) << name;
      EXPECT_TRUE(places.insert(*place).second) << name;
    }
  }
}

TEST_F(CheckCommand, NamesOfDrawingsAreListedAndBadOnesRefused) {
  const std::string lines =
      "<svg><line id=\"bottom\" x1=\"0\" y1=\"0\" x2=\"2\" y2=\"0\"/><line id=\"right\" x1=\"2\" y1=\"0\" x2=\"2\" "
      "y2=\"-1\"/>"
      "<polyline id=\"rest\" points=\"2,-1 0,-1 0,0\"/><line id=\"seam\" x1=\"1\" y1=\"0\" x2=\"1\" y2=\"-1\"/></svg>";
  const auto drawn = call({"check", put("plate.svg", lines), "--json"});
  ASSERT_EQ(drawn.code, 0) << drawn.err;
  const Json json = Json::parse(drawn.out);
  EXPECT_EQ(json["parts"], 2);
  std::map<std::string, std::string> kinds;
  for (const Json& curve : json["curves"]) kinds[curve["name"]] = curve["kind"];
  EXPECT_EQ(kinds, (std::map<std::string, std::string>{
                       {"bottom", "boundary"}, {"right", "boundary"}, {"rest", "boundary"}, {"seam", "internal"}}));
  refuses({"check", path("none.svg")}, 3, {"none.svg"});
  refuses({"check", put("open.csv", "0,0\n1,0\n1,1\n")}, 3, {"no curve closes", "--closed"});
  EXPECT_EQ(call({"check", path("open.csv"), "--closed"}).code, 0);
  refuses({"check", square("1, 1, 2, 5\n2, 2, 3, 5\n3, 3, 4, 5\n4, 4, 1, 5\n"), "--picture", path("m.svg")}, 2,
          {"--picture"});
}

}  // namespace
}  // namespace quebra::cli
