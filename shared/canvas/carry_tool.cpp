#include <cmath>

#include "shared/base/text.h"
#include "shared/canvas/tool.h"
#include "shared/geom/transform.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;

/// Two places tell how the selected lines are carried: from here to there, about here to that direction, over the line
/// from here to there.
class CarryTool final : public Tool {
 public:
  explicit CarryTool(Carrying carrying) : carrying_(carrying) {}

  [[nodiscard]] std::string hint() const override {
    if (base_) {
      return carrying_ == Carrying::Rotate
                 ? translated("Click where the direction to the right is to point, or type degrees")
             : carrying_ == Carrying::Mirror ? translated("Click a second point of the mirror line")
                                             : translated("Click where it is to go, or type @dx,dz");
    }
    return carrying_ == Carrying::Rotate   ? translated("Select lines, then click the point to turn them about")
           : carrying_ == Carrying::Mirror ? translated("Select lines, then click a point of the mirror line")
                                           : translated("Select lines, then click the point to take them by");
  }

  void press(Workspace& work, const Pointer& pointer) override {
    if (work.selection.empty()) {
      say(Told{translated("Nothing is selected: take up Select (S) and click a line first.")});
      return;
    }
    if (!base_) {
      base_ = to_ = pointer.place();
      return;
    }
    to_ = pointer.place();
    if (to_ != *base_) finish(work);
  }
  void move(Workspace& work, const Pointer& pointer) override {
    if (!base_) return;
    to_ = pointer.place();
    if (to_ != *base_ && carrying_ != Carrying::Copy) say(edit(work, Stage::During));
  }
  bool key(Workspace&, Key key) override {
    if (key != Key::Escape || !base_) return false;
    base_.reset();
    say(Dropped{});
    return true;
  }
  [[nodiscard]] std::optional<Point> last() const override { return base_; }
  [[nodiscard]] std::optional<Point> place_of_number(double number) const override {
    if (!base_ || carrying_ != Carrying::Rotate) return std::nullopt;
    return geom::Transform::rotation(base::Angle::from_degrees(number), *base_)(*base_ + geom::Vector{1.0, 0.0});
  }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    show_selection(work, overlay);
    if (!base_ || to_ == *base_) return overlay;
    for (const auto& [pick, line] : images(work)) overlay.lines.push_back(line);
    overlay.lines.push_back({{*base_, to_}, false});
    overlay.texts.push_back({to_, measure_text(*base_, to_, work.unit, work.direction)});
    return overlay;
  }

 private:
  [[nodiscard]] geom::Transform map() const {
    const geom::Vector way = to_ - *base_;
    if (carrying_ == Carrying::Rotate)
      return geom::Transform::rotation(base::Angle::from_radians(std::atan2(way.y, way.x)), *base_);
    if (carrying_ != Carrying::Mirror) return geom::Transform::translation(way);
    // p - 2 (n . (p - base)) n with the unit normal n of the mirror line.
    const geom::Vector n = geom::normalised(geom::left_of(way));
    const double off = 2.0 * (n.x * base_->x + n.y * base_->y);
    return {1.0 - 2.0 * n.x * n.x, -2.0 * n.x * n.y, off * n.x, -2.0 * n.x * n.y, 1.0 - 2.0 * n.y * n.y, off * n.y};
  }
  [[nodiscard]] std::vector<std::pair<scene::Pick, geom::Polyline>> images(const Workspace& work) const {
    const geom::Transform carry = map();
    std::vector<std::pair<scene::Pick, geom::Polyline>> images;
    for (const auto& [pick, vertices] : work.selection) {
      if (const geom::Polyline* line = work.line(pick)) images.emplace_back(pick, carry(*line));
    }
    return images;
  }
  [[nodiscard]] Edited edit(const Workspace& work, Stage stage) const {
    const char* what = carrying_ == Carrying::Rotate   ? "Rotate lines"
                       : carrying_ == Carrying::Mirror ? "Mirror lines"
                                                       : "Move lines";
    Edited edited{{}, translated(what), stage};
    for (auto& [pick, line] : images(work)) edited.lines.push_back({pick, {std::move(line)}});
    return edited;
  }
  void finish(const Workspace& work) {
    if (carrying_ == Carrying::Copy) {
      for (auto& [pick, line] : images(work)) {
        const Shape shape = line.closed ? Shape::Polygon : line.points.size() == 1 ? Shape::Point : Shape::Line;
        say(Drawn{shape, std::move(line)});
      }
    } else {
      say(edit(work, Stage::Done));
    }
    base_.reset();
  }

  Carrying carrying_;
  std::optional<Point> base_;
  Point to_;
};

}  // namespace

std::unique_ptr<Tool> make_carry_tool(Carrying carrying) { return std::make_unique<CarryTool>(carrying); }

}  // namespace dobra::canvas
