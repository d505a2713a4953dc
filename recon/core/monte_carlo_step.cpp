#include "recon/core/monte_carlo_step.h"

#include "recon/core/report.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_error_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* bars = model.findings.get<unfold::MonteCarlo>();
  if (bars == nullptr) return;
  for (const unfold::Spread& spread : bars->spreads) {
    const std::string prefix = "error." + spread.name + '.';
    quantities.push_back({prefix + "mean", spread.mean, spread.unit});
    quantities.push_back({prefix + "deviation", spread.deviation, spread.unit});
    quantities.push_back({prefix + "low", spread.low, spread.unit});
    quantities.push_back({prefix + "median", spread.median, spread.unit});
    quantities.push_back({prefix + "high", spread.high, spread.unit});
  }
  quantities.push_back({"error.failed", count_of(bars->failed), ""});
  if (bars->balanced_share) quantities.push_back({"error.balanced_share", *bars->balanced_share, ""});
}

void add_error_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto* bars = model.findings.get<unfold::MonteCarlo>();
  if (bars == nullptr) return;
  scenario::DataTable table{"error_bars", {"quantity", "unit", "mean", "deviation", "low", "median", "high"}, {}};
  for (const unfold::Spread& s : bars->spreads)
    table.rows.push_back({s.name, s.unit, s.mean, s.deviation, s.low, s.median, s.high});
  tables.push_back(std::move(table));
}

void add_error_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* bars = model.findings.get<unfold::MonteCarlo>()) append(bars->remarks, remarks);
}

}  // namespace

base::Result<model::Model> run_monte_carlo(const model::Model& model, const unfold::MonteCarloParams& params,
                                           const scenario::Context&, const base::Progress& progress) {
  if (!model.restoration) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "error bars need a restoration first; put a step 'restore' before it"};
  }
  model::Model next = model;
  DOBRA_TRY(unfold::MonteCarlo bars,
            monte_carlo(model.section, *model.source, *model.target, model.restoration->params, params, progress));
  next.findings.set(std::move(bars), {.state = model.earlier.size() + 1, .outlives = model::Outlives::Nothing});
  return next;
}

scenario::Operation monte_carlo_step() {
  return scenario::make_operation<model::Model, unfold::MonteCarloParams>(
      "monte_carlo", "Error bars",
      "Restores the section again and again with picks, pin and angle drawn from their errors.", run_monte_carlo,
      {.quantities = add_error_quantities, .tables = add_error_tables, .remarks = add_error_remarks});
}

}  // namespace recon::core
