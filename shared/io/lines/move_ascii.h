#pragma once
// MOVE's ASCII lines: one point a line, tabs between x, y, z, name, id and attribute, a blank line between lines.
// There is no public description; this is the form in which such files are passed on (see docs/user/import.md).

#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/lines/feature.h"

namespace dobra::io::lines {

/// Lines with heights, one feature a block of rows; a new name or id begins a new one too. Name, id and attribute may
/// be missing; the id becomes the property "id", the attribute the property "attribute" (or the kind, where it is
/// horizon, fault, unit or marker) if it is the same in the whole line. A last point equal to the first makes a
/// polygon, a single point a Points feature. A first row without numbers is taken as a header.
/// @error EmptyFile; BadFormat, NotFinite with line and column; DegenerateCurve with the line. @cost O(file size).
base::Result<Features> parse_move_ascii(std::string_view text, const std::string& file);
/// @error FileNotFound, NotAFile, CannotRead, and those of parse_move_ascii.
base::Result<Features> read_move_ascii(const std::string& path);

/// A name as it can stand between tabs and is read again: on one line, without blanks at its ends.
std::string move_name(std::string name);

/// One block a part, every digit kept. What is read from this text gives the same text again. Holes of polygons become
/// rings like others; only name, id and attribute (or kind) are kept.
/// @pre   every feature has heights.
/// @error NotFinite
base::Result<std::string> move_ascii(std::span<const Feature> features);

}  // namespace dobra::io::lines
