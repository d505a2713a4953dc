#pragma once
// For the verifier: whether the base leaves room for two parallels, decided exactly. What just touches counts as
// closed, so two places that are 2 D apart leave none; long doubles cannot tell that from an ulp more. Sums of doubles
// that do not overlap, as in [shewchuk1997predicates].

#include "shared/geom/point.h"

namespace dobra::offset::verifier {

enum class Room { None, Some, Unknown };  ///< Unknown only where products leave the range of doubles.

/// Are p and q more than 2 d apart?
Room between_points(geom::Point p, geom::Point q, double d);
/// Is p more than 2 d off the line through a and b?
Room beside_line(geom::Point a, geom::Point b, geom::Point p, double d);
/// Exactly.
bool parallel(geom::Point a, geom::Point b, geom::Point p, geom::Point q);

/// cross(b - a, q - p), rounded once, if no product of coordinates leaves the range of doubles.
long double cross_of(geom::Point a, geom::Point b, geom::Point p, geom::Point q);

}  // namespace dobra::offset::verifier
