#include "quebra/cli/input_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "quebra/core/input.h"
#include "shared/scenario/runner.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Result;

/// What options say of the input, as its keys; those about lines are judged as those of `convert` are.
Result<void> set_input(dobra::cli::Session& session, const InputFile& file, scenario::Document& document) {
  DOBRA_TRY(const scenario::Table lines, file.lines.table());
  DOBRA_TRY_VOID(dobra::cli::line_options(lines));
  for (const auto& entry : lines.entries()) document.input.set(entry.key, entry.value);
  return file.input.set(scenario::fields_in(session.program.input_fields, document.units), document.input);
}

}  // namespace

void add_input_options(CLI::App& app, InputFile& file) {
  dobra::cli::add_assignment_option(app, file.scenario);
  file.input.add(app, scenario::fields_of<core::InputParams>(), {"closed", "repair", "gap"});
  file.lines.add(app, dobra::cli::LineOptions::Repairs::None);
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
  DOBRA_TRY_VOID(set_input(session, file, document));
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
