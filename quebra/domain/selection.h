#pragma once
// Parts of the boundary named by where they are, "x = 0 and y > 1", instead of by the name of a curve: a drawn outline
// is one curve, and its sides have no names. Page: docs/scenario_format.md.

#include <span>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"
#include "shared/base/result.h"
#include "shared/mesh/element_mesh.h"

namespace quebra::domain {

/// A part of a curve between two corners or junctions that follow each other.
struct CurvePart {
  std::size_t curve = 0;
  double from = 0.0, to = 0.0;  ///< Distances along it, from < to.
  dobra::geom::Point start, end;
};

/// All parts of the curves that bound the material, by curve and distance.  @cost O(n log n) for n corners and
/// junctions
std::vector<CurvePart> boundary_parts(const Domain& domain);

/// Whether `where` is a condition and not a name: it compares something.
bool is_condition(const std::string& where);

/// What a condition holds for: whole parts of the boundary, or the corners where it holds if there is no such part.
struct Selection {
  std::vector<CurvePart> parts;
  std::vector<dobra::geom::Point> corners;
};

/// Conditions are formulas of x and y, in units of Domain::unit, with = < <= > >= between them, joined by `and`, those
/// by `or`. A place that is nearer than 1e-6 of the domain's diagonal to where a condition holds meets it; < and <= are
/// therefore the same.
/// @error BadValue: what cannot be read; a condition that holds nowhere, with what the boundary has; one that holds for
///        a stretch of a part only, with its place.
dobra::base::Result<Selection> select(const Domain& domain, const std::string& condition);

/// The curves that a name or a condition means.
std::vector<std::size_t> curves_meant(const Domain& domain, const std::string& where);

/// The mesh with a set for each condition among the words: of sides, or of the nodes at corners.
/// @error those of select
dobra::base::Result<dobra::mesh::ElementMesh> with_sets(const Domain& domain, const dobra::mesh::ElementMesh& mesh,
                                                        std::span<const std::string> words);

/// "; did you mean 'right'? There is 'left', 'right'": what follows a word that is none of the names.
std::string what_there_is(const std::string& word, const std::vector<std::string>& names);

/// "'outline' from (0, 0) to (2, 0)", each part of the boundary, the first `most` of them and how many more there are.
std::string listed(const Domain& domain, std::size_t most = 12);

}  // namespace quebra::domain
