#pragma once
// The faces of a boundary model with the loops that bound them, each in the chart of its surface.

#include "shared/io/brep/brep.h"

namespace dobra::io::brep {

/// A part of a curve in the chart of a face's surface.
struct ChartPart {
  Index curve = 0;  ///< Of Model::chart_curves.
  double from = 0.0, to = 0.0;
};

/// An edge on a loop. The face lies to the left where the loop is followed.
struct LoopEdge {
  Index edge = 0;  ///< The shape: faces that share it share its nodes.
  Orientation orientation = Orientation::Forward;
  Placement placement;             ///< Of the edge in the world.
  std::optional<ChartPart> chart;  ///< None: the file has no curve in the chart, as it may on a plane.
};

struct TrimmedFace {
  Index shape = 0;
  std::optional<Index> surface;  ///< None: the file has only triangles of this face.
  Placement placement;           ///< Of the surface in the world.
  bool reversed = false;         ///< The face looks against the normal of its surface.
  bool natural = false;
  std::optional<std::size_t> solid;          ///< Number of the solid it is of, from 0; none: of a sheet.
  std::vector<std::vector<LoopEdge>> loops;  ///< By wires. The face's own orientation is not in it.
  /// Where it stands in the file: its line, "face 3".
  base::Place place;
};

/// Every face that the whole shape uses, as often as it does, in the order of the file.
/// @error BadFormat: no face (the file holds curves or points alone), or none with a surface, with the place of the
/// first;
///        TooManyElements: shapes used so often that there are more than a million of them.
base::Result<std::vector<TrimmedFace>> faces_of(const Model& model);

}  // namespace dobra::io::brep
