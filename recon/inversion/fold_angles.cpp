#include "recon/inversion/fold_angles.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace recon::inversion {

namespace {

using kinematics::BendFold;
using std::numbers::pi;

base::Result<void> check_dips(const LimbDips& dips) {
  if (!dips.backlimb && !dips.forelimb) {
    return base::Error{base::ErrorCode::BadValue, "give the dip of the backlimb, of the forelimb, or both"};
  }
  if (dips.backlimb && !(dips.backlimb->degrees() > 0.0 && dips.backlimb->degrees() < 90.0)) {
    return base::Error{base::ErrorCode::BadValue,
                       fmt::format("'backlimb' is between 0 and 90 degrees, not {:.6g}", dips.backlimb->degrees())};
  }
  if (dips.forelimb && !(dips.forelimb->degrees() > 0.0 && dips.forelimb->degrees() < 180.0)) {
    return base::Error{base::ErrorCode::BadValue, fmt::format("'forelimb' is between 0 and 180 degrees (above 90: "
                                                              "overturned), not {:.6g}",
                                                              dips.forelimb->degrees())};
  }
  return {};
}

/// Axial angle of a limb.
double axial(base::Angle dip) { return 0.5 * (pi - dip.radians()); }

BendFold bend_of(double theta, double phi, double gamma) {
  return kinematics::bend_with(base::Angle::from_radians(theta), base::Angle::from_radians(phi),
                               base::Angle::from_radians(gamma));
}

base::Result<std::vector<BendFold>> steps_of_ramp(base::Angle theta) {
  DOBRA_TRY(const BendFold open, kinematics::step_up(theta));
  std::vector<BendFold> folds{open};
  const double tangent = std::tan(theta.radians());
  const double under = std::sqrt(std::max(0.0, 1.0 - 3.0 * tangent * tangent));
  const double tight = std::atan((1.0 - under) / tangent);
  if (under > 1e-6) folds.push_back(bend_of(theta.radians(), theta.radians(), tight));
  return folds;
}

}  // namespace

base::Result<std::vector<BendFold>> bend_folds_of(const LimbDips& dips) {
  DOBRA_TRY_VOID(check_dips(dips));
  if (!dips.forelimb) return steps_of_ramp(*dips.backlimb);
  const double gamma = axial(*dips.forelimb);
  if (!dips.backlimb) {
    const double theta = std::atan2(std::sin(2.0 * gamma), 2.0 * std::cos(gamma) * std::cos(gamma) + 1.0);
    return std::vector<BendFold>{bend_of(theta, theta, gamma)};
  }
  const double theta = dips.backlimb->radians();
  const double between = gamma - theta;
  // cot(gamma - theta + phi) = cot(gamma - theta) - 2 cot(gamma), the angle in (0, 180) degrees.
  const double behind = between > 0.0 ? std::atan2(1.0, 1.0 / std::tan(between) - 2.0 / std::tan(gamma)) : between;
  if (!(between > 0.0) || !(behind > between)) {
    return base::Error{
        base::ErrorCode::CannotRestore,
        fmt::format("no fault that gets flatter over a ramp of {:.4g} degrees folds a forelimb of {:.4g} "
                    "degrees with beds of constant thickness; try fault_propagation_fold, or measure the "
                    "dips anew",
                    dips.backlimb->degrees(), dips.forelimb->degrees())};
  }
  return std::vector<BendFold>{bend_of(theta, behind - between, gamma)};
}

base::Result<PropagationFold> propagation_fold_of(const LimbDips& dips) {
  DOBRA_TRY_VOID(check_dips(dips));
  if (!dips.backlimb && dips.forelimb->degrees() <= 60.0) {
    return base::Error{base::ErrorCode::CannotRestore,
                       fmt::format("the forelimb of a parallel fault-propagation fold dips more than 60 degrees, not "
                                   "{:.4g}; try fault_bend_fold, or trishear",
                                   dips.forelimb->degrees())};
  }
  const base::Angle theta = dips.backlimb
                                ? *dips.backlimb
                                : base::Angle::from_radians(2.0 * std::atan(std::tan(axial(*dips.forelimb)) / 3.0));
  PropagationFold fold;
  DOBRA_TRY(fold.angles, kinematics::propagation_angles(theta));
  if (dips.backlimb && dips.forelimb) {
    fold.misfit = base::Angle::from_degrees(180.0 - 2.0 * fold.angles.gamma_star.degrees() - dips.forelimb->degrees());
  }
  return fold;
}

}  // namespace recon::inversion
