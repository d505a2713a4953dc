#pragma once
// Where the stress has its peaks, and how far the mesh is trusted there. The error of a whole part in the energy norm
// says little of a small notch that holds little of the energy: a coarse mesh may meet 5 % and lack a tenth of the
// peak. The same error, taken over the elements round the peak alone, tells. Page: docs/algorithms/estimate.md.

#include <span>
#include <vector>

#include "shared/fem/error/estimate.h"
#include "shared/fem/problem.h"

namespace dobra::fem::error {

struct HotSpot {
  mesh::NodeId node;
  double stress = 0.0;  ///< Recovered, von Mises, Pa.
  double eta = 0.0;     ///< Of the elements that touch the node, 0..1.
};

/// Peaks of the recovered von Mises stress, greatest first: corner nodes from which one must descend by a tenth to get
/// to a higher one, down to four fifths of the greatest (a finer mesh may change their order). Where the stress is
/// infinite there is no peak, only a slope towards it: singular vertices, and single nodes with a load, a spring or a
/// support; nor is a bump on that slope one, no higher than the slope is as far away. Nor are there any in the discs
/// that the estimate leaves out.
/// @pre check(mesh, problem)  @cost O(n log n)
std::vector<HotSpot> hot_spots(const mesh::ElementMesh& mesh, const Problem& problem, std::span<const geom::Vector> u,
                               const RecoveredStress& recovered, const ErrorEstimate& estimate,
                               std::span<const SingularVertex> singular, std::span<const Disc> left_out = {});

/// Nodes of points that a force of the load case, a support or a spring acts on.
std::vector<mesh::NodeId> single_nodes_acted_on(const mesh::ElementMesh& mesh, const Problem& problem,
                                                const LoadCase& load);

}  // namespace dobra::fem::error
