#include "shared/scenario/lines/line_reading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "shared/base/text.h"

namespace dobra::scenario::lines {
namespace {

using base::Result;

Result<const io::formats::Format*> format_of(const std::string& name, const RefuseKey& refuse) {
  constexpr auto use = io::formats::Use::ReadLines;
  if (const io::formats::Format* known = io::formats::format_named(name, use)) return known;
  const std::vector<std::string> names = io::formats::names_for(use);
  std::string hint = base::did_you_mean(name, names);
  if (hint.empty()) hint = fmt::format("; give {}", fmt::join(names, ", "));
  return refuse("format", fmt::format("unknown '{}'{}", name, hint));
}

}  // namespace

base::Error bad_key(const std::string& key, const std::string& what) {
  return {base::ErrorCode::BadValue, fmt::format("{}: {}", key, what)};
}

Result<std::optional<io::lines::Trace>> trace_of(const std::vector<double>& numbers, const RefuseKey& refuse) {
  if (numbers.empty()) return std::optional<io::lines::Trace>();
  if (numbers.size() != 4) return refuse("trace", "give four numbers: x and y of its beginning and its end on the map");
  auto trace = io::lines::trace_between({numbers[0], numbers[1]}, {numbers[2], numbers[3]});
  if (!trace) return refuse("trace", trace.error().message);
  return std::optional(*trace);
}

Result<std::optional<io::lines::FoldAxis>> fold_axis_of(const std::vector<double>& numbers, const RefuseKey& refuse) {
  if (numbers.empty()) return std::optional<io::lines::FoldAxis>();
  if (numbers.size() != 2 || std::abs(numbers[1]) >= 90.0)
    return refuse("fold_axis", "give two numbers: trend and plunge in degrees, such as 261, 10");
  return std::optional(
      io::lines::FoldAxis{base::Angle::from_degrees(numbers[0]), base::Angle::from_degrees(numbers[1])});
}

Result<std::vector<io::lines::KindRule>> kind_rules(const std::vector<std::string>& texts, const RefuseKey& refuse) {
  std::vector<io::lines::KindRule> rules;
  for (const std::string& text : texts) {
    auto rule = io::lines::kind_rule(text);
    if (!rule) return refuse("kind", rule.error().message);
    rules.push_back(std::move(*rule));
  }
  return rules;
}

Result<io::formats::LineOptions> line_options(const LineReading& reading, const RefuseKey& refuse) {
  io::formats::LineOptions options;
  if (!reading.format.empty()) {
    DOBRA_TRY(options.format, format_of(reading.format, refuse));
  }
  options.text.columns = io::formats::words_between_commas(reading.columns);
  options.text.name_columns = io::formats::words_between_commas(reading.name_columns);
  options.text.separator = reading.separator;
  options.coordinates = reading.coordinates;
  DOBRA_TRY(options.trace, trace_of(reading.trace, refuse));
  DOBRA_TRY(options.fold_axis, fold_axis_of(reading.fold_axis, refuse));
  options.plane_tolerance = reading.plane_tolerance.value_or(options.plane_tolerance);
  if (reading.y_axis != FileAxis::File)
    options.y_direction = reading.y_axis == FileAxis::Up ? io::lines::YDirection::Up : io::lines::YDirection::Down;
  options.y_reference = reading.reference.value_or(options.y_reference);
  if (reading.unit != FileUnit::File)
    options.unit = io::formats::file_unit_metres[static_cast<std::size_t>(reading.unit) - 1];
  options.exaggeration = reading.exaggeration.value_or(options.exaggeration);
  return options;
}

}  // namespace dobra::scenario::lines
