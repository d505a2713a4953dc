// A sheet cut open along shortest ways.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>

#include "shared/base/check.h"
#include "shared/base/disjoint_sets.h"
#include "shared/surf/param/sheet.h"

namespace dobra::surf::param {

using geom::Point3;

namespace {

/// Shortest ways along sides from some points to all others.
struct Ways {
  std::vector<double> length;
  std::vector<HalfEdge> by;  ///< The half-edge, in either direction, that the way to a point ends with.
};

/// The length of every half-edge, as ways count it.
std::vector<double> counted_lengths(const Sheet& sheet, const std::vector<bool>& folded, double beside) {
  const bool some = std::find(folded.begin(), folded.end(), true) != folded.end();
  std::vector<double> lengths(sheet.twins.size());
  for (HalfEdge h = 0; h < lengths.size(); ++h) {
    const double length = geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]);
    lengths[h] = some && !folded[h] ? beside * length : length;
  }
  return lengths;
}

/// Where creases meet or end.
std::vector<bool> crease_corners(const Sheet& sheet, const std::vector<bool>& folded) {
  std::vector<std::uint32_t> creases(sheet.points.size(), 0);
  for (HalfEdge h = 0; h < folded.size(); ++h) creases[sheet.start(h)] += folded[h] ? 1 : 0;
  std::vector<bool> corners(creases.size());
  for (std::size_t v = 0; v < creases.size(); ++v) corners[v] = creases[v] != 0 && creases[v] != 2;
  return corners;
}

Ways ways_from(const Sheet& sheet, const std::vector<double>& lengths, const std::vector<std::uint32_t>& from) {
  const std::size_t n = sheet.points.size();
  std::vector<std::vector<HalfEdge>> out(n);
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    out[sheet.start(h)].push_back(h);
    if (sheet.twins[h] == no_half_edge) out[sheet.end(h)].push_back(h);
  }
  Ways ways{std::vector<double>(n, std::numeric_limits<double>::infinity()), std::vector<HalfEdge>(n, no_half_edge)};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t v : from) {
    ways.length[v] = 0.0;
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > ways.length[v]) continue;
    for (const HalfEdge h : out[v]) {
      const std::uint32_t to = sheet.start(h) == v ? sheet.end(h) : sheet.start(h);
      const double there = length + lengths[h];
      if (there < ways.length[to]) {
        ways.length[to] = there;
        ways.by[to] = h;
        queue.emplace(there, to);
      }
    }
  }
  return ways;
}

class Cutter {
 public:
  Cutter(const Sheet& sheet, const OpenOptions& options)
      : sheet_(sheet),
        folded_(options.crease < 180.0 ? creases_of(sheet, options.crease)
                                       : std::vector<bool>(sheet.twins.size(), false)),
        lengths_(counted_lengths(sheet, folded_, options.beside)),
        corners_(crease_corners(sheet, folded_)),
        corner_from_(options.corner_from),
        cut_(sheet.twins.size(), false) {}

  std::vector<bool> run() {
    if (!sheet_.disk()) find_cut();
    return std::move(cut_);
  }

 private:
  void mark(HalfEdge h) {
    const HalfEdge twin = sheet_.twins[h];
    if (twin == no_half_edge || cut_[h]) return;
    cut_[h] = cut_[twin] = true;
  }
  void mark_way(const Ways& ways, std::uint32_t v) {
    while (ways.by[v] != no_half_edge) {
      const HalfEdge h = ways.by[v];
      mark(h);
      v = sheet_.start(h) == v ? sheet_.end(h) : sheet_.start(h);
    }
  }
  /// A corner of creases where one is far enough.
  [[nodiscard]] std::uint32_t farthest(std::uint32_t from) const {
    const Ways ways = ways_from(sheet_, lengths_, {from});
    const auto all =
        static_cast<std::uint32_t>(std::max_element(ways.length.begin(), ways.length.end()) - ways.length.begin());
    std::uint32_t corner = from;
    for (std::uint32_t v = 0; v < ways.length.size(); ++v) {
      if (corners_[v] && ways.length[v] > ways.length[corner]) corner = v;
    }
    return corner != from && ways.length[corner] >= corner_from_ * ways.length[all] ? corner : all;
  }

  void find_cut() {
    std::vector<std::uint32_t> roots;
    for (const auto& loop : sheet_.loops) roots.insert(roots.end(), loop.begin(), loop.end());
    if (roots.empty()) {
      roots = {farthest(0)};
      if (sheet_.genus() == 0) {
        const Ways ways = ways_from(sheet_, lengths_, roots);
        mark_way(ways, farthest(roots[0]));
        return;
      }
    }
    const Ways ways = ways_from(sheet_, lengths_, roots);
    // Triangles joined over the sides through which the longest ways go; what is left closes the shortest ones.
    std::vector<bool> in_tree(sheet_.twins.size(), false);
    for (const HalfEdge h : ways.by) {
      if (h == no_half_edge) continue;
      in_tree[h] = true;
      if (sheet_.twins[h] != no_half_edge) in_tree[sheet_.twins[h]] = true;
    }
    std::vector<std::pair<double, HalfEdge>> sides;
    for (HalfEdge h = 0; h < sheet_.twins.size(); ++h) {
      if (sheet_.twins[h] == no_half_edge || sheet_.twins[h] < h || in_tree[h]) continue;
      const std::uint32_t a = sheet_.start(h), b = sheet_.end(h);
      sides.emplace_back(-(ways.length[a] + ways.length[b] + lengths_[h]), h);
    }
    std::sort(sides.begin(), sides.end());
    base::DisjointSets joined(sheet_.triangles.size());
    for (const auto& [length, h] : sides) {
      if (joined.root(h / 3) != joined.root(sheet_.twins[h] / 3)) {
        joined.join(h / 3, sheet_.twins[h] / 3);
        continue;
      }
      mark(h);
      mark_way(ways, sheet_.start(h));
      mark_way(ways, sheet_.end(h));
    }
  }

  const Sheet& sheet_;
  const std::vector<bool> folded_;
  const std::vector<double> lengths_;
  const std::vector<bool> corners_;
  const double corner_from_;
  std::vector<bool> cut_;
};

}  // namespace

double loop_length(const Sheet& sheet, const std::vector<std::uint32_t>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += geom::distance(sheet.points[loop[i]], sheet.points[loop[(i + 1) % loop.size()]]);
  return sum;
}

std::size_t longest_loop(const Sheet& sheet) {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < sheet.loops.size(); ++i) {
    const double length = loop_length(sheet, sheet.loops[i]);
    if (length > most) most = length, best = i;
  }
  return best;
}

Sheet filled(const Sheet& sheet) {
  std::vector<Point3> points = sheet.points;
  std::vector<std::array<std::uint32_t, 3>> triangles = sheet.triangles;
  const std::size_t open = longest_loop(sheet);
  for (std::size_t i = 0; i < sheet.loops.size(); ++i) {
    if (i == open) continue;
    const auto& loop = sheet.loops[i];
    const auto middle = static_cast<std::uint32_t>(points.size());
    geom::Vector3 sum;
    for (const std::uint32_t v : loop) sum = sum + (sheet.points[v] - sheet.points[loop[0]]);
    points.push_back(sheet.points[loop[0]] + sum / static_cast<double>(loop.size()));
    for (std::size_t k = 0; k < loop.size(); ++k) triangles.push_back({loop[(k + 1) % loop.size()], loop[k], middle});
  }
  auto made = connect(std::move(points), std::move(triangles));
  DOBRA_CHECK(made.ok());  // each loop passes a vertex once
  return std::move(*made);
}

Sheet quartered(const Sheet& sheet) {
  std::vector<Point3> points = sheet.points;
  std::vector<std::uint32_t> middle(sheet.twins.size());
  for (HalfEdge h = 0; h < middle.size(); ++h) {
    const HalfEdge twin = sheet.twins[h];
    if (twin < h) {
      middle[h] = middle[twin];
      continue;
    }
    middle[h] = static_cast<std::uint32_t>(points.size());
    points.push_back(geom::midpoint(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto& [a, b, c] = sheet.triangles[t];
    const std::uint32_t ab = middle[3 * t], bc = middle[3 * t + 1], ca = middle[3 * t + 2];
    triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  auto made = connect(std::move(points), std::move(triangles));
  DOBRA_CHECK(made.ok());  // of a manifold
  return std::move(*made);
}

std::vector<bool> creases_of(const Sheet& sheet, double degrees) {
  const double least = std::cos(degrees * std::numbers::pi / 180.0);
  const auto normal = [&](HalfEdge h) {
    const auto& [a, b, c] = sheet.triangles[h / 3];
    return cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]);
  };
  std::vector<bool> folded(sheet.twins.size(), false);
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    const HalfEdge twin = sheet.twins[h];
    if (twin == no_half_edge || twin < h) continue;
    const geom::Vector3 m = normal(h), n = normal(twin);
    folded[h] = folded[twin] = dot(m, n) <= least * geom::length(m) * geom::length(n);
  }
  return folded;
}

std::vector<bool> cut_to_disk(const Sheet& sheet, const OpenOptions& options) { return Cutter(sheet, options).run(); }

/// Corners that are joined over sides without a cut are one point.
Opened open_along(const Sheet& sheet, const std::vector<bool>& cut) {
  Opened result;
  const std::size_t corners = sheet.twins.size();
  base::DisjointSets same(corners);
  for (HalfEdge h = 0; h < corners; ++h) {
    const HalfEdge twin = sheet.twins[h];
    if (twin == no_half_edge || cut[h]) continue;
    same.join(h, next(twin));
    same.join(next(h), twin);
  }
  // The first corner of a point keeps its number, so that a sheet without cut stays as it is.
  std::vector<std::uint32_t> number(corners, no_half_edge);
  std::vector<bool> taken(sheet.points.size(), false);
  result.origin.resize(sheet.points.size());
  std::iota(result.origin.begin(), result.origin.end(), 0U);
  std::vector<Point3> points = sheet.points;
  std::vector<std::array<std::uint32_t, 3>> triangles(sheet.triangles.size());
  for (HalfEdge h = 0; h < corners; ++h) {
    const std::uint32_t v = sheet.start(h);
    std::uint32_t& mine = number[same.root(h)];
    if (mine == no_half_edge) {
      mine = v;
      if (taken[v]) {
        mine = static_cast<std::uint32_t>(points.size());
        points.push_back(sheet.points[v]);
        result.origin.push_back(v);
      }
      taken[v] = true;
    }
    triangles[h / 3][h % 3] = mine;
  }
  std::vector<HalfEdge> twins = sheet.twins;
  result.across.assign(corners, no_half_edge);
  for (HalfEdge h = 0; h < corners; ++h) {
    if (!cut[h] || twins[h] == no_half_edge) continue;
    if (h < twins[h]) {
      result.length += geom::distance(sheet.points[sheet.start(h)], sheet.points[sheet.end(h)]);
      ++result.sides;
    }
  }
  for (HalfEdge h = 0; h < corners; ++h) {
    if (cut[h]) std::swap(result.across[h], twins[h]);
  }
  auto connected = connect(std::move(points), std::move(triangles), std::move(twins));
  DOBRA_CHECK(connected.ok());  // a manifold cut along sides is one
  result.sheet = std::move(*connected);
  return result;
}

Opened open(const Sheet& sheet, const OpenOptions& options) { return open_along(sheet, cut_to_disk(sheet, options)); }

}  // namespace dobra::surf::param
