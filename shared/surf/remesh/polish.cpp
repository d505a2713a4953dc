#include "shared/surf/remesh/polish.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

namespace dobra::surf::remesh {

using dobra::mesh::Corners;
using dobra::mesh::NodeId;
using dobra::mesh::TriangleId;
using geom::Point3;
using geom::Vector3;
using param::Sheet;

namespace {

/// One a point: the mean of the normals of the triangles round it, by area.
std::vector<Vector3> normals_of(const Sheet& sheet) {
  std::vector<Vector3> normals(sheet.points.size());
  for (const auto& [a, b, c] : sheet.triangles) {
    const Vector3 area = cross(sheet.points[b] - sheet.points[a], sheet.points[c] - sheet.points[a]);
    for (const std::uint32_t v : {a, b, c}) normals[v] = normals[v] + area;
  }
  for (Vector3& n : normals) n = geom::length(n) > 0.0 ? normalised(n) : n;
  return normals;
}

/// A triangle and which of its corners or sides is meant.
struct CornerOf {
  std::uint32_t triangle = 0, at = 0;
};

/// A node where it is, or could be.
struct Spot {
  Point3 at;
  Vector3 normal;  ///< Of the old mesh there.
};

struct Worth {
  double least = 2.0, sum = 0.0;
};

class Polisher {
 public:
  Polisher(mesh::SurfaceMesh& mesh, const Sheet& before, const TriangleTree& tree, const base::Progress& progress,
           const PolishOptions& options)
      : mesh_(mesh),
        before_(before),
        tree_(tree),
        progress_(progress),
        options_(options),
        bent_least_(std::cos(options.sharpest * std::numbers::pi / 180.0)),
        normals_(normals_of(before)),
        around_(mesh.points.size()),
        stays_(mesh.points.size(), false) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) remember(t);
    fix();
  }

  base::Result<void> run() {
    for (const Point3 p : mesh_.points) {
      DOBRA_TRY_VOID(progress_.check());
      spots_.push_back({p, on_old(p).normal});
    }
    for (int pass = 0; pass < options_.passes; ++pass) {
      const std::vector<std::uint32_t> nodes = poor_nodes();
      std::size_t kept = 0;
      for (const std::uint32_t node : nodes) {
        DOBRA_TRY_VOID(progress_.check());
        kept += flips_round(node);
        if (!stays_[node] && move(node)) ++kept;
      }
      if (kept == 0) break;
    }
    for (std::size_t i = 0; i < spots_.size(); ++i) mesh_.points[i] = spots_[i].at;
    std::fill(mesh_.faces.begin(), mesh_.faces.end(), 0U);
    std::fill(mesh_.places.begin(), mesh_.places.end(), std::array<geom::Point, 3>{});
    return {};
  }
  [[nodiscard]] std::vector<TriangleId> turned() const {
    std::vector<TriangleId> turned;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (worth_of(mesh_.triangles[t]) <= 0.0) turned.emplace_back(t);
    }
    return turned;
  }

 private:
  using Side = std::pair<std::size_t, std::size_t>;
  static Side side_of(NodeId a, NodeId b) { return std::minmax(a.index(), b.index()); }

  void fix() {
    const auto keep = [&](const auto& sets) {
      for (const auto& [name, edges] : sets) {
        for (const mesh::Edge& edge : edges) {
          kept_.insert(side_of(edge[0], edge[1]));
          for (const NodeId node : edge) stays_[node.index()] = true;
        }
      }
    };
    keep(mesh_.boundary_sets);
    keep(mesh_.constraint_sets);
    for (const auto& [name, nodes] : mesh_.node_sets) {
      for (const NodeId node : nodes) stays_[node.index()] = true;
    }
    std::map<Side, int> uses;
    for (const Corners& corners : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++uses[side_of(corners[i], corners[(i + 1) % 3])];
    }
    for (const auto& [side, count] : uses) {
      if (count == 1) stays_[side.first] = stays_[side.second] = true;
    }
  }

  [[nodiscard]] Spot on_old(Point3 p) const {
    const TriangleTree::Nearest near = tree_.nearest(p);
    const auto& [a, b, c] = before_.triangles[near.triangle];
    const Vector3 u = before_.points[b] - before_.points[a], v = before_.points[c] - before_.points[a],
                  w = near.at - before_.points[a], area = cross(u, v);
    const double all = dot(area, area), of_b = dot(cross(w, v), area) / all, of_c = dot(cross(u, w), area) / all;
    const Vector3 normal = (1.0 - of_b - of_c) * normals_[a] + of_b * normals_[b] + of_c * normals_[c];
    return {near.at, geom::length(normal) > 0.0 ? normalised(normal) : area};
  }

  /// Its alpha, less than nought where it faces against the old mesh: against the normals at its corners, which are
  /// means at creases, and against the triangle that is nearest to its centre.
  [[nodiscard]] double worth_of(const Spot& a, const Spot& b, const Spot& c) const {
    const Vector3 u = b.at - a.at, v = c.at - a.at, w = c.at - b.at, area = cross(u, v);
    const double squares = dot(u, u) + dot(v, v) + dot(w, w);
    if (!(squares > 0.0)) return 0.0;
    const double alpha = 2.0 * std::numbers::sqrt3 * geom::length(area) / squares;
    if (dot(area, a.normal + b.normal + c.normal) > 0.0) return alpha;
    const auto& near = before_.triangles[tree_.nearest(a.at + (1.0 / 3.0) * (u + v)).triangle];
    const Point3 p = before_.points[near[0]];
    return dot(area, cross(before_.points[near[1]] - p, before_.points[near[2]] - p)) > 0.0 ? alpha : -alpha;
  }
  [[nodiscard]] double worth_of(const Corners& t) const {
    return worth_of(spots_[t[0].index()], spots_[t[1].index()], spots_[t[2].index()]);
  }

  /// Of poor triangles, ascending.
  [[nodiscard]] std::vector<std::uint32_t> poor_nodes() const {
    std::vector<bool> poor(spots_.size(), false);
    for (const Corners& t : mesh_.triangles) {
      if (progress_.cancelled()) break;
      if (worth_of(t) >= options_.poor) continue;
      for (const NodeId node : t) poor[node.index()] = true;
    }
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t i = 0; i < poor.size(); ++i) {
      if (poor[i]) nodes.push_back(i);
    }
    return nodes;
  }

  /// Of the triangles round a node, were it elsewhere.
  [[nodiscard]] Worth worth(std::uint32_t node, const Spot& spot) const {
    Worth worth;
    for (const CornerOf& c : around_[node]) {
      const Corners& t = mesh_.triangles[c.triangle];
      const double own = worth_of(spot, spots_[t[(c.at + 1) % 3].index()], spots_[t[(c.at + 2) % 3].index()]);
      worth.least = std::min(worth.least, own);
      worth.sum += own;
    }
    return worth;
  }
  [[nodiscard]] bool better(const Worth& after, const Worth& before, std::size_t count) const {
    return after.least > before.least + options_.gain ||
           (after.least >= before.least && after.sum > before.sum + options_.gain * static_cast<double>(count));
  }

  /// The mean of where each triangle round a node would be equilateral.
  [[nodiscard]] Point3 ideal(std::uint32_t node) const {
    const Point3 here = spots_[node].at;
    Vector3 sum;
    for (const CornerOf& c : around_[node]) {
      const Corners& t = mesh_.triangles[c.triangle];
      const Point3 a = spots_[t[(c.at + 1) % 3].index()].at, b = spots_[t[(c.at + 2) % 3].index()].at;
      const Vector3 base = b - a;
      const Point3 middle = a + 0.5 * base;
      const Vector3 up = (here - middle) - (dot(here - middle, base) / dot(base, base)) * base;
      const double high = geom::length(up);
      if (high > 0.0) sum = sum + (middle + (0.5 * std::numbers::sqrt3 * geom::length(base) / high) * up - here);
    }
    return here + sum / static_cast<double>(around_[node].size());
  }

  bool move(std::uint32_t node) {
    const std::size_t count = around_[node].size();
    const Worth before = worth(node, spots_[node]);
    const Vector3 way = ideal(node) - spots_[node].at;
    for (const double part : {1.0, 0.5, 0.25}) {
      const Spot to = on_old(spots_[node].at + part * way);
      if (!better(worth(node, to), before, count)) continue;
      spots_[node] = to;
      return true;
    }
    return false;
  }

  std::size_t flips_round(std::uint32_t node) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < around_[node].size(); ++k) {
      const CornerOf c = around_[node][k];
      if (flip(c.triangle, c.at)) ++kept, k = 0;
    }
    return kept;
  }
  [[nodiscard]] std::optional<CornerOf> across(std::uint32_t triangle, std::uint32_t side) const {
    const NodeId from = mesh_.triangles[triangle][side], to = mesh_.triangles[triangle][(side + 1) % 3];
    for (const CornerOf& c : around_[to.index()]) {
      if (c.triangle != triangle && mesh_.triangles[c.triangle][(c.at + 1) % 3] == from) return c;
    }
    return std::nullopt;
  }
  /// The side from corner `side` of a triangle to the next one becomes the other diagonal.
  bool flip(std::uint32_t first, std::uint32_t side) {
    const auto other = across(first, side);
    if (!other) return false;
    const std::uint32_t second = other->triangle;
    const NodeId a = mesh_.triangles[first][side], b = mesh_.triangles[first][(side + 1) % 3],
                 c = mesh_.triangles[first][(side + 2) % 3], d = mesh_.triangles[second][(other->at + 2) % 3];
    if (c == d || kept_.contains(side_of(a, b)) || joined(c, d)) return false;
    const Corners one{a, d, c}, two{d, b, c};
    const double before = std::min(worth_of(mesh_.triangles[first]), worth_of(mesh_.triangles[second]));
    if (!(std::min(worth_of(one), worth_of(two)) > before + options_.gain)) return false;
    constexpr double flat = 0.05;  // of such a triangle the normal tells nothing
    const double bent = bend(one, two);
    if (before > flat && bent < bent_least_ && bent < bend(mesh_.triangles[first], mesh_.triangles[second]))
      return false;
    forget(first), forget(second);
    mesh_.triangles[first] = one;
    mesh_.triangles[second] = two;
    remember(first), remember(second);
    return true;
  }
  /// The cosine of the angle between the normals of two triangles.
  [[nodiscard]] double bend(const Corners& s, const Corners& t) const {
    const auto area = [&](const Corners& of) {
      const Point3 p = spots_[of[0].index()].at;
      return cross(spots_[of[1].index()].at - p, spots_[of[2].index()].at - p);
    };
    const Vector3 m = area(s), n = area(t);
    const double lengths = geom::length(m) * geom::length(n);
    return lengths > 0.0 ? dot(m, n) / lengths : -1.0;
  }
  [[nodiscard]] bool joined(NodeId c, NodeId d) const {
    return std::any_of(around_[c.index()].begin(), around_[c.index()].end(), [&](const CornerOf& corner) {
      const Corners& all = mesh_.triangles[corner.triangle];
      return all[0] == d || all[1] == d || all[2] == d;
    });
  }
  void forget(std::uint32_t triangle) {
    for (const NodeId node : mesh_.triangles[triangle])
      std::erase_if(around_[node.index()], [&](const CornerOf& c) { return c.triangle == triangle; });
  }
  void remember(std::uint32_t triangle) {
    for (std::uint32_t i = 0; i < 3; ++i) around_[mesh_.triangles[triangle][i].index()].push_back({triangle, i});
  }

  mesh::SurfaceMesh& mesh_;
  const Sheet& before_;
  const TriangleTree& tree_;
  const base::Progress& progress_;
  const PolishOptions options_;
  const double bent_least_;
  const std::vector<Vector3> normals_;
  std::vector<std::vector<CornerOf>> around_;  ///< One a node.
  std::vector<bool> stays_;
  std::vector<Spot> spots_;
  std::set<Side> kept_;
};

}  // namespace

base::Result<std::vector<TriangleId>> polish(mesh::SurfaceMesh& mesh, const Sheet& before, const TriangleTree& tree,
                                             const base::Progress& progress, const PolishOptions& options) {
  Polisher polisher(mesh, before, tree, progress, options);
  DOBRA_TRY_VOID(polisher.run());
  return polisher.turned();
}

}  // namespace dobra::surf::remesh
