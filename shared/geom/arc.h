#pragma once
// Circular arcs, up to the full circle. Travelled from parameter 0 to 1 at constant speed; anticlockwise for a positive
// sweep.

#include <cmath>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/geom/box.h"
#include "shared/geom/point.h"

namespace dobra::geom {

enum class Orientation { Anticlockwise, Clockwise };

class Arc {
 public:
  /// @param start  angle of the first point as seen from the centre, anticlockwise from +x.
  /// @param sweep  signed angle travelled; at most a full turn either way.
  /// @error DegenerateCurve for a radius that is not positive or a sweep of zero; InvalidOption for more than a full
  ///        turn; NotFinite.
  static base::Result<Arc> from_angles(Point centre, double radius, base::Angle start, base::Angle sweep);

  /// The arc round `centre` from one point to another, which it keeps bit for bit; from == to gives the full circle.
  /// The radius is the mean of the two distances to the centre.
  /// @param tolerance  greatest difference of the two distances, relative to their mean.
  /// @error DegenerateCurve if a point is the centre or the distances differ by more.
  static base::Result<Arc> from_ends(Point centre, Point from, Point to, Orientation orientation,
                                     double tolerance = 1e-9);

  /// The arc from `from` through `through` to `to`, which it keeps bit for bit.
  /// @error DegenerateCurve if the three are collinear (exactly) or two are equal.
  static base::Result<Arc> through(Point from, Point through, Point to);

  static base::Result<Arc> circle(Point centre, double radius, Orientation orientation = Orientation::Anticlockwise);

  [[nodiscard]] Point centre() const { return centre_; }
  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] base::Angle start() const { return start_; }
  [[nodiscard]] base::Angle sweep() const { return sweep_; }
  [[nodiscard]] Point from() const { return from_; }
  [[nodiscard]] Point to() const { return to_; }
  /// True for the full circle; its first and last point are equal.
  [[nodiscard]] bool closed() const { return from_ == to_ && std::abs(sweep_.degrees()) > 180.0; }

  /// The point at fraction t of the arc; from() at 0 and to() at 1, exactly.
  [[nodiscard]] Point point(double t) const;
  /// Derivative of point by t; its length is length().
  [[nodiscard]] Vector tangent(double t) const;
  [[nodiscard]] double length() const { return length(0.0, 1.0); }
  /// Length between two parameters, m.
  [[nodiscard]] double length(double t0, double t1) const;
  /// Smallest box of the arc (not of its chord).
  [[nodiscard]] Box box() const;
  [[nodiscard]] Arc reversed() const;

 private:
  Arc() = default;
  [[nodiscard]] double angle_at(double t) const { return start_.radians() + t * sweep_.radians(); }

  Point centre_;
  double radius_ = 0.0;
  base::Angle start_;
  base::Angle sweep_;
  Point from_;
  Point to_;
};

}  // namespace dobra::geom
