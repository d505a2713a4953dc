#include "shared/mesh/delaunay/insertion_order.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "shared/geom/box.h"

namespace dobra::mesh::delaunay {

namespace {

constexpr std::uint32_t curve_bits = 20;

/// Position along the Hilbert curve of the cell (x, y) of a 2^20 x 2^20 grid.
std::uint64_t hilbert_position(std::uint32_t x, std::uint32_t y) {
  std::uint64_t position = 0;
  for (std::uint32_t side = 1U << (curve_bits - 1); side > 0; side >>= 1U) {
    const std::uint32_t right = (x & side) != 0 ? 1U : 0U;
    const std::uint32_t upper = (y & side) != 0 ? 1U : 0U;
    position = (position << 2U) | ((3U * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return position;
}

/// A well mixed hash of an index: decides the round of a point, the same on every machine (splitmix64).
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27U)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31U);
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const geom::Point> points) {
  const geom::Box box = geom::box_of(points);
  const double extent = std::max(box.width(), box.height());
  const double scale = extent > 0.0 ? static_cast<double>((1U << curve_bits) - 1U) / extent : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto x = static_cast<std::uint32_t>((points[i].x - box.low.x) * scale);
    const auto y = static_cast<std::uint32_t>((points[i].y - box.low.y) * scale);
    // Each round is eight times as large as the one before: three zero bits of the hash a round.
    const auto earlier = static_cast<std::uint64_t>(std::countr_zero(mixed(i) | (1ULL << 45U)) / 3);
    keys[i] = {((15U - earlier) << 40U) | hilbert_position(x, y), static_cast<std::uint32_t>(i)};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace dobra::mesh::delaunay
