// Colour bars: where their ticks stand, and what they say of values that the colours do not reach.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/scene/color_map.h"
#include "shared/scene/decimal_mark.h"
#include "shared/scene/furniture.h"

namespace dobra::scene {
namespace {

constexpr double bar_gap = 18.0;
constexpr double bar_width = 13.0;
constexpr double arrow_height = 10.0;
constexpr double widest_title = 110.0;

/// A text at the right of the bar.
struct Said {
  double y = 0.0;
  std::string text;
};

class Bar {
 public:
  Bar(const Scale& scale, double top, double height, double half_line)
      : scale_(scale), box_{{0.0, top}, {bar_width, top + height}}, half_line_(half_line) {}

  [[nodiscard]] double y_of(double value) const {
    const double fraction = scale_.high != scale_.low ? (value - scale_.low) / (scale_.high - scale_.low) : 0.5;
    return box_.high.y - fraction * box_.height();
  }

  /// What the ends say: the least and the greatest value, or what lies beyond the colours.
  [[nodiscard]] std::vector<Said> ends() const {
    std::vector<Said> said;
    if (passes_high(scale_)) {
      said.push_back({box_.low.y - 0.5 * arrow_height,
                      fmt::format("> {}, {} {}", short_number(number(scale_.high)), base::translated("max"),
                                  short_number(number(*scale_.greatest)))});
    } else if (scale_.greatest) {
      said.push_back({y_of(*scale_.greatest),
                      fmt::format("{} {}", base::translated("max"), short_number(number(*scale_.greatest)))});
    }
    if (passes_low(scale_)) {
      said.push_back({box_.high.y + 0.5 * arrow_height,
                      fmt::format("< {}, {} {}", short_number(number(scale_.low)), base::translated("min"),
                                  short_number(number(*scale_.least)))});
    } else if (scale_.least && (said.empty() || y_of(*scale_.least) - said.front().y > 2.0 * half_line_)) {
      said.push_back(
          {y_of(*scale_.least), fmt::format("{} {}", base::translated("min"), short_number(number(*scale_.least)))});
    }
    return said;
  }

  [[nodiscard]] std::vector<Tick> ticks() const {
    if (scale_.low == scale_.high) return {{scale_.low, short_number(number(scale_.low))}};
    const double low = std::min(scale_.low, scale_.high);
    const double high = std::max(scale_.low, scale_.high);
    const auto room = [&](const std::string&) { return 2.0 * half_line_; };
    const bool log10 = scale_.ticks == AxisScale::Log10;
    std::vector<Tick> ticks =
        (log10 ? logarithmic_ticks_that_fit : ticks_that_fit)(low, high, box_.height(), 4.0, 22.0, room);
    if (log10) return ticks;
    // Many zeros before or behind the digits are an exponent.
    const double most = std::max(std::abs(low), std::abs(high));
    if (most >= 1e5 || most < 1e-2) {
      for (Tick& tick : ticks) tick.label = short_number(tick.value);
    }
    return ticks;
  }

  [[nodiscard]] const geom::Box& box() const { return box_; }

 private:
  [[nodiscard]] double number(double value) const {
    return scale_.ticks == AxisScale::Log10 ? std::pow(10.0, value) : value;
  }

  const Scale& scale_;
  geom::Box box_;
  double half_line_;
};

/// The end of a bar beyond which there are values; `tip` above or below it.
void add_arrow(double base, double tip, const Color& fill, std::vector<Mark>& marks) {
  const geom::Point left{0.0, base}, right{bar_width, base}, end{0.5 * bar_width, tip};
  marks.push_back(TriangleMark{{left, right, end}, fill});
  marks.push_back(LineMark{left, end, frame_color, 0.75, Dash::Solid});
  marks.push_back(LineMark{end, right, frame_color, 0.75, Dash::Solid});
}

}  // namespace

bool passes_high(const Scale& scale) {
  return scale.greatest && scale.high > scale.low && *scale.greatest > scale.high;
}

bool passes_low(const Scale& scale) { return scale.least && scale.high > scale.low && *scale.least < scale.low; }

std::string short_number(double value) {
  std::string text = with_decimal_mark(fmt::format("{:.4g}", value));
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const std::size_t digits = std::min(text.find_first_not_of("+-0", e + 1), text.size());
    text = text.substr(0, e + 1) + (text[e + 1] == '-' ? "\u2212" : "") + text.substr(digits);
  }
  return text.front() == '-' ? "\u2212" + text.substr(1) : text;
}

Furniture color_bar(const Scale& scale, double height, const Font& font, const TextMeasure& measure,
                    double& title_height) {
  Furniture made = heading(scale.title, widest_title, font, measure);
  // The title stands flush left with the bar.
  for (Mark& mark : made.marks) {
    if (auto* text = std::get_if<TextMark>(&mark)) text->at.x = 0.5 * text->size.width;
  }
  const Font small{font.size - 1.0, Weight::Regular};
  const double half_line = 0.5 * measure("0", small).height();
  // A label at the upper end of the bar reaches half a line above it.
  title_height = made.height + std::max(passes_high(scale) ? arrow_height : 0.0, half_line) + 2.0;
  const Bar bar(scale, title_height, height, half_line);
  if (scale.low == scale.high)
    made.marks.push_back(BoxMark{bar.box(), color_at(scale.map, 0.5)});
  else
    made.marks.push_back(GradientMark{bar.box(), scale.map, GradientMark::Direction::Up});
  made.marks.push_back(BoxMark{bar.box(), std::nullopt, frame_color, 0.75});
  const geom::Box& box = bar.box();
  if (passes_high(scale)) add_arrow(box.low.y, box.low.y - arrow_height, color_at(scale.map, 1.0), made.marks);
  if (passes_low(scale)) add_arrow(box.high.y, box.high.y + arrow_height, color_at(scale.map, 0.0), made.marks);
  const auto write = [&](const Said& said) {
    TextMark label = text_mark(said.text, {bar_width + tick_length + tick_gap, said.y}, small, measure);
    label.at.x += 0.5 * label.size.width;
    made.width = std::max(made.width, label.at.x + 0.5 * label.size.width);
    made.marks.push_back(std::move(label));
  };
  const std::vector<Said> ends = bar.ends();
  const auto mark = [&](double y) {
    made.marks.push_back(LineMark{{bar_width, y}, {bar_width + tick_length, y}, frame_color, 0.75, Dash::Solid});
  };
  for (const Said& said : ends) {
    write(said);
    if (said.y >= box.low.y && said.y <= box.high.y) mark(said.y);
  }
  for (const Tick& tick : bar.ticks()) {
    const double y = bar.y_of(tick.value);
    const bool taken =
        std::any_of(ends.begin(), ends.end(), [&](const Said& said) { return std::abs(said.y - y) < 2.0 * half_line; });
    if (taken) continue;
    mark(y);
    write({y, tick.label});
  }
  made.height = box.high.y + std::max(passes_low(scale) ? arrow_height : 0.0, half_line);
  return made;
}

ColorBars color_bars(const std::vector<Scale>& scales, double height, const Font& font, const TextMeasure& measure) {
  std::vector<std::pair<Furniture, double>> bars;
  ColorBars made;
  for (const Scale& scale : scales) {
    double title_height = 0.0;
    Furniture bar = color_bar(scale, height, font, measure, title_height);
    made.title_height = std::max(made.title_height, title_height);
    bars.emplace_back(std::move(bar), title_height);
  }
  for (const auto& [bar, title_height] : bars) {
    const geom::Vector by{made.all.width + bar_gap, made.title_height - title_height};
    for (const Mark& mark : bar.marks) made.all.marks.push_back(moved(mark, by));
    made.all.width = by.x + bar.width;
    made.all.height = std::max(made.all.height, by.y + bar.height);
  }
  return made;
}

}  // namespace dobra::scene
