#pragma once
// Superconvergent patch recovery: smooth values at the nodes of a mesh from samples inside its elements. Round each
// vertex the samples of a patch of elements are fitted by a polynomial, weighted least squares in coordinates scaled to
// the patch; mid-side nodes take the mean of the patches of their ends. A patch never crosses into another region or
// through a boundary (so not through the lips of a crack), and grows where a boundary leaves it too few samples.
// Page: docs/algorithms/recover.md. Source: [zienkiewicz1992spr].

#include <cstdint>
#include <span>
#include <vector>

#include "shared/fem/material.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem::error {

/// Terms of the polynomial: 1 x y | + x2 xy y2 | 1 x y xy | 1 x y x2 xy y2 x2y xy2
enum class Basis : std::uint8_t { Linear, Quadratic, Bilinear, Serendipity };
std::size_t term_count(Basis basis);

/// Weighted least squares of polynomials through samples about a centre.
class PatchFit {
 public:
  /// @param centre, scale  local coordinates are (p - centre) / scale.
  /// @param weights        one a point, > 0; empty: all 1.
  PatchFit(Basis basis, geom::Point centre, double scale, std::span<const geom::Point> points,
           std::span<const double> weights = {});

  /// False if the points do not determine the polynomial.
  [[nodiscard]] bool determined() const { return determined_; }
  /// Multiplied by the samples (one a point), these give the value of the fit at p. @pre determined()
  [[nodiscard]] std::vector<double> weights_at(geom::Point p) const;

 private:
  Basis basis_;
  geom::Point centre_;
  double scale_;
  bool determined_ = false;
  std::size_t count_;
  std::vector<double> inverse_;  ///< terms x points, by rows: from samples to coefficients.
};

struct RecoveredStress {
  /// One an element's node, in the order of mesh.nodes, Pa: equal at a node within a region, different across regions.
  std::vector<Voigt> at_element_nodes;
  std::size_t grown = 0;     ///< Patches that had to grow beyond the elements round their vertex.
  std::size_t degraded = 0;  ///< Patches whose samples determine a linear polynomial only, or just a mean.
};

/// Stresses recovered from the displacements `u` of a case.
/// @pre  check(mesh), a material for each region.  @cost O(n), in parallel.
RecoveredStress recover_stress(const mesh::ElementMesh& mesh, const Materials& materials,
                               std::span<const geom::Vector> u);

/// Mean at each node over the regions that meet there, for drawing, Pa.
std::vector<Voigt> nodal_mean(const mesh::ElementMesh& mesh, std::span<const Voigt> at_element_nodes);

}  // namespace dobra::fem::error
