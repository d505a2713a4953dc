#include "shared/io/lines/text_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/lines/text_columns.h"
#include "shared/io/lines/text_fields.h"
#include "shared/io/lines/text_numbers.h"
#include "shared/io/lines/text_units.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Polyline;

namespace {

constexpr std::size_t detect_lines = 1000;
constexpr double highest = std::numeric_limits<double>::max();

std::string name_of(Separator separator) {
  switch (separator) {
    case Separator::Tab:
      return "tabs";
    case Separator::Comma:
      return "','";
    case Separator::Semicolon:
      return "';'";
    default:
      return "blanks";
  }
}

bool is_number(const std::vector<Word>& fields, std::size_t column) {
  return column > 0 && column <= fields.size() && may_be_number(fields[column - 1].text);
}

/// Without blanks between its digits.
bool is_written_plainly(std::string_view field) {
  return base::parse_number(field) || field.find(',') != std::string_view::npos;
}

// Columns by number, from 1; no z: 0.
struct Columns {
  std::size_t x = 1;
  std::size_t y = 2;
  std::size_t z = 0;
  std::vector<std::size_t> names;
  std::vector<std::size_t> extras;
  std::size_t kind = 0;
};

std::optional<std::size_t> column_number(std::string_view text) {
  const std::optional<double> value = base::parse_number(text);
  if (!value || *value < 1.0 || *value > 1e6 || *value != std::floor(*value)) return std::nullopt;
  return static_cast<std::size_t>(*value);
}

// A number that is no column is not looked for in the header.
bool is_name(const std::string& column) { return !base::parse_number(column).has_value(); }

Separator detect_separator(std::string_view text, std::size_t x, std::size_t y) {
  constexpr std::array candidates{Separator::Semicolon, Separator::Tab, Separator::Comma, Separator::Blank};
  std::array<std::size_t, candidates.size()> fits{};
  std::optional<Separator> in_first_line;
  std::vector<Word> fields;
  Lines lines(text);
  for (std::size_t seen = 0; seen < detect_lines && lines.next();) {
    const std::string_view line = lines.line();
    if (is_empty(line) || is_comment(line)) continue;
    ++seen;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (!in_first_line && (candidates[i] == Separator::Blank || line.find(sign_of(candidates[i])) != line.npos)) {
        in_first_line = candidates[i];
      }
      split_fields(line, candidates[i], fields);
      if (!is_number(fields, x) || !is_number(fields, y)) continue;
      // "1,234 567,8" is not 1, 234567 and 8.
      const bool plain = candidates[i] != Separator::Comma ||
                         (is_written_plainly(fields[x - 1].text) && is_written_plainly(fields[y - 1].text));
      if (plain) ++fits[i];
    }
  }
  const auto best = std::max_element(fits.begin(), fits.end());
  // Where nothing fits the file is wrong; the message then speaks of the separator that its first line shows.
  if (*best == 0) return in_first_line.value_or(Separator::Blank);
  return candidates[static_cast<std::size_t>(best - fits.begin())];
}

Result<std::size_t> column_of(const std::string& wanted, const std::vector<Word>& header, const std::string& what) {
  if (const auto number = column_number(wanted)) return *number;
  std::vector<std::string> names;
  for (const Word& field : header) names.emplace_back(field.text);
  const auto found = std::find(names.begin(), names.end(), wanted);
  if (found != names.end() && is_name(wanted)) return static_cast<std::size_t>(found - names.begin()) + 1;
  return Error{ErrorCode::InvalidOption,
               fmt::format("{}: the header has no column {}{}; columns are numbers from 1, or names of the header: {}",
                           what, shown(wanted), base::did_you_mean(wanted, names), fmt::join(names, ", "))};
}

Result<Columns> resolve(const TextPointsOptions& options, const std::vector<Word>& header, bool has_header) {
  Columns made;
  DOBRA_TRY(made.x, column_of(options.columns[0], header, "x"));
  DOBRA_TRY(made.y, column_of(options.columns[1], header, "y"));
  if (options.columns.size() == 3) {
    DOBRA_TRY(made.z, column_of(options.columns[2], header, "height"));
  }
  if (made.x == made.y || made.x == made.z || made.y == made.z) {
    return Error{ErrorCode::InvalidOption, fmt::format("columns {}: one column is given twice; give different ones",
                                                       fmt::join(options.columns, ", "))};
  }
  for (const std::string& name : options.name_columns) {
    DOBRA_TRY(made.names.emplace_back(), column_of(name, header, "name"));
  }
  for (const std::string& name : options.extra_columns) {
    DOBRA_TRY(made.extras.emplace_back(), column_of(name, header, "extra"));
  }
  if (!options.name_columns.empty() || !has_header) return made;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (is_word(header[i].text, text_name_words)) made.names = {i + 1};
    if (is_word(header[i].text, text_kind_words)) made.kind = i + 1;
  }
  return made;
}

// "line 4", "lines 4 and 7", "lines 4, 7, 9, ... (12 in all)".
std::string list_lines(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 8;
  if (lines.size() == 1) return fmt::format("line {}", lines[0]);
  if (lines.size() > most) {
    return fmt::format("lines {}, ... ({} in all)", fmt::join(lines.begin(), lines.begin() + most, ", "), lines.size());
  }
  return fmt::format("lines {} and {}", fmt::join(lines.begin(), lines.end() - 1, ", "), lines.back());
}

// Collects points into lines; one object reads one file.
class TextPointsReader {
 public:
  TextPointsReader(std::string_view text, const std::string& file, const TextPointsOptions& options)
      : text_(text), lines_(text), file_(file), options_(options) {}

  Result<TextPoints> run() {
    if (auto begun = begin(); !begun) return base::located(begun.error(), Place{.file = file_});
    DOBRA_TRY_VOID(find_sign());
    bool first = true;
    bool below_header = has_header_;
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (is_comment(line)) continue;
      if (is_empty(line)) {
        if (options_.blank_lines == BlankLines::SplitLines) DOBRA_TRY_VOID(finish_all());
        continue;
      }
      split_fields(line, points_.separator, fields_);
      if (std::exchange(first, false) && has_header_) {
        points_.header_line = lines_.number();
        continue;
      }
      if (std::exchange(below_header, false) && is_units_row(fields_)) {
        for (const Word& field : fields_) points_.units.emplace_back(field.text);
        continue;
      }
      DOBRA_TRY_VOID(add_point());
    }
    DOBRA_TRY_VOID(finish_all());
    DOBRA_TRY_VOID(check_values());
    if (points_.lines.empty()) {
      return Error{ErrorCode::EmptyFile, "the file holds no points; give at least two", Place{.file = file_}};
    }
    if (!repeated_.empty()) {
      points_.remarks.push_back(fmt::format("{}: {}: repeated {} dropped", file_, list_lines(repeated_),
                                            repeated_.size() == 1 ? "point" : "points"));
    }
    return std::move(points_);
  }

 private:
  // Separator, header and columns.
  Result<void> begin() {
    if (options_.columns.size() != 2 && options_.columns.size() != 3) {
      return Error{
          ErrorCode::InvalidOption,
          fmt::format("{} columns are given; give two (x and y) or three (x, y and height)", options_.columns.size())};
    }
    const std::string_view row = first_row(text_);
    std::string by_name;
    for (const std::string& wanted : options_.columns) {
      if (by_name.empty() && is_name(wanted)) by_name = wanted;
    }
    points_.separator = options_.separator;
    if (points_.separator == Separator::Detect && !by_name.empty()) {
      points_.separator = separator_of_header(row);
    } else if (points_.separator == Separator::Detect) {
      points_.separator = detect_separator(text_, column_number(options_.columns[0]).value_or(1),
                                           column_number(options_.columns[1]).value_or(2));
    }
    split_header(row, points_.separator, fields_);
    points_.column_count = fields_.size();
    has_header_ = options_.header == Header::Present || !by_name.empty();
    DOBRA_TRY(columns_, resolve(options_, fields_, has_header_));
    if (options_.header == Header::Detect && by_name.empty()) {
      has_header_ = fields_.size() >= std::max(columns_.x, columns_.y) && !is_number(fields_, columns_.x) &&
                    !is_number(fields_, columns_.y);
      DOBRA_TRY(columns_, resolve(options_, fields_, has_header_));
    }
    if (has_header_) {
      for (const Word& field : fields_) points_.header.emplace_back(field.text);
    }
    if (has_header_ && columns_.names.empty()) name_by_header();
    points_.columns = {columns_.x, columns_.y};
    if (columns_.z > 0) points_.columns.push_back(columns_.z);
    return {};
  }

  /// The decimal sign of the numbers that are read. @error Unclear with line and column
  Result<void> find_sign() {
    if (text_.find(',') == std::string_view::npos) return {};
    if (points_.separator == Separator::Comma && text_.find('"') == std::string_view::npos) return {};
    DecimalSigns signs;
    std::vector<std::size_t> used = points_.columns;
    used.insert(used.end(), columns_.extras.begin(), columns_.extras.end());
    bool skip = has_header_;
    for (Lines rows(text_); rows.next();) {
      if (is_comment(rows.line()) || is_empty(rows.line()) || std::exchange(skip, false)) continue;
      split_fields(rows.line(), points_.separator, fields_);
      for (const std::size_t column : used) {
        if (column <= fields_.size()) signs.add(fields_[column - 1].text, rows.number(), fields_[column - 1].column);
      }
    }
    auto sign = signs.sign();
    if (!sign) {
      Error error = sign.error();
      error.place->file = file_;
      return error;
    }
    sign_ = *sign;
    if (sign_ == DecimalSign::Comma)
      points_.remarks.push_back(fmt::format("{}: its numbers are read with decimal commas", file_));
    if (const std::string& marked = signs.with_marks(sign_); !marked.empty())
      points_.remarks.push_back(
          fmt::format("{}: marks of thousands in numbers such as {} are left out", file_, shown(marked)));
    return {};
  }

  /// What may stand for no value, in x, y or height.
  void note_value(std::size_t coordinate, double value, std::size_t column) {
    if (stands_for_none(value)) {
      doubtful_[coordinate].push_back(
          {value, std::string(fields_[column - 1].text), lines_.number(), fields_[column - 1].column});
      return;
    }
    least_[coordinate] = std::min(least_[coordinate], value);
    most_[coordinate] = std::max(most_[coordinate], value);
  }

  /// @error BadFormat with the place: a value such as -999.25 that lies far from all others.
  [[nodiscard]] Result<void> check_values() const {
    for (std::size_t i = 0; i < doubtful_.size(); ++i) {
      const double extent = std::max(most_[i] - least_[i], 0.0);
      for (const Doubtful& one : doubtful_[i]) {
        const bool alone = least_[i] > most_[i];
        const bool near = !alone && one.value >= least_[i] - extent && one.value <= most_[i] + extent;
        if (near || alone) continue;
        return Error{ErrorCode::BadFormat,
                     fmt::format("{} stands for no value in many programs, and lies far from all other numbers of its "
                                 "column; take the row out, or give its value",
                                 one.text),
                     Place{.file = file_, .line = one.line, .column = one.column}};
      }
    }
    return {};
  }

  /// More fields than headers, each number in two: commas part the columns and are the decimal sign.
  [[nodiscard]] bool has_commas_of_both_kinds() const {
    if (points_.separator != Separator::Comma || points_.header.size() < 2) return false;
    if (fields_.size() != 2 * points_.header.size()) return false;
    return std::all_of(fields_.begin(), fields_.end(), [](const Word& field) {
      return !field.text.empty() && field.text.find_first_not_of("+-0123456789") == std::string_view::npos;
    });
  }

  /// The column that a header calls "Camada", "horizon" or the like.
  void name_by_header() {
    std::vector<std::size_t> used{columns_.x, columns_.y, columns_.z, columns_.kind};
    used.insert(used.end(), columns_.extras.begin(), columns_.extras.end());
    const WordColumn words = word_column(text_, points_.separator, points_.header, used);
    if (words.words != WordsAre::Names) return;
    columns_.names = {words.column};
    points_.remarks.push_back(told(words, file_));
  }

  /// @param role  what the number is where no header calls it otherwise
  Result<double> number(std::size_t column, std::string_view role) const {
    const bool has_word = has_header_ && column <= points_.header.size() && !points_.header[column - 1].empty();
    const std::string what = has_word ? points_.header[column - 1] : std::string(role);
    const Place at{.file = file_,
                   .line = lines_.number(),
                   .column = column <= fields_.size() ? fields_[column - 1].column : lines_.line().size() + 1};
    if (column > fields_.size()) {
      return Error{ErrorCode::BadFormat,
                   fmt::format("{} is in column {}, but this line has {} separated by {}: {}", what, column,
                               fields_.size(), name_of(points_.separator), shown(lines_.line())),
                   at};
    }
    if (const auto written = number_in(fields_[column - 1].text, sign_); written && std::isfinite(*written))
      return *written;
    Result<double> value = finite_number(fields_[column - 1].text, what);
    if (value) return value;
    Error error = value.error();
    if (column <= points_.header.size() && !says_position(points_.header[column - 1])) {
      error.message +=
          fmt::format("; or say which of the columns {} are x and height (--columns 3,4, columns = [3, 4])",
                      fmt::join(points_.header, ", "));
    }
    return base::located(error, at);
  }

  /// Whether fields between blanks are the words of a name that nothing stands behind.
  [[nodiscard]] bool is_open_name(std::size_t column) const {
    if (points_.separator != Separator::Blank || columns_.names.empty() || column != columns_.names.back())
      return false;
    std::size_t last = std::max({columns_.x, columns_.y, columns_.z, columns_.kind});
    for (const std::size_t other : columns_.extras) last = std::max(last, other);
    return column > last && (!has_header_ || column == points_.header.size());
  }

  /// The words of a name at the end of the row. Without a header a number ends it: it is of another column.
  [[nodiscard]] std::string words_from(std::size_t column) const {
    std::string name = text_in(column);
    for (std::size_t i = column; i < fields_.size(); ++i) {
      const std::string_view word = fields_[i].text;
      if (word.starts_with('#') || (!has_header_ && may_be_number(word))) break;
      name += ' ' + std::string(word);
    }
    if (name.size() > 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    return name;
  }

  /// More fields between blanks than headers, and a name among them that is not the last: which words are its?
  Result<void> check_words_of_names() const {
    if (points_.separator != Separator::Blank || columns_.names.empty() || !has_header_) return {};
    if (columns_.names.back() == points_.header.size()) return {};
    const auto sign =
        std::find_if(fields_.begin(), fields_.end(), [](const Word& word) { return word.text.starts_with('#'); });
    const auto count = static_cast<std::size_t>(sign - fields_.begin());
    if (count <= points_.header.size()) return {};
    return Error{
        ErrorCode::BadFormat,
        fmt::format("this line has {} fields between blanks, and the header {}; put the column of names of several "
                    "words last, or part the columns by tabs or commas",
                    count, points_.header.size()),
        Place{.file = file_, .line = lines_.number()}};
  }

  [[nodiscard]] std::string text_in(std::size_t column) const {
    return column > 0 && column <= fields_.size() ? std::string(fields_[column - 1].text) : std::string();
  }

  Result<void> add_point() {
    DOBRA_TRY_VOID(check_words_of_names());
    if (has_commas_of_both_kinds()) {
      return Error{
          ErrorCode::BadFormat,
          fmt::format("this line has {} numbers between commas, and the header {} columns: its commas seem to be "
                      "decimal signs, too; part the columns by semicolons, or write '.' as the decimal sign",
                      fields_.size(), points_.header.size()),
          Place{.file = file_, .line = lines_.number()}};
    }
    DOBRA_TRY(const double x, number(columns_.x, "x"));
    DOBRA_TRY(const double y, number(columns_.y, "y"));
    double z = 0.0;
    if (columns_.z > 0) {
      DOBRA_TRY(z, number(columns_.z, "height"));
      note_value(2, z, columns_.z);
    }
    note_value(0, x, columns_.x);
    note_value(1, y, columns_.y);
    Line& line = line_of_row();
    if (points_.lines.empty() && line.points.empty()) points_.third_is_number = is_number(fields_, 3);
    const Point point{x, y};
    const bool same =
        !line.points.empty() && line.points.back() == point && (columns_.z == 0 || line.heights.back() == z);
    if (same) {
      repeated_.push_back(lines_.number());
      return {};
    }
    line.points.push_back(point);
    if (columns_.z > 0) line.heights.push_back(z);
    for (const std::size_t column : columns_.extras) {
      if (column > fields_.size()) {
        line.extras.push_back(0.0);
        continue;
      }
      DOBRA_TRY(line.extras.emplace_back(), number(column, "an extra column"));
    }
    return {};
  }

  // A line on its way.
  struct Line {
    std::string name;
    std::string kind;
    std::size_t begin = 0;
    std::vector<Point> points;
    std::vector<double> heights;
    std::vector<double> extras;
  };

  // The line that the current row belongs to.
  Line& line_of_row() {
    std::string name;
    for (const std::size_t column : columns_.names)
      name += (name.empty() ? "" : " ") + (is_open_name(column) ? words_from(column) : text_in(column));
    const std::string kind = text_in(columns_.kind);
    const std::size_t first = options_.rows == Rows::Gathered || open_.empty() ? 0 : open_.size() - 1;
    for (std::size_t i = first; i < open_.size(); ++i) {
      if (open_[i].name == name && open_[i].kind == kind) return open_[i];
    }
    open_.push_back({name, kind, lines_.number(), {}, {}, {}});
    return open_.back();
  }

  Result<void> finish_all() {
    for (Line& line : open_) DOBRA_TRY_VOID(finish(std::move(line)));
    open_.clear();
    return {};
  }

  [[nodiscard]] bool is_kind(const std::string& word) const {
    if (options_.kinds.empty()) return known_kind(word).has_value();
    return std::find(options_.kinds.begin(), options_.kinds.end(), word) != options_.kinds.end();
  }
  [[nodiscard]] std::string hint_of_kind(const std::string& word) const {
    if (options_.kinds.empty()) return kind_hint(word);
    if (std::string hint = base::did_you_mean(word, options_.kinds); !hint.empty()) return hint;
    return fmt::format("; give one of {}", fmt::join(options_.kinds, ", "));
  }

  /// A row stands alone where its name or kind differs from those of its neighbours, itself or a neighbour misspelt.
  [[nodiscard]] Error lone_point(const Line& line) const {
    const auto unknown = [&](const Line& other) {
      return other.name == line.name && other.points.size() == 1 && !other.kind.empty() && !is_kind(other.kind);
    };
    const auto misspelt = std::find_if(open_.begin(), open_.end(), unknown);
    const Line& lone = misspelt != open_.end() && !unknown(line) ? *misspelt : line;
    Error error{ErrorCode::DegenerateCurve,
                {},
                Place{.file = file_, .line = lone.begin, .x = lone.points[0].x, .y = lone.points[0].y}};
    if (unknown(lone)) {
      error.message = fmt::format("unknown kind '{}', in this row only{}", lone.kind, hint_of_kind(lone.kind));
      return error;
    }
    const std::string name = line.name.empty() ? std::string() : fmt::format(" '{}'", line.name);
    const std::string kind = line.kind.empty() ? std::string() : fmt::format(" of kind '{}'", line.kind);
    error.message = fmt::format("a line needs at least two distinct points; this one{}{} has 1", name, kind);
    return error;
  }

  Result<void> finish(Line line) {
    std::vector<Point>& points = line.points;
    if (points.size() < 2) return lone_point(line);
    const bool returns =
        points.front() == points.back() && (line.heights.empty() || line.heights.front() == line.heights.back());
    const bool closed = options_.closing == Closing::WhenFirstPointRepeats && points.size() > 3 && returns;
    if (closed) points.pop_back();
    if (closed && !line.heights.empty()) line.heights.pop_back();
    if (closed) line.extras.resize(line.extras.size() - columns_.extras.size());
    points_.lines.push_back({std::move(points), closed});
    if (columns_.z > 0) points_.heights.push_back(std::move(line.heights));
    if (!columns_.extras.empty()) points_.extras.push_back(std::move(line.extras));
    points_.names.push_back(std::move(line.name));
    points_.kinds.push_back(std::move(line.kind));
    points_.begins.push_back(line.begin);
    return {};
  }

  std::string_view text_;
  Lines lines_;
  std::string file_;
  TextPointsOptions options_;
  Columns columns_;
  bool has_header_ = false;
  DecimalSign sign_ = DecimalSign::Point;
  struct Doubtful {
    double value = 0.0;
    std::string text;
    std::size_t line = 0, column = 0;
  };
  std::array<std::vector<Doubtful>, 3> doubtful_;  ///< Of x, y and height.
  std::array<double, 3> least_{highest, highest, highest};
  std::array<double, 3> most_{-highest, -highest, -highest};
  TextPoints points_;
  std::vector<Line> open_;
  std::vector<std::size_t> repeated_;
  std::vector<Word> fields_;
};

}  // namespace

bool is_word(std::string_view text, std::span<const std::string_view> words) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return std::equal(text.begin(), text.end(), word.begin(), word.end(), same);
  });
}

Result<TextPoints> parse_text_points(std::string_view text, const std::string& file, const TextPointsOptions& options) {
  DOBRA_TRY_VOID(check_text(text, file));
  return TextPointsReader(text, file, options).run();
}

Result<TextPoints> read_text_points(const std::string& path, const TextPointsOptions& options) {
  DOBRA_TRY(const std::string text, read_text(path));
  return parse_text_points(text, path, options);
}

Result<std::string> points_csv(std::span<const Polyline> lines, std::string_view x_name, std::string_view y_name) {
  std::string text = fmt::format("{},{}\n", x_name, y_name);
  const auto add = [&](Point p) { text += base::number_text(p.x) + ',' + base::number_text(p.y) + '\n'; };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    DOBRA_TRY_VOID(check_finite(lines[i].points, fmt::format("line {}", i + 1)));
    if (i > 0) text += '\n';
    for (const Point p : lines[i].points) add(p);
    if (lines[i].closed && !lines[i].points.empty()) add(lines[i].points.front());
  }
  return text;
}

Result<void> write_points_csv(const std::string& path, std::span<const Polyline> lines, std::string_view x_name,
                              std::string_view y_name) {
  return write_text(path, points_csv(lines, x_name, y_name));
}

}  // namespace dobra::io::lines
