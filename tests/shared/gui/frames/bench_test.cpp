#include "shared/gui/frames/bench.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>

namespace dobra::gui::frames {
namespace {

TEST(Bench, WorksElsewhereAndShowsHere) {
  Bench bench;
  QSignalSpy arrived(&bench, &Bench::arrived);
  const QThread* const here = QThread::currentThread();
  std::vector<int> order;
  std::atomic<int> elsewhere = 0;
  for (int i = 0; i < 50; ++i) {
    bench.post([&, i]() -> std::function<void()> {
      if (QThread::currentThread() != here) ++elsewhere;
      return [&, i] {
        EXPECT_EQ(QThread::currentThread(), here);
        order.push_back(i);
      };
    });
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return order.size() == 50U; }, 5000));
  EXPECT_EQ(elsewhere, 50);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
  EXPECT_TRUE(bench.is_idle());
  EXPECT_LT(arrived.count(), 25);  // a frame for many, not one each
  EXPECT_GE(arrived.count(), 1);
}

TEST(Bench, NothingIsHeardOfWhatWasCleared) {
  Bench bench;
  std::atomic<bool> started = false;
  std::atomic<bool> go = false;
  bool shown = false;
  bench.post([&]() -> std::function<void()> {
    started = true;
    while (!go) QThread::msleep(1);
    return [&] { shown = true; };
  });
  bench.post([&]() -> std::function<void()> { return [&] { shown = true; }; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return started.load(); }, 5000));
  bench.clear();
  go = true;
  bool later = false;
  bench.post([&]() -> std::function<void()> { return [&] { later = true; }; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return later; }, 5000));
  EXPECT_FALSE(shown);
}

TEST(Bench, EndsWithWorkLeft) {
  for (int k = 0; k < 20; ++k) {
    Bench bench;
    for (int i = 0; i < 100; ++i) bench.post([]() -> std::function<void()> { return [] {}; });
    if (k % 2 == 0) QTest::qWait(1);
  }
}

}  // namespace
}  // namespace dobra::gui::frames
