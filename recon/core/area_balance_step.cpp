#include "recon/core/steps.h"

#include "recon/core/operations.h"

namespace recon::core {

namespace scenario = dobra::scenario;

namespace {

void add_area_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.area_balance) return;
  const AreaBalance& balance = *model.area_balance;
  const auto add = [&](const std::string& name, const WithError& number_with, const char* unit) {
    quantities.push_back({name, number_with.value, unit});
    quantities.push_back({name + "_error", number_with.error, unit});
    quantities.push_back({name + "_most", number_with.most, unit});
  };
  add("area", balance.area, "m2");
  add("initial_width", balance.initial_width, "m");
  add("width", balance.width, "m");
  add("area_shortening", balance.shortening, "m");
  add("area_shortening_percent", balance.percent, "%");
}

}  // namespace

base::Result<Model> run_area_balance(const Model& model, const AreaBalanceParams& params,
                                     const scenario::Context& context, const base::Progress&) {
  Model next = model;
  DOBRA_TRY(next.area_balance, balance_area(params, context));
  return next;
}

scenario::Operation area_balance_step() {
  return scenario::make_operation<Model, AreaBalanceParams>(
      "area_balance", "Area balance",
      "Shortening from the area of a section and the thickness that its layers had, with errors.", run_area_balance,
      {.quantities = add_area_quantities});
}

}  // namespace recon::core
