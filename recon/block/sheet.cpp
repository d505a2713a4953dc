#include "recon/block/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "shared/solid/dyadic.h"

// 1. Every cell between two neighbouring points and stations is crossed over two of its edges or none: a plane convex
// cell has two changes of side at most. 2. Cells that share an edge go on in each other. 3. Ends of a closed sheet's
// lines lie on its first or last station; along the line in which the plane meets that, they are inside by turns.

namespace recon::block {
namespace {

using dobra::solid::Dyadic;
using geom::Point3;

/// Edges of cells by number: along the rail of a point, or along a station.
class Grid {
 public:
  explicit Grid(const Sheet& sheet) : sheet_(sheet), points_(sheet.stations[0].size()) {}

  [[nodiscard]] std::size_t columns() const { return sheet_.closed ? points_ : points_ - 1; }
  [[nodiscard]] std::size_t rows() const { return sheet_.stations.size() - 1; }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == points_ ? 0 : i + 1; }
  [[nodiscard]] std::size_t along_rail(std::size_t i, std::size_t row) const { return 2 * (row * points_ + i); }
  [[nodiscard]] std::size_t along_station(std::size_t i, std::size_t row) const { return 2 * (row * points_ + i) + 1; }
  [[nodiscard]] const Point3& point(std::size_t i, std::size_t row) const { return sheet_.stations[row][i]; }

  [[nodiscard]] std::array<Point3, 2> ends(std::size_t edge) const {
    const std::size_t row = edge / 2 / points_;
    const std::size_t i = edge / 2 % points_;
    return edge % 2 == 0 ? std::array{point(i, row), point(i, row + 1)}
                         : std::array{point(i, row), point(next(i), row)};
  }
  /// The station that an edge lies on if it is the first or the last one.
  [[nodiscard]] std::optional<std::size_t> rim(std::size_t edge) const {
    const std::size_t row = edge / 2 / points_;
    if (edge % 2 == 0 || (row != 0 && row != rows())) return std::nullopt;
    return row;
  }

 private:
  const Sheet& sheet_;
  std::size_t points_;
};

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Which crossed edges follow each other.
using Links = std::unordered_map<std::size_t, std::array<std::size_t, 2>>;

void link(Links& links, std::size_t a, std::size_t b) {
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    auto& ways = links.try_emplace(from, std::array{none, none}).first->second;
    ways[ways[0] == none ? 0 : 1] = to;
  }
}

/// Crossed edges in order; closed where the first follows the last.
struct Chain {
  std::vector<std::size_t> edges;
  bool closed = false;
};

std::vector<Chain> chains_of(const Links& links, const std::vector<std::size_t>& order) {
  std::vector<Chain> chains;
  std::unordered_map<std::size_t, bool> used;
  const auto walk = [&](std::size_t start) {
    Chain chain;
    std::size_t before = none;
    for (std::size_t at = start; at != none && !used[at];) {
      used[at] = true;
      chain.edges.push_back(at);
      const auto& ways = links.at(at);
      const std::size_t on = ways[0] == before ? ways[1] : ways[0];
      before = at;
      at = on;
      chain.closed = on == start && chain.edges.size() > 2;
    }
    chains.push_back(std::move(chain));
  };
  for (const bool from_ends : {true, false}) {
    for (const std::size_t edge : order) {
      if (!used[edge] && (!from_ends || links.at(edge)[1] == none)) walk(edge);
    }
  }
  return chains;
}

/// As the points of the sheet follow each other.
void turn(Chain& chain) {
  std::vector<std::size_t>& edges = chain.edges;
  if (chain.closed) std::rotate(edges.begin(), std::min_element(edges.begin(), edges.end()), edges.end());
  if (edges.size() > 2 && edges[chain.closed ? 1 : 0] > edges.back())
    std::reverse(edges.begin() + (chain.closed ? 1 : 0), edges.end());
  if (edges.size() == 2 && edges[0] > edges[1]) std::swap(edges[0], edges[1]);
}

/// Joins the open chains of a closed sheet along its rims to loops.
std::vector<Chain> close_along_rims(std::vector<Chain> chains, const Grid& grid, const PlaneSide& plane) {
  struct End {
    std::size_t chain;
    bool last;
    double along;
  };
  std::array<std::vector<End>, 2> rims;
  std::vector<Chain> loops;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].closed) {
      loops.push_back(chains[i]);
      continue;
    }
    for (const bool last : {false, true}) {
      const std::size_t edge = last ? chains[i].edges.back() : chains[i].edges.front();
      rims[*grid.rim(edge) == 0 ? 0 : 1].push_back({i, last, 0.0});
    }
  }
  std::vector<std::array<std::size_t, 2>> partner(chains.size(), {none, none});  // 2 * chain + end
  for (std::vector<End>& ends : rims) {
    if (ends.empty()) continue;
    const auto place = [&](const End& end) {
      const std::size_t edge = end.last ? chains[end.chain].edges.back() : chains[end.chain].edges.front();
      const auto [a, b] = grid.ends(edge);
      return plane.meet(a, b);
    };
    // All lie on one line: they are sorted along what parts the first from the farthest.
    const Point3 first = place(ends[0]);
    geom::Vector3 direction;
    for (const End& end : ends) {
      if (length(place(end) - first) > length(direction)) direction = place(end) - first;
    }
    for (End& end : ends) end.along = dot(place(end) - first, direction);
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.along < b.along; });
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      partner[ends[i].chain][ends[i].last ? 1 : 0] = 2 * ends[i + 1].chain + (ends[i + 1].last ? 1 : 0);
      partner[ends[i + 1].chain][ends[i + 1].last ? 1 : 0] = 2 * ends[i].chain + (ends[i].last ? 1 : 0);
    }
  }
  std::vector<char> used(chains.size(), 0);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].closed || used[i] != 0) continue;
    Chain loop{{}, true};
    std::size_t at = 2 * i;  // the chain, entered at its first end (even) or at its last (odd)
    while (at != none && used[at / 2] == 0) {
      std::vector<std::size_t> edges = chains[at / 2].edges;
      if (at % 2 == 1) std::reverse(edges.begin(), edges.end());
      loop.edges.insert(loop.edges.end(), edges.begin(), edges.end());
      used[at / 2] = 1;
      at = partner[at / 2][at % 2 == 0 ? 1 : 0];
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

int PlaneSide::sign(Point3 p) const {
  const double value = rough(p);
  const double size =
      std::abs(plane_.a * p.x) + std::abs(plane_.b * p.y) + std::abs(plane_.c * p.z) + std::abs(plane_.d);
  if (std::abs(value) > 0x1p-50 * size) return value > 0.0 ? 1 : -1;
  const Dyadic exact = Dyadic(plane_.a) * Dyadic(p.x) + Dyadic(plane_.b) * Dyadic(p.y) +
                       Dyadic(plane_.c) * Dyadic(p.z) + Dyadic(plane_.d);
  return static_cast<int>(exact.sign());
}

bool PlaneSide::above(Point3 p) const { return sign(p) >= 0; }

Point3 PlaneSide::meet(Point3 a, Point3 b) const {
  if (sign(a) == 0) return a;
  if (sign(b) == 0) return b;
  const double at_a = rough(a);
  const double at_b = rough(b);
  const double part = at_a == at_b ? 0.5 : std::clamp(at_a / (at_a - at_b), 0.0, 1.0);
  const auto between = [&](double u, double v) { return u == v ? u : u + part * (v - u); };
  return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)};
}

std::vector<SheetCut> cut_sheet(const Sheet& sheet, const PlaneSide& plane) {
  const Grid grid(sheet);
  std::vector<std::vector<char>> above;
  for (const auto& station : sheet.stations) {
    auto& row = above.emplace_back();
    for (const Point3 p : station) row.push_back(plane.above(p) ? 1 : 0);
  }
  Links links;
  std::vector<std::size_t> order;
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    for (std::size_t i = 0; i < grid.columns(); ++i) {
      const std::size_t j = grid.next(i);
      const std::array corners{above[row][i], above[row][j], above[row + 1][j], above[row + 1][i]};
      const std::array edges{grid.along_station(i, row), grid.along_rail(j, row), grid.along_station(i, row + 1),
                             grid.along_rail(i, row)};
      std::vector<std::size_t> crossed;
      for (std::size_t k = 0; k < 4; ++k) {
        if (corners[k] != corners[(k + 1) % 4]) crossed.push_back(edges[k]);
      }
      if (crossed.size() != 2) continue;
      link(links, crossed[0], crossed[1]);
      order.insert(order.end(), crossed.begin(), crossed.end());
    }
  }
  std::vector<Chain> chains = chains_of(links, order);
  if (sheet.closed) chains = close_along_rims(std::move(chains), grid, plane);
  std::vector<SheetCut> cuts;
  for (Chain& chain : chains) {
    turn(chain);
    SheetCut cut{{}, chain.closed};
    for (const std::size_t edge : chain.edges) {
      const auto [a, b] = grid.ends(edge);
      cut.points.push_back(plane.meet(a, b));
    }
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

std::optional<Point3> cut_rail(const Rail& rail, const PlaneSide& plane) {
  if (plane.above(rail.from) == plane.above(rail.to)) return std::nullopt;
  return plane.meet(rail.from, rail.to);
}

}  // namespace recon::block
