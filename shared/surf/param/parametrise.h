#pragma once
// The discrete parameter space of a disk-like sheet: its border on a convex line or on straight lines between border
// stones, its inside by a convex combination of neighbours. Page: docs/algorithms/parametrise.md.
// Sources: [floater1997] (shape-preserving weights), [floater2003] (mean value coordinates), [miranda2005triangular].

#include <vector>

#include "shared/geom/point.h"
#include "shared/surf/param/sheet.h"

namespace dobra::surf::param {

struct StoneOptions {
  double turn = 40.0;  ///< Degrees by which the border turns at a stone, to either side, at least.
};

/// Border stones: the vertices of the loop at which the border turns sharply, in space. In the order of the loop.
/// A turn is judged between the sides next to the vertex. @cost O(n)
std::vector<std::uint32_t> border_stones(const Sheet& sheet, const std::vector<std::uint32_t>& loop,
                                         const StoneOptions& options = {});

/// Each a weight of the neighbours of a vertex inside: positive, of sum 1.
enum class Weights : std::uint8_t {
  ShapePreserving,  ///< Reproduces plane sheets.
  MeanValue,        ///< So does this; smooth in the places of the vertices.
};

/// Where the border lies.
enum class BorderShape : std::uint8_t {
  Stones,  ///< Straight between stones, which are projected to their mean plane.
  Circle,  ///< A circle, by arc length: strictly convex, so that no triangle can be flipped.
  Auto,    ///< Stones; the circle where they are fewer than three, their polygon crosses itself, or a triangle flips.
};

struct ParametriseOptions {
  Weights weights = Weights::ShapePreserving;
  BorderShape border = BorderShape::Auto;
  StoneOptions stones = {};
  std::vector<std::uint32_t> given_stones = {};  ///< Of the border, in its order; empty: they are found.
};

struct Neighbour {
  std::uint32_t vertex = 0;
  double weight = 0.0;
};
/// The weights of the ring of a vertex inside, in its order. Where a flattened angle is half a turn or more, so that no
/// positive shape-preserving weights exist, those of mean value. @pre first is a half-edge that starts in it
std::vector<Neighbour> ring_weights(const Sheet& sheet, HalfEdge first, Weights weights);

struct Parametrisation {
  std::vector<geom::Point> uv;         ///< One a point; within 0 .. 1, the longer side of their box is 1.
  std::vector<std::uint32_t> stones;   ///< None on a circle.
  BorderShape border;                  ///< Stones or Circle.
  std::vector<std::uint32_t> flipped;  ///< Triangles that are not anticlockwise, by exact orientation.
  /// Why Auto took the circle: one line, empty where it did not.
  std::string why_circle = {};
  double scale = 1.0;  ///< m of the projection plane a unit of the chart; 0 on a circle.
};

/// @pre sheet.disk()
/// @error InvalidOption: given stones that are fewer than three, not on the border or out of order; CannotMesh: Stones
///        where there are fewer than three, or they lie on a line, with the place; CannotSolve.
/// @cost  O(n^1.5), a sparse solution with two right-hand sides
base::Result<Parametrisation> parametrise(const Sheet& sheet, const ParametriseOptions& options = {});

/// The inside for a border that stands. @param uv  the places of the border are read, those inside are written.
/// @error CannotSolve
base::Result<void> solve_inside(const Sheet& sheet, Weights weights, std::vector<geom::Point>& uv);

/// Triangles that are not anticlockwise, exactly.
std::vector<std::uint32_t> flipped_triangles(const Sheet& sheet, const std::vector<geom::Point>& uv);

}  // namespace dobra::surf::param
