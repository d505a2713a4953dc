// How many triangles a face would have, against what meshers make; and refusals within a moment.

#include "quebra/surfaces/expected_triangles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::expected_triangles_test {
namespace {

using namespace dobra;
using testing::HasSubstr;

const std::string ball = "[[input.surface]]\nname = \"s\"\nkind = \"sphere\"\nradius = 2\nv = [-60, 60]\n";
const std::string hole =
    "[[input.trim]]\nname = \"h\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 4\n";

std::string graph(const std::string& formula) {
  return "[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" + formula + "\"\nu = [-1, 1]\nv = [-1, 1]\n";
}
surf::trim::TrimmedSurface face_of(const std::string& text) {
  auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  return made->faces[0];
}

TEST(ExpectedTriangles, AreAboutAsManyAsAreMade) {
  for (const std::string& text : {test::plate, test::plate + hole, ball, graph("sin(3 * x) * y")}) {
    const auto face = face_of(text);
    const surf::mesh::SizeOptions sizes{.largest = 0.2};
    const auto mesh = mesh_surfaces({.faces = {face}, .chart_units = {{1.0, 1.0}}}, {.sizes = sizes});
    ASSERT_TRUE(mesh.ok());
    const double expected = expected_triangles(face, sizes, 64).count;
    const auto made = static_cast<double>(mesh->quality.triangles);
    EXPECT_GT(expected, 0.7 * made) << text;
    EXPECT_LT(expected, 1.3 * made) << text;
  }
}

TEST(ExpectedTriangles, TooManyAreRefusedWithThePlaceOfTheLeast) {
  // 2.3 x 100 / h^2 with h = 2e-4.
  const auto refused = not_too_many(face_of(test::plate), {.largest = 2e-4}, 20'000'000);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::TooManyElements);
  EXPECT_THAT(refused.error().message, HasSubstr("more than 20000000 triangles"));
  EXPECT_TRUE(refused.error().place && refused.error().place->x && refused.error().place->u);
  EXPECT_TRUE(not_too_many(face_of(test::plate), {.largest = 5e-3}, 20'000'000).ok());
}

TEST(ExpectedTriangles, WavesThatTheTurnCannotFollowAreRefused) {
  for (const char* const formula : {"sin(200 * x)", "sin(1000 * x)"})
    EXPECT_FALSE(not_too_many(face_of(graph(formula)), {.largest = 0.1}, 20'000'000).ok()) << formula;
  EXPECT_TRUE(not_too_many(face_of(graph("sin(10 * x)")), {.largest = 0.1}, 20'000'000).ok());
}

}  // namespace
}  // namespace quebra::surfaces::expected_triangles_test
