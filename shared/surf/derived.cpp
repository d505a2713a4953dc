// Surfaces made of surfaces: moved, over another chart, offset along their normals.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/surf/measure.h"
#include "shared/surf/surface.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

struct MovedSurface : Surface::Shape {
  std::shared_ptr<const Surface::Shape> of;
  Frame frame;
  double most;  ///< No vector grows by more.
  MovedSurface(std::shared_ptr<const Surface::Shape> shape, const Frame& to, double growth)
      : of(std::move(shape)), frame(to), most(growth) {}
  [[nodiscard]] Vector3 image(Vector3 v) const { return v.x * frame.x + v.y * frame.y + v.z * frame.z; }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    of->jets(uv, jets);
    for (Jet& jet : jets)
      jet = {frame.origin + image(jet.at - Point3{}),
             image(jet.u),
             image(jet.v),
             image(jet.uu),
             image(jet.uv),
             image(jet.vv)};
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    const Bend bend = of->bend(part);
    return {most * bend.uu, most * bend.uv, most * bend.vv};
  }
  [[nodiscard]] bool seen(const Box& part) const override { return of->seen(part); }
};

/// A range of a parameter that goes round.
struct Turn {
  bool round = false;
  double low = 0.0, period = 1.0;
  double end = 0.0;  ///< Of the window: there the left side is meant.
  [[nodiscard]] double folded(double t) const {
    if (!round) return t;
    const double in = std::clamp(t - std::floor((t - low) / period) * period, low, low + period);
    return t == end && in == low ? low + period : in;
  }
  /// The parts of the own range that a range covers, at most two.
  [[nodiscard]] std::vector<std::pair<double, double>> parts(double from, double to) const {
    if (!round) return {{from, to}};
    if (to - from >= period) return {{low, low + period}};
    const double a = folded(from), b = folded(to);
    if (a < b) return {{a, b}};
    std::vector<std::pair<double, double>> both;
    if (a < low + period) both.emplace_back(a, low + period);
    if (low < b) both.emplace_back(low, b);
    return both;
  }
  [[nodiscard]] std::vector<double> breaks(const std::vector<double>& own, double from, double to) const {
    std::vector<double> found;
    const double first = round ? std::floor((from - low) / period) : 0.0;
    for (double turn = first; turn == first || (round && low + turn * period < to); turn += 1.0) {
      for (const double at : own) found.push_back(at + turn * period);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end(), [&](double a, double b) { return b - a <= 1e-14 * period; }),
                found.end());
    return found;
  }
};

struct WindowShape : Surface::Shape {
  std::shared_ptr<const Surface::Shape> of;
  Turn u, v;
  WindowShape(std::shared_ptr<const Surface::Shape> shape, const Turn& in_u, const Turn& in_v)
      : of(std::move(shape)), u(in_u), v(in_v) {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const Point at{u.folded(uv[i].x), v.folded(uv[i].y)};
      of->jets({&at, 1}, {&jets[i], 1});
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    Bend most;
    for (const auto& [u0, u1] : u.parts(part.low.x, part.high.x)) {
      for (const auto& [v0, v1] : v.parts(part.low.y, part.high.y)) {
        const Bend bend = of->bend({{u0, v0}, {u1, v1}});
        most = {std::max(most.uu, bend.uu), std::max(most.uv, bend.uv), std::max(most.vv, bend.vv)};
      }
    }
    return most;
  }
  [[nodiscard]] bool seen(const Box& part) const override {
    for (const auto& [u0, u1] : u.parts(part.low.x, part.high.x)) {
      for (const auto& [v0, v1] : v.parts(part.low.y, part.high.y)) {
        if (!of->seen({{u0, v0}, {u1, v1}})) return false;
      }
    }
    return true;
  }
};

/// Weights of a first derivative by five values at steps of one, at value number [k].
constexpr std::array<std::array<double, 5>, 5> five{{{-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25},
                                                     {-0.25, -5.0 / 6.0, 1.5, -0.5, 1.0 / 12.0},
                                                     {1.0 / 12.0, -2.0 / 3.0, 0.0, 2.0 / 3.0, -1.0 / 12.0},
                                                     {-1.0 / 12.0, 0.5, -1.5, 5.0 / 6.0, 0.25},
                                                     {0.25, -4.0 / 3.0, 3.0, -4.0, 25.0 / 12.0}}};

struct OffsetShape : Surface::Shape {
  Surface of;
  double distance;
  OffsetShape(const Surface& surface, double by) : of(surface), distance(by) {}

  /// Place and first derivatives.
  struct Tangents {
    Point3 at;
    Vector3 u, v;
  };
  [[nodiscard]] Tangents tangents(Point uv) const {
    const Jet jet = of.jet(uv);
    const std::optional<Vector3> n = normal(of, uv);
    if (!n) return {jet.at, jet.u, jet.v};  // at a point inside, which no face should hold
    const Box& chart = of.chart();
    const double still = 1e-12 * of.size();
    const bool still_u = geom::length(jet.u) * chart.width() <= still;
    const bool still_v = geom::length(jet.v) * chart.height() <= still;
    Jet slope = jet;
    if (!normal(jet)) {  // on a side that is one point: the turn of the normal a little inside
      constexpr double little = 1e-6;
      const Point middle = chart.centre();
      slope = of.jet(
          {still_v ? std::lerp(uv.x, middle.x, little) : uv.x, still_v ? uv.y : std::lerp(uv.y, middle.y, little)});
    }
    const Vector3 across = cross(slope.u, slope.v);
    const double size = geom::length(across);
    if (!(size > 0.0)) return {jet.at + distance * *n, jet.u, jet.v};
    const Vector3 unit = across / size;
    const auto turned = [&](Vector3 by) { return (distance / size) * (by - dot(by, unit) * unit); };
    const Vector3 by_u = turned(cross(slope.uu, slope.v) + cross(slope.u, slope.uv));
    const Vector3 by_v = turned(cross(slope.uv, slope.v) + cross(slope.u, slope.vv));
    return {jet.at + distance * *n, still_u ? Vector3{} : jet.u + by_u, still_v ? Vector3{} : jet.v + by_v};
  }

  /// Five places along a parameter that lie in one piece: the step and the number of the one where `t` is.
  struct Places {
    double step = 0.0;
    int at = 0;
  };
  static Places places(const std::vector<double>& breaks, double t) {
    auto next = std::upper_bound(breaks.begin(), breaks.end(), t);
    if (next == breaks.end()) --next;
    if (next == breaks.begin()) ++next;
    const double low = *(next - 1), high = *next, step = 2e-3 * (high - low);
    const int before = std::clamp(static_cast<int>(std::floor((t - low) / step)), 0, 2);
    const int after = std::clamp(static_cast<int>(std::floor((high - t) / step - 1e-6)), 0, 2);
    return {step, before < 2 ? before : 4 - after};
  }

  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i]);
  }
  [[nodiscard]] Jet jet(Point uv) const {
    const Tangents here = tangents(uv);
    Jet jet{here.at, here.u, here.v, {}, {}, {}};
    const Places in_u = places(of.breaks().u, uv.x), in_v = places(of.breaks().v, uv.y);
    for (int i = 0; i < 5; ++i) {
      const double weight_u = five[static_cast<std::size_t>(in_u.at)][static_cast<std::size_t>(i)] / in_u.step;
      const double weight_v = five[static_cast<std::size_t>(in_v.at)][static_cast<std::size_t>(i)] / in_v.step;
      if (weight_u != 0.0) {
        const Tangents there = tangents({uv.x + (i - in_u.at) * in_u.step, uv.y});
        jet.uu = jet.uu + weight_u * there.u;
        jet.uv = jet.uv + weight_u * there.v;
      }
      if (weight_v != 0.0) jet.vv = jet.vv + weight_v * tangents({uv.x, uv.y + (i - in_v.at) * in_v.step}).v;
    }
    return jet;
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    constexpr int places = 9;
    constexpr double safe = 1.5;
    Bend most;
    for (int i = 0; i < places * places; ++i) {
      const Jet at = jet({std::lerp(part.low.x, part.high.x, (i / places + 0.5) / places),
                          std::lerp(part.low.y, part.high.y, (i % places + 0.5) / places)});
      most = {std::max(most.uu, safe * geom::length(at.uu)), std::max(most.uv, safe * geom::length(at.uv)),
              std::max(most.vv, safe * geom::length(at.vv))};
    }
    return most;
  }
  [[nodiscard]] bool seen(const Box& part) const override { return of.seen(part); }
};

/// @error DegenerateCurve: the offset along the normal of a place passes a centre of curvature.
base::Result<void> check_offset(const Surface& surface, double distance) {
  constexpr int places = 32;
  const Box& chart = surface.chart();
  for (int i = 0; i <= places; ++i) {
    for (int j = 0; j <= places; ++j) {
      const Point uv{std::lerp(chart.low.x, chart.high.x, static_cast<double>(i) / places),
                     std::lerp(chart.low.y, chart.high.y, static_cast<double>(j) / places)};
      const Jet jet = surface.jet(uv);
      const base::Place place{.x = jet.at.x, .y = jet.at.y, .z = jet.at.z, .u = uv.x, .v = uv.y};
      if (!normal(surface, uv))
        return Error{ErrorCode::DegenerateCurve, "the surface has no normal to move it along", place};
      const std::optional<Curvature> bent = curvature(jet);
      if (!bent) continue;
      const double most = distance > 0.0 ? bent->greatest : bent->least;
      if (distance * most >= 1.0)
        return Error{ErrorCode::DegenerateCurve,
                     fmt::format("the offset of {:.6g} m reaches beyond the radius of curvature of {:.6g} m: the "
                                 "surface would fold",
                                 distance, 1.0 / std::abs(most)),
                     place};
    }
  }
  return {};
}

}  // namespace

base::Result<Surface> Surface::moved(const Frame& frame) const {
  if (!geom::is_finite(frame.origin) || !geom::is_finite(frame.x) || !geom::is_finite(frame.y) ||
      !geom::is_finite(frame.z))
    return Error{ErrorCode::NotFinite, "the map of the surface has a number that is not finite"};
  const double x = geom::length(frame.x), y = geom::length(frame.y), z = geom::length(frame.z);
  if (!(std::abs(dot(frame.x, cross(frame.y, frame.z))) > 1e-12 * x * y * z))
    return Error{ErrorCode::DegenerateCurve, "the map of the surface makes things flat"};
  // Axes at right angles stretch by the longest of them; others by no more than all together.
  const bool square = std::abs(dot(frame.x, frame.y)) <= 1e-12 * x * y &&
                      std::abs(dot(frame.y, frame.z)) <= 1e-12 * y * z &&
                      std::abs(dot(frame.z, frame.x)) <= 1e-12 * z * x;
  const double most = square ? std::max({x, y, z}) : std::hypot(x, y, z);
  return make(std::make_shared<const MovedSurface>(shape_, frame, most), chart_, breaks_);
}

base::Result<Surface> Surface::over(const Box& chart, Beyond u, Beyond v) const {
  const Turn in_u{u == Beyond::GoesRound && (chart.low.x < chart_.low.x || chart.high.x > chart_.high.x), chart_.low.x,
                  chart_.width(), chart.high.x};
  const Turn in_v{v == Beyond::GoesRound && (chart.low.y < chart_.low.y || chart.high.y > chart_.high.y), chart_.low.y,
                  chart_.height(), chart.high.y};
  constexpr double most_turns = 1e6;
  if (chart.width() > most_turns * in_u.period || chart.height() > most_turns * in_v.period)
    return Error{ErrorCode::InvalidOption, "the chart goes round more than a million times"};
  Breaks breaks{in_u.breaks(breaks_.u, chart.low.x, chart.high.x), in_v.breaks(breaks_.v, chart.low.y, chart.high.y)};
  if (!in_u.round && !in_v.round) return make(shape_, chart, std::move(breaks));
  return make(std::make_shared<const WindowShape>(shape_, in_u, in_v), chart, std::move(breaks));
}

base::Result<Surface> Surface::offset(double distance) const {
  if (!std::isfinite(distance)) return Error{ErrorCode::NotFinite, "the offset of the surface is not finite"};
  DOBRA_TRY_VOID(check_offset(*this, distance));
  return make(std::make_shared<const OffsetShape>(*this, distance), chart_, breaks_);
}

}  // namespace dobra::surf
