#include "shared/canvas/line_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "shared/base/text.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;

base::Error unreadable_line(std::size_t number, std::string_view line) {
  constexpr std::size_t shown = 40;
  const std::string start = line.size() > shown ? std::string(line.substr(0, shown)) + "..." : std::string(line);
  return {base::ErrorCode::BadValue,
          fmt::format(fmt::runtime(translated("line {} of the clipboard, '{}', is no pair of numbers x and z")), number,
                      start),
          {}};
}

std::optional<double> coordinate(std::string_view word) {
  std::string plain(base::trimmed(word));
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (plain.starts_with("\u2212")) plain.replace(0, 3, "-");
  if (plain.starts_with('+')) plain.erase(0, 1);
  const std::optional<double> value = base::parse_number(plain);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Parted by tabs, else by semicolons, else by blanks, else by commas.
std::vector<std::string_view> words_of(std::string_view line) {
  const auto parted = [&](std::string_view separators, bool may_be_empty) {
    std::vector<std::string_view> words;
    for (std::size_t from = 0; from <= line.size();) {
      const std::size_t to = std::min(line.find_first_of(separators, from), line.size());
      if (to > from || may_be_empty) words.push_back(line.substr(from, to - from));
      from = to + 1;
    }
    return words;
  };
  if (line.find('\t') != std::string_view::npos) return parted("\t", true);
  if (line.find(';') != std::string_view::npos) return parted(";", true);
  std::vector<std::string_view> words = parted(" ", false);
  if (words.size() == 1) return parted(",", true);
  for (std::string_view& word : words) {  // "1, 2"
    if (word.ends_with(',')) word.remove_suffix(1);
  }
  return words;
}

std::optional<Point> point_of(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 2) return std::nullopt;
  const std::optional<double> x = coordinate(words[0]);
  const std::optional<double> y = coordinate(words[1]);
  return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

/// "[[0, 1], [2, 3]]", with "points =" before it or without, as text of a pair a line.
std::string unbracketed(std::string_view text) {
  std::string made;
  int depth = 0;
  for (const char c : text) {
    if (c == '[') {
      ++depth;
    } else if (c == ']') {
      if (depth == 2) made += '\n';
      depth = std::max(0, depth - 1);
    } else if (depth == 2 && c != '\n' && c != '\r') {
      made += c;
    }
  }
  return made;
}

void close_up(NamedLine& line) {
  std::vector<Point>& points = line.line.points;
  // The same place twice is one vertex.
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 4 || points.front() != points.back()) return;
  points.pop_back();
  line.line.closed = true;
}

}  // namespace

std::string text_of_lines(std::span<const NamedLine> lines) {
  std::string text;
  for (const NamedLine& line : lines) {
    if (!text.empty()) text += '\n';
    if (!line.name.empty()) text += "# " + line.name + '\n';
    const auto add = [&](Point p) { text += fmt::format("{}\t{}\n", p.x, p.y); };
    for (const Point p : line.line.points) add(p);
    if (line.line.closed && !line.line.points.empty()) add(line.line.points.front());
  }
  return text;
}

base::Result<std::vector<NamedLine>> lines_of_text(std::string_view text) {
  const std::string inner = text.find("[[") != std::string_view::npos ? unbracketed(text) : std::string(text);
  std::vector<NamedLine> lines;
  NamedLine now;
  const auto end_line = [&] {
    if (!now.line.points.empty()) {
      close_up(now);
      lines.push_back(std::move(now));
    }
    now = {};
  };
  bool header = true;  // words alone, before the first number
  std::size_t number = 0;
  for (std::size_t from = 0; from <= inner.size();) {
    const std::size_t to = std::min(inner.find_first_of("\n\r", from), inner.size());
    const std::string_view line = base::trimmed(std::string_view(inner).substr(from, to - from));
    from = to + (inner.compare(to, 2, "\r\n") == 0 ? 2 : 1);
    ++number;
    if (line.empty()) {
      end_line();
    } else if (line.front() == '#') {
      end_line();
      now.name = base::trimmed(line.substr(1));
    } else if (const std::optional<Point> point = point_of(line)) {
      now.line.points.push_back(*point);
      header = false;
    } else {
      const std::vector<std::string_view> words = words_of(line);
      const bool numbers = std::any_of(words.begin(), words.end(), [](auto word) { return coordinate(word); });
      if (!header || numbers || words.size() < 2) return unreadable_line(number, line);
      header = false;
    }
  }
  end_line();
  if (lines.empty())
    return base::Error{base::ErrorCode::BadValue,
                       translated("the clipboard holds no points: a pair of numbers x and z on each line"),
                       {}};
  return lines;
}

}  // namespace dobra::canvas
