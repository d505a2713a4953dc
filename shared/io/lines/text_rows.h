#pragma once
// The first rows of a text of points as they stand, to be looked at before it is read. Page: docs/user/import.md.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shared/io/lines/text_points.h"

namespace dobra::io::lines {

struct TextRows {
  std::vector<std::string> header;  ///< Empty where the first row holds two numbers.
  std::vector<std::vector<std::string>> rows;
  Separator separator = Separator::Blank;  ///< As used.
  // The columns that reading takes where nobody says others, from 1; 0: none.
  std::size_t x = 0, height = 0, names = 0;
};

/// Comments and empty lines are left out. @param most  rows, the header not counted.
TextRows first_rows(std::string_view text, Separator separator, std::size_t most);

/// Whether a field is a number above nought, whatever its decimal sign.
bool is_above_nought(std::string_view field);

}  // namespace dobra::io::lines
