#include "quebra/gui/solids_shown.h"

#include <memory>

#include "quebra/core/solid_layers.h"
#include "quebra/model/model.h"
#include "shared/gui/canvas.h"
#include "shared/gui/session.h"

namespace quebra::gui {

using dobra::gui::Desk;
using dobra::gui::SectionMade;
namespace scenario = dobra::scenario;
namespace space = dobra::scene::space;

namespace {

/// The model as the last run left it, where it has solids; else null.
const model::Model* model_with_solids(const Desk& desk) {
  const auto& outcome = desk.session.outcome();
  if (!outcome || outcome->run.states.empty()) return nullptr;
  const auto& model = scenario::model_of<model::Model>(outcome->run.states.back());
  return model.solids && !model.solids->parts.empty() ? &model : nullptr;
}

class SolidSection {
 public:
  std::optional<SectionMade> operator()(const Desk& desk, const space::CutPlane& plane) {
    const model::Model* model = model_with_solids(desk);
    if (model == nullptr) return std::nullopt;
    if (!sections_ || sections_->parts() != model->solids)
      sections_ = std::make_shared<const core::SolidSections>(model->solids);
    const scenario::UnitSystem& units = model->units;
    const auto si = [&](double length) { return units.to_si(length, "m"); };
    auto made = sections_->cut({{si(plane.through.x), si(plane.through.y), si(plane.through.z)}, plane.normal});
    if (!made) return std::nullopt;
    space::SpacePicture caps;
    caps.layers = std::move(made->caps);
    dobra::scene::Picture section;
    section.panels.push_back(std::move(made->panel));
    return SectionMade{scenario::in_units(std::move(caps), units).layers,
                       std::move(scenario::in_units(std::move(section), units).panels.front())};
  }

 private:
  std::shared_ptr<const core::SolidSections> sections_;
};

}  // namespace

std::function<std::optional<SectionMade>(const Desk&, const space::CutPlane&)> make_solid_section() {
  return [section = std::make_shared<SolidSection>()](const Desk& desk, const space::CutPlane& plane) {
    return (*section)(desk, plane);
  };
}

void tell_face(const Desk& desk, const dobra::gui::stage::ItemAt& item) {
  const model::Model* model = model_with_solids(desk);
  if (model == nullptr || item.panel != core::section_panel_key || item.pick.layer != core::solid_layer) return;
  const std::vector<std::string> names = core::face_names(model->solids->parts.back());
  if (item.pick.id < names.size()) desk.canvas.say(QString::fromStdString(names[item.pick.id]));
}

}  // namespace quebra::gui
