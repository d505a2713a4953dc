#pragma once
// A sheet with a place in the plane for each point: which triangle holds a place of the chart, and what it says there.
// Page: docs/algorithms/parametrise.md. Source: [miranda2005triangular] (2), (3).

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "shared/geom/spatial_index.h"
#include "shared/surf/param/sheet.h"
#include "shared/surf/surface.h"

namespace dobra::surf::param {

/// A triangle and the barycentric coordinates of a place in it.
struct Located {
  std::uint32_t triangle = 0;
  std::array<double, 3> at{};
  bool inside = true;        ///< Else the nearest place of the border is meant,
  geom::Vector beyond = {};  ///< and this is the step from there.
};

/// Any number of threads may ask at once.
class DiscreteChart {
 public:
  /// @pre one place a point, no triangle flipped (flipped_triangles)  @cost O(n log n)
  DiscreteChart(Sheet sheet, std::vector<geom::Point> uv);

  [[nodiscard]] const Sheet& sheet() const { return sheet_; }
  [[nodiscard]] const std::vector<geom::Point>& uv() const { return uv_; }
  [[nodiscard]] geom::Box box() const { return index_.box(); }

  /// On a side or a vertex the triangle of the lowest number. @param hint  a triangle that may be near
  /// @cost O(log n); a few steps near the hint
  [[nodiscard]] Located locate(geom::Point uv, std::optional<std::uint32_t> hint = std::nullopt) const;
  /// Barycentric coordinates in a triangle, of any place.
  [[nodiscard]] std::array<double, 3> coordinates(std::uint32_t triangle, geom::Point uv) const;
  /// Derivatives of the coordinates, by u and v.
  [[nodiscard]] std::array<geom::Vector, 3> slopes(std::uint32_t triangle) const;
  /// Numbers of the triangles whose boxes overlap a part of the chart.
  template <class Visit>
  void for_each_in(const geom::Box& part, Visit&& visit) const {
    index_.for_each_overlapping(part, [&](std::size_t t) { visit(static_cast<std::uint32_t>(t)); });
  }

 private:
  [[nodiscard]] std::optional<Located> walk(geom::Point uv, std::uint32_t from) const;
  Sheet sheet_;
  std::vector<geom::Point> uv_;
  geom::SpatialIndex index_;
  std::vector<HalfEdge> border_;
  geom::SpatialIndex border_index_;  ///< By number in border_.
};

/// The value at the vertices between them: f(x) = a f(v0) + b f(v1) + c f(v2). Continuous; its derivatives jump.
template <class T>
T barycentric(const DiscreteChart& chart, const std::vector<T>& values, const Located& place) {
  const auto& t = chart.sheet().triangles[place.triangle];
  return place.at[0] * values[t[0]] + place.at[1] * values[t[1]] + place.at[2] * values[t[2]];
}

/// The sheet itself over its chart: plane in each triangle. Beyond its border its tangent plane goes on. Its bend()
/// counts the jumps of its derivatives in a part as if they were spread over it: an estimate, no bound.
/// @error those of Surface::of
base::Result<Surface> plane_pieces(std::shared_ptr<const DiscreteChart> chart);

}  // namespace dobra::surf::param
