#include "shared/scenario/color_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/scenario/field.h"
#include "shared/scenario/toml_reader.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

/// The texts of one row by the English name of their column.
struct Row {
  std::map<std::string, std::string> texts;
  base::Place place;
};

const std::array<std::pair<const char*, std::vector<std::string>>, 5> columns{
    {{"name", {"name", "unit", "code", "nome", "unidade", "sigla"}},
     {"colour", {"colour", "color", "cor"}},
     {"pattern", {"pattern", "padrao", "padrão", "hachura"}},
     {"age", {"age", "idade"}},
     {"lithology", {"lithology", "litologia"}}}};

/// The English name of a column; empty for those that are left alone.
std::string column_of(std::string header) {
  for (char& c : header) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [name, words] : columns) {
    if (std::find(words.begin(), words.end(), header) != words.end()) return name;
  }
  return {};
}

/// The cells of one line; "" within quotes is a quote.
std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += line[i];
    }
  }
  for (std::string& cell : cells) cell = base::trimmed(cell);
  return cells;
}

base::Place line_of(const std::string& file, std::size_t line) {
  base::Place place;
  place.file = file;
  place.line = line;
  return place;
}

base::Result<std::vector<Row>> csv_rows(const std::string& text, const std::string& file) {
  std::vector<Row> rows;
  std::vector<std::string> header;
  char separator = ',';
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line(base::trimmed(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
    ++number;
    if (line.empty() || (line.front() == '#' && header.empty())) continue;
    if (header.empty()) {
      for (const char wanted : {'\t', ';'}) {
        if (line.find(wanted) != std::string::npos) separator = wanted;
      }
      header = cells_of(line, separator);
      for (std::string& cell : header) cell = column_of(cell);
      if (std::find(header.begin(), header.end(), "name") != header.end()) continue;
      return Error{ErrorCode::BadFormat,
                   "the first line names the columns: name, colour, pattern, age, lithology; there is no 'name' in it",
                   line_of(file, number)};
    }
    Row row{{}, line_of(file, number)};
    const std::vector<std::string> cells = cells_of(line, separator);
    if (cells.size() > header.size()) {
      return Error{ErrorCode::BadFormat,
                   fmt::format("{} cells under {} headings; put a text with a '{}' in quotes", cells.size(),
                               header.size(), separator),
                   row.place};
    }
    for (std::size_t c = 0; c < cells.size(); ++c) row.texts[header[c]] = cells[c];
    rows.push_back(std::move(row));
  }
  return rows;
}

base::Result<std::vector<Row>> toml_rows(const std::string& text, const std::string& file) {
  DOBRA_TRY(const std::vector<Table> tables, read_rows(text, file, "unit"));
  std::vector<Field> fields;
  for (const char* const key : {"name", "colour", "color", "pattern", "age", "lithology"})
    fields.push_back({key, Kind::Text, {}, {}, {}, {}});
  std::vector<Row> rows;
  for (const Table& table : tables) {
    DOBRA_TRY_VOID(check(table, fields, "unit"));
    Row row{{}, table.own_place};
    for (const Table::Entry& entry : table.entries())
      row.texts[column_of(entry.key)] = std::get<std::string>(entry.value);
    rows.push_back(std::move(row));
  }
  return rows;
}

base::Result<scene::ColorEntry> entry_of(Row& row) {
  scene::ColorEntry entry{row.texts["name"]};
  const auto bad = [&](const std::string& message) { return Error{ErrorCode::BadFormat, message, row.place}; };
  if (entry.name.empty()) return bad("a unit needs a name");
  if (const std::string& text = row.texts["colour"]; !text.empty()) {
    entry.color = scene::color_of_text(text);
    if (!entry.color) {
      return bad(fmt::format("'{}': '{}' is not a colour; write \"#d2b48c\", \"210, 180, 140\" or a name such as tan",
                             entry.name, text));
    }
  }
  if (const std::string& text = row.texts["pattern"]; !text.empty()) {
    entry.pattern = scene::pattern_of_text(text);
    const auto known = scene::pattern_names();
    if (!entry.pattern) {
      return bad(fmt::format("'{}': '{}' is not a pattern; there are {}{}", entry.name, text, fmt::join(known, ", "),
                             base::did_you_mean(text, known)));
    }
  }
  entry.age = row.texts["age"];
  entry.lithology = row.texts["lithology"];
  return entry;
}

}  // namespace

base::Result<scene::ColorTable> parse_color_table(const std::string& text, const std::string& file) {
  DOBRA_TRY(std::vector<Row> rows, io::ending_of(file) == ".toml" ? toml_rows(text, file) : csv_rows(text, file));
  scene::ColorTable table;
  std::map<std::string, std::size_t> lines;
  for (Row& row : rows) {
    DOBRA_TRY(scene::ColorEntry entry, entry_of(row));
    const auto [known, added] = lines.emplace(entry.name, row.place.line);
    if (!added) {
      return Error{ErrorCode::BadFormat,
                   fmt::format("'{}' has a colour already in line {}; keep one", entry.name, known->second), row.place};
    }
    table.entries.push_back(std::move(entry));
  }
  if (table.entries.empty()) return Error{ErrorCode::BadFormat, "the table names no unit", line_of(file, 0)};
  return table;
}

base::Result<scene::ColorTable> read_color_table(const std::string& path) {
  DOBRA_TRY(const std::string text, io::read_text(path));
  return parse_color_table(text, path);
}

}  // namespace dobra::scenario
