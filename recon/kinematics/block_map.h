#pragma once
// What moves a hanging wall, whatever the method: a finite map of the plane and its inverse, for points and for lines.
// Page: docs/algorithms/rigid_and_shear.md

#include <span>
#include <variant>

#include "recon/kinematics/flow_map.h"
#include "recon/kinematics/propagation_fold.h"
#include "recon/kinematics/rigid_map.h"
#include "recon/kinematics/trishear.h"
#include "recon/kinematics/walk.h"
#include "recon/maps/section_map.h"
#include "shared/base/progress.h"

namespace recon::kinematics {

/// A value, read from any number of threads. In the footwall the methods with a tip move nothing; of the others the map
/// goes on below the fault somehow, and what is to move is the caller's affair.
class BlockMap {
 public:
  BlockMap() = default;  ///< The identity.
  explicit BlockMap(RigidMap map) : map_(std::move(map)) {}
  explicit BlockMap(maps::SectionMap map) : map_(std::move(map)) {}
  explicit BlockMap(FlowMap map) : map_(std::move(map)) {}
  explicit BlockMap(PropagationMap map) : map_(std::move(map)) {}
  explicit BlockMap(TrishearMap map) : map_(std::move(map)) {}

  /// @param on_fault  how points on the fault behind a tip count.
  [[nodiscard]] geom::Point forward(geom::Point p, Wall on_fault = Wall::Hanging) const;
  [[nodiscard]] geom::Point inverse(geom::Point p, Wall on_fault = Wall::Hanging) const {
    return swapped().forward(p, on_fault);
  }
  /// In parallel, the same bytes at any number of threads; points near their neighbours in the span are faster.
  /// @param images  one a point. @error Cancelled
  base::Result<void> forward(std::span<const geom::Point> points, std::span<geom::Point> images,
                             Wall on_fault = Wall::Hanging, const base::Progress& progress = {}) const;
  /// A line, open or closed. Where it crosses the fault behind a tip, both images of the place are joined.
  [[nodiscard]] MovedLine forward(const geom::Polyline& line, Wall on_fault = Wall::Hanging) const;

  [[nodiscard]] BlockMap swapped() const;
  /// Of the formula that holds at p; of trishear by central differences.
  [[nodiscard]] maps::Gradient gradient(geom::Point p) const;
  /// Whether straight lines stay pieces of straight lines, and areas are kept to rounding.
  [[nodiscard]] bool piecewise_affine() const { return !std::holds_alternative<TrishearMap>(map_); }
  /// Of methods in which the tip of the fault moves.
  [[nodiscard]] std::optional<Tip> tip() const;

 private:
  std::variant<RigidMap, maps::SectionMap, FlowMap, PropagationMap, TrishearMap> map_;
};

}  // namespace recon::kinematics
