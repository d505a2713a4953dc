#include "shared/io/meshes/polygon_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/ply.h"
#include "tests/shared/io/io_examples.h"

namespace dobra::io::meshes {
namespace {

using base::ErrorCode;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PolygonFile, ObjCornersCountFromOneOrBackwards) {
  const auto mesh = parse_obj("# s\nv 0 0 0\nv 1 0 0.5\nvn 0 0 1\nv 1 1 0\ng part\nf 1/1 2//1 -1\n", "s.obj");
  ASSERT_TRUE(mesh.ok()) << base::to_string(mesh.error());
  EXPECT_EQ(mesh->points[1], (geom::Point3{1, 0, 0.5}));
  ASSERT_EQ(mesh->faces.size(), 1U);
  EXPECT_THAT(mesh->faces[0], ElementsAre(0, 1, 2));
}

TEST(PolygonFile, OffCountsMayStandOnTheFirstLine) {
  for (const char* head : {"OFF\n3 1 0\n", "OFF 3 1 0\n"}) {
    const auto mesh = parse_off(std::string(head) + "0 0 0\n1 0 0\n0 1 2\n3 0 1 2 255 0 0\n", "s.off");
    ASSERT_TRUE(mesh.ok()) << base::to_string(mesh.error());
    EXPECT_EQ(mesh->points[2].z, 2.0);
    EXPECT_THAT(mesh->faces[0], ElementsAre(0, 1, 2));
  }
}

TEST(PolygonFile, FaultsHaveTheirLine) {
  const auto said = [](const auto& read) { return read.ok() ? "" : base::to_string(read.error()); };
  EXPECT_THAT(said(parse_obj("v 0 0 0\nf 1 2 3\n", "s.obj")), HasSubstr("s.obj:2:5"));
  EXPECT_THAT(said(parse_obj("v 0 0 0\nf 1 0 1\n", "s.obj")), HasSubstr("s.obj:2:5"));
  EXPECT_THAT(said(parse_obj("v 0 zero 0\n", "s.obj")), HasSubstr("s.obj:1:5"));
  EXPECT_THAT(said(parse_obj("v 0 0 0\n", "s.obj")), HasSubstr("no face"));
  EXPECT_THAT(said(parse_off("3 1 0\n", "s.off")), HasSubstr("OFF"));
  EXPECT_THAT(said(parse_off("OFF\n1 1 0\n0 0 0\n3 0 0 7\n", "s.off")), HasSubstr("s.off:4:7"));
  EXPECT_THAT(said(parse_off("OFF\n1 1 0\n0 0 0\n9 0 0\n", "s.off")),
              HasSubstr("s.off:4:6: face 1 of 1 has 9 corners, and the line ends after 2"));
  EXPECT_THAT(said(parse_off("OFF\n2 1 0\n0 0 0\n", "s.off")), HasSubstr("point 2 of 2"));
}

TEST(PolygonFile, MoreFacesThanTheHeaderCountsAreRefusedAtTheirLine) {
  const auto said = [](const auto& read) { return read.ok() ? "" : base::to_string(read.error()); };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string ply = said(parse_ply(header + points + "3 0 1 2\n3 1 3 2\n", "s.ply"));
  EXPECT_THAT(ply, HasSubstr("s.ply:15:1"));
  EXPECT_THAT(ply, HasSubstr("counts 4 points and 1 faces"));
  EXPECT_THAT(said(parse_off("OFF\n4 1 0\n" + points + "3 0 1 2\n\n3 1 3 2\n", "s.off")), HasSubstr("s.off:9:1"));
  // Empty lines and comments are no records.
  EXPECT_EQ(said(parse_ply(header + points + "3 0 1 2\n\n", "s.ply")), "");
  EXPECT_EQ(said(parse_off("OFF\n4 1 0\n" + points + "3 0 1 2\n# end\n\n", "s.off")), "");
}

TEST(PolygonFile, OtherEndingsAreRefused) {
  for (const char* const file : {"a.xyz", "a.stl", "a.msh"}) {
    const auto read = formats::read_polygons(file);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::UnknownFormat);
    EXPECT_THAT(read.error().message, HasSubstr("read from .dxf .obj .ply .off .ts .vtp"));
  }
}

}  // namespace
}  // namespace dobra::io::meshes
