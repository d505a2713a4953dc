#pragma once
// Charts without poles: where a side of a chart is one point (the pole of a sphere, the apex of a cone, a corner of a
// Coons patch), a face that touches it gets a chart in which it is one ordinary point. The new chart is polar: a full
// turn that closes is a disk without a seam, a part of a turn a sector of the true angle. Page:
// docs/algorithms/trimming.md.

#include <functional>

#include "shared/surf/trim/recognise.h"

namespace dobra::surf::trim {

/// The name of edges that are on the surface only to cut it: both sides of a seam, and the line between two charts of
/// one face. They carry numbers, by which the mesh is joined there; its nodes on them may move off afterwards.
inline constexpr const char* artificial_border = "artificial border";

/// A face, or a part of it, in a chart without poles.
struct Opened {
  TrimmedSurface face;
  /// From its chart to that of the face it is of; the pole itself to the middle of the side that it is.
  std::function<geom::Point(geom::Point)> back;
  bool polar = false;  ///< It has another chart than the face.
};

/// Whether a surface comes to a tip, such as that of a cone: normals within a ten thousandth of `radius`, in the chart,
/// are more than 5 degrees apart.
bool has_tip(const Surface& surface, geom::Point at, double radius);

/// Which sides that are points a face touches: those on which an edge of it lies or ends.
std::vector<Side> poles_touched(const TrimmedSurface& face);

/// The chart of a surface round one of its poles: (x, y) = r (cos a, sin a), in m about the pole. Derivatives follow by
/// the chain rule; within 1e-6 of the radius of the pole, where they would be lost, they are the limits there (first
/// ones along the ray, second ones those of the surface that bends most alike).
struct PolarChart {
  Surface surface;
  std::function<geom::Point(geom::Point)> back;
  std::function<geom::Point(geom::Point)> forward;
  std::function<Curve(const Curve&)> mapped;  ///< A curve of the old chart in the new one.
  double angle = 0.0;                         ///< Of the sector; 2 pi: a disk.
  double radius = 0.0;
  /// The turn closes, but round so slender a tip that it is a sector: of the disk chords would pass over each other.
  bool seam = false;
};
/// @param reach  how far from the pole, by part of the range across the side, the chart is asked for
/// @pre the side is one point, the opposite one is not within reach
/// @error those of Surface::of
base::Result<PolarChart> polar_chart(const Surface& surface, Side pole, double reach = 1.0);

/// The face as it is, if it touches no pole; in a polar chart if one; cut in two of them if two opposite ones, at the
/// middle or, where lines run along there, end or turn back, beside it. Edges along poles vanish, both sides of a seam
/// too where the turn closes round a pole that is no slender tip. Those that the cut divides get numbers of their own,
/// if they had one.
/// @error NotSupported: a face that touches poles on sides that meet, with the place; those of recognise
base::Result<std::vector<Opened>> open(const TrimmedSurface& face, SharedNumbers& numbers,
                                       const RecogniseOptions& options = {});

/// Whether a point of the chart lies inside the loops of a face; beside its edges by a thousandth of the chart it may
/// answer either.
bool contains(const TrimmedSurface& face, geom::Point uv);

/// Both ranges of a chart as lengths in space, m: those of the lines through its middle. Source: [miranda2009surface],
/// (6) and (7).
geom::Vector chart_lengths(const Surface& surface);

}  // namespace dobra::surf::trim
