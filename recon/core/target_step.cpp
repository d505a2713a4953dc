#include "recon/core/steps.h"

#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

void add_target_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.target) return;
  quantities.push_back({"target.curves", count_of(model.target->grid.curves.size()), ""});
  quantities.push_back({"target.extended", model.target->extended, "m"});
  quantities.push_back({"columns", count_of(model.target->map.source().inner_count()), ""});
}

void add_target_outputs(const std::shared_ptr<const Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->target) return;
  outputs.push_back({"target_grid.geojson", [model](const std::filesystem::path& path) {
                       return io::gis::write_geojson(
                           path.string(), grid_features(model->target->map.target().base_line(), model->target->grid,
                                                        model->target->target_pin));
                     }});
}

void add_target_remarks(const Model& model, std::vector<std::string>& remarks) {
  if (model.target) append(model.target->remarks, remarks);
}

}  // namespace

base::Result<Model> run_target(const Model& model, const TargetParams& params, const scenario::Context& context,
                               const base::Progress& progress) {
  if (!model.source) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "a target needs a source grid first; put a step 'grid' before it"};
  }
  Model next = model;
  next.restoration.reset();
  next.monte_carlo.reset();
  forget_carried(next);
  DOBRA_TRY(next.target, make_target(model.section, *model.source, params, context, progress));
  return next;
}

scenario::Operation target_step() {
  return scenario::make_operation<Model, TargetParams>(
      "target", "Target", "The geometry to which the top is restored, a datum or a line, held at a pin.", run_target,
      {.quantities = add_target_quantities, .remarks = add_target_remarks, .outputs = add_target_outputs});
}

}  // namespace recon::core
