// Built into threads_test too, for ThreadSanitizer.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/base/parallel.h"
#include "shared/offset/offset.h"

namespace dobra::offset {
namespace {

TEST(Offset, SameBytesWithAnyNumberOfThreads) {
  geom::Polyline base;
  for (int i = 0; i <= 128; ++i) {
    const double x = 4 * std::numbers::pi * i / 128;
    base.points.push_back({x, -std::cos(x)});
  }
  const std::vector<double> d = distances({13, 0.2, 1.0}).value();
  base::set_thread_count(1);
  const auto one = offset(base, d, {}).value();
  base::set_thread_count(0);
  const auto many = offset(base, d, {}).value();
  for (std::size_t k = 0; k < d.size(); ++k) EXPECT_EQ(one[k].pieces.at(0).points, many[k].pieces.at(0).points);
}

}  // namespace
}  // namespace dobra::offset
