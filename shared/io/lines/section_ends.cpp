#include "shared/io/lines/section_ends.h"

#include <fmt/format.h>

#include <algorithm>

namespace dobra::io::lines {

base::Result<std::pair<std::string, std::string>> ends_of_text(const std::string& text) {
  const auto word = [](std::string part) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    return part;
  };
  const std::size_t dash = std::min(text.find('-'), text.size());
  std::pair ends{word(text.substr(0, dash)), word(text.substr(std::min(dash + 1, text.size())))};
  if (!ends.first.empty() && !ends.second.empty()) return ends;
  return base::Error{base::ErrorCode::BadValue,
                     fmt::format("'{}' needs two ends, such as \"W - E\" or \"SSW - NNE\"", text)};
}

}  // namespace dobra::io::lines
