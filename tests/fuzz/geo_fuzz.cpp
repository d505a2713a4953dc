// libFuzzer target: the reader of gmsh geometry. Whatever the bytes: an error with a message and a line, or a geometry
// whose parts refer to what is there.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "shared/io/drawings/geo.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = dobra::io::drawings::parse_geo(text, "fuzz");
  if (!read.ok()) {
    if (read.error().message.empty() || !read.error().place) std::abort();
    return 0;
  }
  for (const auto& [tag, point] : read->points) {
    if (!std::isfinite(point.at.x) || !std::isfinite(point.at.y) || !std::isfinite(point.size)) std::abort();
  }
  for (const auto& [tag, curve] : read->curves) {
    for (const std::int64_t point : curve.points) {
      if (!read->points.contains(point)) std::abort();
    }
  }
  for (const auto& [tag, loops] : read->surfaces) {
    for (const auto& loop : loops) {
      for (const std::int64_t curve : loop) {
        if (!read->curves.contains(std::abs(curve))) std::abort();
      }
    }
  }
  return 0;
}
