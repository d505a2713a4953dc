#pragma once
// Lines as plain text: what a clipboard carries between windows, spreadsheets and scenarios. Page: docs/user/canvas.md.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::canvas {

/// A line with what it is called; a single point is a line of one.
struct NamedLine {
  std::string name{};
  geom::Polyline line;
};

/// A vertex on each text line, its coordinates parted by a tab; "# name" before each line and an empty text line
/// between two. A closed line ends with its first point. Decimals stand behind a point, and numbers read back to the
/// same bits.
std::string text_of_lines(std::span<const NamedLine> lines);

/// What text_of_lines writes; two columns of a spreadsheet, with a header or without, decimals behind a point or (where
/// tabs, semicolons or blanks part the columns) a comma; the value of a scenario's `points`: "[[0, 1], [2, 3]]".
/// Columns behind the second are not read. A line of four points or more that ends where it begins is closed.
/// @error BadValue, translated: what is no pair of numbers, with its line of the text; no points at all.
base::Result<std::vector<NamedLine>> lines_of_text(std::string_view text);

}  // namespace dobra::canvas
