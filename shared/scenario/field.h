#pragma once
// One description of a parameter struct drives the scenario reader, the writer, --help and the window's form.
//
//   struct GridParams {
//     int count = 10;
//     double distance = 0.2;
//     Join join = Join::Mitre;
//     template <class D> static void describe(D& d) {
//       d.field("count", &GridParams::count, {.title = "Number of curves", .at_least = 1});
//       d.field("distance", &GridParams::distance, {.title = "First distance", .unit = "m", .above = 0});
//       d.choice("join", &GridParams::join, {"mitre", "bisector", "round", "bevel"}, {.title = "Corners"});
//     }
//   };
//
// `fields_of<P>()` lists the fields with the defaults of a default-constructed P; `check(table, fields)` judges what
// the user wrote; `from_table<P>(table)` then fills a P.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/scenario/value.h"

namespace dobra::scenario {

/// What a field holds. Degrees: an Angle, written in degrees. Point3: a place in space, held as a list of its three
/// numbers. File: a path, relative to the scenario's folder.
enum class Kind {
  Flag,
  Integer,
  Number,
  Degrees,
  Text,
  Choice,
  File,
  Point,
  Point3,
  Numbers,
  Points,
  Points3,
  Texts,
  Tables
};

enum class Presence { Optional, Required };

/// A kind of file, for the dialog that chooses one and for help.
struct FileKind {
  std::string title;                 ///< English source text.
  std::vector<std::string> endings;  ///< Each with its dot, in small letters.
};

/// What a field's value must satisfy and how it is presented.
struct FieldOptions {
  const char* title = "";  ///< Short, shown in forms; English source text.
  const char* help = "";   ///< One sentence.
  /// Of the number in SI, "m", "Pa"; empty if none. One that goes by a choice is written "Pa, N if kind = force".
  std::string unit = "";
  std::optional<double> above = std::nullopt;     ///< Exclusive lower bound.
  std::optional<double> at_least = std::nullopt;  ///< Inclusive lower bound.
  std::optional<double> at_most = std::nullopt;   ///< Inclusive upper bound.
  std::optional<double> other_than = std::nullopt;
  std::vector<FileKind> files = {};     ///< File only: what is read; empty: not said.
  std::vector<std::string> words = {};  ///< Text only: what it may be, where that is a list; empty: not said.
  bool of_space = false;                ///< Text only: a formula that knows z, u and v beside x and y.
  /// Text and Texts: what of the model it names, "fault" (Program::names_of); Number: which coordinate of a place it
  /// is, "x" or "z"; empty: nothing.
  std::string names = "";
  /// Where it has an effect: "method = shear", "kind in arc, circle and file is set" (condition.h); empty: always.
  std::string when = "";
  Presence presence = Presence::Optional;
};

struct Field {
  std::string key;
  Kind kind = Kind::Text;
  FieldOptions options;
  std::vector<std::string> choices;    ///< Choice only.
  std::optional<Value> default_value;  ///< Nothing for an optional<> member without default, and for Tables.
  std::vector<Field> fields;           ///< Tables only: the fields of each.
  std::int64_t lowest = std::numeric_limits<std::int64_t>::min();  ///< Integer only: what the member's type can hold.
  std::int64_t highest = std::numeric_limits<std::int64_t>::max();
};

/// Finds unknown keys (with a suggestion), wrong types, values out of range or not finite, and missing keys.
/// @param where  what the table is, such as "step 2 (grid)"; stands in the message.
/// @error UnknownKey, BadValue, MissingKey, with file, line and column.
base::Result<void> check(const Table& table, const std::vector<Field>& fields, const std::string& where);

/// Reads the text that a user typed for one field (form, --set).
/// @error BadValue
base::Result<Value> parse_value(const Field& field, const std::string& text);

/// The text that parse_value reads back.
std::string value_text(const Value& value);

/// `value` in the one type that the kind of a field has (Number: double, Point: geom::Point, ...); nothing if it is of
/// another kind.
std::optional<Value> as_kind(const Value& value, Kind kind);

/// "must be at least 1 and at most 5", "must not be 0"; empty if any number will do.
std::string rule_of(const Field& field);

/// "number > 0 m, default 0.2": kind, range, unit and default, for --help and tool tips.
std::string field_summary(const Field& field);

namespace detail {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// The shortest degrees that give this angle: 30, not 29.999999999999996.
double degrees_of(base::Angle angle);
// Conversions of values that passed check().
double number_of(const Value& value);
geom::Point point_of(const Value& value);
std::vector<double> numbers_of(const Value& value);
std::vector<geom::Point> points_of(const Value& value);
geom::Point3 point3_of(const Value& value);
std::vector<geom::Point3> points3_of(const Value& value);
std::vector<std::string> texts_of(const Value& value);
std::vector<Table> tables_of(const Value& value);

template <class T>
constexpr Kind kind_of() {
  if constexpr (std::is_same_v<T, bool>)
    return Kind::Flag;
  else if constexpr (std::is_integral_v<T>)
    return Kind::Integer;
  else if constexpr (std::is_same_v<T, double>)
    return Kind::Number;
  else if constexpr (std::is_same_v<T, base::Angle>)
    return Kind::Degrees;
  else if constexpr (std::is_same_v<T, std::string>)
    return Kind::Text;
  else if constexpr (std::is_same_v<T, geom::Point>)
    return Kind::Point;
  else if constexpr (std::is_same_v<T, std::vector<double>>)
    return Kind::Numbers;
  else if constexpr (std::is_same_v<T, std::vector<geom::Point>>)
    return Kind::Points;
  else if constexpr (std::is_same_v<T, geom::Point3>)
    return Kind::Point3;
  else if constexpr (std::is_same_v<T, std::vector<geom::Point3>>)
    return Kind::Points3;
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return Kind::Texts;
  else
    return Kind::Tables;
}

template <class T>
Value to_value(const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return value;
  else if constexpr (std::is_integral_v<T>)
    return static_cast<std::int64_t>(value);
  else if constexpr (std::is_same_v<T, base::Angle>)
    return degrees_of(value);
  else if constexpr (std::is_same_v<T, geom::Point3>)
    return std::vector<double>{value.x, value.y, value.z};
  else
    return value;
}

template <class T>
T from_value(const Value& value) {
  if constexpr (std::is_same_v<T, double>)
    return number_of(value);
  else if constexpr (std::is_same_v<T, bool>)
    return std::get<bool>(value);
  else if constexpr (std::is_integral_v<T>)
    return static_cast<T>(std::get<std::int64_t>(value));
  else if constexpr (std::is_same_v<T, base::Angle>)
    return base::Angle::from_degrees(number_of(value));
  else if constexpr (std::is_same_v<T, geom::Point>)
    return point_of(value);
  else if constexpr (std::is_same_v<T, std::vector<double>>)
    return numbers_of(value);
  else if constexpr (std::is_same_v<T, std::vector<geom::Point>>)
    return points_of(value);
  else if constexpr (std::is_same_v<T, geom::Point3>)
    return point3_of(value);
  else if constexpr (std::is_same_v<T, std::vector<geom::Point3>>)
    return points3_of(value);
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return texts_of(value);
  else
    return std::get<T>(value);
}

}  // namespace detail

template <class P>
std::vector<Field> fields_of();
template <class P>
P from_table(const Table& table);

/// Lists the fields of P.
template <class P>
class FieldCollector {
 public:
  template <class T>
  void field(const char* key, T P::*member, const FieldOptions& options) {
    add(key, member, options);
  }
  void file(const char* key, std::string P::*member, const FieldOptions& options) {
    add(key, member, options).kind = Kind::File;
  }
  template <class E>
  void choice(const char* key, E P::*member, std::vector<std::string> names, const FieldOptions& options) {
    const std::string chosen = names.at(static_cast<std::size_t>(defaults_.*member));
    Field field{key, Kind::Choice, options, std::move(names), Value(chosen), {}};
    fields.push_back(std::move(field));
  }
  template <class E>
  void choice(const char* key, std::optional<E> P::*, std::vector<std::string> names, const FieldOptions& options) {
    fields.push_back({key, Kind::Choice, options, std::move(names), std::nullopt, {}});
  }
  template <class S>
  void tables(const char* key, std::vector<S> P::*, const FieldOptions& options) {
    fields.push_back({key, Kind::Tables, options, {}, std::nullopt, fields_of<S>()});
  }

  std::vector<Field> fields;

 private:
  template <class T>
  Field& add(const char* key, T P::*member, const FieldOptions& options) {
    Field field{key, Kind::Text, options, {}, std::nullopt, {}};
    if constexpr (detail::IsOptional<T>::value) {
      field.kind = detail::kind_of<typename T::value_type>();
      limit<typename T::value_type>(field);
      if (defaults_.*member) field.default_value = detail::to_value(*(defaults_.*member));
    } else {
      field.kind = detail::kind_of<T>();
      limit<T>(field);
      field.default_value = detail::to_value(defaults_.*member);
    }
    fields.push_back(std::move(field));
    return fields.back();
  }
  template <class T>
  static void limit(Field& field) {
    if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      field.lowest = static_cast<std::int64_t>(std::numeric_limits<T>::min());
      if constexpr (sizeof(T) < sizeof(std::int64_t))
        field.highest = static_cast<std::int64_t>(std::numeric_limits<T>::max());
    }
  }
  P defaults_{};
};

/// Fills a P from a table that passed check().
template <class P>
class Loader {
 public:
  explicit Loader(const Table& table) : table_(table) {}

  template <class T>
  void field(const char* key, T P::*member, const FieldOptions&) {
    const Value* value = table_.find(key);
    if (value == nullptr) return;
    if constexpr (detail::IsOptional<T>::value) {
      result.*member = detail::from_value<typename T::value_type>(*value);
    } else {
      result.*member = detail::from_value<T>(*value);
    }
  }
  void file(const char* key, std::string P::*member, const FieldOptions& options) { field(key, member, options); }
  template <class E>
  void choice(const char* key, E P::*member, const std::vector<std::string>& names, const FieldOptions&) {
    if (const auto at = chosen(key, names)) result.*member = static_cast<E>(*at);
  }
  template <class E>
  void choice(const char* key, std::optional<E> P::*member, const std::vector<std::string>& names,
              const FieldOptions&) {
    if (const auto at = chosen(key, names)) result.*member = static_cast<E>(*at);
  }
  template <class S>
  void tables(const char* key, std::vector<S> P::*member, const FieldOptions&) {
    const Value* value = table_.find(key);
    if (value == nullptr) return;
    (result.*member).clear();
    for (const Table& row : detail::tables_of(*value)) (result.*member).push_back(from_table<S>(row));
  }

  P result{};

 private:
  [[nodiscard]] std::optional<std::size_t> chosen(const char* key, const std::vector<std::string>& names) const {
    const Value* value = table_.find(key);
    for (std::size_t i = 0; value != nullptr && i < names.size(); ++i) {
      if (names[i] == std::get<std::string>(*value)) return i;
    }
    return std::nullopt;
  }
  const Table& table_;
};

template <class P>
std::vector<Field> fields_of() {
  FieldCollector<P> collector;
  P::describe(collector);
  return std::move(collector.fields);
}

/// @pre check(table, fields_of<P>(), ...) passed.
template <class P>
P from_table(const Table& table) {
  Loader<P> loader(table);
  P::describe(loader);
  return std::move(loader.result);
}

}  // namespace dobra::scenario
