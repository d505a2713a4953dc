#pragma once
// Well-known text: POINT, MULTIPOINT, LINESTRING, MULTILINESTRING, POLYGON, MULTIPOLYGON. Source: [ogc06-103].

#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::lines {

/// The geometries of a text, one after another (a ';' between them may stand). Words in any case; third and fourth
/// coordinates (Z, M) are dropped with a remark; contours come out anticlockwise, holes clockwise.
/// @error EmptyFile; BadFormat, NotFinite, DegenerateCurve with line and column.
/// @param faulty  Skip: degenerate parts, collections and curved geometries are left out with a remark.
base::Result<Features> parse_wkt(std::string_view text, const std::string& file = {}, Faulty faulty = Faulty::Refuse);
/// @error FileNotFound, NotAFile, CannotRead, and those of parse_wkt.
base::Result<Features> read_wkt(const std::string& path);

/// One geometry a line with every digit; the MULTI form only where there is more than one part. Names are not kept.
/// @error NotFinite
base::Result<std::string> wkt(std::span<const Feature> features);
/// @error NotFinite, CannotWrite
base::Result<void> write_wkt(const std::string& path, std::span<const Feature> features);

}  // namespace dobra::io::lines
