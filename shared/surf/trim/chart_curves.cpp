#include "shared/surf/trim/chart_curves.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf::trim {

using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

struct MovedShape : Curve::Shape {
  Curve curve;
  Vector3 by;
  MovedShape(const Curve& base, Vector3 way) : curve(base), by(way) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    Curve::Jet jet = curve.jet(t);
    jet.at = jet.at + by;
    return jet;
  }
  [[nodiscard]] double bend(double from, double to) const override { return curve.bend(from, to); }
};

struct EndsShape : Curve::Shape {
  Curve curve;
  double from, to;
  Vector3 at_start, at_end;
  EndsShape(const Curve& base, double begin, double end, Vector3 first, Vector3 last)
      : curve(base), from(begin), to(end), at_start(first), at_end(last) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    Curve::Jet jet = curve.jet(t);
    const double part = (t - from) / (to - from);
    jet.at = jet.at + ((1.0 - part) * at_start + part * at_end);
    jet.first = jet.first + (at_end - at_start) / (to - from);
    return jet;
  }
  [[nodiscard]] double bend(double a, double b) const override { return curve.bend(a, b); }
};

}  // namespace

Curve moved(const Curve& curve, Vector by) {
  return Curve::of(std::make_shared<const MovedShape>(curve, Vector3{by.x, by.y, 0.0}), curve.breaks());
}

Curve with_ends(const Curve& curve, double from, double to, Point start, Point end) {
  const geom::Point3 p = curve.at(from), q = curve.at(to);
  return Curve::of(std::make_shared<const EndsShape>(curve, from, to, Vector3{start.x - p.x, start.y - p.y, 0.0},
                                                     Vector3{end.x - q.x, end.y - q.y, 0.0}),
                   curve.breaks());
}

ChartEdge with_ends(const ChartEdge& edge, const geom::Box& chart, Point start, Point end, double rounding) {
  const auto off = [&](Point is, Point wanted) {
    const bool border =
        wanted.x == chart.low.x || wanted.x == chart.high.x || wanted.y == chart.low.y || wanted.y == chart.high.y;
    return std::max(std::abs(is.x - wanted.x) / chart.width(), std::abs(is.y - wanted.y) / chart.height()) >
           (border ? 0.0 : rounding);
  };
  ChartEdge made = edge;
  if (off(edge.start(), start) || off(edge.end(), end))
    made.curve = with_ends(edge.curve, edge.from, edge.to, start, end);
  return made;
}

geom::Point in_period(const Surface& surface, geom::Point uv) {
  const geom::Box& chart = surface.chart();
  const auto shifted = [](bool closed, double at, double low, double high) {
    return closed && (at < low || at > high) ? at - std::floor((at - low) / (high - low)) * (high - low) : at;
  };
  return {shifted(surface.closed_u(), uv.x, chart.low.x, chart.high.x),
          shifted(surface.closed_v(), uv.y, chart.low.y, chart.high.y)};
}

ChartEdge straight(Point from, Point to, const std::string& name) {
  return {.curve = *Curve::line({from.x, from.y, 0.0}, {to.x, to.y, 0.0}), .name = name};
}

}  // namespace dobra::surf::trim
