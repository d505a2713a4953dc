#include "shared/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <thread>

namespace dobra::base {
namespace {

class Parallel : public ::testing::Test {
 protected:
  void TearDown() override { set_thread_count(0); }
};

TEST_F(Parallel, EveryIndexIsVisitedOnce) {
  for (const std::size_t grain : {std::size_t{1}, std::size_t{7}, std::size_t{5000}}) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(
        visits.size(), [&](std::size_t i) { ++visits[i]; }, grain);
    for (const auto& count : visits) ASSERT_EQ(count.load(), 1);
  }
  parallel_for(0, [](std::size_t) { FAIL() << "there is nothing to visit"; });
}

TEST_F(Parallel, ResultIsTheSameForAnyNumberOfThreads) {
  const auto values = [](std::size_t threads) {
    set_thread_count(threads);
    return parallel_map<double>(
        5000, [](std::size_t i) { return std::sin(static_cast<double>(i)) / 3.0; }, 16);
  };
  const auto one = values(1);
  EXPECT_EQ(one[5], std::sin(5.0) / 3.0);
  EXPECT_EQ(values(2), one);
  EXPECT_EQ(values(4), one);
  EXPECT_EQ(values(0), one);
}

TEST_F(Parallel, OneThreadMeansTheCallersOnly) {
  set_thread_count(1);
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallel_for(200, [&](std::size_t) {
    const std::scoped_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(threads, (std::set<std::thread::id>{std::this_thread::get_id()}));
}

}  // namespace
}  // namespace dobra::base
