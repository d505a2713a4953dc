#pragma once
// A triangle mesh of a file meshed anew: a sheet, cut open where it is no disk, gets a chart (surf/param), and the
// mesher of surfaces fills it with triangles of the size asked for. Its corners, borders and creases are kept; all
// nodes lie on the mesh that was given. Page: docs/algorithms/remesh.md.

#include <cstddef>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/remesh/flatten.h"

namespace dobra::surf::remesh {

struct RemeshOptions {
  double size = 0.0;     ///< No side much longer, m; 0: the mean side of the mesh given.
  double chord = 0.0;    ///< The new mesh is nowhere further from the old one, nor the old from it, m; 0 does not ask.
  double growth = 1.2;   ///< Greatest ratio of the sizes of neighbouring elements, > 1.
  double corner = 40.0;  ///< Degrees: vertices at which the border turns by more stay.
  double crease = 40.0;  ///< Degrees: sides at which the sheet folds by more stay lines; 180: none.
  std::size_t enough = 20'000;  ///< A mesh of fewer triangles whose sides are longer than `size` is quartered first.
  int rounds = 6;               ///< So often it is meshed anew with smaller sizes where the chord asks for it.
  double area_off = 0.01;       ///< An area that differs by more than this part is told.
  double most_area_off = 0.1;   ///< An area that differs by more is refused, with a size that works.
  double least = 0.02;          ///< No size below this part of `size`.
  double beyond = 4.0;          ///< Given up at so many times the triangles that sizes and borders mean.
  double most_stretch = 15.0;   ///< A mesh is parted where its one chart would have more `stretch` (atlas.h).
  std::size_t most_triangles = 20'000'000;
  param::Weights weights = param::Weights::ShapePreserving;
};

struct Remeshed {
  mesh::SurfaceMesh mesh;  ///< One face; places in the chart of the opened sheet.
  mesh::SurfaceQuality quality;
  double deviation =
      0.0;  ///< Greatest distance between both meshes at vertices, and at ten places of each triangle, m.
  std::size_t flipped = 0;         ///< Triangles turned over in the chart, exactly.
  std::size_t creases = 0;         ///< Lines kept.
  std::size_t cut_creases = 0;     ///< Of them, those that the cut runs along.
  std::size_t narrow_creases = 0;  ///< Left out, since they run close beside another line,
  geom::Point3 narrow_at;          ///< and where one of them begins.
  std::size_t short_creases = 0;   ///< Left out, since they are shorter than a side,
  geom::Point3 short_at;           ///< and where one of them begins.
  std::size_t tips = 0;            ///< Points kept at which the mesh comes to a tip: the node set "tips".
  std::size_t tips_out = 0;        ///< Tips left out beside a line or a sharper tip,
  geom::Point3 tip_at;             ///< and where one of them is.
  std::size_t folded = 0;          ///< Triangles that face against the mesh given.
  double area_before = 0.0;        ///< Of the mesh given, m2.
  int rounds = 0;
  /// Those of Charted, and "pieces", "piece_kept", "parted", "folded", "rough", "crease_left_out", "tip_left_out",
  /// "deviation_above",
  /// "area_off". No text names a unit: files of meshes have none.
  std::vector<mesh::Finding> findings;
};

/// Pieces are meshed one by one; of several, one that is too small for the size stays as it came ("piece_kept").
/// A sheet of many small holes keeps them in its chart, and so does one whose cut cannot be meshed; others are cut.
/// @error those of chart_mesh; InvalidOption: sizes, and one too large for the mesh; CannotMesh with the place: a chart
/// with flipped triangles; those of mesh_chart
base::Result<Remeshed> remesh(const dobra::mesh::PolygonMesh& mesh, const RemeshOptions& options = {},
                              const base::Progress& progress = {});

/// Greatest distance between two meshes, both ways, at the vertices and at ten places of each triangle, m.
double deviation(const param::Sheet& a, const param::Sheet& b);

}  // namespace dobra::surf::remesh
