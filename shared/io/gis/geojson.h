#pragma once
// GeoJSON lines, polygons and points with the properties name and kind; read through GDAL/OGR, written by own code so
// that the same features give the same bytes. Coordinates are plain section or domain coordinates: no reference
// system is applied; one in degrees is a question. Source: [rfc7946], [gdal].

#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::gis {

/// The features of a FeatureCollection, a Feature or a bare geometry. Contours come out anticlockwise, holes clockwise;
/// features without geometry, repeated points and, unless they are kept, third coordinates are dropped with a remark.
/// @error EmptyFile; BadFormat: not JSON (line and column), not GeoJSON, an unsupported geometry; NotFinite,
///        DegenerateCurve; the place's item is the feature: "feature 3 'top'". @cost O(file size).
/// @param faulty  Skip: degenerate parts and collections are left out with a remark.
base::Result<lines::Features> parse_geojson(std::string_view text, const std::string& file,
                                            lines::Heights heights = lines::Heights::Drop,
                                            lines::Faulty faulty = lines::Faulty::Refuse);
/// @error FileNotFound, NotAFile, CannotRead, and those of parse_geojson.
base::Result<lines::Features> read_geojson(const std::string& path, lines::Heights heights = lines::Heights::Drop);

/// A FeatureCollection, one feature a line, every digit and the heights kept. MULTI forms only where there is more than
/// one part.
/// @param system  written as the member "crs" of older GeoJSON, which QGIS reads, if it has a code.
/// @error NotFinite
base::Result<std::string> geojson(std::span<const lines::Feature> features,
                                  const lines::ReferenceSystem* system = nullptr);
/// @error NotFinite, CannotWrite
base::Result<void> write_geojson(const std::string& path, std::span<const lines::Feature> features);

}  // namespace dobra::io::gis
