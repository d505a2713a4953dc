#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "shared/base/text.h"
#include "shared/cli/convert_command.h"
#include "shared/io/lines/section_plane.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;

Error bad_usage(const std::string& option, const std::string& what) {
  return {ErrorCode::BadUsage, fmt::format("{}: {}", option, what)};
}

/// The position of `word` among the names.
Result<std::size_t> choice(const std::string& option, const std::string& word, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), word);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string hint = base::did_you_mean(word, names);
  if (hint.empty()) hint = fmt::format("; give {}", fmt::join(names, ", "));
  return bad_usage(option, fmt::format("unknown '{}'{}", word, hint));
}

Result<std::vector<double>> numbers_of(const std::string& option, const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : io::formats::words_between_commas(text)) {
    const auto value = base::parse_number(word);
    if (!value) return bad_usage(option, fmt::format("'{}' is not a number", word));
    numbers.push_back(*value);
  }
  return numbers;
}

Result<io::lines::FoldAxis> fold_axis_of(const std::string& text) {
  DOBRA_TRY(const std::vector<double> numbers, numbers_of("--fold-axis", text));
  if (numbers.size() != 2) return bad_usage("--fold-axis", "give two numbers: trend and plunge in degrees");
  return io::lines::FoldAxis{base::Angle::from_degrees(numbers[0]), base::Angle::from_degrees(numbers[1])};
}

Result<io::lines::Trace> trace_of(const std::string& text) {
  DOBRA_TRY(const std::vector<double> numbers, numbers_of("--trace", text));
  if (numbers.size() != 4) return bad_usage("--trace", "give four numbers: x and y of its beginning and its end");
  return io::lines::trace_between({numbers[0], numbers[1]}, {numbers[2], numbers[3]});
}

Result<double> unit_of(const std::string& text) {
  DOBRA_TRY(const std::size_t unit,
            choice("--unit", text, {io::formats::file_units.begin(), io::formats::file_units.end()}));
  return io::formats::file_unit_metres[unit];
}

}  // namespace

void add_line_reading_options(CLI::App& app, LineOptionTexts& texts) {
  app.add_option("--from", texts.format, "Format of the input; by the ending of its name otherwise")->type_name("NAME");
  app.add_option("--columns", texts.columns, "Text: columns of x and height, or of x, y and height; numbers or headers")
      ->type_name("LIST");
  app.add_option("--name-columns", texts.name_columns, "Text: columns whose texts name a line")->type_name("LIST");
  app.add_option("--separator", texts.separator, "Text: detect (default), blank, tab, comma or semicolon")
      ->type_name("NAME");
  app.add_option("--coordinates", texts.coordinates,
                 "detect (default); section: x and y as they stand; map: lines on a vertical plane in space")
      ->type_name("NAME");
  app.add_option("--trace", texts.trace,
                 "The plane of 3D lines: x0,y0,x1,y1 in metres; found by least squares otherwise")
      ->type_name("LIST");
  app.add_option("--fold-axis", texts.fold_axis,
                 "3D lines down the plunge of a fold: trend,plunge of its axis in degrees")
      ->type_name("T,P");
  app.add_option("--plane-tolerance", texts.plane_tolerance,
                 "Largest distance of 3D lines from their plane, as a part of the length; 0.001 by default")
      ->type_name("X");
  app.add_option("--y-axis", texts.y_axis, "Heights grow up or down; as the file says otherwise, else up")
      ->type_name("up|down");
  app.add_option("--reference", texts.reference, "With --y-axis down: the value at height 0; 0 by default")
      ->type_name("Y");
  app.add_option("--unit", texts.unit, "m, km, ft, in, cm or mm; as the file says otherwise, else m")
      ->type_name("NAME");
  app.add_option("--exaggeration", texts.exaggeration, "Heights are stored this many times too large; 1 by default")
      ->type_name("X");
}

void add_line_options(CLI::App& app, LineOptionTexts& texts) {
  add_line_reading_options(app, texts);
  app.add_option("--kind", texts.kinds,
                 "Kinds by names, such as 'F*=fault'; may be repeated, and the first that fits a name counts")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("PATTERN=KIND");
  app.add_flag("--order", texts.order, "Repair: put unordered points in order along their curve");
  app.add_option("--duplicates", texts.duplicates, "Repair: drop points nearer than this to the one before")
      ->type_name("M");
  app.add_option("--join-gaps", texts.gaps, "Repair: join parts of one name whose ends are nearer than this")
      ->type_name("M");
  app.add_option("--snap", texts.snap, "Repair: move ends nearer than this to a fault onto it")->type_name("M");
  app.add_option("--edges", texts.edges,
                 "Repair: move vertices of polygons nearer than this to a line or another polygon onto it")
      ->type_name("M");
  app.add_option("--slivers", texts.slivers, "Repair: remove polygons and spikes thinner than this")->type_name("M");
}

Result<io::formats::LineOptions> line_options(const LineOptionTexts& texts) {
  io::formats::LineOptions options;
  if (!texts.format.empty()) {
    constexpr auto use = io::formats::Use::ReadLines;
    DOBRA_TRY_VOID(choice("--from", texts.format, io::formats::names_for(use)));
    options.format = io::formats::format_named(texts.format, use);
  }
  options.text.columns = io::formats::words_between_commas(texts.columns);
  options.text.name_columns = io::formats::words_between_commas(texts.name_columns);
  DOBRA_TRY(const std::size_t separator,
            choice("--separator", texts.separator, {"detect", "blank", "tab", "comma", "semicolon"}));
  options.text.separator = static_cast<io::lines::Separator>(separator);
  DOBRA_TRY(const std::size_t coordinates, choice("--coordinates", texts.coordinates, {"detect", "section", "map"}));
  options.coordinates = static_cast<io::formats::Coordinates>(coordinates);
  if (!texts.trace.empty()) {
    DOBRA_TRY(options.trace, trace_of(texts.trace));
  }
  if (!texts.fold_axis.empty()) {
    DOBRA_TRY(options.fold_axis, fold_axis_of(texts.fold_axis));
  }
  if (!texts.y_axis.empty()) {
    DOBRA_TRY(const std::size_t direction, choice("--y-axis", texts.y_axis, {"up", "down"}));
    options.y_direction = static_cast<io::lines::YDirection>(direction);
  }
  if (!texts.unit.empty()) {
    DOBRA_TRY(options.unit, unit_of(texts.unit));
  }
  for (const std::string& text : texts.kinds) {
    auto rule = io::lines::kind_rule(text);
    if (!rule) return bad_usage("--kind", rule.error().message);
    options.kinds.push_back(std::move(*rule));
  }
  options.plane_tolerance = texts.plane_tolerance.value_or(options.plane_tolerance);
  options.y_reference = texts.reference.value_or(options.y_reference);
  options.exaggeration = texts.exaggeration.value_or(options.exaggeration);
  if (texts.order) options.repair.order = io::formats::PointOrder::AlongTheCurve;
  options.repair.duplicates = texts.duplicates;
  options.repair.gaps = texts.gaps;
  options.repair.snap = texts.snap;
  options.repair.edges = texts.edges;
  options.repair.slivers = texts.slivers;
  return options;
}

}  // namespace dobra::cli
