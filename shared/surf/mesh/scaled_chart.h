#pragma once
// The chart of a surface, made alike its image in space: scaled along u and v by the lengths of the isolines through
// the middle, and sheared where u and v are far from right angles in space. Meshers work there. Source:
// [miranda2009surface], equations 6 and 7.

#include <cmath>

#include "shared/surf/measure.h"

namespace dobra::surf::mesh {

/// x = a (u - u0) + b (v - v0), y = d (v - v0).
class ScaledChart {
 public:
  ScaledChart() = default;
  /// @param part  of the chart, in which there is something to mesh.  @pre width and height are positive
  ScaledChart(const Surface& surface, const geom::Box& part);

  [[nodiscard]] const Surface& surface() const { return *surface_; }
  [[nodiscard]] geom::Point scaled(geom::Point uv) const {
    const geom::Vector by = uv - origin_;
    return {a_ * by.x + b_ * by.y, d_ * by.y};
  }
  [[nodiscard]] geom::Point unscaled(geom::Point p) const {
    const double y = p.y / d_;
    return {origin_.x + (p.x - b_ * y) / a_, origin_.y + y};
  }
  /// The nearest place (u, v) of the surface.
  [[nodiscard]] geom::Point held(geom::Point p) const {
    const geom::Box& chart = surface_->chart();
    const geom::Point uv = unscaled(p);
    return {std::clamp(uv.x, chart.low.x, chart.high.x), std::clamp(uv.y, chart.low.y, chart.high.y)};
  }
  /// Whether 3 x 3 places of a part of the scaled chart tell how the surface bends there.
  [[nodiscard]] bool seen(const geom::Box& part) const {
    geom::Box of;
    for (const geom::Point p :
         {part.low, geom::Point{part.high.x, part.low.y}, geom::Point{part.low.x, part.high.y}, part.high})
      of.add(held(p));
    return surface_->seen(of);
  }
  /// Derivatives by x and y. @param p  in the scaled chart; the nearest place of the chart of the surface is taken.
  [[nodiscard]] Jet jet(geom::Point p) const {
    Jet jet = surface_->jet(held(p));
    const double skew = b_ / a_;
    const geom::Vector3 v = (1.0 / d_) * (jet.v - skew * jet.u);
    const geom::Vector3 vv = (1.0 / (d_ * d_)) * (jet.vv - 2.0 * skew * jet.uv + skew * skew * jet.uu);
    const geom::Vector3 uv2 = (1.0 / (a_ * d_)) * (jet.uv - skew * jet.uu);
    return {jet.at, (1.0 / a_) * jet.u, v, (1.0 / (a_ * a_)) * jet.uu, uv2, vv};
  }
  /// Whether the surface has a place there, but for rounding.
  [[nodiscard]] bool holds(geom::Point p) const {
    const geom::Box& chart = surface_->chart();
    const geom::Point uv = unscaled(p);
    const double u = 1e-9 * chart.width(), v = 1e-9 * chart.height();
    return uv.x >= chart.low.x - u && uv.x <= chart.high.x + u && uv.y >= chart.low.y - v && uv.y <= chart.high.y + v;
  }

 private:
  const Surface* surface_ = nullptr;
  geom::Point origin_;
  double a_ = 1.0, b_ = 0.0, d_ = 1.0;
};

}  // namespace dobra::surf::mesh
