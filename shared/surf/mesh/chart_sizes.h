#pragma once
// The sizes wanted on a surface: a quadtree in the scaled chart, whose corners have sizes that count in space. They are
// the least of what is asked: largest size, turn of the normal, chord error, lengths of the given sides, requests; and
// grow from there by lengths in space. Page: docs/algorithms/surface_front.md.

#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/mesh/front/space.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/mesh/scaled_chart.h"
#include "shared/surf/mesh/tips.h"

namespace dobra::surf::mesh {

/// A side that stands already and asks for elements of its length.
struct GivenSide {
  geom::Segment chart;  ///< In the scaled chart.
  double length = 0.0;  ///< In space, m.
};

struct ChartSizes {
  dobra::mesh::sizing::SizeField field;              ///< Over the scaled chart.
  std::vector<dobra::mesh::front::LeafScale> scale;  ///< One a cell; meaningful for leaves.
  std::vector<double> triangles;                     ///< One a cell: about how many fill a leaf.
};

/// @param requests  in the scaled chart, sizes in space.
/// @param tips      places in space where the curvature has no bound. Within a hundredth of the largest size of one,
///                  curvature counts as at that distance: smaller triangles do not turn less there.
/// @error InvalidOption with the option's name; TooManyElements with advice; Cancelled.
/// @cost  some jets of the surface for each cell.
base::Result<ChartSizes> chart_sizes(const ScaledChart& chart, std::span<const GivenSide> sides,
                                     std::span<const dobra::mesh::delaunay::SizeRequest> requests,
                                     std::span<const Tip> tips, const SizeOptions& options,
                                     const base::Progress& progress = {});

/// L of the options, or a twentieth of the surface.
double largest_size(const Surface& surface, const SizeOptions& options);
/// The size that the shape of the surface asks for: by turn and chord; infinite where it is flat, or has no normal.
double size_by_shape(const Jet& jet, const SizeOptions& options);
/// The same for a greatest curvature, 1/m.
double size_by_bend(double bend, const SizeOptions& options);
/// The size up to which triangles of a graph are not turned round in the chart: where it is steep, straight lines of
/// the chart bend sideways on it, more than it bends itself. Infinite for surfaces that are no graphs, and where they
/// do not.
double size_by_chart(const Jet& jet, const SizeOptions& options);
/// The extent of bends that are not followed, m: a thousandth of the largest size, a quarter of the chord where one is
/// asked. Coordinates of files are rounded, which bends surfaces without bound beside a side that is one point.
double unnoticed_bend(double largest, const SizeOptions& options);
/// The greatest curvature that sizes follow at a place, 1/m: that of the jet, but no bend of less extent. Where the jet
/// bends by more than the turn within it, or the chart is next to one point or one line in space, the normals at four
/// places diagonally beside it, so far away, must turn by more than the turn (15 degrees where none is asked), or they
/// tell the bend.
/// @cost  six jets there, else none
double followed_bend(const Surface& surface, geom::Point uv, const Jet& jet, double extent, const SizeOptions& options);

}  // namespace dobra::surf::mesh
