#pragma once
// The paper's construction of one offset curve, edge by edge, on the half-edge subdivision: the reference, and what the window
// shows (figure 5). Each step inserts the raw offset edge of one base segment; where it meets the curve so far, a region has
// closed, and the edges from the earlier visit of that vertex to the later one are deleted, nearest crossing first.
// Limits, which are the paper's: at open ends no region closes, so tails nearer than D to the base may stay; a region is judged
// by its orientation only. The engine (offset.h) has neither limit.
// Source: [carvalho2005offset], requirements E-3 to E-5.

#include <vector>

#include "shared/offset/base_curve.h"
#include "shared/offset/offset.h"
#include "shared/topo/insert.h"

namespace dobra::offset {

class Stepper {
 public:
  /// What one step did. Entities that the same step deleted again are listed, but exist no longer.
  struct Step {
    std::uint32_t base_segment = 0;           ///< In the user's curve.
    geom::Segment edge;                       ///< The raw edge, in the user's coordinates.
    std::vector<topo::EdgeId> inserted;
    std::vector<topo::FaceId> formed;         ///< Regions that the insertion closed.
    std::vector<topo::EdgeId> deleted;
    std::vector<geom::Segment> deleted_edges; ///< Where those were.
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
  struct Link {
    topo::VertexId to;
    std::uint32_t raw;  ///< Raw edge that it is a part of.
  };
  Stepper() = default;
  [[nodiscard]] geom::Point raw_point(std::size_t i) const;
  [[nodiscard]] std::ptrdiff_t position(topo::VertexId v) const;
  [[nodiscard]] std::vector<topo::HalfEdgeId> way(topo::VertexId from, topo::VertexId to) const;
  void close_loop(std::ptrdiff_t at, topo::VertexId v, Step& step);
  [[nodiscard]] OffsetPiece piece(topo::VertexId start, const std::vector<Link>& links, bool closed) const;

  BaseCurve base_;
  RawChain chain_;
  double distance_ = 0.0;
  double orientation_ = 0.0;  ///< Signed area of a closed base, as mirrored; 0 for an open one.
  std::size_t first_ = 0;     ///< Raw edge that a closed curve starts with.
  std::size_t next_ = 0;
  topo::Subdivision subdivision_;
  topo::VertexId start_;
  std::vector<Link> links_;
  std::vector<OffsetPiece> finished_;
  bool closed_up_ = false;
};

/// All steps. @error as Stepper::start and step.
base::Result<OffsetCurve> run_stepper(const geom::Polyline& curve, double distance, const OffsetOptions& options);

}  // namespace dobra::offset
