// 1. The sign of each vertex.
// 2. In a triangle the line joins two of its nodes: vertices at zero, and sides whose ends have opposite signs. A side
//    that is zero is a part of the line itself, once.
// 3. Nodes of sides are found on the surface. Parts are chained.
#include "shared/surf/loft/level.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;

namespace {

using Node = std::pair<std::uint32_t, std::uint32_t>;  // the ends of a side, or a vertex twice

Node side(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

class Levels {
 public:
  Levels(const Patch& patch, const Linear& function, double zero) : patch_(patch), function_(function), zero_(zero) {
    for (const Point3 p : patch.points) {
      const double value = function.at(p);
      values_.push_back(std::abs(value) <= zero ? 0.0 : value);
    }
  }

  LevelSet run() {
    for (const auto& triangle : patch_.triangles) add(triangle, true);
    // Where lines run together at one point, they link the sides that do.
    for (const auto& triangle : patch_.collapsed) add(triangle, false);
    for (const auto& [a, b] : parts_) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    }
    // Ends and branches first; rings are left.
    for (const bool rings : {false, true}) {
      for (const auto& [node, around] : neighbours_) {
        if ((around.size() == 2) != rings) continue;
        for (const Node& next : around) {
          if (parts_.contains(std::minmax(node, next))) follow(node, next);
        }
      }
    }
    return std::move(set_);
  }

 private:
  void add(const std::array<std::uint32_t, 3>& t, bool has_area) {
    std::vector<Node> nodes;
    int zeros = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (values_[a] == 0.0) nodes.push_back({a, a}), ++zeros;
      if ((values_[a] < 0.0 && values_[b] > 0.0) || (values_[a] > 0.0 && values_[b] < 0.0)) nodes.push_back(side(a, b));
    }
    if (zeros == 3 && has_area && set_.flat++ == 0) set_.flat_at = patch_.points[t[0]];
    if (zeros < 3 && nodes.size() == 2) parts_.insert(std::minmax(nodes[0], nodes[1]));
  }

  void follow(Node from, Node to) {
    LevelLine line;
    line.first = end_of(from);
    line.points.push_back(place(from));
    while (true) {
      parts_.erase(std::minmax(from, to));
      const Point3 p = place(to);
      if (!(p == line.points.back())) line.points.push_back(p);
      const auto& around = neighbours_[to];
      const auto next = std::find_if(around.begin(), around.end(),
                                     [&](const Node& n) { return parts_.contains(std::minmax(to, n)); });
      if (around.size() != 2 || next == around.end()) break;
      from = to;
      to = *next;
    }
    line.last = end_of(to);
    if (line.points.size() > 1) set_.lines.push_back(std::move(line));
  }

  [[nodiscard]] PatchEnd end_of(const Node& node) const {
    const std::size_t rows = patch_.v.size(), last = patch_.u.size() - 1;
    const std::size_t a = node.first / rows, b = node.second / rows;
    if (a == 0 && b == 0) return PatchEnd::Low;
    return a == last && b == last ? PatchEnd::High : PatchEnd::Inside;
  }

  /// On the surface: regula falsi with halved ends (Illinois) along the side in the chart.
  [[nodiscard]] Point3 place(const Node& node) const {
    if (node.first == node.second) return patch_.points[node.first];
    const Point from = patch_.place(node.first), to = patch_.place(node.second);
    double low = 0.0, high = 1.0, f_low = values_[node.first], f_high = values_[node.second];
    Point3 found{};
    int last = 0;
    for (int round = 0; round < 60; ++round) {
      const double t = low + (high - low) * f_low / (f_low - f_high);
      found = patch_.surface.at(geom::interpolate(from, to, t));
      const double f = function_.at(found);
      if (std::abs(f) <= 1e-4 * zero_ || !(t > low && t < high)) break;
      if ((f < 0.0) == (f_low < 0.0)) {
        low = t, f_low = f;
        if (last == -1) f_high *= 0.5;
        last = -1;
      } else {
        high = t, f_high = f;
        if (last == 1) f_low *= 0.5;
        last = 1;
      }
    }
    return found;
  }

  const Patch& patch_;
  Linear function_;
  double zero_;
  std::vector<double> values_;
  std::set<std::pair<Node, Node>> parts_;
  std::map<Node, std::vector<Node>> neighbours_;
  LevelSet set_;
};

}  // namespace

LevelSet level_set(const Patch& patch, const Linear& function, double zero) {
  return Levels(patch, function, zero).run();
}

}  // namespace dobra::surf::loft
