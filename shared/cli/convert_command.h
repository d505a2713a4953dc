#pragma once
// The sub-command `convert` of both programs: lines from one format to another, in section coordinates on the way, with
// repairs; pictures of them to a true scale. See docs/user/import.md.

#include <string>

#include "shared/cli/cli.h"
#include "shared/io/formats/line_files.h"

namespace dobra::cli {

/// convert IN OUT: formats by the endings of the names; --json prints what was read, repaired and written.
Command convert_command();

/// Options of `convert` and of every other sub-command that reads a file of lines, as they were typed.
struct LineOptionTexts {
  std::string format;
  std::string columns;
  std::string name_columns;
  std::string separator = "detect";
  std::string coordinates = "detect";
  std::string trace;
  std::optional<double> plane_tolerance;
  std::string y_axis;
  std::optional<double> reference;
  std::string unit;
  std::optional<double> exaggeration;
  bool order = false;
  std::optional<double> duplicates;
  std::optional<double> gaps;
  std::optional<double> snap;
  std::optional<double> edges;
  std::optional<double> slivers;
  std::string fold_axis;
  std::vector<std::string> kinds;
  bool operator==(const LineOptionTexts&) const = default;
};
/// Formats, columns, units, axes and planes; `add_line_options` adds the repairs to them.
void add_line_reading_options(CLI::App& app, LineOptionTexts& texts);
void add_line_options(CLI::App& app, LineOptionTexts& texts);
/// @error BadUsage naming the option.
base::Result<io::formats::LineOptions> line_options(const LineOptionTexts& texts);

}  // namespace dobra::cli
