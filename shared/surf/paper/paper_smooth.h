#pragma once
// Smoothing of the paper's mesher in the chart, by real lengths: X0 + phi * sum w (Xi - X0) / sum w, with w the real
// distance of a neighbour over that in the chart. Internal to paper_mesher.h. Source: [miranda2009surface] (18).

#include <cstdint>
#include <vector>

#include "shared/surf/mesh/assemble.h"

namespace dobra::surf::paper {

/// One pass over the nodes that are not fixed, in order; distances in the chart are of the chart scaled by `scale`. A
/// move that would fold a triangle, or that makes the mean alpha round the node or the least one smaller, is halved
/// twice and then not made: so the mean alpha of the mesh never falls.
/// @return how many moved.  @pre 0 <= phi <= 1
std::size_t smooth_pass(const Surface& surface, mesh::FaceMesh& face, const std::vector<std::uint8_t>& fixed,
                        double phi, geom::Vector scale);

}  // namespace dobra::surf::paper
