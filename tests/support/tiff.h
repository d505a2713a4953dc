#pragma once
// The smallest picture files that GDAL reads.

#include <cstdint>
#include <string>

namespace dobra::test {

/// A TIFF of 8 bits a channel, uncompressed, of one strip.
inline std::string tiff(std::uint32_t width, std::uint32_t height, std::uint32_t channels, const std::string& pixels) {
  std::string bytes("II*\0\0\0\0\0", 8);
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 255U);
  };
  const std::size_t data = bytes.size();
  bytes += pixels;
  if (bytes.size() % 2 == 1) bytes += '\0';
  const std::size_t depths = bytes.size();
  for (std::uint32_t i = 0; i < channels; ++i) put(8, 2);
  const std::size_t directory = bytes.size();
  const auto tag = [&](std::uint32_t number, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    put(number, 2);
    put(type, 2);
    put(count, 4);
    put(value, 4);
  };
  put(9, 2);
  tag(256, 4, 1, width);
  tag(257, 4, 1, height);
  tag(258, 3, channels, channels > 2 ? static_cast<std::uint32_t>(depths) : 8);
  tag(259, 3, 1, 1);
  tag(262, 3, 1, channels > 2 ? 2 : 1);
  tag(273, 4, 1, static_cast<std::uint32_t>(data));
  tag(277, 3, 1, channels);
  tag(278, 4, 1, height);
  tag(279, 4, 1, static_cast<std::uint32_t>(pixels.size()));
  put(0, 4);
  for (int i = 0; i < 4; ++i) bytes[4 + static_cast<std::size_t>(i)] = static_cast<char>(directory >> (8 * i) & 255U);
  return bytes;
}

}  // namespace dobra::test
