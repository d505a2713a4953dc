#pragma once
// The element sizes of the next mesh from the errors of this one: so that every element bears the same error, or so
// that the fewest elements reach the error asked. Near a corner where the stresses are infinite the error falls more
// slowly with the size, and the rules know it.
// Page: docs/algorithms/estimate.md. Source: [zienkiewicz1992spr] (part II), [ladeveze1991].

#include <cstdint>
#include <vector>

#include "shared/fem/error/estimate.h"

namespace dobra::fem::error {

enum class SizeRule : std::uint8_t {
  EqualError,  ///< h = h_i / xi_i^(1/p), xi_i = ||e||_i / (eta_t sqrt((||u||^2 + ||e||^2) / m)).
  Optimal,     ///< Fewest elements whose predicted errors add up to eta_t: sum of r_i^-2 least.
};

struct NewSizeOptions {
  double target = 0.05;  ///< eta asked for, 0..1.
  SizeRule rule = SizeRule::Optimal;
  double least_factor = 0.25;  ///< Of the present size, in one step; its square near a singular vertex.
  double most_factor = 2.0;
  double min_size = 0.0;   ///< m; 0: none.
  double max_size = 0.0;   ///< m; 0: none.
  int singular_rings = 1;  ///< Elements this near a singular vertex (1: those that touch it) follow its exponent.
};

/// The size of an element: the side of the equilateral triangle, or of the square, of its area, m.
double element_size(const mesh::ElementMesh& mesh, std::size_t element);

/// One size an element, m. An error of zero asks for the largest size allowed.
/// @error InvalidOption: the target is not in (0, 1), or the clamps are not in order.  @cost O(n)
base::Result<std::vector<double>> new_sizes(const mesh::ElementMesh& mesh, const ErrorEstimate& estimate,
                                            const std::vector<SingularVertex>& singular, const NewSizeOptions& options);

}  // namespace dobra::fem::error
