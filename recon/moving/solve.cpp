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
  // Behind the slip at which a tip leaves a bed its cutoffs stay together: of equally good slips the least.
  const double least = *std::min_element(sums.begin(), sums.end());
  std::size_t best = trials;
  for (std::size_t i = 0; i < trials; ++i) {
    if (sums[i] > least + meets * meets * reach * reach * 1e-4) continue;
    if (best == trials || std::abs(slip(i)) < std::abs(slip(best))) best = i;
  }
  return slip(best);
}

}  // namespace

Misfit misfit_of(const CutHorizon& cut, const FaultPath& path, const MoveParams& params,
                 const kinematics::BlockMap& map) {
  const auto carried = [&](geom::Point p, bool moves) { return moves ? map.forward(p, kinematics::Wall::Hanging) : p; };
  const geom::Point moved = carried(cut.hanging_wall, cut.hanging_moves);
  const geom::Point foot =
      map.tip() ? map.forward(cut.footwall, kinematics::Wall::Foot) : carried(cut.footwall, cut.foot_moves);
  Misfit misfit{cut.horizon, 0.0, 0.0, 0.0};
  const kinematics::OnPath hanging = nearest(path, moved);
  const kinematics::OnPath standing = nearest(path, foot);
  const bool rigid = params.method == MoveMethod::Rigid;
  misfit.along = rigid ? dot(foot - moved, kinematics::chord(path)) : standing.arc - hanging.arc;
  const double across = hanging.distance - standing.distance;
  misfit.gap = std::max(0.0, across);  // no -0
  misfit.overlap = std::max(0.0, -across);
  return misfit;
}

double root_mean_square(std::span<const Misfit> misfits) {
  double sum = 0.0;
  for (const Misfit& misfit : misfits) sum += misfit.along * misfit.along;
  return misfits.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(misfits.size()));
}

namespace {

/// Cutoffs of one horizon that do not meet, or of several that no slip brings nearer.
base::Result<void> refuse_apart(const FaultPath& path, const MoveParams& params, std::span<const CutHorizon> close,
                                const Motion& motion, double size) {
  std::vector<Misfit> before, after;
  std::string names;
  for (const CutHorizon& cut : close) {
    before.push_back(misfit_of(cut, path, params, {}));
    after.push_back(misfit_of(cut, path, params, motion.map));
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", cut.horizon);
  }
  const double left = root_mean_square(after);
  const bool meet = close.size() == 1 ? left <= meets * size
                                      : left <= std::max(meets * size, (1.0 - 1e-9) * root_mean_square(before));
  if (meet) return {};
  return base::Error{
      base::ErrorCode::CannotRestore,
      fmt::format("the cutoffs of horizon {} cannot meet by {}: at best, with a slip of {:.6g} m, {:.6g} "
                  "m are left along the fault{}; take another method, or give the slip",
                  names, method_name(*params.method), motion.slip, close.size() == 1 ? after.front().along : left,
                  close.size() == 1 ? "" : ", root mean square"),
      place_at(close.front().footwall, "fault")};
}

}  // namespace

base::Result<Motion> solve_slip(const FaultPath& path, const MoveParams& params, std::span<const CutHorizon> close,
                                double arc, double size) {
  // Of one horizon slip is measured at its own cutoff: then the methods that keep points on the fault meet at once.
  const double measured = close.size() == 1 ? close.front().hanging_arc : arc;
  const Objective objective(path, params, close, measured);
  double slip = descend(objective, first_slip(objective, params, close, path), size);
  const std::optional<double> whole = slip_to_bend(path, params);
  const bool to_bend = whole && objective.at(*whole) <= std::pow(meets * size, 2) * static_cast<double>(close.size());
  if (to_bend) slip = *whole;
  DOBRA_TRY(Motion motion, objective.motion(slip));
  if (to_bend) {
    motion.remarks.push_back(
        "the cutoffs meet as soon as the tip has left the beds; the slip taken is that of the whole "
        "fold, which takes the tip back to the bend");
  }
  if (measured != arc && params.method == MoveMethod::Shear)
    motion.slip = nearest(path, motion.map.forward(point_at(path, arc))).arc - arc;
  DOBRA_TRY_VOID(refuse_apart(path, params, close, motion, size));
  return motion;
}

}  // namespace recon::moving
