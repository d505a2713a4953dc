#include "shared/render/cairo_pattern.h"

#include <cmath>
#include <numbers>

namespace dobra::render {
namespace {

using scene::Pattern;

constexpr double cell = 7.0;  ///< Points from sign to sign; rows stand `row` apart, every other one shifted by half.
constexpr double row = 4.0;

/// Draws one sign at each place of a staggered lattice over the box.
template <class Sign>
void at_lattice(cairo_t* context, double x0, double y0, double x1, double y1, const Sign& sign) {
  const auto first = static_cast<long>(std::floor(y0 / row)) - 1;
  for (long j = first; static_cast<double>(j) * row <= y1 + row; ++j) {
    const double shift = j % 2 == 0 ? 0.0 : 0.5 * cell;
    for (double x = std::floor(x0 / cell) * cell - cell + shift; x <= x1 + cell; x += cell)
      sign(context, x, static_cast<double>(j) * row);
  }
}

/// Parallel lines of a slope (1 or -1) over the box.
void add_slanted(cairo_t* context, double x0, double y0, double x1, double y1, double slope) {
  const double height = y1 - y0;
  for (double x = std::floor((x0 - height) / row) * row; x <= x1 + height; x += row) {
    cairo_move_to(context, x, slope > 0.0 ? y1 : y0);
    cairo_line_to(context, x + height, slope > 0.0 ? y0 : y1);
  }
}

void add_brick(cairo_t* context, double x, double y) {
  cairo_move_to(context, x, y);
  cairo_line_to(context, x + cell, y);
  cairo_move_to(context, x, y);
  cairo_line_to(context, x, y + row);
}

void add_dash(cairo_t* context, double x, double y) {
  cairo_move_to(context, x - 2.0, y);
  cairo_line_to(context, x + 2.0, y);
}

void add_cross(cairo_t* context, double x, double y) {
  cairo_move_to(context, x - 1.2, y);
  cairo_line_to(context, x + 1.2, y);
  cairo_move_to(context, x, y - 1.2);
  cairo_line_to(context, x, y + 1.2);
}

void add_vee(cairo_t* context, double x, double y) {
  cairo_move_to(context, x - 1.2, y - 1.2);
  cairo_line_to(context, x, y + 1.2);
  cairo_line_to(context, x + 1.2, y - 1.2);
}

void add_circle(cairo_t* context, double x, double y) {
  cairo_new_sub_path(context);
  cairo_arc(context, x, y, 1.2, 0.0, 2.0 * std::numbers::pi);
}

/// A dot is a stroke without length and with round ends.
void add_dot(cairo_t* context, double x, double y) {
  cairo_move_to(context, x, y);
  cairo_line_to(context, x, y);
}

void add_signs(cairo_t* context, Pattern pattern, double x0, double y0, double x1, double y1) {
  switch (pattern) {
    case Pattern::None:
      return;
    case Pattern::Dots:
      return at_lattice(context, x0, y0, x1, y1, add_dot);
    case Pattern::Bricks:
      return at_lattice(context, x0, y0, x1, y1, add_brick);
    case Pattern::Dashes:
      return at_lattice(context, x0, y0, x1, y1, add_dash);
    case Pattern::Circles:
      return at_lattice(context, x0, y0, x1, y1, add_circle);
    case Pattern::Crosses:
      return at_lattice(context, x0, y0, x1, y1, add_cross);
    case Pattern::Vees:
      return at_lattice(context, x0, y0, x1, y1, add_vee);
    case Pattern::Hatch:
      return add_slanted(context, x0, y0, x1, y1, 1.0);
    case Pattern::BackHatch:
      return add_slanted(context, x0, y0, x1, y1, -1.0);
    case Pattern::CrossHatch:
      add_slanted(context, x0, y0, x1, y1, 1.0);
      return add_slanted(context, x0, y0, x1, y1, -1.0);
  }
}

}  // namespace

void fill_with_pattern(cairo_t* context, Pattern pattern) {
  if (pattern == Pattern::None) return;
  cairo_path_t* path = cairo_copy_path(context);
  cairo_save(context);
  cairo_clip(context);
  // The clip within the plot: what is far outside is not drawn.
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
  cairo_clip_extents(context, &x0, &y0, &x1, &y1);
  add_signs(context, pattern, x0, y0, x1, y1);
  cairo_set_source_rgba(context, 0.1, 0.1, 0.12, 0.55);
  cairo_set_line_width(context, pattern == Pattern::Dots ? 0.9 : 0.4);
  cairo_set_line_cap(context, pattern == Pattern::Dots ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(context, nullptr, 0, 0.0);
  cairo_stroke(context);
  cairo_restore(context);
  cairo_append_path(context, path);
  cairo_path_destroy(path);
}

}  // namespace dobra::render
