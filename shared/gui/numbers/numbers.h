#pragma once
// Numbers as a window shows and takes them: decimals behind the mark of the user's language, never a mark between
// thousands; on input a point and a comma alike. Files keep the point. Page: docs/user/window.md, "Numbers".

#include <QString>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace dobra::gui::numbers {

/// With all its digits; it reads back to the same bits. 40 is "40".
QString whole(double value);

/// For reading: six digits, and whole numbers below a thousand million without an exponent: "14715897", "0,0123457",
/// "2.1e11".
QString readable(double value);

/// A unit with its powers and roots set: "m2" is "m²", "Pa sqrt(m)" is "Pa √m".
QString unit_text(const std::string& unit);

/// How a field of this kind shows a value. Lists have no brackets where they read back without: "1,5; 2".
QString field_text(scenario::Kind kind, const scenario::Value& value);

/// What was typed into a field of this kind, as scenario::parse_value reads it. In a list a comma is a decimal mark
/// where semicolons or blanks part the numbers and, where the language writes it so, in a single number.
QString as_parsed(scenario::Kind kind, const QString& typed);

/// Points from text: two numbers a line, parted by commas, semicolons, tabs or blanks, with or without brackets; a
/// comma is a decimal mark where something else parts the numbers.
/// @error BadValue with the number of the line.
base::Result<std::vector<geom::Point>> points_from_text(const std::string& text);

/// The text that points_from_text reads back to the same bits: "1.5, 2", with the other mark "1,5; 2".
std::string text_of_points(const std::vector<geom::Point>& points);

/// The next "round" value from `value` in steps of a tenth to a hundredth of its size; 0 goes to +-0.1.
double stepped(double value, int steps);

}  // namespace dobra::gui::numbers
