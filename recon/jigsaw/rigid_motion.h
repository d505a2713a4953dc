#pragma once
// A turn and a shift of the plane.

#include <cmath>

#include "shared/geom/polyline.h"

namespace recon {
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::jigsaw {

struct RigidMotion {
  double turn = 0.0;  ///< Anticlockwise, radians.
  geom::Point about;
  geom::Vector by;  ///< After the turn, m.

  [[nodiscard]] geom::Vector turned(geom::Vector v) const { return rotated(v, turn); }
  [[nodiscard]] geom::Point forward(geom::Point p) const {
    return (turn == 0.0 ? p : about + rotated(p - about, turn)) + by;
  }
  [[nodiscard]] geom::Point inverse(geom::Point p) const {
    return turn == 0.0 ? p - by : about + rotated(p - by - about, -turn);
  }
  [[nodiscard]] geom::Polyline forward(geom::Polyline line) const {
    for (geom::Point& p : line.points) p = forward(p);
    return line;
  }
  [[nodiscard]] geom::Polyline inverse(geom::Polyline line) const {
    for (geom::Point& p : line.points) p = inverse(p);
    return line;
  }

 private:
  static geom::Vector rotated(geom::Vector v, double angle) {
    if (angle == 0.0) return v;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
  }
};

}  // namespace recon::jigsaw
