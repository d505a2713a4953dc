#include "shared/scenario/list_text.h"

#include "shared/base/text.h"

namespace dobra::scenario {

std::vector<std::string> parts_of(const std::string& list) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : list) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = std::string(base::trimmed(part));
  return parts;
}

}  // namespace dobra::scenario
