#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/gis/geojson.h"
#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Polyline;

namespace {

std::string string_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Point k of a part, with its height where it has one.
void append_point(std::string& text, const lines::Feature& feature, std::size_t part, std::size_t k) {
  text += '[';
  base::append_number(text, feature.parts[part].points[k].x);
  text += ',';
  base::append_number(text, feature.parts[part].points[k].y);
  if (!feature.heights.empty()) text += ',', base::append_number(text, feature.heights[part][k]);
  text += ']';
}

std::string points_text(const lines::Feature& feature, std::size_t part) {
  const Polyline& line = feature.parts[part];
  std::string text = "[";
  for (std::size_t k = 0; k < line.points.size(); ++k) {
    if (k > 0) text += ',';
    append_point(text, feature, part, k);
  }
  if (line.closed && !line.points.empty()) text += ',', append_point(text, feature, part, 0);
  return text + ']';
}

std::string parts_text(const lines::Feature& feature, std::size_t first, std::size_t last) {
  std::string text = "[";
  for (std::size_t i = first; i < last; ++i) text += (i > first ? "," : "") + points_text(feature, i);
  return text + ']';
}

std::string geometry_text(const lines::Feature& feature) {
  const auto object = [](std::string_view type, const std::string& coordinates) {
    return fmt::format(R"({{"type":"{}","coordinates":{}}})", type, coordinates);
  };
  if (feature.parts.empty() || feature.parts[0].points.empty()) return "null";
  const std::size_t count = feature.parts.size();
  if (feature.type == lines::FeatureType::Points) {
    if (feature.parts[0].points.size() > 1) return object("MultiPoint", points_text(feature, 0));
    std::string point;
    append_point(point, feature, 0, 0);
    return object("Point", point);
  }
  if (feature.type == lines::FeatureType::Lines) {
    return count == 1 ? object("LineString", points_text(feature, 0))
                      : object("MultiLineString", parts_text(feature, 0, count));
  }
  const auto polygons = lines::polygons_of(feature);
  if (polygons.size() == 1) return object("Polygon", parts_text(feature, 0, count));
  std::string text;
  for (const auto& [first, last] : polygons) text += (text.empty() ? "" : ",") + parts_text(feature, first, last);
  return object("MultiPolygon", '[' + text + ']');
}

std::string value_text(const lines::PropertyValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return string_text(*text);
  if (const auto* number = std::get_if<double>(&value)) return base::number_text(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
  return std::get<bool>(value) ? "true" : "false";
}

Result<std::string> properties_text(const lines::Feature& feature) {
  std::string text = "{";
  const auto add = [&](const std::string& key, const std::string& value) {
    text += (text.size() > 1 ? "," : "") + string_text(key) + ':' + value;
  };
  if (!feature.name.empty()) add("name", string_text(feature.name));
  if (!feature.kind.empty()) add("kind", string_text(feature.kind));
  for (const auto& [key, value] : feature.properties) {
    const auto* number = std::get_if<double>(&value);
    if (number != nullptr && !std::isfinite(*number)) {
      return Error{ErrorCode::NotFinite, fmt::format("property {} is not finite and cannot be written", shown(key))};
    }
    add(key, value_text(value));
  }
  return text + '}';
}

}  // namespace

Result<std::string> geojson(std::span<const lines::Feature> features, const lines::ReferenceSystem* system) {
  std::string text = "{\"type\":\"FeatureCollection\",";
  if (const std::size_t colon = system == nullptr ? std::string::npos : system->code.find(':');
      colon != std::string::npos) {
    const std::string urn = "urn:ogc:def:crs:" + system->code.substr(0, colon) + "::" + system->code.substr(colon + 1);
    text += fmt::format(R"("crs":{{"type":"name","properties":{{"name":{}}}}},)", string_text(urn));
  }
  text += "\"features\":[";
  for (std::size_t i = 0; i < features.size(); ++i) {
    const std::string item = fmt::format("feature {} {}", i + 1, shown(features[i].name));
    for (const Polyline& part : features[i].parts) DOBRA_TRY_VOID(check_finite(part.points, item));
    auto properties = properties_text(features[i]);
    if (!properties) return base::located(properties.error(), base::Place{.item = item});
    text += fmt::format("{}\n{{\"type\":\"Feature\",\"properties\":{},\"geometry\":{}}}", i > 0 ? "," : "", *properties,
                        geometry_text(features[i]));
  }
  return text + "\n]}\n";
}

Result<void> write_geojson(const std::string& path, std::span<const lines::Feature> features) {
  return write_text(path, geojson(features));
}

}  // namespace dobra::io::gis
