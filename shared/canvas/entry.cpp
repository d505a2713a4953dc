#include "shared/canvas/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shared/base/text.h"

namespace dobra::canvas {

namespace {

base::Error bad(std::string message) { return {base::ErrorCode::BadValue, std::move(message)}; }

base::Error unreadable(std::string_view text) {
  return bad(fmt::format(
      fmt::runtime(base::translated("'{}' is no place; type x,z or @dx,dz or @distance<degrees or a length")), text));
}

/// A number whose decimals stand behind a point or a comma.
std::optional<double> number(std::string_view text) {
  std::string plain(base::trimmed(text));
  if (std::count(plain.begin(), plain.end(), ',') + std::count(plain.begin(), plain.end(), '.') > 1)
    return std::nullopt;
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (plain.starts_with('+')) plain.erase(0, 1);
  const std::optional<double> value = base::parse_number(plain);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// The texts of the numbers: parted by a semicolon, else by blanks, else by a comma that is no decimal mark.
std::vector<std::string_view> parts_of(std::string_view text, DecimalMark mark) {
  const auto part_at = [&](std::string_view separators) {
    std::vector<std::string_view> parts;
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find_first_of(separators, from), text.size());
      if (to > from || separators == ";" || separators == ",") parts.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    return parts;
  };
  if (text.find(';') != std::string_view::npos) return part_at(";");
  const std::vector<std::string_view> words = part_at(" \t");
  const bool comma_ends_word = words.size() == 2 && words[0].ends_with(',');  // "12, 5"
  if (comma_ends_word) return {words[0].substr(0, words[0].size() - 1), words[1]};
  if (words.size() > 1) return words;
  // A comma beside a point parts two numbers: "12.5,7.25".
  const bool may_be_decimal = mark == DecimalMark::Comma && text.find('.') == std::string_view::npos;
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas == 0 || (commas == 1 && may_be_decimal)) return {text};
  return part_at(",");
}

base::Result<geom::Point> polar(std::string_view text, std::string_view body, geom::Point last) {
  const std::size_t sign = body.find('<');
  const std::optional<double> distance = number(body.substr(0, sign));
  const std::optional<double> degrees = number(body.substr(sign + 1));
  if (!distance || !degrees) return unreadable(text);
  // sin and cos of whole quarters are exact, so that "@100<90" goes straight up.
  const double quarters = *degrees / 90.0;
  const double radians = *degrees * std::numbers::pi / 180.0;
  geom::Vector way{std::cos(radians), std::sin(radians)};
  if (quarters == std::floor(quarters)) way = {std::round(way.x), std::round(way.y)};
  return last + *distance * way;
}

}  // namespace

base::Result<geom::Point> parse_entry(std::string_view text, const EntryContext& context) {
  std::string_view body = base::trimmed(text);
  const bool relative = body.starts_with('@');
  if (relative) body = base::trimmed(body.substr(1));
  const bool has_angle = body.find('<') != std::string_view::npos;
  const std::vector<std::string_view> parts = parts_of(body, context.mark);
  if (!context.last && (relative || has_angle || parts.size() == 1))
    return bad(base::translated("there is no place before to measure from; type x,z"));
  if (has_angle) return polar(text, body, *context.last);
  std::vector<double> values;
  for (const std::string_view part : parts) {
    const std::optional<double> value = number(part);
    if (!value) return unreadable(text);
    values.push_back(*value);
  }
  if (values.size() == 2)
    return relative ? *context.last + geom::Vector{values[0], values[1]} : geom::Point{values[0], values[1]};
  if (values.size() != 1 || relative) return unreadable(text);
  if (!context.towards || length_squared(*context.towards) == 0.0)
    return bad(base::translated("a length needs a direction: move the cursor to where the line is to go"));
  return *context.last + values[0] * geom::normalised(*context.towards);
}

}  // namespace dobra::canvas
