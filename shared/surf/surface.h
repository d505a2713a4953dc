#pragma once
// Parametric surfaces as values: a point of the chart (u, v) gives a point in space with its derivatives. The normal
// Su x Sv points to the side from which u to the right and v upwards turn anticlockwise. Page:
// docs/algorithms/surfaces.md.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shared/geom/box.h"
#include "shared/geom/point.h"
#include "shared/surf/curve.h"

namespace dobra::surf {

/// An origin with three unit axes at right angles; z is x cross y, or its opposite.
struct Frame {
  geom::Point3 origin{};
  geom::Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
};

/// A point with its first and second derivatives.
struct Jet {
  geom::Point3 at;
  geom::Vector3 u, v, uu, uv, vv;
};

/// The sides of the chart: Left and Right at the ends of u, Bottom and Top at those of v.
enum class Side { Left, Right, Bottom, Top };

/// Where pieces of other formulas meet, along u and along v, the ends of the chart among them.
struct Breaks {
  std::vector<double> u, v;
};

/// No second derivative in a part of the chart is longer, m by the units of the chart.
struct Bend {
  double uu = 0.0, uv = 0.0, vv = 0.0;
};

/// Cheap to copy; any number of threads may ask at once. Angles in radians. Every maker may answer with NotFinite for a
/// number that is not, and with InvalidOption for a chart that is empty.
class Surface {
 public:
  /// origin + u x + v y of the frame, whose axes here may have any length and angle. @error DegenerateCurve: parallel
  static base::Result<Surface> plane(const Frame& frame, const geom::Box& chart);
  /// (radius cos u, radius sin u, v). @error DegenerateCurve: a radius that is not positive; so below.
  static base::Result<Surface> cylinder(const Frame& frame, double radius, const geom::Box& chart);
  /// (r cos u, r sin u, v cos a) with r = radius + v sin a; the apex may be a side, not inside.
  /// @param radius  at v = 0; 0 puts the apex there, and beyond the apex the other half of the cone is meant.
  /// @param half_angle  a, within a quarter turn of 0, and neither.
  static base::Result<Surface> cone(const Frame& frame, double radius, double half_angle, const geom::Box& chart);
  /// u the longitude, v the latitude; the poles may be sides, not inside.
  static base::Result<Surface> sphere(const Frame& frame, double radius, const geom::Box& chart);
  /// ((major + minor cos v) cos u, (major + minor cos v) sin u, minor sin v). @pre 0 < minor <= major
  static base::Result<Surface> torus(const Frame& frame, double major, double minor, const geom::Box& chart);

  /// Straight lines from `bottom` (v = 0) to `top` (v = 1) at equal parts of their parameters, 0 <= u <= 1.
  static base::Result<Surface> ruled(const Curve& bottom, const Curve& top);
  /// u the parameter of the profile, 0 <= v <= 1. @error DegenerateCurve: no way
  static base::Result<Surface> extruded(const Curve& profile, geom::Vector3 by);
  /// The same for from <= v <= to, S = profile(u) + v by.
  static base::Result<Surface> extruded(const Curve& profile, geom::Vector3 by, double from, double to);
  /// The profile (v its parameter) turned round the axis by u, from <= u <= to, a full turn at most.
  static base::Result<Surface> revolved(const Curve& profile, geom::Point3 on_axis, geom::Vector3 axis, double from,
                                        double to);
  /// Coons's patch of four borders on the unit square: bottom and top along u, left and right along v.
  /// @error DegenerateCurve: borders that do not meet in the corners to 1e-9 of their size, with the gap and its place.
  static base::Result<Surface> coons(const Curve& bottom, const Curve& top, const Curve& left, const Curve& right);
  /// z = formula(x, y) over a rectangle, u = x and v = y. Derivatives are those of the formula (base::FormulaJet);
  /// where one of its parts has none though the whole has a value (sqrt(x^4) at 0), differences of eighth order.
  /// @cost a few evaluations of the formula a jet
  /// @error those of base::Formula; OutsideDomain where it is not defined, with the place.
  static base::Result<Surface> graph(const std::string& formula, const geom::Box& chart);

  /// A rational B-spline patch; control points with v running fastest: point (i, j) is number i * count_v + j.
  /// @error those of SplineBasis::make and Curve::nurbs
  static base::Result<Surface> nurbs(std::size_t degree_u, std::vector<double> knots_u, std::size_t degree_v,
                                     std::vector<double> knots_v, const std::vector<geom::Point3>& points,
                                     std::vector<double> weights = {});
  /// The B-spline patch through a grid of points, v running fastest, on the unit square: parameters by mean chord
  /// length, knots by their averages. Degrees fall to what the counts allow. Source: [piegl1997], 9.2.5.
  /// @error InvalidOption: fewer than two rows or columns, not count_u * count_v points; DegenerateCurve: points that
  ///        follow each other in all rows (columns) are the same.
  static base::Result<Surface> through(const std::vector<geom::Point3>& points, std::size_t count_u,
                                       std::size_t count_v, std::size_t degree = 3);

  /// The image by the map that sends (a, b, c) to origin + a x + b y + c z: a motion, a mirror, a scale. The chart
  /// stays; a mirror turns the normal, Su x Sv, against the image of the old one.
  /// @error NotFinite; DegenerateCurve: a map that makes things flat
  [[nodiscard]] base::Result<Surface> moved(const Frame& frame) const;
  /// The same formula over another chart, a part of this one or beyond it: round again in a parameter in which it goes
  /// round, by the width of its own chart; else the end pieces go on.
  enum class Beyond { GoesOn, GoesRound };
  [[nodiscard]] base::Result<Surface> over(const geom::Box& chart, Beyond u = Beyond::GoesOn,
                                           Beyond v = Beyond::GoesOn) const;
  /// Each point moved along the unit normal Su x Sv. First derivatives are exact; second ones are differences of them
  /// of fourth order, within 1e-7 of their size. Bounds of bend() are half as much again as those of 9 x 9 places.
  /// @error DegenerateCurve: at one of 33 x 33 places there is no normal (but on a side that is one point), or a radius
  ///        of curvature on that side that is not greater than the distance, with the place.
  [[nodiscard]] base::Result<Surface> offset(double distance) const;

  [[nodiscard]] const geom::Box& chart() const { return chart_; }
  [[nodiscard]] const Breaks& breaks() const { return breaks_; }
  /// Those of the breaks on which the tangents of both sides differ, and the ends of the chart.
  [[nodiscard]] const Breaks& kinks() const { return kinks_; }
  /// Diagonal of the box of some points, m: what tolerances are measured by.
  [[nodiscard]] double size() const { return size_; }
  /// The side is one point in space.
  [[nodiscard]] bool collapsed(Side side) const { return collapsed_[static_cast<std::size_t>(side)]; }
  /// On a side that is one point.
  [[nodiscard]] bool in_pole(geom::Point uv) const;
  /// Left and right (bottom and top) are the same points.
  [[nodiscard]] bool closed_u() const { return closed_u_; }
  [[nodiscard]] bool closed_v() const { return closed_v_; }

  [[nodiscard]] Jet jet(geom::Point uv) const {
    Jet jet;
    shape_->jets({&uv, 1}, {&jet, 1});
    return jet;
  }
  [[nodiscard]] geom::Point3 at(geom::Point uv) const { return jet(uv).at; }
  /// Many at once. @pre as many jets as points
  void jets(std::span<const geom::Point> uv, std::span<Jet> jets) const { shape_->jets(uv, jets); }

  /// Bounds of the second derivatives in a part of the chart: proven ones, but for rounding, and for a graph where its
  /// formula has none: there they are half as much again as those at 257 x 257 places of the chart.
  [[nodiscard]] Bend bend(const geom::Box& part) const { return shape_->bend(part); }
  /// Whether 3 x 3 places of a part of the chart, its corners among them, tell how the surface bends there: nothing
  /// inside turns the tangents by more than twice the greatest and 2.5 times the mean of them, and half a hundredth.
  /// Proven for graphs, taken for granted for other kinds.
  [[nodiscard]] bool seen(const geom::Box& part) const { return shape_->seen(part); }

  /// A kind of surface.
  struct Shape {
    virtual ~Shape() = default;
    virtual void jets(std::span<const geom::Point> uv, std::span<Jet> jets) const = 0;
    [[nodiscard]] virtual Bend bend(const geom::Box& part) const = 0;
    [[nodiscard]] virtual bool seen(const geom::Box& /*part*/) const { return true; }
  };
  /// A kind that is not above. @param inside  breaks between the ends of the chart
  static base::Result<Surface> of(std::shared_ptr<const Shape> shape, const geom::Box& chart, Breaks inside = {}) {
    return make(std::move(shape), chart, std::move(inside));
  }

 private:
  static base::Result<Surface> make(std::shared_ptr<const Shape> shape, const geom::Box& chart, Breaks inside = {});
  Surface(std::shared_ptr<const Shape> shape, const geom::Box& chart, Breaks breaks);

  std::shared_ptr<const Shape> shape_;
  geom::Box chart_;
  Breaks breaks_, kinks_;
  double size_ = 0.0;
  std::array<bool, 4> collapsed_{};
  bool closed_u_ = false, closed_v_ = false;
};

}  // namespace dobra::surf
