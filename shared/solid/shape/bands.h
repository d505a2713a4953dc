#pragma once
// Bands of triangles between two copies of a line, with the volume of the ruled surface between them: places that are
// as far along both copies are joined by straight lines, the rulings. Page: docs/algorithms/section_loft.md. Source:
// [fuchs1977surface] (bands between contours); that four triangles hold the volume of a patch is shown there.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shared/geom/point3.h"
#include "shared/geom/polyline.h"

namespace dobra::solid::shape {

using Triangle = std::array<std::uint32_t, 3>;

/// Points along a line, and how far along each is, in ascending order.
struct Chain {
  std::vector<std::uint32_t> points;
  std::vector<double> at;
};

/// From how far along one line to how far along the next.
struct Ruling {
  double from = 0.0, to = 0.0;
};

/// Vertices of two lines that are joined, by their numbers.
struct Joint {
  std::size_t from = 0, to = 0;
};

/// Corners, where lines turn by 45 degrees or more, are joined in order, left turns to left turns and right turns to
/// right turns, if their places in the boxes of their lines differ by less than half of these: of all ways the one by
/// which most are joined, and nearest. The ends are joined; of an island the last is its first point once more.
/// @cost O(n + c d) for c and d corners
std::vector<Joint> joints_of(const geom::Polyline& a, const geom::Polyline& b);

/// Lines that follow each other, each with the places of its vertices; `breaks` come to hold the ends of all rulings.
struct RuledLines {
  std::vector<std::vector<double>> breaks;
  std::vector<std::vector<Ruling>> rulings;  ///< From each line to the next, in order along both.
};

/// A ruling at every vertex of either of two neighbours, to the place as far along the other from joint to joint.
/// Places within 1e-6 of the whole are one: vertices there are joined to each other, and no break is put beside
/// another.
/// @param joints  from each line to the next, with their ends.  @cost O(n log n) for n vertices
RuledLines ruled(const std::vector<std::vector<double>>& lines, const std::vector<std::vector<Joint>>& joints);

/// One triangle, and the number of the segment of the first chain that its cell stands on or ends at.
struct BandTriangle {
  Triangle corners;
  std::uint32_t segment = 0;
};

/// Triangles between two chains, anticlockwise seen from the right of the first one if the second lies beyond the plane
/// in which right is right. Between two rulings they bound the volume that the ruled surface bounds: a cell that is
/// plane to 1e-12 of its size is cut by its shorter diagonal, any other gets its middle as a point.
/// @pre  every end of a ruling is a place of its chain.  @cost O(n)
std::vector<BandTriangle> band(std::vector<geom::Point3>& points, const Chain& a, const Chain& b,
                               const std::vector<Ruling>& rulings);
/// The same without rulings and without points of its own: each triangle goes on along the chain whose next point comes
/// earlier.  @cost O(n)
std::vector<BandTriangle> band(const std::vector<geom::Point3>& points, const Chain& a, const Chain& b);

}  // namespace dobra::solid::shape
