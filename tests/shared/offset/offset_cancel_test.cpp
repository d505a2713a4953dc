// How soon one offset curve of a long rough base gives up when it is asked to: in processor time, so that a busy
// machine does not matter. With a bisector join far mitres cross everything, which is the longest that one distance can
// take.

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <random>
#include <thread>

#include "shared/offset/offset.h"

namespace dobra::offset {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double allowed = 1.0;  // s; sanitizers make the same work take some five times as long
#else
constexpr double allowed = 0.2;
#endif

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// 60 000 points, each far above or below the one before.
geom::Polyline rough_base() {
  std::mt19937 random(7);
  const auto real = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0; };
  geom::Polyline base;
  for (int i = 0; i < 60000; ++i) {
    const double x = 0.05 * i + 3 * real();
    base.points.push_back({x, 20 * real()});
  }
  return base;
}

struct Answer {
  bool cancelled = false;
  double after = 0;  ///< s of processor time.
};
Answer cancelled_after(const geom::Polyline& base, const OffsetOptions& options, std::chrono::milliseconds wait) {
  const base::CancelToken token;
  double asked = 0;
  std::thread user([&] {
    std::this_thread::sleep_for(wait);
    asked = processor_time();
    token.cancel();
  });
  const auto result = offset(base, std::vector<double>{0.5}, options, base::Progress(token, {}));
  const double end = processor_time();
  user.join();
  EXPECT_TRUE(result.ok() || result.error().code == base::ErrorCode::Cancelled);
  return {!result.ok(), end - asked};
}

TEST(OffsetCancel, OneDistanceOfALongRoughBaseAnswersWithinAFifthOfASecond) {
  const geom::Polyline base = rough_base();
  for (const Join join : {Join::Bisector, Join::Mitre, Join::Round}) {
    OffsetOptions options;
    options.join = join;
    std::size_t answered = 0;
    for (const int wait : {0, 20, 60, 120, 250, 500, 900}) {
      const Answer answer = cancelled_after(base, options, std::chrono::milliseconds(wait));
      if (!answer.cancelled) break;  // it was done before
      ++answered;
      EXPECT_LT(answer.after, allowed) << "join " << int(join) << ", asked after " << wait << " ms";
    }
    EXPECT_GE(answered, 2U) << "join " << int(join) << " is done too soon to be cancelled";
  }
}

}  // namespace
}  // namespace dobra::offset
