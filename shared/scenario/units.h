#pragma once
// The units in which a scenario states its numbers and is told its results. Memory is SI: numbers are turned on the way
// in (in_si, by the units of the parameters' descriptions) and on the way out (in_units). A coherent system has one
// unit of length, one of force, and their stress, so that no equation needs a factor. Page: docs/scenario_format.md.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/scenario/field.h"
#include "shared/scene/space/picture.h"

namespace dobra::scenario {

struct DataTable;
struct Quantity;

/// A number as a fraction of whole numbers where it is one, so that 500 mm and 0.5 m are the same bits.
struct Ratio {
  double above = 1.0;
  double below = 1.0;
  [[nodiscard]] double times(double value) const { return below == 1.0 ? value * above : value * above / below; }
  [[nodiscard]] Ratio inverse() const { return {below, above}; }
};

class UnitSystem {
 public:
  /// m, N, Pa.
  UnitSystem() = default;
  /// Units of length, force and stress with commas between, in any order: "mm, N, MPa"; or "SI".
  /// @error BadValue, beginning with " = " behind the name of a key: a unit that is not known, or three that do not
  /// cohere, with those that would.
  static base::Result<UnitSystem> make(const std::string& text);

  [[nodiscard]] bool si() const { return text_ == "m, N, Pa"; }
  /// As make reads it, in the order length, force, stress.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::string& length_unit() const { return names_[0]; }
  /// The unit here of what is `si` in SI ("Pa", "m2", "J/m2", "Pa sqrt(m)"); others ("deg", "%") are their own.
  [[nodiscard]] std::string unit(std::string_view si) const;
  /// What is called `unit` here, in SI: the way back.
  [[nodiscard]] std::string si_of(std::string_view unit) const;
  /// What one such unit is in SI.
  [[nodiscard]] Ratio in_si(std::string_view si) const;
  [[nodiscard]] double to_si(double value, std::string_view si) const { return in_si(si).times(value); }
  [[nodiscard]] double from_si(double value, std::string_view si) const { return in_si(si).inverse().times(value); }

 private:
  std::string text_ = "m, N, Pa";
  std::array<std::string, 3> names_{"m", "N", "Pa"};
  Ratio length_, force_;
};

/// The SI unit of a field, "Pa"; that of one whose unit goes by a choice ("Pa, N if kind = force") by the table's. Of
/// fields_in() the unit that these have.
std::string si_unit(const Field& field, const Table& table, const std::vector<Field>& fields);

/// A table that was written in `units`, in SI: numbers, points and lists of fields with a unit; texts with a unit are
/// formulas of the coordinates x and y, and become formulas of those in SI. Places stay.
/// @pre check(table, fields, ...) passed.
Table in_si(const Table& table, const std::vector<Field>& fields, const UnitSystem& units);

/// The fields as they are in a document in `units`: their units and their defaults.
std::vector<Field> fields_in(std::vector<Field> fields, const UnitSystem& units);

// From SI.
std::vector<Quantity> in_units(std::vector<Quantity> quantities, const UnitSystem& units);
/// Columns by the unit in their brackets.
std::vector<DataTable> in_units(std::vector<DataTable> tables, const UnitSystem& units);
/// World coordinates by "[m]" in the titles of the axes, colours and values of labels by that in the title of the
/// scale.
scene::Picture in_units(scene::Picture picture, const UnitSystem& units);
scene::space::SpacePicture in_units(scene::space::SpacePicture picture, const UnitSystem& units);
/// A message: numbers before a unit, "0.5 m", and points "(x, y)" and "(x, y, z)"; what stands in quotes stays.
std::string message_in_units(const std::string& message, const UnitSystem& units);
base::Error in_units(base::Error error, const UnitSystem& units);

}  // namespace dobra::scenario
