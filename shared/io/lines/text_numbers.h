#pragma once
// Numbers as texts write them: decimal points and decimal commas, with marks of thousands or without. Internal to io.
// Page: docs/user/import.md.

#include <optional>
#include <string>
#include <string_view>

#include "shared/base/result.h"

namespace dobra::io::lines {

enum class DecimalSign { Point, Comma };

/// What a field may mean under either decimal sign. Marks of thousands are commas (points), blanks and no-break blanks
/// between groups of three digits.
struct NumberReadings {
  std::optional<double> with_point;
  std::optional<double> with_comma;
};
NumberReadings readings_of(std::string_view field);

/// Whether a field is a number under one of the signs.
bool may_be_number(std::string_view field);

/// The number under that sign; nothing where it is none.
std::optional<double> number_in(std::string_view field, DecimalSign sign);

/// Values by which programs say that there is none: -999.25, -9999, 1e30 and the like.
bool stands_for_none(double value);

/// Finds the decimal sign of a file out of all its numbers.
class DecimalSigns {
 public:
  /// A field of numbers, and where it stands.
  void add(std::string_view field, std::size_t line, std::size_t column);
  /// The one sign under which all fields read. @error Unclear with line and column, without a file: fields that speak
  /// for different signs, or one that means two numbers where none tells which.
  [[nodiscard]] base::Result<DecimalSign> sign() const;
  /// A field that holds marks of thousands under `sign`; empty if none does.
  [[nodiscard]] const std::string& with_marks(DecimalSign sign) const {
    return sign == DecimalSign::Point ? comma_marks_ : point_marks_;
  }

 private:
  struct Field {
    std::string text;
    std::size_t line = 0, column = 0;
  };
  std::optional<Field> point_, comma_;     ///< The first that reads under this sign alone.
  std::optional<Field> comma_or_marks_;    ///< The first such as "1,234".
  std::optional<Field> point_or_marks_;    ///< The first such as "1.234".
  std::string comma_marks_, point_marks_;  ///< Such as "1,234.5", "1.234,5".
};

}  // namespace dobra::io::lines
