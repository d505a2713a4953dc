#include "recon/core/restore_step.h"

#include "recon/core/report.h"
#include "recon/core/restore_picture.h"
#include "recon/section/section_check.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

void add_blockwise_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.blockwise) return;
  const jigsaw::Blockwise& made = *model.blockwise;
  for (const balance::LineLength& row : made.lengths) add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  for (const balance::LineLength& row : totals_of(made.lengths))
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  for (const balance::UnitRow& row : made.units) add_cells("unit." + row.name + ".", cells_of(row), quantities);
  for (const jigsaw::BlockRow& row : made.rows) {
    if (row.shift) quantities.push_back({"block." + row.name + ".shift", *row.shift, "m"});
    if (row.shift_error) quantities.push_back({"block." + row.name + ".shift_error", *row.shift_error, "m"});
    if (row.raise) quantities.push_back({"block." + row.name + ".raise", *row.raise, "m"});
    if (row.turn) quantities.push_back({"block." + row.name + ".turn", *row.turn, "deg"});
  }
  for (const jigsaw::RestoredFault& fault : made.faults)
    add_cells("fault." + fault.name + ".", cells_of(fault), quantities);
  if (made.how.jigsaw) {
    const jigsaw::Widths& widths = made.widths;
    quantities.push_back({"width_before", widths.before, "m"});
    quantities.push_back({"width_after", widths.after, "m"});
    quantities.push_back({"shortening", widths.shortening(), "m"});
    quantities.push_back({"shortening_percent", 100.0 * widths.shortening() / widths.after, "%"});
    quantities.push_back({"shortening_by_folding", widths.folding(), "m"});
    quantities.push_back({"greatest_opening_percent", made.greatest_opening_percent, "%"});
  }
  const balance::Balance& balance = made.balance;
  quantities.push_back({"greatest_change_percent", balance.greatest_change_percent, "%"});
  quantities.push_back({"greatest_area_change_percent", balance.greatest_area_change_percent, "%"});
  quantities.push_back({"inconsistency_percent", balance.consistency.worst.percent, "%"});
  if (balance.verdict != balance::BalanceVerdict::NotJudged)
    quantities.push_back({"balanced", balance.verdict == balance::BalanceVerdict::Balanced ? 1.0 : 0.0, ""});
}

void add_blockwise_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (!model.blockwise) return;
  const jigsaw::Blockwise& made = *model.blockwise;
  tables.push_back(row_table("line_length", "horizon", made.lengths));
  if (const auto totals = totals_of(made.lengths); !totals.empty())
    tables.push_back(row_table("horizons_in_pieces", "horizon", totals));
  tables.push_back(row_table("units", "unit", made.units));
  scenario::DataTable blocks{"restored_blocks", {"block", "shift [m]"}, {}};
  if (is_rigid(made.how)) blocks.columns.insert(blocks.columns.end(), {"raise [m]", "turn [deg]"});
  if (!made.ties.empty()) blocks.columns.emplace_back("shift_error [m]");
  for (const jigsaw::BlockRow& row : made.rows) {
    if (!row.shift) continue;
    blocks.rows.push_back({row.name, *row.shift});
    if (row.raise) blocks.rows.back().emplace_back(*row.raise);
    if (row.turn) blocks.rows.back().emplace_back(*row.turn);
    if (!made.ties.empty()) {
      if (row.shift_error)
        blocks.rows.back().emplace_back(*row.shift_error);
      else
        blocks.rows.back().emplace_back(std::string());
    }
  }
  tables.push_back(std::move(blocks));
  if (made.how.jigsaw) tables.push_back(row_table("restored_faults", "fault", made.faults));
}

void add_restored_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  add_blockwise_quantities(model, quantities);
  if (!model.restoration) return;
  const unfold::Restoration& restoration = *model.restoration;
  std::size_t points = 0, outside = 0, beyond = 0, not_reversible = 0, tears = 0;
  double torn = 0.0;
  for (std::size_t i = 0; i < restoration.lengths.size(); ++i) {
    const balance::LineLength& row = restoration.lengths[i];
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
    if (row.horizon == model.source->top) {
      add_cells("top.", cells_of(row), quantities);
      quantities.push_back({"shortening", row.shortening, "m"});
      quantities.push_back({"shortening_percent", row.shortening_percent, "%"});
    }
    const maps::MappedLine& line = restoration.lines[i];
    points += line.given.size();
    outside += line.without_column;
    beyond += line.beyond_ends;
    not_reversible += line.not_reversible;
    tears += line.tears.size();
    torn += row.torn;
  }
  for (const balance::LineLength& row : totals_of(restoration.lengths))
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  const std::vector<balance::UnitRow> units = unit_rows(model);
  for (const balance::UnitRow& row : units) add_cells("unit." + row.name + ".", cells_of(row), quantities);
  for (const balance::UnitRow& row : restoration.ledger.units) {
    const auto same = [&](const balance::UnitRow& unit) { return unit.name == row.name; };
    if (std::none_of(units.begin(), units.end(), same)) add_cells("unit." + row.name + ".", cells_of(row), quantities);
  }
  quantities.push_back({"points", count_of(points), ""});
  quantities.push_back({"points_outside", count_of(outside), ""});
  quantities.push_back({"points_beyond_ends", count_of(beyond), ""});
  quantities.push_back({"points_not_reversible", count_of(not_reversible), ""});
  quantities.push_back({"tears", count_of(tears), ""});
  quantities.push_back({"torn", torn, "m"});
  quantities.push_back({"lean_left", restoration.lean_left, ""});
  quantities.push_back({"lean_right", restoration.lean_right, ""});
  const balance::Balance& balance = restoration.balance;
  quantities.push_back({"greatest_change_percent", balance.greatest_change_percent, "%"});
  quantities.push_back({"greatest_area_change_percent", balance.greatest_area_change_percent, "%"});
  quantities.push_back({"inconsistency_percent", balance.consistency.worst.percent, "%"});
  if (balance.verdict != balance::BalanceVerdict::NotJudged)
    quantities.push_back({"balanced", balance.verdict == balance::BalanceVerdict::Balanced ? 1.0 : 0.0, ""});
}

scenario::DataTable strain_table(const std::vector<maps::Strain>& strains) {
  scenario::DataTable table{
      "strain",
      {"x [m]", "z [m]", "dilatation [%]", "greatest stretch", "least stretch", "direction [deg]", "rotation [deg]"},
      {}};
  for (const maps::Strain& s : strains) {
    table.rows.push_back(
        {s.at.x, s.at.y, 100.0 * s.dilatation, s.greatest, s.least, s.direction.degrees(), s.rotation.degrees()});
  }
  return table;
}

void add_restored_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  add_blockwise_tables(model, tables);
  if (!model.restoration) return;
  tables.push_back(row_table("line_length", "horizon", model.restoration->lengths));
  if (const auto totals = totals_of(model.restoration->lengths); !totals.empty())
    tables.push_back(row_table("horizons_in_pieces", "horizon", totals));
  tables.push_back(row_table("units", "unit", unit_rows(model)));
  tables.push_back(strain_table(model.restoration->ledger.strains));
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string restored_csv(const unfold::Restoration& restoration) {
  std::string text = "horizon,x [m],z [m],x_before [m],z_before [m],depth [m]\n";
  for (std::size_t h = 0; h < restoration.lines.size(); ++h) {
    const maps::MappedLine& line = restoration.lines[h];
    for (std::size_t i = 0; i < line.names.size(); ++i) {
      text += csv_field(restoration.section.horizons[h].name);
      const geom::Point after = line.after.points[i];
      const geom::Point before = line.before.points[i];
      for (const double value : {after.x, after.y, before.x, before.y, line.names[i].depth})
        text += ',' + base::number_text(value);
      text += '\n';
    }
  }
  return text;
}

void add_restored_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  using Path = std::filesystem::path;
  if (!model->restoration && !model->blockwise) return;
  outputs.push_back({"restored.geojson", [model](const Path& path) {
                       return io::gis::write_geojson(path.string(), restored_features(section_made(*model)));
                     }});
  if (!model->restoration) return;
  outputs.push_back(
      {"restored.csv", [model](const Path& path) { return io::write_file(path, restored_csv(*model->restoration)); }});
}

void add_restored_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (model.restoration) append(model.restoration->remarks, remarks);
  if (model.blockwise) append(model.blockwise->remarks, remarks);
}

}  // namespace

base::Result<model::Model> run_restore(const model::Model& model, const unfold::RestoreParams& params,
                                       const scenario::Context&, const base::Progress& progress) {
  if (!model.source || !model.target) {
    const char* missing =
        model.source ? "restore needs a target first; put a step 'target' before it"
                     : "restore needs a source grid and a target first; put the steps 'grid' and 'target' before it";
    return base::Error{base::ErrorCode::CannotRestore, missing};
  }
  model::Model next = model;
  next.findings.forget_after(model.earlier.size());
  DOBRA_TRY_VOID(check_section(next.section, params.crossings));
  DOBRA_TRY(next.restoration, restore(next.section, *model.source, *model.target, params, progress));
  return next;
}

base::Result<model::Model> run_restore_step(const model::Model& model, const jigsaw::RestoreStepParams& params,
                                            const scenario::Context& context, const base::Progress& progress) {
  DOBRA_TRY_VOID(jigsaw::check_params(params));
  if (!is_blockwise(params)) return run_restore(model, params, context, progress);
  DOBRA_TRY(model::Model next, next_stage(model));
  next.findings.forget_after(next.earlier.size());
  DOBRA_TRY_VOID(check_section(next.section, params.crossings));
  DOBRA_TRY(next.blockwise, restore_blockwise(next.section, params, params, progress));
  return next;
}

scenario::Operation restore_step() {
  return scenario::make_operation<model::Model, jigsaw::RestoreStepParams>(
      "restore", "Restore", "Carries every point of the section from the source grid to the target grid.",
      run_restore_step,
      {.quantities = add_restored_quantities,
       .tables = add_restored_tables,
       .remarks = add_restored_remarks,
       .outputs = add_restored_outputs,
       .draw = draw_restored});
}

}  // namespace recon::core
