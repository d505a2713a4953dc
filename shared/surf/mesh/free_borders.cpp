#include "shared/surf/mesh/free_borders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "shared/base/check.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"

// 1. Nodes within some rings of the artificial borders, and the triangles round them. What stands in another set is
//    fixed. 2. Rounds: sides are flipped while the least angle grows; then each node is moved towards the mean of its
//    neighbours, on the surface, if its star gets better.
// The measure of a star is its least alpha and a tenth of its mean one.

namespace dobra::surf::mesh {

using base::Progress;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

constexpr std::uint32_t none = 0xffffffffU;

std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

double alpha(Point3 a, Point3 b, Point3 c) {
  const double sum = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
  return sum > 0.0 ? 2.0 * std::numbers::sqrt3 * length(cross(b - a, c - a)) / sum : 0.0;
}

double least_angle(Point3 a, Point3 b, Point3 c) {
  const auto at = [](Point3 p, Point3 q, Point3 r) {
    return std::atan2(length(cross(q - p, r - p)), dot(q - p, r - p));
  };
  return std::min({at(a, b, c), at(b, c, a), at(c, a, b)});
}

class Freeing {
 public:
  Freeing(SurfaceMesh& mesh, std::span<const Surface> surfaces, const FreeBorderOptions& options)
      : mesh_(mesh), surfaces_(surfaces), options_(options) {}

  Result<std::size_t> run(const std::set<std::string>& artificial, const Progress& progress);

 private:
  void find_region(const std::set<std::string>& artificial);
  void fix_sets();
  [[nodiscard]] std::uint32_t corner(std::uint32_t t, std::size_t i) const {
    return static_cast<std::uint32_t>(mesh_.triangles[t][i].index());
  }
  [[nodiscard]] Point3 at(std::uint32_t node) const { return mesh_.points[node]; }
  [[nodiscard]] std::size_t index_in(std::uint32_t t, std::uint32_t node) const {
    return corner(t, 0) == node ? 0 : corner(t, 1) == node ? 1 : 2;
  }
  [[nodiscard]] bool looks_outwards(const std::array<Point3, 3>& points, const std::array<Point, 3>& places,
                                    std::uint32_t face) const;
  /// The two triangles of the side a-b that its star holds; none where it has one or more than two.
  [[nodiscard]] std::array<std::uint32_t, 2> triangles_of(std::uint32_t a, std::uint32_t b) const;
  bool flip(std::uint32_t a, std::uint32_t b);
  std::size_t flip_all();
  bool move(std::uint32_t node);

  SurfaceMesh& mesh_;
  std::span<const Surface> surfaces_;
  const FreeBorderOptions& options_;
  std::vector<std::vector<std::uint32_t>> star_;  ///< Triangles round a node of the region; empty elsewhere.
  std::vector<std::uint8_t> ring_;                ///< 0: not near; k + 1: k sides from an artificial border.
  std::vector<std::uint8_t> fixed_;
  std::vector<std::uint64_t> kept_;   ///< Sides of sets, sorted.
  std::vector<std::uint32_t> nodes_;  ///< Of the region, ascending.
  std::vector<double> turn_;          ///< One a face: +1 where triangles look along the surface's normal, -1 against.
};

void Freeing::fix_sets() {
  const auto keep = [&](const std::vector<Edge>& edges) {
    for (const Edge& edge : edges) {
      for (const NodeId node : edge) fixed_[node.index()] = 1;
      kept_.push_back(key_of(static_cast<std::uint32_t>(edge[0].index()), static_cast<std::uint32_t>(edge[1].index())));
    }
  };
  for (const auto& [name, edges] : mesh_.boundary_sets) keep(edges);
  for (const auto& [name, edges] : mesh_.constraint_sets) keep(edges);
  for (const auto& [name, nodes] : mesh_.node_sets)
    for (const NodeId node : nodes) fixed_[node.index()] = 1;
  std::sort(kept_.begin(), kept_.end());
}

/// Rings grow over the triangles, one pass a ring. Stars are made for the nodes of the region and one ring more.
void Freeing::find_region(const std::set<std::string>& artificial) {
  ring_.assign(mesh_.points.size(), 0);
  for (const std::string& name : artificial) {
    const auto set = mesh_.boundary_sets.find(name);
    if (set == mesh_.boundary_sets.end()) continue;
    for (const Edge& edge : set->second)
      for (const NodeId node : edge) ring_[node.index()] = 1;
    mesh_.boundary_sets.erase(set);
  }
  const auto last = static_cast<std::uint8_t>(std::clamp(options_.rings, 0, 200) + 2);
  for (std::uint8_t ring = 1; ring < last; ++ring) {
    for (const Corners& corners : mesh_.triangles) {
      const auto in = [&](NodeId node) { return ring_[node.index()] == ring; };
      if (!in(corners[0]) && !in(corners[1]) && !in(corners[2])) continue;
      for (const NodeId node : corners)
        if (ring_[node.index()] == 0) ring_[node.index()] = static_cast<std::uint8_t>(ring + 1);
    }
  }
  star_.assign(mesh_.points.size(), {});
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (ring_[corner(t, i)] != 0) star_[corner(t, i)].push_back(t);
  for (std::uint32_t node = 0; node < ring_.size(); ++node)
    if (ring_[node] != 0 && ring_[node] < last) nodes_.push_back(node);
}

bool Freeing::looks_outwards(const std::array<Point3, 3>& points, const std::array<Point, 3>& places,
                             std::uint32_t face) const {
  const Vector3 area = turn_[face] * cross(points[1] - points[0], points[2] - points[0]);
  return std::all_of(places.begin(), places.end(), [&](Point place) {
    const auto out = normal(surfaces_[face], place);
    return !out || dot(area, *out) > 0.0;
  });
}

std::array<std::uint32_t, 2> Freeing::triangles_of(std::uint32_t a, std::uint32_t b) const {
  std::array<std::uint32_t, 2> found{none, none};
  std::size_t count = 0;
  for (const std::uint32_t t : star_[a]) {
    if (corner(t, 0) != b && corner(t, 1) != b && corner(t, 2) != b) continue;
    if (count == 2) return {none, none};
    found[count++] = t;
  }
  if (count < 2) return {none, none};
  return found;
}

/// Sides a-b of the triangles a, b, c and b, a, d becomes c-d if the least of the six angles grows.
bool Freeing::flip(std::uint32_t a, std::uint32_t b) {
  auto [first, second] = triangles_of(a, b);
  if (first == none || mesh_.faces[first] != mesh_.faces[second] || mesh_.regions[first] != mesh_.regions[second])
    return false;
  if (std::binary_search(kept_.begin(), kept_.end(), key_of(a, b))) return false;
  if (corner(first, (index_in(first, a) + 1) % 3) != b) std::swap(first, second);
  const std::size_t i = index_in(first, a);
  const std::size_t j = index_in(second, b);
  if (corner(first, (i + 1) % 3) != b || corner(second, (j + 1) % 3) != a) return false;
  const std::uint32_t c = corner(first, (i + 2) % 3);
  const std::uint32_t d = corner(second, (j + 2) % 3);
  if (c == d || star_[c].empty() || star_[d].empty() || triangles_of(c, d)[0] != none) return false;
  const bool joined = std::any_of(star_[c].begin(), star_[c].end(), [&](std::uint32_t t) {
    return corner(t, 0) == d || corner(t, 1) == d || corner(t, 2) == d;
  });
  if (joined) return false;
  const double before = std::min(least_angle(at(a), at(b), at(c)), least_angle(at(b), at(a), at(d)));
  const double after = std::min(least_angle(at(a), at(d), at(c)), least_angle(at(d), at(b), at(c)));
  if (after < before + options_.gain) return false;
  const auto& one = mesh_.places[first];
  const auto& two = mesh_.places[second];
  const Point at_c = one[(i + 2) % 3];
  const Point at_d = two[(j + 2) % 3];
  const std::uint32_t face = mesh_.faces[first];
  const std::array<Point, 3> left{one[i], at_d, at_c};
  const std::array<Point, 3> right{at_d, one[(i + 1) % 3], at_c};
  if (!looks_outwards({at(a), at(d), at(c)}, left, face) || !looks_outwards({at(d), at(b), at(c)}, right, face))
    return false;
  mesh_.triangles[first] = {NodeId(a), NodeId(d), NodeId(c)};
  mesh_.triangles[second] = {NodeId(d), NodeId(b), NodeId(c)};
  mesh_.places[first] = left;
  mesh_.places[second] = right;
  std::erase(star_[b], first);
  std::erase(star_[a], second);
  star_[d].push_back(first);
  star_[c].push_back(second);
  return true;
}

std::size_t Freeing::flip_all() {
  std::size_t flips = 0;
  for (const std::uint32_t a : nodes_) {
    const std::vector<std::uint32_t> star = star_[a];
    for (const std::uint32_t t : star) {
      const std::size_t i = index_in(t, a);
      const std::uint32_t b = corner(t, (i + 1) % 3);
      if (corner(t, i) == a && !star_[b].empty() && flip(a, b)) ++flips;
    }
  }
  return flips;
}

bool Freeing::move(std::uint32_t node) {
  const std::vector<std::uint32_t>& star = star_[node];
  if (star.empty()) return false;
  const std::uint32_t face = mesh_.faces[star.front()];
  if (std::any_of(star.begin(), star.end(), [&](std::uint32_t t) { return mesh_.faces[t] != face; })) return false;
  const auto measure = [&](Point3 place) {
    double least = 1.0;
    double sum = 0.0;
    for (const std::uint32_t t : star) {
      const std::size_t i = index_in(t, node);
      const double a = alpha(place, at(corner(t, (i + 1) % 3)), at(corner(t, (i + 2) % 3)));
      least = std::min(least, a);
      sum += a;
    }
    return least + 0.1 * sum / static_cast<double>(star.size());
  };
  const double before = measure(at(node));
  Vector3 mean{};
  for (const std::uint32_t t : star) mean = mean + (at(corner(t, (index_in(t, node) + 1) % 3)) - at(node));
  mean = mean / static_cast<double>(star.size());
  const Point near = mesh_.places[star.front()][index_in(star.front(), node)];
  for (double phi = 1.0; phi > 0.2; phi *= 0.5) {
    const Foot foot = closest(surfaces_[face], at(node) + phi * mean, near);
    if (measure(foot.at) < before + options_.gain) continue;
    const bool sound = std::all_of(star.begin(), star.end(), [&](std::uint32_t t) {
      const std::size_t i = index_in(t, node);
      const std::array<Point3, 3> points{foot.at, at(corner(t, (i + 1) % 3)), at(corner(t, (i + 2) % 3))};
      const auto& places = mesh_.places[t];
      return looks_outwards(points, {foot.uv, places[(i + 1) % 3], places[(i + 2) % 3]}, face);
    });
    if (!sound) continue;
    mesh_.points[node] = foot.at;
    for (const std::uint32_t t : star) mesh_.places[t][index_in(t, node)] = foot.uv;
    return true;
  }
  return false;
}

Result<std::size_t> Freeing::run(const std::set<std::string>& artificial, const Progress& progress) {
  fixed_.assign(mesh_.points.size(), 0);
  find_region(artificial);
  if (nodes_.empty()) return std::size_t{0};
  fix_sets();
  turn_.assign(surfaces_.size(), 0.0);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    double& turn = turn_[mesh_.faces[t]];
    if (turn != 0.0) continue;
    const auto out = normal(surfaces_[mesh_.faces[t]], mesh_.places[t][0]);
    if (!out) continue;
    const Point3 a = at(corner(t, 0));
    turn = std::copysign(1.0, dot(*out, cross(at(corner(t, 1)) - a, at(corner(t, 2)) - a)));
  }
  std::size_t changes = 0;
  for (int round = 0; round < options_.rounds; ++round) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(round) / options_.rounds, "seams");
    std::size_t now = flip_all();
    for (const std::uint32_t node : nodes_)
      if (fixed_[node] == 0 && move(node)) ++now;
    changes += now;
    if (now == 0) break;
  }
  return changes;
}

}  // namespace

Result<std::size_t> free_borders(SurfaceMesh& mesh, std::span<const Surface> surfaces,
                                 const std::set<std::string>& artificial, const FreeBorderOptions& options,
                                 const Progress& progress) {
  return Freeing(mesh, surfaces, options).run(artificial, progress);
}

}  // namespace dobra::surf::mesh
