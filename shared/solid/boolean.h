#pragma once
// Union, intersection and difference of any number of solids, exact and regularised. All facets are cut by each other
// exactly (space.h, cells.h), the winding numbers of all operands on both sides of every cell are read off
// (windings.h), and the cells between inside and outside are the result. Nothing is perturbed and nothing is rounded:
// coincident faces, edges and vertices are cases like any other. Page: docs/algorithms/boolean.md.
// Sources: [zhou2016arrangements] (cells and winding numbers), [requicha1980representations] (regularised sets).

#include <functional>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/solid/solid.h"

namespace dobra::solid {

enum class Operation : std::uint8_t {
  Union,
  Intersection,
  Difference  ///< The first without all the others.
};

/// The most that any two of the operands have in common.
enum class Contact : std::uint8_t { Nothing, Vertex, Edge, Face, Volume };

struct Combined {
  Solid solid;  ///< Regularised: no part of it without volume.
  Contact contact = Contact::Nothing;
};

/// Faces keep the names of the operands' faces that they come from; where several coincide, of the first operand that
/// has its outside there.
/// @error InvalidOption if there are no operands.
/// @cost  O(n log n + pairs of faces whose boxes overlap); exact numbers only near common places.
base::Result<Combined> combine(std::span<const Solid> operands, Operation operation);

/// Whatever of inside and outside makes the result; asked with one value for each operand.
using Rule = std::function<bool(const std::vector<bool>&)>;

/// @error InvalidOption if there are no operands, or the result would reach without end.
base::Result<Combined> combine(std::span<const Solid> operands, const Rule& rule);

/// "nothing", "vertex", "edge", "face", "volume".
const char* name(Contact contact);

}  // namespace dobra::solid
