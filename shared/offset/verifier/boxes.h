#pragma once
// For the verifier: places with 64-bit mantissas, and a tree of boxes. Nothing here is the engine's.

#include <cmath>
#include <cstdint>
#include <vector>

#include "shared/geom/box.h"

namespace dobra::offset::verifier {

/// A place or a displacement with 64-bit mantissas.
struct Wide {
  long double x = 0;
  long double y = 0;
  friend Wide operator+(Wide a, Wide b) { return {a.x + b.x, a.y + b.y}; }
  friend Wide operator-(Wide a, Wide b) { return {a.x - b.x, a.y - b.y}; }
  friend Wide operator-(Wide a) { return {-a.x, -a.y}; }
  friend Wide operator*(long double f, Wide a) { return {f * a.x, f * a.y}; }
};
inline Wide wide(geom::Point p) { return {p.x, p.y}; }
inline geom::Point narrow(Wide a) { return {static_cast<double>(a.x), static_cast<double>(a.y)}; }
inline long double dot(Wide a, Wide b) { return a.x * b.x + a.y * b.y; }
inline long double cross(Wide a, Wide b) { return a.x * b.y - a.y * b.x; }
inline long double size(Wide a) { return std::hypot(a.x, a.y); }
inline Wide right_of(Wide a) { return {a.y, -a.x}; }
inline Wide unit(Wide a) { return (1 / size(a)) * a; }

/// Point of [a, b] nearest to p.
Wide nearest_on(Wide a, Wide b, Wide p);
/// An arc about `centre`, anticlockwise from a to b, at most half a turn: true if the direction of p lies in it.
bool in_sector(Wide centre, Wide a, Wide b, Wide p);

/// Boxes in the order of a chain, halved again and again.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(const std::vector<geom::Box>& boxes);

  /// Calls visit(item) for all items whose boxes, and those of all their parents, `wants` accepts, until visit says
  /// true.
  template <class Wants, class Visit>
  void each(Wants&& wants, Visit&& visit) const {
    if (boxes_.empty()) return;
    std::uint32_t open[80];
    std::size_t count = 0;
    open[count++] = 1;
    while (count > 0) {
      const std::uint32_t node = open[--count];
      if (boxes_[node].empty() || !wants(boxes_[node])) continue;
      if (node >= leaves_) {
        if (visit(static_cast<std::size_t>(node - leaves_))) return;
        continue;
      }
      open[count++] = 2 * node + 1;
      open[count++] = 2 * node;
    }
  }

 private:
  std::uint32_t leaves_ = 1;
  std::vector<geom::Box> boxes_;  // children of i are 2 i and 2 i + 1; the root is 1
};

long double gap(const geom::Box& box, Wide p);
/// Least distance of segment [a, b] from a box, not more than it is, and 0 or the like if they meet.
long double gap(const geom::Box& box, Wide a, Wide b);
geom::Box box_round(Wide a, Wide b);

}  // namespace dobra::offset::verifier
