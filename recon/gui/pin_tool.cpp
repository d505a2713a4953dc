#include "recon/gui/pin_tool.h"

#include <fmt/format.h>

#include <QPainter>
#include <algorithm>

#include "recon/model/model.h"
#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/gui/documents/edit.h"
#include "shared/gui/session.h"
#include "shared/gui/text.h"

namespace recon::gui {

namespace {

namespace canvas = dobra::canvas;
namespace geom = dobra::geom;
namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using dobra::base::translated;

/// The step whose pin is dragged, and the top that it holds.
struct Held {
  std::size_t step = 0;  ///< 1-based.
  geom::Polyline top;
};

/// Whether the panel shows the horizons of the section, each where it stands.
bool shows(const scene::Panel& panel, const section::Section& section) {
  const auto drawn = [&](const geom::Polyline& line) {
    return std::any_of(panel.layers.begin(), panel.layers.end(), [&](const scene::Layer& layer) {
      const auto* lines = std::get_if<scene::Lines>(&layer.content);
      return lines != nullptr && std::find(lines->lines.begin(), lines->lines.end(), line) != lines->lines.end();
    });
  };
  return std::all_of(section.horizons.begin(), section.horizons.end(),
                     [&](const section::Horizon& horizon) { return drawn(horizon.line); });
}

class PinTool final : public canvas::Tool {
 public:
  explicit PinTool(const dobra::gui::Desk& desk) : session_(desk.session) {}

  [[nodiscard]] std::string hint() const override {
    return translated("Press on the section and drag to where the top is held; Escape gives up");
  }

  void press(canvas::Workspace& work, const canvas::Pointer& pointer) override {
    held_ = find(work.panel());
    if (!held_) return;
    before_ = session_.history().current();
    take(pointer);
  }
  void move(canvas::Workspace&, const canvas::Pointer& pointer) override {
    if (!held_) return;
    // Undone or edited elsewhere amid the gesture: it is over.
    if (before_ != session_.history().current()) return give_up();
    take(pointer);
    session_.look_at(with_pin());
  }
  void release(canvas::Workspace&, const canvas::Pointer&) override {
    if (!held_) return;
    if (before_ == session_.history().current()) session_.edit(with_pin(), dobra::gui::text("Move the pin"));
    held_.reset();
  }
  bool key(canvas::Workspace&, canvas::Key key) override {
    if (key != canvas::Key::Escape) return false;
    if (held_) {
      give_up();
    } else {
      say(canvas::PutAway{});
    }
    return true;
  }
  void put_down(canvas::Workspace&) override {
    if (held_) give_up();
  }
  [[nodiscard]] bool unfinished() const override { return held_.has_value(); }

  [[nodiscard]] canvas::Overlay overlay(const canvas::Workspace& work) const override {
    canvas::Overlay overlay;
    canvas::show_selection(work, overlay);
    if (!held_) return overlay;
    overlay.handles.push_back(at_);
    overlay.texts.push_back(
        {at_, canvas::with_decimal_mark(fmt::format("x = {:.6g} {}", at_.x / work.unit.size, work.unit.name))});
    return overlay;
  }

 private:
  /// Says why there is none.
  std::optional<Held> find(const scene::Panel& panel) {
    const scenario::Document& document = session_.document();
    const dobra::gui::documents::OutcomePtr& outcome = session_.outcome();
    std::size_t targets = 0;
    for (std::size_t step = document.steps.size(); step > 0; --step) {
      if (document.steps[step - 1].operation != "target") continue;
      ++targets;
      // Parts before the step count from the input: its section stands in the state before it.
      const bool known = outcome && outcome->run.states.size() >= step &&
                         dobra::gui::Session::common_parts(document, *outcome->document) >= step;
      if (!known) continue;
      const auto& before = scenario::model_of<model::Model>(outcome->run.states[step - 1]);
      if (!before.source || !shows(panel, before.section)) continue;
      const section::Horizon* top = section::find_horizon(before.section, before.source->top);
      if (top != nullptr) return Held{step, top->line};
    }
    say(canvas::Told{
        targets == 0 ? translated("There is nothing to pin: the scenario has no step 'Target'.")
                     : translated("The pin stands on the section that is restored; press there, in its own panel.")});
    return std::nullopt;
  }

  /// The place on the top that is straight above or below, of several the nearest.
  void take(const canvas::Pointer& pointer) {
    const geom::Box box = held_->top.box();
    const double x = std::clamp(pointer.place().x, box.low.x, box.high.x);
    std::optional<geom::Point> nearest;
    const double z = pointer.place().y;
    for (std::size_t i = 0; i < held_->top.segment_count(); ++i) {
      const geom::Segment side = held_->top.segment(i);
      const auto [left, right] = std::minmax(side.from.x, side.to.x);
      if (x < left || x > right) continue;
      const double t = side.from.x == side.to.x ? 0.0 : (x - side.from.x) / (side.to.x - side.from.x);
      const geom::Point at{x, side.from.y + t * (side.to.y - side.from.y)};
      if (!nearest || std::abs(at.y - z) < std::abs(nearest->y - z)) nearest = at;
    }
    at_ = nearest.value_or(geom::Point{x, z});
  }

  [[nodiscard]] scenario::Document with_pin() const {
    scenario::Table target = dobra::gui::documents::table_of(*before_, held_->step);
    target.set("pin", at_.x);
    return dobra::gui::documents::with_table(*before_, held_->step, std::move(target));
  }

  void give_up() {
    held_.reset();
    session_.run();
  }

  dobra::gui::Session& session_;
  std::optional<Held> held_;
  dobra::gui::documents::DocumentPtr before_;  ///< When the gesture began.
  geom::Point at_;
};

}  // namespace

std::unique_ptr<canvas::Tool> make_pin_tool(const dobra::gui::Desk& desk) { return std::make_unique<PinTool>(desk); }

void draw_pin(QPainter& painter) {
  painter.drawPolyline(QPolygonF({{2, 15}, {7, 12}, {17, 18}, {22, 15}}));
  painter.drawLine(QPointF(12, 8), QPointF(12, 22));
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(QPolygonF({{8, 2}, {16, 2}, {12, 8}}));
}

}  // namespace recon::gui
