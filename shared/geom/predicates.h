#pragma once
// Exact signs of the determinants on which all topology rests. Floating-point filter first, expansions where the filter
// cannot tell, and a fixed-point accumulator where expansions would overflow or underflow: exact for all finite input.
// Source: [shewchuk1997predicates], [kulisch2013accumulator]. Page: docs/algorithms/predicates.md.

#include "shared/geom/point.h"

namespace dobra::geom {

enum class Sign : int { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }
constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }
/// @pre value is not NaN.
constexpr Sign sign_of(double value) { return static_cast<Sign>((value > 0.0) - (value < 0.0)); }

/// Positive if a, b, c turn left (anticlockwise), Negative if right, Zero if collinear.
/// @cost about 5 ns where the filter decides; tens of ns (incircle: a microsecond) next to zero.
Sign orient2d(Point a, Point b, Point c);

/// For a, b, c anticlockwise: Positive if d lies inside their circle, Negative outside, Zero on it.
Sign incircle(Point a, Point b, Point c, Point d);

/// Sign of the cross product of the displacements a->b and c->d: Positive if c->d is anticlockwise of a->b, Zero if
/// parallel.
Sign cross_sign(Point a, Point b, Point c, Point d);

/// Sign of the dot product of the displacements a->b and c->d: Positive if they enclose less than 90 degrees.
Sign dot_sign(Point a, Point b, Point c, Point d);

}  // namespace dobra::geom
