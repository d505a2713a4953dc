#include "shared/surf/mesh/edge_in_space.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "shared/surf/details.h"

namespace dobra::surf::mesh {

using geom::Point3;
using geom::Vector3;

namespace {

using Rule = boost::math::quadrature::gauss<double, 7>;

/// Marks of a span between breaks: few where there are many spans, as in a line of a thousand corners.
std::size_t marks_of_span(std::size_t spans) { return std::clamp<std::size_t>(256 / spans, 2, 64); }

/// The marks, and between them the places where an edge passes a kink of its surface: there its tangent jumps.
template <class Place>
std::vector<double> with_kinks(const Surface& surface, const Place& place, const std::vector<double>& marks) {
  const Breaks& kinks = surface.kinks();
  std::vector<double> made;
  for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
    made.push_back(marks[i]);
    const auto pass = [&](const std::vector<double>& lines, const auto& coordinate) {
      if (lines.size() <= 2) return;  // the ends of the chart
      const double from = coordinate(place(marks[i])), to = coordinate(place(marks[i + 1]));
      const auto first = std::upper_bound(lines.begin() + 1, lines.end() - 1, std::min(from, to));
      for (auto line = first; line != lines.end() - 1 && *line < std::max(from, to); ++line) {
        double before = marks[i], after = marks[i + 1];
        for (double s = std::midpoint(before, after); s > before && s < after; s = std::midpoint(before, after))
          ((coordinate(place(s)) < *line) == (from < *line) ? before : after) = s;
        if (before > marks[i]) made.push_back(before);
      }
    };
    pass(kinks.u, [](geom::Point p) { return p.x; });
    pass(kinks.v, [](geom::Point p) { return p.y; });
    std::sort(made.begin(), made.end());
  }
  made.push_back(marks.back());
  made.erase(std::unique(made.begin(), made.end()), made.end());
  return made;
}

}  // namespace

EdgeInSpace::EdgeInSpace(Surface surface, trim::ChartEdge edge) : surface_(std::move(surface)), edge_(std::move(edge)) {
  const double range = edge_.to - edge_.from;
  std::vector<double> ends{0.0, 1.0};
  for (const double t : edge_.curve.breaks()) {
    const double s = (t - edge_.from) / range;
    constexpr double beside = 1e-9;  // of the edge: a break there is its end
    if (s > beside && s < 1.0 - beside) {
      breaks_.push_back(s);
      ends.push_back(s);
    }
  }
  std::sort(breaks_.begin(), breaks_.end());
  std::sort(ends.begin(), ends.end());
  const std::size_t parts = marks_of_span(ends.size() - 1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (std::size_t k = 0; k < parts; ++k) {
      marks_.push_back(std::lerp(ends[i], ends[i + 1], static_cast<double>(k) / static_cast<double>(parts)));
    }
  }
  marks_.push_back(1.0);
  const auto at_place = [&](double s) { return place(s); };
  marks_ = seen_along(surface_, at_place, with_kinks(surface_, at_place, marks_));
  travelled_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < marks_.size(); ++i) {
    const auto rate = [&](double s) { return speed(s); };
    travelled_.push_back(travelled_.back() + Rule::integrate(rate, marks_[i], marks_[i + 1]));
  }
}

EdgeInSpace::Jet EdgeInSpace::jet(double s) const {
  const double range = edge_.to - edge_.from;
  const Curve::Jet c = edge_.curve.jet(parameter(s));
  const surf::Jet p = surface_.jet({c.at.x, c.at.y});
  const double du = range * c.first.x, dv = range * c.first.y;
  const double ddu = range * range * c.second.x, ddv = range * range * c.second.y;
  return {p.at, du * p.u + dv * p.v, du * du * p.uu + 2.0 * du * dv * p.uv + dv * dv * p.vv + ddu * p.u + ddv * p.v};
}

double EdgeInSpace::travelled(double s) const {
  if (s >= 1.0) return travelled_.back();
  const auto above = std::upper_bound(marks_.begin(), marks_.end(), std::max(s, 0.0));
  const auto i = static_cast<std::size_t>(above - marks_.begin()) - 1;
  const auto rate = [&](double at) { return speed(at); };
  return travelled_[i] + (s > marks_[i] ? Rule::integrate(rate, marks_[i], s) : 0.0);
}

double EdgeInSpace::parameter_at(double length) const {
  if (!(length > 0.0)) return 0.0;
  if (length >= travelled_.back()) return 1.0;
  const auto above = std::upper_bound(travelled_.begin(), travelled_.end(), length);
  const auto i = static_cast<std::size_t>(above - travelled_.begin()) - 1;
  double low = marks_[i], high = marks_[i + 1];
  double s = std::lerp(low, high, (length - travelled_[i]) / (travelled_[i + 1] - travelled_[i]));
  for (int step = 0; step < 20; ++step) {
    const double excess = travelled(s) - length;
    const double rate = speed(s);
    if (std::abs(excess) <= 1e-15 * rate) break;
    (excess > 0.0 ? high : low) = s;
    const double next = rate > 0.0 ? s - excess / rate : 0.5 * (low + high);
    const double inside = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(inside - s) <= 1e-14) break;
    s = inside;
  }
  return s;
}

double EdgeInSpace::next_to(Point3 point, double near, double low, double high) const {
  double s = std::clamp(near, low, high);
  double best = geom::distance(at(s), point);
  for (int step = 0; step < 30; ++step) {
    const Jet here = jet(s);
    const Vector3 to = point - here.at;
    const double square = dot(here.first, here.first);
    if (!(square > 0.0)) break;
    const double curved = square - dot(here.second, to);  // Newton's where that goes downhill
    double move = dot(to, here.first) / (curved > 0.1 * square ? curved : square);
    double next = s, distance = best;
    for (int half = 0; half < 10; ++half, move *= 0.5) {
      next = std::clamp(s + move, low, high);
      distance = geom::distance(at(next), point);
      if (distance <= best) break;
    }
    if (distance > best || next == s) break;
    const bool still = std::abs(next - s) <= 1e-15;
    s = next;
    best = distance;
    if (still) break;
  }
  return s;
}

double EdgeInSpace::turn_at(double s) const {
  constexpr double step = 1e-7;
  const Vector3 before = jet(std::max(0.0, s - step)).first, after = jet(std::min(1.0, s + step)).first;
  return std::atan2(geom::length(cross(before, after)), dot(before, after));
}

geom::SpaceCurveFunctions EdgeInSpace::functions(double s0, double s1) const {
  const auto s = [s0, s1](double t) { return (1.0 - t) * s0 + t * s1; };
  // The tangents at its ends are its own, though a corner be there.
  const auto own = [s](double t) {
    constexpr double inside = 1e-7;
    return s(std::clamp(t, inside, 1.0 - inside));
  };
  return {[this, s](double t) { return at(s(t)); }, [this, own](double t) { return jet(own(t)).first; },
          [this, s](double from, double to) { return length(s(from), s(to)); }};
}

}  // namespace dobra::surf::mesh
