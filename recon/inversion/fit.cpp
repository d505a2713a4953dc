#include "recon/inversion/fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recon/inversion/least_squares.h"
#include "shared/base/parallel.h"

namespace recon::inversion {

namespace {

constexpr std::size_t search_points = 240;  ///< Of all beds together, for what is computed very many times, ...
constexpr std::size_t limit_points = 300;   ///< ... and for what is computed many times.
constexpr double known_figures = 1e-6;      ///< Of the size.
constexpr double quick_difference = 1e-4;   ///< Of models of the precision of a search.

/// The free values as the unit box.
class Box {
 public:
  explicit Box(const std::vector<Unknown>& unknowns) : unknowns_(unknowns) {
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
      if (!unknowns[i].fixed()) free_.push_back(i);
    }
  }
  [[nodiscard]] std::size_t dimension() const { return free_.size(); }
  [[nodiscard]] const std::vector<std::size_t>& free() const { return free_; }
  [[nodiscard]] double value(std::size_t k, double at) const {
    const Unknown& unknown = unknowns_[free_[k]];
    return at >= 1.0 ? unknown.high : unknown.low + at * (unknown.high - unknown.low);
  }
  [[nodiscard]] double place(std::size_t k, double value) const {
    const Unknown& unknown = unknowns_[free_[k]];
    return std::clamp((value - unknown.low) / (unknown.high - unknown.low), 0.0, 1.0);
  }
  [[nodiscard]] std::vector<double> values(std::span<const double> at) const {
    std::vector<double> values;
    for (const Unknown& unknown : unknowns_) values.push_back(unknown.low);
    for (std::size_t k = 0; k < free_.size(); ++k) values[free_[k]] = value(k, at[k]);
    return values;
  }

 private:
  const std::vector<Unknown>& unknowns_;
  std::vector<std::size_t> free_;
};

Residuals residuals_of(const std::vector<BedShape>& beds, const Box& box, const Model& model, Precision precision,
                       const FitOptions& options) {
  return [&beds, &box, &model, precision, bedding = options.bedding](std::span<const double> at,
                                                                     std::vector<double>& out) {
    const std::optional<Restore> restore = model(box.values(at), precision);
    if (!restore) return false;
    deviations(beds, *restore, bedding, out);
    return true;
  };
}

std::size_t count_points(const std::vector<BedShape>& beds) {
  std::size_t count = 0;
  for (const BedShape& bed : beds) count += bed.points.size();
  return count;
}

/// So many points of all beds together, but enough of each for its shape.
std::vector<BedShape> some_of(const std::vector<BedShape>& beds, std::size_t points) {
  return thinned(beds, std::max<std::size_t>(points / beds.size(), 20));
}

double root_mean(double sum, std::size_t points) { return std::sqrt(sum / static_cast<double>(points)); }

BedPoints points_of(const BedShape& bed, const std::vector<geom::Point>& restored, const BedLine& line) {
  BedPoints points{{0.0}, {}, bed.weights};
  const geom::Vector along{line.normal.y, -line.normal.x};
  for (std::size_t i = 1; i < restored.size(); ++i) points.steps.push_back(distance(bed.points[i - 1], bed.points[i]));
  for (const geom::Point p : restored) points.along.push_back(geom::dot(p - line.at, along));
  return points;
}

/// The misfits of each bed.
std::vector<BedPoints> judge_beds(const std::vector<BedShape>& beds, const Restore& restore, const FitOptions& options,
                                  Fit& fit) {
  std::vector<BedPoints> all;
  fit.beds.clear();
  for (const BedShape& bed : beds) {
    std::vector<double> as_they_lie, after;
    deviations(
        {bed}, [](geom::Point p) { return p; }, options.bedding, as_they_lie);
    deviations({bed}, restore, options.bedding, after);
    const std::size_t n = bed.points.size();
    BedMisfit row{bed.name, n, root_mean(sum_of_squares(as_they_lie), n), root_mean(sum_of_squares(after), n), {}};
    std::vector<geom::Point> points;
    for (const geom::Point p : bed.points) points.push_back(restore(p));
    const BedLine line = straight_line(bed, points, options.bedding);
    const double angle = std::atan2(-line.normal.x, line.normal.y) * 180.0 / std::numbers::pi;
    row.dip = base::Angle::from_degrees(angle > 90.0 ? angle - 180.0 : angle <= -90.0 ? angle + 180.0 : angle);
    fit.beds.push_back(std::move(row));
    all.push_back(points_of(bed, points, line));
  }
  return all;
}

/// How the errors of each bed hang together, and how many of the points count.
void judge_errors(const std::vector<BedPoints>& beds, const Residuals& residuals, const std::vector<double>& at,
                  const FitOptions& options, Fit& fit) {
  std::vector<double> values;
  residuals(at, values);
  Matrix slopes = slopes_of(residuals, at).value_or(Matrix(at.size(), std::vector<double>(values.size(), 0.0)));
  fit.errors = CorrelatedErrors(beds, values, std::move(slopes), options.bedding ? LineIs::Shifted : LineIs::Turned);
  fit.effective = 0.0;
  for (std::size_t b = 0; b < beds.size(); ++b) {
    fit.beds[b].correlation = static_cast<double>(fit.beds[b].points) / fit.errors.effective()[b];
    fit.beds[b].correlation_length = fit.errors.lengths()[b];
    fit.effective += fit.errors.effective()[b];
  }
}

/// What takes a sum into variances of a point.
struct Scale {
  double least = 0.0;     ///< The least sum, not below what coordinates are known to, m2.
  double expected = 0.0;  ///< What that sum is expected to be, in variances.
  [[nodiscard]] double variances(double sum) const { return sum / least * expected; }
  [[nodiscard]] double sum(double variances) const { return variances * least / expected; }
};

/// The valley about the best place: how far each value may go, and how the others go along with it.
Matrix covariance(const Residuals& residuals, const std::vector<double>& at, const Scale& scale) {
  const std::size_t n = at.size();
  Matrix normal = normal_matrix(slopes_of(residuals, at).value_or(Matrix(n, std::vector<double>{})));
  for (std::size_t i = 0; i < n; ++i) {
    for (double& entry : normal[i]) entry = scale.variances(entry);
    normal[i][i] += 1.0;  // no value is less well known than by the box
  }
  Matrix unit(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) unit[i][i] = 1.0;
  return inverse_of(normal).value_or(std::move(unit));
}

/// Where the valley leads from `from` if some coordinates go to other places.
std::vector<double> along_valley(const std::vector<double>& from, const Matrix& valley,
                                 const std::vector<std::pair<std::size_t, double>>& held) {
  Matrix part(held.size(), std::vector<double>(held.size()));
  for (std::size_t i = 0; i < held.size(); ++i) {
    for (std::size_t j = 0; j < held.size(); ++j) part[i][j] = valley[held[i].first][held[j].first];
  }
  std::vector<double> start = from;
  if (const std::optional<Matrix> inverse = inverse_of(part)) {
    for (std::size_t i = 0; i < held.size(); ++i) {
      double pull = 0.0;
      for (std::size_t j = 0; j < held.size(); ++j) pull += (*inverse)[i][j] * (held[j].second - from[held[j].first]);
      for (std::size_t k = 0; k < start.size(); ++k) start[k] += valley[k][held[i].first] * pull;
    }
  }
  for (double& value : start) value = std::clamp(value, 0.0, 1.0);
  for (const auto& [k, value] : held) start[k] = value;
  return start;
}

/// The least sum with some coordinates held.
base::Result<Minimum> profile_at(const Residuals& residuals, const std::vector<double>& from, const Matrix& valley,
                                 const std::vector<std::pair<std::size_t, double>>& held,
                                 const base::Progress& progress) {
  DescentOptions descent{15, 1e-3, quick_difference, std::vector<bool>(from.size(), false)};
  for (const auto& place : held) descent.held[place.first] = true;
  return descend(residuals, along_valley(from, valley, held), descent, progress);
}

struct Side {
  std::optional<double> limit;  ///< In the box.
  Minimum better;               ///< What was found below the best by the way, if anything.
  std::optional<base::Error> stopped;
};

/// The profile of one value on one side of the best.
class Profile {
 public:
  /// @param allowance  how far the sum may lie above the best, in variances.
  Profile(const Residuals& residuals, const Minimum& best, const Matrix& valley, const Scale& scale, std::size_t k,
          double sign, double allowance, const base::Progress& progress)
      : residuals_(residuals),
        best_(best),
        valley_(valley),
        scale_(scale),
        k_(k),
        sign_(sign),
        allowance_(allowance),
        progress_(progress),
        room_(sign > 0.0 ? 1.0 - best.at[k] : best.at[k]),
        last_(best),
        inner_(best) {}

  /// Outward by doubled steps, each from the place before, to the outermost step that is within the allowance, though
  /// there be walls on the way to it; then between that and the next.
  Side run() {
    if (room_ <= 0.0) return side_;
    double step = std::clamp(0.5 * std::sqrt(allowance_ * valley_[k_][k_]), room_ / 64.0, room_);
    double inside = 0.0;
    double outside = 0.0;  ///< The first step beyond `inside` that is not within; 0: none.
    for (double ratio = 0.0; !side_.stopped; step = std::min(room_, 2.0 * step)) {
      ratio = ratio_at(step);
      if (ratio <= 1.0) {
        inside = step;
        inner_ = last_;
        outside = 0.0;
      } else if (outside == 0.0) {
        outside = step;
      }
      if (step >= room_ || ratio > 20.0) break;
    }
    for (int turn = 0; turn < 5 && outside > 0.0 && !side_.stopped; ++turn) {
      const double middle = 0.5 * (inside + outside);
      last_ = inner_;
      if (ratio_at(middle) <= 1.0) {
        inside = middle;
        inner_ = last_;
      } else {
        outside = middle;
      }
    }
    if (outside > 0.0) side_.limit = best_.at[k_] + sign_ * 0.5 * (inside + outside);
    return side_;
  }

 private:
  /// What the sum has risen at a step, over the allowance.
  double ratio_at(double step) {
    const double place = step >= room_ ? (sign_ > 0.0 ? 1.0 : 0.0) : best_.at[k_] + sign_ * step;
    auto there = profile_at(residuals_, last_.at, valley_, {{k_, place}}, progress_);
    if (!there) {
      side_.stopped = there.error();
      return 0.0;
    }
    last_ = *there;
    if (there->sum < best_.sum && there->sum < side_.better.sum) side_.better = *there;
    return scale_.variances(there->sum - best_.sum) / allowance_;
  }

  const Residuals& residuals_;
  const Minimum& best_;
  const Matrix& valley_;
  const Scale scale_;
  std::size_t k_;
  double sign_, allowance_;
  const base::Progress& progress_;
  double room_;
  Minimum last_, inner_;
  Side side_;
};

/// Global on some points of each bed, then local from the best of what is left.
base::Result<Minimum> search(const std::vector<BedShape>& beds, const Box& box, const Model& model,
                             const FitOptions& options, const base::Progress& progress) {
  const std::vector<BedShape> some = some_of(beds, search_points);
  const Residuals quick = residuals_of(some, box, model, Precision::Search, options);
  const SearchOptions wide{options.seed, std::max<std::size_t>(8 * box.dimension(), 24), options.generations};
  DOBRA_TRY(const std::vector<Minimum> members, evolve(quick, box.dimension(), wide, progress));
  Minimum best = members.front();
  for (std::size_t i = 0; i < std::min<std::size_t>(3, members.size()) && std::isfinite(members[i].sum); ++i) {
    DOBRA_TRY(Minimum local, descend(quick, members[i].at, {30, 1e-3, quick_difference, {}}, progress));
    if (local.sum < best.sum || i == 0) best = std::move(local);
  }
  return best;
}

Scale scale_of(const Fit& fit, const FitOptions& options) {
  const double floor = known_figures * options.size;
  return {std::max(fit.sum, static_cast<double>(fit.points) * floor * floor), fit.errors.expected()};
}

/// What was found on both sides of every free value.
struct Limits {
  std::vector<std::array<Side, 2>> sides;
  Minimum better;
};

base::Result<Limits> limits_of(const Residuals& residuals, const Minimum& best, const Matrix& valley,
                               const Scale& scale, const CorrelatedErrors& errors, double confidence,
                               const base::Progress& progress) {
  const std::size_t n = best.at.size();
  const auto found = base::parallel_map<Side>(2 * n, [&](std::size_t i) {
    const double allowance = errors.allowance(std::array{i / 2}, confidence);
    return Profile(residuals, best, valley, scale, i / 2, i % 2 == 0 ? -1.0 : 1.0, allowance, progress).run();
  });
  Limits limits;
  for (std::size_t k = 0; k < n; ++k) {
    limits.sides.push_back({found[2 * k], found[2 * k + 1]});
    for (const Side& side : limits.sides.back()) {
      if (side.stopped) return *side.stopped;
      if (side.better.sum < limits.better.sum) limits.better = side.better;
    }
  }
  return limits;
}

/// The sums, rms and errors of the values at a place.
void judge(const std::vector<BedShape>& beds, const Box& box, const Model& model, const Residuals& residuals,
           const Minimum& best, const FitOptions& options, Fit& fit) {
  const std::vector<double> values = box.values(best.at);
  fit.points = count_points(beds);
  fit.sum = best.sum;
  fit.rms = root_mean(best.sum, fit.points);
  judge_errors(judge_beds(beds, *model(values, Precision::Full), options, fit), residuals, best.at, options, fit);
  for (std::size_t i = 0; i < values.size(); ++i) fit.estimates[i].best = values[i];
  for (std::size_t k = 0; k < box.dimension(); ++k) {
    Estimate& estimate = fit.estimates[box.free()[k]];
    estimate.at_limit = best.at[k] <= 1e-9 ? AtLimit::Low : best.at[k] >= 1.0 - 1e-9 ? AtLimit::High : AtLimit::No;
  }
}

void tell_limits(Fit& fit, double confidence) {
  for (const Estimate& e : fit.estimates) {
    const Unknown& u = e.unknown;
    if (u.fixed()) continue;
    if (e.at_limit != AtLimit::No)
      fit.remarks.push_back(
          fmt::format("the best {} lies at a limit of the search, {:.6g} {}; widen its limits", u.key, e.best, u.unit));
    if (e.low && e.high) continue;
    if (!e.low && !e.high) {
      fit.remarks.push_back(
          fmt::format("the beds do not determine {}: with {:.4g} % confidence it may be anything from "
                      "{:.6g} to {:.6g} {}; fix it, or give a bed that it shapes",
                      u.key, confidence, u.low, u.high, u.unit));
    } else {
      fit.remarks.push_back(
          fmt::format("the beds bound {} on one side only: it may go {} to the limit of the search, "
                      "{:.6g} {}",
                      u.key, e.low ? "up" : "down", e.low ? u.high : u.low, u.unit));
    }
  }
}

/// Values that the data hold together more firmly than each.
void tell_trade_offs(const Matrix& valley, const Box& box, Fit& fit) {
  for (std::size_t i = 0; i < box.dimension(); ++i) {
    for (std::size_t j = i + 1; j < box.dimension(); ++j) {
      const double correlation = valley[i][j] / std::sqrt(valley[i][i] * valley[j][j]);
      if (std::abs(correlation) < 0.95) continue;
      fit.remarks.push_back(fmt::format("{} and {} trade off: their correlation is {:.3f}",
                                        fit.estimates[box.free()[i]].unknown.key,
                                        fit.estimates[box.free()[j]].unknown.key, correlation));
    }
  }
}

/// Whether there is a fold at all.
void tell_doubts(Fit& fit) {
  if (fit.before > *fit.region) return;
  fit.remarks.push_back(
      fmt::format("the beds as they lie fit straight lines as well (rms {:.4g} m, restored {:.4g} "
                  "m): they are not told from beds that were never folded",
                  fit.before, fit.rms));
}

base::Result<void> check_beds(const std::vector<BedShape>& beds, const Box& box, const FitOptions& options, Fit& fit) {
  const std::size_t points = count_points(beds);
  std::vector<double> present;
  deviations(
      beds, [](geom::Point p) { return p; }, options.bedding, present);
  fit.before = root_mean(sum_of_squares(present), points);
  if (fit.before <= known_figures * options.size) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("the beds are straight as they are, to {:.3g} m, so that they tell of no fold; give "
                                   "beds that are folded",
                                   fit.before)};
  }
  const double needed =
      static_cast<double>(box.dimension()) + static_cast<double>(beds.size()) * (options.bedding ? 1.0 : 2.0);
  if (static_cast<double>(points) <= needed) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("the beds have {} points, which do not determine {} values and the lines of {} "
                                   "beds; digitise them more closely, or fix values",
                                   points, box.dimension(), beds.size())};
  }
  return {};
}

/// The limits of confidence, which were found about another place than the best, and the region of all free values.
void set_limits(const Box& box, const Limits& limits, const Minimum& about, const Minimum& best, const Scale& scale,
                double confidence, Fit& fit) {
  for (std::size_t k = 0; k < box.dimension(); ++k) {
    Estimate& estimate = fit.estimates[box.free()[k]];
    const auto shifted = [&](double limit) {
      return box.value(k, std::clamp(best.at[k] + limit - about.at[k], 0.0, 1.0));
    };
    if (limits.sides[k][0].limit) estimate.low = shifted(*limits.sides[k][0].limit);
    if (limits.sides[k][1].limit) estimate.high = shifted(*limits.sides[k][1].limit);
  }
  fit.region = root_mean(fit.sum + scale.sum(fit.errors.joint_allowance(confidence)), fit.points);
}

/// Local on all points; the limits, on some of the points and about the least sum of these, are shifted to it.
base::Result<void> fit_from(const std::vector<BedShape>& beds, const Box& box, const Model& model,
                            const FitOptions& options, std::vector<double> start, const base::Progress& progress,
                            Fit& fit) {
  const Residuals all = residuals_of(beds, box, model, Precision::Full, options);
  const std::vector<BedShape> some = some_of(beds, limit_points);
  const Residuals residuals = residuals_of(some, box, model, Precision::Search, options);
  DOBRA_TRY(Minimum best, descend(all, std::move(start), {.most_steps = 100}, progress));
  for (int round = 0; round < 3; ++round) {
    judge(beds, box, model, all, best, options, fit);
    if (box.dimension() == 0) return {};
    const Scale scale = scale_of(fit, options);
    progress.report(0.6 + 0.1 * round, "limits");
    DOBRA_TRY(const Minimum about,
              descend(residuals, best.at, {.enough = 1e-5, .difference = quick_difference}, progress));
    const Matrix valley = covariance(residuals, about.at, scale);
    DOBRA_TRY(const Limits limits,
              limits_of(residuals, about, valley, scale, fit.errors, options.confidence, progress));
    if (scale.variances(limits.better.sum - about.sum) < -0.01 && round < 2) {
      DOBRA_TRY(Minimum next, descend(all, limits.better.at, {.most_steps = 100}, progress));
      if (next.sum < best.sum) {
        best = std::move(next);
        continue;
      }
    }
    set_limits(box, limits, about, best, scale, options.confidence, fit);
    tell_trade_offs(valley, box, fit);
    break;
  }
  tell_doubts(fit);
  tell_limits(fit, options.confidence);
  return {};
}

}  // namespace

std::vector<double> Fit::values() const {
  std::vector<double> values;
  for (const Estimate& estimate : estimates) values.push_back(estimate.best);
  return values;
}

std::optional<double> misfit_of(const std::vector<BedShape>& beds, const Model& model, std::span<const double> values,
                                std::optional<base::Angle> bedding) {
  const std::optional<Restore> restore = model(values, Precision::Full);
  if (!restore) return std::nullopt;
  std::vector<double> distances;
  deviations(beds, *restore, bedding, distances);
  return root_mean(sum_of_squares(distances), count_points(beds));
}

base::Result<Fit> fit_beds(const std::vector<BedShape>& beds, const std::vector<std::vector<Unknown>>& alternatives,
                           const Model& model, const FitOptions& options, const base::Progress& progress) {
  Fit fit;
  DOBRA_TRY_VOID(check_beds(beds, Box(alternatives.front()), options, fit));
  Minimum best;
  const std::vector<Unknown>* chosen = &alternatives.front();
  const double parts = static_cast<double>(alternatives.size());
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const base::Progress part =
        progress.part(0.6 * static_cast<double>(i) / parts, 0.6 * static_cast<double>(i + 1) / parts);
    DOBRA_TRY(Minimum found, search(beds, Box(alternatives[i]), model, options, part));
    if (!(found.sum < best.sum)) continue;
    best = std::move(found);
    chosen = &alternatives[i];
  }
  if (!std::isfinite(best.sum)) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "no values between the limits make a map that takes the beds back; change the limits"};
  }
  for (const Unknown& unknown : *chosen) fit.estimates.push_back({unknown, unknown.low, AtLimit::No, {}, {}});
  DOBRA_TRY_VOID(fit_from(beds, Box(*chosen), model, options, std::move(best.at), progress, fit));
  return fit;
}

base::Result<MisfitMap> map_misfit(const std::vector<BedShape>& beds, const std::vector<Unknown>& unknowns,
                                   const Model& model, const Fit& fit, std::array<std::size_t, 2> axes,
                                   std::size_t count, const FitOptions& options, const base::Progress& progress) {
  const Box box(unknowns);
  const std::vector<BedShape> some = some_of(beds, search_points);
  const Residuals residuals = residuals_of(some, box, model, Precision::Search, options);
  std::vector<double> best;
  for (std::size_t k = 0; k < box.dimension(); ++k) best.push_back(box.place(k, fit.estimates[box.free()[k]].best));
  const Scale scale = scale_of(fit, options);
  const Matrix valley = covariance(residuals, best, scale);
  MisfitMap map{axes, {}, {}, {}};
  std::array<std::size_t, 2> k{};
  for (std::size_t a = 0; a < 2; ++a) {
    k[a] = static_cast<std::size_t>(std::find(box.free().begin(), box.free().end(), axes[a]) - box.free().begin());
    for (std::size_t i = 0; i < count; ++i)
      map.at[a].push_back(box.value(k[a], static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  const auto sums =
      base::parallel_map<std::optional<double>>(count * count, [&](std::size_t i) -> std::optional<double> {
        const double step = 1.0 / static_cast<double>(count - 1);
        const auto least = profile_at(
            residuals, best, valley,
            {{k[0], step * static_cast<double>(i % count)}, {k[1], step * static_cast<double>(i / count)}}, progress);
        return least ? std::optional(least->sum) : std::nullopt;
      });
  DOBRA_TRY_VOID(progress.check());
  for (const std::optional<double>& sum : sums) map.rms.push_back(root_mean(*sum, fit.points));
  map.region = root_mean(fit.sum + scale.sum(fit.errors.allowance(k, options.confidence)), fit.points);
  return map;
}

}  // namespace recon::inversion
