#pragma once
// Points moved by an affine matrix, each coordinate rounded once. Page: docs/algorithms/csg.md.

#include <array>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"

namespace dobra::solid {

/// Row by row; applied to columns (x, y, z, 1).
using Matrix = std::array<double, 16>;

constexpr Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Cosine and sine; those of right angles are exact.
std::array<double, 2> circle_at(double degrees);

/// First `inner`, then `outer`; rounded.
Matrix product(const Matrix& outer, const Matrix& inner);
Matrix moved_by(geom::Vector3 by);
/// Anticlockwise about an axis through a point, in degrees; right angles about coordinate axes are exact.
/// @pre the axis is not zero
Matrix turned(geom::Point3 about, geom::Vector3 axis, double degrees);
/// @pre no factor is zero
Matrix scaled(geom::Point3 about, geom::Vector3 factors);
/// The z axis becomes the direction, the origin stays.  @pre direction is not zero
Matrix along(geom::Vector3 direction);

/// @error BadValue: not finite, a last row other than 0, 0, 0, 1, or a matrix that makes volumes flat.
base::Result<void> check_matrix(const Matrix& matrix);
/// Whether it turns left hands into right ones; exact.
bool mirrors(const Matrix& matrix);

/// How many points had to be rounded; each coordinate is the nearest double.
/// @error NotFinite if a coordinate grows too large.  @cost O(n)
base::Result<std::size_t> place(std::vector<geom::Point3>& points, const Matrix& matrix);

/// The place of an error moved with what it speaks of.  @error as place()
base::Result<void> put_error(base::Error& error, const Matrix& matrix);

}  // namespace dobra::solid
