#pragma once
// Tables and notes below the plots of a page, each made by itself at the origin and then moved to its place. Internal
// to scene: layout.h is what callers use.

#include <limits>

#include "shared/scene/furniture.h"

namespace dobra::scene {

/// Title, a line of headings, a rule, the rows; the first column to the left, the others to the right. Columns are as
/// wide as their widest cell; a table wider than the page makes the page wider.
/// @param first, count  the rows; where any follow, a line says how many.
Furniture text_table(const TextTable& table, const Font& font, const TextMeasure& measure, std::size_t first = 0,
                     std::size_t count = std::numeric_limits<std::size_t>::max());

/// The tables of a picture in the middle: side by side where the width allows, else under each other.
struct Tables {
  Furniture furniture;
  bool cut = false;  ///< Rows are left out.
};
/// @param room  tables that are higher are cut, all to the same number of rows, to 0.6 of it; three rows always remain.
Tables tables_of(const Picture& picture, const PageSize& room, const Font& font, const TextMeasure& measure);

/// The notes of a picture under each other.
Furniture notes_of(const Picture& picture, double width, const Font& font, const TextMeasure& measure);

}  // namespace dobra::scene
