#pragma once
// What the user's language writes before decimals: in pictures, and in all that a window shows.

#include <string>

namespace dobra::scene {

enum class DecimalMark { Point, Comma };

/// Of all that is shown from now on; Point until then. Files of numbers have points, whatever the language.
void set_decimal_mark(DecimalMark mark);
DecimalMark decimal_mark();
/// The text with the user's mark in the place of points between digits.
std::string with_decimal_mark(std::string text);

}  // namespace dobra::scene
