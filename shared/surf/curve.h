#pragma once
// Curves in space as values: the borders and profiles of surfaces. Page: docs/algorithms/surfaces.md.

#include <memory>
#include <vector>

#include "shared/geom/point.h"
#include "shared/geom/point3.h"
#include "shared/surf/spline_basis.h"

namespace dobra::surf {

/// Cheap to copy; any number of threads may ask at once.
class Curve {
 public:
  /// A point with the derivatives by the parameter.
  struct Jet {
    geom::Point3 at;
    geom::Vector3 first, second;
  };

  /// From parameter 0 to 1. @error NotFinite; DegenerateCurve if the ends are the same.
  static base::Result<Curve> line(geom::Point3 from, geom::Point3 to);
  /// A part of a circle: centre + cos t * along + sin t * across, t in radians.
  /// @param along, across  of one length, the radius, at a right angle (to 1e-9 of it).
  /// @error NotFinite; DegenerateCurve: no radius, axes that are not so, an angle of zero or more than a full turn.
  static base::Result<Curve> arc(geom::Point3 centre, geom::Vector3 along, geom::Vector3 across, double from,
                                 double to);
  /// at + t along, from <= t <= to. @error NotFinite; DegenerateCurve: no direction, or a range that is empty; so
  /// below.
  static base::Result<Curve> line(geom::Point3 at, geom::Vector3 along, double from, double to);
  /// centre + f(t) along + g(t) across with axes of any length and angle: (f, g) = (cos t, sin t) for an ellipse, of
  /// which t may go round more than once, (cosh t, sinh t) for a hyperbola, (t^2, t) for a parabola.
  enum class Conic { Ellipse, Hyperbola, Parabola };
  static base::Result<Curve> conic(Conic kind, geom::Point3 centre, geom::Vector3 along, geom::Vector3 across,
                                   double from, double to);
  /// A part of an ellipse, as an arc, but the axes (any two conjugate half diameters) have any lengths and angle.
  /// @error as arc; DegenerateCurve: axes along one line
  static base::Result<Curve> ellipse(geom::Point3 centre, geom::Vector3 along, geom::Vector3 across, double from,
                                     double to);
  /// Straight from point to point, by length from 0. @error NotFinite; DegenerateCurve: fewer than two points, or two
  /// that follow each other in one place, with their number from 1.
  static base::Result<Curve> polyline(const std::vector<geom::Point3>& points);
  /// The cubic spline through points, by length of the chords from 0, with continuous curvature: closed and smooth all
  /// round where the last point is the first, else with a third derivative that is continuous at the second and last
  /// but one. Two points are a line, three a parabola. Source: [piegl1997], 9.2. @error as polyline
  static base::Result<Curve> through(const std::vector<geom::Point3>& points);
  /// The same by parameters of one's own, one a point, rising: in a chart whose directions have other units, lengths in
  /// space. @error as polyline; InvalidOption: not as many parameters, or they do not rise
  static base::Result<Curve> through(const std::vector<geom::Point3>& points, const std::vector<double>& parameters);
  /// A rational B-spline; all weights 1 where none are given.
  /// @error those of SplineBasis::make; InvalidOption: not a point (or weight) for each function, a weight that is not
  ///        positive; NotFinite. Each names the number from 1. DegenerateCurve: it is torn at a knot that stands
  ///        degree + 1 times (points on both sides further apart than 1e-12 of the box of all), with the gap.
  static base::Result<Curve> nurbs(std::size_t degree, std::vector<double> knots, std::vector<geom::Point3> points,
                                   std::vector<double> weights = {});
  /// A Bezier curve, plain or rational, on 0 .. 1. @error as nurbs
  static base::Result<Curve> bezier(std::vector<geom::Point3> points, std::vector<double> weights = {});

  /// The image by the map that sends (a, b, c) to to + a x + b y + c z.
  [[nodiscard]] Curve moved(geom::Vector3 x, geom::Vector3 y, geom::Vector3 z, geom::Point3 to) const;
  /// The same over another range. Beyond its own range a closed curve goes round again; the end pieces of an open one
  /// go on. @error NotFinite, DegenerateCurve: a range that is empty
  [[nodiscard]] base::Result<Curve> over(double from, double to) const;
  /// Moved by `distance` along tangent x direction; in the plane to the right where the direction is z.
  /// Second derivatives are differences of fourth order, within 1e-7 of their size where the curve is smooth.
  /// @error DegenerateCurve: no tangent, or one along the direction, at one of 65 places, with the place.
  [[nodiscard]] base::Result<Curve> offset(double distance, geom::Vector3 direction) const;
  /// The part between two parameters with its ends moved to two places exactly; what is between moves by the linear
  /// mean of both. @pre from < to, in the range
  [[nodiscard]] Curve reaching(double from, geom::Point3 at_from, double to, geom::Point3 at_to) const;

  /// A curve in a chart with x and y held between two corners: what leaves the box runs along its border.
  [[nodiscard]] Curve held(geom::Point low, geom::Point high) const;

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  /// Parameters between which it is smooth, both ends among them.
  [[nodiscard]] const std::vector<double>& breaks() const { return breaks_; }
  [[nodiscard]] Jet jet(double t) const { return shape_->jet(t); }
  [[nodiscard]] geom::Point3 at(double t) const { return jet(t).at; }
  /// Between two parameters, m, to 1e-12 of itself where it has no cusp.
  [[nodiscard]] double length(double from, double to) const;

  /// No second derivative between two parameters is longer, m.
  [[nodiscard]] double bend(double from, double to) const { return shape_->bend(from, to); }

  /// A kind of curve.
  struct Shape {
    virtual ~Shape() = default;
    [[nodiscard]] virtual Jet jet(double t) const = 0;
    [[nodiscard]] virtual double bend(double from, double to) const = 0;
  };
  /// A kind that is not above. @pre breaks ascend, two at least
  static Curve of(std::shared_ptr<const Shape> shape, std::vector<double> breaks) {
    return Curve(std::move(shape), std::move(breaks));
  }

 private:
  Curve(std::shared_ptr<const Shape> shape, std::vector<double> breaks)
      : shape_(std::move(shape)), low_(breaks.front()), high_(breaks.back()), breaks_(std::move(breaks)) {}
  std::shared_ptr<const Shape> shape_;
  double low_, high_;
  std::vector<double> breaks_;
};

}  // namespace dobra::surf
