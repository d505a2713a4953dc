#pragma once
// Which curves of a drawing bound the domain and which lie inside it, where the file does not say: chains that close
// bound it, what ends freely or divides it is an internal line; loops of a .poly are holes where a hole point says so.
// Page: docs/algorithms/domain_repair.md.

#include "quebra/domain/domain.h"

namespace quebra::domain {

/// Joins ends within `tolerance`, closes curves that end where they began, and gives each curve of
/// `sketch.without_role` its role; that list is empty afterwards.  @cost O(n log n) for n points
void find_roles(sketch::Sketch& sketch, double tolerance);

/// Loops of a .poly that no hole point makes a hole divide material from material: their curves become internal.
/// The loops of the domain are those of before and must be followed anew. @pre loops have their depth; `inside` is of
/// them
/// @error OutsideDomain for a hole point that lies in no loop.
dobra::base::Result<void> apply_hole_points(Domain& domain, const Inside& inside, const sketch::HolePoints& holes);

}  // namespace quebra::domain
