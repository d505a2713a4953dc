#include "shared/scene/fill.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>

#include "shared/scene/color_map.h"

namespace dobra::scene {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// The outline of equally coloured triangles is what is left of their edges when opposite ones cancel. ---

/// The outline of anticlockwise triangles, as loops whose winding number is that of the triangles together.
class Outline {
 public:
  void add(const Triangle& triangle) {
    for (int k = 0; k < 3; ++k) add_edge(triangle[k], triangle[(k + 1) % 3]);
  }

  std::vector<std::vector<geom::Point>> loops(const std::vector<geom::Point>& points) {
    std::vector<std::vector<geom::Point>> loops;
    while (!next_.empty()) {
      const std::uint32_t start = next_.begin()->first;
      std::vector<geom::Point> loop;
      std::uint32_t at = start;
      do {
        loop.push_back(points[at]);
        at = take_next(at);
      } while (at != start);
      loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  void add_edge(std::uint32_t from, std::uint32_t to) {
    const auto [first, last] = next_.equal_range(to);
    const auto opposite = std::find_if(first, last, [&](const auto& edge) { return edge.second == from; });
    if (opposite != last) {
      next_.erase(opposite);
    } else {
      next_.emplace(from, to);
    }
  }

  std::uint32_t take_next(std::uint32_t from) {
    const auto edge = next_.find(from);
    const std::uint32_t to = edge->second;
    next_.erase(edge);
    return to;
  }

  std::multimap<std::uint32_t, std::uint32_t> next_;  // ordered, so that the same mesh gives the same bytes
};

bool outside(const Mesh& mesh, const Triangle& t, const geom::Box& window) {
  geom::Box box;
  for (const std::uint32_t i : t) box.add(mesh.points[i]);
  return !box.overlaps(window);
}

Triangle anticlockwise(const Mesh& mesh, const Triangle& t) {
  const auto& [a, b, c] = t;
  const double area = geom::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  return area < 0.0 ? Triangle{a, c, b} : t;
}

int level_of(const Scale& scale, double value, int levels) {
  const double fraction = fraction_of(scale, value);
  return std::isnan(fraction) ? -1 : std::min(static_cast<int>(fraction * levels), levels - 1);
}

Color color_of_level(const Scale& scale, int level, int levels) {
  return color_at(scale.map, level < 0 ? std::nan("") : (level + 0.5) / levels);
}

/// The part of a convex polygon of (point, fraction) where side * (fraction - limit) >= 0.
using Corner = std::pair<geom::Point, double>;
std::vector<Corner> clipped(const std::vector<Corner>& polygon, double limit, double side) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double da = side * (a.second - limit);
    const double db = side * (b.second - limit);
    if (da >= 0.0) kept.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
      kept.emplace_back(geom::interpolate(a.first, b.first, da / (da - db)), limit);
    }
  }
  return kept;
}

/// Triangles whose corners are of one level are joined; the others are cut along the levels' borders.
std::vector<ColoredArea> bands_of(const Mesh& mesh, const geom::Box& window, int levels) {
  std::map<int, Outline> whole;
  std::map<int, std::vector<std::vector<geom::Point>>> pieces;
  for (const Triangle& given : mesh.triangles) {
    if (outside(mesh, given, window)) continue;
    const Triangle t = anticlockwise(mesh, given);
    const std::array<int, 3> level{level_of(mesh.scale, mesh.values[t[0]], levels),
                                   level_of(mesh.scale, mesh.values[t[1]], levels),
                                   level_of(mesh.scale, mesh.values[t[2]], levels)};
    const auto [low, high] = std::minmax({level[0], level[1], level[2]});
    if (low == high || low < 0) {
      whole[low].add(t);
      continue;
    }
    // The unclamped fraction: bands end where the scale ends, not at the corners.
    const double width = mesh.scale.high - mesh.scale.low;
    std::vector<Corner> rest;
    for (const std::uint32_t i : t) rest.emplace_back(mesh.points[i], (mesh.values[i] - mesh.scale.low) / width);
    for (int k = low; k <= high && rest.size() >= 3; ++k) {
      const double border = static_cast<double>(k + 1) / levels;
      const std::vector<Corner> band = k == high ? rest : clipped(rest, border, -1.0);
      if (k != high) rest = clipped(rest, border, 1.0);
      if (band.size() < 3) continue;
      std::vector<geom::Point> loop;
      for (const Corner& corner : band) loop.push_back(corner.first);
      pieces[k].push_back(std::move(loop));
    }
  }
  std::map<int, ColoredArea> areas;
  for (auto& [level, outline] : whole) areas[level].loops = outline.loops(mesh.points);
  for (auto& [level, loops] : pieces) {
    auto& all = areas[level].loops;
    all.insert(all.end(), loops.begin(), loops.end());
  }
  std::vector<ColoredArea> list;
  for (auto& [level, area] : areas) {
    area.color = color_of_level(mesh.scale, level, levels);
    list.push_back(std::move(area));
  }
  return list;
}

}  // namespace

std::vector<ColoredArea> areas_of(const Mesh& mesh, const std::optional<Color>& fill, const geom::Box& window,
                                  int levels) {
  if (mesh.values_at == ValuesAt::Points) return bands_of(mesh, window, levels);
  if (mesh.values_at == ValuesAt::None && !fill) return {};
  std::map<int, Outline> outlines;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (outside(mesh, mesh.triangles[i], window)) continue;
    const int level = mesh.values_at == ValuesAt::None ? 0 : level_of(mesh.scale, mesh.values[i], levels);
    outlines[level].add(anticlockwise(mesh, mesh.triangles[i]));
  }
  std::vector<ColoredArea> areas;
  for (auto& [level, outline] : outlines) {
    const Color color = mesh.values_at == ValuesAt::None ? *fill : color_of_level(mesh.scale, level, levels);
    areas.push_back({color, outline.loops(mesh.points)});
  }
  return areas;
}

std::vector<std::vector<std::uint32_t>> edge_chains(const Mesh& mesh) {
  return edge_chains(mesh.triangles, mesh.points.size());
}

std::vector<std::vector<std::uint32_t>> edge_chains(std::span<const Triangle> triangles, std::size_t points) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  // Half-edges at each vertex, in order; a walk takes unused edges until there is none.
  std::vector<std::uint32_t> first(points + 1, 0);
  for (const auto& [a, b] : edges) ++first[a + 1], ++first[b + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
  std::vector<std::uint32_t> edge_of(2 * edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    edge_of[at[edges[e].first]++] = e;
    edge_of[at[edges[e].second]++] = e;
  }
  std::vector<std::uint32_t> cursor(first.begin(), first.end() - 1);
  std::vector<char> used(edges.size(), 0);
  const auto step = [&](std::uint32_t vertex) -> std::optional<std::uint32_t> {
    for (; cursor[vertex] < first[vertex + 1]; ++cursor[vertex]) {
      const std::uint32_t e = edge_of[cursor[vertex]];
      if (used[e]) continue;
      used[e] = 1;
      return edges[e].first == vertex ? edges[e].second : edges[e].first;
    }
    return std::nullopt;
  };
  std::vector<std::vector<std::uint32_t>> chains;
  for (std::uint32_t start = 0; start < points; ++start) {
    while (std::optional<std::uint32_t> next = step(start)) {
      std::vector<std::uint32_t> chain{start};
      for (; next; next = step(*next)) chain.push_back(*next);
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

double mean_edge_length(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  double total = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) total += geom::distance(mesh.points[t[k]], mesh.points[t[(k + 1) % 3]]);
  }
  return total / (3.0 * static_cast<double>(mesh.triangles.size()));
}

double edge_width(double mean_edge, const Style& style, double points_per_world) {
  constexpr double share = 0.06;  // of an edge's length; wider lines darken the colours between them
  constexpr double least = 0.1;
  const double width = std::min(style.line_width, share * mean_edge * points_per_world);
  return width < least ? 0.0 : width;
}

Color stepped_color(const Scale& scale, double value, int levels) {
  return color_of_level(scale, level_of(scale, value, levels), levels);
}

}  // namespace dobra::scene
