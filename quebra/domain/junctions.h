#pragma once
// Where the curves of a domain meet: crossings and ends that lie on another curve become nodes of both. Crossings of
// straight pieces are exact; those with arcs and smooth curves are refined from their chords by Newton's method. Points
// that fall together (within the tolerance) are one, an end before a vertex before a computed crossing.

#include <vector>

#include "quebra/domain/domain.h"
#include "shared/base/result.h"

namespace quebra::domain {

/// Fills domain.junctions. @pre ends that meet are equal.
/// @param places     one a curve.
/// @param tolerance  m; what is nearer is one point.
/// @error SelfIntersection with the place: boundary curves that meet away from their ends, curves that overlap, a curve
///        that crosses itself.
/// @cost  O(n log n + meetings) for n chords.
dobra::base::Result<void> find_junctions(Domain& domain, const std::vector<dobra::base::Place>& places,
                                         double tolerance);

/// Where along a curve a point of the domain lies on it: its ends and junctions. @pre find_junctions
std::vector<double> places_on(const Domain& domain, std::size_t curve, dobra::geom::Point p);

/// The cracks that give a point of the domain a node on each of their lips: those through it, or that end there on the
/// boundary or on each other. A tip has one node.
std::vector<std::size_t> cracks_through(const Domain& domain, dobra::geom::Point p);

}  // namespace quebra::domain
