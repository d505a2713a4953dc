#include "shared/io/gis/ogr_features.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "shared/io/scan.h"

namespace dobra::io::gis {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Polyline;

namespace {

void add_point(const OGRPoint& point, lines::Heights heights, lines::Feature& feature) {
  feature.type = lines::FeatureType::Points;
  if (feature.parts.empty()) feature.parts.emplace_back();
  if (point.IsEmpty()) return;
  feature.parts[0].points.push_back({point.getX(), point.getY()});
  if (heights == lines::Heights::Drop) return;
  if (feature.heights.empty()) feature.heights.emplace_back();
  feature.heights[0].push_back(point.getZ());
}

// Adds the parts of one geometry; `rings` gets each part's number within its polygon.
Result<void> add_parts(const OGRGeometry& geometry, lines::Heights heights, lines::Feature& feature,
                       std::vector<std::size_t>& rings) {
  switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint:
      add_point(*geometry.toPoint(), heights, feature);
      return {};
    case wkbLineString:
      feature.type = lines::FeatureType::Lines;
      add_part(*geometry.toLineString(), heights, feature);
      return {};
    case wkbPolygon: {
      feature.type = lines::FeatureType::Polygons;
      std::size_t ring = 0;
      for (const OGRLinearRing* contour : *geometry.toPolygon()) {
        add_part(*contour, heights, feature);
        rings.push_back(ring++);
      }
      return {};
    }
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
      for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
        DOBRA_TRY_VOID(add_parts(*part, heights, feature, rings));
      }
      return {};
    default:
      return Error{ErrorCode::BadFormat,
                   fmt::format("geometry {} is not read; use Point, LineString, Polygon or their Multi forms",
                               geometry.getGeometryName())};
  }
}

lines::PropertyValue value_of(const OGRFeature& source, int field) {
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

void add_properties(const OGRFeature& source, lines::Feature& feature) {
  for (int i = 0; i < source.GetFieldCount(); ++i) {
    if (!source.IsFieldSetAndNotNull(i)) continue;
    const std::string key = source.GetFieldDefnRef(i)->GetNameRef();
    if (feature.name.empty() && EQUAL(key.c_str(), "name"))
      feature.name = source.GetFieldAsString(i);
    else if (feature.kind.empty() && EQUAL(key.c_str(), "kind"))
      feature.kind = source.GetFieldAsString(i);
    else
      feature.properties.emplace_back(key, value_of(source, i));
  }
}

}  // namespace

void add_part(const OGRSimpleCurve& curve, lines::Heights heights, lines::Feature& feature) {
  Polyline part;
  const int count = curve.getNumPoints();
  part.points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) part.points.push_back({curve.getX(i), curve.getY(i)});
  feature.parts.push_back(std::move(part));
  if (heights == lines::Heights::Drop) return;
  std::vector<double>& kept = feature.heights.emplace_back();
  for (int i = 0; i < count; ++i) kept.push_back(curve.getZ(i));
}

std::optional<lines::ReferenceSystem> reference_system(const OGRSpatialReference* system) {
  if (system == nullptr || system->GetName() == nullptr) return std::nullopt;
  lines::ReferenceSystem made;
  made.name = system->GetName();
  if (made.name == "Undefined geographic SRS" || made.name == "Undefined Cartesian SRS") return std::nullopt;
  char* text = nullptr;
  const char* const options[] = {"FORMAT=WKT2", nullptr};
  if (system->exportToWkt(&text, options) == OGRERR_NONE && text != nullptr) made.wkt = text;
  CPLFree(text);
  const char* const authority = system->GetAuthorityName(nullptr);
  const char* const code = system->GetAuthorityCode(nullptr);
  if (authority != nullptr && code != nullptr) made.code = fmt::format("{}:{}", authority, code);
  made.degrees = system->IsGeographic() != 0;
  return made;
}

void note_system(const OGRSpatialReference* system, lines::StatedConvention& stated) {
  const std::optional<lines::ReferenceSystem> named = reference_system(system);
  if (!named) return;
  if (named->degrees) {
    stated.questions.push_back(
        {lines::Question::About::Coordinates,
         fmt::format("the coordinates are in degrees ({}); project the file first, or say that they are section "
                     "coordinates all the same: coordinates = section (--coordinates section)",
                     named->name)});
    return;
  }
  const double unit = system->GetLinearUnits(nullptr);
  if (std::isfinite(unit) && unit > 0.0) stated.unit = unit;
}

Result<void> add_ogr_feature(const OGRFeature& source, std::size_t number, const std::string& file,
                             lines::Heights heights, lines::Faulty faulty, lines::Features& result) {
  lines::Feature feature;
  add_properties(source, feature);
  feature.source = Place{.file = file, .item = lines::item_of(number, feature)};
  const Place& place = feature.source;
  const OGRGeometry* geometry = source.GetGeometryRef();
  if (geometry == nullptr || geometry->IsEmpty()) {
    result.remarks.push_back(fmt::format("{}: {}: no geometry, left out", file, place.item));
    return {};
  }
  const bool three_dimensional = geometry->Is3D();
  std::vector<std::size_t> rings;
  auto added = add_parts(*geometry, three_dimensional ? heights : lines::Heights::Drop, feature, rings);
  if (!added && faulty == lines::Faulty::Skip) {
    result.remarks.push_back(fmt::format("{}: {}: {}; left out", file, place.item, added.error().message));
    return {};
  }
  if (!added) return base::located(added.error(), place);
  if (three_dimensional && heights == lines::Heights::Drop) {
    result.remarks.push_back(fmt::format("{}: {}: third coordinates dropped", file, place.item));
  }
  if (const std::string open = lines::open_rings(feature); !open.empty())
    result.remarks.push_back(fmt::format("{}: {}: {}", file, place.item, open));
  const Result<std::size_t> repeated =
      faulty == lines::Faulty::Refuse
          ? lines::normalise(feature, rings)
          : lines::normalise_sound(feature, rings, fmt::format("{}: {}", file, place.item), result.remarks);
  if (!repeated) return base::located(repeated.error(), place);
  if (feature.parts.empty()) return {};
  if (*repeated > 0) {
    result.remarks.push_back(fmt::format("{}: {}: {} repeated {} dropped", file, place.item, *repeated,
                                         *repeated == 1 ? "point" : "points"));
  }
  result.features.push_back(std::move(feature));
  return {};
}

}  // namespace dobra::io::gis
