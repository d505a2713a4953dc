#pragma once
// An edge of a chart as a curve in space: the point of the surface at the edge's place in the chart, its derivatives by
// the chain rule, its length by quadrature. Page: docs/algorithms/surface_border.md.

#include <vector>

#include "shared/geom/discretise.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::mesh {

/// The parameter s goes from 0 at the start of the edge to 1 at its end. A value: holds its surface and edge.
class EdgeInSpace {
 public:
  struct Jet {
    geom::Point3 at;
    geom::Vector3 first, second;  ///< By s, m.
  };

  EdgeInSpace(Surface surface, trim::ChartEdge edge);

  [[nodiscard]] const trim::ChartEdge& edge() const { return edge_; }
  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] geom::Point place(double s) const { return edge_.at(parameter(s)); }
  [[nodiscard]] geom::Point3 at(double s) const { return surface_.at(place(s)); }
  [[nodiscard]] Jet jet(double s) const;
  /// Between two parameters, s0 <= s1, m: Gauss's rule with 7 points between the marks.
  [[nodiscard]] double length(double s0, double s1) const { return travelled(s1) - travelled(s0); }
  [[nodiscard]] double length() const { return travelled_.back(); }
  /// From the start to s.
  [[nodiscard]] double travelled(double s) const;
  /// The parameter at which `length` from the start is travelled.
  [[nodiscard]] double parameter_at(double length) const;
  /// The parameter between `low` and `high` at which the edge is next to a point in space, walking from `near`.
  [[nodiscard]] double next_to(geom::Point3 point, double near, double low, double high) const;

  /// Ascending from 0 to 1; all places where the curve of the chart is not smooth are among them, and so many between
  /// that the chart's curve between two is all but straight.
  [[nodiscard]] const std::vector<double>& marks() const { return marks_; }
  /// Where the curve of the chart is not smooth, 0 and 1 left out.
  [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }
  /// How much it turns in space at a break, radians.
  [[nodiscard]] double turn_at(double s) const;
  /// For the discretiser, over the piece from s0 to s1. Refers to this value.
  [[nodiscard]] geom::SpaceCurveFunctions functions(double s0, double s1) const;

 private:
  [[nodiscard]] double parameter(double s) const { return (1.0 - s) * edge_.from + s * edge_.to; }
  [[nodiscard]] double speed(double s) const { return geom::length(jet(s).first); }

  Surface surface_;
  trim::ChartEdge edge_;
  std::vector<double> marks_, breaks_, travelled_;
};

}  // namespace dobra::surf::mesh
