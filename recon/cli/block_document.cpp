#include "recon/cli/block_document.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/block/cut_input.h"
#include "recon/block/loft.h"
#include "recon/block/unit_map.h"
#include "recon/input/input.h"
#include "recon/input/section_input.h"
#include "recon/model/model.h"
#include "recon/space/placed.h"
#include "shared/geom/place.h"
#include "shared/io/lines/section_plane.h"
#include "shared/scenario/runner.h"

namespace recon::cli {

namespace scenario = dobra::scenario;
using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

/// Colours that single lines have, by table and name of the whole.
void copy_line_colours(const scenario::Table& from, scenario::Table& to) {
  for (const auto& entry : to.entries()) {
    const auto* const tables = std::get_if<std::vector<scenario::Table>>(&entry.value);
    const scenario::Value* const source = from.find(entry.key);
    const auto* const sources = source != nullptr ? std::get_if<std::vector<scenario::Table>>(source) : nullptr;
    if (tables == nullptr || sources == nullptr) continue;
    std::vector<scenario::Table> rows = *tables;
    for (scenario::Table& row : rows) {
      for (const scenario::Table& old : *sources) {
        const scenario::Value* const color = old.find("colour");
        const scenario::Value* const name = old.find("name");
        if (color == nullptr || name == nullptr) continue;
        const scenario::Value* const whole = row.find("piece_of");
        if (*name == *row.find("name") || (whole != nullptr && *name == *whole)) row.set("colour", *color);
      }
    }
    to.set(entry.key, std::move(rows));
  }
}

/// @error BadValue: a trace with corners; those of block::loft()
Result<block::Block> lofted(const space::PlacedSections& placed) {
  std::vector<block::LoftedSection> sections;
  for (const space::PlacedSection& each : placed.sections) {
    const std::vector<geom::Point>& corners = each.trace.corners();
    if (corners.size() > 2) {
      return Error{ErrorCode::BadValue,
                   "its trace bends here: a block is lofted between straight sections; leave it out, or divide it",
                   geom::place_at(corners[1], fmt::format("section '{}'", each.name))};
    }
    DOBRA_TRY(const auto trace, dobra::io::lines::trace_between(corners[0], corners[1]));
    sections.push_back({each.name, each.section, trace});
  }
  return block::loft(sections);
}

}  // namespace

Result<block::Block> block_of(dobra::cli::Session& session, scenario::Document document, LengthSaidBy said_by) {
  document.input.erase("cut");
  document.steps.clear();
  document.expects.clear();
  DOBRA_TRY_VOID(scenario::check(document, session.program));
  scenario::Runner runner(session.program);
  const scenario::Run run = runner.run(document, session.progress());  // its remarks are findings of the block
  if (run.error) return *run.error;
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  std::vector<base::Finding> remarks;
  const auto* const places = model.findings.get<input::RemarkPlaces>();
  for (const std::string& remark : model.remarks) {
    base::Place place;
    if (places != nullptr && places->of.contains(remark)) place = places->of.at(remark);
    place.file = document.file.string();
    remarks.push_back({"section_remark", remark, std::move(place)});
  }
  const auto with_remarks = [&](block::Block block) {
    std::erase_if(remarks,
                  [&](const base::Finding& remark) { return recon::block::is_told(remark.place, block.findings); });
    block.findings.insert(block.findings.begin(), remarks.begin(), remarks.end());
    return block;
  };
  if (const auto* placed = model.findings.get<space::PlacedSections>()) {
    remarks = placed->findings;
    auto block = lofted(*placed);
    if (!block) return base::located(block.error(), {.file = document.file.string()});
    return with_remarks(std::move(*block));
  }
  if (!(model.along_strike > 0.0)) {
    return Error{ErrorCode::MissingKey,
                 said_by == LengthSaidBy::Option
                     ? "how far does the section go on? Give --along-strike a length, or along_strike in its [input]"
                     : "how far does the section go on? Give along_strike a length in its [input]",
                 base::Place{.file = document.file.string(), .item = "input"}};
  }
  DOBRA_TRY(block::Block block, block::extrude(model.section, {model.along_strike, model.trace}));
  return with_remarks(std::move(block));
}

Result<std::vector<double>> trace_of_cut(const scenario::Document& document) {
  const scenario::Value* const given = document.input.find("cut");
  if (given == nullptr) return Error{ErrorCode::BadUsage, "give --trace x0,y0,x1,y1: where the cut runs on the map"};
  DOBRA_TRY_VOID(scenario::check(document.input, scenario::fields_of<input::SectionInput>(), "input"));
  std::vector<double> numbers = scenario::from_table<input::SectionInput>(document.input).cut;
  if (numbers.size() != 4) {
    return Error{ErrorCode::BadUsage,
                 fmt::format("--trace: give four numbers, x and y of its beginning and its end on the map, not {}",
                             numbers.size())};
  }
  for (double& number : numbers) number = document.units.to_si(number, "m");
  return numbers;
}

scenario::Document document_of_cut(const block::BlockCut& cut, const scenario::Table& original,
                                   const std::vector<double>& trace) {
  scenario::Document document;
  document.program = "recon";
  document.title = fmt::format("Section from ({}, {}) to ({}, {})", trace[0], trace[1], trace[2], trace[3]);
  document.input = block::input_table(cut.section);
  document.input.set("trace", trace);
  copy_line_colours(original, document.input);
  return document;
}

void take_colours(const scenario::Table& original, const std::filesystem::path& folder, const std::filesystem::path& to,
                  scenario::Document& document) {
  const scenario::Value* const value = original.find("colours");
  const auto* const file = value != nullptr ? std::get_if<std::string>(value) : nullptr;
  if (file == nullptr) return;
  std::error_code ignored;
  const auto from = std::filesystem::absolute(folder / *file, ignored);
  const auto seen = std::filesystem::proximate(from, std::filesystem::absolute(to, ignored), ignored);
  document.input.set("colours", ignored ? from.string() : seen.string());
}

std::optional<base::Finding> flaw_of(dobra::cli::Session& session, const scenario::Document& document,
                                     const std::filesystem::path& file) {
  scenario::Document named = document;
  named.file = file;
  const scenario::Run run = scenario::Runner(session.program).run(named);
  if (!run.error) return std::nullopt;
  return block::flaw_finding(*run.error);
}

}  // namespace recon::cli
