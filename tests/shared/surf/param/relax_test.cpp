#include "shared/surf/param/relax.h"

#include <gtest/gtest.h>

#include "shared/surf/param/parametrise.h"
#include "tests/support/sheets.h"

namespace dobra::surf::param {
namespace {

using geom::Point;
using geom::Point3;

constexpr double pi = std::numbers::pi;

struct Flattened {
  Sheet sheet;
  std::vector<Point> uv;
  Relaxed relaxed;
};

Flattened relaxed_on_circle(const test::PolygonMesh& mesh, bool cut = false) {
  Sheet sheet = sheet_of(mesh)->sheet;
  if (cut) sheet = open(sheet).sheet;
  std::vector<Point> uv = parametrise(sheet, {.border = BorderShape::Circle})->uv;
  const Relaxed relaxed = relax(sheet, uv, {.steps = 200, .enough = 1e-6}).value();
  return {std::move(sheet), std::move(uv), relaxed};
}

/// The greatest part by which a side is longer or shorter in the chart than in space.
double worst_side(const Flattened& made) {
  double worst = 0.0;
  for (HalfEdge h = 0; h < made.sheet.twins.size(); ++h) {
    const double in_space =
        geom::distance(made.sheet.points[made.sheet.start(h)], made.sheet.points[made.sheet.end(h)]);
    const double in_chart = distance(made.uv[made.sheet.start(h)], made.uv[made.sheet.end(h)]);
    worst = std::max(worst, std::abs(in_chart / in_space - 1.0));
  }
  return worst;
}

TEST(Relax, WhatCanBeUnrolledIsUnrolled) {
  // A plane L, a cylinder of three quarters, and a cone: laid on a circle first, then as long in the chart as in space.
  const auto bent_l = test::grid_mesh(
      16, 16,
      [](double u, double v) {
        return Point3{u, v, 0};
      },
      [](std::uint32_t i, std::uint32_t j) { return i >= 6 && j >= 6; });
  const auto roll = test::shaken_grid(30, 12, 0.5, 3, [](double u, double v) {
    return Point3{std::cos(1.5 * pi * u), std::sin(1.5 * pi * u), 2 * v};
  });
  const auto cone = test::grid_mesh(30, 10, [](double u, double v) {
    const double r = 0.2 + v, a = 1.5 * pi * u;
    return Point3{r * std::cos(a), r * std::sin(a), 2 * r};
  });
  for (const auto& mesh : {bent_l, roll, cone}) {
    const Flattened made = relaxed_on_circle(mesh);
    EXPECT_GT(made.relaxed.energy_before, 4.5);
    // The triangles of the bent ones are plane pieces, which no plane sheet has exactly.
    EXPECT_NEAR(made.relaxed.energy, 4.0, 1e-3);
    EXPECT_LT(worst_side(made), 0.02);
    EXPECT_TRUE(flipped_triangles(made.sheet, made.uv).empty());
    EXPECT_FALSE(borders_cross(made.sheet, made.uv));
  }
}

TEST(Relax, APlaneSheetComesBackToTheDigits) {
  const auto plane = test::shaken_grid(12, 9, 0.6, 5, [](double u, double v) { return Point3{3 * u, v, 0}; });
  const Flattened made = relaxed_on_circle(plane);
  EXPECT_NEAR(made.relaxed.energy, 4.0, 1e-4);
  EXPECT_LT(worst_side(made), 0.02);
}

TEST(Relax, ASphereCannotBeLaidFlatAndItsEnergySaysSo) {
  const Flattened made = relaxed_on_circle(test::half_sphere(12));
  EXPECT_LT(made.relaxed.energy, made.relaxed.energy_before);
  EXPECT_GT(made.relaxed.energy, 4.05);
  EXPECT_TRUE(flipped_triangles(made.sheet, made.uv).empty());
}

TEST(Relax, BordersThatWouldCrossHoldTheStep) {
  // A wide stair that winds twice and a half: laid flat at its true lengths it would lie on itself.
  const auto spiral = test::grid_mesh(90, 3, [](double u, double v) {
    const double a = 5.0 * pi * u, r = 0.4 + v;
    return Point3{r * std::cos(a), r * std::sin(a), 0.02 * a};
  });
  const Flattened made = relaxed_on_circle(spiral);
  EXPECT_TRUE(made.relaxed.held_by_border);
  EXPECT_GT(made.relaxed.energy, 4.01);
  EXPECT_FALSE(borders_cross(made.sheet, made.uv));
  EXPECT_TRUE(flipped_triangles(made.sheet, made.uv).empty());
}

TEST(Relax, ATorusCutOpenKeepsEveryTriangle) {
  const Flattened made = relaxed_on_circle(test::torus_mesh(24, 12), true);
  EXPECT_LT(made.relaxed.energy, 0.7 * made.relaxed.energy_before);
  EXPECT_TRUE(flipped_triangles(made.sheet, made.uv).empty());
  EXPECT_FALSE(borders_cross(made.sheet, made.uv));
}

TEST(Relax, BordersThatCrossAreFound) {
  const auto sheet = sheet_of(test::grid_mesh(2, 1, [](double u, double v) { return Point3{u, v, 0}; }))->sheet;
  std::vector<Point> uv;
  for (const Point3 p : sheet.points) uv.push_back({p.x, p.y});
  EXPECT_FALSE(borders_cross(sheet, uv));
  for (Point& p : uv) {
    if (p.x == 1.0 && p.y == 1.0) p = {0.25, -0.5};
  }
  EXPECT_TRUE(borders_cross(sheet, uv));
}

TEST(Relax, AskedToStopItStops) {
  const Sheet sheet = sheet_of(test::half_sphere(8))->sheet;
  std::vector<Point> uv = parametrise(sheet, {.border = BorderShape::Circle})->uv;
  base::CancelToken token;
  token.cancel();
  const auto made = relax(sheet, uv, {}, base::Progress(token, nullptr));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::surf::param
