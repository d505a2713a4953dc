#include "recon/core/area_balance_step.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_area_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* found = model.findings.get<balance::AreaBalance>();
  if (found == nullptr) return;
  const auto add = [&](const std::string& name, const balance::WithError& number_with, const char* unit) {
    quantities.push_back({name, number_with.value, unit});
    quantities.push_back({name + "_error", number_with.error, unit});
    quantities.push_back({name + "_most", number_with.most, unit});
  };
  add("area", found->area, "m2");
  add("initial_width", found->initial_width, "m");
  add("width", found->width, "m");
  add("area_shortening", found->shortening, "m");
  add("area_shortening_percent", found->percent, "%");
}

}  // namespace

base::Result<model::Model> run_area_balance(const model::Model& model, const balance::AreaBalanceParams& params,
                                            const scenario::Context& context, const base::Progress&) {
  model::Model next = model;
  DOBRA_TRY(balance::AreaBalance found, balance_area(params, context));
  next.findings.set(std::move(found), {});
  return next;
}

scenario::Operation area_balance_step() {
  return scenario::make_operation<model::Model, balance::AreaBalanceParams>(
      "area_balance", "Area balance",
      "Shortening from the area of a section and the thickness that its layers had, with errors.", run_area_balance,
      {.quantities = add_area_quantities});
}

}  // namespace recon::core
