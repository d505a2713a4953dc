#pragma once
// Lines on a vertical plane in space, as sections come out of 3D programs: the plane is found by least squares, its
// misfit told, and the lines are laid into it; the trace takes them back. Page: docs/algorithms/section_plane.md.

#include <string>
#include <utility>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::lines {

/// The vertical plane nearest to all points of the features: its trace is the line of least squares (of distances) of
/// their places on the map. It runs towards the east (north where it is due north), and begins at the first point along
/// it; a plane exactly along the x or the y axis keeps that axis's coordinate instead.
/// @pre   every feature has heights.
/// @error BadFormat: all points stand over one place.
/// @cost  O(points).
base::Result<Trace> fit_trace(const std::vector<Feature>& features);

/// The trace from one place on the map to another, without misfits. @error InvalidOption: the two are one.
base::Result<Trace> trace_between(geom::Point from, geom::Point to);

/// `trace` with the misfits of these features. @pre every feature has heights.
Trace with_misfit(Trace trace, const std::vector<Feature>& features);

/// How far the features reach along the trace, from the first point to the last, m.
double length_along(const Trace& trace, const std::vector<Feature>& features);

/// Lays the features into the plane: x along the trace, y the height; heights are dropped.
/// @error DegenerateCurve with the feature and the place: nothing but one point is left of a line.
base::Result<void> lay_into_plane(std::vector<Feature>& features, const Trace& trace);

/// The axis of a cylindrical fold: the way that its hinge line goes down.
struct FoldAxis {
  base::Angle trend;   ///< From north, clockwise.
  base::Angle plunge;  ///< Below the horizontal, between -90 and 90 degrees.
};

/// Lays the features into the plane across the axis, each point along the axis, as if one looked down the plunge: x is
/// horizontal, towards trend + 90 degrees, y the steepest way up in the plane; the place 0, 0, 0 becomes 0, 0.
/// @error as lay_into_plane.  Source: [ragan2009] for the construction.
base::Result<void> project_along(std::vector<Feature>& features, const FoldAxis& axis);

/// The compass points, of sixteen, at the two ends of a section that runs towards `azimuth`: "W", "E".
std::pair<std::string, std::string> ends_of(base::Angle azimuth);
/// Where x of a section runs to, from north, clockwise.
base::Angle azimuth_of(const Trace& trace);
base::Angle azimuth_of(const FoldAxis& axis);

/// The reverse: map coordinates and heights.
std::vector<Feature> out_of_plane(std::vector<Feature> features, const Trace& trace);

}  // namespace dobra::io::lines
