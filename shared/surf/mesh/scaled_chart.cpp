#include "shared/surf/mesh/scaled_chart.h"

namespace dobra::surf::mesh {

using geom::Point;

namespace {

constexpr int samples = 33;

/// Length of an isoline as a polyline: enough for a scale.
double isoline(const Surface& surface, Point from, Point to) {
  double sum = 0.0;
  geom::Point3 last = surface.at(from);
  for (int i = 1; i < samples; ++i) {
    const geom::Point3 next = surface.at(geom::interpolate(from, to, static_cast<double>(i) / (samples - 1)));
    sum += geom::distance(last, next);
    last = next;
  }
  return sum;
}

/// Mean cosine of the angle between Su and Sv.
double mean_skew(const Surface& surface, const geom::Box& part) {
  constexpr int places = 5;
  double sum = 0.0;
  int counted = 0;
  for (int i = 0; i < places; ++i) {
    for (int j = 0; j < places; ++j) {
      const Metric m = metric(surface.jet(
          {part.low.x + (i + 0.5) / places * part.width(), part.low.y + (j + 0.5) / places * part.height()}));
      if (!(m.e > 0.0 && m.g > 0.0)) continue;
      sum += m.f / std::sqrt(m.e * m.g);
      ++counted;
    }
  }
  return counted == 0 ? 0.0 : sum / counted;
}

}  // namespace

ScaledChart::ScaledChart(const Surface& surface, const geom::Box& part) : surface_(&surface), origin_(part.low) {
  constexpr double noticed = 0.3;
  const Point middle = part.centre();
  const double along_u = isoline(surface, {part.low.x, middle.y}, {part.high.x, middle.y}) / part.width();
  const double along_v = isoline(surface, {middle.x, part.low.y}, {middle.x, part.high.y}) / part.height();
  if (!(along_u > 0.0 && along_v > 0.0 && std::isfinite(along_u) && std::isfinite(along_v))) return;
  a_ = along_u;
  d_ = along_v;
  const double skew = std::clamp(mean_skew(surface, part), -0.999, 0.999);
  if (!(std::abs(skew) > noticed)) return;
  b_ = skew * along_v;
  d_ = along_v * std::sqrt(1.0 - skew * skew);
}

}  // namespace dobra::surf::mesh
