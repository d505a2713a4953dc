// 1. Nodes of each lattice: from those on lines of sections, then the borders, then the rest, over neighbours that are
//    near. Triangles with two corners in one node go.
// 2. Between crossing sections: border nodes of several patches that are at one place are one node; a border side on
//    which another patch has nodes is parted at them, its triangle into a fan.
// 3. A triangle without a height has a corner on its longest side: that side is turned to the other diagonal.
// 4. Nodes of no triangle go.
#include "shared/surf/loft/joined.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace dobra::surf::loft {

using geom::Point3;
using geom::Vector3;

namespace {

constexpr double one_node = 1e-6;   // of the size
constexpr double no_height = 1e-8;  // of the size
constexpr std::uint32_t no_node = 0xffffffffU;

using MeshTriangle = std::array<std::uint32_t, 3>;
using MeshSide = std::array<std::uint32_t, 2>;

/// A side of one triangle, as that runs round it.
struct BorderSide {
  MeshSide side{};
  std::size_t triangle = 0;
};

std::uint64_t directed(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32U) | b; }
std::uint64_t side_of(std::uint32_t a, std::uint32_t b) { return directed(std::min(a, b), std::max(a, b)); }

/// The node of each point of a lattice: the number of the point that stands for it.
class LatticeNodes {
 public:
  LatticeNodes(const Patch& patch, double near) : patch_(patch), near_(near), node_(patch.points.size(), no_node) {}

  std::vector<std::uint32_t> run() {
    const std::size_t rows = patch_.v.size(), columns = patch_.u.size();
    for (const int wanted : {0, 1, 2}) {
      for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
          if (rank(i, j) == wanted) take(static_cast<std::uint32_t>(i * rows + j));
        }
      }
    }
    return std::move(node_);
  }

 private:
  [[nodiscard]] int rank(std::size_t i, std::size_t j) const {
    const bool low = j == 0 || j + 1 == patch_.v.size(), side = i == 0 || i + 1 == patch_.u.size();
    const auto& lines = patch_.sections_v;
    const bool line = lines.empty() ? low || side : std::find(lines.begin(), lines.end(), patch_.v[j]) != lines.end();
    if (line) return 0;
    return low || side ? 1 : 2;
  }

  /// The point stands for itself and for the neighbours that are near to it.
  void take(std::uint32_t from) {
    if (node_[from] != no_node) return;
    const auto row = static_cast<std::uint32_t>(patch_.v.size());
    node_[from] = from;
    std::vector<std::uint32_t> open{from};
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      const auto ask = [&](std::uint32_t next) {
        if (node_[next] != no_node || geom::distance(patch_.points[next], patch_.points[from]) > near_) return;
        node_[next] = from;
        open.push_back(next);
      };
      if (at % row > 0) ask(at - 1);
      if (at % row + 1 < row) ask(at + 1);
      if (at >= row) ask(at - row);
      if (at + row < patch_.points.size()) ask(at + row);
    }
  }

  const Patch& patch_;
  double near_;
  std::vector<std::uint32_t> node_;
};

class Joining {
 public:
  explicit Joining(double size) : near_(one_node * size), thin_(no_height * size) {}

  JoinedMesh run(const NamedSurface& surface) {
    const bool crossing =
        surface.patches.size() > 1 && std::any_of(surface.patches.begin(), surface.patches.end(),
                                                  [](const Patch& patch) { return patch.sections_v.empty(); });
    for (const Patch& patch : surface.patches) {
      const std::size_t first = triangles_.size();
      add(patch);
      if (crossing) add_border(first);
    }
    if (crossing) {
      join();
      part_sides();
    }
    turn_thin();
    return used();
  }

 private:
  // Step 1.
  void add(const Patch& patch) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), patch.points.begin(), patch.points.end());
    const std::vector<std::uint32_t> node = LatticeNodes(patch, near_).run();
    std::vector<MeshTriangle> own;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> alike;  // by the first two of their corners in order
    for (const auto& t : patch.triangles) {
      const MeshTriangle at{node[t[0]], node[t[1]], node[t[2]]};
      if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
      own.push_back({at[0] + first, at[1] + first, at[2] + first});
    }
    // What was folded flat on itself, as points came together, has no place.
    bool folds = false;
    for (std::size_t i = 0; i < node.size(); ++i) folds = folds || node[i] != i;
    std::vector<bool> gone(own.size(), false);
    for (std::size_t k = 0; folds && k < own.size(); ++k) {
      MeshTriangle sorted = own[k];
      std::sort(sorted.begin(), sorted.end());
      auto& others = alike[directed(sorted[0], sorted[1])];
      const auto same = std::find_if(others.begin(), others.end(), [&](std::size_t other) {
        MeshTriangle its = own[other];
        std::sort(its.begin(), its.end());
        return !gone[other] && its == sorted;
      });
      if (same == others.end()) {
        others.push_back(k);
      } else {
        gone[*same] = gone[k] = true;
      }
    }
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (gone[k]) continue;
      triangles_.push_back(own[k]);
    }
  }

  /// Sides of one triangle of a patch.
  /// @param first  its first triangle
  void add_border(std::size_t first) {
    std::vector<std::pair<std::uint64_t, BorderSide>> all;
    for (std::size_t i = first; i < triangles_.size(); ++i) {
      const MeshTriangle& t = triangles_[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const MeshSide side{t[k], t[(k + 1) % 3]};
        all.push_back({side_of(side[0], side[1]), {side, i}});
      }
    }
    borders_.push_back(once(std::move(all)));
  }

  /// Those whose key no other has.
  static std::vector<BorderSide> once(std::vector<std::pair<std::uint64_t, BorderSide>> all) {
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second.triangle) < std::tie(b.first, b.second.triangle);
    });
    std::vector<BorderSide> sides;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool before = i > 0 && all[i - 1].first == all[i].first;
      const bool behind = i + 1 < all.size() && all[i + 1].first == all[i].first;
      if (!before && !behind) sides.push_back(all[i].second);
    }
    return sides;
  }

  // Step 2.
  void join() {
    struct Taken {
      std::uint32_t node = 0;
      std::size_t last_patch = 0;
    };
    std::vector<Taken> taken;  // by x
    const auto before = [&](const Taken& a, double x) { return points_[a.node].x < x; };
    std::vector<std::uint32_t> same(points_.size());
    for (std::uint32_t i = 0; i < same.size(); ++i) same[i] = i;
    const auto by_x = [&](const Taken& a, const Taken& b) { return points_[a.node].x < points_[b.node].x; };
    for (std::size_t patch = 0; patch < borders_.size(); ++patch) {
      std::vector<std::uint32_t> nodes;
      for (const BorderSide& of : borders_[patch]) nodes.push_back(of.side[0]);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      std::vector<Taken> fresh;
      for (const std::uint32_t node : nodes) {
        Taken* nearest = nullptr;
        double least = near_;
        for (auto at = std::lower_bound(taken.begin(), taken.end(), points_[node].x - near_, before);
             at != taken.end() && points_[at->node].x <= points_[node].x + near_; ++at) {
          const double away = geom::distance(points_[at->node], points_[node]);
          if (away <= least && at->last_patch != patch) least = away, nearest = &*at;
        }
        if (nearest == nullptr) {
          fresh.push_back({node, patch});
        } else {
          same[node] = nearest->node;
          nearest->last_patch = patch;
        }
      }
      std::sort(fresh.begin(), fresh.end(), by_x);
      const auto known = static_cast<std::ptrdiff_t>(taken.size());
      taken.insert(taken.end(), fresh.begin(), fresh.end());
      std::inplace_merge(taken.begin(), taken.begin() + known, taken.end(), by_x);
    }
    for (auto& border : borders_) {
      for (BorderSide& of : border) of.side = {same[of.side[0]], same[of.side[1]]};
    }
    for (MeshTriangle& t : triangles_) {
      for (std::uint32_t& corner : t) corner = same[corner];
    }
  }

  void part_sides() {
    std::vector<std::pair<std::uint64_t, BorderSide>> all;
    for (const auto& border : borders_) {
      for (const BorderSide& of : border) all.push_back({side_of(of.side[0], of.side[1]), of});
    }
    const std::vector<BorderSide> sides = once(std::move(all));
    std::vector<std::uint32_t> nodes;
    for (const auto& [side, triangle] : sides) nodes.insert(nodes.end(), side.begin(), side.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    std::sort(nodes.begin(), nodes.end(),
              [&](std::uint32_t a, std::uint32_t b) { return points_[a].x < points_[b].x; });
    // A triangle may have several sides that are parted: where each of them is now.
    std::unordered_map<std::uint64_t, std::size_t> owner;
    for (const auto& [side, triangle] : sides) owner[directed(side[0], side[1])] = triangle;
    for (const auto& [side, triangle] : sides) {
      const std::vector<std::uint32_t> within = nodes_on(side, nodes);
      if (!within.empty()) part(side, within, owner);
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> nodes_on(const MeshSide& side,
                                                    const std::vector<std::uint32_t>& by_x) const {
    const Point3 a = points_[side[0]], b = points_[side[1]];
    const Vector3 along = b - a;
    const double square = geom::dot(along, along);
    std::vector<std::pair<double, std::uint32_t>> found;
    const auto first = std::lower_bound(by_x.begin(), by_x.end(), std::min(a.x, b.x) - near_,
                                        [&](std::uint32_t node, double x) { return points_[node].x < x; });
    for (auto at = first; at != by_x.end() && points_[*at].x <= std::max(a.x, b.x) + near_; ++at) {
      if (*at == side[0] || *at == side[1]) continue;
      const Vector3 off = points_[*at] - a;
      const double part = geom::dot(off, along) / square;
      if (part <= 0.0 || part >= 1.0 || geom::length(off - part * along) > near_) continue;
      found.emplace_back(part, *at);
    }
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> nodes;
    for (const auto& [part, node] : found) nodes.push_back(node);
    return nodes;
  }

  void part(const MeshSide& side, const std::vector<std::uint32_t>& within,
            std::unordered_map<std::uint64_t, std::size_t>& owner) {
    const std::size_t whole = owner[directed(side[0], side[1])];
    const MeshTriangle t = triangles_[whole];
    std::size_t k = 0;
    while (t[k] != side[0]) ++k;
    const std::uint32_t tip = t[(k + 2) % 3];
    std::uint32_t from = side[0];
    for (std::size_t i = 0; i <= within.size(); ++i) {
      const std::uint32_t to = i < within.size() ? within[i] : side[1];
      const MeshTriangle piece{from, to, tip};
      if (i == 0) {
        triangles_[whole] = piece;
      } else {
        triangles_.push_back(piece);
      }
      if (to == side[1]) owner[directed(to, tip)] = i == 0 ? whole : triangles_.size() - 1;
      from = to;
    }
  }

  // Step 3.
  [[nodiscard]] double height(const MeshTriangle& t) const {
    const Point3 a = points_[t[0]], b = points_[t[1]], c = points_[t[2]];
    const double longest = std::max({geom::distance(a, b), geom::distance(b, c), geom::distance(c, a)});
    return longest > 0.0 ? geom::length(geom::cross(b - a, c - a)) / longest : 0.0;
  }

  void turn_thin() {
    constexpr int most_rounds = 20;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<std::size_t> thin;
      for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (height(triangles_[i]) <= thin_) thin.push_back(i);
      }
      if (thin.empty() || !turn(thin)) return;
    }
  }

  bool turn(const std::vector<std::size_t>& thin) {
    std::unordered_map<std::uint64_t, std::array<std::size_t, 2>> beside;
    constexpr auto no_triangle = static_cast<std::size_t>(-1);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [at, fresh] =
            beside.try_emplace(side_of(triangles_[i][k], triangles_[i][(k + 1) % 3]), std::array{i, no_triangle});
        if (!fresh) at->second[1] = i;
      }
    }
    std::unordered_set<std::uint32_t> on_border;
    for (const auto& [side, of] : beside) {
      if (of[1] != no_triangle) continue;
      on_border.insert(static_cast<std::uint32_t>(side >> 32U));
      on_border.insert(static_cast<std::uint32_t>(side & 0xffffffffU));
    }
    std::vector<bool> touched(triangles_.size(), false), gone(triangles_.size(), false);
    bool changed = false;
    for (const std::size_t i : thin) {
      if (touched[i]) continue;
      const MeshTriangle t = triangles_[i];
      std::size_t k = 0;
      const auto length = [&](std::size_t of) { return geom::distance(points_[t[of]], points_[t[(of + 1) % 3]]); };
      for (std::size_t of = 1; of < 3; ++of) {
        if (length(of) > length(k)) k = of;
      }
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const auto& both = beside.at(side_of(a, b));
      if (both[1] == no_triangle) {
        if (on_border.contains(c)) continue;  // the border would pass it twice
        gone[i] = touched[i] = changed = true;
        continue;
      }
      const std::size_t other = both[0] == i ? both[1] : both[0];
      if (touched[other]) continue;
      const MeshTriangle& o = triangles_[other];
      const std::uint32_t d = o[0] + o[1] + o[2] - a - b;
      const MeshTriangle first{a, d, c}, second{d, b, c};
      if (beside.contains(side_of(c, d))) continue;
      if (std::min(height(first), height(second)) <= std::min(height(t), height(o))) continue;
      triangles_[i] = first;
      triangles_[other] = second;
      touched[i] = touched[other] = changed = true;
      beside.try_emplace(side_of(c, d), std::array{i, other});
    }
    std::vector<MeshTriangle> left;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (!gone[i]) left.push_back(triangles_[i]);
    }
    triangles_ = std::move(left);
    return changed;
  }

  // Step 4.
  JoinedMesh used() {
    JoinedMesh mesh;
    std::vector<std::uint32_t> number(points_.size(), no_node);
    for (const MeshTriangle& t : triangles_) {
      MeshTriangle& made = mesh.triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        if (number[t[k]] == no_node) {
          number[t[k]] = static_cast<std::uint32_t>(mesh.points.size());
          mesh.points.push_back(points_[t[k]]);
        }
        made[k] = number[t[k]];
      }
    }
    return mesh;
  }

  double near_, thin_;
  std::vector<Point3> points_;
  std::vector<MeshTriangle> triangles_;
  std::vector<std::vector<BorderSide>> borders_;  // of patches, where sections cross
};

}  // namespace

JoinedMesh joined(const NamedSurface& surface, double size) { return Joining(size).run(surface); }

}  // namespace dobra::surf::loft
