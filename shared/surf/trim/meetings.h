#pragma once
// Where arcs of a chart cross or touch inside. Of use inside this folder.

#include "shared/surf/trim/arcs.h"

namespace dobra::surf::trim {

struct Crossing {
  std::size_t strand_a = 0, strand_b = 0;
  double part_a = 0.0, part_b = 0.0;
  geom::Point at;  ///< By parts of the chart.
};

/// All crossings and touchings of arcs with each other and themselves, vertices that both have left out.
/// @error CannotMesh with the place where they cannot be told.
base::Result<std::vector<Crossing>> crossings(const Surface& surface, const Arcs& arcs, double same);

/// The parts of a strand between which it is smooth, both ends among them.
std::vector<double> smooth_parts_of(const Arcs& arcs, std::size_t strand, double from, double to);

}  // namespace dobra::surf::trim
