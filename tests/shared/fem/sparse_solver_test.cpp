#include "shared/fem/sparse_solver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace dobra::fem {
namespace {

/// A chain of n springs of stiffness 1; the first node held or not.
SymmetricMatrix chain(std::size_t n, bool held) {
  SymmetricMatrix matrix{n, {}, {}, {}};
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    matrix.rows.push_back(static_cast<std::int32_t>(i + 1));
    matrix.columns.push_back(static_cast<std::int32_t>(j + 1));
    matrix.values.push_back(value);
  };
  if (held) add(0, 0, 1.0);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    add(i, i, 1.0);
    add(i + 1, i + 1, 1.0);
    add(i + 1, i, -1.0);
  }
  return matrix;
}

TEST(SparseSolver, SeveralRightSidesAreSolvedWithOneFactorisation) {
  constexpr std::size_t n = 200;
  auto factors = Factorisation::make(chain(n, true)).value();
  std::vector<double> b(2 * n, 0.0);
  b[n - 1] = 1.0;                          // a pull at the end: every spring stretches by 1
  std::fill(b.begin() + n, b.end(), 1.0);  // each node pulled: node i feels the n - i of those beyond
  ASSERT_TRUE(factors.solve(b, 2).ok());
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(b[i], static_cast<double>(i + 1), 1e-9);
    sum += static_cast<double>(n - i);
    EXPECT_NEAR(b[n + i], sum, 1e-9 * sum);
  }
  EXPECT_EQ(factors.statistics().unknowns, n);
  EXPECT_GT(factors.statistics().memory_estimate, 0.0);
}

TEST(SparseSolver, ASingularMatrixIsAnError) {
  const auto factors = Factorisation::make(chain(50, false));
  ASSERT_FALSE(factors.ok());
  EXPECT_EQ(factors.error().code, base::ErrorCode::CannotSolve);
  EXPECT_THAT(factors.error().message, testing::HasSubstr("singular"));
}

TEST(SparseSolver, WhatDoesNotFitIsRefusedBeforeItIsFactorised) {
  const auto factors = Factorisation::make(chain(50, true), {.memory_limit = 100.0});
  ASSERT_FALSE(factors.ok());
  EXPECT_THAT(factors.error().message, testing::HasSubstr("50 unknowns need about"));
}

}  // namespace
}  // namespace dobra::fem
