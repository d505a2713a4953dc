#pragma once
// CHECK guards promises between parts of this code. What the user's data can cause is a Result, not a CHECK.

namespace dobra::base {

/// Prints the broken promise with its place and aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace dobra::base

/// Always on, in release builds too.
#define DOBRA_CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::dobra::base::check_failed(#condition, __FILE__, __LINE__))
