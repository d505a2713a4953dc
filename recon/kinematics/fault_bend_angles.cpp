#include "recon/kinematics/fault_bend_angles.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace recon::kinematics {

namespace {

using std::numbers::pi;

/// phi that goes with a gamma.
double phi_of(double theta, double gamma) {
  const double x = gamma - theta;
  return std::atan2(1.0, 1.0 / std::tan(x) - 2.0 / std::tan(gamma)) - x;
}

BendFold fold_of(double theta, double phi, double gamma) {
  return bend_with(base::Angle::from_radians(theta), base::Angle::from_radians(phi), base::Angle::from_radians(gamma));
}

}  // namespace

BendFold bend_with(base::Angle theta, base::Angle phi, base::Angle gamma) {
  const double between = gamma.radians() - theta.radians();
  const double ratio = std::sin(between) / std::sin(between + phi.radians());
  return {theta, phi, gamma, base::Angle::from_radians(theta.radians() - phi.radians() + pi - 2.0 * gamma.radians()),
          ratio};
}

base::Result<BendFold> bend_fold(base::Angle cutoff, base::Angle turn) {
  const double theta = cutoff.radians();
  const double phi = turn.radians();
  if (std::abs(theta) < 1e-12) {
    BendFold along{{}, turn, base::Angle::from_radians(0.5 * (pi - phi)), {}, 1.0};
    return along;
  }
  if (theta < 0.0 || theta >= 0.5 * pi) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("the fault cuts the beds at {:.2f} degrees; a fault-bend fold climbs through them at 0 "
                    "to 90 degrees; say which way the beds lie (bedding), or take fault_parallel_flow",
                    cutoff.degrees())};
  }
  // phi has its maximum where tan gamma = 3 tan theta, and falls from there to gamma = 180 degrees.
  double low = std::atan(3.0 * std::tan(theta));
  double high = pi;
  const double greatest = phi_of(theta, low);
  if (phi > greatest + 1e-12) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("no fold keeps the thickness of beds cut at {:.2f} degrees round a bend of {:.2f} "
                    "degrees; the greatest bend is {:.2f} degrees; draw the bend with more corners, or take "
                    "fault_parallel_flow",
                    cutoff.degrees(), turn.degrees(), base::Angle::from_radians(greatest).degrees())};
  }
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (phi_of(theta, middle) > phi ? low : high) = middle;
  }
  return fold_of(theta, phi, 0.5 * (low + high));
}

base::Result<BendFold> step_up(base::Angle theta) {
  const double tangent = std::tan(theta.radians());
  const double under = 1.0 - 3.0 * tangent * tangent;
  if (!(theta.radians() > 0.0) || theta.degrees() > 30.0 + 1e-9) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("a step up to a flat has ramps of 0 to 30 degrees, not of {:.2f}; draw the ramp's top "
                    "with more corners, or take fault_parallel_flow",
                    theta.degrees())};
  }
  const double gamma = std::atan2(1.0 + std::sqrt(std::max(under, 0.0)), tangent);
  return fold_of(theta.radians(), theta.radians(), gamma);
}

}  // namespace recon::kinematics
