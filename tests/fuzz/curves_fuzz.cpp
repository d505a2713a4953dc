// libFuzzer target: the readers of curves. Byte 0 chooses the format, the rest is the file. Whatever the bytes: an
// error with a message, or curves of finite points.

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "shared/io/formats/curves.h"

namespace {

constexpr const char* endings[] = {".txt", ".csv", ".wkt", ".geojson", ".dxf", ".dat", ".tsv", ".json"};

/// One file for the whole run, in memory where the system has such a place.
std::string file_of(const char* ending) {
  static const std::string folder =
      std::filesystem::exists("/dev/shm") ? "/dev/shm" : std::filesystem::temp_directory_path().string();
  return folder + "/dobra_curves_fuzz_" + std::to_string(::getpid()) + ending;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string path = file_of(endings[data[0] % std::size(endings)]);
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return 0;
  std::fwrite(data + 1, 1, size - 1, file);
  std::fclose(file);
  const auto read = dobra::io::formats::read_curves(path);
  std::remove(path.c_str());
  if (!read.ok()) {
    if (read.error().message.empty()) std::abort();
    return 0;
  }
  if (read->curves.empty()) std::abort();
  for (const auto& curve : read->curves) {
    for (const auto p : curve.line.points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) std::abort();
    }
  }
  return 0;
}
