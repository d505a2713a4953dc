// What stands in for a surface of many triangles while the view moves.
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "shared/scene/space/pick.h"

namespace dobra::scene::space {

namespace {

using geom::Point3;

/// The cell of each point, in the order in which they are met.
std::vector<std::uint32_t> cells_of(const std::vector<Point3>& points, const geom::Box3& box, double cell) {
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> cells(points.size());
  const auto step = [cell](double from, double low) {
    return static_cast<std::uint64_t>(std::clamp((from - low) / cell, 0.0, 2.0e6));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    const std::uint64_t key = geom::is_finite(p)
                                  ? step(p.x, box.low.x) | step(p.y, box.low.y) << 21U | step(p.z, box.low.z) << 42U
                                  : ~std::uint64_t{0};
    cells[i] = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
  }
  return cells;
}

/// The triangles that have not shrunk to a line or a point; of those between the same cells the first.
std::vector<std::uint32_t> kept(const Surface& surface, const std::vector<std::uint32_t>& cells) {
  std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> keys;
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    std::array<std::uint32_t, 3> key{cells[t[0]], cells[t[1]], cells[t[2]]};
    std::sort(key.begin(), key.end());
    if (key[0] != key[1] && key[1] != key[2]) keys.emplace_back(key, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].first != keys[i - 1].first) triangles.push_back(keys[i].second);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Surface made_of(const Surface& surface, const std::vector<std::uint32_t>& cells,
                const std::vector<std::uint32_t>& triangles) {
  const std::size_t count = cells.empty() ? 0 : *std::max_element(cells.begin(), cells.end()) + std::size_t{1};
  std::vector<geom::Vector3> sum(count);
  std::vector<double> number(count, 0.0);
  std::vector<double> value(count, 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!geom::is_finite(surface.points[i])) continue;
    sum[cells[i]] = sum[cells[i]] + (surface.points[i] - Point3{});
    number[cells[i]] += 1.0;
    if (surface.values_at == ValuesAt::Points) value[cells[i]] += surface.values[i];
  }
  std::vector<Point3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = Point3{} + sum[i] / std::max(number[i], 1.0);
    value[i] /= std::max(number[i], 1.0);
  }
  Surface made;
  made.values_at = surface.values_at;
  made.scale = surface.scale;
  made.points = std::move(points);
  if (surface.values_at == ValuesAt::Points) made.values = std::move(value);
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<double> values;
  std::vector<Color> colors;
  for (const std::uint32_t i : triangles) {
    const auto& t = surface.triangles[i];
    corners.push_back({cells[t[0]], cells[t[1]], cells[t[2]]});
    if (surface.values_at == ValuesAt::Triangles) values.push_back(surface.values[i]);
    if (!surface.colors.empty()) colors.push_back(surface.colors[i]);
  }
  made.triangles = std::move(corners);
  if (surface.values_at == ValuesAt::Triangles) made.values = std::move(values);
  made.colors = std::move(colors);
  return made;
}

}  // namespace

Surface thinned(const Surface& surface, std::size_t most) {
  if (surface.triangles.size() <= most) return surface;
  geom::Box3 box;
  for (const Point3& p : surface.points) {
    if (geom::is_finite(p)) box.add(p);
  }
  constexpr double coarser = 1.4;
  double cell = 0.7 * box.diagonal() / std::sqrt(static_cast<double>(std::max<std::size_t>(most, 1)));
  for (;; cell *= coarser) {
    const std::vector<std::uint32_t> cells = cells_of(surface.points, box, cell);
    const std::vector<std::uint32_t> triangles = kept(surface, cells);
    if (triangles.size() <= most) return made_of(surface, cells, triangles);
  }
}

}  // namespace dobra::scene::space
