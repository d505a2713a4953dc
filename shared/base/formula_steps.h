#pragma once
// A formula of two names as the steps of a stack machine. Internal to formula_jet.h.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/formula_jet.h"
#include "shared/base/result.h"

namespace dobra::base::formula_jets {

enum Operation : std::uint8_t {
  Number,
  X,
  Y,
  Add,
  Subtract,
  Multiply,
  Divide,
  Power,
  Negate,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Equal,
  Unequal,
  And,
  Or,
  Choose,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Sinh,
  Cosh,
  Tanh,
  Exp,
  Log,
  Log10,
  Sqrt,
  Cbrt,
  Abs,
  Sign,
  Floor,
  Atan2,
  Hypot,
  Min,
  Max
};

/// How many values of the stack an operation takes.
std::size_t taken_by(std::uint8_t operation);

/// @error BadValue with the character from which on the text is no formula
Result<std::vector<FormulaJet::Step>> steps_of(const std::string& text, const std::array<std::string, 2>& names);

}  // namespace dobra::base::formula_jets
