#pragma once
// The borders and lines of faces become nodes and sides, in space: the same ones for all faces that meet there. What
// stands here is given to a mesher of one face (chart_input.h). Page: docs/algorithms/surface_border.md.
// Source: [miranda2009surface].

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::mesh {

enum class DivisionKind : std::uint8_t {
  /// As [miranda2009surface] has it: ceil(length / L) equal steps of the parameter, each bisected while it is longer
  /// than L or its tangent turns by more than A.
  Halving,
  /// As few sides as size, turn and chord allow, over each of which the integral of ds / h is the same.
  Even,
};

struct DivisionOptions {
  DivisionKind kind = DivisionKind::Even;
  SizeOptions sizes = {};
  /// Ends further apart than this part of the chart's diagonal do not meet, unless an edge's own tolerance in space
  /// says they do. What lies so near to a line is on it.
  double closing = 1e-6;
  std::size_t most_sides = 5'000'000;  ///< Of a piece between corners; more end in TooManyElements.
};

/// The ends of a side by their coordinates, in order.
struct SideEnds {
  std::array<double, 3> low, high;
  SideEnds(geom::Point3 p, geom::Point3 q);
  friend auto operator<=>(const SideEnds&, const SideEnds&) = default;
};
/// The middle of the curve between the ends of a side.
using Middles = std::map<SideEnds, geom::Point3>;

struct Division {
  /// One a surface. Points of `chart` are no two the same; those of edges come first, in the order of loops and lines.
  std::vector<ChartInput> faces;
  std::uint32_t nodes = 0;          ///< Numbers of nodes are below this, and all are used.
  Middles middles;                  ///< One a side.
  std::vector<std::string> cracks;  ///< Sets to be opened into two lips; each once.
  /// Of these, sides on seams by their nodes, as the crack runs; each is there for both sides of the seam.
  std::map<std::string, std::vector<std::array<std::uint32_t, 2>>> cracks_on_seams;
  std::vector<Finding> findings;  ///< "gap_closed", "kink".
};

/// A surface without loops is meant whole: sides that are the same points in space are divided once, a side that is one
/// point gets no node between its ends. Kinks of a surface become lines inside, in the set "kink". Lines may end on
/// loops and cross other lines: there are nodes there.
/// @param surfaces  loops closed, none crosses another.
/// @error InvalidOption: sizes that are not positive, growth not above 1; CannotMesh with the place {x, y, z, u, v}:
///        ends that do not meet, edges of one shared curve that do not run beside each other; those of discretise.
/// @cost  O(n log n) for n nodes.
base::Result<Division> divide(std::span<const trim::TrimmedSurface> surfaces, const DivisionOptions& options = {},
                              const base::Progress& progress = {});

}  // namespace dobra::surf::mesh
