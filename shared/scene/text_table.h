#pragma once
// Tables and notes below the plots of a page, each made by itself at the origin and then moved to its place. Internal
// to scene: layout.h is what callers use.

#include "shared/scene/furniture.h"

namespace dobra::scene {

/// Title, a line of headings, a rule, the rows; the first column to the left, the others to the right. Columns are as
/// wide as their widest cell; a table wider than the page makes the page wider.
Furniture text_table(const TextTable& table, const Font& font, const TextMeasure& measure);

/// All tables and the notes of a picture under each other, centred.
Furniture tables_and_notes(const Picture& picture, double width, const Font& font, const TextMeasure& measure);

}  // namespace dobra::scene
