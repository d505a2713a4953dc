#pragma once
// Places that a user types while drawing. Page: docs/user/canvas.md.

#include <optional>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::canvas {

/// Both marks are read where the text leaves no doubt.
using scene::decimal_mark;
using scene::DecimalMark;
using scene::set_decimal_mark;
using scene::with_decimal_mark;

struct EntryContext {
  std::optional<geom::Point> last = std::nullopt;      ///< The place before.
  std::optional<geom::Vector> towards = std::nullopt;  ///< From there to the cursor: where a plain length goes.
  DecimalMark mark = decimal_mark();
};

/// "x,z" a place; "@dx,dz" from the last place; "@d<angle" as distance and degrees anticlockwise from +x; "d" a length
/// towards the cursor. Numbers are parted by a comma, a semicolon or blanks. A comma is a decimal mark where a
/// semicolon or blanks part the numbers, beside "<", and, where the language writes it so, in a single number: "12,5"
/// is a length in Portuguese and a place in English.
/// @error BadValue: what cannot be read, with the forms; a relative place or a length without a last place; a length
///        without a direction.
base::Result<geom::Point> parse_entry(std::string_view text, const EntryContext& context);

}  // namespace dobra::canvas
