#pragma once
// A block that moves as a whole: turned about a pivot, then shifted. Page: docs/algorithms/rigid_and_shear.md

#include "recon/kinematics/affine_piece.h"
#include "recon/kinematics/amount.h"
#include "shared/geom/transform.h"

namespace recon::kinematics {

class RigidMap {
 public:
  RigidMap() = default;
  explicit RigidMap(geom::Vector by) : motion_(geom::Transform::translation(by)) {}
  /// Turned anticlockwise about the pivot, then shifted.
  RigidMap(base::Angle anticlockwise, geom::Point pivot, geom::Vector by = {})
      : motion_(geom::Transform::translation(by) * geom::Transform::rotation(anticlockwise, pivot)) {}

  [[nodiscard]] const geom::Transform& motion() const { return motion_; }
  [[nodiscard]] RigidMap swapped() const;
  void piece(geom::Point p, Wall on_fault, AffinePiece& here) const;

 private:
  geom::Transform motion_;
};

/// The unit vector from the path's first point to its last one.  @pre they differ.
geom::Vector chord(const FaultPath& path);

/// The shift along the chord, m.
/// @error CannotRestore where the chord is upright (heave), or level (throw).
base::Result<geom::Vector> shift_along_chord(const FaultPath& path, Amount amount);

}  // namespace recon::kinematics
