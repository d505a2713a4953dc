#include "shared/io/lines/text_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/base/text.h"
#include "shared/io/scan.h"

namespace dobra::io::lines {

using base::Error;
using base::ErrorCode;
using base::Place;

namespace {

constexpr std::array<std::string_view, 4> blanks{" ", "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// With the digits of the whole part without marks between their groups, and '.' as decimal sign; nothing where the
/// marks do not stand between groups of three, or are of two kinds.
std::optional<std::string> without_marks(std::string_view field, char decimal, std::string_view mark) {
  std::string made;
  std::size_t at = 0;
  if (field.starts_with('+') || field.starts_with('-')) made += field[at++];
  std::size_t run = 0;
  std::size_t groups = 0;
  const std::size_t begin = at;
  std::string_view used;
  for (; at < field.size();) {
    if (is_digit(field[at])) {
      made += field[at++];
      ++run;
      continue;
    }
    std::string_view found;
    for (const std::string_view blank : blanks) {
      if (field.substr(at).starts_with(blank)) found = blank;
    }
    if (field.substr(at).starts_with(mark)) found = mark;
    if (found.empty()) break;
    const bool group = groups == 0 ? run >= 1 && run <= 3 && field[begin] != '0' : run == 3;
    if (!group || (!used.empty() && used != found)) return std::nullopt;
    used = found;
    run = 0;
    ++groups;
    at += found.size();
  }
  if (run == 0 || (groups > 0 && run != 3)) return std::nullopt;
  if (at < field.size() && field[at] == decimal) {
    made += '.';
    const std::size_t first = ++at;
    while (at < field.size() && is_digit(field[at])) made += field[at++];
    if (at == first) return std::nullopt;
  }
  const std::string_view rest = field.substr(at);
  if (!rest.empty() && rest[0] != 'e' && rest[0] != 'E') return std::nullopt;
  return made += rest;
}

std::optional<double> reading(std::string_view field, char decimal, std::string_view mark) {
  const auto plain = without_marks(field, decimal, mark);
  return plain ? base::parse_number(*plain) : std::nullopt;
}

Error unclear(std::string message, std::size_t line, std::size_t column) {
  return {ErrorCode::Unclear, std::move(message), Place{.line = line, .column = column}};
}

}  // namespace

NumberReadings readings_of(std::string_view field) {
  NumberReadings made;
  made.with_point = base::parse_number(field);
  if (!made.with_point) made.with_point = reading(field, '.', ",");
  made.with_comma = reading(field, ',', ".");
  // "inf", "5." and the like hold nothing that a comma would change.
  if (!made.with_comma && made.with_point && field.find_first_of(".,") == std::string_view::npos)
    made.with_comma = made.with_point;
  return made;
}

bool may_be_number(std::string_view field) {
  if (base::parse_number(field)) return true;
  const NumberReadings readings = readings_of(field);
  return readings.with_point || readings.with_comma;
}

std::optional<double> number_in(std::string_view field, DecimalSign sign) {
  if (sign == DecimalSign::Comma) return readings_of(field).with_comma;
  if (const auto plain = base::parse_number(field)) return plain;
  return readings_of(field).with_point;
}

bool stands_for_none(double value) {
  static constexpr std::array<double, 12> known{-999.0,   -999.25,   -9999.0,    -9999.25,
                                                -99999.0, -99999.25, 9999900.0,  1e30,
                                                -1e30,    1e31,      1.70141e38, 1.701410009187828e38};
  return std::find(known.begin(), known.end(), value) != known.end();
}

void DecimalSigns::add(std::string_view field, std::size_t line, std::size_t column) {
  const NumberReadings readings = readings_of(field);
  const auto keep = [&](std::optional<Field>& first) {
    if (!first) first = Field{std::string(field), line, column};
  };
  if (!readings.with_point && !readings.with_comma) return;
  const std::size_t comma = field.find(',');
  const std::size_t point = field.find('.');
  if (!readings.with_comma) {
    keep(point_);
    if (comma != std::string_view::npos && comma_marks_.empty()) comma_marks_ = field;
  } else if (!readings.with_point) {
    keep(comma_);
    if (point != std::string_view::npos && point_marks_.empty()) point_marks_ = field;
  } else if (*readings.with_point != *readings.with_comma) {
    keep(comma != std::string_view::npos ? comma_or_marks_ : point_or_marks_);
    if (comma != std::string_view::npos && comma_marks_.empty()) comma_marks_ = field;
  }
}

base::Result<DecimalSign> DecimalSigns::sign() const {
  if (point_ && comma_) {
    const bool point_first =
        point_->line < comma_->line || (point_->line == comma_->line && point_->column < comma_->column);
    const Field& first = point_first ? *point_ : *comma_;
    const Field& second = point_first ? *comma_ : *point_;
    return unclear(fmt::format("the number {} has another decimal sign than {} in line {}; write all numbers of the "
                               "file alike",
                               shown(second.text), shown(first.text), first.line),
                   second.line, second.column);
  }
  const auto two = [&](const Field& field) {
    const NumberReadings readings = readings_of(field.text);
    return unclear(
        fmt::format("the number {} may be {} or {}, and no other number of the file tells; write '.' as the decimal "
                    "sign and no marks of thousands",
                    shown(field.text), std::min(*readings.with_point, *readings.with_comma),
                    std::max(*readings.with_point, *readings.with_comma)),
        field.line, field.column);
  };
  if (comma_) {
    if (point_or_marks_ && point_marks_.empty()) return two(*point_or_marks_);
    return DecimalSign::Comma;
  }
  if (comma_or_marks_ && !point_) return two(*comma_or_marks_);
  return DecimalSign::Point;
}

}  // namespace dobra::io::lines
