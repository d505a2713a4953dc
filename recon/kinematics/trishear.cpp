#include "recon/kinematics/trishear.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "recon/kinematics/refuse.h"

namespace recon::kinematics {

namespace {

/// z, x / x0 and slip / x0 in the zone, with e = |y| / (m x) = |z|^k of one sign.
using State = std::array<double, 3>;

/// The field in the frame of the tip. It depends on e alone, so that distance from the tip is but a scale. With
/// k = max(s, 1) and the variable sigma, d(slip) = x k |z|^(k-1) d(sigma), all is smooth on either side of z = 0.
struct Zone {
  double sense;        ///< v0
  double propagation;  ///< P/S
  double s;            ///< Concentration.
  double time;         ///< +1: slip grows, -1: it goes back.
  double half_over = 0.5 / (1.0 + s);
  double side = 1.0;                         ///< Sign of z.
  std::size_t rows = 5;                      ///< Of the extrapolation.
  std::optional<std::size_t> variable = {};  ///< Of the state, instead of sigma: steps end where it has a given value.

  [[nodiscard]] double power() const { return std::max(s, 1.0); }
  static double raised(double z, double to) { return to == 1.0 ? z : std::pow(z, to); }

  [[nodiscard]] State rate(const State& at) const {
    const double k = power();
    const double z = std::max(side * at[0], 0.0);
    const double root = raised(z, k / s);  // e^(1/s)
    const double e = raised(z, k);
    const double along = sense * 0.5 * (side * root + 1.0) - propagation;
    const double across = sense * (e * root - 1.0) * half_over;
    const double pace = k == 1.0 ? 1.0 : k * raised(z, k - 1.0);
    const State rate{time * (across - side * e * along), time * pace * along * at[1], pace * at[1]};
    if (!variable) return rate;
    const double by = rate[*variable];
    return {rate[0] / by, rate[1] / by, rate[2] / by};
  }

  /// Gragg's modified midpoint rule, extrapolated to order 2 x rows (Bulirsch and Stoer).
  [[nodiscard]] State step(const State& from, double h, double& error) const {
    constexpr std::array<int, 5> parts{2, 4, 6, 8, 10};
    std::array<State, 5> table{};
    const State first = rate(from);
    State coarse{};
    for (std::size_t row = 0; row < rows; ++row) {
      State value = midpoint(from, first, h, parts[row]);
      for (std::size_t column = 0; column < row; ++column) {
        const double ratio = static_cast<double>(parts[row]) / parts[row - column - 1];
        const double weight = 1.0 / (ratio * ratio - 1.0);
        for (std::size_t i = 0; i < 3; ++i) {
          const double finer = value[i] + weight * (value[i] - table[column][i]);
          table[column][i] = value[i];
          value[i] = finer;
        }
      }
      coarse = row > 0 ? table[row - 1] : value;
      table[row] = value;
    }
    error = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = i == 0 ? 1.0 : i == 1 ? std::abs(table[rows - 1][1]) : 1.0 + std::abs(table[rows - 1][2]);
      error = std::max(error, std::abs(table[rows - 1][i] - coarse[i]) / size);
    }
    return table[rows - 1];
  }

 private:
  [[nodiscard]] State midpoint(const State& from, const State& first, double h, int parts) const {
    const double part = h / parts;
    State before = from;
    State at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = from[i] + part * first[i];
    for (int k = 1; k < parts; ++k) {
      const State slope = rate(at);
      for (std::size_t i = 0; i < 3; ++i) {
        const double next = before[i] + 2.0 * part * slope[i];
        before[i] = at[i];
        at[i] = next;
      }
    }
    const State slope = rate(at);
    for (std::size_t i = 0; i < 3; ++i) at[i] = 0.5 * (at[i] + before[i] + part * slope[i]);
    return at;
  }
};

/// The step h' <= h after which `beyond` of the state is 0, where it is < 0 before and >= 0 behind h.
template <class Beyond>
State step_to(const Zone& zone, const State& from, double h, const Beyond& beyond) {
  double low = 0.0;
  double high = h;
  double at_low = beyond(from);
  double unused = 0.0;
  State state = zone.step(from, h, unused);
  double at_high = beyond(state);
  for (int i = 0, stuck = 0; i < 60 && high - low > 1e-15 * h && at_high != 0.0; ++i) {
    // Illinois: the false position, with half the weight of an end that stays.
    const double middle = i < 50 ? (low * at_high - high * at_low) / (at_high - at_low) : 0.5 * (low + high);
    const State there = zone.step(from, middle, unused);
    const double value = beyond(there);
    if (value >= 0.0) {
      high = middle;
      at_high = value;
      state = there;
      if (stuck == 1) at_low *= 0.5;
      stuck = 1;
    } else {
      low = middle;
      at_low = value;
      if (stuck == -1) at_high *= 0.5;
      stuck = -1;
    }
    if (std::abs(value) <= 1e-16) return there;
  }
  return state;
}

/// The same with a value of the state as the variable, in one step (Henon). Nothing where that is not true enough.
std::optional<State> step_onto(Zone zone, const State& from, std::size_t variable, double value, double tolerance) {
  zone.variable = variable;
  double error = 0.0;
  State state = zone.step(from, value - from[variable], error);
  if (!(error <= tolerance)) return std::nullopt;
  state[variable] = value;
  return state;
}

/// Goes on through the zone for `left` of slip, or to its side.
/// @param x, e  place: x > 0 from the tip, e = y / (m x) in [-1, 1]; both become those of the end.
void through_zone(Zone zone, double tolerance, double& x, double& e, double& left) {
  const double k = zone.power();
  zone.side = e < 0.0 ? -1.0 : 1.0;
  if (e == 0.0) zone.side = -zone.sense * zone.time;  // at e = 0 it goes towards this side
  State at{zone.side * std::pow(std::abs(e), 1.0 / k), 1.0, 0.0};
  const double goal = left / x;
  const auto grown = [&](double by) {
    return 0.9 * std::pow(tolerance / by, 1.0 / (2.0 * static_cast<double>(zone.rows) - 1.0));
  };
  constexpr double at_tip = 1e-15;  // of the distance from the tip at first
  double h = 0.1;
  double error = 0.0;
  bool ended = true;
  for (int steps = 0; steps < 100000; ++steps) {
    const State next = zone.step(at, h, error);
    if (!(error <= tolerance) && h > 1e-14) {  // nor where a trial has left what numbers can hold
      h *= std::clamp(grown(error), 0.1, 0.9);
      continue;
    }
    const bool past_end = next[2] >= goal;
    const bool past_middle = zone.side * next[0] < 0.0;
    const bool past_side = std::abs(next[0]) > 1.0;
    if (!past_end && !past_middle && !past_side) {
      at = next;
      if (at[1] < at_tip) {  // the tip passes it: it goes on in the wall of its side
        at[0] = zone.side;
        ended = false;
        break;
      }
      h *= std::clamp(grown(std::max(error, 1e-30)), 0.5, 3.0);
      continue;
    }
    // The first of what the step passes.
    const auto after_end = [&](const State& state) { return (state[2] - goal) / (1.0 + goal); };
    const auto over_middle = [&](const State& state) { return past_middle ? -zone.side * state[0] : -1.0; };
    const auto over_side = [&](const State& state) { return past_side ? std::abs(state[0]) - 1.0 : -1.0; };
    const bool one = int{past_end} + int{past_middle} + int{past_side} == 1;
    const double value = past_end ? goal : past_middle ? 0.0 : zone.side;
    const auto onto = one ? step_onto(zone, at, past_end ? 2 : 0, value, tolerance) : std::nullopt;
    at = onto ? *onto : step_to(zone, at, h, [&](const State& state) {
      return std::max({after_end(state), over_middle(state), over_side(state)});
    });
    ended = after_end(at) >= std::max(over_middle(at), over_side(at));
    if (ended || over_side(at) >= over_middle(at)) break;
    zone.side = -zone.side;
    at[0] = 0.0;
  }
  left = ended ? 0.0 : std::max(0.0, left - x * at[2]);
  x *= at[1];
  e = zone.side * std::min(std::pow(std::abs(at[0]), k), 1.0);
}

}  // namespace

base::Result<TrishearMap> TrishearMap::make(geom::Point tip, geom::Vector direction, Side hanging, double slip,
                                            const TrishearParams& params, const TrishearTolerances& tolerances) {
  const double apical = params.apical.degrees();
  if (!(apical > 0.0 && apical < 180.0)) {
    return refused(
        fmt::format("the triangle of trishear has an angle of 0 to 180 degrees, not of {:.6g}; change apical", apical),
        tip);
  }
  if (!(params.propagation >= 0.0) || !(params.concentration > 0.0)) {
    return refused(
        fmt::format("trishear has P/S >= 0 and a concentration > 0, not {:.6g} and {:.6g}; change propagation "
                    "or concentration",
                    params.propagation, params.concentration),
        tip);
  }
  TrishearMap map;
  map.tip_ = tip;
  map.direction_ = geom::normalised(direction);
  map.out_ = hanging == Side::Left ? geom::left_of(map.direction_) : geom::right_of(map.direction_);
  map.amount_ = std::abs(slip);
  map.sense_ = slip < 0.0 ? -1.0 : 1.0;
  map.params_ = params;
  map.slope_ = std::tan(0.5 * params.apical.radians());
  map.tolerances_ = tolerances;
  map.size_ = std::max(map.amount_ * (1.0 + params.propagation), 1e-300);
  if (map.tolerances_.chord <= 0.0) map.tolerances_.chord = 1e-6 * map.size_;
  return map;
}

TrishearMap TrishearMap::swapped() const {
  TrishearMap back = *this;
  back.back_ = !back_;
  return back;
}

Tip TrishearMap::tip() const {
  const geom::Point far = tip_ + params_.propagation * amount_ * direction_;
  return back_ ? Tip{far, tip_} : Tip{tip_, far};
}

geom::Point TrishearMap::operator()(geom::Point p, Wall on_fault) const {
  const Tip tips = tip();
  const geom::Vector v = p - tips.before;
  double x = geom::dot(v, direction_);
  double y = geom::dot(v, out_);
  const double nudge = 1e-12 * size_;
  double lift = 0.0;
  if (x <= nudge && std::abs(y) <= 10.0 * nudge) lift = (on_fault == Wall::Hanging ? nudge : -nudge) - y;
  y += lift;
  const double lifted = y;
  Zone zone{sense_, params_.propagation, params_.concentration, back_ ? -1.0 : 1.0};
  if (tolerances_.integration > 1e-9) zone.rows = 3;
  double left = amount_;
  for (int part = 0; part < 3 && left > 0.0; ++part) {
    if (std::abs(y) < slope_ * x) {
      double e = y / (slope_ * x);
      through_zone(zone, tolerances_.integration, x, e, left);
      y = e * slope_ * x;
      if (left <= 0.0) break;
    }
    // Outside the zone, or on its side on the way out: straight, to the zone if it lies ahead.
    const double speed = zone.time * ((y >= 0.0 ? sense_ : 0.0) - params_.propagation);
    const double entry = (std::abs(y) / slope_ - x) / speed;
    const bool enters = part == 0 && speed > 0.0 && entry > 0.0 && entry < left;
    x = enters ? std::abs(y) / slope_ * (1.0 + 1e-15) : x + speed * left;
    left = enters ? left - entry : 0.0;
  }
  if (y == lifted) y -= lift;
  return tips.after + x * direction_ + y * out_;
}

bool TrishearMap::parted(geom::Point image, geom::Point other) const {
  const geom::Vector v = image - tip().after;
  const geom::Vector w = other - tip().after;
  return geom::dot(v, direction_) < 0.0 && geom::dot(w, direction_) < 0.0 &&
         (geom::dot(v, out_) > 0.0) != (geom::dot(w, out_) > 0.0);
}

void TrishearMap::add_cut(geom::Point a, geom::Point b, Wall on_fault, MovedLine& moved) const {
  // By the side of the jump: beside the cut rounding leaves no sure sign of the wall.
  const geom::Point first = (*this)(a, on_fault);
  const geom::Point last = (*this)(b, on_fault);
  for (int i = 0; i < 60; ++i) {
    const geom::Point middle = geom::midpoint(a, b);
    if (middle == a || middle == b) break;
    const geom::Point image = (*this)(middle, on_fault);
    (geom::distance(image, first) < geom::distance(image, last) ? a : b) = middle;
  }
  for (const geom::Point p : {a, b}) {
    const geom::Point image = (*this)(p, on_fault);
    moved.before.points.push_back(p);
    moved.after.points.push_back(image - geom::dot(image - tip().after, out_) * out_);
  }
}

namespace {
/// Of a piece of a line at which a tip cuts it, beyond the halvings of others.
constexpr int cut_halvings = 12;
}  // namespace

MovedLine TrishearMap::line(const geom::Polyline& line, Wall on_fault) const {
  MovedLine moved;
  moved.before.closed = moved.after.closed = line.closed;
  const auto add = [&](geom::Point p, geom::Point image) {
    moved.before.points.push_back(p);
    moved.after.points.push_back(image);
  };
  const auto image_of = [&](geom::Point p) { return (*this)(p, on_fault); };
  // Quarters are looked at too: a piece whose middle is on the chord by chance may still bend.
  const auto fill = [&](const auto& self, geom::Point a, geom::Point fa, geom::Point b, geom::Point fb, int depth,
                        bool near_cut) -> void {
    near_cut = near_cut || (depth <= 0 && parted(fa, fb));
    const geom::Point middle = geom::midpoint(a, b);
    const geom::Point image = image_of(middle);
    if (depth == -cut_halvings) {
      if (parted(fa, fb)) add_cut(a, b, on_fault, moved);
      return;
    }
    if (depth <= 0 && !near_cut) return;
    const auto off = [&](geom::Point p, double t) { return geom::distance(p, geom::interpolate(fa, fb, t)); };
    const bool straight = off(image, 0.5) <= tolerances_.chord &&
                          off(image_of(geom::interpolate(a, b, 0.25)), 0.25) <= tolerances_.chord &&
                          off(image_of(geom::interpolate(a, b, 0.75)), 0.75) <= tolerances_.chord;
    if (straight) return;
    self(self, a, fa, middle, image, depth - 1, near_cut);
    add(middle, image);
    self(self, middle, image, b, fb, depth - 1, near_cut);
  };
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    moved.given.push_back(moved.before.points.size());
    const geom::Point a = line.points[i];
    const geom::Point image = image_of(a);
    add(a, image);
    if (i == line.segment_count()) break;
    const geom::Point b = line.segment(i).to;
    fill(fill, a, image, b, image_of(b), tolerances_.most_halvings, false);
  }
  return moved;
}

TrishearTip trishear_tip(const FaultPath& path) {
  const std::vector<geom::Point>& points = path.line.points;
  TrishearTip tip{path.tip_at_begin && !path.tip_at_end, points.back(), points[points.size() - 2], {}};
  if (tip.at_begin) tip.at = points.front(), tip.bend = points[1];
  tip.direction = geom::normalised(tip.at - tip.bend);
  return tip;
}

base::Result<TrishearMap> trishear(const FaultPath& path, double slip, const TrishearParams& params, DrawnTip drawn,
                                   const TrishearTolerances& tolerances) {
  const auto [at_begin, end, bend, direction] = trishear_tip(path);
  const double travel = params.propagation * std::abs(slip);
  const double needed = std::abs(slip) + (drawn == DrawnTip::After ? travel : 0.0);
  if (path.line.points.size() > 2 && geom::distance(bend, end) < needed) {
    return refused(
        fmt::format("the fault bends here, {:.6g} m from its tip, where trishear needs it straight for {:.6g} m "
                    "(slip {}); give less slip, or draw the last piece straighter",
                    geom::distance(bend, end), needed, drawn == DrawnTip::After ? "and the way of the tip" : ""),
        bend);
  }
  const Side side = (path.hanging == Side::Left) != at_begin ? Side::Left : Side::Right;
  const geom::Point tip = drawn == DrawnTip::After ? end - travel * direction : end;
  return TrishearMap::make(tip, direction, side, at_begin ? -slip : slip, params, tolerances);
}

}  // namespace recon::kinematics
