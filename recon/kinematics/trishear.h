#pragma once
// Trishear: in front of the tip of a fault slip dies out across a triangle, which the tip takes along. Velocities in
// tip coordinates (x along the fault ahead, y into the hanging wall, m = tan(apical / 2), e = |y| / (m x), s the
// concentration, per unit of slip of sense v0 = +1 or -1):
//   |y| < m x  vx = v0 / 2 (sgn(y) e^(1/s) + 1)    vy = v0 m / (2 (1 + s)) (e^((1+s)/s) - 1)      div v = 0
//   above      (v0, 0)        below, and behind the tip in the footwall: 0
// Page: docs/algorithms/trishear.md. Source: [erslev1991], [zehnder2000].

#include "recon/kinematics/walk.h"
#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace recon::kinematics {

struct TrishearParams {
  base::Angle apical;          ///< Full angle of the triangle, in (0, 180) degrees.
  double propagation = 1.5;    ///< P/S: how far the tip goes a metre of slip, >= 0.
  double concentration = 1.0;  ///< s > 0; above 1 strain gathers in the middle.
};

struct TrishearTolerances {
  double chord = 0.0;          ///< Images of lines are halved until their chord is this near, m; 0: 1e-6 of the size.
  double integration = 1e-13;  ///< Error of a step, relative to the distance from the tip.
  int most_halvings = 14;      ///< Of a piece of a line.
};

class TrishearMap {
 public:
  TrishearMap() = default;
  /// @param tip        before the slip; it goes P/S |slip| along `direction` in either sense of slip.
  /// @param direction  of the fault at its tip, unit, the way the tip goes.
  /// @param hanging    side of `direction`.
  /// @param slip       of the hanging wall along `direction`, m.
  /// @error CannotRestore where a parameter is outside its range.
  static base::Result<TrishearMap> make(geom::Point tip, geom::Vector direction, Side hanging, double slip,
                                        const TrishearParams& params, const TrishearTolerances& tolerances = {});

  /// The inverse: time runs back, and the tip goes home. It is not the map of -slip.
  [[nodiscard]] TrishearMap swapped() const;
  /// @param on_fault  of points on the fault behind the tip. With P/S < 1 and slip > 0 the hanging wall overtakes the
  /// tip:
  ///                  what lies on the fault is then spread in front of it, and comes out in its footwall.
  [[nodiscard]] geom::Point operator()(geom::Point p, Wall on_fault = Wall::Hanging) const;
  /// Halved until its pieces are true to the chord tolerance.
  [[nodiscard]] MovedLine line(const geom::Polyline& line, Wall on_fault = Wall::Hanging) const;
  [[nodiscard]] Tip tip() const;
  [[nodiscard]] double size() const { return size_; }

 private:
  /// Whether two images lie in the two walls behind the tip.
  [[nodiscard]] bool parted(geom::Point image, geom::Point other) const;
  /// The vertex between a and b at which the tip has cut the line, with its images on both walls.
  void add_cut(geom::Point a, geom::Point b, Wall on_fault, MovedLine& moved) const;

  geom::Point tip_;  ///< Before the forward slip.
  geom::Vector direction_{1.0, 0.0};
  geom::Vector out_{0.0, 1.0};
  double amount_ = 0.0;  ///< |slip|, m.
  double sense_ = 1.0;   ///< v0
  TrishearParams params_;
  double slope_ = 0.5;  ///< m
  TrishearTolerances tolerances_;
  bool back_ = false;
  double size_ = 1.0;  ///< m
};

/// Whether the fault as drawn ends where the tip stood before the slip, or after it.
enum class DrawnTip { Before, After };

/// The end of a path in front of which trishear takes place: its last point, or its first one if the path has a tip
/// there alone.
struct TrishearTip {
  bool at_begin = false;
  geom::Point at;
  geom::Point bend;        ///< The vertex behind it.
  geom::Vector direction;  ///< The way the tip goes, unit.
};
TrishearTip trishear_tip(const FaultPath& path);

/// Trishear at that end. The fault must be straight behind it for as far as slip and zone reach.
/// @param slip  along the path, m.
/// @error CannotRestore: parameters, or a bend too near to the tip, with its place.
base::Result<TrishearMap> trishear(const FaultPath& path, double slip, const TrishearParams& params, DrawnTip drawn,
                                   const TrishearTolerances& tolerances = {});

}  // namespace recon::kinematics
