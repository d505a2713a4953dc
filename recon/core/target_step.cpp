#include "recon/core/target_step.h"

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "shared/base/text.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;
namespace scene = dobra::scene;
using base::translated;

namespace {

void add_target_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.target) return;
  quantities.push_back({"target.curves", count_of(model.target->grid.curves.size()), ""});
  quantities.push_back({"target.extended", model.target->extended, "m"});
  quantities.push_back({"columns", count_of(model.target->map.source().inner_count()), ""});
}

void add_target_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->target) return;
  outputs.push_back({"target_grid.geojson", [model](const std::filesystem::path& path) {
                       return io::gis::write_geojson(
                           path.string(), grid_features(model->target->map.target().base_line(), model->target->grid,
                                                        model->target->target_pin));
                     }});
}

void add_target_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (model.target) append(model.target->remarks, remarks);
}

scene::Panel grid_panel(const model::Model& model, const section::Palette& palette, const geom::Polyline& pin) {
  scene::Panel panel = empty_panel("restored", translated("Target grid"), model.section);
  panel.layers = grid_layers(model.target->grid, "target_grid");
  scene::Style style;
  const section::Horizon* top = find_horizon(model.section, model.source->top);
  if (top != nullptr) style.line = palette.of(whole_name(*top)).line;
  style.line_width = 1.6;
  panel.layers.push_back(lines_layer("target", translated("Target"), style, {model.target->map.target().base_line()}));
  for (scene::Layer& layer : pin_layers(pin)) panel.layers.push_back(std::move(layer));
  return panel;
}

/// The section with its grid and the target's, until it is restored.
void draw_target(const model::Model& model, scene::Picture& picture) {
  if (!model.target || model.restoration) return;
  const section::Palette palette(model.section);
  const maps::ColumnMap& map = model.target->map;
  const maps::ColumnPoint pin = map.locate(model.target->source_pin).at;
  const double deepest = model.source->options.distances.back();
  PanelParts parts;
  parts.under = filled_units(model.section, palette);
  parts.grid = grid_layers(model.source->grid, "source_grid");
  parts.pin = pin_layers(normal_at_pin(map.source(), pin, deepest));
  show({current_panel(model, palette, std::move(parts)),
        grid_panel(model, palette, normal_at_pin(map.target(), pin, deepest))},
       model.section, picture);
}

}  // namespace

base::Result<model::Model> run_target(const model::Model& model, const unfold::TargetParams& params,
                                      const scenario::Context& context, const base::Progress& progress) {
  if (!model.source) {
    return base::Error{base::ErrorCode::CannotRestore,
                       "a target needs a source grid first; put a step 'grid' before it"};
  }
  model::Model next = model;
  next.restoration.reset();
  next.findings.forget_after(model.earlier.size());
  DOBRA_TRY(next.target, make_target(model.section, *model.source, params, context, progress));
  return next;
}

scenario::Operation target_step() {
  return scenario::make_operation<model::Model, unfold::TargetParams>(
      "target", "Target", "The geometry to which the top is restored, a datum or a line, held at a pin.", run_target,
      {.quantities = add_target_quantities,
       .remarks = add_target_remarks,
       .outputs = add_target_outputs,
       .draw = draw_target});
}

}  // namespace recon::core
