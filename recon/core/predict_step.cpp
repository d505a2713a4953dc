#include "recon/core/predict_step.h"

#include <fmt/format.h>

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "shared/base/text.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color predicted_color{20, 80, 190, 255};

const inversion::Predicted* prediction_of(const model::Model& model) {
  const auto* found = model.findings.get<FoundPrediction>();
  return found == nullptr ? nullptr : &found->predicted;
}

void add_prediction_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const inversion::Predicted* found = prediction_of(model);
  if (found == nullptr) return;
  for (std::size_t i = 0; i < found->solutions.size(); ++i) {
    const std::string prefix = i == 0 ? "predict." : fmt::format("predict.{}.", i + 1);
    for (const auto& [name, value] : found->solutions[i]) quantities.push_back({prefix + name, value, ""});
  }
}

void add_prediction_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const inversion::Predicted* found = prediction_of(model);
  if (found == nullptr || found->lines.empty()) return;
  scenario::DataTable lines{"predicted", {"line", "x [m]", "z [m]"}, {}};
  for (const inversion::Predicted::Line& line : found->lines) {
    for (const geom::Point p : line.line.points) lines.rows.push_back({line.kind, p.x, p.y});
  }
  tables.push_back(std::move(lines));
}

void add_prediction_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const inversion::Predicted* found = prediction_of(model)) append(found->remarks, remarks);
}

void draw_prediction(const model::Model& model, scene::Picture& picture) {
  const auto* found = model.findings.get<FoundPrediction>();
  if (found == nullptr || found->predicted.lines.empty() || is_done(model)) return;
  const section::Palette palette(found->section);
  PanelParts parts;
  parts.under = filled_units(found->section, palette);
  for (const inversion::Predicted::Line& line : found->predicted.lines) {
    scene::Style style;
    style.line = predicted_color;
    const bool regional = line.kind == "regional";
    style.line_width = regional ? 0.8 : 2.0;
    style.dash = regional ? scene::Dash::Dotted : scene::Dash::Dashed;
    const std::string title = regional             ? translated("Regional")
                              : line.kind == "bed" ? translated("Bed predicted")
                                                   : translated("Fault predicted");
    parts.pin.push_back(lines_layer("predicted_" + line.kind, title, style, {line.line}));
  }
  show({section_panel(empty_panel("prediction", translated("Prediction"), found->section), found->section, palette,
                      std::move(parts))},
       found->section, picture);
}

}  // namespace

base::Result<model::Model> run_predict(const model::Model& model, const inversion::PredictParams& params,
                                       const scenario::Context&, const base::Progress&) {
  FoundPrediction found;
  found.section = current_section(model);
  DOBRA_TRY(found.predicted, inversion::predict(found.section, params));
  model::Model next = model;
  const std::size_t state = model.earlier.size() + (is_done(model) ? 1U : 0U);
  next.findings.set(std::move(found), {.state = state, .outlives = model::Outlives::Nothing});
  return next;
}

scenario::Operation predict_step() {
  return scenario::make_operation<model::Model, inversion::PredictParams>(
      "predict", "Prediction",
      "The deep part of a fault from a rollover, a rollover over a fault, or the angles of a fold from its dips.",
      run_predict,
      {.quantities = add_prediction_quantities,
       .tables = add_prediction_tables,
       .remarks = add_prediction_remarks,
       .draw = draw_prediction});
}

}  // namespace recon::core
