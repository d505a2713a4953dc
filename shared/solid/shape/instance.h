#pragma once
// Instances: solids by a few numbers. All stand on the plane z = 0 or about the origin; a matrix places them
// (placement.h). Page: docs/algorithms/sweeps.md. Source: [requicha1980representations] (primitive instancing).

#include "shared/solid/shape/profile.h"

namespace dobra::solid::shape {

/// Of the circles that polygons stand for.
struct Roundness {
  int segments = 64;  ///< Corners of a circle; at least 3.
  int rows = 32;      ///< Of a sphere from pole to pole, of a torus round its tube; at least 2, or 3 of a torus.
};

// @error InvalidOption: a size that is not above 0 and finite, or too few segments; the name of the size is in the
//        message.

/// From the origin to (x, y, z): left, right (in x), front, back (in y), bottom, top.
base::Result<Shape> block(geom::Vector3 size);
/// Over a regular polygon about the origin, whose first corner lies on the x axis: bottom, top, side_1 ...
base::Result<Shape> prism(int sides, double radius, double height);
/// The same, to a point above the origin: bottom, side_1 ...
base::Result<Shape> pyramid(int sides, double radius, double height);
/// bottom, top, side.
base::Result<Shape> cylinder(double radius, double height, const Roundness& roundness = {});
/// A top radius of 0 makes a point: bottom, side; else top too.
base::Result<Shape> cone(double radius, double top_radius, double height, const Roundness& roundness = {});
/// About the origin: side.
base::Result<Shape> sphere(double radius, const Roundness& roundness = {});
/// A tube of `minor_radius` about a circle of `radius` in the plane z = 0: side.
base::Result<Shape> torus(double radius, double minor_radius, const Roundness& roundness = {});

}  // namespace dobra::solid::shape
