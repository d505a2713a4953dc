#include "recon/moving/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/base/parallel.h"
#include "shared/geom/place.h"

namespace recon::moving {

namespace {

using kinematics::Amount;
using kinematics::FaultPath;
using kinematics::Measure;

constexpr double nowhere = std::numeric_limits<double>::infinity();
/// Cutoffs meet if they are nearer than this part of the size.
constexpr double meets = 1e-7;
/// Slips that are tried where the misfit may have several valleys.
constexpr std::size_t trials = 65;
constexpr int most_steps = 60;

/// The sum of squares that is to be least.
class Objective {
 public:
  Objective(const FaultPath& path, const MoveParams& params, std::span<const CutHorizon> close, double arc)
      : path_(path), params_(params), close_(close), arc_(arc) {}

  [[nodiscard]] base::Result<Motion> motion(double slip) const {
    return make_motion(path_, params_, {Measure::Slip, slip}, arc_);
  }
  /// Empty where the method has no map of that slip.
  [[nodiscard]] std::vector<double> residuals(double slip) const {
    const auto made = motion(slip);
    std::vector<double> along;
    for (const CutHorizon& cut : close_) {
      if (made) along.push_back(misfit_of(cut, path_, params_, made->map).along);
    }
    return along;
  }
  [[nodiscard]] double at(double slip) const {
    const std::vector<double> along = residuals(slip);
    double sum = along.empty() ? nowhere : 0.0;
    for (const double one : along) sum += one * one;
    return sum;
  }

 private:
  const FaultPath& path_;
  const MoveParams& params_;
  std::span<const CutHorizon> close_;
  double arc_;
};

/// Gauss-Newton with halved steps, from a slip that has a map.
double descend(const Objective& objective, double slip, double size) {
  double least = objective.at(slip);
  for (int step = 0; step < most_steps && least > 0.0; ++step) {
    const double difference = 1e-6 * size;
    const std::vector<double> here = objective.residuals(slip);
    const std::vector<double> before = objective.residuals(slip - difference);
    const std::vector<double> behind = objective.residuals(slip + difference);
    if (before.empty() || behind.empty()) break;
    double slope = 0.0, curvature = 0.0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double change = (behind[i] - before[i]) / (2.0 * difference);
      slope += change * here[i];
      curvature += change * change;
    }
    if (!(curvature > 0.0)) break;
    double by = -slope / curvature;
    double next = objective.at(slip + by);
    for (int half = 0; half < 40 && !(next < least); ++half) next = objective.at(slip + (by *= 0.5));
    if (!(next < least)) break;
    slip += by;
    least = next;
  }
  return slip;
}

/// The slip from which to go down: by the cutoffs alone, or the best of many where the misfit may have several valleys.
double first_slip(const Objective& objective, const MoveParams& params, std::span<const CutHorizon> close,
                  const FaultPath& path) {
  double mean = 0.0;
  for (const CutHorizon& cut : close) {
    const geom::Vector apart = cut.footwall - cut.hanging_wall;
    mean += params.method == MoveMethod::Rigid && !params.angle ? dot(apart, kinematics::chord(path))
                                                                : cut.foot_arc - cut.hanging_arc;
  }
  mean /= static_cast<double>(close.size());
  if (objective.at(mean) < nowhere && !has_tip(*params.method) && params.method != MoveMethod::FaultBendFold)
    return mean;
  const double reach = std::max(2.0 * geom::length(path.line), 4.0 * std::abs(mean));
  std::vector<double> sums(trials);
  const auto slip = [&](std::size_t i) {
    return i == 0 ? mean : reach * (2.0 * static_cast<double>(i) / static_cast<double>(trials) - 1.0);
  };
  base::parallel_for(trials, [&](std::size_t i) { sums[i] = objective.at(slip(i)); });
  return slip(static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin()));
}

}  // namespace

Misfit misfit_of(const CutHorizon& cut, const FaultPath& path, const MoveParams& params,
                 const kinematics::BlockMap& map) {
  const geom::Point moved = map.forward(cut.hanging_wall, kinematics::Wall::Hanging);
  Misfit misfit{cut.horizon, 0.0, 0.0, 0.0};
  const kinematics::OnPath on = nearest(path, moved);
  const geom::Vector chord = kinematics::chord(path);
  misfit.along = params.method == MoveMethod::Rigid ? dot(cut.footwall - moved, chord) : cut.foot_arc - on.arc;
  misfit.gap = std::max(on.distance, 0.0);
  misfit.overlap = std::max(-on.distance, 0.0);
  return misfit;
}

double root_mean_square(std::span<const Misfit> misfits) {
  double sum = 0.0;
  for (const Misfit& misfit : misfits) sum += misfit.along * misfit.along;
  return misfits.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(misfits.size()));
}

base::Result<Motion> solve_slip(const FaultPath& path, const MoveParams& params, std::span<const CutHorizon> close,
                                double arc, double size) {
  // Of one horizon slip is measured at its own cutoff: then the methods that keep points on the fault meet at once.
  const double measured = close.size() == 1 ? close.front().hanging_arc : arc;
  const Objective objective(path, params, close, measured);
  const double slip = descend(objective, first_slip(objective, params, close, path), size);
  DOBRA_TRY(Motion motion, objective.motion(slip));
  if (measured != arc && params.method == MoveMethod::Shear)
    motion.slip = nearest(path, motion.map.forward(point_at(path, arc))).arc - arc;
  const Misfit left = misfit_of(close.front(), path, params, motion.map);
  if (close.size() == 1 && std::abs(left.along) > meets * size) {
    return base::Error{base::ErrorCode::CannotRestore,
                       fmt::format("the cutoffs of horizon '{}' cannot meet by {}: at best, with a slip of {:.6g} m, "
                                   "{:.6g} m are left along the fault; take another method, or give the slip",
                                   left.horizon, method_name(*params.method), motion.slip, left.along),
                       place_at(close.front().footwall, "fault")};
  }
  return motion;
}

}  // namespace recon::moving
