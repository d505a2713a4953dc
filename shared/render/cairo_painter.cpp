#include "shared/render/cairo_painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/scene/color_map.h"
#include "shared/scene/fill.h"
#include "shared/scene/pattern.h"

namespace dobra::render {
namespace {

using geom::Point;
using scene::Color;

/// cairo's own numbers end at 2^23 points; a deep zoom must not come near.
constexpr double far_off = 20000.0;
/// Points nearer than this to the last one are left out of a path: smaller than any device shows.
constexpr double too_near = 0.02;
/// Neighbouring areas of different colours are grown by this much, points, so that no background shines between them.
constexpr double seam = 0.3;

void set_color(cairo_t* context, const Color& color) {
  cairo_set_source_rgba(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0, color.alpha / 255.0);
}

void set_dash(cairo_t* context, scene::Dash dash, double width) {
  const std::vector<double> lengths = scene::dash_lengths(dash, width);
  cairo_set_dash(context, lengths.data(), static_cast<int>(lengths.size()), 0.0);
}

/// The part of a convex or other polygon on one side of a vertical (axis 0) or horizontal (axis 1) line;
/// Sutherland-Hodgman.
std::vector<Point> cut(const std::vector<Point>& polygon, int axis, double limit, double side) {
  const auto off = [&](Point p) { return side * ((axis == 0 ? p.x : p.y) - limit); };
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i];
    const Point b = polygon[(i + 1) % polygon.size()];
    if (off(a) >= 0.0) kept.push_back(a);
    if ((off(a) > 0.0) != (off(b) > 0.0) && off(a) != off(b)) {
      kept.push_back(geom::interpolate(a, b, off(a) / (off(a) - off(b))));
    }
  }
  return kept;
}

std::vector<Point> near_part(std::vector<Point> polygon) {
  for (const int axis : {0, 1}) {
    polygon = cut(polygon, axis, -far_off, 1.0);
    polygon = cut(polygon, axis, far_off, -1.0);
  }
  return polygon;
}

/// Draws the signs over the current path, which stays, under the context's fill rule.
void fill_with_pattern(cairo_t* context, scene::Pattern pattern) {
  if (pattern == scene::Pattern::None) return;
  cairo_path_t* path = cairo_copy_path(context);
  cairo_save(context);
  cairo_clip(context);
  // The clip within the plot: what is far outside is not drawn.
  geom::Box seen{{0.0, 0.0}, {0.0, 0.0}};
  cairo_clip_extents(context, &seen.low.x, &seen.low.y, &seen.high.x, &seen.high.y);
  for (const geom::Segment& stroke : scene::pattern_strokes(pattern, seen)) {
    cairo_move_to(context, stroke.from.x, stroke.from.y);
    cairo_line_to(context, stroke.to.x, stroke.to.y);
  }
  set_color(context, scene::pattern_ink);
  cairo_set_line_width(context, scene::pattern_width(pattern));
  cairo_set_dash(context, nullptr, 0, 0.0);
  cairo_stroke(context);
  cairo_restore(context);
  cairo_append_path(context, path);
  cairo_path_destroy(path);
}

class LayerPainter {
 public:
  LayerPainter(cairo_t* context, const scene::Style& style, const scene::PanelLayout& place)
      : context_(context), style_(style), place_(place) {}

  void operator()(const scene::Lines& content) const {
    if (style_.line_width <= 0.0) return;
    for (const geom::Polyline& line : content.lines) add_line(line.points, line.closed);
    stroke(style_.line_width);
  }

  void operator()(const scene::Markers& content) const {
    const double radius = 0.5 * style_.marker_size;
    set_color(context_, style_.line);
    for (const Point& world : content.points) {
      const Point p = place_.transform.to_page(world);
      if (!place_.plot.grown(radius).contains(p)) continue;
      cairo_new_sub_path(context_);
      cairo_arc(context_, p.x, p.y, radius, 0.0, 2.0 * std::numbers::pi);
      cairo_close_path(context_);
    }
    cairo_fill(context_);
  }

  void operator()(const scene::Regions& content) const {
    cairo_set_fill_rule(context_, CAIRO_FILL_RULE_EVEN_ODD);
    for (const scene::Region& region : content.regions) {
      if (!style_.fill) break;
      for (const geom::Polyline& contour : region.contours) add_loop(contour.points);
      set_color(context_, *style_.fill);
      cairo_fill_preserve(context_);
      fill_with_pattern(context_, style_.pattern);
      cairo_new_path(context_);
    }
    if (style_.line_width <= 0.0) return;
    for (const scene::Region& region : content.regions) {
      for (const geom::Polyline& contour : region.contours) add_line(contour.points, true);
    }
    stroke(style_.line_width);
  }

  void operator()(const scene::Mesh& content) const {
    fill_mesh(content);
    const double width = scene::edge_width(scene::mean_edge_length(content), style_, place_.transform.points_per_x);
    if (width <= 0.0) return;
    std::vector<Point> points;
    for (const std::vector<std::uint32_t>& chain : scene::edge_chains(content)) {
      points.clear();
      for (const std::uint32_t i : chain) points.push_back(content.points[i]);
      add_line(points, false);
    }
    stroke(width);
  }

  void operator()(const scene::Labels&) const {}  // the layout has placed them as marks

  void operator()(const scene::Image& content) const {
    if (!content.pixels || content.pixels->rgba.empty()) return;
    const scene::Pixels& pixels = *content.pixels;
    const auto width = static_cast<int>(pixels.width);
    const auto height = static_cast<int>(pixels.height);
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    if (cairo_surface_status(surface) == CAIRO_STATUS_SUCCESS) {
      copy_premultiplied(pixels, surface);
      const Point upper_left = place_.transform.to_page({content.box.low.x, content.box.high.y});
      const Point lower_right = place_.transform.to_page({content.box.high.x, content.box.low.y});
      cairo_save(context_);
      cairo_translate(context_, upper_left.x, upper_left.y);
      cairo_scale(context_, (lower_right.x - upper_left.x) / width, (lower_right.y - upper_left.y) / height);
      cairo_set_source_surface(context_, surface, 0.0, 0.0);
      cairo_pattern_set_extend(cairo_get_source(context_), CAIRO_EXTEND_PAD);
      cairo_rectangle(context_, 0.0, 0.0, width, height);
      cairo_clip(context_);
      cairo_paint_with_alpha(context_, content.opacity);
      cairo_restore(context_);
    }
    cairo_surface_destroy(surface);
  }

 private:
  /// cairo wants its colours times their opacity, in one number a pixel.
  static void copy_premultiplied(const scene::Pixels& pixels, cairo_surface_t* surface) {
    cairo_surface_flush(surface);
    unsigned char* const rows = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    for (std::size_t y = 0; y < pixels.height; ++y) {
      auto* row = reinterpret_cast<std::uint32_t*>(rows + y * stride);
      for (std::size_t x = 0; x < pixels.width; ++x) {
        const std::uint8_t* p = pixels.rgba.data() + 4 * (y * pixels.width + x);
        const std::uint32_t alpha = p[3];
        const auto part = [&](std::uint32_t channel) { return (channel * alpha + 127) / 255; };
        row[x] = alpha << 24U | part(p[0]) << 16U | part(p[1]) << 8U | part(p[2]);
      }
    }
    cairo_surface_mark_dirty(surface);
  }

  void fill_mesh(const scene::Mesh& content) const {
    const geom::Box window = place_.transform.to_world(place_.plot);
    const std::vector<scene::ColoredArea> areas = scene::areas_of(content, style_.fill, window);
    if (areas.empty()) return;
    // Translucent areas would show where their grown borders overlap: draw them opaque, then fade all together.
    const std::uint8_t alpha = areas.front().color.alpha;
    if (alpha != 255) cairo_push_group(context_);
    cairo_set_fill_rule(context_, CAIRO_FILL_RULE_WINDING);
    cairo_set_line_width(context_, areas.size() > 1 ? seam : 0.0);
    cairo_set_dash(context_, nullptr, 0, 0.0);
    for (const scene::ColoredArea& area : areas) {
      for (const std::vector<Point>& loop : area.loops) add_loop(loop);
      set_color(context_, {area.color.red, area.color.green, area.color.blue, 255});
      if (areas.size() > 1) {
        cairo_fill_preserve(context_);
        cairo_stroke(context_);
      } else {
        cairo_fill(context_);
      }
    }
    if (alpha == 255) return;
    cairo_pop_group_to_source(context_);
    cairo_paint_with_alpha(context_, alpha / 255.0);
  }

  void stroke(double width) const {
    set_color(context_, style_.line);
    cairo_set_line_width(context_, width);
    set_dash(context_, style_.dash, width);
    cairo_stroke(context_);
  }

  /// Adds a line to the path, without what is far outside the plot.
  void add_line(const std::vector<Point>& world, bool closed) const {
    if (world.size() < 2) return;
    const double reach = 2.0 * style_.line_width + 1.0;
    if (!place_.transform.to_world(place_.plot.grown(reach)).overlaps(geom::box_of(world))) return;
    bool all_near = true;
    for (const Point& p : world) all_near = all_near && near(place_.transform.to_page(p));
    Point last = place_.transform.to_page(world.front());
    if (all_near) cairo_move_to(context_, last.x, last.y);
    const std::size_t count = world.size() + (closed && !all_near ? 1 : 0);
    for (std::size_t i = 1; i < count; ++i) {
      const Point next = place_.transform.to_page(world[i % world.size()]);
      if (all_near) {
        if (i + 1 < count && geom::distance(last, next) < too_near) continue;
        cairo_line_to(context_, next.x, next.y);
      } else {
        double from = 0.0;
        double to = 1.0;
        if (scene::part_inside({last, next}, {{-far_off, -far_off}, {far_off, far_off}}, from, to)) {
          const Point a = geom::interpolate(last, next, from);
          const Point b = geom::interpolate(last, next, to);
          if (i == 1 || from > 0.0) cairo_move_to(context_, a.x, a.y);
          cairo_line_to(context_, b.x, b.y);
        }
      }
      last = next;
    }
    if (closed && all_near) cairo_close_path(context_);
  }

  void add_loop(const std::vector<Point>& world) const {
    if (world.size() < 3) return;
    std::vector<Point> page;
    bool all_near = true;
    for (const Point& p : world) {
      page.push_back(place_.transform.to_page(p));
      all_near = all_near && near(page.back());
    }
    if (!all_near) page = near_part(std::move(page));
    for (std::size_t i = 0; i < page.size(); ++i) {
      if (i == 0) {
        cairo_move_to(context_, page[i].x, page[i].y);
      } else {
        cairo_line_to(context_, page[i].x, page[i].y);
      }
    }
    if (!page.empty()) cairo_close_path(context_);
  }

  static bool near(Point p) { return std::abs(p.x) < far_off && std::abs(p.y) < far_off; }

  cairo_t* context_;
  const scene::Style& style_;
  const scene::PanelLayout& place_;
};

void add_box(cairo_t* context, const geom::Box& box) {
  cairo_rectangle(context, box.low.x, box.low.y, box.width(), box.height());
}

class MarkPainter {
 public:
  MarkPainter(cairo_t* context, TextAs text) : context_(context), text_(text) {}

  void operator()(const scene::LineMark& mark) const {
    if (mark.width <= 0.0) return;
    cairo_move_to(context_, mark.from.x, mark.from.y);
    cairo_line_to(context_, mark.to.x, mark.to.y);
    set_color(context_, mark.color);
    cairo_set_line_width(context_, mark.width);
    set_dash(context_, mark.dash, mark.width);
    cairo_stroke(context_);
  }

  void operator()(const scene::BoxMark& mark) const {
    if (mark.fill) {
      add_box(context_, mark.box);
      set_color(context_, *mark.fill);
      cairo_fill_preserve(context_);
      fill_with_pattern(context_, mark.pattern);
      cairo_new_path(context_);
    }
    if (mark.line_width <= 0.0) return;
    add_box(context_, mark.box);
    set_color(context_, mark.line);
    cairo_set_line_width(context_, mark.line_width);
    cairo_set_dash(context_, nullptr, 0, 0.0);
    cairo_stroke(context_);
  }

  void operator()(const scene::DiscMark& mark) const {
    cairo_new_sub_path(context_);
    cairo_arc(context_, mark.centre.x, mark.centre.y, 0.5 * mark.diameter, 0.0, 2.0 * std::numbers::pi);
    set_color(context_, mark.fill);
    cairo_fill(context_);
  }

  void operator()(const scene::TriangleMark& mark) const {
    for (const Point& corner : mark.corners) cairo_line_to(context_, corner.x, corner.y);
    cairo_close_path(context_);
    set_color(context_, mark.fill);
    if (mark.seam > 0.0) {
      cairo_set_line_width(context_, mark.seam);
      cairo_set_dash(context_, nullptr, 0, 0.0);
      cairo_fill_preserve(context_);
      cairo_stroke(context_);
      return;
    }
    cairo_fill(context_);
  }

  void operator()(const scene::GradientMark& mark) const {
    const bool up = mark.direction == scene::GradientMark::Direction::Up;
    cairo_pattern_t* pattern = up ? cairo_pattern_create_linear(0.0, mark.box.high.y, 0.0, mark.box.low.y)
                                  : cairo_pattern_create_linear(mark.box.low.x, 0.0, mark.box.high.x, 0.0);
    constexpr int stops = 32;
    for (int i = 0; i <= stops; ++i) {
      const double fraction = static_cast<double>(i) / stops;
      const Color color = scene::color_at(mark.map, fraction);
      cairo_pattern_add_color_stop_rgb(pattern, fraction, color.red / 255.0, color.green / 255.0, color.blue / 255.0);
    }
    cairo_set_source(context_, pattern);
    add_box(context_, mark.box);
    cairo_fill(context_);
    cairo_pattern_destroy(pattern);
  }

  void operator()(const scene::TextMark& mark) const {
    if (text_ == TextAs::NotDrawn) return;
    select_font(context_, mark.font);
    cairo_save(context_);
    cairo_translate(context_, mark.at.x, mark.at.y);
    if (mark.turn == scene::TextMark::Turn::Up) cairo_rotate(context_, -0.5 * std::numbers::pi);
    cairo_move_to(context_, -0.5 * mark.size.width, 0.5 * (mark.size.ascent - mark.size.descent));
    set_color(context_, mark.color);
    cairo_show_text(context_, mark.text.c_str());
    cairo_new_path(context_);
    cairo_restore(context_);
  }

 private:
  cairo_t* context_;
  TextAs text_;
};

}  // namespace

void select_font(cairo_t* context, const scene::Font& font) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
  const bool bold = font.weight == scene::Weight::Bold;
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, font.size);
}

void paint(cairo_t* context, const scene::Picture& picture, const scene::Layout& layout, TextAs text,
           const Color& paper) {
  cairo_set_source_rgb(context, paper.red / 255.0, paper.green / 255.0, paper.blue / 255.0);
  cairo_rectangle(context, 0.0, 0.0, layout.page.width, layout.page.height);
  cairo_fill(context);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  for (std::size_t i = 0; i < picture.panels.size(); ++i) {
    cairo_save(context);
    add_box(context, layout.panels[i].plot);
    cairo_clip(context);
    for (const scene::Layer& layer : picture.panels[i].layers) {
      if (layer.visible) std::visit(LayerPainter(context, layer.style, layout.panels[i]), layer.content);
    }
    cairo_restore(context);
  }
  for (const scene::Mark& mark : layout.marks) std::visit(MarkPainter(context, text), mark);
}

}  // namespace dobra::render
