// 1. A strict JSON pass finds syntax errors with their line and column (GDAL is lenient and tells neither).
// 2. GDAL/OGR reads the features from memory, its messages collected instead of printed.
// 3. Each OGR feature becomes a Feature; anything GDAL reported as a failure on the way is our error.

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>

#include "shared/io/file.h"
#include "shared/io/gdal.h"
#include "shared/io/geojson.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Polyline;

namespace {

// Walks the JSON without keeping it and remembers the first error.
struct SyntaxCheck : nlohmann::json_sax<nlohmann::json> {
  explicit SyntaxCheck(std::size_t text_size) : size(text_size) {}
  std::size_t size;
  std::size_t offset = 0;  // of the word that offends
  bool at_end = false;
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception&) override {
    // A number out of range is refused behind its last digit; the place is its first one.
    const bool number = last_token.find_first_not_of("0123456789+-.eE") == std::string::npos;
    offset = position - std::min(position, number ? last_token.size() : 1);
    at_end = position > size;
    return false;
  }
};

Result<void> check_syntax(std::string_view text, const std::string& file) {
  SyntaxCheck check(text.size());
  if (nlohmann::json::sax_parse(text.begin(), text.end(), &check)) return {};
  const Place place = place_of_byte(text, check.at_end ? text.size() : check.offset, file);
  if (check.at_end) {
    return Error{ErrorCode::BadFormat, "not valid JSON: the file ends too early; it may have been cut short", place};
  }
  return Error{ErrorCode::BadFormat,
               fmt::format("not valid JSON at {}; correct the file",
                           shown(text.substr(check.offset, text.find_first_of("\r\n", check.offset) - check.offset))),
               place};
}

Polyline polyline_of(const OGRSimpleCurve& curve) {
  Polyline part;
  part.points.reserve(static_cast<std::size_t>(curve.getNumPoints()));
  for (int i = 0; i < curve.getNumPoints(); ++i) part.points.push_back({curve.getX(i), curve.getY(i)});
  return part;
}

// Adds the parts of one geometry; `rings` gets each part's number within its polygon.
Result<void> add_parts(const OGRGeometry& geometry, Feature& feature, std::vector<std::size_t>& rings) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint: {
      feature.type = FeatureType::Points;
      if (feature.parts.empty()) feature.parts.emplace_back();
      const OGRPoint& point = *geometry.toPoint();
      if (!point.IsEmpty()) feature.parts[0].points.push_back({point.getX(), point.getY()});
      return {};
    }
    case wkbLineString:
      feature.type = FeatureType::Lines;
      feature.parts.push_back(polyline_of(*geometry.toLineString()));
      return {};
    case wkbPolygon: {
      feature.type = FeatureType::Polygons;
      std::size_t ring = 0;
      for (const OGRLinearRing* contour : *geometry.toPolygon()) {
        feature.parts.push_back(polyline_of(*contour));
        rings.push_back(ring++);
      }
      return {};
    }
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) DOBRA_TRY_VOID(add_parts(*part, feature, rings));
      return {};
    default:
      return Error{ErrorCode::BadFormat,
                   fmt::format("geometry {} is not read; use Point, LineString, Polygon or their Multi forms",
                               geometry.getGeometryName())};
  }
}

PropertyValue value_of(const OGRFeature& source, int field) {
  const OGRFieldDefn& definition = *source.GetFieldDefnRef(field);
  switch (definition.GetType()) {
    case OFTInteger:
      if (definition.GetSubType() == OFSTBoolean) return source.GetFieldAsInteger(field) != 0;
      return static_cast<std::int64_t>(source.GetFieldAsInteger(field));
    case OFTInteger64:
      return static_cast<std::int64_t>(source.GetFieldAsInteger64(field));
    case OFTReal:
      return source.GetFieldAsDouble(field);
    default:
      return std::string(source.GetFieldAsString(field));
  }
}

void add_properties(const OGRFeature& source, Feature& feature) {
  for (int i = 0; i < source.GetFieldCount(); ++i) {
    if (!source.IsFieldSetAndNotNull(i)) continue;
    const std::string key = source.GetFieldDefnRef(i)->GetNameRef();
    if (key == "name")
      feature.name = source.GetFieldAsString(i);
    else if (key == "kind")
      feature.kind = source.GetFieldAsString(i);
    else
      feature.properties.emplace_back(key, value_of(source, i));
  }
}

std::string item_of(std::size_t number, const Feature& feature) {
  return feature.name.empty() ? fmt::format("feature {}", number)
                              : fmt::format("feature {} {}", number, shown(feature.name));
}

// Adds one OGR feature to the result, or a remark where it has no geometry.
Result<void> add_feature(const OGRFeature& source, std::size_t number, const std::string& file, Features& result) {
  Feature feature;
  add_properties(source, feature);
  const Place place{.file = file, .item = item_of(number, feature)};
  const OGRGeometry* geometry = source.GetGeometryRef();
  if (geometry == nullptr || geometry->IsEmpty()) {
    result.remarks.push_back(fmt::format("{}: {}: no geometry, left out", file, place.item));
    return {};
  }
  std::vector<std::size_t> rings;
  if (auto added = add_parts(*geometry, feature, rings); !added) return base::located(added.error(), place);
  if (geometry->Is3D()) {
    result.remarks.push_back(fmt::format("{}: {}: third coordinates dropped", file, place.item));
  }
  const Result<std::size_t> repeated = normalise(feature, rings);
  if (!repeated) {
    return base::located(repeated.error(), place);
  }
  if (*repeated > 0) {
    result.remarks.push_back(fmt::format("{}: {}: {} repeated {} dropped", file, place.item, *repeated,
                                         *repeated == 1 ? "point" : "points"));
  }
  result.features.push_back(std::move(feature));
  return {};
}

Result<Features> read_features(GDALDataset& data, const GdalMessages& messages, const std::string& file) {
  Features result;
  std::size_t number = 0;
  for (OGRLayer* layer : data.GetLayers()) {
    layer->ResetReading();
    while (const OGRFeatureUniquePtr source{layer->GetNextFeature()}) {
      ++number;
      if (messages.failure) break;
      DOBRA_TRY_VOID(add_feature(*source, number, file, result));
    }
  }
  if (messages.failure) {
    return Error{ErrorCode::BadFormat, fmt::format("not valid GeoJSON: {}", *messages.failure), Place{.file = file}};
  }
  for (const std::string& warning : messages.warnings) result.remarks.push_back(fmt::format("{}: {}", file, warning));
  return result;
}

}  // namespace

Result<Features> parse_geojson(std::string_view text, const std::string& file) {
  DOBRA_TRY_VOID(check_text(text, file));
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  DOBRA_TRY_VOID(check_syntax(text, file));
  static std::once_flag registered;
  std::call_once(registered, [] { RegisterOGRGeoJSON(); });
  const GdalMessages messages;
  const GdalMemoryFile memory(text, ".geojson");
  const char* const drivers[] = {"GeoJSON", nullptr};
  const char* const options[] = {"DATE_AS_STRING=YES", nullptr};
  const GDALDatasetUniquePtr data(
      GDALDataset::Open(memory.name(), GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers, options));
  if (!data) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("not GeoJSON: give a FeatureCollection, a Feature or a geometry{}",
                             messages.failure ? " (" + *messages.failure + ")" : std::string{}),
                 Place{.file = file}};
  }
  return read_features(*data, messages, file);
}

Result<Features> read_geojson(const std::string& path) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_geojson(text, path);
}

}  // namespace dobra::io
