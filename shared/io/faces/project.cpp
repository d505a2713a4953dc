#include "shared/io/faces/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/closest.h"

namespace dobra::io::faces {

using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

/// A plane's parameters are an affine map of space.
Piece on_plane(const surf::Surface& plane, Piece piece) {
  const surf::Jet jet = plane.jet({0.0, 0.0});
  // By the dual axes, for axes that a placement has scaled or skewed.
  const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v), d = e * g - f * f;
  const Vector3 a = (g / d) * jet.u - (f / d) * jet.v, b = (e / d) * jet.v - (f / d) * jet.u;
  const Vector3 from = Point3{} - jet.at;
  piece.curve =
      piece.space->moved({a.x, b.x, 0.0}, {a.y, b.y, 0.0}, {a.z, b.z, 0.0}, {dot(from, a), dot(from, b), 0.0});
  return piece;
}

struct Place {
  Point uv;
  geom::Vector slope;  ///< By the parameter of the curve.
};

/// Places at equal steps of the parameter, each sought from the one before.
std::vector<Place> places_of(const WholeSurface& whole, const surf::Surface& surface, const surf::Curve& space,
                             std::size_t count) {
  std::vector<Place> places;
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = std::lerp(space.low(), space.high(), static_cast<double>(i) / static_cast<double>(count));
    const surf::Curve::Jet on = space.jet(t);
    surf::Foot foot;
    if (!places.empty()) {
      foot = surf::closest(surface, on.at, places.back().uv);
    } else if (const auto near = whole.place_of ? whole.place_of(on.at) : std::nullopt) {
      foot = surf::closest(surface, on.at, *near);
    } else {
      foot = surf::closest_of_all(surface, on.at);
    }
    Point uv = foot.uv;
    if (!places.empty()) {  // on from the last place, over a seam
      const Point last = places.back().uv;
      if (whole.period_u > 0.0) uv.x += std::round((last.x - uv.x) / whole.period_u) * whole.period_u;
      if (whole.period_v > 0.0) uv.y += std::round((last.y - uv.y) / whole.period_v) * whole.period_v;
    }
    const surf::Jet jet = surface.jet(foot.uv);
    const double e = dot(jet.u, jet.u), f = dot(jet.u, jet.v), g = dot(jet.v, jet.v), d = e * g - f * f;
    const double p = dot(on.first, jet.u), q = dot(on.first, jet.v);
    const bool regular = d > 1e-18 * e * g;
    places.push_back({uv, regular ? geom::Vector{(g * p - f * q) / d, (e * q - f * p) / d} : geom::Vector{}});
  }
  return places;
}

/// The cubic spline with these places and slopes.
base::Result<surf::Curve> through(const std::vector<Place>& places, double low, double high) {
  const std::size_t count = places.size() - 1;
  const double step = (high - low) / static_cast<double>(count);
  std::vector<double> knots(4, low);
  std::vector<Point3> points{{places[0].uv.x, places[0].uv.y, 0.0}};
  for (std::size_t i = 0; i < count; ++i) {
    const Place &a = places[i], &b = places[i + 1];
    const Point first = a.uv + (step / 3.0) * a.slope, second = b.uv - (step / 3.0) * b.slope;
    points.push_back({first.x, first.y, 0.0});
    points.push_back({second.x, second.y, 0.0});
    if (i + 1 < count) {
      const double at = std::lerp(low, high, static_cast<double>(i + 1) / static_cast<double>(count));
      knots.insert(knots.end(), 2, at);
    }
  }
  points.push_back({places.back().uv.x, places.back().uv.y, 0.0});
  knots.insert(knots.end(), 4, high);
  return surf::Curve::nurbs(3, std::move(knots), std::move(points));
}

}  // namespace

Outcome<Piece> projected(const WholeSurface& whole, const surf::Surface& surface, const Piece& piece, double diagonal,
                         const ImportOptions& options, Report& report) {
  if (whole.flat) return on_plane(surface, piece);
  Piece made = piece;
  const surf::Curve& space = *piece.space;
  double gap = 0.0;
  Point worst{};
  for (std::size_t count = 16; count <= 256; count *= 2) {
    const auto curve = through(places_of(whole, surface, space, count), space.low(), space.high());
    if (!curve)
      return Refusal{"face_curve", fmt::format("{} cannot be projected: {}", piece.name, curve.error().message)};
    made.curve = *curve;
    gap = 0.0;
    for (std::size_t i = 0; i < 4 * count; ++i) {
      const double t =
          std::lerp(space.low(), space.high(), (static_cast<double>(i) + 0.5) / (4.0 * static_cast<double>(count)));
      const double by = distance(surface.at(made.at(t)), space.at(t));
      if (by > gap) gap = by, worst = made.at(t);
    }
    if (gap <= std::max(1e-8 * diagonal, 0.1 * piece.tolerance)) break;
  }
  if (gap > options.apart_part * diagonal)
    return Refusal{"face_apart",
                   fmt::format("{} has no curve in the chart, and its curve in space is {:.6g} m from the surface",
                               piece.name, gap),
                   worst, surface.at(worst)};
  report.say(
      "curve_projected",
      fmt::format("{} has no curve in the chart; projected to the surface, {:.6g} m away at most", piece.name, gap),
      worst, surface.at(worst));
  made.tolerance = std::max(made.tolerance, gap);
  return made;
}

}  // namespace dobra::io::faces
