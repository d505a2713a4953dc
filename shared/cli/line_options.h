#pragma once
// Options about files of lines, of every command that reads one: made of the description that scenarios have
// (shared/scenario/lines/line_reading.h), by the same names but for a few that are shorter.

#include "shared/cli/parameter_options.h"
#include "shared/scenario/lines/line_reading.h"

namespace dobra::cli {

class LineOptions {
 public:
  enum class Repairs { Offered, None };
  explicit LineOptions(OutOfRange out_of_range = OutOfRange::BadValue) : options_(out_of_range) {}

  /// @param repairs  and kinds by names: whether they are offered too.
  void add(CLI::App& app, Repairs repairs);
  /// What the user gave, by the keys of the description. @error as ParameterOptions::set
  [[nodiscard]] base::Result<scenario::Table> table() const;

 private:
  ParameterOptions options_;
};

/// What such a table means. @error BadUsage naming the option.
base::Result<io::formats::LineOptions> line_options(const scenario::Table& given);

}  // namespace dobra::cli
