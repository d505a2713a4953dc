#pragma once
// Shapefiles and GeoPackages, read and written through GDAL/OGR. Coordinates are those of the section, or map
// coordinates with heights; a reference system is only looked at for its unit, and never applied. Source: [gdal].

#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::gis {

/// All features of all layers, in the order of the file, third coordinates kept. `stated.unit` is that of the reference
/// system where it is not the metre; there is a question where the system is in degrees.
/// @error FileNotFound; BadFormat with OGR's own reason; NotFinite, DegenerateCurve: the place's item is the feature.
/// @param faulty  Skip: degenerate parts and collections are left out with a remark.
base::Result<lines::Features> read_ogr_file(const std::string& path, lines::Faulty faulty = lines::Faulty::Refuse);

/// A Shapefile: .shp, .shx, .dbf and .cpg. Fields: name, kind, then every property; DBF cuts their names at ten bytes.
/// @error InvalidOption: more than one kind of geometry; NotFinite, CannotWrite. Nothing is left behind then.
/// @param system  written to a .prj. @return remarks: fields whose names were cut.
base::Result<std::vector<std::string>> write_shapefile(const std::string& path,
                                                       std::span<const lines::Feature> features,
                                                       const lines::ReferenceSystem* system = nullptr);

/// A GeoPackage with a layer for each kind of geometry: lines, polygons, points.
/// @error NotFinite, CannotWrite. An old file is left as it was then.
base::Result<std::vector<std::string>> write_geopackage(const std::string& path,
                                                        std::span<const lines::Feature> features,
                                                        const lines::ReferenceSystem* system = nullptr);

}  // namespace dobra::io::gis
