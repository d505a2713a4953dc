#pragma once
// The line along which a hanging wall moves, and on which side of it, how far along it and how far from it a point
// lies. Both ends of the line go on straight. Page: docs/algorithms/cutoffs.md

#include <optional>

#include "shared/geom/polyline.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::kinematics {

/// Side of travel.
enum class Side { Left, Right };
/// How a point that lies on the fault counts.
enum class Wall { Hanging, Foot };

struct FaultPath {
  geom::Polyline line;        ///< Open, n >= 2 distinct points, m, from the lower end to the higher one.
  Side hanging = Side::Left;  ///< Where the hanging wall lies.
  bool level = false;         ///< Both ends equally high, from -x to +x: what is up along it has to be said.
  bool tip_at_begin = false;  ///< Ends in rock there. Otherwise the fault leaves the section and goes on straight.
  bool tip_at_end = false;
};

/// Where the end of a fault lies at both states of a map.
struct Tip {
  geom::Point before, after;
};

struct OnPath {
  double arc = 0.0;       ///< m from the path's first point; beyond the ends below 0 and above its length.
  double distance = 0.0;  ///< m, > 0 in the hanging wall.
};

/// The nearest point of the path, of equally near ones the first.  @cost O(n)
OnPath nearest(const FaultPath& path, geom::Point p);

/// Without vertices at which it bends no more than rounding does: what ends on it, or a tip that stood there, may have
/// left some.
FaultPath straightened(FaultPath path);

/// The point at a distance along the path, m.
geom::Point point_at(const FaultPath& path, double arc);

/// Which wall p lies in, by exact predicates against what is nearest of the path; on the path: nothing.
/// @pre the path, with both ends going on straight, does not meet itself.  @cost O(n)
std::optional<Wall> wall_of(const FaultPath& path, geom::Point p);

}  // namespace recon::kinematics
