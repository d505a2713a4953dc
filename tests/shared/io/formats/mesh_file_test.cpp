#include "shared/io/formats/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "shared/io/file.h"
#include "shared/io/formats/boundary_file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::formats {
namespace {

using mesh::ElementMesh;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Reverses the corners of an element.
void invert(ElementMesh& mesh, std::size_t element) {
  const auto first = mesh.nodes.begin() + mesh.first[element];
  std::reverse(first + 1, first + static_cast<std::ptrdiff_t>(mesh::corner_count(mesh.types[element])));
}

/// Triangles with their regions, without sets, for formats that hold little.
ElementMesh plain() {
  ElementMesh mesh = test::example_mesh(4);
  mesh.side_sets.clear();
  mesh.node_sets.clear();
  mesh.tips.clear();
  return mesh;
}

/// As every command reads it.
TEST(MeshFile, ABinaryPlyIsReadAsElementsPolygonsAndABoundary) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("m.ply");
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const auto zeros = [](std::size_t count) { return std::string(count, '\0'); };
  const std::string one = std::string("\x3f\x80", 2) + zeros(2);
  bytes += zeros(12) + one + zeros(8) + zeros(4) + one + zeros(4);
  bytes += "\x03" + zeros(4) + zeros(3) + "\x01" + zeros(3) + "\x02";
  ASSERT_TRUE(write_text(file, bytes).ok());
  const auto polygons = read_polygons(file);
  ASSERT_TRUE(polygons.ok()) << to_string(polygons.error());
  const auto boundary = read_boundary(file);
  ASSERT_TRUE(boundary.ok()) << to_string(boundary.error());
  const auto elements = read_mesh(file);
  ASSERT_TRUE(elements.ok()) << to_string(elements.error());
  EXPECT_EQ(polygons->points, (std::vector<geom::Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(boundary->points, polygons->points);
  EXPECT_EQ(elements->mesh.element_count(), 1U);
  for (const std::string empty : {"", " \n"}) {
    ASSERT_TRUE(write_text(file, empty).ok());
    EXPECT_EQ(read_polygons(file).error().code, base::ErrorCode::EmptyFile);
  }
}

TEST(MeshFile, AnInvertedElementIsNamedWithItsNumberAndPlaceInEveryFormatThatTurnsIt) {
  const test::TemporaryFolder folder;
  ElementMesh mesh = plain();
  invert(mesh, 6);
  for (const std::string name : {"m.msh", "m.msh2", "m.inp", "m.bdf", "m.nf", "m.ele"}) {
    ASSERT_TRUE(write_mesh(folder.file(name), mesh, meshes::InpElement::PlaneStress).ok()) << name;
    const auto read = read_mesh(folder.file(name));
    ASSERT_TRUE(read.ok()) << name << base::to_string(read.error());
    EXPECT_TRUE(mesh::check(read->mesh).ok()) << name;
    const auto found = inverted_elements(*read);
    ASSERT_EQ(found.size(), 1U) << name;
    EXPECT_EQ(found[0].place->item, name == "m.ele" ? "element 6 of the file" : "element 7 of the file") << name;
    const auto nodes = mesh.nodes_of(mesh::ElementId(6));
    EXPECT_NEAR(*found[0].place->x, (mesh.point(nodes[0]).x + mesh.point(nodes[1]).x + mesh.point(nodes[2]).x) / 3.0,
                1e-9)
        << name;
    EXPECT_THAT(read->remarks, ElementsAre(HasSubstr("1 of 30 elements run clockwise"))) << name;
  }
}

TEST(MeshFile, AWholeClockwiseMeshOrRegionIsARemarkAndWhatIsAgainstItAFault) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"m.msh2", "m.inp", "m.bdf", "m.nf", "m.ele"}) {
    ElementMesh mesh = plain();
    const auto read_back = [&] {
      EXPECT_TRUE(write_mesh(folder.file(name), mesh, meshes::InpElement::PlaneStress).ok()) << name;
      return read_mesh(folder.file(name)).value();
    };
    EXPECT_THAT(inverted_elements(read_back()), IsEmpty()) << name;
    EXPECT_THAT(read_back().remarks, IsEmpty()) << name;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.regions[e] == 7) invert(mesh, e);
    }
    EXPECT_THAT(inverted_elements(read_back()), IsEmpty()) << name;
    EXPECT_THAT(read_back().remarks, ElementsAre(HasSubstr("elements run clockwise and are turned round"))) << name;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.regions[e] != 7) invert(mesh, e);
    }
    EXPECT_THAT(inverted_elements(read_back()), IsEmpty()) << name;
    invert(mesh, 3);
    const auto found = inverted_elements(read_back());
    ASSERT_EQ(found.size(), 1U) << name;
    EXPECT_THAT(found[0].message, HasSubstr("its corners run anticlockwise, those of most others clockwise"));
  }
}

TEST(MeshFile, NumbersAreThoseOfTheFile) {
  const test::TemporaryFolder folder;
  const std::string text =
      "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 2, 0\n*ELEMENT, TYPE=CPS3\n30, 1, 2, 3\n10, 1, 4, 3\n20, 2, 5, "
      "3\n";
  ASSERT_TRUE(write_file(folder.file("m.inp"), text).ok());
  const auto found = inverted_elements(read_mesh(folder.file("m.inp")).value());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].place->item, "element 10 of the file");
}

}  // namespace
}  // namespace dobra::io::formats
