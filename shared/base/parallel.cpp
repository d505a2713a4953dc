#include "shared/base/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <memory>

#ifdef DOBRA_TSAN
#include <sanitizer/tsan_interface.h>
#endif

namespace dobra::base {
namespace {

/// ThreadSanitizer cannot see how oneTBB, which Debian builds without it, orders what happens before, in and after a
/// loop. These two say it. (This file itself is compiled without the sanitizer, because of oneTBB's templates.)
void publish([[maybe_unused]] char& edge) {
#ifdef DOBRA_TSAN
  __tsan_release(&edge);
#endif
}
void receive([[maybe_unused]] char& edge) {
#ifdef DOBRA_TSAN
  __tsan_acquire(&edge);
#endif
}

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body, std::size_t grain) {
  char begun = 0;
  char done = 0;
  publish(begun);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
    receive(begun);
    for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    publish(done);
  });
  receive(done);
}

void set_thread_count(std::size_t threads) {
  static std::unique_ptr<tbb::global_control> control;
  control.reset();
  if (threads > 0) {
    control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
  }
}

}  // namespace dobra::base
