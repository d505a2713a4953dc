#pragma once
// Parallel fault-propagation folds: the tip of a ramp climbs from a flat while the fold in front of it takes up all
// slip. Beds keep their thickness. Page: docs/algorithms/propagation_fold.md. Source: [suppe1990].

#include <optional>

#include "recon/kinematics/affine_piece.h"
#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace recon::kinematics {

struct PropagationAngles {
  base::Angle theta;          ///< Of the ramp against the beds.
  base::Angle gamma_star;     ///< Axial angle of the fold's front: the forelimb dips 180 degrees - 2 gamma*.
  base::Angle gamma_1;        ///< Axial angle of the bend.
  base::Angle gamma;          ///< From the beds to the wall in front of the fold.
  base::Angle beta_2;         ///< 180 degrees - 2 gamma*.
  double propagation = 0.0;   ///< P/S: how far the tip goes a metre of slip.
  double r1 = 0.0, r2 = 0.0;  ///< Speeds over the front limb, above and below the branch of the axial planes.
};

/// @error CannotRestore, without a place: theta <= 0, or >= 60 degrees, where P/S grows without bound.
base::Result<PropagationAngles> propagation_angles(base::Angle theta);

/// Points in the footwall stay. Exact, affine in pieces, det F = 1.
class PropagationMap {
 public:
  PropagationMap() = default;
  /// @param path      lower flat, along which the beds lie, and one ramp; the ramp's length does not count.
  /// @param ramp      of a path of the flat alone: the ramp's angle to it.
  /// @param from, to  slip since the tip was at the bend, m, >= 0; to < from restores.
  /// @error CannotRestore: slip < 0; more than one bend, or none and no ramp, with the place; angles as above.
  static base::Result<PropagationMap> make(const FaultPath& path, std::optional<base::Angle> ramp, double from,
                                           double to);

  [[nodiscard]] PropagationMap swapped() const;
  void piece(geom::Point p, Wall on_fault, AffinePiece& here) const;
  [[nodiscard]] const PropagationAngles& angles() const { return angles_; }
  [[nodiscard]] Tip tip() const;
  [[nodiscard]] double size() const { return size_; }

 private:
  PropagationAngles angles_;
  geom::Point bend_;
  geom::Vector along_{1.0, 0.0};  ///< The flat, unit.
  geom::Vector out_{0.0, 1.0};    ///< Into the hanging wall.
  double from_ = 0.0, to_ = 0.0;
  double size_ = 1.0;  ///< m
};

}  // namespace recon::kinematics
