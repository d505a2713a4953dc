#include "shared/scenario/lines/line_keys.h"

#include <algorithm>

namespace dobra::scenario::lines {

std::vector<FileKind> file_kinds(const std::vector<io::formats::Use>& uses) {
  std::vector<const io::formats::Format*> found;
  for (const io::formats::Use use : uses) {
    for (const io::formats::Format& format : io::formats::all_formats()) {
      const bool known = std::find(found.begin(), found.end(), &format) != found.end();
      if (!known && is_for(format, use)) found.push_back(&format);
    }
  }
  std::vector<FileKind> kinds;
  for (const io::formats::Format* const format : found) kinds.push_back({format->title, format->endings});
  return kinds;
}

}  // namespace dobra::scenario::lines
