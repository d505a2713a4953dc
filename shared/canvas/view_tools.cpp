#include "shared/base/text.h"
#include "shared/canvas/line_edit.h"
#include "shared/canvas/tool.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;

/// The view moves under the hand; the tool itself has nothing to do.
class HandTool final : public Tool {
 public:
  [[nodiscard]] std::string hint() const override {
    return translated("Drag to move the view; the wheel zooms; Escape goes back to Select");
  }
  [[nodiscard]] Cursor cursor() const override { return Cursor::Hand; }
  [[nodiscard]] bool snaps() const override { return false; }
  void press(Workspace&, const Pointer&) override {}
  void move(Workspace&, const Pointer&) override {}
  bool key(Workspace&, Key key) override {
    if (key == Key::Escape) say(PutAway{});
    return key == Key::Escape;
  }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    show_selection(work, overlay);
    return overlay;
  }
};

class ZoomTool final : public Tool {
 public:
  [[nodiscard]] std::string hint() const override {
    return translated("Drag a box round what is to be seen; a click zooms in, with Shift out; Escape goes back");
  }
  [[nodiscard]] Cursor cursor() const override { return Cursor::Magnifier; }
  [[nodiscard]] bool snaps() const override { return false; }
  void press(Workspace&, const Pointer& pointer) override { box_ = {pointer.at, pointer.at}; }
  void move(Workspace&, const Pointer& pointer) override {
    if (box_) box_->second = pointer.at;
  }
  void release(Workspace&, const Pointer& pointer) override {
    if (!box_) return;
    const Point corners[] = {box_->first, pointer.at};
    const geom::Box box = geom::box_of(corners);
    box_.reset();
    // What is as small as the hand trembles is a click.
    const bool click = box.width() < 0.5 * pointer.reach && pointer.exaggeration * box.height() < 0.5 * pointer.reach;
    if (click) {
      say(LookedAt{geom::Box{pointer.at, pointer.at}, pointer.modifier == Modifier::Add ? 0.5 : 2.0});
    } else {
      say(LookedAt{box, 1.0});
    }
  }
  bool key(Workspace&, Key key) override {
    if (key != Key::Escape) return false;
    if (!box_) say(PutAway{});
    box_.reset();
    return true;
  }
  [[nodiscard]] bool unfinished() const override { return false; }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    show_selection(work, overlay);
    if (box_) overlay.lines.push_back(rectangle(box_->first, box_->second));
    return overlay;
  }

 private:
  std::optional<std::pair<Point, Point>> box_;
};

}  // namespace

std::unique_ptr<Tool> make_hand_tool() { return std::make_unique<HandTool>(); }
std::unique_ptr<Tool> make_zoom_tool() { return std::make_unique<ZoomTool>(); }

}  // namespace dobra::canvas
