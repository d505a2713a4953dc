#pragma once
// Points as rows of a spreadsheet: what the clipboard takes and gives.

#include <QString>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::gui::vertices {

/// Points from text: a row each with two numbers, apart by a tab, a semicolon, or blanks; a comma parts them where it
/// is no decimal mark. Decimals behind a point or a comma. A first row of words is left out.
/// @error BadValue: the row and what is wrong with it.
base::Result<std::vector<geom::Point>> points_of_rows(const QString& text);

/// "x<tab>z" a row, decimals behind the mark of the user's language; reads back to the same bits.
QString rows_of_points(const std::vector<geom::Point>& points);

/// A number as it stands in a cell: the shortest that reads back to the same bits.
QString cell_text(double value);

/// The number in a cell, with a decimal point or comma; nothing if it is none, or not finite.
std::optional<double> cell_value(const QString& typed);

}  // namespace dobra::gui::vertices
