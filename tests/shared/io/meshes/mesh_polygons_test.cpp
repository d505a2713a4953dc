#include "shared/io/meshes/mesh_polygons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "shared/io/formats/mesh_file.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::meshes {
namespace {

using mesh::ElementId;
using mesh::ElementMesh;
using mesh::ElementSide;
using mesh::ElementType;
using mesh::NodeId;
using testing::HasSubstr;

/// A ring of eight squares round an empty one, each a Q8 whose mid-sides are nodes of no corner.
ElementMesh ring(ElementType type) {
  ElementMesh mesh;
  mesh.first.push_back(0);
  std::map<geom::Point, NodeId> known;
  const auto node = [&](double x, double y) {
    const auto [at, is_new] = known.try_emplace({x, y}, NodeId(mesh.points.size()));
    if (is_new) mesh.points.push_back({x, y});
    return at->second;
  };
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) {
      if (i == 1 && j == 1) continue;
      std::vector<NodeId> nodes{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)};
      if (type == ElementType::Q8) {
        for (const NodeId mid : {node(i + 0.5, j), node(i + 1, j + 0.5), node(i + 0.5, j + 1), node(i, j + 0.5)})
          nodes.push_back(mid);
      }
      add_element(mesh, type, nodes, i == 0 ? 1 : 2);
    }
  }
  return mesh;
}

TEST(MeshPolygons, SurfacesHoldCornersOnlyAndKeepQuadrilaterals) {
  const test::TemporaryFolder folder;
  for (const char* ending : {".obj", ".off", ".ply"}) {
    const std::string file = folder.file(std::string("m") + ending);
    const ElementMesh mesh = ring(ElementType::Q8);
    ASSERT_TRUE(formats::write_mesh(file, mesh, InpElement::PlaneStress).ok()) << ending;
    const auto polygons = formats::read_polygons(file);
    ASSERT_TRUE(polygons.ok()) << base::to_string(polygons.error());
    EXPECT_EQ(polygons->points.size(), 16U) << ending;
    EXPECT_EQ(polygons->faces.size(), 8U) << ending;
    EXPECT_TRUE(mesh::check(*polygons, mesh::Closedness::Sheet).empty()) << ending;
    const auto read = formats::read_mesh(file);
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->mesh.element_count(), 8U);
    EXPECT_EQ(area(read->mesh), 8.0);
    EXPECT_THAT(formats::losses(file, mesh), testing::Contains(HasSubstr("corners only")));
  }
}

TEST(MeshPolygons, StlIsReadBackAndTellsWhatItCut) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("m.stl");
  ASSERT_TRUE(formats::write_mesh(file, ring(ElementType::Q4), InpElement::PlaneStress).ok());
  EXPECT_THAT(formats::losses(file, ring(ElementType::Q4)),
              testing::Contains(HasSubstr("8 quadrilaterals are cut in two")));
  const auto read = formats::read_mesh(file);
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->mesh.element_count(), 16U);
  EXPECT_NEAR(area(read->mesh), 8.0, 1e-5);
}

TEST(MeshPolygons, APolyHoldsTheLinesWithAPointInEachHole) {
  const test::TemporaryFolder folder;
  ElementMesh mesh = ring(ElementType::Q8);
  mesh.side_sets["bottom"] = {{ElementId(0), 0}, {ElementId(1), 0}, {ElementId(2), 0}};
  mesh.side_sets["seam"] = {{ElementId(0), 1}};
  ASSERT_TRUE(formats::write_mesh(folder.file("m.poly"), mesh, InpElement::PlaneStress).ok());
  const auto poly = read_poly(folder.file("m.poly"));
  ASSERT_TRUE(poly.ok()) << base::to_string(poly.error());
  EXPECT_EQ(poly->nodes.points.size(), 16U);
  EXPECT_EQ(poly->segments.size(), 12U + 4U + 1U);
  EXPECT_EQ(std::count(poly->segment_markers.begin(), poly->segment_markers.end(), 1), 3);
  EXPECT_EQ(std::count(poly->segment_markers.begin(), poly->segment_markers.end(), 2), 1);
  ASSERT_EQ(poly->holes.size(), 1U);
  EXPECT_TRUE(poly->holes[0].x > 1 && poly->holes[0].x < 2 && poly->holes[0].y > 1 && poly->holes[0].y < 2);
  EXPECT_EQ(poly->regions.size(), 2U);
}

}  // namespace
}  // namespace dobra::io::meshes
