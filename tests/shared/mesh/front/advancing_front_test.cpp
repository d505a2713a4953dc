#include "shared/mesh/front/advancing_front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "shared/geom/predicates.h"
#include "shared/mesh/delaunay/planar_domain.h"
#include "shared/mesh/front/front_gaps.h"
#include "shared/mesh/front/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;
using Kernel = delaunay::DelaunayKernel;

struct Started {
  delaunay::PlanarDomain domain;
  sizing::SizeField field;
  double area = 0.0;
};

Started start(const delaunay::MeshInput& input, double growth = 1.3) {
  Started started{build_domain(input, delaunay::Outside::Remove, {}).value(),
                  size_field_of(input, {.growth = growth}).value()};
  started.area = area(extract(started.domain, input).mesh);
  return started;
}

double covered(const Kernel& kernel) {
  double sum = 0.0;
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const Kernel::Triangle& cell = kernel.cell(c);
    if (cell.region < 0) continue;
    const Point a = kernel.point(cell.vertex[0]);
    EXPECT_EQ(geom::orient2d(a, kernel.point(cell.vertex[1]), kernel.point(cell.vertex[2])), geom::Sign::Positive);
    sum += 0.5 * geom::cross(kernel.point(cell.vertex[1]) - a, kernel.point(cell.vertex[2]) - a);
  }
  return sum;
}

/// The front that is left of `started`.
Front advanced(Started& started, const FrontalOptions& options = {}) {
  Front front;
  EXPECT_TRUE(test::run_to_end(*advancing_front(started.domain.kernel, started.field, options, front), {}));
  return front;
}

/// Area enclosed by the sides that stand.
double open(const Kernel& kernel, const Front& front) {
  double sum = 0.0;
  for (const FrontSide& side : front.sides) {
    if (side.from == FrontSide::free) continue;
    sum += 0.5 * geom::cross(kernel.point(side.from) - Point{}, kernel.point(front.to(side)) - Point{});
  }
  return sum;
}

TEST(AdvancingFront, TrianglesAndGapsTogetherCoverTheDomain) {
  for (const delaunay::MeshInput& input : {test::square(1.0, 40), test::que_d(), test::que_e(),
                                           test::graded_plate(5'000).input, test::uniform_plate(5'000)}) {
    Started s = start(input);
    const Front front = advanced(s);
    EXPECT_NEAR(covered(s.domain.kernel) + open(s.domain.kernel, front), s.area, 1e-12 * s.area);
  }
}

TEST(AdvancingFront, UniformPlateIsNearlyFilled) {
  Started s = start(test::uniform_plate(20'000));
  const Front front = advanced(s);
  EXPECT_LT(open(s.domain.kernel, front), 0.1 * s.area);
}

TEST(AdvancingFront, BothSidesOfAConstraintAndItsTipsAreReached) {
  delaunay::MeshInput input = test::square(1.0, 20);
  add_chain(input, {{0.5, 0.3}, {0.5, 0.35}, {0.5, 0.4}, {0.5, 0.45}, {0.5, 0.5}, {0.5, 0.55}}, delaunay::Closure::Open,
            {"crack", delaunay::EdgeKind::Constraint});
  input.points.push_back({0.77, 0.23});
  Started s = start(input);
  Kernel& kernel = s.domain.kernel;
  Front front = advanced(s);
  EXPECT_EQ(front.loose.size(), 1U);
  EXPECT_NEAR(covered(kernel) + open(kernel, front), s.area, 1e-12);
  const FrontalOptions options;
  ASSERT_TRUE(test::run_to_end(*gap_filler(kernel, front, s.field, options), {}));
  EXPECT_NEAR(covered(kernel), s.area, 1e-12);
  // Twins are mutual, and every marked side is one that was given.
  std::size_t marked = 0;
  for (Kernel::Half e = 0; e < 4 * kernel.cell_count(); ++e) {
    if ((e & 3U) == 3U) continue;
    ASSERT_NE(kernel.twin(e), Kernel::none);
    EXPECT_EQ(kernel.twin(kernel.twin(e)), e);
    EXPECT_EQ(kernel.mark(e), kernel.mark(kernel.twin(e)));
    EXPECT_EQ(kernel.origin(e), kernel.target(kernel.twin(e)));
    marked += kernel.mark(e) != 0 ? 1U : 0U;
  }
  EXPECT_EQ(marked, 2U * (80U + 5U));
}

/// One line a turn: the generation of the side whose turn it was, and the node that it made, if any.
struct Turn {
  int generation = 0;
  Kernel::Vertex node = Kernel::none;
};
std::vector<Turn> log_of_turns(Started& started, const FrontalOptions& options = {}) {
  Front front;
  const auto engine = advancing_front(started.domain.kernel, started.field, options, front);
  std::vector<Turn> log;
  while (true) {
    const std::size_t before = started.domain.kernel.vertex_count();
    EXPECT_TRUE(engine->step(1, {}));
    if (engine->done()) return log;
    const bool made = started.domain.kernel.vertex_count() > before;
    log.push_back({front.generation, made ? static_cast<Kernel::Vertex>(before) : Kernel::none});
  }
}

TEST(AdvancingFront, SUR_j_OnASquareAllSidesOfALevelAreUsedBeforeAnyOfTheNext) {
  for (const int segments : {25, 32, 60}) {
    Started s = start(test::square(1.0, segments));
    const std::vector<Turn> log = log_of_turns(s);
    EXPECT_EQ(log.front().generation, 0);
    EXPECT_GT(log.back().generation, segments / 2);
    const double height = 0.5 * std::numbers::sqrt3 / segments;
    double deepest = 0.0;
    for (std::size_t i = 1; i < log.size(); ++i) {
      ASSERT_GE(log[i].generation, log[i - 1].generation);
      ASSERT_LE(log[i].generation, log[i - 1].generation + 1);
      if (log[i].node == Kernel::none) continue;
      // What the generations are for: the front moves in layers; where those of two sides of the square meet it lags.
      const Point p = s.domain.kernel.point(log[i].node);
      const double depth = std::min({p.x, p.y, 1.0 - p.x, 1.0 - p.y}) / height;
      EXPECT_GT(depth, deepest - 6.0) << "row " << depth << " after row " << deepest;
      deepest = std::max(deepest, depth);
    }
  }
}

TEST(AdvancingFront, LimitAndCancelEndIt) {
  Started s = start(test::square(1.0, 200));
  FrontalOptions few;
  few.max_triangles = 100;
  Front front;
  EXPECT_EQ(test::run_to_end(*advancing_front(s.domain.kernel, s.field, few, front), {}).error().code,
            base::ErrorCode::TooManyElements);
  Started again = start(test::square(1.0, 20));
  base::CancelToken token;
  token.cancel();
  const FrontalOptions options;
  EXPECT_EQ(test::run_to_end(*advancing_front(again.domain.kernel, again.field, options, front), {token, nullptr})
                .error()
                .code,
            base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::mesh::front
