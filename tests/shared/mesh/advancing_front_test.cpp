#include "shared/mesh/advancing_front.h"

#include <gtest/gtest.h>

#include <map>

#include "shared/geom/predicates.h"
#include "shared/mesh/front_gaps.h"
#include "shared/mesh/planar_domain.h"
#include "shared/mesh/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh {
namespace {

using geom::Point;
using Kernel = DelaunayKernel;

struct Started {
  PlanarDomain domain;
  SizeField field;
  double area = 0.0;
};

Started start(const MeshInput& input, double growth = 1.3) {
  Started started{build_domain(input, Outside::Remove, {}).value(), size_field_of(input, {.growth = growth}).value()};
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
  for (const MeshInput& input : {test::square(1.0, 40), test::que_d(), test::que_e(), test::graded_plate(5'000).input,
                                 test::uniform_plate(5'000)}) {
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
  MeshInput input = test::square(1.0, 20);
  add_chain(input, {{0.5, 0.3}, {0.5, 0.35}, {0.5, 0.4}, {0.5, 0.45}, {0.5, 0.5}, {0.5, 0.55}}, Closure::Open,
            {"crack", EdgeKind::Constraint});
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
}  // namespace dobra::mesh
