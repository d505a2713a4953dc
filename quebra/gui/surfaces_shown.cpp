#include "quebra/gui/surfaces_shown.h"

#include "quebra/core/surface_layers.h"
#include "quebra/core/surface_marks.h"

namespace quebra::gui {

std::optional<std::size_t> face_of(const model::Model& model, const dobra::scene::Pick& pick) {
  const model::SurfaceSet& set = *model.surfaces;
  if (pick.layer == core::faces_layer) return pick.id;
  if (pick.layer == "mesh" && !model.surface_meshes.empty()) {
    const auto& faces = model.surface_meshes.back()->mesh.faces;
    return pick.id < faces.size() ? std::optional<std::size_t>(faces[pick.id]) : std::nullopt;
  }
  if (pick.layer != core::left_out_layer) return std::nullopt;
  std::size_t before = 0;
  for (std::size_t f = 0; f < set.parts.size(); ++f) {
    before += set.parts[f].left_out.size();
    if (pick.id < before) return f;
  }
  return std::nullopt;
}

const model::Model* model_with_surfaces(const dobra::gui::Session& session) {
  const dobra::gui::documents::OutcomePtr& outcome = session.outcome();
  if (!outcome || outcome->run.states.empty()) return nullptr;
  const auto& model = dobra::scenario::model_of<model::Model>(outcome->run.states.back());
  return model.surfaces ? &model : nullptr;
}

std::string chart_with(const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item) {
  const model::Model* model = model_with_surfaces(desk.session);
  const auto face = model == nullptr ? std::nullopt : face_of(*model, item.pick);
  return face ? core::chart_key(*face) : std::string();
}

std::optional<dobra::scene::Panel> chart_panel(const dobra::gui::Desk& desk, const std::string& key) {
  const model::Model* model = model_with_surfaces(desk.session);
  const auto face = core::face_of_chart(key);
  if (model == nullptr || !face || *face >= model->surfaces->faces.size()) return std::nullopt;
  dobra::scene::Picture picture;
  picture.panels.push_back(core::chart_of(*model, *face));
  return std::move(dobra::scenario::in_units(std::move(picture), model->units).panels.front());
}

}  // namespace quebra::gui
