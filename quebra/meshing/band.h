#pragma once
// Bands: the offset curves of one source, and what is left of them where several sources lie near each other. Curves of
// two bands of like spacing give way to each other as the offset of both sources together has it: one is kept where it
// is at least as far from the other source as that source's own curve of the same number, so that equal curves meet in
// common nodes and nothing crosses; a band at least twice as fine stays whole, and the coarse one ends at its outermost
// curve. Page: docs/algorithms/bands.md. Source: [carvalho2005offset].

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "quebra/model/model.h"

namespace quebra::meshing {

enum class Spacing {
  Ring,  ///< Nodes as far apart as the curve is from its two neighbours, on the mean.
  Base,  ///< Nodes where the offset of the divided base has them.
};

/// Where the tube round a source lies, of which the curves of its band are borders.
enum class Tube {
  Round,   ///< All round it, ends included: a crack.
  Beside,  ///< On both sides, no farther than its ends: a boundary, of which one side is outside the domain.
  Right,   ///< On the right of its travel, no farther than its ends.
};

/// An offset curve inside the domain, before it gives way to those of other bands.
struct BandCurve {
  dobra::geom::Polyline line;
  std::size_t rank = 0;  ///< Of its distance, from 0.
  std::optional<model::Constraint::Foot> start, end;
};

struct Band {
  std::vector<std::string> curves;  ///< Names of the source's.
  dobra::geom::Polyline source;
  Tube tube = Tube::Beside;
  Spacing kind = Spacing::Ring;
  std::vector<double> distances;  ///< By rank, ascending, m.
  std::vector<double> spacings;   ///< Wanted distance of the nodes, by rank, m.
  std::vector<BandCurve> lines;
};

/// What is left of all bands, with nodes at the wanted spacing; ends on the boundary are nodes of it, crossings nodes
/// of both curves. Names: "hole_1", further pieces "hole_1_2".
/// @cost O(n log n + crossings) for n chords.
std::vector<model::Constraint> constraints_of(const domain::Domain& domain,
                                              std::span<const std::shared_ptr<const Band>> bands);

}  // namespace quebra::meshing
