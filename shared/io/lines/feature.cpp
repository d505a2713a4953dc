#include "shared/io/lines/feature.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/predicates.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Polyline;

namespace {

struct Normal {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

// Newell's normal of a closed ring, about its first point.
Normal normal_of(const Polyline& ring, const std::vector<double>& heights) {
  Normal n;
  if (ring.points.empty()) return n;
  const std::size_t count = ring.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = i + 1 == count ? 0 : i + 1;
    const geom::Vector a = ring.points[i] - ring.points[0];
    const geom::Vector b = ring.points[j] - ring.points[0];
    const double za = heights[i] - heights[0];
    const double zb = heights[j] - heights[0];
    n.x += a.y * zb - za * b.y;
    n.y += za * b.x - a.x * zb;
    n.z += a.x * b.y - a.y * b.x;
  }
  return n;
}

// Seen from the south, from the west where the plane runs from north to south, from above where it is level.
bool is_anticlockwise(const Normal& n) {
  const double level = std::hypot(n.x, n.y);
  if (level < std::abs(n.z)) return n.z > 0.0;
  if (std::abs(n.y) > 1e-9 * level) return n.y < 0.0;
  return n.x > 0.0;
}

// Drops points equal to their predecessor in all three coordinates, and the repeated first point of a ring.
std::size_t drop_repeated(Polyline& part, std::vector<double>& heights) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    if (kept > 0 && part.points[i] == part.points[kept - 1] && heights[i] == heights[kept - 1]) continue;
    part.points[kept] = part.points[i];
    heights[kept++] = heights[i];
  }
  while (part.closed && kept > 1 && part.points[kept - 1] == part.points[0] && heights[kept - 1] == heights[0]) --kept;
  const std::size_t dropped = part.points.size() - kept;
  part.points.resize(kept);
  heights.resize(kept);
  return dropped;
}

Result<std::size_t> normalise_3d(Feature& feature, const std::vector<std::size_t>& ring_of_polygon) {
  std::size_t dropped = 0;
  const bool polygons = feature.type == FeatureType::Polygons;
  for (std::size_t i = 0; i < feature.parts.size(); ++i) {
    Polyline& part = feature.parts[i];
    std::vector<double>& heights = feature.heights[i];
    for (std::size_t k = 0; k < part.points.size(); ++k) {
      if (geom::is_finite(part.points[k]) && std::isfinite(heights[k])) continue;
      return Error{ErrorCode::NotFinite, fmt::format("point {} is not finite; correct or remove it", k + 1)};
    }
    if (feature.type == FeatureType::Points) continue;
    // The repeated first point is the format's way to close a ring, not a mistake.
    const bool repeats =
        part.points.size() > 1 && part.points.front() == part.points.back() && heights.front() == heights.back();
    if (polygons && repeats) part.points.pop_back(), heights.pop_back();
    part.closed = polygons;
    dropped += drop_repeated(part, heights);
    const std::size_t needed = polygons ? 3 : 2;
    if (part.points.size() < needed) {
      Error error{ErrorCode::DegenerateCurve, fmt::format("a {} needs at least {} distinct points; this one has {}",
                                                          polygons ? "polygon" : "line", needed, part.points.size())};
      if (!part.points.empty()) error.place = Place{.x = part.points[0].x, .y = part.points[0].y};
      return error;
    }
    if (polygons && is_anticlockwise(normal_of(part, heights)) != (ring_of_polygon[i] == 0)) {
      std::reverse(part.points.begin(), part.points.end());
      std::reverse(heights.begin(), heights.end());
    }
  }
  return dropped;
}

/// All points on one line. @pre three points or more, the first two unlike.
bool is_flat(const Polyline& ring) {
  const std::vector<geom::Point>& p = ring.points;
  return std::all_of(p.begin() + 2, p.end(),
                     [&](geom::Point q) { return geom::orient2d(p[0], p[1], q) == geom::Sign::Zero; });
}

}  // namespace

Result<std::size_t> normalise(Feature& feature, const std::vector<std::size_t>& ring_of_polygon) {
  if (!feature.heights.empty()) return normalise_3d(feature, ring_of_polygon);
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < feature.parts.size(); ++i) {
    Polyline& part = feature.parts[i];
    if (feature.type == FeatureType::Points) {
      for (const geom::Point p : part.points) {
        if (!geom::is_finite(p)) return Error{ErrorCode::NotFinite, "a point is not finite; correct or remove it"};
      }
      continue;
    }
    if (feature.type == FeatureType::Polygons) {
      part.closed = true;
      // The repeated first point is the format's way to close a ring, not a mistake.
      if (part.points.size() > 1 && part.points.front() == part.points.back()) part.points.pop_back();
    }
    const std::size_t before = part.points.size();
    part = geom::without_repeated_points(std::move(part));
    dropped += before - part.points.size();
    DOBRA_TRY_VOID(geom::validate(part));
    if (feature.type != FeatureType::Polygons) continue;
    const double area = geom::signed_area(part);
    if (area == 0.0) {
      if (!is_flat(part)) continue;  // crosses itself: what reads it tells, or mends it
      return Error{ErrorCode::DegenerateCurve, "a polygon has no area; correct or remove it",
                   Place{.x = part.points[0].x, .y = part.points[0].y}};
    }
    if ((area > 0.0) != (ring_of_polygon[i] == 0)) part = geom::reversed(std::move(part));
  }
  return dropped;
}

Result<std::size_t> normalise_sound(Feature& feature, const std::vector<std::size_t>& ring_of_polygon,
                                    const std::string& where, std::vector<std::string>& remarks) {
  const std::vector<Polyline> parts = std::move(feature.parts);
  const std::vector<std::vector<double>> heights = std::move(feature.heights);
  feature.parts.clear();
  feature.heights.clear();
  std::size_t dropped = 0;
  bool contour_gone = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t ring = feature.type == FeatureType::Polygons ? ring_of_polygon[i] : 0;
    if (ring > 0 && contour_gone) continue;
    Feature one{.type = feature.type, .parts = {parts[i]}};
    if (!heights.empty()) one.heights = {heights[i]};
    const Result<std::size_t> repeated = normalise(one, {ring});
    if (!repeated && repeated.error().code != ErrorCode::DegenerateCurve) return repeated.error();
    if (ring == 0) contour_gone = !repeated;
    if (!repeated) {
      const std::string which = parts.size() > 1 ? fmt::format(": part {}", i + 1) : std::string{};
      remarks.push_back(fmt::format("{}{}: {}; left out", where, which, base::to_string(repeated.error())));
      continue;
    }
    dropped += *repeated;
    feature.parts.push_back(std::move(one.parts[0]));
    if (!heights.empty()) feature.heights.push_back(std::move(one.heights[0]));
  }
  return dropped;
}

std::string open_rings(const Feature& feature) {
  if (feature.type != FeatureType::Polygons) return {};
  std::vector<const Polyline*> open;
  for (const Polyline& ring : feature.parts) {
    if (!ring.points.empty() && ring.points.front() != ring.points.back()) open.push_back(&ring);
  }
  if (open.empty()) return {};
  const geom::Point from = open.front()->points.back();
  const geom::Point to = open.front()->points.front();
  const std::string count = open.size() == 1 ? "a ring does" : fmt::format("{} rings do", open.size());
  return fmt::format("{} not end at the first point; closed from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}){}", count, from.x,
                     from.y, to.x, to.y, open.size() == 1 ? "" : " and so on");
}

std::vector<std::size_t> rings_of(const Feature& feature) {
  std::vector<std::size_t> rings;
  for (std::size_t i = 0; i < feature.parts.size(); ++i) {
    rings.push_back(is_anticlockwise(normal_of(feature.parts[i], feature.heights[i])) ? 0 : 1);
  }
  return rings;
}

Result<void> drop_heights(Feature& feature) {
  if (feature.heights.empty()) return {};
  const std::vector<std::size_t> rings = rings_of(feature);
  feature.heights.clear();
  DOBRA_TRY_VOID(normalise(feature, rings));
  return {};
}

Result<void> drop_heights(Features& features, Faulty faulty) {
  for (Feature& feature : features.features) {
    if (feature.heights.empty()) continue;
    if (faulty == Faulty::Refuse) {
      if (auto dropped = drop_heights(feature); !dropped) return base::located(dropped.error(), feature.source);
      continue;
    }
    const std::vector<std::size_t> rings = rings_of(feature);
    feature.heights.clear();
    DOBRA_TRY_VOID(normalise_sound(feature, rings, where(feature.source), features.remarks));
  }
  if (faulty == Faulty::Skip) std::erase_if(features.features, [](const Feature& f) { return f.parts.empty(); });
  return {};
}

std::vector<std::pair<std::size_t, std::size_t>> polygons_of(const Feature& feature) {
  std::vector<std::pair<std::size_t, std::size_t>> polygons;
  const std::vector<std::size_t> rings = feature.heights.empty() ? std::vector<std::size_t>{} : rings_of(feature);
  for (std::size_t i = 0; i < feature.parts.size(); ++i) {
    const bool contour = rings.empty() ? geom::signed_area(feature.parts[i]) > 0.0 : rings[i] == 0;
    if (polygons.empty() || contour) polygons.emplace_back(i, i);
    polygons.back().second = i + 1;
  }
  return polygons;
}

std::vector<Feature> rings_apart(std::span<const Feature> features) {
  std::vector<Feature> apart;
  for (const Feature& feature : features) {
    if (feature.type != FeatureType::Polygons || feature.parts.size() < 2) {
      apart.push_back(feature);
      continue;
    }
    const bool map = !feature.heights.empty();
    const std::vector<std::size_t> rings = map ? rings_of(feature) : std::vector<std::size_t>{};
    for (std::size_t i = 0; i < feature.parts.size(); ++i) {
      Feature ring = feature;
      ring.parts = {feature.parts[i]};
      if (map) ring.heights = {feature.heights[i]};
      if (map ? rings[i] != 0 : geom::signed_area(feature.parts[i]) < 0.0) {
        ring.parts[0] = geom::reversed(std::move(ring.parts[0]));
        if (map) std::reverse(ring.heights[0].begin(), ring.heights[0].end());
      }
      apart.push_back(std::move(ring));
    }
  }
  return apart;
}

std::string where(const Place& place) {
  if (place.line > 0) return fmt::format("{}:{}", place.file, place.line);
  return place.item.empty() ? place.file : fmt::format("{}: {}", place.file, place.item);
}

std::string item_of(std::size_t number, const Feature& feature) {
  return feature.name.empty() ? fmt::format("feature {}", number)
                              : fmt::format("feature {} {}", number, shown(feature.name));
}

}  // namespace dobra::io::lines
