#include "recon/core/operations.h"

#include <algorithm>

#include "recon/block/cut_input.h"
#include "recon/core/area_balance_step.h"
#include "recon/core/balance_step.h"
#include "recon/core/carry_step.h"
#include "recon/core/faults_step.h"
#include "recon/core/grid_step.h"
#include "recon/core/input_picture.h"
#include "recon/core/invert_step.h"
#include "recon/core/join_step.h"
#include "recon/core/monte_carlo_step.h"
#include "recon/core/move_step.h"
#include "recon/core/offset_step.h"
#include "recon/core/predict_step.h"
#include "recon/core/report.h"
#include "recon/core/restore_step.h"
#include "recon/core/section_picture.h"
#include "recon/core/space_steps.h"
#include "recon/core/target_step.h"
#include "recon/input/colors.h"
#include "recon/input/drawing.h"
#include "recon/input/importing.h"
#include "recon/input/input.h"
#include "recon/model/chain.h"
#include "recon/model/names.h"
#include "recon/section/section_faces.h"
#include "shared/base/finding_text.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;

namespace {

base::Result<scenario::State> read_input(const scenario::Table& table, const scenario::Context& context,
                                         const base::Progress& progress) {
  const auto input = scenario::from_table<input::SectionInput>(table);
  model::Model model;
  if (!input.placed_sections.empty()) {
    std::vector<base::Place> places;
    for (const scenario::Table& row : std::get<std::vector<scenario::Table>>(*table.find("section")))
      places.push_back(row.own_place);
    DOBRA_TRY(space::PlacedSections placed, space::read_placed(input, context, progress, places));
    for (const base::Finding& finding : placed.findings) model.remarks.push_back(base::line_of(finding));
    model.findings.set(std::move(placed), {});
    return scenario::make_state(std::move(model));
  }
  DOBRA_TRY(input::ReadSection read, read_section(input, context, progress));
  if (!input.cut.empty()) {
    DOBRA_TRY(read, block::cut_through(std::move(read), input));
  }
  model.section = std::move(read.section);
  model.remarks = std::move(read.remarks);
  model.findings.set(input::RemarkPlaces{std::move(read.places)}, {});
  model.trace = read.trace;
  if (input.cut.empty()) model.along_strike = input.along_strike.value_or(0.0);
  return scenario::make_state(std::move(model));
}

/// Sections in space are no section that could be restored, until one is cut from the surfaces through them.
bool has_section(const model::Model& model) {
  return !model.section.horizons.empty() || !model.section.units.empty() || !model.earlier.empty();
}

scenario::Operation for_one_section(scenario::Operation operation) {
  operation.run = [run = std::move(operation.run)](const scenario::State& state, const scenario::Table& table,
                                                   const scenario::Context& context,
                                                   const base::Progress& progress) -> base::Result<scenario::State> {
    if (!has_section(scenario::model_of<model::Model>(state)))
      return base::Error{base::ErrorCode::CannotRestore,
                         "the document holds several sections in space; cut one from the surfaces through them (steps "
                         "'surface' and 'cut'), or open the file of one"};
    return run(state, table, context, progress);
  };
  return operation;
}

/// Of the section, and of the chain from its second stage on.
void add_section_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  quantities.push_back({"horizons", count_of(model.section.horizons.size()), ""});
  if (!is_done(model)) {
    for (const section::Horizon& horizon : model.section.horizons) {
      quantities.push_back({"horizon." + horizon.name + ".length_before", geom::length(horizon.line), "m"});
    }
  }
  if (model.section.faces) {
    double units = 0.0;
    for (const section::RockUnit& unit : model.section.faces->units) units += unit.area;
    quantities.push_back({"section.area", model.section.faces->area, "m2"});
    quantities.push_back({"section.units_area", units, "m2"});
    quantities.push_back({"section.misfits", count_of(model.section.faces->misfits.size()), ""});
  }
  if (model.earlier.empty()) return;
  quantities.push_back({"stages", count_of(model.earlier.size()), ""});
  const auto chain = restored_stages(model);
  const model::Comparison whole = compare(chain, 0, chain.size());
  for (const model::Compared& row : whole.beds)
    quantities.push_back({"since_input.horizon." + row.name + ".change_percent", row.change_percent(), "%"});
  for (const model::Compared& row : whole.units)
    quantities.push_back({"since_input.unit." + row.name + ".change_percent", row.change_percent(), "%"});
  const bool balanced = judge(whole, balance_tolerance(chain)).balanced;
  quantities.push_back({"since_input.balanced", balanced ? 1.0 : 0.0, ""});
}

/// Every bed and unit in every state that the chain has gone through, and what changed since the input.
scenario::DataTable stages_table(const std::vector<const model::Stage*>& chain) {
  scenario::DataTable table{
      "stages", {"state", "kind", "name", "before [m or m2]", "after", "change since input [%]"}, {}};
  for (std::size_t k = 1; k <= chain.size(); ++k) {
    const model::Comparison whole = compare(chain, 0, k);
    const auto add = [&](const char* kind, const std::vector<model::Compared>& rows) {
      for (const model::Compared& row : rows)
        table.rows.push_back({count_of(k), kind, row.name, row.before, row.after, row.change_percent()});
    };
    add("horizon", whole.beds);
    add("unit", whole.units);
  }
  return table;
}

void add_chain_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (!model.earlier.empty()) tables.push_back(stages_table(restored_stages(model)));
}

void add_section_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  append(model.remarks, remarks);
  for (std::size_t k = 0; k < model.earlier.size(); ++k) {
    const model::Stage& stage = *model.earlier[k];
    for (const std::string& remark : remarks_of(stage))
      remarks.push_back(std::string(what_was_done(stage)) + ' ' + std::to_string(k + 1) + ": " + remark);
  }
  if (const std::string verdict = verdict_since_input(restored_stages(model)); !verdict.empty())
    remarks.push_back(verdict);
}

scenario::Drawing drawing() {
  using Of = scenario::Drawing::Kind::Of;
  return {
      .kinds = {{"horizon", "Horizon", Of::Lines, "horizon"},
                {"fault", "Fault", Of::Lines, "fault"},
                {"pin", "Pin line"},
                {"loose", "Loose line"},
                {"topography", "Topography"},
                {"datum", "Datum"},
                {"polygon", "Unit polygon", Of::Polygons},
                {"border", "Border", Of::Polygons},
                {"marker", "Marker", Of::Points}},
      .edit =
          [](const scenario::Document& document, const scenario::State& input, std::span<const scene::LineEdit> edits) {
            return input::with_lines_edited(document, scenario::model_of<model::Model>(input).section, edits);
          },
      .add = [](const scenario::Document& document, const std::string& table, const std::string& name,
                const geom::Polyline& line) { return input::with_line(document, table, name, line); },
      .settle =
          [](const scenario::Document& before, scenario::Document after, const scenario::State& input) {
            const std::set<std::string> gone = input::horizons_gone(before, after);
            return input::with_colors_kept(std::move(after), scenario::model_of<model::Model>(input).section, gone);
          },
      .unit_length = input::unit_length};
}

scenario::Program make_program() {
  scenario::Program recon;
  recon.name = "recon";
  recon.title = "RECON";
  recon.input_fields = scenario::fields_of<input::SectionInput>();
  recon.read_input = read_input;
  recon.draw_input = [](const scenario::Table& table, const scenario::Context& context,
                        dobra::scene::Picture& picture) {
    draw_lines(scenario::from_table<input::SectionInput>(table), context, picture);
  };
  recon.nothing_yet = [](const scenario::Table& input) {
    return std::none_of(input.entries().begin(), input.entries().end(), [](const scenario::Table::Entry& entry) {
      const auto* rows = std::get_if<std::vector<scenario::Table>>(&entry.value);
      return rows != nullptr && !rows->empty();
    });
  };
  recon.results = scenario::make_results<model::Model>({.quantities = add_section_quantities,
                                                        .tables = add_chain_tables,
                                                        .remarks = add_section_remarks,
                                                        .draw =
                                                            [](const model::Model& model, scene::Picture& picture) {
                                                              has_section(model) ? draw_section(model, picture)
                                                                                 : draw_placed(model, picture);
                                                            },
                                                        .draw_space = draw_placed_in_space});
  recon.operations = {grid_step(),   target_step(),      restore_step(), move_step(),         join_step(),
                      carry_step(),  monte_carlo_step(), balance_step(), area_balance_step(), faults_step(),
                      invert_step(), predict_step(),     offset_step()};
  for (scenario::Operation& operation : recon.operations) operation = for_one_section(std::move(operation));
  recon.operations.push_back(surface_step());
  recon.operations.push_back(cut_step());
  recon.names_of = [](const scenario::State& state, const std::string& what) {
    return names_of(scenario::model_of<model::Model>(state), what);
  };
  recon.name_at = [](const scenario::State& state, const std::string& what,
                     const std::optional<dobra::scene::Pick>& line, dobra::geom::Point at) {
    return model::name_at(scenario::model_of<model::Model>(state), what, line, at);
  };
  recon.drawing = drawing();
  recon.importing = input::importing();
  return recon;
}

}  // namespace

const scenario::Program& program() {
  static const scenario::Program recon = make_program();
  return recon;
}

}  // namespace recon::core
