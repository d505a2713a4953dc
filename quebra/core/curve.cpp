#include "quebra/core/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/discretise.h"

namespace quebra::core {
namespace {

using dobra::base::Angle;
using dobra::geom::Arc;
using dobra::geom::Point;
using dobra::geom::Polyline;

/// Two distances nearer than this fraction of the curve are the same node.
constexpr double same_node = 1e-9;

/// Local size at distance s: the curve's own, bounded near the stops and where a smooth curve turns fast.
class SizeAlong {
 public:
  SizeAlong(const Curve& curve, double own, const std::vector<Stop>& stops, const DivideOptions& options)
      : curve_(curve), own_(own), options_(options) {
    if (curve.division.segments == 0) smooth_ = std::get_if<Smooth>(&curve.shape);
    if (const auto* line = std::get_if<Polyline>(&curve.shape)) arc_lengths_ = dobra::geom::arc_lengths(*line);
    for (const Stop& stop : stops) {
      if (stop.size > 0.0) sized_.push_back(stop);
    }
  }
  [[nodiscard]] double operator()(double s) const {
    double size = own_;
    if (smooth_ != nullptr) {
      const auto& chords = smooth_->chords();
      const auto above = std::upper_bound(chords.s.begin() + 1, chords.s.end() - 1, s);
      const auto i = static_cast<std::size_t>(above - chords.s.begin()) - 1;
      if (chords.turn[i] > 0.0) size = std::min(size, (chords.s[i + 1] - chords.s[i]) * options_.turn.radians() / chords.turn[i]);
    }
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
void integrate(const SizeAlong& size, double size_from, double to, double size_to, Integral& sum) {
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

/// Nodes strictly between `from` and `to`, so that each piece has about the same integral of ds / size.
void divide_piece(double from, double to, const SizeAlong& size, std::vector<double>& nodes) {
  constexpr int samples = 256;
  Integral integral{{from}};
  double before = size(from);
  for (int i = 1; i <= samples; ++i) {
    const double s = i == samples ? to : from + (to - from) * i / samples;
    const double here = size(s);
    integrate(size, before, s, here, integral);
    before = here;
  }
  const double total = integral.value.back();
  const int pieces = std::max(1, static_cast<int>(std::ceil(total - 0.25)));
  for (int piece = 1; piece < pieces; ++piece) {
    const double wanted = total * piece / pieces;
    const auto above = std::lower_bound(integral.value.begin(), integral.value.end(), wanted);
    const auto i = static_cast<std::size_t>(above - integral.value.begin()) - 1;
    const double inside = (wanted - integral.value[i]) / (integral.value[i + 1] - integral.value[i]);
    nodes.push_back(integral.s[i] + inside * (integral.s[i + 1] - integral.s[i]));
  }
}

/// `segments` pieces between `from` and `to` whose lengths grow geometrically to `ratio` times the first.
void divide_exactly(double from, double to, int segments, double ratio, std::vector<double>& nodes) {
  const double growth = segments > 1 ? std::pow(ratio, 1.0 / (segments - 1)) : 1.0;
  double piece = 1.0;
  double total = 0.0;
  for (int i = 0; i < segments; ++i, piece *= growth) total += piece;
  piece = 1.0;
  double travelled = 0.0;
  for (int i = 1; i < segments; ++i, piece *= growth) {
    travelled += piece;
    nodes.push_back(from + (to - from) * travelled / total);
  }
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

dobra::geom::Vector Smooth::direction(double s) const { return normalised(path_.tangent(parameter(std::clamp(s, 0.0, length())))); }

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
  const auto above = std::upper_bound(at.begin() + 1, at.begin() + static_cast<std::ptrdiff_t>(line.segment_count()), s);
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
  // Cannot fail: an Arc has a positive length, no corner, and the angle is positive.
  auto pieces = dobra::geom::discretise(arc, {.max_angle = trace_turn}).value();
  Trace result{pieces.polyline(), std::move(pieces.parameters)};
  for (double& s : result.s) s *= arc.length();
  return result;
}

std::vector<double> divide(const Curve& curve, std::vector<Stop> stops, const DivideOptions& options) {
  const double total = length(curve);
  const auto before = [](const Stop& a, const Stop& b) { return a.s < b.s; };
  const Division& said = curve.division;

  double own = options.size;
  if (said.segments > 0) own = total / said.segments;
  if (said.size > 0.0) own = said.size;
  const auto* const arc = std::get_if<Arc>(&curve.shape);
  if (arc != nullptr && said.segments == 0) own = std::min(own, arc->radius() * options.turn.radians() * (1.0 + same_node));

  if (curve.tip_size > 0.0) {
    stops.push_back({0.0, curve.tip_size});
    stops.push_back({total, curve.tip_size});
  }
  for (const double s : corners(curve)) stops.push_back({s, 0.0});
  std::stable_sort(stops.begin(), stops.end(), before);
  const SizeAlong size(curve, own, stops, options);

  std::vector<double> nodes;
  // Sizes at the ends and further stops there do not cut the curve.
  const bool one_piece = std::all_of(stops.begin(), stops.end(), [&](const Stop& stop) { return stop.s <= 0.0 || stop.s >= total; });
  for (const Stop& stop : stops) {
    const double s = std::clamp(stop.s, 0.0, total);
    if (nodes.empty()) {
      nodes.push_back(s);
      continue;
    }
    const double from = nodes.back();
    if (s - from <= same_node * total) continue;
    if (one_piece && said.segments > 0) {
      divide_exactly(from, s, said.segments, said.ratio, nodes);
    } else {
      divide_piece(from, s, size, nodes);
    }
    nodes.push_back(s);
  }
  nodes.back() = total;
  if (curve.role == Role::Crack && nodes.size() == 2) nodes.insert(nodes.begin() + 1, 0.5 * total);
  return nodes;
}

}  // namespace quebra::core
