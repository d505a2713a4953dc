#include "shared/cli/convert_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "shared/base/text.h"
#include "shared/cli/line_options.h"
#include "shared/cli/line_picture.h"
#include "shared/cli/pictures.h"
#include "shared/cli/staging.h"
#include "shared/io/lines/section_ends.h"
#include "shared/render/cairo.h"
#include "shared/scenario/color_table.h"

namespace dobra::cli {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using Json = nlohmann::ordered_json;

/// What convert has for itself.
struct ConvertParams {
  std::string to;
  io::formats::Coordinates to_coordinates = io::formats::Coordinates::Detect;
  std::optional<io::lines::FeatureType> only;
  std::string scale;
  std::string colors;
  std::string orientation;

  template <class D>
  static void describe(D& d) {
    d.field("to", &ConvertParams::to,
            {.title = "Format", .help = "Of the output, as of --from; by the ending of its name otherwise."});
    d.choice(
        "to_coordinates", &ConvertParams::to_coordinates, {"detect", "section", "map"},
        {.title = "Coordinates of the output", .help = "section: x and height; map: x, y and height on the trace."});
    d.choice("only", &ConvertParams::only, {"points", "lines", "polygons"},
             {.title = "Only these", .help = "The others are left out."});
    d.field("scale", &ConvertParams::scale,
            {.title = "Scale", .help = "Pictures and DXF to a true scale such as 1:10000."});
    d.file("colours", &ConvertParams::colors,
           {.title = "Table of colours",
            .help = "Pictures: CSV or TOML with name, colour, pattern, age and lithology of units and lines."});
    d.field("orientation", &ConvertParams::orientation,
            {.title = "Orientation",
             .help = "Pictures: what stands over the left and the right end, such as W - E; told by the plane of lines "
                     "in space."});
  }
};

struct ConvertOptions {
  std::string input;
  std::filesystem::path output;
  LineOptions lines{OutOfRange::BadUsage};
  OptionsOf<ConvertParams> own;
};

constexpr const char* type_names[] = {"points", "lines", "polygons"};

/// What the output is.
struct Target {
  bool picture = false;
  io::formats::LineWriteOptions lines;
  std::optional<double> scale;  ///< 1:n, the n.
  std::optional<scene::ColorTable> colors;
  std::optional<std::pair<std::string, std::string>> ends;
};

Result<Target> target_of(const ConvertParams& params, const std::filesystem::path& output) {
  Target target;
  target.picture = params.to.empty() && check_ending(output, Drawer::Cairo).ok();
  if (!params.to.empty()) {
    target.lines.format = io::formats::format_named(params.to, io::formats::Use::WriteLines);
    if (target.lines.format == nullptr) {
      return Error{ErrorCode::BadUsage,
                   fmt::format("--to: unknown '{}'{}", params.to,
                               base::did_you_mean(params.to, io::formats::names_for(io::formats::Use::WriteLines)))};
    }
  } else if (!target.picture) {
    auto format = io::formats::line_format_of(output.string());
    if (!format) {
      return Error{ErrorCode::BadUsage, fmt::format("{}: {} {}; or give --to NAME", output.string(),
                                                    format.error().message, fmt::join(render::picture_endings, " "))};
    }
    target.lines.format = *format;
  }
  target.lines.coordinates = params.to_coordinates;
  if (!params.colors.empty()) {
    if (!target.picture) return Error{ErrorCode::BadUsage, fmt::format("--colours is for {}", picture_endings("and"))};
    DOBRA_TRY(target.colors, scenario::read_color_table(params.colors));
  }
  if (!params.orientation.empty()) {
    if (!target.picture)
      return Error{ErrorCode::BadUsage, fmt::format("--orientation is for {}", picture_endings("and"))};
    auto ends = io::lines::ends_of_text(params.orientation);
    if (!ends) return Error{ErrorCode::BadUsage, "--orientation: " + ends.error().message};
    target.ends = *ends;
  }
  if (params.scale.empty()) return target;
  const bool ratio = params.scale.starts_with("1:");
  const auto number = base::parse_number(ratio ? params.scale.substr(2) : params.scale);
  if (!ratio || !number || !std::isfinite(*number) || *number <= 0.0) {
    return Error{ErrorCode::BadUsage, fmt::format("--scale {}: give a scale such as 1:10000", params.scale)};
  }
  if (!target.picture && !target.lines.format->lines->to_scale) {
    const auto others = io::formats::endings_for(io::formats::Use::WriteLinesToScale);
    return Error{ErrorCode::BadUsage,
                 fmt::format("--scale is for {} {}", fmt::join(render::picture_endings, " "), fmt::join(others, " "))};
  }
  target.scale = *number;
  return target;
}

Result<void> keep_only(io::formats::LineWork& work, std::optional<io::lines::FeatureType> wanted) {
  if (!wanted) return {};
  const char* const only = type_names[static_cast<std::size_t>(*wanted)];
  const std::size_t before = work.features.size();
  std::erase_if(work.features, [wanted](const io::lines::Feature& f) { return f.type != *wanted; });
  if (work.features.empty()) return Error{ErrorCode::BadFormat, fmt::format("the file has no {}", only)};
  work.remarks.push_back(fmt::format("{} features that are no {} left out", before - work.features.size(), only));
  return {};
}

/// Millimetres on paper instead of metres.
io::formats::LineWork on_paper(io::formats::LineWork work, double scale) {
  for (io::lines::Feature& feature : work.features) {
    for (geom::Polyline& part : feature.parts) {
      for (geom::Point& p : part.points) p = {1000.0 * p.x / scale, 1000.0 * p.y / scale};
    }
  }
  return work;
}

Result<void> write(const ConvertOptions& options, const Target& target, io::formats::LineWork& work) {
  DOBRA_TRY(Staging staging, Staging::open(options.output.parent_path(), TargetFolder::MustExist));
  const std::filesystem::path file = staging.path(options.output.filename().string());
  base::Result<void> written;
  if (target.picture) {
    const std::string title = std::filesystem::path(options.input).stem().string();
    written = draw_lines(work, file, {title, target.scale, target.colors, target.ends});
  } else if (target.scale) {
    written = io::formats::write_any_lines(file.string(), on_paper(work, *target.scale), target.lines, work.remarks);
  } else {
    written = io::formats::write_any_lines(file.string(), work, target.lines, work.remarks);
  }
  if (!written) return staging.for_user(written.error());
  DOBRA_TRY_VOID(staging.commit());
  return {};
}

Json feature_json(const io::lines::Feature& feature) {
  std::size_t points = 0;
  for (const geom::Polyline& part : feature.parts) points += part.points.size();
  return {{"name", feature.name},
          {"kind", feature.kind},
          {"type", type_names[static_cast<std::size_t>(feature.type)]},
          {"parts", feature.parts.size()},
          {"points", points}};
}

std::string report_json(const ConvertOptions& options, const Target& target, const io::formats::LineWork& work) {
  geom::Box box;
  Json features = Json::array();
  for (const io::lines::Feature& feature : work.features) {
    for (const geom::Polyline& part : feature.parts) box.add(part.box());
    features.push_back(feature_json(feature));
  }
  Json repairs = Json::array();
  for (const io::formats::Repair& repair : work.repairs) {
    repairs.push_back({{"repair", repair.what},
                       {"item", repair.item},
                       {"done", repair.text},
                       {"at", {repair.at.x, repair.at.y}},
                       {"moved", repair.moved}});
  }
  Json json = {
      {"read",
       {{"file", options.input},
        {"format", work.format->name},
        {"y_axis", work.y_direction == io::lines::YDirection::Down ? "down" : "up"},
        {"unit", work.unit},
        {"extent", {box.low.x, box.low.y, box.high.x, box.high.y}},
        {"features", features}}},
      {"repairs", repairs},
      {"written",
       {{"file", options.output.string()},
        {"format", target.picture ? options.output.extension().string().substr(1) : target.lines.format->name}}},
      {"remarks", work.remarks}};
  if (work.trace) {
    const io::lines::Trace& t = *work.trace;
    json["read"]["trace"] = {{"origin", {t.x, t.y}},
                             {"direction", {t.east, t.north}},
                             {"largest_misfit", t.largest_misfit},
                             {"mean_misfit", t.mean_misfit}};
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Whatever readers and writers find wrong with options is the user's usage here.
Error of_usage(Error error) {
  if (error.code == ErrorCode::InvalidOption) error.code = ErrorCode::BadUsage;
  return error;
}

Result<int> convert_job(Session& session, const ConvertOptions& options) {
  DOBRA_TRY(const scenario::Table lines, options.lines.table());
  DOBRA_TRY(const io::formats::LineOptions line_settings, line_options(lines));
  DOBRA_TRY(const ConvertParams own, options.own.read());
  DOBRA_TRY(const Target target, target_of(own, options.output));
  DOBRA_TRY_VOID(check_writable(options.output));
  auto read = io::formats::read_any_lines(options.input, line_settings);
  if (!read) return of_usage(read.error());
  io::formats::LineWork& work = *read;
  if (auto kept = keep_only(work, own.only); !kept) return base::located(kept.error(), {.file = options.input});
  if (const auto kinds = io::lines::check_kinds(work.features); !kinds)
    work.remarks.push_back(base::to_string(kinds.error()));
  if (target.colors) {
    for (std::string& remark : scene::remarks_on(*target.colors, drawn_names(work)))
      work.remarks.push_back(std::move(remark));
  }
  DOBRA_TRY_VOID(session.check());
  if (auto written = write(options, target, work); !written) return of_usage(written.error());
  for (const std::string& remark : work.remarks) session.note(remark);
  for (const io::formats::Repair& repair : work.repairs) session.note(io::formats::to_string(repair));
  if (session.options.format == OutputFormat::Json) {
    DOBRA_TRY_VOID(print(report_json(options, target, work)));
  } else if (session.options.verbosity != Verbosity::Quiet) {
    DOBRA_TRY_VOID(print(options.output.string() + '\n'));
  }
  return 0;
}

}  // namespace

Command convert_command() {
  return {
      "convert", "Lines from one format to another, with units, depths, planes and repairs", [](CLI::App& app) -> Job {
        const auto options = std::make_shared<ConvertOptions>();
        app.add_option("in", options->input,
                       fmt::format("Lines: {}", fmt::join(io::formats::endings_for(io::formats::Use::ReadLines), " ")))
            ->required()
            ->type_name("IN");
        app.add_option("out", options->output, fmt::format("The same, or {}", picture_endings()))
            ->required()
            ->type_name("OUT");
        options->lines.add(app, LineOptions::Repairs::Offered);
        options->own.add(app);
        return [options](Session& session) { return convert_job(session, *options); };
      }};
}

}  // namespace dobra::cli
