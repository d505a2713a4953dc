#pragma once
// The geometry of a domain as a file holds it, before roles are found: what the rows of drawings read.

#include <string>
#include <variant>

#include "shared/base/result.h"
#include "shared/io/drawings/geo.h"
#include "shared/io/drawings/svg.h"
#include "shared/io/formats/format.h"
#include "shared/io/meshes/poly.h"

namespace dobra::io::formats {

/// Segments between points, with markers and holes; or curves with tags, loops and groups; or outlines of pieces. A
/// further format of drawings gives one of these.
struct Drawing {
  std::variant<meshes::PolyFile, drawings::GeoFile, drawings::SvgFile> held;
};

/// By the ending. @error UnknownFormat naming the endings; those of the readers.
base::Result<Drawing> read_drawing(const std::string& path);

}  // namespace dobra::io::formats
