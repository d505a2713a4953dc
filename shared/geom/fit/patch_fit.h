#pragma once
// Polynomials of the plane fitted to samples of a patch by weighted least squares: what every patch recovery is made
// of, that of stresses (fem/error/recover.h) and that of surfaces (surf/param/recovered.h). Pages:
// docs/algorithms/recover.md, docs/algorithms/recovered_surface.md. Source: [zienkiewicz1992spr].

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/geom/point.h"

namespace dobra::geom::fit {

/// Terms of the polynomial: 1 x y | + x2 xy y2 | 1 x y xy | 1 x y x2 xy y2 x2y xy2
enum class Basis : std::uint8_t { Linear, Quadratic, Bilinear, Serendipity };
std::size_t term_count(Basis basis);

/// Weighted least squares of polynomials through samples about a centre.
class PatchFit {
 public:
  /// @param centre, scale  local coordinates are (p - centre) / scale.
  /// @param weights        one a point, > 0; empty: all 1.
  /// @cost  O(points * terms^2)
  PatchFit(Basis basis, Point centre, double scale, std::span<const Point> points,
           std::span<const double> weights = {});

  /// False if the points do not determine the polynomial.
  [[nodiscard]] bool determined() const { return determined_; }
  /// Multiplied by the samples (one a point), these give the value of the fit at p. @pre determined()
  [[nodiscard]] std::vector<double> weights_at(Point p) const;
  /// The polynomial of these samples, in local coordinates; terms beyond its basis are 0.
  /// @pre determined(), one sample a point  @return in the order 1 x y x2 xy y2 x2y xy2
  [[nodiscard]] std::array<double, 8> coefficients(std::span<const double> samples) const;

 private:
  Basis basis_;
  Point centre_;
  double scale_;
  bool determined_ = false;
  std::size_t count_;
  std::vector<double> inverse_;  ///< terms x points, by rows: from samples to coefficients.
};

}  // namespace dobra::geom::fit
