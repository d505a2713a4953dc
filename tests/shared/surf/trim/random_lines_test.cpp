// Charts full of random lines: faces fill the chart, and each lies on one side of every closed line.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/open.h"
#include "tests/shared/surf/surface_shapes.h"
#include "tests/shared/surf/trim/chart_checks.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using geom::Vector;
using namespace surf::test;

struct Ellipse {
  Point middle;
  Vector along, across;
  [[nodiscard]] bool holds(Point p) const {
    const Vector d = p - middle;
    const double area = cross(along, across);
    return std::hypot(cross(d, across) / area, cross(along, d) / area) < 1.0;
  }
};

TEST(RandomLines, FacesFillTheChartAndLieOnOneSideOfEveryEllipse) {
  const char* const asked = std::getenv("DOBRA_RANDOM_CASES");
  const int cases = asked ? std::atoi(asked) : 60;
  int faces = 0, refused = 0, points = 0, unlike = 0, sharp = 0;
  for (int seed = 0; seed < cases; ++seed) {
    Chance chance{std::mt19937(static_cast<unsigned>(seed + 1))};
    // Every second chart is closed along u: ellipses go over its seam.
    const bool pipe = seed % 2 == 1;
    const Surface surface =
        pipe ? *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 6}}) : *Surface::plane({}, {{0, 0}, {2 * pi, 6}});
    std::vector<TrimLine> lines;
    std::vector<Ellipse> ellipses;
    const int count = 1 + static_cast<int>(chance.random() % 5);
    for (int i = 0; i < count; ++i) {
      const double a = chance(0.2, 1.2), b = chance(0.2, 1.2), turn = chance(0, pi);
      Ellipse e{{chance(pipe ? -1.0 : 1.3, pipe ? 7.0 : 5.0), chance(1.3, 4.7)},
                {a * std::cos(turn), a * std::sin(turn)},
                {-b * std::sin(turn), b * std::cos(turn)}};
      const double from = chance(0, 6);
      const Curve curve = *Curve::ellipse({e.middle.x, e.middle.y, 0}, {e.along.x, e.along.y, 0},
                                          {e.across.x, e.across.y, 0}, from, from + 2 * pi);
      lines.push_back({{{{.curve = curve, .from = from, .to = from + 2 * pi}}}, true});
      ellipses.push_back(e);
    }
    const int open_count = static_cast<int>(chance.random() % 5);
    for (int i = 0; i < open_count; ++i) {
      std::vector<geom::Point3> through;
      for (int k = 0; k < 4; ++k) through.push_back({chance(0.8, 5.4), chance(0.8, 5.2), 0});
      const Curve spline = i % 2 ? *Curve::through(through) : *Curve::polyline(through);
      lines.push_back({{{{.curve = spline, .from = spline.low(), .to = spline.high()}}}, false, i % 3 != 2});
    }
    const auto found = recognise(surface, lines);
    if (!found.ok()) {
      // A spline may leave the chart, and once in hundreds turn back so sharply that its legs cannot be told apart.
      if (found.error().code == base::ErrorCode::CannotMesh) ++sharp;
      EXPECT_TRUE(found.error().place && found.error().place->u) << seed << found.error().message;
      EXPECT_TRUE(found.error().code == base::ErrorCode::CannotMesh ||
                  found.error().code == base::ErrorCode::OutsideDomain)
          << seed << found.error().message;
      ++refused;
      continue;
    }
    double area = 0.0;
    for (const TrimmedSurface& face : found->faces()) {
      area += chart_area(face);
      check_loops(face);
      ++faces;
    }
    EXPECT_NEAR(area, 12 * pi, 1e-6) << seed;
    std::vector<std::vector<Point>> of(found->faces().size());
    for (int i = 0; i < 60; ++i) {
      const Point p{chance(0, 2 * pi), chance(0, 6)};
      const auto face = found->pick(p);
      if (!face.ok()) continue;
      of[*face].push_back(p);
      if (!contains(found->faces()[*face], p)) ++unlike;  // it may be, beside an edge
      ++points;
    }
    for (std::size_t f = 0; f < of.size(); ++f) {
      for (const Point p : of[f]) {
        for (const Ellipse& e : ellipses) {
          const auto holds = [&](Point q) {
            return e.holds(q) || (pipe && (e.holds(q + Vector{2 * pi, 0}) || e.holds(q - Vector{2 * pi, 0})));
          };
          EXPECT_EQ(holds(p), holds(of[f].front())) << seed << p;
        }
      }
    }
  }
  EXPECT_GT(faces, 3 * cases);
  EXPECT_GT(points, 30 * cases);
  EXPECT_LT(refused, cases / 3);
  EXPECT_LE(sharp, cases / 300);
  EXPECT_LE(unlike, points / 2000);
  if (asked)
    printf("%d charts, %d faces, %d points, %d refused, %d of them for sharp turns\n", cases, faces, points, refused,
           sharp);
}

}  // namespace
}  // namespace dobra::surf::trim
