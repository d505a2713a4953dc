#include "shared/scene/furniture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dobra::scene {
namespace {

constexpr double swatch_width = 24.0;
constexpr double swatch_gap = 6.0;
constexpr double column_gap = 18.0;

enum class Swatch { Line, Marker, Area, Mesh, Values };

struct Entry {
  std::string title;
  Swatch swatch = Swatch::Line;
  Style style;
  Scale scale;
};

bool same_scale(const Scale& a, const Scale& b) {
  return a.title == b.title && a.map == b.map && a.low == b.low && a.high == b.high && a.ticks == b.ticks &&
         a.least == b.least && a.greatest == b.greatest;
}

bool same_entry(const Entry& a, const Entry& b) {
  const Style& s = a.style;
  const Style& t = b.style;
  return a.title == b.title && a.swatch == b.swatch && s.line == t.line && s.line_width == t.line_width &&
         s.dash == t.dash && s.fill == t.fill && s.marker_size == t.marker_size && a.scale.map == b.scale.map;
}

/// What stands for a layer in the legend; nothing for labels and for layers without content.
std::optional<Entry> entry_of(const Layer& layer) {
  if (!layer.visible || layer.in_legend == InLegend::No || layer.title.empty() || extent(layer).empty()) {
    return std::nullopt;
  }
  Entry entry{layer.title, Swatch::Line, layer.style, {}};
  if (std::holds_alternative<Labels>(layer.content) || std::holds_alternative<Image>(layer.content))
    return std::nullopt;
  if (std::holds_alternative<Markers>(layer.content)) entry.swatch = Swatch::Marker;
  if (std::holds_alternative<Regions>(layer.content)) entry.swatch = Swatch::Area;
  if (const auto* mesh = std::get_if<Mesh>(&layer.content)) {
    entry.swatch = mesh->values_at == ValuesAt::None ? Swatch::Mesh : Swatch::Values;
    entry.scale = mesh->scale;
  }
  return entry;
}

std::vector<Entry> entries_of(const Picture& picture) {
  std::vector<Entry> entries;
  for (const Panel& panel : picture.panels) {
    for (const Layer& layer : panel.layers) {
      const std::optional<Entry> entry = entry_of(layer);
      if (!entry) continue;
      const bool known =
          std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return same_entry(e, *entry); });
      if (!known) entries.push_back(*entry);
    }
  }
  return entries;
}

/// The swatch in a box of swatch_width round the height `y`.
void add_swatch(const Entry& entry, geom::Point left, std::vector<Mark>& marks) {
  const Style& style = entry.style;
  const geom::Box box{{left.x, left.y - 5.0}, {left.x + swatch_width, left.y + 5.0}};
  const geom::Point middle = box.centre();
  const double width = std::min(style.line_width, 4.0);
  switch (entry.swatch) {
    case Swatch::Line:
      marks.push_back(LineMark{left, {box.high.x, left.y}, style.line, width, style.dash});
      return;
    case Swatch::Marker:
      marks.push_back(DiscMark{middle, std::min(style.marker_size, 9.0), style.line});
      return;
    case Swatch::Area:
      marks.push_back(BoxMark{box, style.fill, style.line, width});
      return;
    case Swatch::Values:
      marks.push_back(GradientMark{box, entry.scale.map, GradientMark::Direction::Right});
      marks.push_back(BoxMark{box, std::nullopt, style.line, std::min(width, 1.0)});
      return;
    case Swatch::Mesh:
      marks.push_back(BoxMark{box, style.fill, style.line, width});
      if (width <= 0.0) return;
      marks.push_back(LineMark{{middle.x, box.low.y}, {middle.x, box.high.y}, style.line, width, Dash::Solid});
      marks.push_back(LineMark{{box.low.x, box.high.y}, {middle.x, box.low.y}, style.line, width, Dash::Solid});
      marks.push_back(LineMark{{middle.x, box.high.y}, {box.high.x, box.low.y}, style.line, width, Dash::Solid});
      return;
  }
}

std::string number_of(double value) {
  const std::string text = fmt::format("{:.6g}", value);
  return text.front() == '-' ? "\u2212" + text.substr(1) : text;
}

geom::Vector offset_of(Anchor anchor, const TextSize& size, double gap) {
  switch (anchor) {
    case Anchor::Callout:
    case Anchor::Centre:
      return {0.0, 0.0};
    case Anchor::Left:
      return {-0.5 * size.width - gap, 0.0};
    case Anchor::Right:
      return {0.5 * size.width + gap, 0.0};
    case Anchor::Above:
      return {0.0, -0.5 * size.height() - gap};
    case Anchor::Below:
      return {0.0, 0.5 * size.height() + gap};
  }
  return {0.0, 0.0};
}

/// Moves a text that sticks out of `plot` inwards; false if it has no room in it at all.
bool keep_inside(TextMark& mark, const geom::Box& plot) {
  const geom::Box box = box_of(Mark{mark});
  if (box.width() > plot.width() || box.height() > plot.height()) return false;
  mark.at.x += std::max(0.0, plot.low.x - box.low.x) - std::max(0.0, box.high.x - plot.high.x);
  mark.at.y += std::max(0.0, plot.low.y - box.low.y) - std::max(0.0, box.high.y - plot.high.y);
  return true;
}

}  // namespace

TextMark text_mark(const std::string& text, geom::Point middle, const Font& font, const TextMeasure& measure,
                   TextMark::Turn turn) {
  std::string safe = readable(text);
  const TextSize size = measure(safe, font);
  return {middle, std::move(safe), font, ink, turn, size};
}

Furniture heading(const std::string& text, double width, Font font, const TextMeasure& measure) {
  Furniture made;
  if (text.empty()) return made;
  const std::vector<std::string> lines = wrapped(text, width, font, measure);
  for (const std::string& line : lines) made.width = std::max(made.width, measure(line, font).width);
  for (const std::string& line : lines) {
    TextMark mark = text_mark(line, {0.5 * made.width, 0.0}, font, measure);
    mark.at.y = made.height + 0.5 * mark.size.height();
    made.height += mark.size.height();
    made.marks.push_back(std::move(mark));
  }
  return made;
}

Furniture turned_heading(const std::string& text, double height, Font font, const TextMeasure& measure) {
  Furniture made;
  if (text.empty()) return made;
  const std::vector<std::string> lines = wrapped(text, height, font, measure);
  for (const std::string& line : lines) made.height = std::max(made.height, measure(line, font).width);
  for (const std::string& line : lines) {
    TextMark mark = text_mark(line, {0.0, 0.5 * made.height}, font, measure, TextMark::Turn::Up);
    mark.at.x = made.width + 0.5 * mark.size.height();
    made.width += mark.size.height();
    made.marks.push_back(std::move(mark));
  }
  return made;
}

Furniture legend(const Picture& picture, double width, const Font& font, const TextMeasure& measure) {
  struct Cell {
    std::vector<std::string> lines;
    Font font;
  };
  const std::vector<Entry> entries = entries_of(picture);
  Furniture made;
  if (entries.empty()) return made;
  const double lead = swatch_width + swatch_gap;
  std::vector<Cell> cells;
  double widest = 0.0;
  for (const Entry& entry : entries) {
    Cell cell{{}, font};
    cell.lines = wrapped(entry.title, std::max(width - lead, 40.0), cell.font, measure);
    for (const std::string& line : cell.lines) widest = std::max(widest, measure(line, cell.font).width);
    cells.push_back(std::move(cell));
  }
  const double column = lead + widest + column_gap;
  const auto most = static_cast<std::size_t>(std::max(1.0, std::floor((width + column_gap) / column)));
  const std::size_t rows = (entries.size() + most - 1) / most;
  const std::size_t columns = (entries.size() + rows - 1) / rows;
  made.width = static_cast<double>(columns) * column - column_gap;
  for (std::size_t first = 0; first < entries.size(); first += columns) {
    double row_height = 0.0;
    for (std::size_t i = first; i < std::min(first + columns, entries.size()); ++i) {
      const double x = static_cast<double>(i - first) * column;
      const double line_height = measure("A", cells[i].font).height();
      const double height = std::max(12.0, line_height * static_cast<double>(cells[i].lines.size()));
      add_swatch(entries[i], {x, made.height + 0.5 * height}, made.marks);
      double y = made.height + 0.5 * (height - line_height * static_cast<double>(cells[i].lines.size() - 1));
      for (const std::string& line : cells[i].lines) {
        TextMark mark = text_mark(line, {x + lead, y}, cells[i].font, measure);
        mark.at.x += 0.5 * mark.size.width;
        made.marks.push_back(std::move(mark));
        y += line_height;
      }
      row_height = std::max(row_height, height);
    }
    made.height += row_height + 3.0;
  }
  made.height -= 3.0;
  return made;
}

std::vector<Scale> scales_of(const Panel& panel) {
  std::vector<Scale> scales;
  for (const Layer& layer : panel.layers) {
    const auto* mesh = std::get_if<Mesh>(&layer.content);
    if (!layer.visible || mesh == nullptr || mesh->values_at == ValuesAt::None || mesh->triangles.empty()) continue;
    const bool known =
        std::any_of(scales.begin(), scales.end(), [&](const Scale& s) { return same_scale(s, mesh->scale); });
    if (!known) scales.push_back(mesh->scale);
  }
  return scales;
}

bool same_scales(const std::vector<Scale>& a, const std::vector<Scale>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_scale);
}

std::string text_of(const Label& label) {
  if (!label.value) return label.text;
  return label.text + (label.text.empty() ? "" : " ") + short_number(*label.value);
}

Furniture scale_bar(double points_per_world, const std::string& unit, const Font& font, const TextMeasure& measure) {
  Furniture made;
  const double world = nice_below(100.0 / points_per_world);
  const double length = world * points_per_world;
  TextMark text = text_mark(number_of(world) + (unit.empty() ? "" : " " + unit), {0.0, 6.0}, font, measure);
  text.at.x = length + swatch_gap + 0.5 * text.size.width;
  made.width = length + swatch_gap + text.size.width;
  made.height = std::max(12.0, text.size.height());
  const double y = 0.5 * made.height;
  text.at.y = y;
  made.marks.push_back(LineMark{{0.0, y}, {length, y}, ink, 1.5, Dash::Solid});
  made.marks.push_back(LineMark{{0.0, y - 3.5}, {0.0, y + 3.5}, ink, 1.0, Dash::Solid});
  made.marks.push_back(LineMark{{length, y - 3.5}, {length, y + 3.5}, ink, 1.0, Dash::Solid});
  made.marks.push_back(std::move(text));
  return made;
}

std::string unit_of(const std::string& axis_title) {
  const std::size_t open = axis_title.rfind('[');
  const std::size_t close = axis_title.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  return axis_title.substr(open + 1, close - open - 1);
}

void add_labels(const Panel& panel, const PanelLayout& place, const TextMeasure& measure, std::vector<Mark>& marks) {
  std::vector<geom::Box> taken;
  // Topmost layers choose first.
  for (std::size_t i = panel.layers.size(); i-- > 0;) {
    const Layer& layer = panel.layers[i];
    const auto* content = std::get_if<Labels>(&layer.content);
    if (!layer.visible || content == nullptr) continue;
    for (const Label& label : content->labels) {
      const geom::Point at = place.transform.to_page(label.at);
      const std::string text = text_of(label);
      if (label.anchor == Anchor::Callout || !place.plot.contains(at) || text.empty()) continue;
      TextMark mark = text_mark(text, at, {layer.style.text_size, Weight::Regular}, measure);
      mark.color = layer.style.line;
      mark.at = at + offset_of(label.anchor, mark.size, 3.0);
      if (!keep_inside(mark, place.plot.grown(-2.0))) continue;
      geom::Box box = box_of(Mark{mark}).grown(1.0);
      if (label.anchor == Anchor::Left || label.anchor == Anchor::Right) {
        const geom::Box place_of = below_others(box, taken);
        mark.at.y += place_of.low.y - box.low.y;
        box = place_of;
      }
      const auto overlaps = [&](const geom::Box& other) { return other.overlaps(box); };
      if (box.high.y > place.plot.high.y || std::any_of(taken.begin(), taken.end(), overlaps)) continue;
      taken.push_back(box);
      // Light behind the text keeps it readable over lines, in every drawer alike.
      marks.push_back(BoxMark{box, Color{255, 255, 255, 190}, {}, 0.0});
      marks.push_back(std::move(mark));
    }
  }
  add_callouts(panel, place, measure, taken, marks);
}

geom::Box below_others(geom::Box name, const std::vector<geom::Box>& taken) {
  constexpr int most_moves = 16;
  constexpr double gap = 0.01;
  for (int k = 0; k < most_moves; ++k) {
    double free_from = name.low.y;
    for (const geom::Box& other : taken) {
      if (other.overlaps(name)) free_from = std::max(free_from, other.high.y + gap);
    }
    if (free_from == name.low.y) break;
    name = {{name.low.x, free_from}, {name.high.x, free_from + name.height()}};
  }
  return name;
}

void add_axes(const PanelLayout& place, const std::vector<Tick>& x_ticks, const std::vector<Tick>& y_ticks,
              const Font& font, const TextMeasure& measure, std::vector<Mark>& marks) {
  const geom::Box& plot = place.plot;
  marks.push_back(BoxMark{plot, std::nullopt, frame_color, 0.75});
  for (const Tick& tick : x_ticks) {
    const double x = place.transform.to_page({tick.value, 0.0}).x;
    marks.push_back(LineMark{{x, plot.high.y}, {x, plot.high.y + tick_length}, frame_color, 0.75, Dash::Solid});
    TextMark label = text_mark(tick.label, {x, plot.high.y + tick_length + tick_gap}, font, measure);
    label.at.y += 0.5 * label.size.height();
    marks.push_back(std::move(label));
  }
  for (const Tick& tick : y_ticks) {
    const double y = place.transform.to_page({0.0, tick.value}).y;
    marks.push_back(LineMark{{plot.low.x - tick_length, y}, {plot.low.x, y}, frame_color, 0.75, Dash::Solid});
    TextMark label = text_mark(tick.label, {plot.low.x - tick_length - tick_gap, y}, font, measure);
    label.at.x -= 0.5 * label.size.width;
    marks.push_back(std::move(label));
  }
}

}  // namespace dobra::scene
