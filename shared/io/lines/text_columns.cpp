#include "shared/io/lines/text_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "shared/base/text.h"
#include "shared/io/lines/text_fields.h"
#include "shared/io/lines/text_numbers.h"
#include "shared/io/lines/text_units.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

namespace {

/// How headers call the name of a line, in English and Portuguese; as `plain` gives words.
constexpr std::array<std::string_view, 32> line_words{
    "name",    "nome",   "names",   "nomes",      "horizon", "horizons", "horizonte", "horizontes",
    "layer",   "layers", "camada",  "camadas",    "unit",    "unidade",  "formation", "formacao",
    "feature", "feicao", "line",    "linha",      "id",      "bed",      "contact",   "contato",
    "member",  "membro", "surface", "superficie", "fault",   "falha",    "label",     "rotulo"};
constexpr std::array<std::string_view, 9> depth_words{"depth", "depths", "profundidade", "profundidades", "prof",
                                                      "tvd",   "tvdss",  "sstvd",        "tvdmsl"};

constexpr std::array<std::string_view, 4> distance_words{"x", "distance", "distancia", "dist"};
constexpr std::array<std::string_view, 9> height_words{"z",    "y",      "height",   "elevation", "elev",
                                                       "cota", "altura", "altitude", "elevacao"};

template <std::size_t Count>
bool is_one_of(std::string_view word, const std::array<std::string_view, Count>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "Prof. (m)" as prof, m.
std::vector<std::string> words_of(std::string_view header) {
  std::vector<std::string> words(1);
  for (const char c : plain(header)) {
    const bool letter = (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
    if (letter) words.back() += c;
    if (!letter && !words.back().empty()) words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

struct ColumnTexts {
  WordColumn shown;
  std::size_t filled = 0;
  std::size_t numbers = 0;
  std::unordered_set<std::string_view> different;

  void add(std::string_view text, std::size_t line) {
    if (different.insert(text).second && different.size() <= 2) {
      (different.size() == 1 ? shown.first : shown.other) = text;
      (different.size() == 1 ? shown.first_line : shown.other_line) = line;
    }
    if (text.empty()) return;
    ++filled;
    if (may_be_number(text)) ++numbers;
  }

  [[nodiscard]] WordsAre meaning(std::size_t rows) const {
    const std::vector<std::string> words = words_of(shown.header);
    const bool whole = words.size() == 1 && is_one_of(words[0], line_words);
    const bool said = std::any_of(words.begin(), words.end(), [](const auto& w) { return is_one_of(w, line_words); });
    const bool own = different.size() == rows && rows > 1;  // names of points, or comments
    const bool tells = different.size() > 1 && !own;
    if (filled == numbers) return whole && tells ? WordsAre::Unclear : WordsAre::NoColumn;
    if (said && !own) return WordsAre::Names;
    if (2 * numbers >= filled) return WordsAre::NoColumn;  // numbers, and words where there are none
    return tells ? WordsAre::Unclear : WordsAre::LeftOut;
  }
};

/// What stands behind a '#' between blanks is a comment.
void drop_comment(std::vector<Word>& fields, Separator separator) {
  if (separator != Separator::Blank) return;
  const auto sign = std::find_if(fields.begin(), fields.end(), [](const Word& w) { return w.text.starts_with('#'); });
  fields.erase(sign, fields.end());
}

/// The texts of every column that is not used, from 0; `rows` gets their number.
std::vector<ColumnTexts> column_texts(std::string_view text, Separator separator, bool has_header,
                                      std::span<const std::size_t> used, std::size_t& rows) {
  std::vector<ColumnTexts> columns;
  std::vector<Word> fields;
  bool skip = has_header;
  bool below_header = has_header;
  Lines lines(text);
  while (lines.next()) {
    if (is_empty(lines.line()) || is_comment(lines.line()) || std::exchange(skip, false)) continue;
    split_fields(lines.line(), separator, fields);
    drop_comment(fields, separator);
    if (std::exchange(below_header, false) && is_units_row(fields)) continue;
    if (rows == 0) columns.resize(std::max<std::size_t>(fields.size(), 3));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (std::find(used.begin(), used.end(), i + 1) != used.end()) continue;
      columns[i].add(i < fields.size() ? fields[i].text : std::string_view(), lines.number());
    }
    ++rows;
  }
  return columns;
}

std::string titled(const WordColumn& words) {
  return fmt::format("column {}{}", words.column, words.header.empty() ? "" : " (" + shown(words.header) + ")");
}

}  // namespace

WordColumn word_column(std::string_view text, Separator separator, std::span<const std::string> header,
                       std::span<const std::size_t> used) {
  std::size_t rows = 0;
  std::vector<ColumnTexts> columns = column_texts(text, separator, !header.empty(), used, rows);
  WordColumn best;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    WordColumn& words = columns[i].shown;
    words.column = i + 1;
    if (i < header.size()) words.header = header[i];
    if (columns[i].different.empty()) continue;
    words.words = columns[i].meaning(rows);
    const bool none = words.words == WordsAre::NoColumn;
    if (!none && (best.words == WordsAre::NoColumn || words.words < best.words)) best = words;
  }
  return best;
}

std::string told(const WordColumn& words, const std::string& file) {
  if (words.words == WordsAre::Names) {
    return fmt::format("{}: {} is taken for the names of the lines; --name-columns says another", file, titled(words));
  }
  return fmt::format("{}: {} is left out: its text is {} in every row", file, titled(words),
                     words.other_line == 0 ? shown(words.first) : "another");
}

base::Error asked(const WordColumn& words, const std::string& file, std::size_t x, std::size_t height) {
  return {base::ErrorCode::Unclear,
          fmt::format("{} has different texts, {} in line {} and {} here; say that it names the lines (--name-columns "
                      "{}, name_columns = [\"{}\"], or the header 'name' in the file), or that it does not (--columns "
                      "{},{}, columns = [{}, {}])",
                      titled(words), shown(words.first), words.first_line, shown(words.other), words.column,
                      words.column, x, height, x, height),
          base::Place{.file = file, .line = words.other_line}};
}

namespace {

/// A header without its unit: "z (m)" as z.
std::string quantity_of(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
  return words.empty() ? std::string() : words.front();
}
bool says_distance(std::string_view header) { return is_one_of(quantity_of(header), distance_words); }
bool says_height(std::string_view header) { return is_one_of(quantity_of(header), height_words) || says_depth(header); }

/// The column of that very word, else the only one that says as much; 0: none, or several.
std::size_t column_that(std::span<const Word> header, std::string_view word, bool (*says)(std::string_view)) {
  std::size_t found = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (quantity_of(header[i].text) == word) return i + 1;
    if (!says(header[i].text)) continue;
    found = i + 1;
    ++count;
  }
  return count == 1 ? found : 0;
}

}  // namespace

bool says_position(std::string_view header) { return says_distance(header) || says_height(header); }

base::Result<std::optional<PositionColumns>> position_columns(std::string_view text, Separator separator,
                                                              const std::string& file) {
  const std::optional<PositionColumns> none;
  std::vector<Word> header;
  const std::string_view row = first_row(text);
  split_header(row, separator == Separator::Detect ? separator_of_header(row) : separator, header);
  if (header.size() < 2 || (says_distance(header[0].text) && says_height(header[1].text))) return none;
  const auto has = [&](std::string_view word) {
    return std::any_of(header.begin(), header.end(), [&](const Word& w) { return quantity_of(w.text) == word; });
  };
  const std::size_t x = column_that(header, "x", says_distance);
  const std::size_t height = column_that(header, has("z") ? "z" : "y", says_height);
  if (x == 0 || height == 0) return none;
  if (has("y") && has("z")) {
    return base::Error{base::ErrorCode::Unclear,
                       "the header names x, y and z; say which are x and height of the section (--columns x,z, columns "
                       "= [\"x\", \"z\"]), or that all are map coordinates (--columns x,y,z)",
                       base::Place{.file = file}};
  }
  return std::optional(PositionColumns{x, height});
}

bool says_depth(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
  return std::any_of(words.begin(), words.end(), [](const auto& w) { return is_one_of(w, depth_words); });
}

}  // namespace dobra::io::lines
