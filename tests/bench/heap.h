#pragma once
// Counts what a benchmark allocates: replaces the global operators, so that exactly one source of a program includes
// it. Peers use the same operators, but are timed only.

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace heap {
inline std::size_t in_use = 0;
inline std::size_t peak = 0;
}  // namespace heap

[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  heap::in_use += malloc_usable_size(memory);
  heap::peak = std::max(heap::peak, heap::in_use);
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  heap::in_use -= malloc_usable_size(memory);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }
