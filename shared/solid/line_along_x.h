#pragma once
// How often solids surround a point: a line from it along x, moved by (e^3, e, e^2) for an infinitely small e, so that
// it passes no edge and no vertex. Exact.

#include <array>
#include <utility>
#include <vector>

#include "shared/solid/box_tree.h"

namespace dobra::solid {

/// (operand, winding number other than 0), ascending.
using Windings = std::vector<std::pair<std::uint32_t, int>>;

void add_step(Windings& windings, std::uint32_t operand, int step);

class LineAlongX {
 public:
  LineAlongX(const Soup& soup, const Homogeneous& from);

  /// Of the point moved by (e^3, e, e^2).  @cost O(log n + facets whose boxes the line meets)
  [[nodiscard]] Windings windings(const std::vector<BoxTree>& trees) const;
  /// Whether the point itself lies on a facet or its border.
  [[nodiscard]] bool starts_on_facet(const std::vector<BoxTree>& trees) const;

 private:
  [[nodiscard]] int crossing(const Facet& facet) const;
  [[nodiscard]] bool holds(const Facet& facet) const;
  [[nodiscard]] geom::Sign side(const Facet& facet) const;
  [[nodiscard]] geom::Sign compare(int axis, PointId p) const;
  [[nodiscard]] geom::Sign turn(int u, int v, PointId p, PointId q) const;
  [[nodiscard]] bool passes_right_of(PointId a, PointId b) const;

  const Soup& soup_;
  Homogeneous from_;
  std::array<double, 3> near_{};
  std::array<double, 3> slack_{};  // of near_
};

}  // namespace dobra::solid
