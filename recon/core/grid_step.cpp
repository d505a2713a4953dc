#include "recon/core/grid_step.h"

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "recon/input/topography.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;

namespace {

/// The stage that the grid stands on.
base::Result<model::Model> stage_from(const model::Model& model, unfold::GridFrom from) {
  if (from == unfold::GridFrom::Current) return next_stage(model);
  model::Model next;
  next.remarks = model.remarks;
  next.findings = model.findings;
  next.findings.begin_stage();
  next.findings.forget_after(0);
  next.section = input_section(model);
  return next;
}

void add_grid_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.source) return;
  const unfold::SourceGrid& source = *model.source;
  quantities.push_back({"grid.curves", count_of(source.grid.curves.size()), ""});
  quantities.push_back({"grid.rungs", count_of(source.grid.rungs.size()), ""});
  quantities.push_back({"grid.vanished", count_of(source.grid.vanished), ""});
  quantities.push_back({"grid.deepest", source.deepest, "m"});
  quantities.push_back({"grid.last_distance", source.options.distances.back(), "m"});
}

void add_grid_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->source) return;
  outputs.push_back({"source_grid.geojson", [model](const std::filesystem::path& path) {
                       const auto pin = model->target ? std::optional(model->target->source_pin) : std::nullopt;
                       return io::gis::write_geojson(path.string(),
                                                     grid_features(model->source->base, model->source->grid, pin));
                     }});
}

void add_grid_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (model.source) append(model.source->remarks, remarks);
}

/// Until there is a target, which draws both sides.
void draw_grid(const model::Model& model, dobra::scene::Picture& picture) {
  if (!model.source || model.target) return;
  const section::Palette palette(model.section);
  PanelParts parts;
  parts.under = filled_units(model.section, palette);
  parts.grid = grid_layers(model.source->grid, "source_grid");
  show({current_panel(model, palette, std::move(parts))}, model.section, picture);
}

}  // namespace

base::Result<model::Model> run_grid(const model::Model& model, const unfold::GridParams& params,
                                    const scenario::Context&, const base::Progress& progress) {
  DOBRA_TRY(model::Model next, stage_from(model, params.from));
  DOBRA_TRY(next.section, input::with_topography_as_horizon(std::move(next.section), params.top));
  DOBRA_TRY(next.source, make_source_grid(next.section, params, progress));
  return next;
}

scenario::Operation grid_step() {
  return scenario::make_operation<model::Model, unfold::GridParams>(
      "grid", "Source grid", "Offset curves of the top of the section and the transversals between them.", run_grid,
      {.quantities = add_grid_quantities, .remarks = add_grid_remarks, .outputs = add_grid_outputs, .draw = draw_grid});
}

}  // namespace recon::core
