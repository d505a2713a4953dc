#include "recon/core/section_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "shared/base/text.h"
#include "shared/geom/contour.h"
#include "shared/scene/unit_colors.h"

namespace recon::core {

namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color grid_color{126, 147, 168, 255};
constexpr scene::Color rung_color{176, 190, 203, 255};
constexpr scene::Color fault_color{150, 20, 30, 255};
constexpr scene::Color surface_color{92, 70, 30, 255};
/// More rungs than this would be a grey area: then every k-th is shown.
constexpr std::size_t most_rungs = 160;
/// The room for plots on a sheet, points: which arrangement of two gives the larger scale.
constexpr double sheet_width = 760.0;
constexpr double sheet_height = 240.0;
constexpr double clearly = 1.4;
/// With more horizons than this the legend has only the units, each by the name of the horizon above it.
constexpr std::size_t most_horizons_in_legend = 12;
/// More lines or markers of one kind than this share an entry of the legend.
constexpr std::size_t most_of_a_kind = 3;
/// Alpha of what stands over a backdrop.
constexpr std::uint8_t translucent = 110;
/// More horizons than this are drawn with thin lines.
constexpr std::size_t most_thick_horizons = 20;
/// From this length on, m, axes are in kilometres.
constexpr double long_section = 10000.0;

/// Of a line that is no bed; one that is eroded has the colour of its horizon.
scene::Style style_of(const section::SectionLine& line, const section::Palette& palette) {
  scene::Style style;
  style.line = ink;
  style.line_width = 0.9;
  style.dash = scene::Dash::Dashed;
  if (line.kind == section::LineKind::Fault || line.kind == section::LineKind::Topography) {
    style.line = line.kind == section::LineKind::Fault ? fault_color : surface_color;
    style.line_width = 1.8;
    style.dash = scene::Dash::Solid;
  } else if (line.kind == section::LineKind::Datum) {
    style.dash = scene::Dash::Dotted;
  } else if (line.kind == section::LineKind::Eroded) {
    style.line = palette.of(line.name).line;
    style.line_width = 1.2;
  }
  return style;
}

/// What many lines of a kind are called together in the legend.
std::string kind_title(section::LineKind kind) {
  switch (kind) {
    case section::LineKind::Fault:
      return translated("Faults");
    case section::LineKind::Pin:
      return translated("Pin lines");
    case section::LineKind::Datum:
      return translated("Datums");
    case section::LineKind::Eroded:
      return translated("Eroded");
    case section::LineKind::Topography:
      return translated("Topography");
    case section::LineKind::Loose:
      break;
  }
  return translated("Lines");
}

/// The name of a fault over its upper end.
scene::Layer fault_name(const section::SectionLine& line) {
  const std::vector<geom::Point>& points = line.line.points;
  const geom::Point top = points.front().y > points.back().y ? points.front() : points.back();
  scene::Style style;
  style.line = fault_color;
  style.text_size = 8.0;
  return {"fault_name_" + std::to_string(line.id.index()),         line.name, style,
          scene::Labels{{{top, line.name, scene::Anchor::Above}}}, true,      scene::InLegend::No};
}

/// Faults, pin and loose lines, markers.
void add_items(scene::Panel& panel, const section::Section& section, const section::Palette& palette) {
  std::map<section::LineKind, std::size_t> count;
  for (const section::SectionLine& line : section.lines) ++count[line.kind];
  bool eroded_told = false;
  for (const section::SectionLine& line : section.lines) {
    const bool eroded = line.kind == section::LineKind::Eroded;
    const bool many = count[line.kind] > most_of_a_kind;
    scene::Layer layer = lines_layer("line_" + std::to_string(line.id.index()),
                                     eroded ? fmt::format("{} ({})", line.name, translated("eroded")) : line.name,
                                     style_of(line, palette), {line.line});
    std::get<scene::Lines>(layer.content).ids = {static_cast<std::uint32_t>(line.id.index())};
    if (many) layer.legend = kind_title(line.kind);
    // Each has the colour of its horizon: the first stands for all.
    if (many && eroded && std::exchange(eroded_told, true)) layer.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(layer));
    if (line.kind == section::LineKind::Fault) panel.layers.push_back(fault_name(line));
  }
  for (const section::Marker& marker : section.markers) {
    scene::Style style;
    style.line = ink;
    scene::Layer layer{"marker_" + std::to_string(marker.id.index()),
                       marker.name,
                       style,
                       scene::Markers{marker.points, {}},
                       true,
                       scene::InLegend::Yes};
    if (section.markers.size() > most_of_a_kind) layer.legend = translated("Markers");
    panel.layers.push_back(std::move(layer));
  }
}

void add_horizons(scene::Panel& panel, const section::Section& section, const section::Palette& palette) {
  const auto wholes = whole_horizons(section);
  const auto is_unit = [](const scene::Layer& layer) { return layer.key.starts_with("unit_"); };
  const bool units = std::any_of(panel.layers.begin(), panel.layers.end(), is_unit);
  const bool listed = !units || wholes.size() <= most_horizons_in_legend;
  for (const std::vector<const section::Horizon*>& pieces : wholes) {
    const section::Horizon& first = *pieces.front();
    scene::Style style;
    style.line = palette.of(whole_name(first)).line;
    style.line_width = wholes.size() <= most_thick_horizons ? 1.6 : 0.8;
    scene::Lines lines;
    for (const section::Horizon* piece : pieces) {
      lines.lines.push_back(piece->line);
      lines.ids.push_back(static_cast<std::uint32_t>(piece->id.index()));
    }
    panel.layers.push_back({"horizon_" + std::to_string(first.id.index()), whole_name(first), style, std::move(lines),
                            true, listed ? scene::InLegend::Yes : scene::InLegend::No});
  }
}

/// The colour as that of words on white: as dark as a contrast of 4.5 asks for.
scene::Color of_words(scene::Color color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const auto contrast = [&] {  // of WCAG 2
    return 1.05 / (0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue) + 0.05);
  };
  while (contrast() < 4.5) {
    for (std::uint8_t* channel : {&color.red, &color.green, &color.blue})
      *channel = static_cast<std::uint8_t>(*channel * 31 / 32);
  }
  return color;
}

/// The side on which nothing of the line itself is in the way: an overturned bed comes to its end from the right.
scene::Anchor side_of_name(const geom::Polyline& line) {
  constexpr double stretch = 0.1;  // of its length, before the end
  double all = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) all += geom::distance(line.points[i - 1], line.points[i]);
  double along = 0.0;
  geom::Vector from{};  // from the end to where the stretch begins
  for (std::size_t i = line.points.size() - 1; i > 0 && along < stretch * all; --i) {
    const geom::Vector side = line.points[i - 1] - line.points[i];
    const double length = geom::length(side);
    if (!(length > 0.0)) continue;
    const double part = std::min(1.0, (stretch * all - along) / length);
    from = from + part * side;
    along += part * length;
  }
  return from.x > std::abs(from.y) ? scene::Anchor::Left : scene::Anchor::Right;
}

/// Names at the right ends; the layout makes room for them. The highest choose first, the others stand below.
void add_names(scene::Panel& panel, const section::Section& section, const section::Palette& palette) {
  struct Name {
    const section::Horizon* first;
    geom::Point at;
    scene::Anchor side;
  };
  std::vector<Name> names;
  for (const std::vector<const section::Horizon*>& pieces : whole_horizons(section)) {
    const section::Horizon* last =
        *std::max_element(pieces.begin(), pieces.end(), [](const section::Horizon* a, const section::Horizon* b) {
          return a->line.points.back().x < b->line.points.back().x;
        });
    names.push_back({pieces.front(), last->line.points.back(), side_of_name(last->line)});
  }
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.at.y < b.at.y; });
  for (const Name& name : names) {
    scene::Style style;
    style.line = of_words(palette.of(whole_name(*name.first)).line);
    style.text_size = 8.0;
    const std::string& text = whole_name(*name.first);
    panel.layers.push_back({"name_" + std::to_string(name.first->id.index()), text, style,
                            scene::Labels{{{name.at, text, name.side}}}, true, scene::InLegend::No});
  }
}

/// Beside each other, or above each other where that gives a clearly larger scale on a sheet.
scene::Arrangement arrangement_of(const std::vector<scene::Panel>& panels) {
  geom::Vector row;
  geom::Vector column;
  for (const scene::Panel& panel : panels) {
    const geom::Box box = scene::extent(panel);
    row = {row.x + box.width(), std::max(row.y, box.height())};
    column = {std::max(column.x, box.width()), column.y + box.height()};
  }
  const auto scale = [](geom::Vector size) { return std::min(sheet_width / size.x, sheet_height / size.y); };
  return scale(column) > clearly * scale(row) ? scene::Arrangement::Column : scene::Arrangement::Row;
}

void add_layers(std::vector<scene::Layer> more, std::vector<scene::Layer>& layers) {
  layers.insert(layers.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

scene::Layer lines_layer(std::string key, std::string title, scene::Style style, std::vector<geom::Polyline> lines) {
  return {std::move(key), std::move(title), style, scene::Lines{std::move(lines), {}}, true, scene::InLegend::Yes};
}

scene::Layer region_layer(std::string key, std::string title, const scene::UnitStyle& unit, geom::Polyline contour) {
  scene::Style style;
  style.line_width = 0.0;
  style.fill = unit.fill;
  style.pattern = unit.pattern;
  return {std::move(key), std::move(title),    style, scene::Regions{{{{std::move(contour)}}}, {}},
          true,           scene::InLegend::Yes};
}

std::vector<scene::Layer> unit_layers(const section::Section& section, const section::Palette& palette,
                                      const std::vector<balance::LedgerUnit>& units) {
  const bool many = whole_horizons(section).size() > most_horizons_in_legend;
  std::vector<scene::Layer> layers;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const balance::LedgerUnit& unit = units[i];
    const std::string key = "unit_" + std::to_string(i);
    if (unit.unit) {
      layers.push_back(region_layer(key, unit.name, palette.of(*unit.unit), section.units[unit.unit->index()].contour));
      layers.back().legend = palette.whole_of(*unit.unit);
      continue;
    }
    const section::Horizon& upper = section.horizons[*unit.upper];
    const section::Horizon& lower = section.horizons[*unit.lower];
    layers.push_back(
        region_layer(key, unit.name, palette.of(whole_name(upper)), contour_between(upper.line, lower.line)));
    layers.back().legend = many ? whole_name(upper) : fmt::format("{} - {}", whole_name(upper), whole_name(lower));
  }
  return layers;
}

std::vector<scene::Layer> over_backdrops(const section::Section& section, std::vector<scene::Layer> fills) {
  std::vector<scene::Layer> layers;
  for (std::size_t i = 0; i < section.backdrops.size(); ++i) {
    const section::Backdrop& backdrop = section.backdrops[i];
    layers.push_back({"backdrop_" + std::to_string(i), backdrop.name, {}, backdrop.image, true, scene::InLegend::No});
  }
  for (scene::Layer& layer : fills) {
    if (layer.style.fill && !section.backdrops.empty()) layer.style.fill->alpha = translucent;
    layers.push_back(std::move(layer));
  }
  return layers;
}

std::vector<scene::Layer> filled_units(const section::Section& section, const section::Palette& palette) {
  return over_backdrops(section,
                        unit_layers(section, palette, balance::ledger_units(section, {}, section::LayerSide::Below)));
}

std::vector<scene::Layer> grid_layers(const unfold::Grid& grid, const std::string& key) {
  std::vector<geom::Polyline> rungs;
  const std::size_t stride = 1 + grid.rungs.size() / most_rungs;
  for (std::size_t i = 0; i < grid.rungs.size(); i += stride) rungs.push_back(grid.rungs[i]);
  scene::Style thin;
  thin.line = rung_color;
  thin.line_width = 0.35;
  std::vector<geom::Polyline> curves;
  for (const unfold::GridCurve& curve : grid.curves)
    curves.insert(curves.end(), curve.pieces.begin(), curve.pieces.end());
  scene::Style style;
  style.line = grid_color;
  style.line_width = 0.6;
  return {lines_layer(key + "_rungs", translated("Rungs"), thin, std::move(rungs)),
          lines_layer(key, translated("Offset curves"), style, std::move(curves))};
}

geom::Polyline normal_at_pin(const maps::Columns& columns, maps::ColumnPoint pin, double deepest) {
  const double above = 0.04 * columns.base_line().box().diagonal();
  const auto at_depth = [&](double depth) {
    pin.depth = depth;
    return columns.point(pin);
  };
  return {{at_depth(-above), at_depth(std::max(deepest, above))}, false};
}

std::vector<scene::Layer> pin_layers(const geom::Polyline& line) {
  const geom::Point top = line.points.front();
  const geom::Point bottom = line.points.back();
  scene::Style style;
  style.line = ink;
  style.line_width = 1.0;
  style.dash = scene::Dash::Dashed;
  scene::Style text;
  text.line = ink;
  text.text_size = 8.0;
  const scene::Anchor anchor = top.y >= bottom.y ? scene::Anchor::Above : scene::Anchor::Below;
  return {lines_layer("pin", translated("Pin line"), style, {line}),
          {"pin_name", translated("Pin"), text, scene::Labels{{{top, translated("pin"), anchor}}}, true,
           scene::InLegend::No}};
}

scene::Panel empty_panel(const std::string& key, const std::string& title, const section::Section& section) {
  scene::Panel made;
  made.key = key;
  made.title = title;
  made.axes = {translated("x [m]"), translated("z [m]")};
  if (box_of(section).width() >= long_section) made.axes = {translated("x [km]"), translated("z [km]")};
  if (box_of(section).width() >= long_section) made.axes.unit = 1000.0;
  made.left_end = section.left_end;
  made.right_end = section.right_end;
  return made;
}

scene::Panel section_panel(scene::Panel panel, const section::Section& section, const section::Palette& palette,
                           PanelParts parts) {
  panel.layers = std::move(parts.under);
  add_layers(std::move(parts.grid), panel.layers);
  add_items(panel, section, palette);
  add_horizons(panel, section, palette);
  add_layers(std::move(parts.pin), panel.layers);
  add_names(panel, section, palette);
  return panel;
}

scene::Panel current_panel(const model::Model& model, const section::Palette& palette, PanelParts parts) {
  std::string title = translated("Deformed section");
  if (!model.earlier.empty()) {
    title = fmt::format(
        "{} {}",
        model.earlier.back()->moved ? translated("Section after move") : translated("Section after restoration"),
        model.earlier.size());
  }
  return section_panel(empty_panel("deformed", title, model.section), model.section, palette, std::move(parts));
}

void show(std::vector<scene::Panel> panels, const section::Section& section, scene::Picture& picture) {
  for (std::size_t i = 1; i < panels.size(); ++i) {
    for (scene::Layer& layer : panels[i].layers) {
      const bool known = std::any_of(panels[0].layers.begin(), panels[0].layers.end(), [&](const auto& other) {
        return scene::legend_name(other) == scene::legend_name(layer);
      });
      if (known) layer.in_legend = scene::InLegend::No;
    }
  }
  picture.paper = scene::Paper::A4Landscape;
  picture.arrangement = arrangement_of(panels);
  picture.panels = std::move(panels);
  if (section.colors) scene::paint(picture, *section.colors);
}

void draw_section(const model::Model& model, scene::Picture& picture) {
  if (model.source) return;
  const section::Palette palette(model.section);
  PanelParts parts;
  parts.under = filled_units(model.section, palette);
  show({current_panel(model, palette, std::move(parts))}, model.section, picture);
}

}  // namespace recon::core
