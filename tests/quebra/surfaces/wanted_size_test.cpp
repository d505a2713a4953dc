// Sizes by formula on surfaces: what is no size is refused with the place, unless it is asked for outside the face.

#include "quebra/surfaces/wanted_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::wanted_size_test {
namespace {

using namespace dobra;
using testing::HasSubstr;

base::Result<model::SurfaceMeshed> meshed(const std::string& text, const std::string& formula) {
  auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  model::SurfaceSet set{.faces = made->faces, .chart_units = {}};
  for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
  return mesh_surfaces(set, {.sizes = {.largest = 2.0}, .size_formula = formula});
}
base::Error refusal(const std::string& text, const std::string& formula) {
  const auto mesh = meshed(text, formula);
  EXPECT_FALSE(mesh.ok()) << formula;
  return mesh ? base::Error{} : mesh.error();
}

TEST(WantedSize, IsRefusedWhereItIsNotPositive) {
  for (const char* const formula : {"-1", "0", "x - 5", "1 - 0.3 * x"}) {
    const base::Error error = refusal(test::plate, formula);
    EXPECT_EQ(error.code, base::ErrorCode::BadValue);
    EXPECT_THAT(error.message, HasSubstr("sizes must be greater than 0")) << formula;
    EXPECT_TRUE(error.place && error.place->x && error.place->u);
  }
}

TEST(WantedSize, IsRefusedWhereItIsNoNumberOrHasNoBound) {
  for (const char* const formula : {"0 / 0", "sqrt(x - 5)", "1 / x"})
    EXPECT_THAT(refusal(test::plate, formula).message, HasSubstr("no finite value")) << formula;
}

TEST(WantedSize, IsRefusedForAHollowInTheMiddleAlone) {
  // Positive on the border, and negative within 3 of the middle.
  const base::Error error = refusal(test::plate, "0.5 * (hypot(x - 5, y - 5) - 3)");
  EXPECT_THAT(error.message, HasSubstr("sizes must be greater than 0"));
  EXPECT_LE(std::hypot(*error.place->x - 5, *error.place->y - 5), 3.0);
}

TEST(WantedSize, MayBeNoSizeInsideAHole) {
  const std::string hole =
      "[[input.trim]]\nname = \"h\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 4\n";
  EXPECT_TRUE(meshed(test::plate + hole, "hypot(x - 5, y - 5) > 3.5 ? 0.5 : -1").ok());
}

TEST(WantedSize, PlacesAreWrittenInDegrees) {
  const base::Error error = refusal(
      "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 180]\nv = [0, 3]\n", "(91 - u) / 100");
  EXPECT_GT(*error.place->u, 91.0);
}

}  // namespace
}  // namespace quebra::surfaces::wanted_size_test
