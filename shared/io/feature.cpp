#include "shared/io/feature.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Polyline;

Result<std::size_t> normalise(Feature& feature, const std::vector<std::size_t>& ring_of_polygon) {
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
      return Error{ErrorCode::DegenerateCurve, "a polygon has no area; correct or remove it",
                   Place{.x = part.points[0].x, .y = part.points[0].y}};
    }
    if ((area > 0.0) != (ring_of_polygon[i] == 0)) part = geom::reversed(std::move(part));
  }
  return dropped;
}

std::vector<std::pair<std::size_t, std::size_t>> polygons_of(const Feature& feature) {
  std::vector<std::pair<std::size_t, std::size_t>> polygons;
  for (std::size_t i = 0; i < feature.parts.size(); ++i) {
    if (polygons.empty() || geom::signed_area(feature.parts[i]) > 0.0) polygons.emplace_back(i, i);
    polygons.back().second = i + 1;
  }
  return polygons;
}

}  // namespace dobra::io
