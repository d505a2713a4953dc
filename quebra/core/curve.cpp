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

/// Local size at distance s: the curve's own, bounded near the stops.
class SizeAlong {
 public:
  SizeAlong(double own, const std::vector<Stop>& stops, double growth) : own_(own), growth_(growth) {
    for (const Stop& stop : stops) {
      if (stop.size > 0.0) sized_.push_back(stop);
    }
  }
  [[nodiscard]] double operator()(double s) const {
    double size = own_;
    for (const Stop& stop : sized_) size = std::min(size, stop.size + (growth_ - 1.0) * std::abs(s - stop.s));
    return size;
  }
  [[nodiscard]] bool uniform() const { return sized_.empty(); }

 private:
  double own_;
  double growth_;
  std::vector<Stop> sized_;
};

/// Nodes strictly between `from` and `to`, so that each piece has about the same integral of ds / size.
void divide_piece(double from, double to, const SizeAlong& size, std::vector<double>& nodes) {
  constexpr int samples = 256;
  std::vector<double> integral(samples + 1, 0.0);
  const double step = (to - from) / samples;
  for (int i = 0; i < samples; ++i) integral[i + 1] = integral[i] + step / size(from + (i + 0.5) * step);
  const double total = integral.back();
  const int pieces = std::max(1, static_cast<int>(std::ceil(total - 0.25)));
  for (int piece = 1; piece < pieces; ++piece) {
    const double wanted = total * piece / pieces;
    const auto above = std::lower_bound(integral.begin(), integral.end(), wanted);
    const auto i = static_cast<std::size_t>(above - integral.begin()) - 1;
    const double inside = (wanted - integral[i]) / (integral[i + 1] - integral[i]);
    nodes.push_back(from + (static_cast<double>(i) + inside) * step);
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

double length(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return arc->length();
  return dobra::geom::length(std::get<Polyline>(curve.shape));
}

bool closed(const Curve& curve) {
  if (const auto* line = std::get_if<Polyline>(&curve.shape)) return line->closed;
  return std::get<Arc>(curve.shape).closed();
}

Point point(const Curve& curve, double s) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return arc->point(s / arc->length());
  const auto& line = std::get<Polyline>(curve.shape);
  return dobra::geom::point_at(line, dobra::geom::arc_lengths(line), s);
}

std::vector<double> corners(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return {0.0, arc->length()};
  return dobra::geom::arc_lengths(std::get<Polyline>(curve.shape));
}

double longest_piece(const Curve& curve, Angle turn) {
  if (const auto* arc = std::get_if<Arc>(&curve.shape)) return arc->radius() * turn.radians() * (1.0 + same_node);
  return std::numeric_limits<double>::infinity();
}

Trace trace(const Curve& curve, Angle turn) {
  if (const auto* line = std::get_if<Polyline>(&curve.shape)) return {*line, dobra::geom::arc_lengths(*line)};
  const Arc& arc = std::get<Arc>(curve.shape);
  // Cannot fail: an Arc has a positive length, no corner, and the angle is positive.
  auto pieces = dobra::geom::discretise(arc, {.max_angle = turn}).value();
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
  if (said.segments == 0) own = std::min(own, longest_piece(curve, options.turn));

  for (const double s : corners(curve)) stops.push_back({s, 0.0});
  std::stable_sort(stops.begin(), stops.end(), before);
  const SizeAlong size(own, stops, options.growth);

  std::vector<double> nodes;
  const bool one_piece = stops.size() == 2;
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
  return nodes;
}

}  // namespace quebra::core
