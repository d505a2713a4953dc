// Files of one face or a few that were typed by hand, in versions 1 to 3 of the format, with and without the line
// DBRep_DrawableShape. Their areas are closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/io/faces/import.h"
#include "tests/support/meshed_faces.h"

namespace dobra::io::faces {
namespace {

std::string hand_written(const std::string& name) {
  return std::string(DOBRA_SOURCE_DIR) + "/tests/shared/io/faces/data/" + name + ".brep";
}

/// The perimeter of a quarter of an ellipse by summing chords.
double quarter_of_ellipse(double a, double b) {
  double sum = 0.0;
  constexpr int parts = 20000;
  for (int i = 0; i < parts; ++i) {
    const double s = 0.5 * std::numbers::pi * i / parts, t = 0.5 * std::numbers::pi * (i + 1) / parts;
    sum += std::hypot(a * (std::cos(t) - std::cos(s)), b * (std::sin(t) - std::sin(s)));
  }
  return sum;
}

struct HandWritten {
  const char* name;
  std::size_t faces;
  double area;
  int euler;
};

TEST(HandWrittenFiles, AreMeshedWithTheirAreas) {
  const std::vector<HandWritten> all{
      {"bezier_v1", 1, 3.0 * std::numbers::pi, 1},                 // a quarter of a tube, radius 2, height 3
      {"extrusion_v2", 1, 2.0 * quarter_of_ellipse(3.0, 2.0), 1},  // height 2
      {"revolution_v3", 1, std::numbers::pi * (1.5 * std::numbers::pi + 1.0),
       1},                                            // half of the outer upper quarter of a torus
      {"offset_v1", 1, 6.25 * std::sin(0.5), 1},      // 1 radian by half a radian, radius 2.5
      {"trimmed_v2", 1, 12.0 - std::numbers::pi, 0},  // 4 by 3, with a round hole
      {"bspline_v3", 1, 14.0, 1},                     // 2 by 2 and 5 by 2, with a kink
      {"located_v1", 2, 4.0, 2},                      // 2 by 1, twice
      {"periodic_v2", 1, 8.0 * (1.0 + std::asinh(1.0) / std::sqrt(2.0)), 0}  // four parabolas, height 2
  };
  for (const HandWritten& file : all) {
    const auto made = faces_of_file(hand_written(file.name));
    ASSERT_TRUE(made.ok()) << file.name << ": " << base::to_string(made.error());
    EXPECT_EQ(made->refused, 0U) << file.name;
    ASSERT_EQ(made->faces.size(), file.faces) << file.name;
    for (const surf::mesh::Finding& finding : made->findings)
      ADD_FAILURE() << file.name << ": " << finding.code << ' ' << finding.message;
    const support::MeshedFaces mesh = support::mesh_faces(made->faces, 0.25, 5.0);
    ASSERT_FALSE(mesh.refused) << file.name << ": " << base::to_string(*mesh.refused);
    EXPECT_NEAR(mesh.quality.area, file.area, 2e-3 * file.area) << file.name;
    EXPECT_EQ(mesh.quality.euler, file.euler) << file.name;
    EXPECT_GE(mesh.quality.alpha_min, 0.5) << file.name;
    EXPECT_LT(mesh.turned, 10.0) << file.name;
  }
}

TEST(HandWrittenFiles, PlacementsAreComposedAndTheirPowersCount) {
  const auto made = faces_of_file(hand_written("located_v1"));
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->faces.size(), 2U);
  // The first is turned by a quarter, moved by 10 along x and by 3 along z; the second is turned back, moved by 6
  // and 3.
  const surf::trim::TrimmedSurface &one = made->faces[0], &other = made->faces[1];
  EXPECT_NEAR(geom::distance(one.surface.at({2.0, 1.0}), {9.0, 2.0, 3.0}), 0.0, 1e-12);
  EXPECT_NEAR(geom::distance(other.surface.at({2.0, 1.0}), {1.0, 8.0, 9.0}), 0.0, 1e-12);
  EXPECT_FALSE(one.reversed);
  EXPECT_TRUE(other.reversed);
}

TEST(HandWrittenFiles, TriangulationsAreReadOverAndAFaceOfTrianglesAloneIsLeftOut) {
  const auto made = faces_of_file(hand_written("triangulated_v3"));
  ASSERT_TRUE(made.ok()) << base::to_string(made.error());
  ASSERT_EQ(made->faces.size(), 1U);
  EXPECT_EQ(made->refused, 1U);
  ASSERT_EQ(made->findings.size(), 1U);
  EXPECT_EQ(made->findings[0].code, "face_surface");
  EXPECT_EQ(made->findings[0].place.item, "face 2");
  EXPECT_GT(made->findings[0].place.line, 0U);
  const support::MeshedFaces mesh = support::mesh_faces(made->faces, 0.25);
  ASSERT_FALSE(mesh.refused) << base::to_string(*mesh.refused);
  EXPECT_NEAR(mesh.quality.area, 6.0, 1e-9);  // legs 4 and 3; the file's triangles and its sphere count for nothing
}

TEST(HandWrittenFiles, CurvesAloneAreRefused) {
  const auto made = faces_of_file(hand_written("curves_alone_v2"));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::BadFormat);
  ASSERT_TRUE(made.error().place.has_value());
  EXPECT_NE(made.error().place->file.find("curves_alone_v2.brep"), std::string::npos);
}

TEST(HandWrittenFiles, APlaneWithoutBoundsIsRefusedWithItsFace) {
  const auto made = faces_of_file(hand_written("boundless_v1"));
  ASSERT_TRUE(made.ok()) << base::to_string(made.error());
  EXPECT_TRUE(made->faces.empty());
  EXPECT_EQ(made->refused, 1U);
  ASSERT_EQ(made->findings.size(), 1U);
  EXPECT_EQ(made->findings[0].code, "face_endless");
  EXPECT_EQ(made->findings[0].place.item, "face 1");
  EXPECT_GT(made->findings[0].place.line, 0U);
}

}  // namespace
}  // namespace dobra::io::faces
