// A face taken out of a solid is noticed, whichever it is; whole solids and sheets are not spoken of.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "shared/io/brep/faces.h"
#include "shared/io/faces/import.h"

namespace dobra::io::faces {
namespace {

using testing::HasSubstr;

std::vector<surf::mesh::Finding> told(const brep::Model& model) {
  const auto made = faces_of_model(model);
  EXPECT_TRUE(made.ok()) << base::to_string(made.error());
  std::vector<surf::mesh::Finding> open;
  if (!made) return open;
  for (const surf::mesh::Finding& finding : made->findings) {
    if (finding.code == "solid_open") open.push_back(finding);
  }
  return open;
}

brep::Model file(const std::string& name) {
  return *brep::read_brep(std::string(DOBRA_SOURCE_DIR) + "/tests/shared/io/brep/data/" + name + ".brep");
}

TEST(OpenSolids, WholeFilesHaveNone) {
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(DOBRA_SOURCE_DIR) + "/tests/shared/io/brep/data")) {
    if (entry.path().extension() != ".brep") continue;
    const auto model = brep::read_brep(entry.path().string());
    if (!model || !brep::faces_of(*model)) continue;
    ++files;
    if (entry.path().stem() == "ruled_loft") continue;  // it is open
    EXPECT_TRUE(told(*model).empty()) << entry.path();
  }
  EXPECT_GE(files, 19U);
}

/// Its rectangle has four sides and its rounded rectangle eight: four faces are drawn between them, and nothing between
/// (0, 0, 0) and the last four sides. So OCCT writes it, as a solid.
TEST(OpenSolids, ALoftThatLeavesAHoleIsToldWithItsPlace) {
  const auto found = told(file("ruled_loft"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].message, HasSubstr("of 6 faces, is open: edges that one face has alone: 6;"));
  EXPECT_LT(geom::distance({*found[0].place.x, *found[0].place.y, *found[0].place.z}, {0, 0, 0}), 1e-12);
}

TEST(OpenSolids, EachFaceThatIsTakenOutIsNoticed) {
  // A box with a rounded edge, and a cylinder cut by a box.
  for (const char* name : {"box_fillet", "cut_cylinder"}) {
    const brep::Model whole = file(name);
    std::size_t taken = 0;
    for (std::size_t s = 0; s < whole.shapes.size(); ++s) {
      if (whole.shapes[s].kind != brep::ShapeKind::Shell) continue;
      for (std::size_t k = 0; k < whole.shapes[s].parts.size(); ++k, ++taken) {
        brep::Model open = whole;
        open.shapes[s].parts.erase(open.shapes[s].parts.begin() + static_cast<std::ptrdiff_t>(k));
        const auto found = told(open);
        ASSERT_EQ(found.size(), 1U) << name << ' ' << k;
        EXPECT_THAT(found[0].message, HasSubstr("is open: edges that one face has alone"));
        EXPECT_FALSE(found[0].place.item.empty());
        // The place is a corner of the face that is gone.
        bool corner = false;
        const brep::Use& face = whole.shapes[s].parts[k];
        for (const brep::Use& wire : whole.shapes[face.shape].parts) {
          for (const brep::Use& edge : whole.shapes[wire.shape].parts) {
            for (const brep::Use& vertex : whole.shapes[edge.shape].parts) {
              const auto at = std::get<brep::Vertex>(whole.shapes[vertex.shape].is).at;
              corner = corner || geom::distance(at, {*found[0].place.x, *found[0].place.y, *found[0].place.z}) < 1e-9;
            }
          }
        }
        EXPECT_TRUE(corner) << name << ' ' << k;
      }
    }
    EXPECT_EQ(taken, 9U) << name;
  }
}

TEST(OpenSolids, AShellAloneMayBeOpen) {
  brep::Model model = file("box_fillet");
  for (brep::Shape& shape : model.shapes) {
    if (shape.kind == brep::ShapeKind::Shell) shape.parts.pop_back();
    if (shape.kind == brep::ShapeKind::Solid) shape.kind = brep::ShapeKind::Compound;
  }
  EXPECT_TRUE(told(model).empty());
}

}  // namespace
}  // namespace dobra::io::faces
