#pragma once
// The faces of a boundary model as trimmed surfaces that a mesher can take: placed in the world, their loops closed,
// in order and turned so that the face lies on the left. What was mended, and each face that was refused, is told.
// Page: docs/algorithms/import_of_faces.md.

#include <string>
#include <vector>

#include "shared/io/brep/brep.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::io::faces {

struct ImportOptions {
  double gap_tolerances =
      10.0;                   ///< Ends of edges that follow each other may be so many times the file's tolerance apart,
  double gap_part = 1e-3;     ///< or this part of the face's diagonal, whichever is more. They are joined.
  double apart_part = 1e-2;   ///< A curve in the chart may leave its curve in space by this part of the diagonal.
  double beyond_part = 1e-2;  ///< And by this part leave the range of its surface; it is held at its border.
  double margin = 0.05;       ///< The chart goes so much beyond the loops, part of their width.
};

struct Imported {
  std::vector<surf::trim::TrimmedSurface> faces;
  /// Codes of what was mended: face_twice, gap_closed, edge_dropped, edge_twice, edge_turned,
  /// loop_split, loop_turned, loop_dropped, period_shifted, seam_added, side_added, natural_bounds, curve_projected,
  /// curve_held, curves_apart, edges_cross. Codes of faces left out, face_ and the reason: face_surface, face_curve,
  /// face_open, face_endless, face_crossing, face_apart, face_outside, face_empty. Of solids: solid_open.
  std::vector<surf::mesh::Finding> findings;
  std::size_t refused = 0;  ///< Faces that are left out, each with one finding.
};

/// Each face of the model, once where shells share it, is among `faces` or named in `findings`, in the order of the
/// file. Edges that faces share have one SharedCurveId; an edge is named "edge 7", a face "face 3"; both sides of a
/// seam have no name. A mirror in a placement turns `reversed`, so that what was outside stays outside.
/// @error those of brep::faces_of
/// @cost O(n^2) in the pieces of a face
base::Result<Imported> faces_of_model(const brep::Model& model, const ImportOptions& options = {});
/// @error those of brep::read_brep and faces_of_model
base::Result<Imported> faces_of_file(const std::string& path, const ImportOptions& options = {});

}  // namespace dobra::io::faces
