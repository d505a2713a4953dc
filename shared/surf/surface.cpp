#include "shared/surf/surface.h"

#include <algorithm>
#include <cmath>

namespace dobra::surf {

using geom::Box;
using geom::Point;
using geom::Point3;

namespace {

constexpr std::size_t samples = 33;  ///< Along a side.

void cut_to(std::vector<double>& breaks, double low, double high) {
  std::erase_if(breaks, [&](double at) { return !(at > low && at < high); });
  breaks.insert(breaks.begin(), low);
  breaks.push_back(high);
}

/// The breaks at which the tangents of both sides differ, with the ends of the range.
std::vector<double> kinks_of(const Surface& surface, bool of_u) {
  constexpr int places = 17;
  const Box& chart = surface.chart();
  const std::vector<double>& breaks = of_u ? surface.breaks().u : surface.breaks().v;
  const double range = of_u ? chart.width() : chart.height();
  std::vector<double> found{breaks.front()};
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i) {
    const double at = breaks[i], before = std::nextafter(at, breaks.front());
    bool jumps = false;
    for (int k = 0; k < places && !jumps; ++k) {
      const double part = (k + 0.5) / places;
      const double other =
          of_u ? std::lerp(chart.low.y, chart.high.y, part) : std::lerp(chart.low.x, chart.high.x, part);
      const Jet left = surface.jet(of_u ? Point{before, other} : Point{other, before});
      const Jet right = surface.jet(of_u ? Point{at, other} : Point{other, at});
      const geom::Vector3 jump = of_u ? right.u - left.u : right.v - left.v;
      jumps = geom::length(jump) * range > 1e-9 * surface.size();
    }
    if (jumps) found.push_back(at);
  }
  found.push_back(breaks.back());
  return found;
}

}  // namespace

base::Result<Surface> Surface::make(std::shared_ptr<const Shape> shape, const Box& chart, Breaks inside) {
  if (!geom::is_finite(chart.low) || !geom::is_finite(chart.high))
    return base::Error{base::ErrorCode::NotFinite, "the chart of the surface is not finite"};
  if (!(chart.low.x < chart.high.x && chart.low.y < chart.high.y))
    return base::Error{base::ErrorCode::InvalidOption,
                       "the chart of the surface is empty; give each range a beginning "
                       "below its end"};
  cut_to(inside.u, chart.low.x, chart.high.x);
  cut_to(inside.v, chart.low.y, chart.high.y);
  return Surface(std::move(shape), chart, std::move(inside));
}

Surface::Surface(std::shared_ptr<const Shape> shape, const Box& chart, Breaks breaks)
    : shape_(std::move(shape)), chart_(chart), breaks_(std::move(breaks)) {
  // A grid of points, of which the borders tell what is one point and what meets.
  std::vector<Point> uv;
  for (std::size_t i = 0; i < samples; ++i) {
    for (std::size_t j = 0; j < samples; ++j) {
      const double s = static_cast<double>(i) / (samples - 1), t = static_cast<double>(j) / (samples - 1);
      uv.push_back({(1.0 - s) * chart.low.x + s * chart.high.x, (1.0 - t) * chart.low.y + t * chart.high.y});
    }
  }
  std::vector<Jet> grid(uv.size());
  jets(uv, grid);
  Point3 low = grid[0].at, high = grid[0].at;
  for (const Jet& jet : grid) {
    low = {std::min(low.x, jet.at.x), std::min(low.y, jet.at.y), std::min(low.z, jet.at.z)};
    high = {std::max(high.x, jet.at.x), std::max(high.y, jet.at.y), std::max(high.z, jet.at.z)};
  }
  size_ = geom::distance(low, high);
  const double same = 1e-12 * size_;
  const auto at = [&](std::size_t i, std::size_t j) { return grid[i * samples + j].at; };
  collapsed_.fill(true);
  closed_u_ = closed_v_ = true;
  constexpr std::size_t last = samples - 1;
  for (std::size_t k = 0; k < samples; ++k) {
    const auto stays = [&](Side side, Point3 first, Point3 now) {
      if (geom::distance(first, now) > same) collapsed_[static_cast<std::size_t>(side)] = false;
    };
    stays(Side::Left, at(0, 0), at(0, k));
    stays(Side::Right, at(last, 0), at(last, k));
    stays(Side::Bottom, at(0, 0), at(k, 0));
    stays(Side::Top, at(0, last), at(k, last));
    if (geom::distance(at(0, k), at(last, k)) > same) closed_u_ = false;
    if (geom::distance(at(k, 0), at(k, last)) > same) closed_v_ = false;
  }
  kinks_ = {kinks_of(*this, true), kinks_of(*this, false)};
}

bool Surface::in_pole(Point uv) const {
  return (uv.x == chart_.low.x && collapsed(Side::Left)) || (uv.x == chart_.high.x && collapsed(Side::Right)) ||
         (uv.y == chart_.low.y && collapsed(Side::Bottom)) || (uv.y == chart_.high.y && collapsed(Side::Top));
}

}  // namespace dobra::surf
