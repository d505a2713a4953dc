#include "shared/io/lines/text_rows.h"

#include <algorithm>
#include <array>

#include "shared/io/lines/text_columns.h"
#include "shared/io/lines/text_fields.h"
#include "shared/io/lines/text_numbers.h"
#include "shared/io/lines/text_units.h"

namespace dobra::io::lines {

namespace {

std::size_t numbers_in(const std::vector<Word>& fields) {
  return static_cast<std::size_t>(
      std::count_if(fields.begin(), fields.end(), [](const Word& field) { return may_be_number(field.text); }));
}

/// The separator under which most of the rows give two numbers.
Separator separator_of(const std::vector<std::string_view>& rows) {
  constexpr std::array candidates{Separator::Semicolon, Separator::Tab, Separator::Comma, Separator::Blank};
  std::array<std::size_t, candidates.size()> good{};
  std::vector<Word> fields;
  for (const std::string_view row : rows) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      split_fields(row, candidates[i], fields);
      if (numbers_in(fields) >= 2) ++good[i];
    }
  }
  const auto best = std::max_element(good.begin(), good.end());
  if (*best == 0) return rows.empty() ? Separator::Blank : separator_of_header(rows.front());
  return candidates[static_cast<std::size_t>(best - good.begin())];
}

}  // namespace

bool is_above_nought(std::string_view field) {
  const NumberReadings readings = readings_of(field);
  return readings.with_point.value_or(readings.with_comma.value_or(0.0)) > 0.0;
}

TextRows first_rows(std::string_view text, Separator separator, std::size_t most) {
  std::vector<std::string_view> lines;
  Lines all(text);
  while (lines.size() < most + 1 && all.next()) {
    if (!is_empty(all.line()) && !is_comment(all.line())) lines.push_back(all.line());
  }
  TextRows made;
  made.separator = separator == Separator::Detect ? separator_of(lines) : separator;
  std::vector<Word> fields;
  for (const std::string_view line : lines) {
    const bool first = made.rows.empty() && made.header.empty();
    if (first)
      split_header(line, made.separator, fields);
    else
      split_fields(line, made.separator, fields);
    std::vector<std::string> row;
    for (const Word& field : fields) row.emplace_back(field.text);
    if (!made.header.empty() && made.rows.empty() && is_units_row(fields)) {
      for (std::size_t i = 0; i < std::min(row.size(), made.header.size()); ++i) {
        if (!row[i].empty() && row[i] != "-") made.header[i] += ' ' + row[i];
      }
      continue;
    }
    if (first && numbers_in(fields) < 2) {
      made.header = std::move(row);
    } else {
      made.rows.push_back(std::move(row));
    }
  }
  if (made.rows.size() > most) made.rows.pop_back();
  std::size_t columns = made.header.size();
  for (const auto& row : made.rows) columns = std::max(columns, row.size());
  if (columns < 2) return made;
  const auto by_header = position_columns(text, made.separator, {});
  const PositionColumns position = by_header && *by_header ? **by_header : PositionColumns{};
  made.x = position.x;
  made.height = position.height;
  for (std::size_t i = 0; i < made.header.size(); ++i) {
    if (is_word(made.header[i], text_name_words)) made.names = i + 1;
  }
  if (made.names > 0) return made;
  const std::array used{made.x, made.height};
  const WordColumn words = word_column(text, made.separator, made.header, used);
  if (words.words == WordsAre::Names) made.names = words.column;
  return made;
}

}  // namespace dobra::io::lines
