#include "quebra/gui/control_drag.h"

#include "quebra/core/surface_edits.h"
#include "quebra/gui/surfaces_shown.h"
#include "shared/gui/canvas.h"
#include "shared/gui/messages.h"
#include "shared/gui/session.h"
#include "shared/gui/text.h"

namespace quebra::gui {

using dobra::gui::Desk;
using dobra::gui::text;
using dobra::gui::stage::ItemAt;
using dobra::gui::stage::MarkerDrag;

namespace {

/// What is dragged, from the beginning of a drag to its end: runs on the way may have no surfaces to tell of.
class Dragged {
 public:
  void operator()(const Desk& desk, MarkerDrag phase, const ItemAt& marker, const dobra::geom::Point3& to) {
    if (phase == MarkerDrag::Begins) begin(desk.session);
    if (phase == MarkerDrag::Begins || !set_ || marker.pick.id >= set_->controls.size()) return;
    if (phase == MarkerDrag::IsTakenBack || (marker.place && to == *marker.place)) return desk.session.run();
    auto moved = core::with_control_moved(desk.session.document(), *set_, marker.pick.id, to);
    if (!moved) return desk.canvas.say(dobra::gui::in_words(moved.error()));
    if (phase == MarkerDrag::Moves) {
      (void)desk.session.look_at(*std::move(moved));
      return;
    }
    const model::ControlPoint& control = set_->controls[marker.pick.id];
    desk.session.edit(*std::move(moved),
                      text("Move point %1 of '%2'").arg(control.point + 1).arg(QString::fromStdString(control.name)));
  }

 private:
  void begin(const dobra::gui::Session& session) {
    const model::Model* model = model_with_surfaces(session);
    set_ = model != nullptr ? model->surfaces : nullptr;
  }

  std::shared_ptr<const model::SurfaceSet> set_;
};

}  // namespace

ControlDrag make_control_drag() {
  return
      [dragged = std::make_shared<Dragged>()](const Desk& desk, MarkerDrag phase, const ItemAt& marker,
                                              const dobra::geom::Point3& to) { (*dragged)(desk, phase, marker, to); };
}

}  // namespace quebra::gui
