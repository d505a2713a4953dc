#include "quebra/sketch/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/discretise.h"
#include "shared/geom/spatial_index.h"

namespace quebra::sketch {
namespace {

using dobra::base::Angle;
using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Polyline;

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;

/// Two distances nearer than this fraction of the curve are the same node; limits are met up to it.
constexpr double same_node = 1e-9;
/// Sizes wanted by a field are met up to this factor: it is made of chords, which are shorter than the curve.
constexpr double near_enough = 1.05;

/// Local size at distance s: the curve's own, bounded near the stops and where a smooth curve turns fast.
class SizeAlong {
 public:
  SizeAlong(const Curve& curve, double own, const std::vector<Stop>& stops, const DivideOptions& options)
      : curve_(curve), own_(own), options_(options) {
    if (options.rule == DivisionRule::Even) smooth_ = std::get_if<Smooth>(&curve.shape);
    if (const auto* line = std::get_if<Polyline>(&curve.shape)) arc_lengths_ = dobra::geom::arc_lengths(*line);
    for (const Stop& stop : stops) {
      if (stop.size > 0.0) sized_.push_back(stop);
    }
  }
  /// What the curve itself allows: never exceeded.
  [[nodiscard]] double own(double s) const {
    double size = own_;
    if (smooth_ != nullptr) {
      const auto& chords = smooth_->chords();
      const auto above = std::upper_bound(chords.s.begin() + 1, chords.s.end() - 1, s);
      const auto i = static_cast<std::size_t>(above - chords.s.begin()) - 1;
      if (chords.turn[i] > 0.0)
        size = std::min(size, (chords.s[i + 1] - chords.s[i]) * options_.turn.radians() / chords.turn[i]);
    }
    return size;
  }
  /// With the wishes of stops and of the field.
  [[nodiscard]] double operator()(double s) const {
    double size = own(s);
    for (const Stop& stop : sized_) size = std::min(size, stop.size + (options_.growth - 1.0) * std::abs(s - stop.s));
    if (options_.limit) size = std::min(size, options_.limit(at(s)));
    return size;
  }

 private:
  [[nodiscard]] Point at(double s) const {
    if (const auto* line = std::get_if<Polyline>(&curve_.shape)) return dobra::geom::point_at(*line, arc_lengths_, s);
    return point(curve_, s);
  }

  const Curve& curve_;
  double own_;
  const DivideOptions& options_;
  const Smooth* smooth_ = nullptr;
  std::vector<double> arc_lengths_;
  std::vector<Stop> sized_;
};

/// The integral of ds / size from the start of a piece, at ever further points.
struct Integral {
  std::vector<double> s;
  std::vector<double> value{0.0};
};

/// Adds the interval up to `to`, halved wherever the size changes much within it: a size that is small at one end only,
/// by any factor, is seen.
template <class Size>
void integrate(const Size& size, double size_from, double to, double size_to, Integral& sum) {
  constexpr double alike = 1.5;
  const double from = sum.s.back();
  const double middle = 0.5 * (from + to);
  const double size_middle = size(middle);
  const auto [least, greatest] = std::minmax({size_from, size_middle, size_to});
  if (greatest > alike * least && to - from > least && from < middle && middle < to) {
    integrate(size, size_from, middle, size_middle, sum);
    integrate(size, size_middle, to, size_to, sum);
    return;
  }
  sum.s.push_back(to);
  sum.value.push_back(sum.value.back() + (to - from) / size_middle);
}

/// The integral from `from` to `to`: about the number of pieces.
template <class Size>
Integral integral_of(double from, double to, const Size& size) {
  constexpr int samples = 256;
  Integral integral{{from}};
  double before = size(from);
  for (int i = 1; i <= samples; ++i) {
    const double s = i == samples ? to : from + (to - from) * i / samples;
    const double here = size(s);
    integrate(size, before, s, here, integral);
    before = here;
  }
  return integral;
}

Error too_many(const Curve& curve, double pieces, const DivideOptions& options) {
  const double size = length(curve) / pieces;
  return {ErrorCode::TooManyElements,
          fmt::format("curve '{}', {:.6g} m long, would get about {:.3g} sides of {:.3g} m on the mean, more than the "
                      "{} elements allowed; use a greater size, or raise max_elements",
                      curve.name, length(curve), pieces, size, options.most)};
}

/// Nodes strictly between `from` and `to`, so that each piece has the same integral of ds / size.
Result<void> divide_evenly(const Curve& curve, double from, double to, const SizeAlong& size,
                           const DivideOptions& options, std::vector<double>& nodes) {
  const auto own = [&](double s) { return size.own(s); };
  Integral integral = integral_of(from, to, size);
  // Wishes that the curve's own pieces meet well enough, at each of its ends too, change nothing; others are met in
  // full, and so is the own size.
  constexpr double unnoticed = 0.5;  // pieces, of those that lead from a finer neighbour
  Integral alone = integral_of(from, to, own);
  const double more = integral.value.back() - alone.value.back();
  if (more <= std::min((near_enough - 1.0) * alone.value.back(), unnoticed)) integral = std::move(alone);
  const double total = integral.value.back();
  if (!(static_cast<double>(nodes.size()) + total <= static_cast<double>(options.most)))
    return too_many(curve, static_cast<double>(nodes.size()) + total, options);
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(total * (1.0 - same_node))));
  for (std::size_t piece = 1; piece < pieces; ++piece) {
    const double wanted = total * static_cast<double>(piece) / static_cast<double>(pieces);
    const auto above = std::lower_bound(integral.value.begin(), integral.value.end(), wanted);
    const auto i = static_cast<std::size_t>(above - integral.value.begin()) - 1;
    const double inside = (wanted - integral.value[i]) / (integral.value[i + 1] - integral.value[i]);
    nodes.push_back(integral.s[i] + inside * (integral.s[i + 1] - integral.s[i]));
  }
  return {};
}

/// The same by the discretiser of geom.
Result<void> divide_by_halves(const Curve& curve, double from, double to, const SizeAlong& size,
                              const DivideOptions& options, std::vector<double>& nodes) {
  const double pieces = static_cast<double>(nodes.size()) + integral_of(from, to, size).value.back();
  if (!(pieces <= static_cast<double>(options.most))) return too_many(curve, pieces, options);
  const auto at = [&](double t) { return from + t * (to - from); };
  const bool straight = std::holds_alternative<Polyline>(curve.shape);
  const dobra::geom::Vector along = straight ? direction(curve, at(0.5)) : dobra::geom::Vector{};
  const dobra::geom::CurveFunctions functions{
      .point = [&](double t) { return point(curve, at(t)); },
      .tangent = [&](double t) { return straight ? along : direction(curve, at(t)); },
      .length = [&](double t0, double t1) { return (t1 - t0) * (to - from); }};
  dobra::geom::DiscretiseOptions limits{.max_angle = options.turn, .max_length = size.own(from)};
  limits.max_length_over = [&](double t0, double t1) {
    constexpr int samples = 8;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i) least = std::min(least, size(at(t0 + (t1 - t0) * i / samples)));
    return near_enough * least;
  };
  DOBRA_TRY(const auto found, dobra::geom::discretise(functions, limits));
  for (std::size_t i = 1; i + 1 < found.parameters.size(); ++i) nodes.push_back(at(found.parameters[i]));
  return {};
}

/// Halves every piece of more than twice a neighbour's length, until there is none.
void balance(std::vector<double>& nodes, bool closed) {
  constexpr double most = 2.0 * (1.0 + 1e-6);
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<double> finer{nodes.front()};
    const std::size_t pieces = nodes.size() - 1;
    const auto piece = [&](std::size_t i) { return nodes[i + 1] - nodes[i]; };
    for (std::size_t i = 0; i < pieces; ++i) {
      double least = std::numeric_limits<double>::infinity();
      if (i > 0 || closed) least = std::min(least, piece((i + pieces - 1) % pieces));
      if (i + 1 < pieces || closed) least = std::min(least, piece((i + 1) % pieces));
      if (piece(i) > most * least) {
        finer.push_back(0.5 * (nodes[i] + nodes[i + 1]));
        changed = true;
      }
      finer.push_back(nodes[i + 1]);
    }
    nodes = std::move(finer);
  }
}

/// `segments` pieces along a curve whose lengths grow geometrically to `ratio` times the first: distance after u of
/// them.
class Progression {
 public:
  Progression(double length, std::size_t segments, double ratio)
      : length_(length),
        n_(static_cast<double>(segments)),
        growth_(segments > 1 ? std::pow(ratio, 1.0 / (n_ - 1.0)) : 1.0) {
    // Growth too slow to be told from none.
    if (std::abs(n_ * std::log(growth_)) < 1e-9) growth_ = 1.0;
  }
  [[nodiscard]] double distance(double u) const {
    if (growth_ == 1.0) return length_ * u / n_;
    return length_ * std::expm1(u * std::log(growth_)) / std::expm1(n_ * std::log(growth_));
  }
  /// Its inverse.
  [[nodiscard]] double pieces(double s) const {
    if (growth_ == 1.0) return n_ * s / length_;
    return std::log1p(s / length_ * std::expm1(n_ * std::log(growth_))) / std::log(growth_);
  }
  [[nodiscard]] double longest() const { return std::max(distance(1.0), length_ - distance(n_ - 1.0)); }

 private:
  double length_, n_, growth_;
};

/// As many pieces as it takes for the longest to be `size`.
std::size_t segments_for(double length, double size, double ratio) {
  const double bias = std::abs(ratio - 1.0) < 1e-9 ? 1.0 : std::max(ratio, 1.0 / ratio);
  const double above_mean = bias > 1.0 ? bias * std::log(bias) / (bias - 1.0) : 1.0;
  auto segments = static_cast<std::size_t>(std::max(1.0, std::floor(length / size * above_mean) - 3.0));
  while (Progression(length, segments, ratio).longest() > size * (1.0 + same_node)) ++segments;
  return segments;
}

/// Just `segments` pieces in all: each stop takes the number that is nearest to its place in the progression, one piece
/// at least between two stops, and the pieces between two stops share what lies between them in the progression's
/// proportions.
Result<std::vector<double>> divide_explicitly(const Curve& curve, const std::vector<double>& stops,
                                              std::size_t segments) {
  const std::size_t runs = stops.size() - 1;
  if (segments < runs) {
    return Error{ErrorCode::BadValue, fmt::format("curve '{}' has {} pieces between its corners and the nodes that "
                                                  "others need on it; {} segments cannot follow them: give {} or more",
                                                  curve.name, runs, segments, runs)};
  }
  if (curve.role == Role::Crack && segments < 2) {
    return Error{ErrorCode::BadValue,
                 fmt::format("crack '{}' of one segment could not open; give it 2 or more", curve.name)};
  }
  const Progression progression(stops.back(), segments, curve.division.ratio);
  std::vector<double> nodes{0.0};
  std::size_t number = 0;
  for (std::size_t run = 1; run <= runs; ++run) {
    const double u_from = progression.pieces(stops[run - 1]);
    const double u_to = progression.pieces(stops[run]);
    const auto nearest = static_cast<std::size_t>(std::max(0.0, std::round(u_to)));
    const std::size_t next = run == runs ? segments : std::clamp(nearest, number + 1, segments - (runs - run));
    for (std::size_t i = number + 1; i < next; ++i) {
      const double share = static_cast<double>(i - number) / static_cast<double>(next - number);
      nodes.push_back(progression.distance(u_from + share * (u_to - u_from)));
    }
    nodes.push_back(stops[run]);
    number = next;
  }
  return nodes;
}

}  // namespace

dobra::base::Result<Smooth> Smooth::make(dobra::geom::CubicPath path) {
  Smooth result(std::move(path));
  DOBRA_TRY(const auto pieces, dobra::geom::discretise(result.path_, {.max_angle = trace_turn}));
  result.knots_.assign(result.path_.knots().begin(), result.path_.knots().end());
  const double first = result.knots_.front();
  const double range = result.knots_.back() - first;
  for (double& knot : result.knots_) knot = (knot - first) / range;
  const std::vector<double>& knots = result.knots_;
  result.at_knot_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    result.at_knot_.push_back(result.at_knot_.back() + result.path_.length(knots[i], knots[i + 1]));
  }
  const auto functions = dobra::geom::functions_of(result.path_);
  result.chords_.points = pieces.points;
  result.chords_.s.push_back(0.0);
  for (std::size_t i = 0; i + 1 < pieces.parameters.size(); ++i) {
    const double from = pieces.parameters[i];
    const double to = pieces.parameters[i + 1];
    result.chords_.s.push_back(result.chords_.s.back() + result.path_.length(from, to));
    result.chords_.turn.push_back(dobra::geom::tangent_turn(functions, from, to).radians());
  }
  result.chords_.s.back() = result.length();
  return result;
}

/// Newton's method within the cubic, from the share of its length.
double Smooth::parameter(double s) const {
  const std::vector<double>& knots = knots_;
  const auto above = std::upper_bound(at_knot_.begin() + 1, at_knot_.end() - 1, s);
  const auto i = static_cast<std::size_t>(above - at_knot_.begin()) - 1;
  const double piece = at_knot_[i + 1] - at_knot_[i];
  double t = knots[i] + (knots[i + 1] - knots[i]) * (s - at_knot_[i]) / piece;
  for (int step = 0; step < 20; ++step) {
    const double excess = path_.length(knots[i], t) - (s - at_knot_[i]);
    const double speed = dobra::geom::length(path_.tangent(t));
    if (std::abs(excess) <= 1e-14 * length() || speed == 0.0) break;
    t = std::clamp(t - excess / speed, knots[i], knots[i + 1]);
  }
  return t;
}

Point Smooth::point(double s) const {
  if (s <= 0.0) return chords_.points.front();
  if (s >= length()) return chords_.points.back();
  return path_.point(parameter(s));
}

dobra::geom::Vector Smooth::direction(double s) const {
  return normalised(path_.tangent(parameter(std::clamp(s, 0.0, length()))));
}

Result<Smooth> Smooth::part(double from, double to) const {
  const double first = from <= 0.0 ? 0.0 : parameter(from);
  const double last = to >= length() ? 1.0 : parameter(to);
  std::vector<dobra::geom::HermiteCubic> cubics;
  std::vector<double> knots{first};
  for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
    const double span = knots_[k + 1] - knots_[k];
    const double u = std::clamp((first - knots_[k]) / span, 0.0, 1.0);
    const double v = std::clamp((last - knots_[k]) / span, 0.0, 1.0);
    if (!(v - u > same_node)) continue;
    const auto cubic = bezier_of(path_.cubics()[k]);
    cubics.push_back({cubic.point(u), cubic.point(v), (v - u) * cubic.tangent(u), (v - u) * cubic.tangent(v)});
    knots.push_back(knots_[k] + v * span);
  }
  if (cubics.empty()) return Error{ErrorCode::DegenerateCurve, "a part of a curve has no length"};
  return make({std::move(cubics), std::move(knots)});
}

bool bounds(const Curve& curve) { return curve.role == Role::Boundary || curve.role == Role::Hole; }

double length(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return arc->length();
  if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) return smooth->length();
  return dobra::geom::length(std::get<Polyline>(curve.shape));
}

bool closed(const Curve& curve) {
  if (const auto* line = std::get_if<Polyline>(&curve.shape)) return line->closed;
  if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) return smooth->closed();
  return std::get<Arc>(curve.shape).closed();
}

Point point(const Curve& curve, double s) { return points(curve, std::span(&s, 1)).front(); }

std::vector<Point> points(const Curve& curve, std::span<const double> s) {
  std::vector<Point> result;
  result.reserve(s.size());
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) {
    for (const double at : s) result.push_back(arc->point(at / arc->length()));
  } else if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) {
    for (const double at : s) result.push_back(smooth->point(at));
  } else {
    const auto& line = std::get<Polyline>(curve.shape);
    const std::vector<double> arc_lengths = dobra::geom::arc_lengths(line);
    for (const double at : s) result.push_back(dobra::geom::point_at(line, arc_lengths, at));
  }
  return result;
}

dobra::geom::Vector direction(const Curve& curve, double s) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return normalised(arc->tangent(s / arc->length()));
  if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) return smooth->direction(s);
  const auto& line = std::get<Polyline>(curve.shape);
  const std::vector<double> at = dobra::geom::arc_lengths(line);
  const auto above =
      std::upper_bound(at.begin() + 1, at.begin() + static_cast<std::ptrdiff_t>(line.segment_count()), s);
  return normalised(line.segment(static_cast<std::size_t>(above - at.begin()) - 1).vector());
}

std::vector<double> corners(const Curve& curve) {
  if (const auto* line = std::get_if<Polyline>(&curve.shape)) return dobra::geom::arc_lengths(*line);
  return {0.0, length(curve)};
}

Trace trace(const Curve& curve) {
  if (const auto* line = std::get_if<Polyline>(&curve.shape)) return {*line, dobra::geom::arc_lengths(*line)};
  if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) {
    Trace result{{smooth->chords().points, smooth->closed()}, smooth->chords().s};
    if (result.line.closed) result.line.points.pop_back();
    return result;
  }
  const Arc& arc = std::get<Arc>(curve.shape);
  // An arc turns evenly: of the halves that discretise() makes all are fine enough at once, and need not be looked at.
  double count = 1.0;
  while (std::abs(arc.sweep().radians()) >
         count * (1.0 + dobra::geom::DiscretiseOptions{}.slack) * trace_turn.radians())
    count *= 2.0;
  dobra::geom::Discretisation pieces;
  for (double i = 0.0; i <= count; ++i) {
    pieces.parameters.push_back(i / count);
    pieces.points.push_back(arc.point(i / count));
  }
  Trace result{pieces.polyline(), std::move(pieces.parameters)};
  for (double& s : result.s) s *= arc.length();
  return result;
}

ShapeKey shape_key(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) {
    if (arc->closed()) return {{arc->centre(), {arc->radius(), 0.0}}};
    const Point first = point(curve, 0.0);
    const Point last = point(curve, arc->length());
    const auto& [low, high] = std::minmax(first, last);
    const double side = cross(high - low, point(curve, 0.5 * arc->length()) - low) > 0.0 ? 1.0 : -1.0;
    return {{arc->centre(), low}, {high, {side, 0.0}}};
  }
  const dobra::geom::Polyline line = trace(curve).line;
  ShapeKey key;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const auto [from, to] = line.segment(i);
    key.push_back({std::min(from, to), std::max(from, to)});
  }
  std::sort(key.begin(), key.end());
  return key;
}

dobra::geom::Box box_of(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return arc->box();
  if (const auto* smooth = std::get_if<Smooth>(&curve.shape)) return dobra::geom::box_of(smooth->chords().points);
  return std::get<Polyline>(curve.shape).box();
}

std::vector<std::uint8_t> lone_circles(std::span<const Curve> curves, std::span<const Point> points, double margin) {
  std::vector<dobra::geom::Box> boxes;
  std::vector<std::size_t> owner;
  const auto add = [&](const dobra::geom::Box& box, std::size_t curve) {
    boxes.push_back(box);
    owner.push_back(curve);
  };
  std::vector<std::uint8_t> lone(curves.size(), 0);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto* const arc = std::get_if<Arc>(&curves[c].shape);
    if (arc == nullptr) {
      const Trace along = trace(curves[c]);
      for (std::size_t i = 0; i < along.line.segment_count(); ++i) add(along.line.segment(i).box(), c);
      continue;
    }
    lone[c] = arc->closed() ? 1 : 0;
    constexpr int parts = 16;
    const double bulge = arc->radius() * (1.0 - std::cos(0.5 * arc->sweep().radians() / parts));
    for (int i = 0; i < parts; ++i)
      add(dobra::geom::Segment{arc->point(1.0 * i / parts), arc->point((i + 1.0) / parts)}.box().grown(bulge), c);
  }
  for (const Point p : points) add({p, p}, curves.size());
  const dobra::geom::SpatialIndex index(boxes);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (lone[c] == 0) continue;
    index.for_each_overlapping(box_of(curves[c]).grown(margin), [&](std::size_t i) {
      if (owner[i] != c) lone[c] = 0;
      return owner[i] != c ? dobra::geom::Visit::Stop : dobra::geom::Visit::Continue;
    });
  }
  return lone;
}

std::optional<std::array<double, 2>> meeting(const Curve& one, double s, const Curve& two, double t, double tolerance) {
  const bool straight = std::holds_alternative<Polyline>(one.shape) && std::holds_alternative<Polyline>(two.shape);
  if (straight) return std::array{s, t};
  const double first = length(one), second = length(two);
  for (int step = 0; step < 30; ++step) {
    const dobra::geom::Vector gap = point(two, t) - point(one, s);
    const dobra::geom::Vector u = direction(one, s);
    const dobra::geom::Vector v = direction(two, t);
    const double turn = cross(u, v);
    if (std::abs(turn) < 1e-9) break;
    const double ds = cross(gap, v) / turn;
    const double dt = cross(gap, u) / turn;
    s = std::clamp(s + ds, 0.0, first);
    t = std::clamp(t + dt, 0.0, second);
    if (std::abs(ds) + std::abs(dt) < 1e-15 * (first + second)) break;
  }
  if (distance(point(one, s), point(two, t)) > tolerance) return std::nullopt;
  return std::array{s, t};
}

bool explicit_division(const Curve& curve, std::span<const Stop> stops) {
  if (curve.division.segments == 0 && curve.division.ratio == 1.0) return false;
  const double total = length(curve);
  return std::none_of(stops.begin(), stops.end(),
                      [&](const Stop& stop) { return stop.size > 0.0 && stop.s > 0.0 && stop.s < total; });
}

Result<std::vector<double>> divide(const Curve& curve, std::vector<Stop> stops, const DivideOptions& options) {
  const double total = length(curve);
  const Division& said = curve.division;
  double own = said.size > 0.0 ? said.size : options.size;
  const auto* const arc = std::get_if<Arc>(&curve.shape);
  const double turn_size = arc != nullptr ? arc->radius() * options.turn.radians() * (1.0 + same_node) : own;
  const bool explicitly = explicit_division(curve, stops);
  if (!explicitly && said.segments > 0) own = total / said.segments;
  if (said.segments == 0 && (explicitly || options.rule == DivisionRule::Even)) own = std::min(own, turn_size);

  if (curve.tip_size > 0.0) {
    stops.push_back({0.0, curve.tip_size});
    stops.push_back({total, curve.tip_size});
  }
  std::vector<double> cuts = corners(curve);
  for (const Stop& stop : stops) cuts.push_back(std::clamp(stop.s, 0.0, total));
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](double a, double b) { return b - a <= same_node * total; }),
             cuts.end());
  cuts.back() = total;
  if (explicitly) {
    const double least = said.segments > 0 ? said.segments : total / own;
    if (least > static_cast<double>(options.most)) return too_many(curve, least, options);
    return divide_explicitly(
        curve, cuts,
        said.segments > 0 ? static_cast<std::size_t>(said.segments) : segments_for(total, own, said.ratio));
  }
  const SizeAlong size(curve, own, stops, options);
  std::vector<double> nodes{0.0};
  const auto divide_run = options.rule == DivisionRule::Even ? divide_evenly : divide_by_halves;
  for (std::size_t run = 1; run < cuts.size(); ++run) {
    DOBRA_TRY_VOID(divide_run(curve, cuts[run - 1], cuts[run], size, options, nodes));
    nodes.push_back(cuts[run]);
  }
  if (options.rule == DivisionRule::Halving) balance(nodes, closed(curve));
  if (curve.role == Role::Crack && nodes.size() == 2) nodes.insert(nodes.begin() + 1, 0.5 * total);
  return nodes;
}

}  // namespace quebra::sketch
