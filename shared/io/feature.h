#pragma once
// Named geometry as the exchange formats (GeoJSON, WKT) carry it.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::io {

enum class FeatureType { Points, Lines, Polygons };

using PropertyValue = std::variant<bool, std::int64_t, double, std::string>;

/// One feature: coordinates are those of the section or the domain (x right, y up), never longitude and latitude.
struct Feature {
  FeatureType type = FeatureType::Lines;
  /// Points: one part that holds them all. Lines: open parts. Polygons: closed parts, each anticlockwise contour
  /// followed by its clockwise holes.
  std::vector<geom::Polyline> parts = {};
  std::string name = {};  ///< Property "name"; empty if there is none.
  std::string kind = {};  ///< Property "kind", such as "horizon" or "fault"; empty if there is none.
  std::vector<std::pair<std::string, PropertyValue>> properties = {};  ///< The others, in file order.
  friend bool operator==(const Feature&, const Feature&) = default;
};

struct Features {
  std::vector<Feature> features;
  std::vector<std::string> remarks;  ///< What was changed or left out on reading, one line each.
};

/// Cleans what a file gave: drops repeated points, closes polygons without their repeated first point, turns contours
/// anticlockwise and holes (every ring of a polygon but its first) clockwise.
/// @param ring_of_polygon  for Polygons: for each part its number within its polygon (0 = outer contour).
/// @return                 number of repeated points dropped.
/// @error                  NotFinite, DegenerateCurve with the place.
base::Result<std::size_t> normalise(Feature& feature, const std::vector<std::size_t>& ring_of_polygon);

/// Parts of a Polygons feature grouped into polygons, each [first, last): an anticlockwise part starts a new one.
std::vector<std::pair<std::size_t, std::size_t>> polygons_of(const Feature& feature);

}  // namespace dobra::io
