#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shared/base/text.h"
#include "shared/canvas/line_edit.h"
#include "shared/canvas/tool.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;
using geom::Polyline;

constexpr std::size_t circle_sides = 64;

bool by_two_clicks(Drawing drawing) { return drawing == Drawing::Rectangle || drawing == Drawing::Circle; }

class DrawTool final : public Tool {
 public:
  explicit DrawTool(Drawing drawing) : drawing_(drawing) {}

  [[nodiscard]] std::string hint() const override {
    switch (drawing_) {
      case Drawing::Line:
      case Drawing::Polygon:
        if (points_.empty()) return translated("Click the first point, or type x,z");
        return translated("Click the next point, or type @dx,dz; Enter ends, Backspace takes a point back");
      case Drawing::Rectangle:
        return points_.empty() ? translated("Click a corner") : translated("Click the opposite corner");
      case Drawing::Circle:
        return points_.empty() ? translated("Click the centre") : translated("Click a point of the circle");
      case Drawing::Point:
        break;
    }
    return translated("Click the point");
  }

  void press(Workspace&, const Pointer& pointer) override {
    cursor_ = pointer.place();
    if (!points_.empty() && points_.back() == cursor_) return;
    points_.push_back(cursor_);
    if (drawing_ == Drawing::Point || (by_two_clicks(drawing_) && points_.size() == 2)) finish();
  }
  void move(Workspace&, const Pointer& pointer) override { cursor_ = pointer.place(); }
  void double_click(Workspace& work, const Pointer& pointer) override {
    if (points_.empty()) return;
    press(work, pointer);
    if (!points_.empty()) finish();
  }
  bool key(Workspace&, Key key) override {
    if (points_.empty()) return false;
    if (key == Key::Enter) finish();
    if (key == Key::Escape) points_.clear();
    if (key == Key::Backspace) points_.pop_back();
    return true;
  }

  [[nodiscard]] std::optional<Point> last() const override {
    return points_.empty() ? std::nullopt : std::optional(points_.back());
  }
  [[nodiscard]] Overlay overlay(const Workspace&) const override {
    Overlay overlay;
    if (points_.empty()) return overlay;
    overlay.lines = {shape_with(cursor_)};
    overlay.handles = points_;
    overlay.texts = {{cursor_, measure_text(points_.back(), cursor_)}};
    return overlay;
  }

 private:
  [[nodiscard]] Polyline shape_with(Point next) const {
    if (drawing_ == Drawing::Rectangle) return rectangle(points_.front(), next);
    if (drawing_ == Drawing::Circle) return regular_polygon(points_.front(), next, circle_sides);
    Polyline line{points_, drawing_ == Drawing::Polygon};
    if (line.points.empty() || line.points.back() != next) line.points.push_back(next);
    return line;
  }
  void finish() {
    const Polyline shape = by_two_clicks(drawing_) && points_.size() < 2 ? Polyline{points_, true} : [&] {
      const Point last = points_.back();
      return by_two_clicks(drawing_) ? shape_with(last) : Polyline{points_, drawing_ == Drawing::Polygon};
    }();
    const bool closed = drawing_ != Drawing::Line && drawing_ != Drawing::Point;
    const std::size_t least = drawing_ == Drawing::Point ? 1 : closed ? 3 : 2;
    if (shape.points.size() < least || (closed && geom::signed_area(shape) == 0.0)) {
      say(Told{
          translated(closed ? "A closed line needs three points that do not lie in line" : "A line needs two points")});
      return;
    }
    points_.clear();
    say(Drawn{drawing_ == Drawing::Point ? Shape::Point : closed ? Shape::Polygon : Shape::Line, shape});
  }

  Drawing drawing_;
  std::vector<Point> points_;
  Point cursor_;
};

class MeasureTool final : public Tool {
 public:
  [[nodiscard]] std::string hint() const override {
    return translated("Click points: length and dip of each way, and from the third point on the area");
  }
  void press(Workspace&, const Pointer& pointer) override {
    if (std::exchange(ended_, false)) points_.clear();
    cursor_ = pointer.place();
    points_.push_back(cursor_);
  }
  void move(Workspace&, const Pointer& pointer) override {
    if (!ended_) cursor_ = pointer.place();
  }
  void double_click(Workspace&, const Pointer&) override { ended_ = true; }
  bool key(Workspace&, Key key) override {
    if (points_.empty()) return false;
    if (key == Key::Enter) ended_ = true;
    if (key == Key::Escape) points_.clear();
    if (key == Key::Backspace) points_.pop_back();
    return true;
  }
  [[nodiscard]] std::optional<Point> last() const override {
    return points_.empty() ? std::nullopt : std::optional(points_.back());
  }
  [[nodiscard]] Overlay overlay(const Workspace&) const override {
    Overlay overlay;
    if (points_.empty()) return overlay;
    Polyline way{points_, false};
    if (way.points.back() != cursor_) way.points.push_back(cursor_);
    overlay.handles = way.points;
    if (way.points.size() < 2) return overlay;
    std::string told = measure_text(way.points[way.points.size() - 2], way.points.back());
    if (way.points.size() > 2) {
      const Polyline ring{way.points, true};
      told += "\n" + fmt::format(fmt::runtime(translated("{:.6g} m in all, area {:.6g} m²")), geom::length(way),
                                 std::abs(geom::signed_area(ring)));
    }
    overlay.texts = {{way.points.back(), told}};
    overlay.lines = {std::move(way)};
    return overlay;
  }

 private:
  std::vector<Point> points_;
  Point cursor_;
  bool ended_ = false;
};

}  // namespace

std::string measure_text(Point from, Point to) {
  const geom::Vector way = to - from;
  const double length = geom::length(way);
  if (length == 0.0) return fmt::format("{} m", 0);
  const double dip = std::atan2(std::abs(way.y), std::abs(way.x)) * 180.0 / std::numbers::pi;
  return fmt::format(fmt::runtime(translated("{:.6g} m, dip {:.1f}°")), length, dip);
}

std::unique_ptr<Tool> make_draw_tool(Drawing drawing) { return std::make_unique<DrawTool>(drawing); }
std::unique_ptr<Tool> make_measure_tool() { return std::make_unique<MeasureTool>(); }

}  // namespace dobra::canvas
