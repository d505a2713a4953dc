#pragma once
// From elements to the stiffness matrix and the load vectors. Element matrices are computed in parallel; every row of
// the global matrix is then summed by one thread over its elements in ascending order, so the bytes do not depend on
// the number of threads. Page: docs/algorithms/fem.md. Source: [zienkiewicz2000fem].

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/fem/element.h"
#include "shared/fem/problem.h"

namespace dobra::fem {

/// Upper triangle of a symmetric matrix of 2 x 2 blocks {xx, xy, yx, yy}, one block row and column a node.
struct BlockMatrix {
  std::vector<std::size_t> first;             ///< Blocks of row i: first[i] .. first[i + 1] - 1.
  std::vector<std::uint32_t> columns;         ///< Ascending in each row, from the diagonal on.
  std::vector<std::array<double, 4>> blocks;  ///< N/m; the diagonal ones whole.
  [[nodiscard]] std::size_t size() const { return first.size() - 1; }
};

/// The stiffness of one element: the 2 x 2 blocks of its nodes a <= b, by rows (a, then b), N/m.
/// @return false if the element is turned inside out at an integration point.
bool element_stiffness(const ElementGeometry& element, const Material& material,
                       std::span<std::array<double, 4>> blocks);

/// The matrix of the elements and springs.
/// @pre   check(mesh, problem)
/// @error CannotMesh with the place of an element that is inside out.  @cost O(n)
base::Result<BlockMatrix> assemble(const mesh::ElementMesh& mesh, const Problem& problem);

/// A u, N. @cost O(blocks)
std::vector<geom::Vector> multiply(const BlockMatrix& matrix, std::span<const geom::Vector> u);

/// Consistent nodal forces of a load case, N.  @pre check(mesh, problem)
std::vector<geom::Vector> load_vector(const mesh::ElementMesh& mesh, const Problem& problem, const LoadCase& load);
/// Adds the forces of one load along the sides `sides`.
void add_side_load(const mesh::ElementMesh& mesh, const Materials& materials, std::span<const mesh::ElementSide> sides,
                   const Traction& traction, std::span<geom::Vector> forces);

/// Calls visit(node positions of the side, shape, point, outward unit normal, length of the integration point) at the
/// integration points of a side.
template <class Visit>
void integrate_side(const mesh::ElementMesh& mesh, mesh::ElementSide side, Visit&& visit) {
  const ElementType type = mesh.types[side.element.index()];
  const auto nodes = side_nodes(mesh, side);
  const std::size_t count = mesh::is_quadratic(type) ? 3 : 2;
  for (const IntegrationPoint& gauss : side_points()) {
    const Shape shape = side_shape(type, gauss.xi);
    geom::Point at;
    geom::Vector tangent;
    for (std::size_t i = 0; i < count; ++i) {
      const geom::Point p = mesh.point(nodes[i]);
      at = at + shape.n[i] * geom::Vector{p.x, p.y};
      tangent = tangent + shape.d_xi[i] * geom::Vector{p.x, p.y};
    }
    const double speed = length(tangent);
    visit(std::span(nodes).first(count), shape, at, right_of(tangent) / speed, speed * gauss.weight);
  }
}

}  // namespace dobra::fem
