// Meshes of surfaces in files: the third coordinate, which plane meshes do not have.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"

namespace dobra::io::meshes {
namespace {

using mesh::ElementType;
using mesh::NodeId;
using testing::HasSubstr;

/// A triangle and a quadrilateral that rise along x.
mesh::ElementMesh two() {
  mesh::ElementMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0.5}};
  mesh.first.push_back(0);
  const std::vector<NodeId> quad{NodeId(0), NodeId(1), NodeId(2), NodeId(3)}, triangle{NodeId(1), NodeId(4), NodeId(2)};
  add_element(mesh, ElementType::Q4, quad, 1);
  add_element(mesh, ElementType::T3, triangle, 2);
  mesh.side_sets["low"] = {{mesh::ElementId(0), 0}};
  mesh.node_sets["tip"] = {NodeId(4)};
  return mesh;
}
const std::vector<double> rising{0.25, 1.25, 1.25, 0.25, 2.125};

std::string written(const std::string& ending, const std::vector<double>& heights) {
  const std::string path = (std::filesystem::temp_directory_path() / ("dobra_heights" + ending)).string();
  const auto done = formats::write_mesh(path, two(), InpElement::Shell, heights);
  EXPECT_TRUE(done.ok()) << (done ? "" : to_string(done.error()));
  const std::string text = read_text(path).value();
  std::filesystem::remove(path);
  return text;
}

TEST(Heights, StandInEveryFormatThatHasThem) {
  EXPECT_THAT(written(".vtu", rising), HasSubstr("2.0 0.5 2.125"));
  EXPECT_THAT(written(".msh", rising),
              testing::AllOf(HasSubstr("2.0 0.5 2.125\n"), HasSubstr("0.0 0.0 0.25 1.0 1.0 1.25 1 ")));
  EXPECT_THAT(written(".msh2", rising), HasSubstr("5 2.0 0.5 2.125\n"));
  EXPECT_THAT(written(".inp", rising),
              testing::AllOf(HasSubstr("5, 2.0, 0.5, 2.125"), HasSubstr("TYPE=S4"), HasSubstr("TYPE=S3")));
  EXPECT_THAT(written(".bdf", rising), HasSubstr("GRID    5               2.      .5      2.125"));
  EXPECT_THAT(written(".obj", rising), HasSubstr("v 2.0 0.5 2.125"));
  EXPECT_THAT(written(".ply", rising), HasSubstr("2.0 0.5 2.125"));
  EXPECT_THAT(written(".off", rising), HasSubstr("2.0 0.5 2.125"));
  const std::string stl = written(".stl", rising);
  EXPECT_THAT(stl, HasSubstr("vertex 2.0 0.5 2.125"));
  std::size_t facets = 0;
  for (std::size_t at = stl.find("endfacet"); at != std::string::npos; at = stl.find("endfacet", at + 1)) ++facets;
  EXPECT_EQ(facets, 3U);
}

TEST(Heights, OfNoughtAreThoseOfAPlaneMesh) {
  const std::vector<double> flat(5, 0.0);
  for (const char* const ending : {".obj", ".ply", ".off", ".vtu"})
    EXPECT_EQ(written(ending, flat), written(ending, {})) << ending;
}

TEST(Heights, FormatsWithoutThemAreRefusedByName) {
  for (const char* const path : {"m.nf", "m.node", "m.ele", "m.poly"}) {
    const auto refused = formats::write_mesh(path, two(), InpElement::Shell, rising);
    ASSERT_FALSE(refused.ok()) << path;
    EXPECT_THAT(to_string(refused.error()), HasSubstr(".vtu .msh .msh2 .inp"));
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  std::vector<double> broken = rising;
  broken[2] = std::numeric_limits<double>::quiet_NaN();
  const auto refused = formats::write_mesh("m.vtu", two(), InpElement::Shell, broken);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(to_string(refused.error()), HasSubstr("node 3"));
}

}  // namespace
}  // namespace dobra::io::meshes
