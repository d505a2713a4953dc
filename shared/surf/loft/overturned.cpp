#include "shared/surf/loft/overturned.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf::loft {

using geom::Point3;
using geom::Vector3;

namespace {

constexpr double rounded = 1e-6;  // of the size

const Point3& at(const Patch& patch, std::size_t i, std::size_t j) { return patch.points[i * patch.v.size() + j]; }

/// Whether triangles look both ways.
bool turns_over(const Patch& patch) {
  double up = 0.0, down = 0.0;
  for (const auto& t : patch.triangles) {
    const double z = geom::cross(patch.points[t[1]] - patch.points[t[0]], patch.points[t[2]] - patch.points[t[0]]).z;
    (z > 0.0 ? up : down) += std::abs(z);
  }
  return std::min(up, down) > rounded * (up + down);
}

/// An end of a line along u over or under which the line lies too.
std::optional<Point3> within_its_line(const Patch& patch, std::size_t j) {
  const std::size_t n = patch.u.size();
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    x += at(patch, i, j).x / static_cast<double>(n);
    y += at(patch, i, j).y / static_cast<double>(n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double dx = at(patch, i, j).x - x, dy = at(patch, i, j).y - y;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
  }
  const double way = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the greatest spread on the map
  const auto along = [&](std::size_t i) {
    return (at(patch, i, j).x - x) * std::cos(way) + (at(patch, i, j).y - y) * std::sin(way);
  };
  double low = along(0), high = low;
  for (std::size_t i = 1; i < n; ++i) low = std::min(low, along(i)), high = std::max(high, along(i));
  const double near = rounded * (high - low);
  for (const std::size_t end : {std::size_t{0}, n - 1}) {
    if (along(end) > low + near && along(end) < high - near) return at(patch, end, j);
  }
  if (std::abs(along(0) - along(n - 1)) <= near) return at(patch, 0, j);
  return std::nullopt;
}

/// Numbers in border_of() at which the sides of the chart begin, and its length.
std::array<std::size_t, 5> sides(const Patch& patch) {
  const std::size_t n = patch.u.size() - 1, m = patch.v.size() - 1;
  return {0, n, n + m, 2 * n + m, 2 * (n + m)};
}

/// Six times the volume between the triangles and a place.
double cone(Point3 from, Point3 a, Point3 b, Point3 c) { return geom::dot(a - from, geom::cross(b - from, c - from)); }

double cones(const Patch& patch, Point3 from) {
  double sum = 0.0;
  for (const auto& t : patch.triangles) sum += cone(from, patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
  return sum;
}

/// Sides of the chart are joined from corner to corner, by parts of their numbers of points.
double side_cones(const Patch& upper, const Patch& lower, Point3 from) {
  const std::vector<Point3> top = border_of(upper), base = border_of(lower);
  const auto top_sides = sides(upper), base_sides = sides(lower);
  double sum = 0.0;
  for (std::size_t side = 0; side < 4; ++side) {
    std::size_t p = top_sides[side], q = base_sides[side];
    const std::size_t p_end = top_sides[side + 1], q_end = base_sides[side + 1];
    while (p < p_end || q < q_end) {
      const Point3 above = top[p % top.size()], below = base[q % base.size()];
      const bool on_top = q == q_end || (p < p_end && (p - top_sides[side]) * (q_end - base_sides[side]) <=
                                                          (q - base_sides[side]) * (p_end - top_sides[side]));
      if (on_top) {
        sum += cone(from, below, top[(p + 1) % top.size()], above);
        ++p;
      } else {
        sum += cone(from, below, base[(q + 1) % base.size()], above);
        ++q;
      }
    }
  }
  return sum;
}

/// Whether corners of both charts lie nearer to each other than to any other corner's.
bool beside(const Patch& upper, const Patch& lower) {
  const auto top = border_of(upper), base = border_of(lower);
  const auto top_sides = sides(upper), base_sides = sides(lower);
  double straight = 0.0;
  std::array<double, 4> others{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Point3 corner = top[top_sides[k]];
    straight += geom::distance(corner, base[base_sides[k]]);
    for (std::size_t turn = 1; turn < 4; ++turn)
      others[turn] += geom::distance(corner, base[base_sides[(k + turn) % 4]]);
    others[0] += geom::distance(corner, base[base_sides[k ^ 1U]]);  // the other way round
  }
  return straight < *std::min_element(others.begin(), others.end());
}

}  // namespace

std::optional<Point3> overturned_end(const NamedSurface& surface) {
  for (const Patch& patch : surface.patches) {
    if (!turns_over(patch)) continue;
    for (std::size_t j = 0; j < patch.v.size(); ++j) {
      if (const auto end = within_its_line(patch, j)) return end;
    }
  }
  return std::nullopt;
}

std::optional<double> closed_volume(const NamedSurface& upper, const NamedSurface& lower) {
  if (upper.patches.size() != lower.patches.size()) return std::nullopt;
  double sum = 0.0;
  for (std::size_t k = 0; k < upper.patches.size(); ++k) {
    const Patch &top = upper.patches[k], &base = lower.patches[k];
    if (top.sections_v.empty() || base.sections_v.empty() || top.sections.front() != base.sections.front() ||
        top.sections.back() != base.sections.back() || !beside(top, base))
      return std::nullopt;
    const Point3 from = top.points.front();
    sum += std::abs(cones(top, from) - cones(base, from) + side_cones(top, base, from)) / 6.0;
  }
  return sum;
}

}  // namespace dobra::surf::loft
