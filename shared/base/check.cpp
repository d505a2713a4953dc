#include "shared/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace dobra::base {

void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: internal error, please report it: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace dobra::base
