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
    return cannot(fmt::format("the {} turns back along the direction of shear here, at ({:.6g}, {:.6g}); take another "
                              "angle",
                              what, at.x, at.y),
                  at, what);
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

}  // namespace

base::Result<PredictedFault> fault_under(const Rollover& rollover) {
  const geom::Point foot = rollover.known.points.front();
  const geom::Point hanging = rollover.known.points.back();
  const double across =
      ShearAxes(rollover.shear, false).turned(hanging).x - ShearAxes(rollover.shear, false).turned(foot).x;
  const ShearAxes axes(rollover.shear, across < 0.0);
  const double shift = std::abs(across);
  if (!(shift > 1e-9 * geom::distance(foot, hanging))) {
    return cannot(
        "both cutoffs of the bed lie on one line of shear, so that it tells no extension; take another angle, or "
        "a bed that is cut",
        foot, "fault");
  }
  const std::vector<geom::Point> known = axes.turned(rollover.known);
  const std::vector<geom::Point> bed = axes.turned(rollover.bed);
  DOBRA_TRY_VOID(check_ascends(known, axes, "fault"));
  DOBRA_TRY_VOID(check_ascends(bed, axes, "bed"));
  PredictedFault found;
  found.steps = static_cast<std::size_t>((bed.back().x - known.back().x) / shift);
  if (found.steps < 1 || found.steps > most_steps) {
    return cannot(fmt::format("the rollover goes {} times the shift of {:.6g} m across the shear, where 1 to {} tell a "
                              "fault; give a {} of the bed",
                              found.steps, shift, most_steps, found.steps < 1 ? "longer part" : "shorter part"),
                  rollover.bed.points.back(), "bed");
  }
  // The regional in these axes.
  const geom::Point at = known.front();
  const geom::Vector along{std::cos(rollover.bedding.radians()), std::sin(rollover.bedding.radians())};
  const geom::Vector turned = axes.turned(foot + along) - at;
  const double slope = turned.y / turned.x;
  const auto regional = [&](double q) { return at.y + slope * (q - at.x); };
  // Corner by corner, on what has been found.
  std::vector<geom::Point> fault = known;
  for (const double q : corners_of(known, bed, shift)) {
    if (q <= known.back().x + 1e-9 * shift) continue;
    fault.push_back({q, height_on(fault, q - shift) + height_on(bed, q) - regional(q - shift)});
  }
  for (const geom::Point p : fault) found.line.points.push_back(axes.back(p));
  const double last = bed.back().x;
  found.regional.points = {foot, axes.back({last, regional(last)})};
  found.shift = shift / std::abs(turned.x);
  const geom::Point before = axes.back({last - shift, height_on(fault, last - shift)});
  const geom::Point end = found.line.points.back();
  const geom::Vector chord = end - before;
  found.end_dip =
      base::Angle::from_radians(std::abs(std::atan2(geom::cross(along, chord), std::abs(geom::dot(along, chord)))));
  found.end = geom::midpoint(before, end);
  geom::Polyline lost{rollover.known.points, true};
  lost.points.insert(lost.points.end(), rollover.bed.points.begin(), rollover.bed.points.end());
  lost.points.push_back(found.regional.points.back());
  found.lost_area = std::abs(geom::signed_area(lost));
  found.area_depth = found.lost_area / found.shift;
  const geom::Vector down{along.y, -along.x};
  found.area_place = found.regional.points.back() + found.area_depth * down;
  return found;
}

}  // namespace recon::inversion
