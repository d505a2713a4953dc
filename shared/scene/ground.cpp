#include "shared/scene/ground.h"

#include <algorithm>
#include <cmath>

namespace dobra::scene {

namespace {

constexpr double cover = 0.9;  ///< Of the light, or the dark, behind words.
constexpr double faint = 1.6;  ///< Contrast to white paper below which a grey line is meant to stand back.

double luminance(const Color& color) {
  const auto linear = [](std::uint8_t part) {
    const double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

/// `part` of `b` over `a`; the opacity is that of `a`.
Color mixed(const Color& a, const Color& b, double part) {
  const auto mix = [part](std::uint8_t x, std::uint8_t y) { return byte((1.0 - part) * x + part * y); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), a.alpha};
}

/// As light as it was dark; hue and spread of its parts stay.
Color inverted(const Color& color) {
  const int sum = std::max({color.red, color.green, color.blue}) + std::min({color.red, color.green, color.blue});
  const int shift = 255 - sum;
  return {byte(color.red + shift), byte(color.green + shift), byte(color.blue + shift), color.alpha};
}

bool is_grey(const Color& color) {
  return std::max({color.red, color.green, color.blue}) - std::min({color.red, color.green, color.blue}) < 24;
}

Color seen_on(const Color& color, const Color& ground) {
  if (contrast(color, ground) >= readable_contrast) return color;
  Color made = inverted(color);
  for (int step = 0; step < 20 && contrast(made, ground) < readable_contrast; ++step)
    made = mixed(made, Color{255, 255, 255}, 0.1);
  return made;
}

}  // namespace

bool is_dark(const Ground& ground) { return luminance(ground.paper) < 0.18; }

double contrast(const Color& a, const Color& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

Color line_on(const Color& color, const Ground& ground) {
  if (!is_dark(ground)) return color;
  if (is_grey(color) && contrast(color, {255, 255, 255}) < faint) return mixed(ground.paper, color, 0.18);
  return seen_on(color, ground.paper);
}

Color words_on(const Color& color, const Ground& ground) {
  return is_dark(ground) ? seen_on(color, mixed(ground.paper, {255, 255, 255}, 1.0 - cover)) : color;
}

namespace {

/// A fill that hardly shows on paper hardly shows on the dark.
Color fill_on(const Color& color, const Ground& ground) {
  if (!is_dark(ground) || !is_grey(color) || contrast(color, {255, 255, 255}) >= faint) return color;
  const Color made = mixed(ground.paper, color, 0.12);
  return {made.red, made.green, made.blue, color.alpha};
}

}  // namespace

Style style_on(const Layer& layer, const Ground& ground) {
  Style style = layer.style;
  if (!is_dark(ground)) return style;
  const auto* mesh = std::get_if<Mesh>(&layer.content);
  const bool filled = style.fill.has_value() && !std::holds_alternative<Lines>(layer.content);
  if (std::holds_alternative<Regions>(layer.content) && style.fill && fill_on(*style.fill, ground) != *style.fill) {
    style.fill = fill_on(*style.fill, ground);
    style.line = line_on(style.line, ground);
    return style;
  }
  // The outline of a fill is seen on the fill.
  if (filled || (mesh != nullptr && mesh->values_at != ValuesAt::None)) return style;
  style.line =
      std::holds_alternative<Labels>(layer.content) ? words_on(style.line, ground) : line_on(style.line, ground);
  return style;
}

Mark on_ground(Mark mark, const Ground& ground) {
  if (!is_dark(ground)) return mark;
  if (auto* line = std::get_if<LineMark>(&mark)) line->color = line_on(line->color, ground);
  if (auto* disc = std::get_if<DiscMark>(&mark)) disc->fill = line_on(disc->fill, ground);
  if (auto* text = std::get_if<TextMark>(&mark)) text->color = words_on(text->color, ground);
  if (auto* box = std::get_if<BoxMark>(&mark)) {
    const bool behind_words =
        box->fill && box->fill->alpha < 255 && *box->fill == Color{255, 255, 255, box->fill->alpha};
    if (behind_words) {
      box->fill = ground.paper;
      box->fill->alpha = byte(255.0 * cover);
    } else if (box->fill) {
      box->fill = fill_on(*box->fill, ground);
    }
    if (behind_words || !box->fill) box->line = line_on(box->line, ground);
  }
  return mark;
}

}  // namespace dobra::scene
