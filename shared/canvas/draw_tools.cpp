#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"
#include "shared/canvas/line_edit.h"
#include "shared/canvas/tool.h"

namespace dobra::canvas {

namespace {

using base::translated;
using geom::Point;
using geom::Polyline;

constexpr std::size_t circle_sides = 64;

bool by_two_clicks(Drawing drawing) { return drawing == Drawing::Rectangle || drawing == Drawing::Circle; }

/// Places one after the other.
class PointsTool : public Tool {
 public:
  bool key(Workspace&, Key key) override {
    if (points_.empty()) return false;
    if (key == Key::Enter) end();
    if (key == Key::Escape) points_.clear();
    if (key == Key::Backspace) points_.pop_back();
    return true;
  }
  [[nodiscard]] std::optional<Point> last() const override {
    return points_.empty() ? std::nullopt : std::optional(points_.back());
  }

 protected:
  virtual void end() = 0;

  std::vector<Point> points_;
  Point cursor_;
};

class DrawTool final : public PointsTool {
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
    if (drawing_ == Drawing::Point || (by_two_clicks(drawing_) && points_.size() == 2)) end();
  }
  void move(Workspace&, const Pointer& pointer) override { cursor_ = pointer.place(); }
  void double_click(Workspace& work, const Pointer& pointer) override {
    if (points_.empty()) return;
    press(work, pointer);
    if (!points_.empty()) end();
  }
  void put_down(Workspace&) override {
    if (const auto shape = made()) say(*shape);
    points_.clear();
  }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    if (points_.empty()) return overlay;
    overlay.lines = {shape_with(cursor_)};
    overlay.handles = points_;
    overlay.texts = {{cursor_, measure_text(points_.back(), cursor_, work.unit, work.direction)}};
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
  [[nodiscard]] bool closed() const { return drawing_ != Drawing::Line && drawing_ != Drawing::Point; }
  /// Nothing as long as it has too few points.
  [[nodiscard]] std::optional<Drawn> made() const {
    const std::size_t least = drawing_ == Drawing::Polygon ? 3 : drawing_ == Drawing::Point ? 1 : 2;
    if (points_.size() < least) return std::nullopt;
    Polyline line = by_two_clicks(drawing_) ? shape_with(points_.back()) : Polyline{points_, closed()};
    if (closed() && geom::signed_area(line) == 0.0) return std::nullopt;
    return Drawn{drawing_ == Drawing::Point ? Shape::Point : closed() ? Shape::Polygon : Shape::Line, std::move(line)};
  }
  void end() override {
    if (const auto shape = made()) {
      points_.clear();
      say(*shape);
    } else {
      say(Told{translated(closed() ? "A closed line needs three points that do not lie in line"
                                   : "A line needs two points")});
    }
  }

  Drawing drawing_;
};

class MeasureTool final : public PointsTool {
 public:
  [[nodiscard]] std::string hint() const override {
    return translated("Click points: length and direction of each way, and from the third point on the area");
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
  [[nodiscard]] bool unfinished() const override { return !points_.empty() && !ended_; }
  [[nodiscard]] Overlay overlay(const Workspace& work) const override {
    Overlay overlay;
    if (points_.empty()) return overlay;
    Polyline way{points_, false};
    if (way.points.back() != cursor_) way.points.push_back(cursor_);
    overlay.handles = way.points;
    if (way.points.size() < 2) return overlay;
    std::string told = measure_text(way.points[way.points.size() - 2], way.points.back(), work.unit, work.direction);
    if (way.points.size() > 2) {
      const Polyline ring{way.points, true};
      const LengthUnit& unit = work.unit;
      told += "\n" + fmt::format(fmt::runtime(translated("{:.6g} {} in all, area {:.6g} {}²")),
                                 geom::length(way) / unit.size, unit.name,
                                 std::abs(geom::signed_area(ring)) / unit.size / unit.size, unit.name);
    }
    overlay.texts = {{way.points.back(), with_decimal_mark(told)}};
    overlay.lines = {std::move(way)};
    return overlay;
  }

 private:
  void end() override { ended_ = true; }

  bool ended_ = false;
};

}  // namespace

std::string measure_text(Point from, Point to, const LengthUnit& unit, Direction direction) {
  const geom::Vector way = to - from;
  const double length = geom::length(way);
  if (length == 0.0) return fmt::format("{} {}", 0, unit.name);
  const bool dips = direction == Direction::Dip;
  const double angle = dips ? std::atan2(std::abs(way.y), std::abs(way.x)) : std::atan2(way.y, way.x);
  const std::string told = dips ? translated("{:.6g} {}, dip {:.1f}°") : translated("{:.6g} {}, angle {:.1f}°");
  return with_decimal_mark(
      fmt::format(fmt::runtime(told), length / unit.size, unit.name, angle * 180.0 / std::numbers::pi));
}

std::string made_by_a_step() {
  return translated("A step has made this; show the input to edit it (menu View, or Ctrl+1).");
}

std::unique_ptr<Tool> make_draw_tool(Drawing drawing) { return std::make_unique<DrawTool>(drawing); }
std::unique_ptr<Tool> make_measure_tool() { return std::make_unique<MeasureTool>(); }

}  // namespace dobra::canvas
