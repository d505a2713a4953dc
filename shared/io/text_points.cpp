#include "shared/io/text_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/scan.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Polyline;

namespace {

constexpr std::size_t detect_lines = 1000;

bool is_comment(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '#';
}

bool is_empty(std::string_view line) { return line.find_first_not_of(" \t\v\f") == std::string_view::npos; }

char sign_of(Separator separator) {
  switch (separator) {
    case Separator::Tab:
      return '\t';
    case Separator::Comma:
      return ',';
    case Separator::Semicolon:
      return ';';
    default:
      return ' ';
  }
}

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

// Fields of a line; a field in double quotes may hold the separator.
void split_fields(std::string_view line, Separator separator, std::vector<Word>& fields) {
  if (separator == Separator::Blank) {
    split_words(line, fields);
    return;
  }
  fields.clear();
  const char sign = sign_of(separator);
  std::size_t begin = 0;
  bool in_quotes = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') in_quotes = !in_quotes;
    if (i < line.size() && (line[i] != sign || in_quotes)) continue;
    std::size_t low = begin;
    std::size_t high = i;
    const auto strip = [&](std::string_view what) {
      while (low < high && what.find(line[low]) != std::string_view::npos) ++low;
      while (low < high && what.find(line[high - 1]) != std::string_view::npos) --high;
    };
    strip(" \t\v\f");
    if (high - low >= 2 && line[low] == '"' && line[high - 1] == '"') ++low, --high;
    strip(" \t\v\f");
    fields.push_back({line.substr(low, high - low), low + 1});
    begin = i + 1;
  }
}

bool is_number(const std::vector<Word>& fields, std::size_t column) {
  return column <= fields.size() && base::parse_number(fields[column - 1].text).has_value();
}

Separator detect_separator(std::string_view text, const TextPointsOptions& options) {
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
      if (is_number(fields, options.x_column) && is_number(fields, options.y_column)) ++fits[i];
    }
  }
  const auto best = std::max_element(fits.begin(), fits.end());
  // Where nothing fits the file is wrong; the message then speaks of the separator that its first line shows.
  if (*best == 0) return in_first_line.value_or(Separator::Blank);
  return candidates[static_cast<std::size_t>(best - fits.begin())];
}

Result<void> check_options(const TextPointsOptions& options) {
  const auto refuse = [](std::string message) { return Error{ErrorCode::InvalidOption, std::move(message)}; };
  if (options.x_column == 0 || options.y_column == 0) return refuse("columns are counted from 1; give 1 or more");
  if (options.x_column == options.y_column) {
    return refuse(fmt::format("x and y are both column {}; give two different columns", options.x_column));
  }
  if (!std::isfinite(options.unit_factor) || options.unit_factor <= 0.0) {
    return refuse(fmt::format("the unit factor is {}; give a number above 0", options.unit_factor));
  }
  if (!std::isfinite(options.y_reference)) return refuse("the reference of y is not finite; give a number");
  return {};
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
class Reader {
 public:
  Reader(std::string_view text, const std::string& file, const TextPointsOptions& options)
      : lines_(text), file_(file), options_(options) {
    points_.separator = options.separator == Separator::Detect ? detect_separator(text, options) : options.separator;
  }

  Result<TextPoints> run() {
    bool first = true;
    while (lines_.next()) {
      const std::string_view line = lines_.line();
      if (is_comment(line)) continue;
      if (is_empty(line)) {
        if (options_.blank_lines == BlankLines::SplitLines) DOBRA_TRY_VOID(finish_line());
        continue;
      }
      split_fields(line, points_.separator, fields_);
      const bool header = std::exchange(first, false) && is_header();
      if (!header) DOBRA_TRY_VOID(add_point());
    }
    DOBRA_TRY_VOID(finish_line());
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
  bool is_header() const {
    if (options_.header != Header::Detect) return options_.header == Header::Present;
    return fields_.size() >= std::max(options_.x_column, options_.y_column) && !is_number(fields_, options_.x_column) &&
           !is_number(fields_, options_.y_column);
  }

  Result<double> number(std::size_t column, std::string_view what) const {
    const Place at{.file = file_,
                   .line = lines_.number(),
                   .column = column <= fields_.size() ? fields_[column - 1].column : lines_.line().size() + 1};
    if (column > fields_.size()) {
      return Error{ErrorCode::BadFormat,
                   fmt::format("{} is in column {}, but this line has {} separated by {}: {}", what, column,
                               fields_.size(), name_of(points_.separator), shown(lines_.line())),
                   at};
    }
    Result<double> value = finite_number(fields_[column - 1].text, what);
    if (!value) return base::located(value.error(), at);
    return value;
  }

  Result<void> add_point() {
    DOBRA_TRY(const double x, number(options_.x_column, "x"));
    DOBRA_TRY(const double y, number(options_.y_column, "y"));
    const double up = options_.y_direction == YDirection::Up ? y : options_.y_reference - y;
    const Point point{x * options_.unit_factor, up * options_.unit_factor};
    if (!geom::is_finite(point)) {
      return Error{ErrorCode::NotFinite, "the point is not finite after the change of units; correct it or the factor",
                   Place{.file = file_, .line = lines_.number()}};
    }
    if (current_.points.empty()) first_line_ = lines_.number();
    if (!current_.points.empty() && current_.points.back() == point) {
      repeated_.push_back(lines_.number());
    } else {
      current_.points.push_back(point);
    }
    return {};
  }

  Result<void> finish_line() {
    if (current_.points.empty()) return {};
    std::vector<Point>& points = current_.points;
    if (points.size() < 2) {
      return Error{ErrorCode::DegenerateCurve, "a line needs at least two distinct points; this one has 1",
                   Place{.file = file_, .line = first_line_, .x = points[0].x, .y = points[0].y}};
    }
    if (options_.closing == Closing::WhenFirstPointRepeats && points.size() > 3 && points.front() == points.back()) {
      points.pop_back();
      current_.closed = true;
    }
    points_.lines.push_back(std::move(current_));
    current_ = {};
    return {};
  }

  Lines lines_;
  std::string file_;
  TextPointsOptions options_;
  TextPoints points_;
  Polyline current_;
  std::size_t first_line_ = 0;
  std::vector<std::size_t> repeated_;
  std::vector<Word> fields_;
};

}  // namespace

Result<TextPoints> parse_text_points(std::string_view text, const std::string& file, const TextPointsOptions& options) {
  if (auto checked = check_options(options); !checked) return base::located(checked.error(), Place{.file = file});
  DOBRA_TRY_VOID(check_text(text, file));
  return Reader(text, file, options).run();
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
  DOBRA_TRY(const std::string text, points_csv(lines, x_name, y_name));
  return write_file(path, text);
}

}  // namespace dobra::io
