#include "recon/space/placed.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/section/file_rounding.h"
#include "shared/geom/place.h"
#include "shared/scenario/document.h"

namespace recon::space {

namespace loft = dobra::surf::loft;
namespace scenario = dobra::scenario;
using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

struct ReadOne {
  input::ReadSection read;
  std::vector<double> trace;
};

Result<ReadOne> read_scenario(const std::filesystem::path& file, const base::Progress& progress) {
  DOBRA_TRY(const scenario::Document document, scenario::read_document(file));
  if (document.program != "recon")
    return Error{
        ErrorCode::WrongProgram,
        fmt::format("a scenario of {}, not of recon; name a scenario of recon, or a file of lines", document.program),
        base::Place{.file = file.string()}};
  DOBRA_TRY_VOID(scenario::check(document.input, scenario::fields_of<input::SectionInput>(), "input"));
  const auto given = scenario::from_table<input::SectionInput>(document.input);
  if (!given.placed_sections.empty())
    return Error{ErrorCode::BadSection, "holds [[input.section]] itself; name the files of its sections instead",
                 base::Place{.file = file.string()}};
  scenario::Context context;
  context.folder = document.folder();
  auto read = read_section(given, context, progress);
  if (!read) return base::located(read.error(), {.file = file.string()});
  return ReadOne{std::move(*read), given.trace};
}

Result<ReadOne> read_lines(const input::PlacedSectionInput& placed, input::SectionInput around,
                           const scenario::Context& context, const base::Progress& progress) {
  around.placed_sections.clear();
  input::LinesInput lines;
  lines.file = placed.file;
  around.lines = {std::move(lines)};
  // Lines that have map coordinates are laid into the plane of the trace.
  if (around.trace.empty() && placed.trace.size() == 4) around.trace = placed.trace;
  auto read = read_section(around, context, progress);
  if (!read) return base::located(read.error(), {.file = (context.folder / placed.file).string()});
  return ReadOne{std::move(*read), {}};
}

Result<PlacedSection> read_one(const input::PlacedSectionInput& placed, const input::SectionInput& around,
                               const scenario::Context& context, const base::Progress& progress,
                               std::vector<base::Finding>& findings) {
  if (!placed.trace.empty()) DOBRA_TRY_VOID(plan_trace(placed.trace, "trace"));
  const std::filesystem::path path = context.folder / placed.file;
  const bool is_scenario = path.extension() == ".toml";
  DOBRA_TRY(ReadOne one, is_scenario ? read_scenario(path, progress) : read_lines(placed, around, context, progress));
  const std::vector<double>& trace = placed.trace.empty() ? one.trace : placed.trace;
  if (trace.empty())
    return Error{ErrorCode::MissingKey,
                 "where the section stands is not said; give its trace on the map, trace = [x0, y0, x1, y1]"};
  DOBRA_TRY(loft::PlanTrace plan, plan_trace(trace, "trace"));
  std::string name = placed.name.empty() ? path.stem().string() : placed.name;
  for (const std::string& remark : one.read.remarks) {
    const std::string item = fmt::format("section '{}'", name);
    base::Place place{.file = path.string(), .item = item};
    if (const auto at = one.read.places.find(remark); at != one.read.places.end())
      place.x = at->second.x, place.y = at->second.y;
    findings.push_back({"section_remark", fmt::format("{}: {}", item, remark), std::move(place)});
  }
  return PlacedSection{std::move(name), std::move(one.read.section), std::move(plan)};
}

/// What is wrong in a section is told with the section, whatever item of it is meant; a file that cannot be read, with
/// the table that names it too.
Error of_section(Error error, const std::string& item, base::Place table) {
  const bool no_text =
      error.code == ErrorCode::FileNotFound || error.code == ErrorCode::NotAFile || error.code == ErrorCode::EmptyFile;
  if (no_text && table.line > 0)
    error.message +=
        "; " + fmt::format("the [[input.section]] at {} names it", fmt::format("{}:{}", table.file, table.line));
  if (error.place && !error.place->item.empty()) error.message = fmt::format("{}: {}", item, error.message);
  table.item = item;
  return base::located(std::move(error), table);
}

/// @error BadValue: no part of its lines lies over the trace
Result<void> check_over_trace(const PlacedSection& placed) {
  const geom::Box box = box_of(placed.section);
  const double length = placed.trace.length();
  if (box.low.x < length && box.high.x > 0.0) return {};
  return Error{ErrorCode::BadValue,
               fmt::format("no part of its lines is on its trace: they go from {:.6g} to {:.6g} m, the trace from 0 to "
                           "{:.6g} m; correct the trace, or measure x of the lines from its first corner",
                           box.low.x, box.high.x, length)};
}

/// What lies beside the trace is placed on its end pieces, gone on. Told where it leaves the trace by more than files
/// round.
void tell_beyond(const PlacedSection& placed, std::vector<base::Finding>& findings) {
  const geom::Box box = box_of(placed.section);
  const double length = placed.trace.length();
  const double same = std::max(1e-9 * length, section::rounding_of_files(placed.section));
  const double before = -box.low.x, behind = box.high.x - length;
  const double beyond = std::max(before, behind);
  if (beyond <= same) return;
  const auto& corners = placed.trace.corners();
  const geom::Point end = before > behind ? corners.front() : corners.back();
  findings.push_back({"beyond_trace",
                      fmt::format("section '{}' reaches {:.6g} m beyond the ends of its trace, which is {:.6g} m long; "
                                  "there the trace goes straight on",
                                  placed.name, beyond, length),
                      geom::place_at(end, fmt::format("section '{}'", placed.name))});
}

void tell_topography(const PlacedSection& placed, std::vector<base::Finding>& findings) {
  const std::string item = fmt::format("section '{}'", placed.name);
  for (const section::SectionLine& line : placed.section.lines) {
    if (line.kind != section::LineKind::Topography) continue;
    const geom::Point p = placed.trace.on_map(line.line.points.front().x);
    findings.push_back({"topography_left_out",
                        fmt::format("{} has a topography, '{}': no surface goes through it, and volumes and new "
                                    "sections go on above it; draw it as a horizon to have one",
                                    item, line.name),
                        {.item = item, .x = p.x, .y = p.y, .z = line.line.points.front().y}});
    return;
  }
}

}  // namespace

Result<loft::PlanTrace> plan_trace(const std::vector<double>& numbers, const std::string& key) {
  if (numbers.size() < 4 || numbers.size() % 2 != 0)
    return Error{ErrorCode::BadValue,
                 fmt::format("{}: {} numbers; give places on the map, x0, y0, x1, y1, ...", key, numbers.size())};
  std::vector<geom::Point> corners;
  for (std::size_t i = 0; i < numbers.size(); i += 2) corners.push_back({numbers[i], numbers[i + 1]});
  auto trace = loft::PlanTrace::make(std::move(corners));
  if (!trace) {
    Error error = trace.error();
    error.code = ErrorCode::BadValue;
    error.message = fmt::format("{}: {}", key, error.message);
    return error;
  }
  return trace;
}

Result<PlacedSections> read_placed(const input::SectionInput& input, const scenario::Context& context,
                                   const base::Progress& progress, const std::vector<base::Place>& places) {
  if (!input.horizons.empty() || !input.faults.empty() || !input.units.empty() || !input.lines.empty())
    return Error{ErrorCode::BadSection,
                 "the input has lines of a section and [[input.section]]; put the lines into a file of their own, and "
                 "name it in an [[input.section]]",
                 base::Place{.item = "input"}};
  for (const auto& [key, given] : {std::pair("along_strike", input.along_strike.has_value()),
                                   {"cut", !input.cut.empty()},
                                   {"trace", !input.trace.empty()}}) {
    if (given)
      return Error{ErrorCode::BadSection,
                   fmt::format("'{}' is for a document of one section; this one has several, each with a trace of its "
                               "own: take it out",
                               key),
                   base::Place{.item = "input"}};
  }
  if (input.placed_sections.size() < 2)
    return Error{ErrorCode::BadSection, "one [[input.section]] alone; surfaces take two sections at least",
                 base::Place{.item = "input"}};
  PlacedSections made;
  for (std::size_t k = 0; k < input.placed_sections.size(); ++k) {
    const input::PlacedSectionInput& placed = input.placed_sections[k];
    const base::Place table = k < places.size() ? places[k] : base::Place{};
    DOBRA_TRY_VOID(progress.check());
    const std::string item = fmt::format("section '{}'", placed.name.empty() ? placed.file : placed.name);
    auto one = read_one(placed, input, context, progress, made.findings);
    if (!one) return of_section(one.error(), item, table);
    const bool twice = std::any_of(made.sections.begin(), made.sections.end(),
                                   [&](const PlacedSection& other) { return other.name == one->name; });
    if (twice)
      return of_section(
          {ErrorCode::BadSection, "another section has this name already; give it a name of its own (name)"},
          fmt::format("section '{}'", one->name), table);
    if (const auto over = check_over_trace(*one); !over) return of_section(over.error(), item, table);
    tell_beyond(*one, made.findings);
    tell_topography(*one, made.findings);
    made.sections.push_back(std::move(*one));
  }
  return made;
}

loft::Section lines_of(const PlacedSection& placed) {
  loft::Section made{placed.name, placed.trace, {}};
  for (const section::Horizon& horizon : placed.section.horizons)
    made.lines.push_back({whole_name(horizon), loft::LineKind::Horizon, horizon.line});
  for (const section::SectionLine& line : placed.section.lines) {
    if (line.kind == section::LineKind::Fault)
      made.lines.push_back({whole_name(line), loft::LineKind::Fault, line.line});
  }
  return made;
}

}  // namespace recon::space
