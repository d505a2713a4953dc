#include "shared/render/vtk_marks.h"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

#include "shared/render/vtk_scene.h"
#include "shared/scene/color_map.h"
#include "shared/scene/pattern.h"

namespace dobra::render {
namespace {

using geom::Point;
using scene::Color;

int pixel_size(const scene::Font& font, double pixels_per_point) {
  return std::max(1, static_cast<int>(std::lround(font.size * pixels_per_point)));
}

void set_font(vtkTextProperty& property, const scene::Font& font, double pixels_per_point) {
  const bool bold = font.weight == scene::Weight::Bold;
  const char* file =
      bold ? "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf" : "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  std::error_code none;
  if (std::filesystem::exists(file, none)) {
    property.SetFontFamily(VTK_FONT_FILE);
    property.SetFontFile(file);
  } else {
    property.SetFontFamilyToArial();
    property.SetBold(bold);
  }
  property.SetFontSize(pixel_size(font, pixels_per_point));
}

/// Points.
double ink_width(const std::string& text, const scene::Font& font, double pixels_per_point) {
  vtkNew<vtkTextProperty> property;
  set_font(*property, font, pixels_per_point);
  int box[4] = {0, -1, 0, -1};
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (text.empty() || renderer == nullptr || !renderer->GetBoundingBox(property, text, box, 72)) return 0.0;
  return (box[1] - box[0] + 1) / pixels_per_point;
}

/// Page shapes as coloured triangles in pixels, y up.
class Shapes {
 public:
  Shapes(int height, double pixels_per_point) : height_(height), scale_(pixels_per_point) {
    colors_->SetNumberOfComponents(4);
  }

  void operator()(const scene::LineMark& mark) {
    if (mark.width <= 0.0) return;
    const geom::Polyline line{{mark.from, mark.to}, false};
    if (mark.dash == scene::Dash::Solid) return add_line({mark.from, mark.to}, mark.color, mark.width);
    const geom::Box window = line.box().grown(1.0);
    for (const geom::Segment& stroke : scene::strokes_of(line, scene::dash_lengths(mark.dash, mark.width), window)) {
      add_line(stroke, mark.color, mark.width);
    }
  }

  void operator()(const scene::BoxMark& mark) {
    if (mark.fill) {
      add_box(pixels(mark.box), *mark.fill, *mark.fill, scene::GradientMark::Direction::Up);
      add_pattern(mark.box, mark.pattern);
    }
    if (mark.line_width <= 0.0) return;
    // Sides are as long as to fill the corners.
    const double half = 0.5 * snapped_width(mark.line_width) / scale_;
    const geom::Box& b = mark.box;
    add_line({{b.low.x - half, b.low.y}, {b.high.x + half, b.low.y}}, mark.line, mark.line_width);
    add_line({{b.low.x - half, b.high.y}, {b.high.x + half, b.high.y}}, mark.line, mark.line_width);
    add_line({{b.low.x, b.low.y + half}, {b.low.x, b.high.y - half}}, mark.line, mark.line_width);
    add_line({{b.high.x, b.low.y + half}, {b.high.x, b.high.y - half}}, mark.line, mark.line_width);
  }

  void operator()(const scene::DiscMark& mark) {
    constexpr int sides = 32;
    const Point middle = pixel(mark.centre);
    const double radius = 0.5 * mark.diameter * scale_;
    const auto rim = [&](int i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      return Point{middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
    };
    for (int i = 0; i < sides; ++i) add_triangle({middle, rim(i), rim(i + 1)}, {mark.fill, mark.fill, mark.fill});
  }

  void operator()(const scene::TriangleMark& mark) {
    add_triangle({pixel(mark.corners[0]), pixel(mark.corners[1]), pixel(mark.corners[2])},
                 {mark.fill, mark.fill, mark.fill});
  }

  void operator()(const scene::GradientMark& mark) {
    constexpr int parts = 64;
    const geom::Box all = pixels(mark.box);
    for (int i = 0; i < parts; ++i) {
      const double from = static_cast<double>(i) / parts;
      const double to = static_cast<double>(i + 1) / parts;
      geom::Box part = all;
      if (mark.direction == scene::GradientMark::Direction::Up) {
        part.low.y = all.low.y + from * all.height();
        part.high.y = all.low.y + to * all.height();
      } else {
        part.low.x = all.low.x + from * all.width();
        part.high.x = all.low.x + to * all.width();
      }
      add_box(part, scene::color_at(mark.map, from), scene::color_at(mark.map, to), mark.direction);
    }
  }

  void operator()(const scene::TextMark&) {}

  void move_to(vtkPolyData& data) {
    data.Initialize();
    data.SetPoints(points_);
    data.SetPolys(cells_);
    data.GetPointData()->SetScalars(colors_);
    data.Modified();
  }

 private:
  [[nodiscard]] Point pixel(Point page) const { return {page.x * scale_, height_ - page.y * scale_}; }

  /// In whole pixels, so that borders are sharp.
  [[nodiscard]] geom::Box pixels(const geom::Box& page) const {
    geom::Box box;
    for (const Point& corner : {pixel(page.low), pixel(page.high)})
      box.add(Point{std::round(corner.x), std::round(corner.y)});
    return box;
  }

  void add_pattern(const geom::Box& b, scene::Pattern pattern) {
    const geom::Polyline border{{b.low, {b.high.x, b.low.y}, b.high, {b.low.x, b.high.y}}, true};
    const double width = scene::pattern_width(pattern);
    for (const geom::Segment& stroke : scene::parts_inside(scene::pattern_strokes(pattern, b), {border}))
      add_line(stroke, scene::pattern_ink, width);
  }

  [[nodiscard]] double snapped_width(double points) const { return std::max(1.0, std::round(points * scale_)); }

  void add_line(const geom::Segment& page, const Color& color, double width) {
    Point a = pixel(page.from);
    Point b = pixel(page.to);
    double wide = width * scale_;
    if (a.x == b.x || a.y == b.y) {
      wide = snapped_width(width);
      // An odd width is sharp in the middle of a pixel, an even one between two.
      const double shift = static_cast<int>(wide) % 2 == 1 ? 0.5 : 0.0;
      const auto snap = [shift](double v) { return std::round(v - shift) + shift; };
      if (a.x == b.x) a.x = b.x = snap(a.x);
      if (a.y == b.y) a.y = b.y = snap(a.y);
    }
    if (a == b) return;
    const geom::Vector side = (0.5 * std::max(wide, 1.0)) * geom::left_of(geom::normalised(b - a));
    add_triangle({a + side, a + -side, b + -side}, {color, color, color});
    add_triangle({a + side, b + -side, b + side}, {color, color, color});
  }

  void add_box(const geom::Box& box, const Color& from, const Color& to, scene::GradientMark::Direction direction) {
    const bool up = direction == scene::GradientMark::Direction::Up;
    const Point a = box.low;
    const Point b{box.high.x, box.low.y};
    const Point c = box.high;
    const Point d{box.low.x, box.high.y};
    add_triangle({a, b, c}, {from, up ? from : to, to});
    add_triangle({a, c, d}, {from, to, up ? to : from});
  }

  void add_triangle(const std::array<Point, 3>& corners, const std::array<Color, 3>& colors) {
    cells_->InsertNextCell(3);
    for (int k = 0; k < 3; ++k) {
      cells_->InsertCellPoint(points_->InsertNextPoint(corners[k].x, corners[k].y, 0.0));
      const unsigned char rgba[4] = {colors[k].red, colors[k].green, colors[k].blue, colors[k].alpha};
      colors_->InsertNextTypedTuple(rgba);
    }
  }

  double height_;
  double scale_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

/// Marks lie in one plane, each over those before it: while they are drawn nothing asks how near they are.
void draw_in_order(vtkRenderer& renderer) {
  constexpr unsigned gl_lequal = 0x0203;
  constexpr unsigned gl_always = 0x0207;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback([](vtkObject* caller, unsigned long event, void*, void*) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(vtkRenderer::SafeDownCast(caller)->GetRenderWindow());
    if (window != nullptr) window->GetState()->vtkglDepthFunc(event == vtkCommand::StartEvent ? gl_always : gl_lequal);
  });
  renderer.AddObserver(vtkCommand::StartEvent, command);
  renderer.AddObserver(vtkCommand::EndEvent, command);
}

}  // namespace

scene::TextMeasure vtk_text_measure(double pixels_per_point) {
  // While a view moves, nearly all texts are those of the frame before.
  const auto widths = std::make_shared<std::map<std::pair<int, std::string>, double>>();
  return [pixels_per_point, widths](std::string_view text, const scene::Font& font) {
    constexpr std::size_t most = 10000;
    const int pixels = pixel_size(font, pixels_per_point);
    // Of DejaVu Sans; VTK measures only the ink of the letters at hand.
    scene::TextSize size{0.0, 0.928 * pixels / pixels_per_point, 0.236 * pixels / pixels_per_point};
    if (widths->size() > most) widths->clear();
    const int kind = font.weight == scene::Weight::Bold ? -pixels : pixels;
    const auto [known, fresh] = widths->try_emplace({kind, std::string(text)}, 0.0);
    if (fresh) known->second = ink_width(scene::readable(text), font, pixels_per_point);
    size.width = known->second;
    return size;
  };
}

VtkMarks::VtkMarks(vtkRenderer& renderer) : renderer_(renderer), shapes_(vtkSmartPointer<vtkPolyData>::New()) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes_);
  mapper->ScalarVisibilityOn();
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  renderer_.AddActor2D(actor);
  draw_in_order(renderer_);
}

void VtkMarks::show(const std::vector<scene::Mark>& marks, int height, double pixels_per_point) {
  Shapes shapes(height, pixels_per_point);
  for (auto& [key, texts] : texts_) texts.used = 0;
  for (const scene::Mark& mark : marks) {
    std::visit(shapes, mark);
    if (const auto* text = std::get_if<scene::TextMark>(&mark)) show_text(*text, height, pixels_per_point);
  }
  shapes.move_to(*shapes_);
  // What this layout does not need goes; while panning most labels stay.
  for (auto entry = texts_.begin(); entry != texts_.end();) {
    Texts& texts = entry->second;
    for (std::size_t i = texts.used; i < texts.actors.size(); ++i) renderer_.RemoveActor2D(texts.actors[i]);
    texts.actors.resize(texts.used);
    entry = texts.actors.empty() ? texts_.erase(entry) : std::next(entry);
  }
}

void VtkMarks::show_text(const scene::TextMark& mark, int height, double pixels_per_point) {
  if (mark.text.empty()) return;
  const bool up = mark.turn == scene::TextMark::Turn::Up;
  const bool bold = mark.font.weight == scene::Weight::Bold;
  const Color& c = mark.color;
  const std::string key = fmt::format("{} {} {} {},{},{} {}", pixel_size(mark.font, pixels_per_point), bold, up, c.red,
                                      c.green, c.blue, mark.text);
  Texts& texts = texts_[key];
  if (texts.used == texts.actors.size()) {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(mark.text.c_str());
    actor->SetTextScaleModeToNone();
    vtkTextProperty& property = *actor->GetTextProperty();
    set_font(property, mark.font, pixels_per_point);
    property.SetColor(c.red / 255.0, c.green / 255.0, c.blue / 255.0);
    property.SetJustificationToCentered();
    property.SetVerticalJustificationToCentered();
    property.SetOrientation(up ? 90.0 : 0.0);
    property.SetLineOffset(0.0);
    renderer_.AddActor2D(actor);
    texts.actors.push_back(actor);
  }
  vtkTextActor& actor = *texts.actors[texts.used++];
  actor.SetDisplayPosition(static_cast<int>(std::lround(mark.at.x * pixels_per_point)),
                           static_cast<int>(std::lround(height - mark.at.y * pixels_per_point)));
}

}  // namespace dobra::render
