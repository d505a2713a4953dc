#include "recon/moving/motion.h"

#include <fmt/format.h>

#include <cmath>

#include "recon/kinematics/fault_bend_fold.h"
#include "recon/kinematics/fault_slip.h"
#include "recon/kinematics/shear.h"
#include "shared/geom/place.h"

namespace recon::moving {

namespace {

using kinematics::Amount;
using kinematics::BlockMap;
using kinematics::FaultPath;
using kinematics::Measure;

/// Slip along a straight segment. A level one has no throw, an upright one no heave.
base::Result<double> slip_on(const geom::Segment& segment, Amount amount, const char* what) {
  if (amount.as == Measure::Slip) return amount.value;
  const geom::Vector along = geom::normalised(segment.to - segment.from);
  const double part = std::abs(amount.as == Measure::Heave ? along.x : along.y);
  if (part > 1e-9) return amount.value / part;
  const bool heave = amount.as == Measure::Heave;
  return base::Error{base::ErrorCode::CannotRestore,
                     fmt::format("{} is {}, so that slip along it has no {}; give slip or {}", what,
                                 heave ? "upright" : "level", heave ? "heave" : "throw", heave ? "throw" : "heave"),
                     place_at(segment.from, "fault")};
}

base::Result<double> slip_from(const FaultPath& path, Amount amount, double arc) {
  DOBRA_TRY(const double reached, arc_after(path, arc, amount));
  return reached - arc;
}

base::Result<Motion> rigid(const FaultPath& path, const MoveParams& params, Amount amount) {
  DOBRA_TRY(const geom::Vector by, shift_along_chord(path, amount));
  Motion motion;
  motion.slip = dot(by, kinematics::chord(path));
  motion.map =
      BlockMap(params.angle ? kinematics::RigidMap(*params.angle, *params.pivot, by) : kinematics::RigidMap(by));
  return motion;
}

base::Result<Motion> shear(const FaultPath& path, const MoveParams& params, Amount amount, double arc) {
  Motion motion;
  const base::Angle angle = params.angle.value_or(base::Angle{});
  DOBRA_TRY(const double h, shear_heave(path, angle, arc, amount));
  DOBRA_TRY(maps::SectionMap map, shear_over(path, angle, h));
  DOBRA_TRY(motion.slip, slip_from(path, amount, arc));
  motion.map = BlockMap(std::move(map));
  motion.figures = {{"shear_heave", h}};
  return motion;
}

base::Result<Motion> flow(const FaultPath& path, Amount amount, double arc) {
  Motion motion;
  DOBRA_TRY(motion.slip, slip_from(path, amount, arc));
  DOBRA_TRY(kinematics::FlowMap map, fault_parallel_flow(path, motion.slip));
  motion.map = BlockMap(std::move(map));
  return motion;
}

base::Result<Motion> flexural(const FaultPath& path, Amount amount, double arc) {
  Motion motion;
  DOBRA_TRY(motion.slip, slip_from(path, amount, arc));
  DOBRA_TRY(maps::ColumnMap map, flexural_slip(path, motion.slip));
  motion.map = BlockMap(maps::SectionMap(std::move(map)));
  return motion;
}

void report_bend(const kinematics::BendStage& stage, std::size_t number, Motion& motion) {
  const std::string prefix = fmt::format("bend_{}.", number);
  for (const auto& [name, angle] : {std::pair{"theta", stage.fold.theta},
                                    {"phi", stage.fold.phi},
                                    {"gamma", stage.fold.gamma},
                                    {"beta", stage.fold.beta}})
    motion.figures.emplace_back(prefix + name, angle.degrees());
  motion.figures.emplace_back(prefix + "slip_ratio", stage.fold.slip_ratio);
  motion.remarks.push_back(fmt::format(
      "bend at {}, slip from {:.6g} to {:.6g} m: theta {:.4g}, phi {:.4g}, gamma {:.4g}, beta {:.4g} degrees, R {:.5g}",
      stage.at, stage.from, stage.to, stage.fold.theta.degrees(), stage.fold.phi.degrees(), stage.fold.gamma.degrees(),
      stage.fold.beta.degrees(), stage.fold.slip_ratio));
}

base::Result<Motion> bend_fold(const FaultPath& path, const MoveParams& params, Amount amount) {
  Motion motion;
  DOBRA_TRY(motion.slip, slip_on(path.line.segment(0), amount, "the lowest segment of the fault"));
  const bool forward = params.direction == Direction::Forward;
  const double from = forward ? params.slip_before : params.slip_before - motion.slip;
  const double to = forward ? params.slip_before + motion.slip : params.slip_before;
  DOBRA_TRY(const std::vector<kinematics::BendStage> stages, bend_stages(path, params.bedding, from, to));
  DOBRA_TRY(kinematics::FlowMap map, fault_bend_fold(path, params.bedding, from, to));
  motion.map = BlockMap(std::move(map));
  for (std::size_t i = 0; i < stages.size(); ++i) report_bend(stages[i], i + 1, motion);
  return motion;
}

/// Slip that has made the ramp of a fold as it is drawn, m.
double slip_of_ramp(const FaultPath& path, const kinematics::PropagationAngles& angles) {
  const bool drawn = path.line.points.size() > 2;
  return drawn ? path.line.segment(path.line.segment_count() - 1).length() / angles.propagation : 0.0;
}

base::Result<Motion> propagation_fold(const FaultPath& path, const MoveParams& params, Amount amount) {
  Motion motion;
  DOBRA_TRY(motion.slip, slip_on(path.line.segment(0), amount, "the lower flat"));
  DOBRA_TRY(const auto still, kinematics::PropagationMap::make(path, params.ramp, 0.0, 0.0));
  const kinematics::PropagationAngles& angles = still.angles();
  const bool drawn = path.line.points.size() > 2;
  const geom::Segment ramp = path.line.segment(path.line.segment_count() - 1);
  const double had = slip_of_ramp(path, angles);
  if (had + motion.slip < -1e-9 * (had + std::abs(motion.slip))) {
    return base::Error{base::ErrorCode::CannotRestore,
                       fmt::format("the ramp is {:.6g} m long, which a slip of {:.6g} m makes (P/S {:.4g}); give at "
                                   "most that",
                                   drawn ? ramp.length() : 0.0, had, angles.propagation),
                       place_at(ramp.from, "fault")};
  }
  DOBRA_TRY(auto map, kinematics::PropagationMap::make(path, params.ramp, had, std::max(had + motion.slip, 0.0)));
  motion.figures = {{"theta", angles.theta.degrees()},
                    {"gamma_star", angles.gamma_star.degrees()},
                    {"gamma", angles.gamma.degrees()},
                    {"propagation", angles.propagation}};
  motion.map = BlockMap(std::move(map));
  return motion;
}

base::Result<Motion> trishear(const FaultPath& path, const MoveParams& params, Amount amount) {
  Motion motion;
  DOBRA_TRY(motion.slip, slip_on(path.line.segment(path.line.segment_count() - 1), amount, "the fault at its tip"));
  const kinematics::TrishearParams given{*params.apical, params.propagation, params.concentration};
  if (params.direction == Direction::Forward) {
    DOBRA_TRY(auto map, kinematics::trishear(path, motion.slip, given, kinematics::DrawnTip::Before));
    motion.map = BlockMap(std::move(map));
  } else {
    DOBRA_TRY(auto map, kinematics::trishear(path, -motion.slip, given, kinematics::DrawnTip::After));
    motion.map = BlockMap(map.swapped());
  }
  return motion;
}

}  // namespace

bool has_tip(MoveMethod method) { return method == MoveMethod::FaultPropagationFold || method == MoveMethod::Trishear; }

std::optional<double> slip_to_bend(const FaultPath& drawn, const MoveParams& params) {
  if (params.method != MoveMethod::FaultPropagationFold || params.direction == Direction::Forward) return std::nullopt;
  const FaultPath path = straightened(drawn);
  const auto map = kinematics::PropagationMap::make(path, params.ramp, 0.0, 0.0);
  if (!map || path.line.points.size() < 3) return std::nullopt;
  return -slip_of_ramp(path, map->angles());
}

base::Result<Motion> make_motion(const FaultPath& drawn, const MoveParams& params, Amount amount, double arc) {
  const FaultPath path = straightened(drawn);
  switch (*params.method) {
    case MoveMethod::Rigid:
      return rigid(path, params, amount);
    case MoveMethod::Shear:
      return shear(path, params, amount, arc);
    case MoveMethod::FaultParallelFlow:
      return flow(path, amount, arc);
    case MoveMethod::FaultBendFold:
      return bend_fold(path, params, amount);
    case MoveMethod::FaultPropagationFold:
      return propagation_fold(path, params, amount);
    case MoveMethod::Trishear:
      return trishear(path, params, amount);
    case MoveMethod::FlexuralSlip:
      break;
  }
  return flexural(path, amount, arc);
}

}  // namespace recon::moving
