#pragma once
// What of a raw offset curve is nearer than D to the base, for the stepper on closed contours: plain distances in
// doubles, with nothing of the engine's, so that the two can be held against each other. Boxes of consecutive segments
// prune the search.

#include <optional>
#include <vector>

#include "shared/geom/polyline.h"
#include "shared/offset/kernel/base_curve.h"

namespace dobra::offset::stepper {

class StepperJudge {
 public:
  StepperJudge() = default;
  /// Asked in the frame of stepper_point().
  StepperJudge(const BaseCurve& base, double distance, const OffsetOptions& options);

  /// True if the middle of the edge lies within the distance of the base, or in the corner that some join adds.
  [[nodiscard]] bool middle_is_near(const geom::Segment& edge, std::uint32_t base_segment) const;
  /// True if all of the edge does, as far as can be told; false where in doubt.
  [[nodiscard]] bool buried(const geom::Segment& edge, std::uint32_t base_segment) const;

 private:
  struct Nearest {
    std::size_t segment = 0;
    double distance = 0.0;
  };
  /// What a join adds beyond the arc about a corner: convex, anticlockwise.
  struct Spike {
    std::vector<geom::Point> points;
    geom::Box box;
  };
  [[nodiscard]] Nearest nearest(geom::Point q) const;
  [[nodiscard]] bool near(geom::Point q) const;
  [[nodiscard]] bool holds(const Spike& spike, geom::Point q, double margin) const;
  [[nodiscard]] const Spike* spike_at(geom::Point q) const;
  [[nodiscard]] bool buried(const geom::Segment& edge, const geom::Point* corner, int depth, int& budget) const;
  [[nodiscard]] geom::Point lifted(geom::Point q, const geom::Point* corner) const;
  [[nodiscard]] std::optional<geom::Point> bevelled_corner(const geom::Segment& edge, std::uint32_t base_segment) const;
  void add_spikes(const BaseCurve& base, const OffsetOptions& options);

  geom::Polyline base_;
  double distance_ = 0.0;
  double near_ = 0.0;  // below this, q counts as nearer than the distance
  std::size_t leaves_ = 1;
  std::vector<geom::Box> boxes_;  // of runs of segments, heap order; leaves hold `leaf` segments
  std::vector<Spike> spikes_;
  std::size_t spike_leaves_ = 1;
  std::vector<geom::Box> spike_boxes_;
};

/// A point of the base's own frame in that of the stepper: the user's coordinates, mirrored in y if the left side was
/// chosen.
geom::Point stepper_point(const BaseCurve& base, Vec p);

}  // namespace dobra::offset::stepper
