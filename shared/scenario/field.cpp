#include "shared/scenario/field.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/scenario/list_text.h"
#include "shared/scenario/toml_reader.h"
#include "shared/scenario/toml_text.h"
#include "shared/scenario/units.h"

namespace dobra::scenario {
namespace {

using base::Error;
using base::ErrorCode;

/// A number for people: 0 and 12, not 0.0 and 12.0.
std::string plain(double value) { return fmt::format("{}", value); }

std::string joined_choices(const Field& field) {
  std::string out;
  for (const std::string& choice : field.choices) out += (out.empty() ? "'" : ", '") + choice + "'";
  return out;
}

std::string wanted(const Field& field) {
  switch (field.kind) {
    case Kind::Flag:
      return "true or false";
    case Kind::Integer:
      return "a whole number";
    case Kind::Number:
      return "a number";
    case Kind::Degrees:
      return "an angle in degrees";
    case Kind::Text:
      return "a text in quotes";
    case Kind::Choice:
      return "one of " + joined_choices(field);
    case Kind::File:
      return "a file name in quotes";
    case Kind::Point:
      return "a point [x, y]";
    case Kind::Point3:
      return "a point or direction in space [x, y, z]";
    case Kind::Numbers:
      return "a list of numbers";
    case Kind::Points:
      return "a list of points [[x, y], ...]";
    case Kind::Points3:
      return "a list of points in space [[x, y, z], ...]";
    case Kind::Texts:
      return "a list of texts";
    case Kind::Tables:
      return "tables under double brackets";
  }
  return {};
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return count == 0 ? "an empty list" : fmt::format("a list of {} {}", count, count == 1 ? one : many);
}

struct FoundText {
  std::string operator()(bool flag) const { return flag ? "true" : "false"; }
  std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
  std::string operator()(double number) const { return base::number_text(number); }
  std::string operator()(const std::string& text) const {
    // Cut between characters, not inside one.
    std::size_t length = std::min<std::size_t>(text.size(), 40);
    while (length < text.size() && length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
    return fmt::format("the text {}", value_toml(text.substr(0, length) + (length < text.size() ? "..." : "")));
  }
  std::string operator()(geom::Point point) const { return "the point " + value_toml(point); }
  std::string operator()(const std::vector<double>& list) const { return counted(list.size(), "number", "numbers"); }
  std::string operator()(const Points& list) const { return counted(list.size(), "point", "points"); }
  std::string operator()(const std::vector<geom::Point3>& list) const {
    return counted(list.size(), "point in space", "points in space");
  }
  std::string operator()(const std::vector<std::string>& list) const { return counted(list.size(), "text", "texts"); }
  std::string operator()(const std::vector<Table>& list) const { return counted(list.size(), "table", "tables"); }
};

std::string found(const Value& value) { return std::visit(FoundText{}, value); }

struct IsEmptyList {
  template <class T>
  bool operator()(const T&) const {
    return false;
  }
  template <class T>
  bool operator()(const std::vector<T>& list) const {
    return list.empty();
  }
  bool operator()(const Points& list) const { return list.empty(); }
};

bool is_empty_list(const Value& value) { return std::visit(IsEmptyList{}, value); }

std::string range_text(const Field& field) {
  std::vector<std::string> parts;
  if (field.options.above) parts.push_back("greater than " + plain(*field.options.above));
  if (field.options.at_least) parts.push_back("at least " + plain(*field.options.at_least));
  if (field.options.at_most) parts.push_back("at most " + plain(*field.options.at_most));
  if (field.options.other_than) parts.push_back("other than " + plain(*field.options.other_than));
  return fmt::format("{}", fmt::join(parts, " and "));
}

/// What is wrong with one number of a field; empty if nothing.
std::string number_trouble(const Field& field, double number, const std::string& unit) {
  if (!std::isfinite(number)) return "a finite number";
  const FieldOptions& o = field.options;
  const bool inside = (!o.above || number > *o.above) && (!o.at_least || number >= *o.at_least) &&
                      (!o.at_most || number <= *o.at_most) && (!o.other_than || number != *o.other_than);
  return inside ? "" : range_text(field) + unit;
}

Error bad_value(std::string message, const base::Place& place) {
  return {ErrorCode::BadValue, std::move(message), place};
}

/// @param unit  of the numbers, with a blank before it; empty: they have none.
base::Result<void> check_numbers(const Value& value, const Value& written, const Field& field, const std::string& unit,
                                 const base::Place& place) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    for (std::size_t i = 0; i < numbers->size(); ++i) {
      const std::string trouble = number_trouble(field, (*numbers)[i], unit);
      if (!trouble.empty()) {
        return bad_value(fmt::format("number {} of '{}' must be {}, found {}{}", i + 1, field.key, trouble,
                                     base::number_text((*numbers)[i]), std::isfinite((*numbers)[i]) ? unit : ""),
                         place);
      }
    }
  }
  if (const auto* points = std::get_if<Points>(&value)) {
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (!geom::is_finite((*points)[i])) {
        return bad_value(fmt::format("point {} of '{}' must have finite coordinates, found {}", i + 1, field.key,
                                     value_toml((*points)[i])),
                         place);
      }
    }
  }
  if (const auto* points = std::get_if<std::vector<geom::Point3>>(&value)) {
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (!geom::is_finite((*points)[i]))
        return bad_value(fmt::format("point {} of '{}' must have finite coordinates", i + 1, field.key), place);
    }
  }
  const auto* point = std::get_if<geom::Point>(&value);
  if (point != nullptr && !geom::is_finite(*point)) {
    return bad_value(fmt::format("'{}' must have finite coordinates, found {}", field.key, value_toml(*point)), place);
  }
  std::optional<double> number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    if (*integer < field.lowest || *integer > field.highest) {
      return bad_value(
          fmt::format("'{}' must be between {} and {}, found {}", field.key, field.lowest, field.highest, *integer),
          place);
    }
    number = static_cast<double>(*integer);
  }
  if (const auto* real = std::get_if<double>(&value)) number = *real;
  if (number) {
    const std::string trouble = number_trouble(field, *number, unit);
    if (!trouble.empty())
      return bad_value(fmt::format("'{}' must be {}, found {}{}", field.key, trouble, found(written),
                                   std::isfinite(*number) ? unit : ""),
                       place);
  }
  return {};
}

/// A text that begins with a number where one is meant: "3 m", "3,5".
bool has_unit(const Value& written, Kind kind) {
  const auto* text = std::get_if<std::string>(&written);
  if (text == nullptr || text->empty()) return false;
  const bool number = kind == Kind::Number || kind == Kind::Integer || kind == Kind::Degrees;
  return number && std::isdigit(static_cast<unsigned char>(text->front())) != 0;
}

base::Result<void> check_value(const Value& written, const Field& field, const std::string& unit,
                               const base::Place& place, const std::string& where) {
  const std::optional<Value> value = as_kind(written, field.kind);
  if (!value) {
    if (has_unit(written, field.kind)) {
      return bad_value(fmt::format("'{}' must be {}, found {}: numbers stand without quotes and without units",
                                   field.key, wanted(field), found(written)),
                       place);
    }
    return bad_value(fmt::format("'{}' must be {}, found {}", field.key, wanted(field), found(written)), place);
  }
  if (field.kind == Kind::Choice) {
    const auto& text = std::get<std::string>(*value);
    if (std::find(field.choices.begin(), field.choices.end(), text) == field.choices.end()) {
      return bad_value(fmt::format("'{}' must be {}, found '{}'{}", field.key, wanted(field), text,
                                   base::did_you_mean(text, field.choices)),
                       place);
    }
  }
  if (field.kind == Kind::File && field.options.presence == Presence::Required &&
      std::get<std::string>(*value).empty()) {
    return bad_value(fmt::format("'{}' must be {}, found an empty text", field.key, wanted(field)), place);
  }
  if (const auto* rows = std::get_if<std::vector<Table>>(&*value)) {
    for (std::size_t i = 0; i < rows->size(); ++i) {
      DOBRA_TRY_VOID(check((*rows)[i], field.fields,
                           fmt::format("{}{}{} {}", where, where.empty() ? "" : ", ", field.key, i + 1)));
    }
    return {};
  }
  return check_numbers(*value, written, field, unit.empty() ? "" : ' ' + unit, place);
}

base::Result<void> check_known(const Table& table, const std::vector<Field>& fields) {
  std::vector<std::string> keys;
  for (const Field& field : fields) keys.push_back(field.key);
  for (const Table::Entry& entry : table.entries()) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    std::string hint = base::did_you_mean(entry.key, keys);
    if (hint.empty())
      hint = keys.empty() ? "; no keys are taken here" : fmt::format("; known keys: {}", fmt::join(keys, ", "));
    return Error{ErrorCode::UnknownKey, fmt::format("unknown key '{}'{}", entry.key, hint), entry.place};
  }
  return {};
}

base::Result<void> check_all(const Table& table, const std::vector<Field>& fields, const std::string& where) {
  DOBRA_TRY_VOID(check_known(table, fields));
  for (const Table::Entry& entry : table.entries()) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == entry.key; });
    DOBRA_TRY_VOID(check_value(entry.value, *field, si_unit(*field, table, fields), entry.place, where));
  }
  for (const Field& field : fields) {
    if (field.options.presence != Presence::Required || table.find(field.key) != nullptr) continue;
    return Error{ErrorCode::MissingKey, fmt::format("the key '{}' is missing; it must be {}", field.key, wanted(field)),
                 table.own_place};
  }
  return {};
}

/// What the user typed, as a value of any kind; nothing if it is none that the field could take.
std::optional<Value> typed(const Field& field, const std::string& text) {
  switch (field.kind) {
    case Kind::Flag:
      return text == "true" ? std::optional<Value>(true) : text == "false" ? std::optional<Value>(false) : std::nullopt;
    case Kind::Integer: {
      std::int64_t integer = 0;
      const std::size_t start = text.starts_with('+') ? 1 : 0;
      const auto [end, status] = std::from_chars(text.data() + start, text.data() + text.size(), integer);
      if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
      return Value(integer);
    }
    case Kind::Number:
    case Kind::Degrees: {
      const auto number = base::parse_number(text);
      return number ? std::optional<Value>(*number) : std::nullopt;
    }
    case Kind::Tables:
      return std::nullopt;
    case Kind::Point:
    case Kind::Point3:
    case Kind::Numbers:
    case Kind::Points:
    case Kind::Points3:
    case Kind::Texts: {
      // The outer brackets may be left out.
      auto value = read_value(text);
      if (!value || !as_kind(*value, field.kind)) value = read_value("[" + text + "]");
      return value ? std::optional<Value>(*value) : std::nullopt;
    }
    default:
      return Value(text);
  }
}

}  // namespace

std::optional<Value> as_kind(const Value& value, Kind kind) {
  const auto same = [&](auto* held) { return held != nullptr ? std::optional<Value>(*held) : std::nullopt; };
  const bool empty = is_empty_list(value);
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  const auto* point = std::get_if<geom::Point>(&value);
  switch (kind) {
    case Kind::Flag:
      return same(std::get_if<bool>(&value));
    case Kind::Integer:
      return same(std::get_if<std::int64_t>(&value));
    case Kind::Number:
    case Kind::Degrees:
      if (const auto* integer = std::get_if<std::int64_t>(&value)) return Value(static_cast<double>(*integer));
      return same(std::get_if<double>(&value));
    case Kind::Text:
    case Kind::Choice:
    case Kind::File:
      return same(std::get_if<std::string>(&value));
    case Kind::Point:
      if (numbers != nullptr && numbers->size() == 2) return Value(geom::Point{(*numbers)[0], (*numbers)[1]});
      return same(point);
    case Kind::Point3:
      if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
      return same(numbers);
    case Kind::Numbers:
      if (point != nullptr) return Value(std::vector<double>{point->x, point->y});
      if (empty) return Value(std::vector<double>{});
      return same(numbers);
    case Kind::Points:
      return empty ? Value(Points{}) : same(std::get_if<Points>(&value));
    case Kind::Points3:
      return empty ? Value(std::vector<geom::Point3>{}) : same(std::get_if<std::vector<geom::Point3>>(&value));
    case Kind::Texts:
      return empty ? Value(std::vector<std::string>{}) : same(std::get_if<std::vector<std::string>>(&value));
    case Kind::Tables:
      return empty ? Value(std::vector<Table>{}) : same(std::get_if<std::vector<Table>>(&value));
  }
  return std::nullopt;
}

base::Result<void> check(const Table& table, const std::vector<Field>& fields, const std::string& where) {
  const auto judged = check_all(table, fields, where);
  if (judged || where.empty()) return judged;
  base::Place place;
  place.item = where;
  return base::located(judged.error(), place);
}

namespace {

/// Whether the text is a number that is greater than any that can be held.
bool overflows(const std::string& text) {
  double value = 0.0;
  const std::size_t start = text.starts_with('+') ? 1 : 0;
  const auto [end, status] = std::from_chars(text.data() + start, text.data() + text.size(), value);
  return status == std::errc::result_out_of_range && end == text.data() + text.size();
}

}  // namespace

base::Result<Value> parse_value(const Field& field, const std::string& text) {
  if (io::first_byte_outside_utf8(text) || text.find('\0') != std::string::npos) {
    return Error{ErrorCode::BadValue, fmt::format("the text given for '{}' is not UTF-8", field.key)};
  }
  const bool free_text = field.kind == Kind::Text || field.kind == Kind::File || field.kind == Kind::Choice;
  const std::optional<Value> value = typed(field, free_text ? text : std::string(base::trimmed(text)));
  std::optional<Value> converted = value ? as_kind(*value, field.kind) : std::nullopt;
  if (!converted && field.kind == Kind::Texts && text.find_first_of("[]") == std::string::npos)
    converted = Value(parts_of(text));
  if (!converted) {
    const bool number = field.kind == Kind::Number || field.kind == Kind::Degrees;
    return Error{ErrorCode::BadValue, fmt::format("'{}' must be {}, found '{}'{}", field.key, wanted(field), text,
                                                  number && overflows(text) ? ", which is beyond 1.8e308" : "")};
  }
  auto judged = check_value(*converted, field, si_unit(field, {}, {field}), {}, "");
  if (!judged) return Error{judged.error().code, judged.error().message};
  return *converted;
}

std::string value_text(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : value_toml(value);
}

std::string rule_of(const Field& field) {
  const FieldOptions& o = field.options;
  if (o.other_than && !o.above && !o.at_least && !o.at_most) return "must not be " + plain(*o.other_than);
  const std::string range = range_text(field);
  return range.empty() ? range : "must be " + range;
}

std::string field_summary(const Field& field) {
  static constexpr const char* names[] = {"true or false",    "whole number",   "number",
                                          "angle in degrees", "text",           "one of",
                                          "file name",        "point [x, y]",   "triple [x, y, z]",
                                          "list of numbers",  "list of points", "list of points in space",
                                          "list of texts",    "tables"};
  std::string out = names[static_cast<std::size_t>(field.kind)];
  if (field.kind == Kind::Choice) out += ' ' + joined_choices(field);
  const FieldOptions& options = field.options;
  if (!options.words.empty()) out = fmt::format("one of {}", fmt::join(options.words, ", "));
  if (!options.files.empty()) out += ':';
  for (const FileKind& kind : options.files) out += fmt::format(" {}", fmt::join(kind.endings, " "));
  if (options.above) out += " > " + plain(*options.above);
  if (options.at_least) out += " >= " + plain(*options.at_least);
  if (options.at_most) out += (options.above || options.at_least ? " and <= " : " <= ") + plain(*options.at_most);
  if (options.other_than) out += " other than " + plain(*options.other_than);
  if (!options.unit.empty()) out += fmt::format(" [{}]", options.unit);
  if (options.presence == Presence::Required)
    out += ", required";
  else if (field.default_value)
    out += ", default " + value_toml(*field.default_value);
  if (!options.when.empty()) out += "; only if " + options.when;
  return out;
}

namespace detail {

double degrees_of(base::Angle angle) {
  const double degrees = angle.degrees();
  const double rounded = base::parse_number(fmt::format("{:.14g}", degrees)).value_or(degrees);
  return base::Angle::from_degrees(rounded) == angle ? rounded : degrees;
}

double number_of(const Value& value) { return std::get<double>(as_kind(value, Kind::Number).value()); }
geom::Point point_of(const Value& value) { return std::get<geom::Point>(as_kind(value, Kind::Point).value()); }
std::vector<double> numbers_of(const Value& value) {
  return std::get<std::vector<double>>(as_kind(value, Kind::Numbers).value());
}
std::vector<geom::Point> points_of(const Value& value) {
  return std::get<Points>(as_kind(value, Kind::Points).value()).list();
}
geom::Point3 point3_of(const Value& value) {
  const auto numbers = std::get<std::vector<double>>(as_kind(value, Kind::Point3).value());
  return {numbers[0], numbers[1], numbers[2]};
}
std::vector<geom::Point3> points3_of(const Value& value) {
  return std::get<std::vector<geom::Point3>>(as_kind(value, Kind::Points3).value());
}
std::vector<std::string> texts_of(const Value& value) {
  return std::get<std::vector<std::string>>(as_kind(value, Kind::Texts).value());
}
std::vector<Table> tables_of(const Value& value) {
  return std::get<std::vector<Table>>(as_kind(value, Kind::Tables).value());
}

}  // namespace detail
}  // namespace dobra::scenario
