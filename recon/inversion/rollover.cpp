#include "recon/inversion/rollover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/place.h"

namespace recon::inversion {

namespace {

constexpr std::size_t most_steps = 200;

/// Across and along the direction of shear, q growing away from the footwall.
class ShearAxes {
 public:
  ShearAxes(base::Angle shear, bool mirrored)
      : cosine_(std::cos(shear.radians())), sine_(std::sin(shear.radians())), sign_(mirrored ? -1.0 : 1.0) {}
  [[nodiscard]] geom::Point turned(geom::Point p) const {
    return {sign_ * (p.x * cosine_ - p.y * sine_), p.x * sine_ + p.y * cosine_};
  }
  [[nodiscard]] geom::Point back(geom::Point p) const {
    const double q = sign_ * p.x;
    return {q * cosine_ + p.y * sine_, p.y * cosine_ - q * sine_};
  }
  [[nodiscard]] std::vector<geom::Point> turned(const geom::Polyline& line) const {
    std::vector<geom::Point> points;
    for (const geom::Point p : line.points) points.push_back(turned(p));
    return points;
  }

 private:
  double cosine_, sine_, sign_;
};

base::Error cannot(std::string message, geom::Point at, const char* item) {
  return {base::ErrorCode::CannotRestore, std::move(message), place_at(at, item)};
}

/// w of a line that ascends in q; its ends go on level.
double height_on(const std::vector<geom::Point>& line, double q) {
  const auto after = std::upper_bound(line.begin(), line.end(), q, [](double v, geom::Point p) { return v < p.x; });
  if (after == line.begin()) return line.front().y;
  if (after == line.end()) return line.back().y;
  const geom::Point a = *(after - 1);
  return a.y + (q - a.x) / (after->x - a.x) * (after->y - a.y);
}

base::Result<void> check_ascends(const std::vector<geom::Point>& line, const ShearAxes& axes, const char* what) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i].x > line[i - 1].x) continue;
    const geom::Point at = axes.back(line[i]);
    return cannot(
        fmt::format("the {} turns back along the direction of shear here, at {}; take another angle", what, at), at,
        what);
  }
  return {};
}

/// All q at which the predicted fault may have a corner, ascending.
std::vector<double> corners_of(const std::vector<geom::Point>& known, const std::vector<geom::Point>& bed,
                               double shift) {
  std::vector<double> corners;
  const double last = bed.back().x;
  for (const std::vector<geom::Point>* line : {&known, &bed}) {
    for (const geom::Point p : *line) {
      for (double q = p.x; q <= last; q += shift) corners.push_back(q);
    }
  }
  corners.push_back(last);
  std::sort(corners.begin(), corners.end());
  const auto near = [&](double a, double b) { return b - a <= 1e-9 * shift; };
  corners.erase(std::unique(corners.begin(), corners.end(), near), corners.end());
  return corners;
}

geom::Vector direction_of(base::Angle angle) { return {std::cos(angle.radians()), std::sin(angle.radians())}; }

/// A rollover across and along the direction of shear.
struct TurnedRollover {
  std::vector<geom::Point> known, bed;
  double shift = 0.0;    ///< H
  geom::Vector bedding;  ///< Of the regional, unit.
  [[nodiscard]] double regional(double q) const {
    return known.front().y + bedding.y / bedding.x * (q - known.front().x);
  }
};

base::Result<TurnedRollover> turned(const Rollover& rollover, const ShearAxes& axes) {
  const geom::Point foot = rollover.known.points.front();
  TurnedRollover made{axes.turned(rollover.known), axes.turned(rollover.bed), 0.0, {}};
  made.shift = made.known.back().x - made.known.front().x;
  made.bedding = axes.turned(foot + direction_of(rollover.bedding)) - made.known.front();
  if (std::abs(made.bedding.x) < 1e-9) {
    return cannot("the regional lies along the direction of shear; take another angle, or another bedding", foot,
                  "fault");
  }
  if (!(made.shift > 1e-9 * geom::distance(foot, rollover.known.points.back()))) {
    return cannot(
        "both cutoffs of the bed lie on one line of shear, so that it tells no extension; take another angle, or "
        "a bed that is cut",
        foot, "fault");
  }
  DOBRA_TRY_VOID(check_ascends(made.known, axes, "fault"));
  DOBRA_TRY_VOID(check_ascends(made.bed, axes, "bed"));
  return made;
}

/// The fault, corner by corner on what has been found.
std::vector<geom::Point> chain_of(const TurnedRollover& rollover) {
  std::vector<geom::Point> fault = rollover.known;
  const double shift = rollover.shift;
  for (const double q : corners_of(rollover.known, rollover.bed, shift)) {
    if (q <= rollover.known.back().x + 1e-9 * shift) continue;
    fault.push_back({q, height_on(fault, q - shift) + height_on(rollover.bed, q) - rollover.regional(q - shift)});
  }
  return fault;
}

/// The area between regional, fault and bed, and the depth of a flat that it makes.
void measure_area(const Rollover& rollover, PredictedFault& found) {
  geom::Polyline lost{rollover.known.points, true};
  lost.points.insert(lost.points.end(), rollover.bed.points.begin(), rollover.bed.points.end());
  lost.points.push_back(found.regional.points.back());
  found.lost_area = std::abs(geom::signed_area(lost));
  found.area_depth = found.lost_area / found.shift;
  found.area_place = found.regional.points.back() + found.area_depth * geom::right_of(direction_of(rollover.bedding));
}

}  // namespace

base::Result<PredictedFault> fault_under(const Rollover& rollover) {
  const ShearAxes plain(rollover.shear, false);
  const bool to_minus = plain.turned(rollover.known.points.back()).x < plain.turned(rollover.known.points.front()).x;
  const ShearAxes axes(rollover.shear, to_minus);
  DOBRA_TRY(const TurnedRollover made, turned(rollover, axes));
  PredictedFault found;
  const double last = made.bed.back().x;
  found.steps = static_cast<std::size_t>((last - made.known.back().x) / made.shift);
  if (found.steps < 1 || found.steps > most_steps) {
    return cannot(fmt::format("the rollover goes {} times the shift of {:.6g} m across the shear, where 1 to {} tell a "
                              "fault; give a {} of the bed",
                              found.steps, made.shift, most_steps, found.steps < 1 ? "longer part" : "shorter part"),
                  rollover.bed.points.back(), "bed");
  }
  const std::vector<geom::Point> fault = chain_of(made);
  for (const geom::Point p : fault) found.line.points.push_back(axes.back(p));
  found.regional.points = {rollover.known.points.front(), axes.back({last, made.regional(last)})};
  found.shift = made.shift / std::abs(made.bedding.x);
  const geom::Point before = axes.back({last - made.shift, height_on(fault, last - made.shift)});
  const geom::Vector along = direction_of(rollover.bedding);
  const geom::Vector chord = found.line.points.back() - before;
  found.end_dip =
      base::Angle::from_radians(std::abs(std::atan2(geom::cross(along, chord), std::abs(geom::dot(along, chord)))));
  found.end = geom::midpoint(before, found.line.points.back());
  measure_area(rollover, found);
  return found;
}

}  // namespace recon::inversion
