// Built into threads_test too, for ThreadSanitizer.

#include <gtest/gtest.h>

#include "shared/base/parallel.h"
#include "shared/fem/solve.h"
#include "tests/support/fem_meshes.h"

namespace dobra::fem {
namespace {

TEST(Solve, TheBytesDoNotDependOnTheNumberOfThreads) {
  const mesh::ElementMesh mesh = test::quarter_plate(mesh::ElementType::T6, 40);
  Problem problem{.materials = {{0, {.young = 1000.0, .poisson = 0.3, .thickness = 1.0, .state = PlaneState::Stress}}},
                  .supports = {{.where = "bottom", .normal = 0.0}, {.where = "top", .x = 0.0}}};
  problem.cases[0].sides = {{"right", linear({4, 0}, {1.0, 0.0}, {4, 4}, {1.5, 0.3})}};
  base::set_thread_count(1);
  const Solution one = solve(mesh, problem).value();
  base::set_thread_count(4);
  const Solution four = solve(mesh, problem).value();
  base::set_thread_count(0);
  EXPECT_EQ(one.cases[0].displacements, four.cases[0].displacements);
  EXPECT_EQ(one.cases[0].reactions, four.cases[0].reactions);
}

}  // namespace
}  // namespace dobra::fem
