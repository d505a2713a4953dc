#pragma once
// The line that the tops of all blocks are restored to where that is no level datum: a regional dip, the topography.
// Page: docs/algorithms/jigsaw.md

#include <vector>

#include "recon/section/section.h"
#include "recon/unfold/restore.h"

namespace recon::jigsaw {

class TargetLine {
 public:
  /// @param points  x grows or falls all the way; the ends go on straight, by `beyond` metres.
  /// @error BadValue: fewer than two points, an x that turns back, with the place.
  static base::Result<TargetLine> make(std::vector<geom::Point> points, double beyond);

  /// From left to right.
  [[nodiscard]] const geom::Polyline& line() const { return line_; }
  [[nodiscard]] double z(double x) const;
  /// A place on the line, moved by as much as a block that slides `by` metres along a level datum: along the line, or
  /// of shear across its direction.
  [[nodiscard]] geom::Point slid(geom::Point from, double by, const unfold::RestoreParams& params) const;
  /// What of a line lies on the side of the layers: its longest stretch there.
  [[nodiscard]] geom::Polyline clipped(const geom::Polyline& line, section::LayerSide side) const;

 private:
  geom::Polyline line_;
};

}  // namespace recon::jigsaw
