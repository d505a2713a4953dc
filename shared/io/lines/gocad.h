#pragma once
// GOCAD lines (PLine) and points (VSet), as GOCAD, SKUA, PZero and OpenGeode write them: the header in one line or in
// several, `name:`, `name=` or `*name:`, version 1 or 1.0, objects alone or in groups, VRTX, PVRTX, ATOM and PATOM, SEG
// in any order or left out. Source: [gocad].

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::lines {

/// The lines and points of a file with their heights as written. A PLine is one Lines feature of all its open paths (a
/// path ends where segments branch) and one Polygons feature for each closed path. GEOLOGICAL_TYPE gives the kind: top
/// is "horizon", others as they are; GEOLOGICAL_FEATURE becomes a property. `stated` says what ZPOSITIVE and AXIS_UNIT
/// say; where ZPOSITIVE is missing it asks. Properties of vertices and objects of other types are left out with a
/// remark. @error EmptyFile; BadFormat with line and column: no GOCAD object, a vertex or segment that is not well
///        formed, an unknown vertex, the end missing; NotFinite, DegenerateCurve with the line of the object.
/// @cost  O(file size).
base::Result<Features> parse_gocad(std::string_view text, const std::string& file);
/// @error FileNotFound, NotAFile, CannotRead, and those of parse_gocad.
base::Result<Features> read_gocad(const std::string& path);

/// A name as a GOCAD header can hold it and as it is read again: on one line, without braces or blanks at its ends.
std::string gocad_name(std::string name);

/// One PLine a line feature and polygon ring, one VSet a Points feature; heights are elevations in metres; every digit
/// kept. What is read from this text gives the same text again. Holes of polygons become rings like others; of the
/// properties only "geological_feature" is kept.
/// @pre   every feature has heights.
/// @error NotFinite
base::Result<std::string> gocad(std::span<const Feature> features);

}  // namespace dobra::io::lines
