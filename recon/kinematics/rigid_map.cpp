#include "recon/kinematics/rigid_map.h"

#include <cmath>

#include "recon/kinematics/refuse.h"

namespace recon::kinematics {

RigidMap RigidMap::swapped() const {
  RigidMap back;
  // A rotation and a shift: the transpose turns back, so that nothing is divided by.
  const auto m = motion_.matrix();
  const geom::Transform turned{m[0][0], m[1][0], 0.0, m[0][1], m[1][1], 0.0};
  const geom::Vector home = turned(geom::Vector{m[0][2], m[1][2]});
  back.motion_ = geom::Transform::translation(-home) * turned;
  return back;
}

void RigidMap::piece(geom::Point, Wall, AffinePiece& here) const {
  const auto m = motion_.matrix();
  here.origin = {};
  here.image = {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}};
  here.sides.clear();
}

geom::Vector chord(const FaultPath& path) {
  return geom::normalised(path.line.points.back() - path.line.points.front());
}

base::Result<geom::Vector> shift_along_chord(const FaultPath& path, Amount amount) {
  const geom::Vector along = chord(path);
  if (amount.as == Measure::Slip) return amount.value * along;
  const double part = std::abs(amount.as == Measure::Heave ? along.x : along.y);
  if (part <= 1e-9) {
    return refused(
        amount.as == Measure::Heave
            ? "the fault stands upright from end to end, so that slip along it has no heave; give slip or throw"
            : "the ends of the fault are level, so that slip along it has no throw; give slip or heave",
        path.line.points.front());
  }
  return (amount.value / part) * along;
}

}  // namespace recon::kinematics
