#include "recon/input/line_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/input/import.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/line_files.h"

namespace recon::input {

namespace io = dobra::io;

namespace {

/// Empty where the input does not say.
base::Result<std::vector<std::string>> columns_of(const HorizonInput& input) {
  std::vector<std::string> columns;
  if (input.columns.empty()) return columns;
  for (const double number : input.columns) {
    const bool column = number >= 1.0 && number <= 1e6 && number == std::floor(number);
    if (column) columns.push_back(fmt::format("{}", static_cast<std::size_t>(number)));
  }
  if (columns.size() != input.columns.size() || columns.size() < 2 || columns.size() > 3) {
    return base::Error{base::ErrorCode::BadValue,
                       "columns needs two whole numbers from 1 on, such as [1, 2], or three: x, y and height"};
  }
  return columns;
}

/// How the lines of a file are placed, and the repairs of their points. What neither the input of the line nor that of
/// the section sets is left to the file.
template <class Input>
io::formats::LineOptions options_of(const Input& input, const ReadSettings& settings) {
  const section::Convention& convention = settings.convention;
  io::formats::LineOptions options;
  options.text.separator = static_cast<io::lines::Separator>(input.separator);
  if (input.y_axis == LineAxis::Up) options.y_direction = io::lines::YDirection::Up;
  const bool section_down = input.y_axis == LineAxis::Section && convention.y_axis == section::VerticalAxis::Down;
  if (input.y_axis == LineAxis::Down || section_down) options.y_direction = io::lines::YDirection::Down;
  options.y_reference = convention.reference;
  options.exaggeration = convention.exaggeration;
  if (input.unit != LineUnit::Section) {
    options.unit = metres_per_unit(static_cast<section::LengthUnit>(static_cast<int>(input.unit) - 1));
  } else if (convention.unit != section::LengthUnit::Metre) {
    options.unit = metres_per_unit(convention.unit);
  }
  options.trace = settings.trace;
  options.fold_axis = settings.fold_axis;
  options.plane_tolerance = settings.plane_tolerance;
  if (input.order == PointOrder::AlongCurve) options.repair.order = io::formats::PointOrder::AlongTheCurve;
  if (input.drop_duplicates > 0.0) options.repair.duplicates = input.drop_duplicates;
  if (input.join_gaps > 0.0) options.repair.gaps = input.join_gaps;
  return options;
}

bool has_blank_lines(const std::string& path) {
  const auto text = io::read_text(path);
  return text && (text->find("\n\n") != std::string::npos || text->find("\n\r\n") != std::string::npos);
}

/// The lines of that name, or without a name all there are if they share one.
base::Result<std::vector<const io::lines::Feature*>> chosen(const std::vector<io::lines::Feature>& features,
                                                            const std::string& wanted) {
  std::vector<const io::lines::Feature*> found;
  std::vector<std::string> names;
  for (const auto type :
       {io::lines::FeatureType::Lines, io::lines::FeatureType::Polygons, io::lines::FeatureType::Points}) {
    if (!found.empty()) break;
    for (const io::lines::Feature& feature : features) {
      if (feature.type != type) continue;
      names.push_back(feature.name);
      if (wanted.empty() || feature.name == wanted) found.push_back(&feature);
    }
  }
  if (found.empty()) {
    return base::Error{base::ErrorCode::BadSection,
                       fmt::format("the file has no line named '{}'{}", wanted, base::did_you_mean(wanted, names))};
  }
  const std::string& name = found.front()->name;
  const bool one =
      std::all_of(found.begin(), found.end(), [&](const io::lines::Feature* f) { return f->name == name; });
  if (found.size() > 1 && (name.empty() || !one)) {
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("the file has {} lines to choose from; name one with feature = \"...\"", found.size())};
  }
  return found;
}

}  // namespace

void leave_horizons_apart(io::formats::RepairOptions& repair) {
  repair.may_join = [](const io::formats::PartEnd& a, const io::formats::PartEnd&) { return !is_horizon(a.feature); };
}

base::Result<io::formats::LineWork> work_of_file(const LinesInput& input, const std::string& path,
                                                 const ReadSettings& settings) {
  io::formats::LineOptions options = options_of(input, settings);
  if (!input.columns.empty()) options.text.columns = input.columns;
  options.text.name_columns = input.name_columns;
  leave_horizons_apart(options.repair);
  DOBRA_TRY(options.kinds, dobra::scenario::lines::kind_rules(input.kind));
  return io::formats::read_any_lines(path, options);
}

base::Result<ReadPieces> lines_of_file(const HorizonInput& input, const std::string& path,
                                       const ReadSettings& settings) {
  io::formats::LineOptions options = options_of(input, settings);
  options.text.blank_lines = io::lines::BlankLines::Ignore;
  DOBRA_TRY(options.text.columns, columns_of(input));
  DOBRA_TRY(io::formats::LineWork work, io::formats::read_any_lines(path, options));
  const auto named = [](const io::lines::Feature& feature) { return !feature.name.empty(); };
  if (work.format->name == "text" && std::any_of(work.features.begin(), work.features.end(), named)) {
    // Where rows have names a blank line ends a piece; elsewhere it says nothing.
    options.text.blank_lines = io::lines::BlankLines::SplitLines;
    if (auto split = io::formats::read_any_lines(path, options))
      work = std::move(*split);
    else
      work.remarks.push_back("blank lines are not taken for the ends of pieces, since a single row stands between two");
  } else if (work.format->name == "text" && has_blank_lines(path)) {
    options.text.blank_lines = io::lines::BlankLines::SplitLines;
    const auto split = io::formats::read_any_lines(path, options);
    if (split && split->features.size() > work.features.size())
      work.remarks.push_back("blank lines are not taken for the ends of lines: the rows have no names");
  }
  DOBRA_TRY(const std::vector<const io::lines::Feature*> features, chosen(work.features, input.feature));
  ReadPieces read{{}, work.remarks, work.trace};
  for (const io::lines::Feature* feature : features) {
    for (geom::Polyline piece : feature->parts) {
      if (piece.closed) piece.points.push_back(piece.points.front());
      piece.closed = false;
      read.pieces.push_back(std::move(piece));
    }
  }
  if (read.pieces.empty()) return base::Error{base::ErrorCode::BadSection, "the line has no points; take it out"};
  for (const io::formats::Repair& repair : work.repairs) read.remarks.push_back(io::formats::to_string(repair));
  return read;
}

}  // namespace recon::input
