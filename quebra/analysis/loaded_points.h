#pragma once
// Forces at single points: loads, reactions and springs that act on one node. Stress goes there as 1 / r and the energy
// is infinite, so that no mesh meets an error in the energy norm: the estimate leaves a neighbourhood out
// (Saint-Venant's), whose radius belongs to the domain and not to the mesh. Page: docs/algorithms/estimate.md. Source:
// [zienkiewicz1992spr].

#include <string>
#include <vector>

#include "quebra/analysis/problem.h"
#include "quebra/model/model.h"
#include "shared/fem/solve.h"

namespace quebra::analysis {

/// A point with a force that the energy feels.
struct LoadedPoint {
  std::string name;
  dobra::geom::Point at;
  dobra::geom::Vector force;  ///< On the material: load, reaction and spring together, N.
  double radius = 0.0;        ///< Of its neighbourhood, m.
};

/// The radius of a point's neighbourhood: 1/20 of the room, that is of the thickness of the material across the
/// boundary there, and of the distance to other loops and cracks. A notch in the same loop beside the point does not
/// count.
double radius_round(const domain::Domain& domain, dobra::geom::Point at);

/// The points of a load case whose force F can add more than 0.1 % to eta: F > 0.001 sqrt(E t) ||u||. What acts along
/// an axis, or a normal, that a curve through the point holds is spread along that curve and no force at a point.
/// @param radius  of all; 0: radius_round, and 1/20 of the distance to the tips of the mesh.
std::vector<LoadedPoint> loaded_points(const domain::Domain& domain, const dobra::mesh::ElementMesh& mesh,
                                       const ProblemParams& params, const dobra::fem::Problem& problem,
                                       const dobra::fem::CaseResult& result, double radius);

/// "'load', 'support_left'"
std::string names_of(const std::vector<LoadedPoint>& points);

}  // namespace quebra::analysis
