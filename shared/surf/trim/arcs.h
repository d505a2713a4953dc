#pragma once
// Lines of a chart cut where they cross, touch, overlap or end on each other: arcs between vertices, which meet nowhere
// else. Crossings are found on the curves themselves, by halving with bounds of their second derivatives and Newton's
// rule. Of use inside this folder. Page: docs/algorithms/trimming.md.

#include <array>
#include <map>

#include "shared/base/result.h"
#include "shared/surf/trim/finding.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

/// An edge as it came, or the part of it between two seams. A place on it is a part of its way: 0 where it starts.
struct Strand {
  ChartEdge edge;
  std::size_t line = 0;                     ///< Of which line.
  bool bounds = true;                       ///< Faces end there.
  std::optional<Side> side = std::nullopt;  ///< Of the chart.
  ChartLine::Kind kind = ChartLine::Kind::Constraint;
  std::size_t start = 0, end = 0;           ///< Vertices.
  double whole_from = 0.0, whole_to = 1.0;  ///< Parameters of the edge that came, of which it may be a part.
};

/// Where another strand runs along an arc.
struct Along {
  std::size_t strand = 0;
  double from = 0.0, to = 1.0;
  bool against = false;  ///< It runs against the arc.
};

struct Arc {
  std::size_t strand = 0;
  double from = 0.0, to = 1.0;  ///< from < to
  std::size_t start = 0, end = 0;
  std::vector<Along> along = {};  ///< All strands there, that of the arc first.
};

struct Cutting {
  double same = 1e-7;  ///< Points nearer than this are one, by parts of the chart's ranges.
};

/// In what follows places are by parts of the chart's ranges: (0, 0) to (1, 1).
struct Arcs {
  std::vector<geom::Point> vertices;
  std::vector<Strand> strands;
  std::vector<Arc> arcs;
  geom::Box chart;

  [[nodiscard]] geom::Point part(geom::Point uv) const {
    return {(uv.x - chart.low.x) / chart.width(), (uv.y - chart.low.y) / chart.height()};
  }
  [[nodiscard]] geom::Point uv(geom::Point part) const {
    return {part.x == 1.0 ? chart.high.x : chart.low.x + part.x * chart.width(),
            part.y == 1.0 ? chart.high.y : chart.low.y + part.y * chart.height()};
  }
  /// Place and derivatives on a strand, by parts of its way.
  struct At {
    geom::Point at;
    geom::Vector first, second;
  };
  [[nodiscard]] At on(std::size_t strand, double part) const;
  /// No second derivative is longer there.
  [[nodiscard]] double bend(std::size_t strand, double from, double to) const;
  /// The vertex at a place, a new one if there is none within `same`.
  std::size_t vertex(geom::Point p, double same);
};

/// A place where two lines cross or touch (`a` may be `b`).
struct Meeting {
  std::size_t line_a = 0, line_b = 0;
  geom::Point uv;
};

/// Cuts strands whose ends are vertices already.
/// @param cuts  parameters of shared curves at which they are cut besides
/// @error CannotMesh: two lines run so near to each other, or touch so closely, that they cannot be told apart.
base::Result<std::vector<Meeting>> cut(const Surface& surface, Arcs& arcs, const Cutting& options,
                                       const std::map<SharedCurveId, std::vector<double>>& cuts = {});

}  // namespace dobra::surf::trim
