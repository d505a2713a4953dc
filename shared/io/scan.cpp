#include "shared/io/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "shared/base/text.h"

namespace dobra::io {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

// Words between a separator such as ','; blanks round them are taken away, an empty last word is not a word.
void split_at(std::string_view line, char separator, std::vector<Word>& words) {
  words.clear();
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    std::string_view text = line.substr(begin, end - begin);
    std::size_t column = begin + 1;
    while (!text.empty() && is_blank(text.front())) {
      text.remove_prefix(1);
      ++column;
    }
    text = base::trimmed(text);
    if (end < line.size() || !text.empty()) words.push_back({text, column});
    begin = end + 1;
  }
}

}  // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string_view part = text.substr(0, longest);
  if (part.size() < text.size()) {
    // Not in the middle of a UTF-8 sequence.
    while (!part.empty() && (static_cast<unsigned char>(text[part.size()]) & 0xC0U) == 0x80U) part.remove_suffix(1);
  }
  std::string result = "'";
  for (const char c : part) result += (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) ? '?' : c;
  return result + (part.size() < text.size() ? "...'" : "'");
}

Result<void> check_text(std::string_view text, const std::string& file) {
  if (text.find_first_not_of(" \t\r\n\v\f\xEF\xBB\xBF") == std::string_view::npos) {
    return Error{ErrorCode::EmptyFile, "the file is empty; give one that has data", Place{.file = file}};
  }
  const std::size_t zero = text.find('\0');
  if (zero == std::string_view::npos) return {};
  Lines lines(text);
  while (lines.next()) {
    const std::size_t at = lines.line().find('\0');
    if (at == std::string_view::npos) continue;
    return Error{ErrorCode::BadFormat, "this is a binary file (it holds a zero byte); give a text file",
                 Place{.file = file, .line = lines.number(), .column = at + 1}};
  }
  return Error{ErrorCode::BadFormat, "this is a binary file; give a text file", Place{.file = file}};
}

Result<double> finite_number(std::string_view text, std::string_view what) {
  if (text.empty()) return Error{ErrorCode::BadFormat, fmt::format("{} is missing; a number is needed", what)};
  const std::optional<double> value = base::parse_number(text);
  if (!value && text.find(',') != std::string_view::npos) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("{} {} is not a number; write '.' as the decimal sign", what, shown(text))};
  }
  if (!value) {
    return Error{ErrorCode::BadFormat,
                 fmt::format("{} {} is not a number of double precision; correct or remove it", what, shown(text))};
  }
  if (!std::isfinite(*value)) {
    return Error{ErrorCode::NotFinite, fmt::format("{} {} is not finite; correct or remove it", what, shown(text))};
  }
  return *value;
}

Result<void> check_finite(std::span<const geom::Point> points, std::string_view what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (geom::is_finite(points[i])) continue;
    return Error{ErrorCode::NotFinite, fmt::format("point {} of {} is not finite and cannot be written", i + 1, what)};
  }
  return {};
}

Place place_of_byte(std::string_view text, std::size_t offset, const std::string& file) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return Place{.file = file,
               .line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')),
               .column = before.size() - line_begin + 1};
}

Lines::Lines(std::string_view text) : rest_(text) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

bool Lines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  const bool crlf = rest_.substr(end).starts_with("\r\n");
  rest_.remove_prefix(std::min(end + (crlf ? 2 : 1), rest_.size()));
  ++number_;
  return true;
}

void split_words(std::string_view line, std::vector<Word>& words) {
  words.clear();
  std::size_t i = 0;
  while (true) {
    while (i < line.size() && is_blank(line[i])) ++i;
    if (i == line.size()) return;
    const std::size_t begin = i;
    while (i < line.size() && !is_blank(line[i])) ++i;
    words.push_back({line.substr(begin, i - begin), begin + 1});
  }
}

Records::Records(std::string_view text, std::string file, char comment, char separator)
    : lines_(text), file_(std::move(file)), comment_(comment), separator_(separator) {}

bool Records::next() {
  if (again_) {
    again_ = false;
    return true;
  }
  while (lines_.next()) {
    const std::string_view line = lines_.line().substr(0, lines_.line().find(comment_));
    if (separator_ == ' ')
      split_words(line, words_);
    else
      split_at(line, separator_, words_);
    if (!words_.empty()) return true;
  }
  words_.clear();
  return false;
}

Result<void> Records::expect(std::string_view what) {
  if (next()) return {};
  return Error{ErrorCode::BadFormat, fmt::format("the file ends before {}; it may have been cut short", what),
               Place{.file = file_, .line = lines_.number()}};
}

Place Records::place(std::size_t i) const {
  return Place{.file = file_,
               .line = lines_.number(),
               .column = i < words_.size() ? words_[i].column : lines_.line().size() + 1};
}

Error Records::error(std::size_t i, std::string message) const {
  return Error{ErrorCode::BadFormat, std::move(message), place(i)};
}

Result<double> Records::number(std::size_t i, std::string_view what) const {
  Result<double> value = finite_number(i < words_.size() ? words_[i].text : std::string_view{}, what);
  if (!value) return base::located(value.error(), place(i));
  return value;
}

Result<std::int64_t> Records::integer(std::size_t i, std::string_view what) const {
  const std::string_view text = i < words_.size() ? words_[i].text : std::string_view{};
  if (text.empty()) return error(i, fmt::format("{} is missing; an integer is needed", what));
  std::int64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc{} && end == text.data() + text.size()) return value;
  return error(i, fmt::format("{} {} is not an integer", what, shown(text)));
}

Result<std::size_t> Records::count(std::size_t i, std::string_view what, std::size_t limit) const {
  DOBRA_TRY(const std::int64_t value, integer(i, what));
  if (value >= 0 && static_cast<std::uint64_t>(value) <= limit) return static_cast<std::size_t>(value);
  if (value < 0) return error(i, fmt::format("{} {} is negative", what, value));
  return error(i, fmt::format("{} {} is above {}", what, value, limit));
}

}  // namespace dobra::io
