#pragma once
// What of a surface is meant: loops in its chart that bound it, lines and points that a mesh must have. A value; what
// it must fulfil is judged by who makes it (recognise.h) and by the mesher. Page: docs/algorithms/trimming.md.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/error.h"
#include "shared/surf/surface.h"

namespace dobra::surf::trim {

/// Of a curve in space on which several edges lie: of two faces, or of both sides of a seam.
using SharedCurveId = std::uint32_t;

/// A part of a curve in the chart. Its points are (u, v, 0).
struct ChartEdge {
  Curve curve;
  double from = 0.0, to = 1.0;  ///< Parameters of the curve; followed backwards where to < from.
  std::string name = {};        ///< Its sides in the mesh are in the set of this name; edges may share one.
  /// Edges of one number, whatever face they bound, are one curve in space and have the same nodes.
  std::optional<SharedCurveId> shared = std::nullopt;
  bool against = false;    ///< Runs against the shared curve.
  double tolerance = 0.0;  ///< Edges that are one curve are at most so far apart in space, m.
  /// Of a loop, on both sides of a seam inside the face: the mesh is opened there along the crack `name`, which runs
  /// along the edge or against it.
  enum class Crack : std::uint8_t { None, Along, Against } crack = Crack::None;

  [[nodiscard]] geom::Point at(double t) const {
    const geom::Point3 p = curve.at(t);
    return {p.x, p.y};
  }
  [[nodiscard]] geom::Point start() const { return at(from); }
  [[nodiscard]] geom::Point end() const { return at(to); }
};

/// Closed: each edge ends where the next begins, the last where the first does. What is meant lies on its left: outer
/// loops are anticlockwise in the chart, holes clockwise.
struct ChartLoop {
  std::vector<ChartEdge> edges;
};

/// A line inside, along which the mesh has sides: open or closed, from loop to loop or free.
struct ChartLine {
  enum class Kind : std::uint8_t {
    Constraint,  ///< Of the mesh only.
    Interface,   ///< Between two regions.
    Crack,       ///< The mesh is opened along it: two lips that share its tips.
  };
  std::vector<ChartEdge> edges;
  Kind kind = Kind::Constraint;
};

/// A node inside, with the size wanted there, if any (m, in space).
struct ChartPoint {
  geom::Point at;
  std::string name = {};
  std::optional<double> size = std::nullopt;
};

/// The part round `at`, up to loops and interfaces, has the tag `region`.
struct ChartRegion {
  geom::Point at;
  std::int32_t region = 0;
  std::string name = {};
};

struct TrimmedSurface {
  Surface surface;
  std::vector<ChartLoop> loops = {};  ///< None: the whole chart.
  std::vector<ChartLine> lines = {};
  std::vector<ChartPoint> points = {};
  std::vector<ChartRegion> regions = {};
  bool reversed = false;   ///< It looks against the normal of its surface: so are its triangles turned.
  std::string name = {};   ///< Its triangles are in the region or set of this name.
  base::Place place = {};  ///< Where it stands in the user's file.
};

}  // namespace dobra::surf::trim
