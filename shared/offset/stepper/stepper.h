#pragma once
// The paper's construction of one offset curve, edge by edge, on the half-edge subdivision. It is the reference for the
// engine. Each step inserts the raw offset edge of one base segment. Where the edge meets the curve so far, a region
// has closed: the edges between the two visits of that vertex are deleted, nearest crossing first.
//
// Open curves follow the paper to the letter: at open ends no region closes, so tails nearer than D to the base may
// stay. On closed contours the region's edges are deleted only if all of it is nearer than D to the base. Otherwise
// they stand as part of the result, whichever way they turn: a second component, or a pocket. The last step deletes
// what of them is too near. So the result does not depend on the start. Cost: O(log n) an edge inserted and O(1) an
// edge deleted; on closed contours one more search of the base an edge. Page: docs/algorithms/offset.md. Source:
// [carvalho2005offset].

#include <span>
#include <vector>

#include "shared/offset/stepper/judge.h"
#include "shared/offset/types/curve.h"
#include "shared/topo/insert.h"

namespace dobra::offset::stepper {

class Stepper {
 public:
  /// What one step did. Entities that the same step deleted again are listed, but exist no longer.
  struct Step {
    std::uint32_t base_segment = 0;  ///< In the user's curve.
    geom::Segment edge;              ///< The raw edge, in the user's coordinates.
    std::vector<topo::EdgeId> inserted;
    std::vector<topo::FaceId> formed;  ///< Regions that the insertion closed.
    std::vector<topo::EdgeId> deleted;
    std::vector<geom::Segment> deleted_edges;  ///< Where those were.
  };

  /// @error as offset().
  static base::Result<Stepper> start(const geom::Polyline& curve, double distance, const OffsetOptions& options);

  [[nodiscard]] bool done() const { return next_ == chain_.segment.size(); }
  /// @pre !done()
  base::Result<Step> step();
  /// The curve so far.
  [[nodiscard]] OffsetCurve result() const;
  /// In the user's coordinates, mirrored in y if the left side was chosen.
  [[nodiscard]] const topo::Subdivision& subdivision() const { return subdivision_; }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  /// Of what an edge of the subdivision is a part; its attribute, so that parts know it too.
  struct Mark {
    std::uint32_t trail = none;  ///< Of the curve so far: this raw edge.
    std::uint32_t kept = none;   ///< Of a region that stands (closed contours).
  };
  Stepper() = default;
  [[nodiscard]] geom::Point raw_point(std::size_t i) const {
    return stepper_point(base_, chain_.points[i % chain_.points.size()]);
  }
  [[nodiscard]] std::uint32_t base_segment(std::uint32_t raw) const { return chain_.segment[raw]; }
  [[nodiscard]] Mark mark(topo::EdgeId e) const;
  [[nodiscard]] bool on_trail(topo::VertexId v) const;
  [[nodiscard]] double rounding(geom::Point p) const;
  base::Result<topo::VertexId> arrive(geom::Point p);
  base::Result<void> lead_through(topo::EdgeId e, geom::Point p);
  [[nodiscard]] geom::Polyline way_of(const geom::Segment& edge) const;
  [[nodiscard]] std::vector<topo::HalfEdgeId> trail(topo::VertexId from, topo::VertexId to) const;
  void advance(topo::HalfEdgeId h, std::uint32_t raw, std::span<const topo::HalfEdgeId> ahead, Step& step);
  [[nodiscard]] bool spurious(std::span<const topo::HalfEdgeId> region) const;
  void erase(topo::EdgeId e, Step& step);
  void erase_what_is_near(Step& step);
  [[nodiscard]] bool kept_way(topo::HalfEdgeId h) const;
  [[nodiscard]] topo::HalfEdgeId next_kept(topo::HalfEdgeId h) const;
  void add_contours(OffsetCurve& curve) const;
  [[nodiscard]] OffsetPiece piece(const std::vector<topo::HalfEdgeId>& way, bool kept, bool closed) const;

  BaseCurve base_;
  RawChain chain_;
  StepperJudge judge_;
  double distance_ = 0.0;
  std::size_t next_ = 0;
  topo::Subdivision subdivision_;
  topo::VertexId start_, end_;  ///< Of the curve so far.
};

/// All steps. @error as Stepper::start and step.
base::Result<OffsetCurve> run_stepper(const geom::Polyline& curve, double distance, const OffsetOptions& options);

}  // namespace dobra::offset::stepper
