#include "shared/solid/warp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace dobra::solid {
namespace {

using geom::Point3;

constexpr std::size_t most_cut_all_ways = 32;

/// The greatest less the least volume between the loop, cut into triangles in every way, and its first corner.
double spread_of_volumes(std::span<const Point3> loop) {
  const std::size_t n = loop.size();
  std::vector<double> least(n * n, 0.0);
  std::vector<double> most(n * n, 0.0);
  const auto six = [&](std::size_t i, std::size_t k, std::size_t j) {
    return dot(loop[i] - loop[0], cross(loop[k] - loop[0], loop[j] - loop[0]));
  };
  // Of the corners from i to j: one triangle stands on the side from j to i, with some corner k between them.
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (std::size_t k = i + 1; k < j; ++k) {
        low = std::min(low, least[i * n + k] + least[k * n + j] + six(i, k, j));
        high = std::max(high, most[i * n + k] + most[k * n + j] + six(i, k, j));
      }
      least[i * n + j] = low;
      most[i * n + j] = high;
    }
  }
  return (most[n - 1] - least[n - 1]) / 6.0;
}

}  // namespace

std::optional<Warp> warp_of(std::span<const Point3> loop, double flat) {
  const std::vector<double> off = mesh::distances_from_mean_plane(loop);
  if (off.empty()) return std::nullopt;
  const auto farthest = static_cast<std::size_t>(
      std::max_element(off.begin(), off.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      off.begin());
  const double distance = std::abs(off[farthest]);
  if (!(distance > flat)) return std::nullopt;
  const auto [low, high] = std::minmax_element(off.begin(), off.end());
  const double volume = loop.size() <= most_cut_all_ways ? spread_of_volumes(loop)
                                                         : length(mesh::newell_area(loop) - Point3{}) * (*high - *low);
  return Warp{distance, loop[farthest], volume};
}

void add_warp(std::optional<WarpedFaces>& all, std::uint32_t face, const Warp& warp) {
  if (!all) all.emplace();
  ++all->count;
  all->volume += warp.volume;
  if (warp.distance <= all->distance) return;
  all->face = face;
  all->distance = warp.distance;
  all->at = warp.at;
}

double diagonal_of(std::span<const Point3> points) {
  if (points.empty()) return 0.0;
  Point3 low = points[0];
  Point3 high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

bool begin_alike(const Space& space, std::vector<std::vector<PointId>>& loops) {
  std::vector<PointId>& outer = loops[0];
  const std::size_t n = outer.size();
  const auto key = [&](std::size_t i) {
    const Point3 at = space.rounded(outer[i]);
    return std::tuple(distance(space.rounded(outer[(i + n - 1) % n]), space.rounded(outer[(i + 1) % n])), at.x, at.y,
                      at.z);
  };
  std::size_t first = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (key(i) < key(first)) first = i;
  }
  std::rotate(outer.begin(), outer.begin() + static_cast<std::ptrdiff_t>(first), outer.end());
  const auto place = [&](PointId p) {
    const Point3 at = space.rounded(p);
    return std::tuple(at.x, at.y, at.z);
  };
  if (place(outer[1]) < place(outer[n - 1])) return false;
  std::reverse(outer.begin() + 1, outer.end());
  for (std::size_t l = 1; l < loops.size(); ++l) std::reverse(loops[l].begin(), loops[l].end());
  return true;
}

}  // namespace dobra::solid
