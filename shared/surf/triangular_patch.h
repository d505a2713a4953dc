#pragma once
// The patch between three curves, by area coordinates u + v + w = 1: on each side it is the curve, inside the trilinear
// mean of what its sides say, straight lines between them. Page: docs/algorithms/triangular_patch.md.
// Sources: [gordon1973hall], [miranda2005triangular] (1).

#include <array>
#include <cstdint>
#include <vector>

#include "shared/surf/surface.h"

namespace dobra::surf {

/// Cheap to copy; any number of threads may ask at once.
class TriangularPatch {
 public:
  /// Curves follow each other round the triangle: from vertex u = 1 to v = 1, on to w = 1, and back. Each may run
  /// either way.
  /// @error DegenerateCurve: ends that do not meet to 1e-9 of the size of all, with the widest gap and its place
  static base::Result<TriangularPatch> make(const Curve& first, const Curve& second, const Curve& third);

  /// @pre u + v + w = 1, none negative; what is outside is the same formula with the curves gone on.
  [[nodiscard]] geom::Point3 at(double u, double v, double w) const;
  /// On the unit square, where v up from the first curve (bottom) to the last vertex (top, one point) is w, and u
  /// across the part of the way from the third curve (left) to the second (right). Second derivatives are within 1e-7
  /// of their size; bounds of bend() are half as much again as those of 17 x 17 places.
  [[nodiscard]] base::Result<Surface> surface() const;

  struct Corner {
    geom::Point3 at;
    geom::Vector3 by_u, by_v, by_w;                           ///< Derivatives, each coordinate taken alone.
    std::array<std::array<geom::Vector3, 3>, 3> second = {};  ///< By two of u, v, w.
  };
  [[nodiscard]] Corner jet(double u, double v, double w) const;

 private:
  /// A curve over 0 .. 1 in either direction.
  struct Side {
    Curve curve;
    double from = 0.0, to = 1.0;
    [[nodiscard]] Curve::Jet jet(double t) const;
  };
  struct Quotient {
    geom::Vector3 value, first, second;
  };
  explicit TriangularPatch(std::vector<Side> sides);
  [[nodiscard]] Quotient quotient(std::size_t corner, std::size_t towards, double x) const;

  std::vector<Side> sides_;             ///< From vertex k to the next.
  std::array<geom::Point3, 3> corner_;  ///< u, v, w.
};

/// The nodes at the crossings of n + 1 lines of each coordinate, and their triangles, turned as the curves run.
struct TriangularGrid {
  std::vector<geom::Point3> points;
  std::vector<std::array<double, 3>> places;  ///< u, v, w of each.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// (n + 1) (n + 2) / 2 nodes, those of the sides on the curves, and n^2 triangles. @pre n >= 1
TriangularGrid grid(const TriangularPatch& patch, std::uint32_t n);

}  // namespace dobra::surf
