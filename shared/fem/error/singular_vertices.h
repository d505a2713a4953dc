#pragma once
// Where the stresses of a problem are infinite: crack tips, corners of the boundary that point into the material, and
// places where a support ends. Displacements go there as r^lambda with lambda < 1, which the rules of new sizes need to
// know. Page: docs/algorithms/estimate.md. Source: [williams1952].

#include <vector>

#include "shared/base/angle.h"
#include "shared/fem/error/new_sizes.h"
#include "shared/fem/problem.h"

namespace dobra::fem::error {

/// The exponent at a corner with one clamped and one free face: the least positive root of
///   4 kappa sin^2(lambda w) = (kappa + 1)^2 - 4 lambda^2 sin^2 w;   1 if there is none below.
double clamped_corner_exponent(base::Angle interior, const Material& material);

/// Tips, free corners above 210 degrees (less is a curve followed by sides), clamped faces that end at a free one, and
/// rollers (lines of symmetry) that do: those are half of a free corner of twice the angle.
/// @pre  check(mesh, problem)  @cost O(n)
std::vector<SingularVertex> singular_vertices(const mesh::ElementMesh& mesh, const Problem& problem);

/// Free corners that point out of the material: where the tractions of their faces do not fit together (a sheared face
/// beside a free one) the stress stays finite but depends on the direction from which one comes. Exponent 1.
/// @pre  check(mesh, problem)  @cost O(n)
std::vector<SingularVertex> free_corners(const mesh::ElementMesh& mesh, const Problem& problem);

}  // namespace dobra::fem::error
