#include "recon/balance/fold_class.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon::balance {

namespace {

/// Support of a line in the direction that leans `angle` clockwise from the vertical, and where it is taken.
struct Support {
  double value = -std::numeric_limits<double>::infinity();
  std::size_t point = 0;
};

Support support(const geom::Polyline& line, double angle, double sign) {
  const geom::Vector normal{sign * std::sin(angle), sign * std::cos(angle)};
  Support best;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    const double value = normal.x * line.points[i].x + normal.y * line.points[i].y;
    if (value > best.value) best = {value, i};
  }
  return best;
}

/// A tangent at an end of the line is none: the line goes on.
bool touches_inside(const geom::Polyline& line, double angle, double sign) {
  const std::size_t margin = 1 + line.points.size() / 50;
  const std::size_t at = support(line, angle, sign).point;
  return at >= margin && at + margin < line.points.size();
}

/// +1 for an antiform, -1 for a synform: the side of its chord on which the line lies.
double bulge(const geom::Polyline& line) {
  geom::Polyline closed = line;
  closed.closed = true;
  return geom::signed_area(closed) <= 0.0 ? 1.0 : -1.0;
}

RamsayClass class_of(double index, double tolerance) {
  if (index < -tolerance) return RamsayClass::Class1A;
  if (index <= tolerance) return RamsayClass::Class1B;
  if (index < 1.0 - tolerance) return RamsayClass::Class1C;
  return index <= 1.0 + tolerance ? RamsayClass::Class2 : RamsayClass::Class3;
}

}  // namespace

const char* class_name(RamsayClass value) {
  switch (value) {
    case RamsayClass::Class1A:
      return "1A";
    case RamsayClass::Class1B:
      return "1B";
    case RamsayClass::Class1C:
      return "1C";
    case RamsayClass::Class2:
      return "2";
    case RamsayClass::Class3:
      break;
  }
  return "3";
}

std::optional<FoldClass> fold_class(const geom::Polyline& upper, const geom::Polyline& lower,
                                    const FoldClassOptions& options) {
  const double sign = bulge(upper);
  // The dips that both surfaces have: one run of angles in half-degree steps, about the one in its middle.
  constexpr double step = 0.5;
  double low = 0.0, high = 0.0, best_low = 0.0, best_high = -1.0;
  bool inside = false;
  for (double angle = -89.5; angle <= 90.0; angle += step) {
    const double radians = base::Angle::from_degrees(angle).radians();
    const bool common = angle < 90.0 && touches_inside(upper, radians, sign) && touches_inside(lower, radians, sign);
    if (common && !inside) low = angle;
    if (common) high = angle;
    if (!common && inside && high - low > best_high - best_low) {
      best_low = low;
      best_high = high;
    }
    inside = common;
  }
  FoldClass result;
  const double hinge = 0.5 * (best_low + best_high);
  result.dips = base::Angle::from_degrees(0.5 * (best_high - best_low));
  if (result.dips < options.least_range) return std::nullopt;
  result.axial_normal = base::Angle::from_degrees(hinge);
  const double middle = result.axial_normal.radians();
  const auto thickness = [&](double from_hinge) {
    const double angle = middle + from_hinge;
    return sign * (support(upper, angle, sign).value - support(lower, angle, sign).value);
  };
  result.hinge_thickness = thickness(0.0);
  // Least squares of log t' = p log cos a through the origin.
  double numerator = 0.0, denominator = 0.0;
  for (int i = 0; i < options.angles; ++i) {
    const double a = result.dips.radians() * (2.0 * i / (options.angles - 1) - 1.0);
    const double part = thickness(a) / result.hinge_thickness;
    const double log_cosine = std::log(std::cos(a));
    if (!(part > 0.0)) return std::nullopt;
    numerator += std::log(part) * log_cosine;
    denominator += log_cosine * log_cosine;
  }
  result.index = numerator / denominator;
  result.value = class_of(result.index, options.tolerance);
  return result;
}

}  // namespace recon::balance
