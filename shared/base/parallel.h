#pragma once
// Parallel loops whose result does not depend on the number of threads: each index writes only its own slot.
// Nothing is reduced in parallel; sums are taken afterwards, in index order.

#include <cstddef>
#include <functional>
#include <vector>

namespace dobra::base {

/// Calls body(i) once for every i in [0, count), in any order and on any thread.
/// `body` may write only to slot i of what it fills, and must not throw.
/// @cost One task per `grain` indices.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body, std::size_t grain = 1);

/// The values f(0) .. f(count-1), in that order whatever the number of threads.
template <class T, class Function>
std::vector<T> parallel_map(std::size_t count, Function&& f, std::size_t grain = 1) {
  std::vector<T> values(count);
  parallel_for(
      count, [&](std::size_t i) { values[i] = f(i); }, grain);
  return values;
}

/// Upper bound on the threads used by parallel loops from now on; 0 takes all cores. Call before any work starts.
void set_thread_count(std::size_t threads);

}  // namespace dobra::base
