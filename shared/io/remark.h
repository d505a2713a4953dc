#pragma once
// What a reader did with a file, for the user, and where it stands.

#include <string>

#include "shared/base/error.h"

namespace dobra::io {

struct Remark {
  std::string message;  ///< One line.
  base::Place place;
};

/// "file:line: message".
inline std::string to_string(const Remark& remark) {
  return base::to_string(base::Error{base::ErrorCode::Unclear, remark.message, remark.place});
}

}  // namespace dobra::io
