#include "shared/scene/furniture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "shared/base/text.h"
#include "shared/scene/decimal_mark.h"

namespace dobra::scene {
namespace {

constexpr double swatch_gap = 6.0;
constexpr double swatch_height = 10.0;

/// How tightly a legend is set.
struct Print {
  Font font;
  double swatch = 24.0;  ///< Width.
  double row_gap = 3.0;
  double column_gap = 18.0;
};

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
         s.dash == t.dash && s.fill == t.fill && s.pattern == t.pattern && s.marker_size == t.marker_size &&
         a.scale.map == b.scale.map;
}

/// What stands for a layer in the legend; nothing for labels and for layers without content.
std::optional<Entry> entry_of(const Layer& layer) {
  if (!layer.visible || layer.in_legend == InLegend::No || legend_name(layer).empty() || is_empty(layer)) {
    return std::nullopt;
  }
  Entry entry{legend_name(layer), Swatch::Line, layer.style, {}};
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

/// The swatch in a box of that size, to the right of `left`.
void add_swatch(const Entry& entry, geom::Point left, const PageSize& size, std::vector<Mark>& marks) {
  const Style& style = entry.style;
  const double half = 0.5 * size.height;
  const geom::Box box{{left.x, left.y - half}, {left.x + size.width, left.y + half}};
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
      marks.push_back(BoxMark{box, style.fill, style.line, width, style.pattern});
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

/// The entries of a legend in columns of equal width, read downwards.
class LegendTable {
 public:
  LegendTable(const std::vector<Entry>& entries, const PageSize& room, const Print& print, const TextMeasure& measure)
      : entries_(entries), print_(print), lead_(print.swatch + swatch_gap), line_(measure("A", print.font).height()) {
    double widest = 0.0;
    std::size_t most_lines = 1;
    for (const Entry& entry : entries) {
      Font smaller = print.font;
      lines_.push_back(wrapped(entry.title, std::max(room.width - lead_, 40.0), smaller, measure));
      fonts_.push_back(smaller);
      for (const std::string& line : lines_.back()) widest = std::max(widest, measure(line, smaller).width);
      most_lines = std::max(most_lines, lines_.back().size());
    }
    column_ = lead_ + widest + print.column_gap;
    row_ = std::max(line_ + 1.0, line_ * static_cast<double>(most_lines)) + print.row_gap;
    const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor((room.width + print.column_gap) / column_)));
    rows_ = (entries.size() + columns - 1) / columns;
    if ((static_cast<double>(rows_) * row_ - print.row_gap) > room.height)
      rows_ = static_cast<std::size_t>(std::max(1.0, std::floor((room.height + print.row_gap) / row_)));
    shown_ = std::min(entries.size(), rows_ * columns);
    if (shown_ < entries.size()) --shown_;  // the last place says how many more there are
  }

  [[nodiscard]] bool holds_all() const { return shown_ == entries_.size(); }

  [[nodiscard]] Furniture furniture(const TextMeasure& measure) const {
    Furniture made;
    const std::size_t places = shown_ + (holds_all() ? 0 : 1);
    for (std::size_t i = 0; i < places; ++i) {
      const geom::Point left{static_cast<double>(i / rows_) * column_,
                             static_cast<double>(i % rows_) * row_ + 0.5 * (row_ - print_.row_gap)};
      const PageSize swatch{print_.swatch, std::min(swatch_height, row_ - print_.row_gap)};
      if (i < shown_) add_swatch(entries_[i], left, swatch, made.marks);
      const std::vector<std::string> more{
          fmt::format(fmt::runtime(base::translated("... {} more")), entries_.size() - shown_)};
      const std::vector<std::string>& lines = i < shown_ ? lines_[i] : more;
      double y = left.y - 0.5 * line_ * static_cast<double>(lines.size() - 1);
      for (const std::string& line : lines) {
        TextMark mark =
            text_mark(line, {left.x + (i < shown_ ? lead_ : 0.0), y}, i < shown_ ? fonts_[i] : print_.font, measure);
        mark.at.x += 0.5 * mark.size.width;
        made.marks.push_back(std::move(mark));
        y += line_;
      }
    }
    made.width = static_cast<double>((places + rows_ - 1) / rows_) * column_ - print_.column_gap;
    made.height = static_cast<double>(std::min(rows_, places)) * row_ - print_.row_gap;
    return made;
  }

 private:
  std::span<const Entry> entries_;
  Print print_;
  double lead_;
  double line_;
  std::vector<std::vector<std::string>> lines_;
  std::vector<Font> fonts_;
  double column_ = 0.0;
  double row_ = 0.0;
  std::size_t rows_ = 1;
  std::size_t shown_ = 0;
};

std::string number_of(double value) {
  const std::string text = with_decimal_mark(fmt::format("{:.6g}", value));
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

/// A name has this much room round it, and moves at most so many of its heights.
constexpr double name_border = 3.0;
constexpr double name_reach = 3.5;

NamePlace name_place(const Label& label, geom::Point at, const TextSize& size) {
  return {at, label.anchor, size.width + 2.0 * name_border, size.height() + 2.0};
}

/// Moves a text that sticks out of `plot` inwards; false if it has no room in it at all.
bool keep_inside(TextMark& mark, const geom::Box& plot) {
  const geom::Box box = box_of(Mark{mark});
  if (box.width() > plot.width() || box.height() > plot.height()) return false;
  mark.at.x += std::max(0.0, plot.low.x - box.low.x) - std::max(0.0, box.high.x - plot.high.x);
  mark.at.y += std::max(0.0, plot.low.y - box.low.y) - std::max(0.0, box.high.y - plot.high.y);
  return true;
}

class LabelPlacer {
 public:
  LabelPlacer(const PanelLayout& place, const TextMeasure& measure, std::vector<Mark>& marks)
      : place_(place), inner_(place.plot.grown(-2.0)), measure_(measure), marks_(marks) {}

  /// Places a label that has room; names beside ends wait for each other.
  void add(const Label& label, const Style& style) {
    const geom::Point at = place_.transform.to_page(label.at);
    const std::string text = text_of(label);
    if (label.anchor == Anchor::Callout || !place_.plot.contains(at) || text.empty()) return;
    TextMark mark = text_mark(text, at, {style.text_size, Weight::Regular}, measure_);
    mark.color = style.line;
    if (label.anchor == Anchor::Left || label.anchor == Anchor::Right) {
      names_.push_back(name_place(label, at, mark.size));
      waiting_.push_back(std::move(mark));
      return;
    }
    mark.at = at + offset_of(label.anchor, mark.size, 3.0);
    if (keep_inside(mark, inner_)) put(std::move(mark));
  }

  /// Of the labels placed so far.
  [[nodiscard]] const std::vector<geom::Box>& taken() const { return taken_; }

  void place_names() {
    double line = 0.0;
    for (NamePlace& name : names_) {
      line = std::max(line, name.height);
      // Where it would be cut off it stands over its end.
      const double off = std::max(0.0, name.end.x + name.width - inner_.high.x);
      if (name.side == Anchor::Right) name.end.x -= off;
      if (name.side == Anchor::Left) name.end.x += std::max(0.0, inner_.low.x - name.end.x + name.width);
    }
    const auto boxes = places_of_names(names_, name_reach * line, inner_.low.y, inner_.high.y);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (!boxes[i]) continue;
      TextMark& mark = waiting_[i];
      const geom::Point end = mark.at;
      mark.at = boxes[i]->centre();
      if (keep_inside(mark, inner_)) put(std::move(mark), end);
    }
    names_.clear();
    waiting_.clear();
  }

 private:
  void put(TextMark mark, std::optional<geom::Point> end = std::nullopt) {
    const geom::Box box = box_of(Mark{mark}).grown(1.0);
    const auto overlaps = [&](const geom::Box& other) { return other.overlaps(box); };
    if (std::any_of(taken_.begin(), taken_.end(), overlaps)) return;
    taken_.push_back(box);
    if (end && std::abs(mark.at.y - end->y) > 0.5 * box.height()) {
      const geom::Point to{end->x < box.low.x ? box.low.x : std::min(box.high.x, end->x), mark.at.y};
      marks_.push_back(LineMark{*end, to, mark.color, 0.5, Dash::Solid});
    }
    // Light behind the text keeps it readable over lines, in every drawer alike.
    marks_.push_back(BoxMark{box, Color{255, 255, 255, 190}, {}, 0.0});
    marks_.push_back(std::move(mark));
  }

  const PanelLayout& place_;
  geom::Box inner_;
  const TextMeasure& measure_;
  std::vector<Mark>& marks_;
  std::vector<geom::Box> taken_;
  std::vector<NamePlace> names_;
  std::vector<TextMark> waiting_;
};

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

Furniture legend(const Picture& picture, const PageSize& room, const Font& font, const TextMeasure& measure,
                 SmallPrint small_print) {
  const std::vector<Entry> entries = entries_of(picture);
  if (entries.empty()) return {};
  // Small print before anything is left out.
  const Print small{{std::min(font.size, 7.0), font.weight}};
  const Print smallest{{std::min(font.size, 6.0), font.weight}, 14.0, 0.5, 12.0};
  LegendTable table(entries, room, {font}, measure);
  for (const Print& print : {small, smallest}) {
    if (small_print == SmallPrint::Yes && !table.holds_all()) table = LegendTable(entries, room, print, measure);
  }
  return table.furniture(measure);
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

Furniture scale_bar(double points_per_unit, const std::string& unit, const std::string& ratio, const Font& font,
                    const TextMeasure& measure) {
  Furniture made;
  const double units = nice_below(100.0 / points_per_unit);
  const double length = units * points_per_unit;
  const std::string after = ratio.empty() ? "" : "   " + ratio;
  TextMark text = text_mark(number_of(units) + (unit.empty() ? "" : " " + unit) + after, {0.0, 6.0}, font, measure);
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
  LabelPlacer placer(place, measure, marks);
  // Topmost layers choose first, names beside ends before all others.
  for (const bool beside : {true, false}) {
    for (std::size_t i = panel.layers.size(); i-- > 0;) {
      const auto* content = std::get_if<Labels>(&panel.layers[i].content);
      if (!panel.layers[i].visible || content == nullptr) continue;
      for (const Label& label : content->labels) {
        if ((label.anchor == Anchor::Left || label.anchor == Anchor::Right) == beside)
          placer.add(label, panel.layers[i].style);
      }
    }
    placer.place_names();
  }
  add_callouts(panel, place, measure, placer.taken(), marks);
}

std::vector<std::optional<geom::Box>> places_of_names(const Panel& panel, const Transform& transform, double widest,
                                                      double low, double high, const TextMeasure& measure) {
  std::vector<NamePlace> names;
  double line = 0.0;
  for (auto layer = panel.layers.rbegin(); layer != panel.layers.rend(); ++layer) {
    const auto* content = std::get_if<Labels>(&layer->content);
    if (!layer->visible || content == nullptr) continue;
    for (const Label& label : content->labels) {
      if (label.anchor != Anchor::Left && label.anchor != Anchor::Right) continue;
      const TextSize size = measure(label.text, {layer->style.text_size, Weight::Regular});
      if (label.text.empty() || size.width > widest) continue;  // wider than what it names: it has to stand over that
      names.push_back(name_place(label, transform.to_page(label.at), size));
      line = std::max(line, size.height());
    }
  }
  return places_of_names(names, name_reach * line, low, high);
}

void add_end_letters(const Panel& panel, const geom::Box& plot, const Font& font, const TextMeasure& measure,
                     std::vector<Mark>& marks) {
  for (const Anchor side : {Anchor::Left, Anchor::Right}) {
    const std::string& text = side == Anchor::Left ? panel.left_end : panel.right_end;
    if (text.empty()) continue;
    TextMark mark = text_mark(text, {}, font, measure);
    const double half = 0.5 * mark.size.width;
    mark.at = {side == Anchor::Left ? plot.low.x + half : plot.high.x - half,
               plot.low.y - 5.0 - 0.5 * mark.size.height()};
    marks.push_back(std::move(mark));
  }
}

void add_grid(const PanelLayout& place, const std::vector<Tick>& x_ticks, const std::vector<Tick>& y_ticks,
              std::vector<Mark>& marks) {
  const geom::Box& plot = place.plot;
  for (const Tick& tick : x_ticks) {
    const double x = place.transform.to_page({tick.value, 0.0}).x;
    marks.push_back(LineMark{{x, plot.low.y}, {x, plot.high.y}, grid_color, 0.75, Dash::Solid});
  }
  for (const Tick& tick : y_ticks) {
    const double y = place.transform.to_page({0.0, tick.value}).y;
    marks.push_back(LineMark{{plot.low.x, y}, {plot.high.x, y}, grid_color, 0.75, Dash::Solid});
  }
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
