#include "shared/scene/text_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"

namespace dobra::scene {

namespace {

constexpr double column_gap = 10.0;
constexpr double row_gap = 2.5;
constexpr double block_gap = 10.0;
constexpr std::size_t least_rows = 3;
constexpr std::size_t most_letters = 48;
constexpr double cut_share = 0.6;   // of the room, for tables that are cut anyway
constexpr double table_gap = 26.0;  // between tables that stand side by side

void add(Furniture& made, const Furniture& part, geom::Vector by) {
  for (const Mark& mark : part.marks) made.marks.push_back(moved(mark, by));
}

/// No name makes a table wider than a page.
std::string elided(const std::string& text) {
  std::size_t letters = 0;
  std::size_t cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continue;  // goes on with a letter
    if (++letters == most_letters) cut = i;
  }
  return letters <= most_letters ? text : text.substr(0, cut) + "\u2026";
}

Furniture under_each_other(const std::vector<Furniture>& parts, double gap) {
  Furniture made;
  for (const Furniture& part : parts) made.width = std::max(made.width, part.width);
  for (const Furniture& part : parts) {
    if (made.height > 0.0) made.height += gap;
    add(made, part, {0.5 * (made.width - part.width), made.height});
    made.height += part.height;
  }
  return made;
}

Furniture side_by_side(const std::vector<Furniture>& parts) {
  Furniture made;
  for (const Furniture& part : parts) {
    if (made.width > 0.0) made.width += table_gap;
    add(made, part, {made.width, 0.0});
    made.width += part.width;
    made.height = std::max(made.height, part.height);
  }
  return made;
}

Furniture arranged(const std::vector<Furniture>& parts, bool beside) {
  return beside ? side_by_side(parts) : under_each_other(parts, block_gap);
}

}  // namespace

Furniture text_table(const TextTable& table, const Font& font, const TextMeasure& measure, std::size_t first,
                     std::size_t count) {
  const Font bold{font.size, Weight::Bold};
  std::vector<double> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    double width = measure(table.columns[c], bold).width;
    for (const auto& row : table.rows)
      width = std::max(width, c < row.size() ? measure(elided(row[c]), font).width : 0.0);
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
      TextMark mark = text_mark(elided(cells[c]), {}, how, measure);
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
  const std::size_t end = first + std::min(count, table.rows.size() - std::min(first, table.rows.size()));
  for (std::size_t i = first; i < end; ++i) add_row(table.rows[i], font);
  if (end < table.rows.size()) {
    const std::string more =
        fmt::format(fmt::runtime(base::translated("... {} more rows, in the tables (CSV) and the report")),
                    table.rows.size() - end);
    TextMark mark = text_mark(more, {}, font, measure);
    mark.at = {0.5 * mark.size.width, made.height + 0.5 * line};
    made.width = std::max(made.width, mark.size.width);
    made.height += line;
    made.marks.push_back(std::move(mark));
  }
  return made;
}

Tables tables_of(const Picture& picture, const PageSize& room, const Font& font, const TextMeasure& measure) {
  Tables made;
  if (picture.tables.empty()) return made;
  const auto make = [&](std::size_t rows) {
    std::vector<Furniture> parts;
    for (const TextTable& table : picture.tables) parts.push_back(text_table(table, font, measure, 0, rows));
    return parts;
  };
  std::size_t longest = 0;
  for (const TextTable& table : picture.tables) longest = std::max(longest, table.rows.size());
  std::vector<Furniture> parts = make(longest);
  const bool beside = side_by_side(parts).width <= room.width;
  made.furniture = arranged(parts, beside);
  // Every row less is a line less, of which the first says how many are left out.
  const double line = measure("0", font).height() + row_gap;
  const double most = made.furniture.height > room.height ? cut_share * room.height : room.height;
  for (std::size_t kept = longest; made.furniture.height > most && kept > least_rows;) {
    const double lines = (made.furniture.height - most) / line / static_cast<double>(parts.size());
    kept -= std::min(kept - least_rows, static_cast<std::size_t>(std::max(1.0, std::floor(lines))));
    made.cut = true;
    parts = make(kept);
    made.furniture = arranged(parts, beside);
  }
  return made;
}

Furniture notes_of(const Picture& picture, double width, const Font& font, const TextMeasure& measure) {
  std::vector<Furniture> parts;
  for (const std::string& note : picture.notes) parts.push_back(heading(note, width, font, measure));
  return under_each_other(parts, 1.0);
}

}  // namespace dobra::scene
