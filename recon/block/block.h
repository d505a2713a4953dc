#pragma once
// A section made a block: its units extruded along strike, each a solid, neighbours with the same faces between them.
// Block coordinates: x along the section, y into it as one looks at it (along strike), z up, metres; the section itself
// stands at y = 0. Page: docs/algorithms/section_block.md. Source: [requicha1980representations] (sweeps).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/block/sheet.h"
#include "recon/section/section.h"
#include "shared/base/finding.h"
#include "shared/io/lines/feature.h"
#include "shared/solid/section.h"
#include "shared/solid/shape/profile.h"
#include "shared/solid/solid.h"

namespace recon::block {

/// All of one unit. Faces are called after the line that they come from, "horizon A", "fault F", "topography T",
/// "border", "side", "contact" (unit_map.h), or "start" and "end" across strike.
struct BlockUnit {
  std::string name;
  /// Faces as neighbours share them: every vertex of a neighbour on a common edge is a corner of both.
  dobra::solid::shape::Shape shape;
  dobra::solid::Solid solid;
  std::size_t parts = 0;  ///< Connected ones; faults do not part a unit that lies on both sides.
  double area = 0.0;      ///< Of the section's, m2; this and the next are exact numbers rounded to nearest.
  double volume = 0.0;    ///< m3.
};

/// Of all units together: what two of them share counts once. Neighbours in one plane with one name between the same
/// units are one face, edges in a line one edge.
struct BlockCounts {
  std::size_t vertices = 0, edges = 0, faces = 0;
};

struct Block {
  section::Section section;         ///< What was extruded.
  dobra::io::lines::Trace trace;    ///< Where the section stands on the map ...
  bool placed = false;              ///< ... as was said; otherwise it is taken to run to the east from (0, 0).
  double length = 0.0;              ///< Along strike, m.
  std::vector<BlockUnit> units;     ///< In the order of the section's.
  std::vector<Sheet> sheets;        ///< Lines, polygons and the border of the section as surfaces, complete.
  std::vector<Rail> rails;          ///< Its points as lines.
  double area = 0.0, volume = 0.0;  ///< Of all units, likewise exact and rounded.
  BlockCounts counts;
  std::vector<base::Finding> findings;
  std::shared_ptr<const dobra::solid::Sections> sections;  ///< Of the units' solids, in their order.

  [[nodiscard]] geom::Point3 on_map(geom::Point3 p) const {
    return {trace.x + p.x * trace.east - p.y * trace.north, trace.y + p.x * trace.north + p.y * trace.east, p.z};
  }
  [[nodiscard]] geom::Point3 in_block(geom::Point3 map) const {
    const double dx = map.x - trace.x;
    const double dy = map.y - trace.y;
    return {dx * trace.east + dy * trace.north, dy * trace.east - dx * trace.north, map.z};
  }
};

struct BlockOptions {
  double along_strike = 0.0;  ///< m, above 0.
  /// Where the section stands on the map; by default from (0, 0) to the east, so that the block reaches to the north.
  std::optional<dobra::io::lines::Trace> trace{};
};

/// @error InvalidOption: along_strike; BadSection and others of unit_map(); those of solid::from_loops.
/// @cost  O(n log n) for n points of the section
base::Result<Block> extrude(const section::Section& section, const BlockOptions& options);

}  // namespace recon::block
