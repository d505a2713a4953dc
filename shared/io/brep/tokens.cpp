#include "shared/io/brep/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "shared/io/scan.h"

namespace dobra::io::brep {

using base::Result;

namespace {
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }
}  // namespace

void Tokens::skip_blanks() {
  for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) {
    if (text_[at_] != '\n') continue;
    ++line_;
    begin_of_line_ = at_ + 1;
  }
}

std::string_view Tokens::peek() {
  skip_blanks();
  std::size_t end = at_;
  while (end < text_.size() && !is_blank(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

Result<std::string_view> Tokens::word(std::string_view what) {
  const std::string_view found = peek();
  said_line_ = line_;
  said_column_ = at_ - begin_of_line_ + 1;
  if (found.empty()) return error(fmt::format("the file ends before {}; it is cut short", what));
  at_ += found.size();
  return found;
}

Result<void> Tokens::expect(std::string_view keyword) {
  DOBRA_TRY(const std::string_view found, word(fmt::format("'{}'", keyword)));
  if (found != keyword) return error(fmt::format("{} stands where '{}' belongs", shown(found), keyword));
  return {};
}

Result<double> Tokens::number(std::string_view what) {
  DOBRA_TRY(const std::string_view found, word(what));
  const auto number = finite_number(found, what);
  if (!number) return error(number.error().message, number.error().code);
  return *number;
}

Result<geom::Vector3> Tokens::vector(std::string_view what) {
  DOBRA_TRY(const double x, number(what));
  DOBRA_TRY(const double y, number(what));
  DOBRA_TRY(const double z, number(what));
  return geom::Vector3{x, y, z};
}

Result<geom::Point3> Tokens::point(std::string_view what) {
  DOBRA_TRY(const geom::Vector3 v, vector(what));
  return geom::Point3{} + v;
}

Result<geom::Point3> Tokens::point_of_chart(std::string_view what) {
  DOBRA_TRY(const double u, number(what));
  DOBRA_TRY(const double v, number(what));
  return geom::Point3{u, v, 0.0};
}

Result<long> Tokens::integer(std::string_view what, long low, long high) {
  DOBRA_TRY(const std::string_view found, word(what));
  long value = 0;
  const auto [end, bad] = std::from_chars(found.data(), found.data() + found.size(), value);
  if (bad != std::errc() || end != found.data() + found.size())
    return error(fmt::format("{} stands where {}, an integer, belongs", shown(found), what));
  if (value < low || value > high) return error(fmt::format("{} is {}; it can be {} to {}", what, value, low, high));
  return value;
}

Result<bool> Tokens::flag(std::string_view what) {
  DOBRA_TRY(const long value, integer(what, 0, 1));
  return value == 1;
}

Result<std::size_t> Tokens::count(std::string_view what, std::size_t words_each) {
  DOBRA_TRY(const long value, integer(what, 0, static_cast<long>(most_items)));
  const auto wanted = static_cast<std::size_t>(value);
  if (wanted > 0 && (text_.size() - at_) / (2 * words_each) + 1 < wanted)
    return error(fmt::format("{} is {}, for which the rest of the file is too short", what, wanted));
  return wanted;
}

Result<std::size_t> Tokens::index(std::string_view what, std::size_t size, After after) {
  DOBRA_TRY(const std::string_view found, word(what));
  std::size_t value = 0;
  const char* end = found.data() + found.size();
  const auto [rest, bad] = std::from_chars(found.data(), end, value);
  if (bad != std::errc() || (rest != end && after == After::Blank))
    return error(fmt::format("{} stands where the number of {} belongs", shown(found), what));
  at_ -= static_cast<std::size_t>(end - rest);
  if (value < 1 || value > size) return error(fmt::format("there is no {} {}; the file has {}", what, value, size));
  return value - 1;
}

void Tokens::skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

base::Error Tokens::error(std::string message, base::ErrorCode code) const {
  return {code, std::move(message), base::Place{.file = file_, .line = said_line_, .column = said_column_}};
}

}  // namespace dobra::io::brep
