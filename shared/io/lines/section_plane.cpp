#include "shared/io/lines/section_plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Vector;

namespace {

template <class Visitor>
void for_each_point(const std::vector<Feature>& features, Visitor&& visit) {
  for (const Feature& feature : features) {
    for (const geom::Polyline& part : feature.parts) {
      for (const Point p : part.points) visit(p);
    }
  }
}

// Eastwards; northwards where there is no east in it.
Vector canonical(Vector direction) {
  const bool back = direction.x < 0.0 || (direction.x == 0.0 && direction.y < 0.0);
  return back ? -direction : direction;
}

}  // namespace

Result<Trace> fit_trace(const std::vector<Feature>& features) {
  geom::Box box;
  double count = 0.0;
  Vector sum;
  for_each_point(features, [&](Point p) { box.add(p), count += 1.0; });
  if (count == 0.0 || (box.width() == 0.0 && box.height() == 0.0)) {
    return Error{ErrorCode::BadFormat, "all points stand over one place on the map: no section plane can be found"};
  }
  // An axis is kept exactly, so that such files come back as they were.
  if (box.height() == 0.0) return Trace{0.0, box.low.y, 1.0, 0.0};
  if (box.width() == 0.0) return Trace{box.low.x, 0.0, 0.0, 1.0};
  const Point middle = box.centre();  // sums about it do not lose digits to large map coordinates
  for_each_point(features, [&](Point p) { sum = sum + (p - middle); });
  const Point mean = middle + sum / count;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for_each_point(features, [&](Point p) {
    const Vector v = p - mean;
    xx += v.x * v.x;
    xy += v.x * v.y;
    yy += v.y * v.y;
  });
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Vector along = canonical({std::cos(angle), std::sin(angle)});
  double first = 0.0;
  for_each_point(features, [&](Point p) { first = std::min(first, geom::dot(p - mean, along)); });
  const Point origin = mean + first * along;
  return with_misfit({origin.x, origin.y, along.x, along.y}, features);
}

Result<Trace> trace_between(Point from, Point to) {
  const double length = geom::distance(from, to);
  if (!(length > 0.0) || !std::isfinite(length)) {
    return Error{ErrorCode::InvalidOption, "the trace begins and ends at one place; give two different ones"};
  }
  const Vector along = (to - from) / length;
  return Trace{from.x, from.y, along.x, along.y};
}

Trace with_misfit(Trace trace, const std::vector<Feature>& features) {
  double count = 0.0;
  double squares = 0.0;
  trace.largest_misfit = 0.0;
  for_each_point(features, [&](Point p) {
    const double off = std::abs(geom::cross({trace.east, trace.north}, p - Point{trace.x, trace.y}));
    trace.largest_misfit = std::max(trace.largest_misfit, off);
    squares += off * off;
    count += 1.0;
  });
  trace.mean_misfit = count > 0.0 ? std::sqrt(squares / count) : 0.0;
  return trace;
}

double length_along(const Trace& trace, const std::vector<Feature>& features) {
  geom::Box along;
  for_each_point(features, [&](Point p) {
    along.add(Point{geom::dot({trace.east, trace.north}, p - Point{trace.x, trace.y}), 0.0});
  });
  return along.width();
}

namespace {

/// Puts every point where `place` says, by its place on the map and its height.
template <class Place>
Result<void> lay_each(std::vector<Feature>& features, const Place& place) {
  for (std::size_t k = 0; k < features.size(); ++k) {
    Feature& feature = features[k];
    const std::vector<std::size_t> rings = rings_of(feature);
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      for (std::size_t j = 0; j < feature.parts[i].points.size(); ++j) {
        Point& p = feature.parts[i].points[j];
        p = place(p, feature.heights[i][j]);
      }
    }
    feature.heights.clear();
    if (auto laid = normalise(feature, rings); !laid) {
      return base::located(base::located(laid.error(), feature.source), base::Place{.item = item_of(k + 1, feature)});
    }
  }
  return {};
}

}  // namespace

Result<void> lay_into_plane(std::vector<Feature>& features, const Trace& trace) {
  const Vector along{trace.east, trace.north};
  return lay_each(features, [&](Point p, double height) {
    return Point{geom::dot(p - Point{trace.x, trace.y}, along), height};
  });
}

Result<void> project_along(std::vector<Feature>& features, const FoldAxis& axis) {
  const double trend = axis.trend.radians();
  const double plunge = axis.plunge.radians();
  // Unit vectors of the plane (east, north, up): across the axis on the level, and across both.
  const Vector level{std::cos(trend), -std::sin(trend)};
  const Vector rise{std::sin(plunge) * std::sin(trend), std::sin(plunge) * std::cos(trend)};
  const double upwards = std::cos(plunge);
  return lay_each(features, [&](Point p, double height) {
    const Vector place = p - Point{};
    return Point{geom::dot(place, level), geom::dot(place, rise) + upwards * height};
  });
}

std::pair<std::string, std::string> ends_of(base::Angle azimuth) {
  static constexpr std::array<const char*, 16> points{"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                      "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  const auto sixteenth = static_cast<long>(std::lround(azimuth.degrees() / 22.5));
  const auto towards = static_cast<std::size_t>((sixteenth % 16 + 16) % 16);
  return {points[(towards + 8) % 16], points[towards]};
}

base::Angle azimuth_of(const Trace& trace) { return base::Angle::from_radians(std::atan2(trace.east, trace.north)); }

base::Angle azimuth_of(const FoldAxis& axis) { return axis.trend + base::Angle::from_degrees(90.0); }

std::vector<Feature> out_of_plane(std::vector<Feature> features, const Trace& trace) {
  for (Feature& feature : features) {
    feature.heights.clear();
    for (geom::Polyline& part : feature.parts) {
      std::vector<double>& heights = feature.heights.emplace_back();
      for (Point& p : part.points) {
        heights.push_back(p.y);
        p = {trace.x + p.x * trace.east, trace.y + p.x * trace.north};
      }
    }
  }
  return features;
}

}  // namespace dobra::io::lines
