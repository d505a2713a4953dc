#include "quebra/cli/input_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "shared/scenario/runner.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Result;

/// The options about files of lines as keys of the input, once they are judged as those of `convert` are.
Result<void> set_lines(const InputFile& file, scenario::Table& input) {
  const dobra::cli::LineOptionTexts& texts = file.lines;
  DOBRA_TRY(const io::formats::LineOptions lines, dobra::cli::line_options(texts));
  const dobra::cli::LineOptionTexts none;
  const auto set = [&](const char* key, const std::string& text, const std::string& unsaid) {
    if (text != unsaid) input.set(key, text);
  };
  set("format", texts.format, "");
  set("columns", texts.columns, "");
  set("name_columns", texts.name_columns, "");
  set("separator", texts.separator, none.separator);
  set("coordinates", texts.coordinates, none.coordinates);
  set("y_axis", texts.y_axis, "");
  set("unit", texts.unit, "");
  if (lines.trace) {
    const io::lines::Trace& t = *lines.trace;
    input.set("trace", std::vector<double>{t.x, t.y, t.x + t.east, t.y + t.north});
  }
  if (lines.fold_axis)
    input.set("fold_axis", std::vector<double>{lines.fold_axis->trend.degrees(), lines.fold_axis->plunge.degrees()});
  if (texts.plane_tolerance) input.set("plane_tolerance", *texts.plane_tolerance);
  if (texts.reference) input.set("reference", *texts.reference);
  if (texts.exaggeration) input.set("exaggeration", *texts.exaggeration);
  if (file.closed) input.set("closed", std::string("yes"));
  return {};
}

}  // namespace

void add_input_options(CLI::App& app, InputFile& file) {
  app.add_option("--set", file.scenario.assignments, "Change a value, such as input.width=2; may be repeated")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  app.add_flag("--repair", file.repair,
               "Mend repeated points, spikes, doubles, gaps and crossings of the input, and list each");
  app.add_option("--gap", file.gap, "Widest gap that --repair closes; 1/1000 of the drawing's diagonal by default")
      ->type_name("W");
  dobra::cli::add_line_reading_options(app, file.lines);
}

Result<scenario::Document> document_of(dobra::cli::Session& session, const InputFile& file) {
  scenario::Document document;
  if (file.scenario.file.extension() == ".toml") {
    DOBRA_TRY(document, dobra::cli::load(session, file.scenario));
  } else {
    document.program = session.program.name;
    document.input.set("file", file.scenario.file.string());
    for (const std::string& assignment : file.scenario.assignments) {
      DOBRA_TRY(document, scenario::with_value(std::move(document), session.program, assignment));
    }
  }
  DOBRA_TRY_VOID(set_lines(file, document.input));
  if (file.repair) document.input.set("repair", std::string("yes"));
  if (file.gap) document.input.set("gap", *file.gap);
  return document;
}

scenario::Step step_of(const std::string& operation) {
  return {.operation = operation, .name = {}, .params = {}, .comment = {}, .place = {}};
}

void leave_out_from(scenario::Document& document, std::size_t first, const std::vector<std::string>& keep,
                    StepChanges& changes) {
  std::vector<scenario::Step> kept;
  for (std::size_t i = first; i < document.steps.size(); ++i) {
    if (std::find(keep.begin(), keep.end(), document.steps[i].operation) != keep.end()) {
      kept.push_back(std::move(document.steps[i]));
    } else {
      changes.left_out.push_back(scenario::step_label(document, i + 1));
    }
  }
  document.steps.resize(first);
  document.steps.insert(document.steps.end(), std::make_move_iterator(kept.begin()),
                        std::make_move_iterator(kept.end()));
}

std::string text_of(const StepChanges& changes, const scenario::Document& document) {
  std::string text;
  if (!changes.left_out.empty()) text = fmt::format("{} left out", fmt::join(changes.left_out, ", "));
  if (!changes.added.empty())
    text += fmt::format("{}added: {}", text.empty() ? "" : "; ", fmt::join(changes.added, ", "));
  return text.empty() ? text : fmt::format("of the steps of {}: {}", document.file.string(), text);
}

}  // namespace quebra::cli
