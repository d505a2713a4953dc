#include "shared/io/meshes/poly.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "shared/io/file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::meshes {
namespace {

using base::ErrorCode;
using test::place_text;
using testing::ElementsAre;
using testing::HasSubstr;

// A square with a square hole and two regions, as Triangle's documentation lays it out.
const std::string square =
    "# a plate\n8 2 1 1   # points\n1 0 0 5.5 1\n2 4 0 5.5 1\n3 4 4 5.5 1\n4 0 4 5.5 1\n\n"
    "5 1 1 0 2\n6 2 1 0 2\n7 2 2 0 2\n8 1 2 0 2\n8 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 5 6 2\n6 6 7 2\n7 7 8 2\n8 "
    "8 5 2\n"
    "1\n1 1.5 1.5\n1\n1 3.5 3.5 7 0.25\n";

TEST(Poly, PointsAttributesMarkersSegmentsHolesAndRegionsAreRead) {
  const auto read = parse_poly(square, "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->nodes.points.size(), 8U);
  EXPECT_EQ(read->nodes.first_number, 1U);
  EXPECT_EQ(read->nodes.points[2], (geom::Point{4, 4}));
  EXPECT_EQ(read->nodes.attributes[0], 5.5);
  EXPECT_EQ(read->nodes.markers[7], 2);
  ASSERT_EQ(read->segments.size(), 8U);
  EXPECT_EQ(read->segments[3], (std::array<std::uint32_t, 2>{3, 0}));
  EXPECT_EQ(read->segment_markers[4], 2);
  EXPECT_THAT(read->holes, ElementsAre(geom::Point{1.5, 1.5}));
  EXPECT_THAT(read->regions, ElementsAre(PolyRegion{{3.5, 3.5}, 7.0, 0.25}));
}

TEST(Poly, NumbersFromZeroAndAbsentSectionsAreRead) {
  const auto read = parse_poly("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n", "f");
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->nodes.first_number, 0U);
  EXPECT_EQ(read->segments[2], (std::array<std::uint32_t, 2>{2, 0}));
  EXPECT_TRUE(read->holes.empty() && read->regions.empty() && read->segment_markers.empty());
}

TEST(Poly, PointsMayStandInTheNodeFileBeside) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("a.poly")) << "0 2 0 0\n1 0\n1 1 2\n0\n";
  const auto missing = read_poly(folder.file("a.poly"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::FileNotFound);
  EXPECT_THAT(base::to_string(missing.error()), HasSubstr("a.node"));
  std::ofstream(folder.file("a.node")) << "2 2 0 0\n1 0 0\n2 1 0.5\n";
  const auto read = read_poly(folder.file("a.poly"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->nodes.points[1], (geom::Point{1, 0.5}));
}

TEST(Poly, WriteReadWriteGivesTheSameBytes) {
  const auto read = parse_poly(square, "f");
  ASSERT_TRUE(read.ok());
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_poly(folder.file("a.poly"), *read).ok());
  const auto again = read_poly(folder.file("a.poly"));
  ASSERT_TRUE(again.ok()) << base::to_string(again.error());
  EXPECT_EQ(*again, *read);
  EXPECT_EQ(*poly_text(*again), *read_text(folder.file("a.poly")));
}

TEST(Poly, BadTextIsRefusedWithItsPlace) {
  const std::string points = "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n";
  const std::tuple<std::string, ErrorCode, std::string, std::string> cases[] = {
      {"", ErrorCode::EmptyFile, "f:0:0", "empty"},
      {"three 2 0 0\n", ErrorCode::BadFormat, "f:1:1", "the number of points 'three' is not an integer"},
      {"-3 2 0 0\n", ErrorCode::BadFormat, "f:1:1", "negative"},
      {"3 3 0 0\n", ErrorCode::BadFormat, "f:1:3", "dimension 3"},
      {"0 2 0 0\n", ErrorCode::BadFormat, "f:1:1", "no points"},
      {"3 2 0 0\n1 0 0\n", ErrorCode::BadFormat, "f:2:0", "ends before point 2 of 3"},
      {"2 2 0 0\n1 0 0\n3 0 0\n", ErrorCode::BadFormat, "f:3:1", "point number 3 stands where 2 is due"},
      {"2 2 0 0\n5 0 0\n", ErrorCode::BadFormat, "f:2:1", "start at 0 or 1"},
      {"2 2 0 0\n1 0 zero\n", ErrorCode::BadFormat, "f:2:5", "y 'zero' is not a number"},
      {"2 2 0 0\n1 0 inf\n", ErrorCode::NotFinite, "f:2:5", "not finite"},
      {"2 2 0 0\n1 0\n", ErrorCode::BadFormat, "f:2:4", "y is missing"},
      {points + "1 0\n1 1 4\n", ErrorCode::BadFormat, "f:6:5", "there is no point 4"},
      {points + "1 0\n1 2 2\n", ErrorCode::BadFormat, "f:6:3", "to itself"},
      {points + "1 0\n1 1 2\n", ErrorCode::BadFormat, "f:6:0", "ends before the number of holes"},
      {points + "1 0\n1 1 2\n0\n0\n9 9\n", ErrorCode::BadFormat, "f:9:1", "behind the last section"},
  };
  for (const auto& [text, code, place, says] : cases) {
    const auto read = parse_poly(text, "f");
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, code) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
}

TEST(NodeEle, QUE_i_AMeshReadsBackWithTheSameCountsAndNumbers) {
  const test::TemporaryFolder folder;
  for (const mesh::ElementMesh& mesh : {test::example_mesh(), mesh::to_second_order(test::example_mesh()).mesh}) {
    ASSERT_TRUE(write_node_ele(folder.file("m"), mesh).ok());
    const auto read = read_node_ele(folder.file("m"));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->points, mesh.points);
    EXPECT_EQ(read->types, mesh.types);
    EXPECT_EQ(read->nodes, mesh.nodes);
    EXPECT_EQ(read->regions, mesh.regions);
  }
  EXPECT_EQ(ele_file_of(test::quadratic_example()).error().code, ErrorCode::InvalidOption) << "it has quadrilaterals";
}

TEST(NodeEle, MarkersTellTheFirstSideSet) {
  const mesh::ElementMesh mesh = test::example_mesh();
  const NodeFile nodes = node_file_of(mesh);
  std::vector<std::int64_t> expected(mesh.points.size(), 0);
  std::int64_t marker = static_cast<std::int64_t>(mesh.side_sets.size());
  for (auto set = mesh.side_sets.rbegin(); set != mesh.side_sets.rend(); ++set, --marker) {
    for (const mesh::ElementSide& side : set->second) {
      const auto [from, to, middle] = side_nodes(mesh, side);
      expected[from.index()] = expected[to.index()] = marker;
    }
  }
  EXPECT_EQ(nodes.markers, expected);
}

TEST(NodeEle, BadTrianglesAreRefusedWithTheirPlace) {
  const auto nodes = parse_node("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n", "n");
  ASSERT_TRUE(nodes.ok());
  const std::tuple<std::string, std::string, std::string> cases[] = {
      {"1 3 0\n0 0 1 3\n", "e:2:7", "there is no point 3"},
      {"1 4 0\n0 0 1 2 3\n", "e:1:3", "triangles of 4 nodes"},
      {"2 3 0\n0 0 1 2\n", "e:2:0", "ends before triangle 2 of 2"},
      {"1 3 1\n0 0 1 2\n", "e:2:8", "an attribute is missing"},
  };
  for (const auto& [text, place, says] : cases) {
    const auto read = parse_ele(text, "e", *nodes);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(place_text(read.error()), place) << text;
    EXPECT_THAT(read.error().message, HasSubstr(says)) << text;
  }
  // A clockwise triangle is turned.
  EXPECT_EQ(mesh_of(*nodes, *parse_ele("1 3 0\n0 0 2 1\n", "e", *nodes)).nodes,
            (std::vector{mesh::NodeId(0), mesh::NodeId(1), mesh::NodeId(2)}));
}

}  // namespace
}  // namespace dobra::io::meshes
