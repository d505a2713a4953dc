#pragma once
// The validation book: reference values of the literature and of closed forms, each with the scenario that finds it by
// the same operations that a user runs. Page: docs/algorithms/crack.md and fem.md. Sources stand in each case.

#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"

namespace quebra::core {

struct ValidationCase {
  std::string section;  ///< Of the list of references: "3.5".
  std::string name;
  std::string scenario;  ///< Text of a scenario file.
  std::string quantity;  ///< Of its last state.
  double factor = 1.0;   ///< Multiplies the quantity: 1 / (sigma sqrt(pi a)) for geometry factors.
  double reference = 0.0;
  double tolerance = 0.0;  ///< Relative.
  std::string source;
  std::string note = {};  ///< Why the tolerance is wider than that of its kind.
  /// If there is one, the scenario of a coarser mesh: the value is then the rate at which the quantity falls with the
  /// size of the elements, sizes as 1 / sqrt(unknowns).
  std::string coarse = {};
};
std::vector<ValidationCase> validation_cases();

struct ValidationResult {
  ValidationCase what;
  double value = 0.0;
  double error = 0.0;  ///< Relative to the reference; a value of the other sign is wrong by 200 %.
  [[nodiscard]] bool met() const { return error <= what.tolerance; }
};
/// @error that of the scenario which fails, with the name of its case.
dobra::base::Result<std::vector<ValidationResult>> validate(const std::vector<ValidationCase>& cases,
                                                            const dobra::base::Progress& progress);

/// As tables: CSV, JSON, and a page.
std::string validation_csv(const std::vector<ValidationResult>& results);
std::string validation_json(const std::vector<ValidationResult>& results);
std::string validation_html(const std::vector<ValidationResult>& results);

}  // namespace quebra::core
