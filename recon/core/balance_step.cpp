#include "recon/core/steps.h"

#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/section_check.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_balance_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.area_depth) return;
  for (const BedBalance& bed : model.area_depth->beds) add_cells("bed." + bed.name + '.', cells_of(bed), quantities);
  for (const LayerClass& layer : model.area_depth->layers)
    quantities.push_back({"layer." + layer.name + ".isogon_index", layer.fold.index, ""});
  if (const auto& fit = model.area_depth->fit) {
    add_cells("", cells_of(*fit), quantities);
  }
  quantities.push_back({"bed_inconsistency_percent", model.area_depth->consistency.worst.percent, "%"});
}

void add_balance_tables(const Model& model, std::vector<scenario::DataTable>& tables) {
  if (model.area_depth) tables.push_back(row_table("area_depth", "horizon", model.area_depth->beds));
}

void add_balance_remarks(const Model& model, std::vector<std::string>& remarks) {
  if (model.area_depth) append(model.area_depth->remarks, remarks);
}

}  // namespace

base::Result<Model> run_balance(const Model& model, const BalanceParams& params, const scenario::Context&,
                                const base::Progress&) {
  Section section = input_section(model);
  DOBRA_TRY_VOID(check_section(section, params.crossings));
  Model next = model;
  DOBRA_TRY(next.area_depth, area_depth(section, params));
  if (model.earlier.empty()) next.section = std::move(section);  // it may have got its faces
  return next;
}

scenario::Operation balance_step() {
  return scenario::make_operation<Model, BalanceParams>(
      "balance", "Balance", "Bed lengths, excess areas and the depth of the detachment of the section as it is.",
      run_balance,
      {.quantities = add_balance_quantities, .tables = add_balance_tables, .remarks = add_balance_remarks});
}

}  // namespace recon::core
