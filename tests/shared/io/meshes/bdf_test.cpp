// bdf.h, neutral.h and mesh_file.h.

#include "shared/io/meshes/bdf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/msh.h"
#include "shared/io/meshes/neutral.h"
#include "shared/io/meshes/stl.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::meshes {
namespace {

using base::ErrorCode;
using mesh::ElementMesh;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;

/// Equal but for the last digits of the coordinates.
void expect_same_but_rounded(const ElementMesh& read, const ElementMesh& mesh, double tolerance) {
  ASSERT_EQ(read.points.size(), mesh.points.size());
  for (std::size_t n = 0; n < mesh.points.size(); ++n) EXPECT_LE(distance(read.points[n], mesh.points[n]), tolerance);
  ElementMesh moved = read;
  moved.points = mesh.points;
  for (std::size_t i = 0; i < moved.tips.size(); ++i) moved.tips[i].direction = mesh.tips[i].direction;
  EXPECT_EQ(moved, mesh);
}

TEST(Bdf, QUE_i_AMeshReadsBackWithAllItsSetsAndTheSecondTextIsTheFirst) {
  for (const ElementMesh& mesh : {test::example_mesh(), test::quadratic_example()}) {
    const std::string text = *bdf_text(mesh);
    const auto read = parse_bdf(text, "f");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    expect_same_but_rounded(read->mesh, mesh, 2e-13);
    EXPECT_EQ(*bdf_text(read->mesh), text);
  }
}

/// A triangle with this corner beside (0, 0) and (1, 0).
ElementMesh triangle_with(geom::Point corner) {
  ElementMesh mesh;
  mesh.points = {{0.0, 0.0}, {1.0, 0.0}, corner};
  add_element(mesh, mesh::ElementType::T3, {{mesh::NodeId(0), mesh::NodeId(1), mesh::NodeId(2)}}, 1);
  return mesh;
}

TEST(Bdf, CardsAreInSmallFieldsWhereTheyHoldTheValueAndInLargeOnesElsewhere) {
  // Seven digits and a point are eight characters.
  for (const auto& [corner, line] : std::vector<std::pair<geom::Point, std::string>>{
           {{0.5, 2.0}, "GRID    3               .5      2.      0.\n"},
           {{-12.125, 1e-5}, "GRID    3               -12.125 1.-5    0.\n"},
           {{1234.567, 0.1234567}, "GRID    3               1234.567.12345670.\n"},
           {{1e6, 4.0}, "GRID    3               1000000.4.      0.\n"}}) {
    const std::string text = *bdf_text(triangle_with(corner));
    EXPECT_EQ(text.find('*'), std::string::npos) << text;
    EXPECT_THAT(text, HasSubstr(line));
    EXPECT_EQ(parse_bdf(text, "f")->mesh.points[2], corner);
  }
  // One digit more and the card is long, alone.
  for (const geom::Point corner :
       {geom::Point{1.0 / 3.0, 1.0}, {12345.678, 1.0}, {0.5, 1.2345678}, {0.5, -1e-5 / 7.0}}) {
    const std::string text = *bdf_text(triangle_with(corner));
    EXPECT_THAT(text, HasSubstr("\nGRID    2"));
    EXPECT_THAT(text, HasSubstr("\nGRID*   3"));
    EXPECT_THAT(text, HasSubstr("\nCTRIA3  1"));
    EXPECT_LE(distance(parse_bdf(text, "f")->mesh.points[2], corner), 1e-9 * length(corner - geom::Point{}));
  }
}

TEST(Bdf, NumbersFitTheirFieldAndStay) {
  EXPECT_EQ(bdf_number(0.0, 8), "0.");
  EXPECT_EQ(bdf_number(1.0, 8), "1.");
  EXPECT_EQ(bdf_number(-0.5, 8), "-.5");
  EXPECT_EQ(bdf_number(1.0 / 3.0, 8), ".3333333");
  EXPECT_EQ(bdf_number(1e-300, 8), "1.-300");
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(uniform(random), static_cast<int>(random() % 200) - 100);
    for (const std::size_t width : {8U, 16U}) {
      const std::string text = bdf_number(value, width);
      ASSERT_LE(text.size(), width) << text;
      ASSERT_NE(text.find('.'), std::string::npos) << text;
      const auto read = parse_bdf("GRID,1,," + text + ",0.\nGRID,2,,1.+9,1.+9\nGRID,3,,0.,1.\nCTRIA3,1,1,1,2,3\n", "f");
      ASSERT_TRUE(read.ok()) << text;
      EXPECT_EQ(bdf_number(read->mesh.points[0].x, width), text);
      EXPECT_NEAR(read->mesh.points[0].x, value, std::abs(value) * (width == 8 ? 2e-2 : 1e-9)) << text;
    }
  }
}

TEST(Bdf, FixedAndFreeFieldsOfOtherProgramsAreRead) {
  const auto read = parse_bdf(
      "SOL 101\nCEND\nBEGIN BULK\n$ a comment\nGRID    1               0.0     0.0     0.0\nGRID,2,,1.,0.\nGRID*   3   "
      "                            1.0D+0"
      "          1.0\n*       0.0\nGRID    4               0.0     1.0\nCQUAD4  10      5       1       2       3      "
      " 4\nSET1,7,1,2\nMAT1,1,2.1+11,,.3\n"
      "ENDDATA\n",
      "f");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->mesh.element_count(), 1U);
  EXPECT_EQ(read->mesh.regions[0], 5);
  EXPECT_DOUBLE_EQ(area(read->mesh), 1.0);
  EXPECT_EQ(read->mesh.node_sets.at("set 7").size(), 2U);
  EXPECT_THAT(read->remarks, ElementsAre(HasSubstr("'MAT1' left out")));
}

TEST(Bdf, BadTextIsRefusedWithItsPlace) {
  const std::string grid = "GRID,1,,0.,0.\nGRID,2,,1.,0.\nGRID,3,,0.,1.\n";
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {grid, "f:0:0", "no triangles"},
      {grid + "GRID,3,,0.,1.\n", "f:4:1", "given twice"},
      {"GRID,1,,a,0.\n", "f:1:9", "'a' is not a number"},
      {grid + "CTRIA3,1,1,1,2,9\n", "f:4:1", "no grid point 9"},
      {grid + "CTRIA3,1,1,1\n", "f:4:1", "too few fields"},
      {"+,1\n", "f:1:1", "no card before"},
      {grid + "CTRIA3,1,1,1,2,3\n$DOBRA SIDESET a\n$DOBRA SIDE 1 4\n", "f:6:1", "no side 4"},
  };
  for (const auto& [text, place, says] : cases) {
    const auto read = parse_bdf(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(Neutral, QUE_i_AMeshReadsBackTheSameAndTheSecondTextIsTheFirst) {
  for (const ElementMesh& mesh : {test::example_mesh(), test::quadratic_example()}) {
    const NeutralFile file{mesh, {{0, {2.1e11, 0.25}}, {7, {7e10, 1.0 / 3.0}}}, 0.02};
    const std::string text = *neutral_text(file);
    const auto read = parse_neutral(text, "f");
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(*read, file);
    EXPECT_EQ(*neutral_text(*read), text);
  }
}

TEST(Neutral, TheSectionsAreThoseOfTheOriginal) {
  const std::string text = *neutral_text({test::example_mesh(3), {}, 1.0});
  std::size_t at = 0;
  for (const char* const section : {"%HEADER", "%NODE\n", "%NODE.COORD", "%MATERIAL.ISOTROPIC", "%THICKNESS",
                                    "%INTEGRATION.ORDER", "%ELEMENT\n", "%ELEMENT.T3", "%END"}) {
    at = text.find(section, at);
    EXPECT_NE(at, std::string::npos) << section;
  }
}

TEST(Neutral, BadTextIsRefusedWithItsPlace) {
  const std::string nodes = "%NODE.COORD\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n";
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {"hello\n", "f:1:1", "section"},
      {nodes, "f:0:0", "before %END"},
      {nodes + "%END\n", "f:0:0", "no elements"},
      {"%NODE.COORD\n2\n1 0 0 0\n1 1 0 0\n", "f:4:1", "given twice"},
      {nodes + "%ELEMENT.T3\n1\n1 1 1 1 1 2 4\n%END\n", "f:8:13", "no node 4"},
      {nodes + "%ELEMENT.T3\n1\n1 1 1 1 1 2 3\n%NODE.SET\n1\n'a' 1\n9\n%END\n", "f:12:1", "no node 9"},
      {nodes + "%ELEMENT.T3\n1\n1 1 1 1 1 2 3\n%SIDE.SET\n1\n'a' 1\n1 4\n%END\n", "f:12:1", "no side 4"},
  };
  for (const auto& [text, place, says] : cases) {
    const auto read = parse_neutral(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(MeshFile, EveryEndingIsWritten) {
  const test::TemporaryFolder folder;
  const ElementMesh mesh = test::example_mesh();
  for (const std::string& ending : formats::endings_for(formats::Use::WriteMesh)) {
    ASSERT_TRUE(formats::write_mesh(folder.file("m" + ending), mesh, InpElement::PlaneStress).ok()) << ending;
    EXPECT_TRUE(read_text(folder.file("m" + ending)).ok()) << ending;
  }
  EXPECT_EQ(read_msh(folder.file("m.msh2"))->mesh, mesh);
  EXPECT_EQ(formats::write_mesh(folder.file("m.xyz"), mesh, InpElement::PlaneStress).error().code, ErrorCode::BadUsage);
}

TEST(Stl, FacesAndPointsReadBack) {
  const mesh::TriangleMesh mesh = triangle_mesh_of(test::example_mesh(3));
  const auto text = stl_text(mesh);
  ASSERT_TRUE(text.ok());
  EXPECT_THAT(*text, HasSubstr("facet normal"));
  const auto read = parse_stl(*text, "a.stl");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_EQ(read->triangles.size(), mesh.triangles.size());
  EXPECT_NEAR(area(*read), area(mesh), 1e-6) << "OpenMesh reads it in single precision";
}

}  // namespace
}  // namespace dobra::io::meshes
