#pragma once
// What a text of points says by its headers and by columns of words, where no option says it. Internal to io.
// Page: docs/user/import.md.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/lines/text_points.h"

namespace dobra::io::lines {

/// Names: the header calls the column by a word for lines of sections, such as "Camada" or "horizon".
/// Unclear: its texts may be names; they differ, and some are repeated. LeftOut: they tell no lines apart.
enum class WordsAre { NoColumn, Names, Unclear, LeftOut };

/// The column of words that matters most: the first that names lines, else the first that is unclear.
struct WordColumn {
  WordsAre words = WordsAre::NoColumn;
  std::size_t column = 0;  ///< From 1.
  std::string header;      ///< Empty where there is none.
  std::string first;       ///< The text of the first row, and another text where there is one.
  std::string other;
  std::size_t first_line = 0;  ///< Of the file.
  std::size_t other_line = 0;
};

/// @param header  fields of the first row, or empty where that is none. @param used  columns that have a meaning.
/// @cost O(text).
WordColumn word_column(std::string_view text, Separator separator, std::span<const std::string> header,
                       std::span<const std::size_t> used);

/// Names, LeftOut: what was done, in one line.
std::string told(const WordColumn& words, const std::string& file);
/// Unclear: what is asked, with the place.  @param x, height  the columns that are taken, from 1.
base::Error asked(const WordColumn& words, const std::string& file, std::size_t x, std::size_t height);

/// Columns of x and height, from 1.
struct PositionColumns {
  std::size_t x = 1, height = 2;
};
/// Those that the header calls so ("x", "distance"; "z", "y", "elevation", "depth", ...), where they are not the first
/// two; nothing where it does not tell.
/// @error Unclear: x, y and z, not as the first three.
base::Result<std::optional<PositionColumns>> position_columns(std::string_view text, Separator separator,
                                                              const std::string& file);
/// Whether a header calls its column x or height.
bool says_position(std::string_view header);

/// Whether a header says that its column grows downwards: "depth", "Profundidade (m)", "prof", "TVDSS".
bool says_depth(std::string_view header);

}  // namespace dobra::io::lines
