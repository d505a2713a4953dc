// A place or a line that a field of a form is waiting for.

#include <utility>

#include "shared/canvas/tool.h"

namespace dobra::canvas {

namespace {

class PointTool : public Tool {
 public:
  explicit PointTool(std::string hint) : hint_(std::move(hint)) {}
  [[nodiscard]] std::string hint() const override { return hint_; }
  [[nodiscard]] bool unfinished() const override { return true; }

  void press(Workspace&, const Pointer&) override { pressed_ = true; }
  void release(Workspace& work, const Pointer& pointer) override {
    if (!std::exchange(pressed_, false)) return;
    Pointed pointed{pointer.place(), pointer.at};
    if (pointer.snap) pointed.line = pointer.snap->on;
    if (!pointed.line) pointed.line = scene::pick(work.panel(), pointer.at, pointer.reach);
    say(pointed);
  }
  void move(Workspace&, const Pointer& pointer) override { at_ = pointer.place(); }
  bool key(Workspace&, Key key) override {
    if (key != Key::Escape && key != Key::Backspace) return false;
    say(NotPointed{});
    return true;
  }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    show_selection(work, overlay);
    if (at_) overlay.handles.push_back(*at_);
    return overlay;
  }

 private:
  std::string hint_;
  bool pressed_ = false;  ///< The click was begun here.
  std::optional<geom::Point> at_;
};

}  // namespace

std::unique_ptr<Tool> make_point_tool(std::string hint) { return std::make_unique<PointTool>(std::move(hint)); }

}  // namespace dobra::canvas
