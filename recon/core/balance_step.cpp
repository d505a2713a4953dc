#include "recon/core/balance_step.h"

#include "recon/core/report.h"
#include "recon/section/section_check.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_balance_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* found = model.findings.get<balance::AreaDepth>();
  if (found == nullptr) return;
  for (const balance::BedBalance& bed : found->beds) add_cells("bed." + bed.name + '.', cells_of(bed), quantities);
  for (const balance::LayerClass& layer : found->layers)
    quantities.push_back({"layer." + layer.name + ".isogon_index", layer.fold.index, ""});
  if (const auto& fit = found->fit) {
    add_cells("", cells_of(*fit), quantities);
  }
  quantities.push_back({"bed_inconsistency_percent", found->consistency.worst.percent, "%"});
}

void add_balance_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (const auto* found = model.findings.get<balance::AreaDepth>())
    tables.push_back(row_table("area_depth", "horizon", found->beds));
}

void add_balance_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* found = model.findings.get<balance::AreaDepth>()) append(found->remarks, remarks);
}

}  // namespace

base::Result<model::Model> run_balance(const model::Model& model, const balance::BalanceParams& params,
                                       const scenario::Context&, const base::Progress&) {
  section::Section section = input_section(model);
  DOBRA_TRY_VOID(check_section(section, params.crossings));
  model::Model next = model;
  DOBRA_TRY(balance::AreaDepth found, area_depth(section, params));
  next.findings.set(std::move(found), {});
  if (model.earlier.empty()) next.section = std::move(section);  // it may have got its faces
  return next;
}

scenario::Operation balance_step() {
  return scenario::make_operation<model::Model, balance::BalanceParams>(
      "balance", "Balance", "Bed lengths, excess areas and the depth of the detachment of the section as it is.",
      run_balance,
      {.quantities = add_balance_quantities, .tables = add_balance_tables, .remarks = add_balance_remarks});
}

}  // namespace recon::core
