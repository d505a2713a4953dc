#include "shared/scene/marks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dobra::scene {
namespace {

std::size_t letters(std::string_view text) {
  // Every byte that does not continue a UTF-8 sequence begins a letter.
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

struct BoxOf {
  geom::Box operator()(const LineMark& mark) const {
    geom::Box box;
    box.add(mark.from);
    box.add(mark.to);
    return box;
  }
  geom::Box operator()(const BoxMark& mark) const { return mark.box; }
  geom::Box operator()(const DiscMark& mark) const {
    return geom::Box{mark.centre, mark.centre}.grown(0.5 * mark.diameter);
  }
  geom::Box operator()(const TriangleMark& mark) const { return geom::box_of(mark.corners); }
  geom::Box operator()(const GradientMark& mark) const { return mark.box; }
  geom::Box operator()(const TextMark& mark) const {
    geom::Vector half{0.5 * mark.size.width, 0.5 * mark.size.height()};
    if (mark.turn == TextMark::Turn::Up) half = {half.y, half.x};
    return {mark.at + -half, mark.at + half};
  }
};

struct Move {
  geom::Vector by;
  void operator()(LineMark& mark) const {
    mark.from = mark.from + by;
    mark.to = mark.to + by;
  }
  void operator()(BoxMark& mark) const { mark.box = {mark.box.low + by, mark.box.high + by}; }
  void operator()(DiscMark& mark) const { mark.centre = mark.centre + by; }
  void operator()(TriangleMark& mark) const {
    for (geom::Point& corner : mark.corners) corner = corner + by;
  }
  void operator()(GradientMark& mark) const { mark.box = {mark.box.low + by, mark.box.high + by}; }
  void operator()(TextMark& mark) const { mark.at = mark.at + by; }
};

}  // namespace

std::string readable(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80U                    ? 1
                               : lead >= 0xC2U && lead < 0xE0U ? 2
                               : lead >= 0xE0U && lead < 0xF0U ? 3
                               : lead >= 0xF0U && lead < 0xF5U ? 4
                                                               : 0;
    bool good = length > 0 && i + length <= text.size() && lead >= 0x20U && lead != 0x7FU;
    for (std::size_t k = 1; good && k < length; ++k) good = (static_cast<unsigned char>(text[i + k]) & 0xC0U) == 0x80U;
    // Overlong forms, surrogates and numbers beyond U+10FFFF.
    const auto second = length > 2 && good ? static_cast<unsigned char>(text[i + 1]) : 0x90U;
    if ((lead == 0xE0U && second < 0xA0U) || (lead == 0xEDU && second >= 0xA0U && length == 3) ||
        (lead == 0xF0U && second < 0x90U) || (lead == 0xF4U && second >= 0x90U && length == 4)) {
      good = false;
    }
    safe += good ? std::string(text.substr(i, length)) : "\uFFFD";
    i += good ? length : 1;
  }
  return safe;
}

TextMeasure approximate_text_measure() {
  return [](std::string_view text, const Font& font) {
    const double letter = font.weight == Weight::Bold ? 0.68 : 0.6;
    return TextSize{letter * font.size * static_cast<double>(letters(text)), 0.93 * font.size, 0.24 * font.size};
  };
}

geom::Box box_of(const Mark& mark) { return std::visit(BoxOf{}, mark); }

Mark moved(Mark mark, geom::Vector by) {
  std::visit(Move{by}, mark);
  return mark;
}

std::vector<double> dash_lengths(Dash dash, double line_width) {
  const double unit = std::max(line_width, 0.75);
  switch (dash) {
    case Dash::Solid:
      return {};
    case Dash::Dashed:
      return {5.0 * unit, 3.0 * unit};
    case Dash::Dotted:
      return {1.2 * unit, 2.0 * unit};
  }
  return {};
}

bool part_inside(const geom::Segment& segment, const geom::Box& box, double& from, double& to) {
  const geom::Point a = segment.from;
  const geom::Vector d = segment.vector();
  from = 0.0;
  to = 1.0;
  const std::pair<double, double> sides[] = {
      {-d.x, a.x - box.low.x}, {d.x, box.high.x - a.x}, {-d.y, a.y - box.low.y}, {d.y, box.high.y - a.y}};
  for (const auto& [p, q] : sides) {
    if (p == 0.0 && q < 0.0) return false;
    if (p < 0.0) from = std::max(from, q / p);
    if (p > 0.0) to = std::min(to, q / p);
  }
  return from < to;
}

std::vector<geom::Segment> strokes_of(const geom::Polyline& line, const std::vector<double>& pattern,
                                      const geom::Box& window) {
  const double stroke = pattern.front();
  double period = 0.0;
  for (const double length : pattern) period += length;
  std::vector<geom::Segment> strokes;
  double travelled = 0.0;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    const double length = segment.length();
    double from = 0.0;
    double to = 1.0;
    if (length > 0.0 && part_inside(segment, window, from, to)) {
      const double last = travelled + to * length;
      for (double k = std::floor((travelled + from * length) / period); k * period < last; k += 1.0) {
        const double begin = std::max(k * period - travelled, from * length);
        const double end = std::min(k * period + stroke - travelled, to * length);
        if (begin >= end) continue;
        strokes.push_back({geom::interpolate(segment.from, segment.to, begin / length),
                           geom::interpolate(segment.from, segment.to, end / length)});
      }
    }
    travelled += length;
  }
  return strokes;
}

std::vector<std::string> wrapped(const std::string& given, double width, Font& font, const TextMeasure& measure) {
  const std::string text = readable(given);
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, space - from);
    from = space + 1;
    if (word.empty()) continue;
    if (!lines.empty() && measure(lines.back() + " " + word, font).width <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  double widest = 0.0;
  for (const std::string& line : lines) widest = std::max(widest, measure(line, font).width);
  if (widest > width) font.size *= width / widest * 0.98;
  return lines;
}

}  // namespace dobra::scene
