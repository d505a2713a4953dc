#pragma once
// gmsh's geometry files (.geo), built-in kernel, plane: points, lines, circle and ellipse arcs, splines, loops, plane
// surfaces, physical groups, sizes, divisions; variables, lists and arithmetic; For, If and macros. Source:
// [gmsh-manual].

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::io::drawings {

struct GeoPoint {
  geom::Point at;
  double size = 0.0;  ///< Wanted mesh size, m; 0: none.
};

enum class GeoCurveKind { Line, Circle, Ellipse, Spline, BSpline, Bezier };

struct GeoCurve {
  GeoCurveKind kind = GeoCurveKind::Line;
  std::vector<std::int64_t>
      points;          ///< Tags. Circle: start, centre, end; ellipse: start, centre, point of the major axis, end.
  int segments = 0;    ///< Of "Transfinite Curve"; 0: none.
  double ratio = 1.0;  ///< Of its progression: last segment to first.
  base::Place place;
};

struct GeoGroup {
  int dimension = 0;  ///< 0 points, 1 curves, 2 surfaces.
  std::int64_t tag = 0;
  std::string name;                    ///< Empty: none.
  std::vector<std::int64_t> entities;  ///< Tags without signs.
};

struct GeoFile {
  std::map<std::int64_t, GeoPoint> points;
  std::map<std::int64_t, GeoCurve> curves;
  std::map<std::int64_t, std::vector<std::vector<std::int64_t>>>
      surfaces;  ///< Loops of signed curve tags, outer one first.
  std::vector<GeoGroup> groups;
  std::vector<std::array<std::int64_t, 2>> embedded;  ///< Dimension and tag of points and curves "In Surface".
  std::vector<std::string> remarks;                   ///< Statements without a meaning here, one line each.
};

/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat with line and column for what is wrong or not
///        supported (volumes, extrusions, the OpenCASCADE kernel, includes).
/// @cost  linear, loops counted as often as they run; at most ten million steps.
base::Result<GeoFile> read_geo(const std::string& path);
base::Result<GeoFile> parse_geo(std::string_view text, const std::string& file);

}  // namespace dobra::io::drawings
