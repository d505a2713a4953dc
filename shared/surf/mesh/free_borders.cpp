#include "shared/surf/mesh/free_borders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "shared/geom/predicates.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"

namespace dobra::surf::mesh {

using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

double alpha(Point3 a, Point3 b, Point3 c) {
  const double sides = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
  return sides > 0.0 ? 2.0 * std::sqrt(3.0) * geom::length(cross(b - a, c - a)) / sides : 0.0;
}

/// A triangle and which of its corners or sides is meant.
struct Corner {
  std::size_t triangle = 0;
  std::size_t at = 0;
};

class Freeing {
 public:
  Freeing(SurfaceMesh& mesh, std::span<const trim::TrimmedSurface> surfaces, std::span<const std::size_t> owner,
          const std::string& set, const FreeBorderOptions& options)
      : mesh_(mesh), surfaces_(surfaces), owner_(owner), options_(options) {
    const auto found = mesh_.constraint_sets.find(set);
    if (found == mesh_.constraint_sets.end()) return;
    freed_ = found->second;
    mesh_.constraint_sets.erase(found);
    corners_.resize(mesh_.points.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) corners_[mesh_.triangles[t][i].index()].push_back({t, i});
    }
    fix();
    choose();
  }

  std::size_t run() {
    std::size_t kept = 0;
    for (int pass = 0; pass < options_.passes && !nodes_.empty(); ++pass) {
      std::size_t now = 0;
      for (const std::size_t node : nodes_) now += flip_round(node);
      for (const std::size_t node : nodes_) now += move(node) ? 1U : 0U;
      kept += now;
      if (now == 0) break;
    }
    return kept;
  }

 private:
  using Side = std::pair<std::size_t, std::size_t>;
  static Side side_of(NodeId a, NodeId b) { return std::minmax(a.index(), b.index()); }

  void fix() {
    fixed_.assign(mesh_.points.size(), 0);
    const auto fix_sets = [&](const auto& sets) {
      for (const auto& [name, edges] : sets) {
        for (const Edge& edge : edges) {
          kept_sides_.insert(side_of(edge[0], edge[1]));
          for (const NodeId node : edge) fixed_[node.index()] = 1;
        }
      }
    };
    fix_sets(mesh_.boundary_sets);
    fix_sets(mesh_.constraint_sets);
    for (const auto& [name, nodes] : mesh_.node_sets) {
      for (const NodeId node : nodes) fixed_[node.index()] = 1;
    }
    std::map<Side, std::size_t> uses;
    for (const Corners& corners : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++uses[side_of(corners[i], corners[(i + 1) % 3])];
    }
    for (const auto& [side, count] : uses) {
      if (count == 1) fixed_[side.first] = fixed_[side.second] = 1;
    }
  }

  void choose() {
    std::set<std::size_t> near;
    for (const Edge& edge : freed_) near.insert({edge[0].index(), edge[1].index()});
    for (int ring = 0; ring < options_.rings; ++ring) {
      std::set<std::size_t> next = near;
      for (const std::size_t node : near) {
        for (const Corner& corner : corners_[node]) {
          for (const NodeId other : mesh_.triangles[corner.triangle]) next.insert(other.index());
        }
      }
      near = std::move(next);
    }
    for (const std::size_t node : near) {
      if (fixed_[node] == 0 && one_face(node)) nodes_.push_back(node);
    }
  }
  [[nodiscard]] bool one_face(std::size_t node) const {
    const auto& around = corners_[node];
    return !around.empty() && std::all_of(around.begin(), around.end(), [&](const Corner& c) {
      return owner_[mesh_.faces[c.triangle]] == owner_[mesh_.faces[around[0].triangle]] &&
             mesh_.regions[c.triangle] == mesh_.regions[around[0].triangle];
    });
  }

  [[nodiscard]] Point3 at(std::size_t triangle, std::size_t corner) const {
    return mesh_.point(mesh_.triangles[triangle][corner % 3]);
  }
  /// Whether a triangle runs as those of its face do in their chart.
  [[nodiscard]] bool upright(std::size_t chart, const std::array<Point, 3>& places) const {
    const auto wanted = surfaces_[chart].reversed ? geom::Sign::Negative : geom::Sign::Positive;
    return geom::orient2d(places[0], places[1], places[2]) == wanted;
  }

  // --- moves

  /// The mean of where each triangle around would be equilateral.
  [[nodiscard]] Point3 ideal(std::size_t node) const {
    Vector3 sum{};
    const Point3 here = mesh_.points[node];
    for (const Corner& c : corners_[node]) {
      const Point3 a = at(c.triangle, c.at + 1), b = at(c.triangle, c.at + 2);
      const Vector3 base = b - a;
      const Point3 middle = a + 0.5 * base;
      const Vector3 up = (here - middle) - (dot(here - middle, base) / dot(base, base)) * base;
      const double high = geom::length(up);
      const Point3 apex = high > 0.0 ? middle + (0.5 * std::sqrt(3.0) * geom::length(base) / high) * up : here;
      sum = sum + (apex - here);
    }
    return here + sum / static_cast<double>(corners_[node].size());
  }

  struct Moved {
    Point3 at;
    std::vector<Point> places;  ///< One a corner of the node.
  };
  /// The node by a step of the chart of its first triangle.
  [[nodiscard]] std::optional<Moved> moved(std::size_t node, geom::Vector step) const {
    const auto& around = corners_[node];
    const auto place = [&](const Corner& c) { return mesh_.places[c.triangle][c.at]; };
    const std::size_t chart = mesh_.faces[around[0].triangle];
    const Surface& surface = surfaces_[chart].surface;
    const geom::Box& box = surface.chart();
    // Beyond a seam a closed chart goes on; that of a slender tip is turned there.
    const bool goes_on = surface.closed_u() || surface.closed_v();
    const auto by_step = [&](const Corner& c) {
      return mesh_.faces[c.triangle] == chart && (goes_on || place(c) == place(around[0]));
    };
    // One of its places in this chart must stay there: the surface is asked nowhere else.
    std::optional<Point> inside;
    for (const Corner& c : around) {
      const Point to = place(c) + step;
      if (by_step(c) && to.x >= box.low.x && to.x <= box.high.x && to.y >= box.low.y && to.y <= box.high.y) inside = to;
    }
    if (!inside) return std::nullopt;
    Moved moved{surface.at(*inside), {}};
    for (const Corner& c : around) {
      const std::size_t own = mesh_.faces[c.triangle];
      moved.places.push_back(by_step(c) ? place(c) + step : closest(surfaces_[own].surface, moved.at, place(c)).uv);
    }
    return moved;
  }

  /// The least alpha around, and the sum; nothing if a triangle would be turned in its chart.
  struct Worth {
    double least = 2.0, sum = 0.0;
  };
  [[nodiscard]] std::optional<Worth> worth(std::size_t node, const Moved& moved) const {
    Worth worth;
    for (std::size_t k = 0; k < corners_[node].size(); ++k) {
      const Corner& c = corners_[node][k];
      std::array<Point, 3> places = mesh_.places[c.triangle];
      places[c.at] = moved.places[k];
      if (!upright(mesh_.faces[c.triangle], places)) return std::nullopt;
      const Point3 a = at(c.triangle, c.at + 1), b = at(c.triangle, c.at + 2);
      // Nor may it turn over in space.
      if (dot(cross(a - moved.at, b - moved.at), cross(a - mesh_.points[node], b - mesh_.points[node])) <= 0.0)
        return std::nullopt;
      const double own = alpha(moved.at, a, b);
      worth.least = std::min(worth.least, own);
      worth.sum += own;
    }
    return worth;
  }

  bool move(std::size_t node) {
    const auto& around = corners_[node];
    Moved now{mesh_.points[node], {}};
    for (const Corner& c : around) now.places.push_back(mesh_.places[c.triangle][c.at]);
    const auto before = worth(node, now);
    if (!before) return false;  // A pole, or the end of what a chart tells.
    const Jet jet = surfaces_[mesh_.faces[around[0].triangle]].surface.jet(now.places[0]);
    const Vector3 way = ideal(node) - now.at;
    const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v), determinant = e * g - f * f;
    if (!(determinant > 1e-12 * e * g)) return false;
    const double p = dot(way, jet.u), q = dot(way, jet.v);
    const geom::Vector step{(g * p - f * q) / determinant, (e * q - f * p) / determinant};
    for (const double part : {1.0, 0.5, 0.25}) {
      const auto to = moved(node, part * step);
      if (!to) continue;
      const auto after = worth(node, *to);
      const double count = static_cast<double>(around.size());
      if (!after) continue;
      const bool better = after->least > before->least + options_.gain ||
                          (after->least >= before->least && after->sum > before->sum + options_.gain * count);
      if (!better) continue;
      mesh_.points[node] = to->at;
      for (std::size_t k = 0; k < around.size(); ++k) mesh_.places[around[k].triangle][around[k].at] = to->places[k];
      return true;
    }
    return false;
  }

  // --- flips

  std::size_t flip_round(std::size_t node) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < corners_[node].size(); ++k) {
      const Corner c = corners_[node][k];
      if (flip(c.triangle, c.at)) ++kept, k = 0;
    }
    return kept;
  }

  [[nodiscard]] std::optional<Corner> across(std::size_t triangle, std::size_t side) const {
    const NodeId from = mesh_.triangles[triangle][side], to = mesh_.triangles[triangle][(side + 1) % 3];
    for (const Corner& c : corners_[to.index()]) {
      if (c.triangle != triangle && mesh_.triangles[c.triangle][(c.at + 1) % 3] == from) return c;
    }
    return std::nullopt;
  }

  /// The cosine of the angle between a triangle and its surface in its middle; 1 where that has no normal.
  [[nodiscard]] double along_surface(std::size_t chart, const std::array<Point, 3>& places,
                                     const std::array<Point3, 3>& corners) const {
    const Point middle = Point{} + ((places[0] - Point{}) + (places[1] - Point{}) + (places[2] - Point{})) / 3.0;
    const auto own = normal(surfaces_[chart].surface, middle);
    const Vector3 area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = geom::length(area);
    if (!own || !(size > 0.0)) return 1.0;
    return (surfaces_[chart].reversed ? -1.0 : 1.0) * dot(*own, area) / size;
  }

  /// The side from corner `side` of a triangle to the next one becomes the other diagonal.
  bool flip(std::size_t first, std::size_t side) {
    const auto other = across(first, side);
    if (!other || mesh_.faces[other->triangle] != mesh_.faces[first] ||
        mesh_.regions[other->triangle] != mesh_.regions[first])
      return false;
    const std::size_t second = other->triangle, chart = mesh_.faces[first];
    const NodeId a = mesh_.triangles[first][side], b = mesh_.triangles[first][(side + 1) % 3];
    const NodeId c = mesh_.triangles[first][(side + 2) % 3], d = mesh_.triangles[second][(other->at + 2) % 3];
    if (c == d || kept_sides_.contains(side_of(a, b)) || joined(c, d)) return false;
    const Point pa = mesh_.places[first][side], pb = mesh_.places[first][(side + 1) % 3],
                pc = mesh_.places[first][(side + 2) % 3];
    // The other triangle may be on the far side of the seam.
    const geom::Vector shift = pb - mesh_.places[second][other->at];
    const geom::Vector same = pa - mesh_.places[second][(other->at + 1) % 3];
    const geom::Box& box = surfaces_[chart].surface.chart();
    if (std::abs(shift.x - same.x) > 1e-9 * box.width() || std::abs(shift.y - same.y) > 1e-9 * box.height())
      return false;
    const Point pd = mesh_.places[second][(other->at + 2) % 3] + shift;
    const std::array<Point, 3> one{pa, pd, pc}, two{pd, pb, pc};
    if (!upright(chart, one) || !upright(chart, two)) return false;
    const Point3 qa = mesh_.point(a), qb = mesh_.point(b), qc = mesh_.point(c), qd = mesh_.point(d);
    const double before = std::min(alpha(qa, qb, qc), alpha(qb, qa, qd));
    const double after = std::min(alpha(qa, qd, qc), alpha(qd, qb, qc));
    const Vector3 normal = cross(qb - qa, qc - qa) + cross(qa - qb, qd - qb);
    if (!(after > before + options_.gain) || dot(cross(qd - qa, qc - qa), normal) <= 0.0 ||
        dot(cross(qb - qd, qc - qd), normal) <= 0.0)
      return false;
    // Across a slender tip a good triangle may lie through the surface.
    const std::array<Point, 3> old_one{pa, pb, pc}, old_two{pb, pa, pd};
    const double turned_before =
        std::min(along_surface(chart, old_one, {qa, qb, qc}), along_surface(chart, old_two, {qb, qa, qd}));
    const double turned_after =
        std::min(along_surface(chart, one, {qa, qd, qc}), along_surface(chart, two, {qd, qb, qc}));
    constexpr double most_turned = 0.5;  // the cosine of 60 degrees
    if (turned_after < std::min(turned_before, most_turned)) return false;
    forget(first), forget(second);
    mesh_.triangles[first] = {a, d, c}, mesh_.places[first] = one;
    mesh_.triangles[second] = {d, b, c}, mesh_.places[second] = two;
    remember(first), remember(second);
    return true;
  }
  [[nodiscard]] bool joined(NodeId c, NodeId d) const {
    return std::any_of(corners_[c.index()].begin(), corners_[c.index()].end(), [&](const Corner& corner) {
      const Corners& all = mesh_.triangles[corner.triangle];
      return all[0] == d || all[1] == d || all[2] == d;
    });
  }
  void forget(std::size_t triangle) {
    for (const NodeId node : mesh_.triangles[triangle])
      std::erase_if(corners_[node.index()], [&](const Corner& c) { return c.triangle == triangle; });
  }
  void remember(std::size_t triangle) {
    for (std::size_t i = 0; i < 3; ++i) corners_[mesh_.triangles[triangle][i].index()].push_back({triangle, i});
  }

  SurfaceMesh& mesh_;
  std::span<const trim::TrimmedSurface> surfaces_;
  std::span<const std::size_t> owner_;
  FreeBorderOptions options_;
  std::vector<Edge> freed_;
  std::vector<std::vector<Corner>> corners_;  ///< One a node.
  std::vector<std::uint8_t> fixed_;
  std::set<Side> kept_sides_;
  std::vector<std::size_t> nodes_;  ///< That may move, ascending.
};

}  // namespace

std::size_t free_borders(SurfaceMesh& mesh, std::span<const trim::TrimmedSurface> surfaces,
                         std::span<const std::size_t> owner, const std::string& set, const FreeBorderOptions& options) {
  return Freeing(mesh, surfaces, owner, set, options).run();
}

}  // namespace dobra::surf::mesh
