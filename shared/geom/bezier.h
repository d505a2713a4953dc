#pragma once
// Bezier curves of any degree, plain and rational, and the cubic in Hermite form. All are travelled from parameter 0
// to 1. Page: docs/algorithms/curves.md. Source: [farin2002curves].

#include <span>
#include <utility>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::geom {

/// Lies in the convex hull of its vertices and begins and ends at the first and the last.
class Bezier {
 public:
  /// @error DegenerateCurve for fewer than two vertices; NotFinite.
  static base::Result<Bezier> make(std::vector<Point> vertices);

  [[nodiscard]] std::span<const Point> vertices() const { return vertices_; }
  [[nodiscard]] std::size_t degree() const { return vertices_.size() - 1; }
  /// By de Casteljau's rule. @cost O(degree^2)
  [[nodiscard]] Point point(double t) const;
  /// Derivative by t.
  [[nodiscard]] Vector tangent(double t) const;
  /// Length between two parameters, m, to 1e-12 of itself where the curve has no cusp.
  [[nodiscard]] double length(double t0, double t1) const;
  /// The parts before and after t; together they are the curve.
  [[nodiscard]] std::pair<Bezier, Bezier> split(double t) const;

 private:
  explicit Bezier(std::vector<Point> vertices) : vertices_(std::move(vertices)) {}
  friend Bezier bezier_of(const struct HermiteCubic& cubic);
  std::vector<Point> vertices_;
};

/// Vertex 1 of a curve of degree `degree` that goes on from the end of `before` with the same derivative (equation 49):
/// degree (V1 - V0) = n (V_n - V_{n-1}).
Point smooth_continuation(const Bezier& before, std::size_t degree);

/// A cubic by its ends and its derivatives there.
struct HermiteCubic {
  Point from, to;
  Vector from_tangent, to_tangent;
};
Bezier bezier_of(const HermiteCubic& cubic);
/// @pre degree 3.
HermiteCubic hermite_of(const Bezier& cubic);

/// Vertices with positive weights; arcs of conics exactly.
class RationalBezier {
 public:
  /// @error DegenerateCurve for fewer than two vertices; InvalidOption for other than one positive weight a vertex;
  /// NotFinite.
  static base::Result<RationalBezier> make(std::vector<Point> vertices, std::vector<double> weights);

  [[nodiscard]] std::span<const Point> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const double> weights() const { return weights_; }
  [[nodiscard]] Point point(double t) const;
  [[nodiscard]] Vector tangent(double t) const;
  [[nodiscard]] double length(double t0, double t1) const;
  [[nodiscard]] std::pair<RationalBezier, RationalBezier> split(double t) const;

 private:
  RationalBezier(std::vector<Point> vertices, std::vector<double> weights)
      : vertices_(std::move(vertices)), weights_(std::move(weights)) {}
  std::vector<Point> vertices_;
  std::vector<double> weights_;
};

}  // namespace dobra::geom
