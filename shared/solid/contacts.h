#pragma once
// Where facets meet: for every pair that does, the segments and points on the line of their planes that both hold, or
// that they lie in one plane. Exact; what two facets have in common as edges and corners already is left out.

#include <utility>
#include <vector>

#include "shared/solid/box_tree.h"
#include "shared/solid/soup.h"

namespace dobra::solid {

/// What a facet is to be cut along; a point if both ends are one.
struct Cut {
  std::uint32_t facet;
  PointId a, b;
  PlaneId other;  ///< The plane that cuts.
};

struct Contacts {
  std::vector<Cut> cuts;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coplanar;  ///< Facets of one plane that may overlap.
  /// Pairs of one operand that meet otherwise than in common edges and corners, with a point of theirs.
  struct Inside {
    std::uint32_t f, g;
    PointId at;
  };
  std::vector<Inside> inside;
};

/// @param trees  one for each operand, over its facets.
/// @cost  O((n + pairs whose boxes overlap) log n); exact numbers only where the filters cannot tell.
Contacts contacts(Soup& soup, const std::vector<BoxTree>& trees);

/// The closed part of the line in which a facet meets a plane: points along it and whether it holds what follows.
struct Stop {
  PointId point;
  bool holds;  ///< The facet holds the way to the next stop.
  bool below;  ///< It holds the way just below the other plane.
};

/// The stops of a facet on the line of its plane and another, ascending along the axis.
/// @param signs  of its corners against the other plane.
void stops_along(Soup& soup, std::uint32_t facet, PlaneId other, const std::vector<geom::Sign>& signs, int axis,
                 std::vector<Stop>& stops);

/// An axis along which no two points of the line of both planes are equal; -1 if the planes are parallel.
int axis_of_line(const Space& space, PlaneId a, PlaneId b);

}  // namespace dobra::solid
