// libFuzzer target: the reader of SVG outlines. Whatever the bytes: an error with a message and a place, or outlines
// whose pieces follow each other and are finite.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "shared/io/drawings/svg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = dobra::io::drawings::parse_svg(text, "fuzz");
  if (!read.ok()) {
    if (read.error().message.empty() || !read.error().place) std::abort();
    return 0;
  }
  if (read->paths.empty()) std::abort();
  for (const auto& path : read->paths) {
    if (path.pieces.empty() || path.name.empty()) std::abort();
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      const auto& piece = path.pieces[i];
      for (const auto p : {piece.from, piece.to, piece.control[0], piece.control[1], piece.centre}) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) std::abort();
      }
      if (!std::isfinite(piece.sweep) || (i > 0 && path.pieces[i - 1].to != piece.from)) std::abort();
    }
  }
  return 0;
}
