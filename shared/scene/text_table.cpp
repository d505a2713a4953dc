#include "shared/scene/text_table.h"

#include <algorithm>

namespace dobra::scene {

namespace {

constexpr double column_gap = 14.0;
constexpr double row_gap = 2.5;
constexpr double block_gap = 10.0;

void add(Furniture& made, const Furniture& part, geom::Vector by) {
  for (const Mark& mark : part.marks) made.marks.push_back(moved(mark, by));
}

}  // namespace

Furniture text_table(const TextTable& table, const Font& font, const TextMeasure& measure) {
  const Font bold{font.size, Weight::Bold};
  std::vector<double> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    double width = measure(table.columns[c], bold).width;
    for (const auto& row : table.rows) width = std::max(width, c < row.size() ? measure(row[c], font).width : 0.0);
    widths.push_back(width);
  }
  Furniture made;
  for (const double width : widths) made.width += width + (made.width > 0.0 ? column_gap : 0.0);
  const Furniture title = heading(table.title, std::max(made.width, 200.0), {font.size + 1.0, Weight::Bold}, measure);
  made.width = std::max(made.width, title.width);
  add(made, title, {0.5 * (made.width - title.width), 0.0});
  made.height = title.height > 0.0 ? title.height + 4.0 : 0.0;
  const double line = measure("0", font).height() + row_gap;
  const auto add_row = [&](const std::vector<std::string>& cells, const Font& how) {
    double x = 0.0;
    for (std::size_t c = 0; c < widths.size() && c < cells.size(); ++c) {
      TextMark mark = text_mark(cells[c], {}, how, measure);
      const double left = c == 0 ? x : x + widths[c] - mark.size.width;
      mark.at = {left + 0.5 * mark.size.width, made.height + 0.5 * line};
      made.marks.push_back(std::move(mark));
      x += widths[c] + column_gap;
    }
    made.height += line;
  };
  add_row(table.columns, bold);
  made.marks.push_back(LineMark{{0.0, made.height}, {made.width, made.height}, frame_color, 0.75, Dash::Solid});
  made.height += 1.5;
  for (const auto& row : table.rows) add_row(row, font);
  return made;
}

Furniture tables_and_notes(const Picture& picture, double width, const Font& font, const TextMeasure& measure) {
  std::vector<Furniture> parts;
  for (const TextTable& table : picture.tables) parts.push_back(text_table(table, font, measure));
  for (const std::string& note : picture.notes) parts.push_back(heading(note, width, font, measure));
  Furniture made;
  for (const Furniture& part : parts) made.width = std::max(made.width, part.width);
  std::size_t number = 0;
  for (const Furniture& part : parts) {
    if (number > 0) made.height += number > picture.tables.size() ? 1.0 : block_gap;
    add(made, part, {0.5 * (made.width - part.width), made.height});
    made.height += part.height;
    ++number;
  }
  return made;
}

}  // namespace dobra::scene
