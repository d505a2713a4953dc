#include "quebra/core/line_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace quebra::core {
namespace {

namespace io = dobra::io;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;

Result<const io::formats::Format*> format_of(const std::string& name) {
  using io::formats::Use;
  if (const auto* format = io::formats::format_named(name, Use::ReadLines)) return format;
  return Error{ErrorCode::BadValue, fmt::format("format: unknown '{}'; give {}", name,
                                                fmt::join(io::formats::names_for(Use::ReadLines), ", "))};
}

}  // namespace

Result<SketchOptions> sketch_options(const LineInput& input) {
  const LineInput none;
  SketchOptions options;
  options.open_lines = input.closed;
  io::formats::LineOptions& lines = options.lines;
  if (!input.format.empty()) {
    DOBRA_TRY(lines.format, format_of(input.format));
  }
  lines.text.columns = io::formats::words_between_commas(input.columns);
  lines.text.name_columns = io::formats::words_between_commas(input.name_columns);
  lines.text.separator = input.separator;
  lines.coordinates = input.coordinates;
  if (!input.trace.empty()) {
    if (input.trace.size() != 4)
      return Error{ErrorCode::BadValue, "trace: give four numbers: x and y of its beginning and its end"};
    DOBRA_TRY(lines.trace,
              io::lines::trace_between({input.trace[0], input.trace[1]}, {input.trace[2], input.trace[3]}));
  }
  if (!input.fold_axis.empty()) {
    if (input.fold_axis.size() != 2)
      return Error{ErrorCode::BadValue, "fold_axis: give two numbers: trend and plunge in degrees"};
    lines.fold_axis = io::lines::FoldAxis{dobra::base::Angle::from_degrees(input.fold_axis[0]),
                                          dobra::base::Angle::from_degrees(input.fold_axis[1])};
  }
  lines.plane_tolerance = input.plane_tolerance.value_or(lines.plane_tolerance);
  if (input.y_axis != FileAxis::File)
    lines.y_direction = input.y_axis == FileAxis::Up ? io::lines::YDirection::Up : io::lines::YDirection::Down;
  lines.y_reference = input.reference.value_or(lines.y_reference);
  if (input.unit != FileUnit::File)
    lines.unit = io::formats::file_unit_metres[static_cast<std::size_t>(input.unit) - 1];
  lines.exaggeration = input.exaggeration.value_or(lines.exaggeration);
  options.chosen = input.closed != none.closed || !input.format.empty() || !input.columns.empty() ||
                   !input.name_columns.empty() || input.separator != none.separator ||
                   input.coordinates != none.coordinates || !input.trace.empty() || !input.fold_axis.empty() ||
                   input.plane_tolerance || input.reference || input.exaggeration || input.y_axis != none.y_axis ||
                   input.unit != none.unit;
  return options;
}

}  // namespace quebra::core
