#include "recon/core/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "recon/core/section_faces.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"

namespace recon::core {

namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color grid_color{126, 147, 168, 255};
constexpr scene::Color rung_color{176, 190, 203, 255};
constexpr scene::Color fault_color{150, 20, 30, 255};
constexpr scene::Color pin_color{40, 40, 40, 255};
constexpr scene::Color surface_color{92, 70, 30, 255};
/// More rungs than this would be a grey area: then every k-th is shown.
constexpr std::size_t most_rungs = 160;
/// Sections longer than this many times their height stand one above the other, where they have the whole width of the
/// page.
constexpr double wide = 5.0;

scene::Layer lines_layer(std::string key, std::string title, scene::Style style, std::vector<geom::Polyline> lines) {
  return {std::move(key), std::move(title), style, scene::Lines{std::move(lines), {}}, true, scene::InLegend::Yes};
}

void add_grid(scene::Panel& panel, const Grid& grid, const std::string& key) {
  std::vector<geom::Polyline> rungs;
  const std::size_t stride = 1 + grid.rungs.size() / most_rungs;
  for (std::size_t i = 0; i < grid.rungs.size(); i += stride) rungs.push_back(grid.rungs[i]);
  scene::Style thin;
  thin.line = rung_color;
  thin.line_width = 0.35;
  panel.layers.push_back(lines_layer(key + "_rungs", translated("Rungs"), thin, std::move(rungs)));

  std::vector<geom::Polyline> curves;
  for (const GridCurve& curve : grid.curves) curves.insert(curves.end(), curve.pieces.begin(), curve.pieces.end());
  scene::Style style;
  style.line = grid_color;
  style.line_width = 0.6;
  panel.layers.push_back(lines_layer(key, translated("Offset curves"), style, std::move(curves)));
}

/// `color` with so much white that lines on it stay readable.
scene::Color tint(scene::Color color) {
  const auto paler = [](std::uint8_t channel) { return static_cast<std::uint8_t>(255 - (255 - channel) / 4); };
  return {paler(color.red), paler(color.green), paler(color.blue), 255};
}

scene::Layer region_layer(std::string key, std::string title, scene::Color fill, geom::Polyline contour) {
  scene::Style style;
  style.line_width = 0.0;
  style.fill = fill;
  return {std::move(key), std::move(title),    style, scene::Regions{{{{std::move(contour)}}}, {}},
          true,           scene::InLegend::Yes};
}

scene::Color unit_color(std::size_t number) { return tint(horizon_color(HorizonId(number))); }

/// Units filled: the polygons of the section, or what lies between neighbouring horizons.
void add_units(scene::Panel& panel, const Section& section, const std::vector<LedgerUnit>& units) {
  for (std::size_t i = 0; i < units.size(); ++i) {
    const LedgerUnit& unit = units[i];
    geom::Polyline contour =
        unit.unit ? section.units[unit.unit->index()].contour
                  : contour_between(section.horizons[*unit.upper].line, section.horizons[*unit.lower].line);
    const std::size_t color = unit.unit ? i : section.horizons[*unit.upper].id.index();
    panel.layers.push_back(region_layer("unit_" + std::to_string(i), unit.name, unit_color(color), std::move(contour)));
  }
}

/// Units that are measured by their faces: the rows of the ledger after those of `units`.
void add_face_units(scene::Panel& panel, const Section& section, const Ledger& ledger, std::size_t first,
                    std::vector<geom::Polyline> UnitRow::*faces) {
  for (std::size_t i = first; i < ledger.units.size(); ++i) {
    const UnitRow& row = ledger.units[i];
    scene::Color color{226, 226, 226, 255};  // no horizon over it
    for (const RockUnit& unit : section.faces->units) {
      if (unit.name == row.name && unit.top) color = unit_color(section.horizons[*unit.top].id.index());
    }
    scene::Layer layer = region_layer("unit_" + std::to_string(i), row.name, color, {});
    std::get<scene::Regions>(layer.content).regions = {scene::Region{row.*faces}};
    panel.layers.push_back(std::move(layer));
  }
}

/// So that a picture behind them is seen.
void make_translucent(scene::Panel& panel) {
  for (scene::Layer& layer : panel.layers) {
    if (layer.style.fill) layer.style.fill->alpha = 110;
  }
}

/// Pictures behind the section.
void add_backdrops(scene::Panel& panel, const Section& section) {
  for (std::size_t i = 0; i < section.backdrops.size(); ++i) {
    const Backdrop& backdrop = section.backdrops[i];
    panel.layers.push_back(
        {"backdrop_" + std::to_string(i), backdrop.name, {}, backdrop.image, true, scene::InLegend::No});
  }
}

/// Of a line that is no bed; one that is eroded has the colour of its horizon.
scene::Style style_of(const SectionLine& line, const Section& section) {
  scene::Style style;
  style.line = pin_color;
  style.line_width = 0.9;
  style.dash = scene::Dash::Dashed;
  if (line.kind == LineKind::Fault || line.kind == LineKind::Topography) {
    style.line = line.kind == LineKind::Fault ? fault_color : surface_color;
    style.line_width = 1.8;
    style.dash = scene::Dash::Solid;
  } else if (line.kind == LineKind::Datum) {
    style.dash = scene::Dash::Dotted;
  } else if (line.kind == LineKind::Eroded) {
    if (const Horizon* first = first_piece(section, line.name)) style.line = horizon_color(first->id);
    style.line_width = 1.2;
  }
  return style;
}

/// Faults, pin and loose lines, markers.
void add_items(scene::Panel& panel, const Section& section) {
  for (const SectionLine& line : section.lines) {
    const bool eroded = line.kind == LineKind::Eroded;
    scene::Layer layer = lines_layer("line_" + std::to_string(line.id.index()),
                                     eroded ? fmt::format("{} ({})", line.name, translated("eroded")) : line.name,
                                     style_of(line, section), {line.line});
    std::get<scene::Lines>(layer.content).ids = {static_cast<std::uint32_t>(line.id.index())};
    panel.layers.push_back(std::move(layer));
  }
  for (const Marker& marker : section.markers) {
    scene::Style style;
    style.line = pin_color;
    panel.layers.push_back({"marker_" + std::to_string(marker.id.index()), marker.name, style,
                            scene::Markers{marker.points, {}}, true, scene::InLegend::Yes});
  }
}

/// det F - 1 in percent; seen where the method does not keep areas.
void add_dilatation(scene::Panel& panel, const DilatationField& field, bool seen) {
  scene::Mesh mesh;
  mesh.points = field.points;
  mesh.triangles = field.triangles;
  mesh.values_at = scene::ValuesAt::Triangles;
  std::vector<double> sizes;
  for (const double value : field.values) {
    mesh.values.push_back(100.0 * value);
    sizes.push_back(std::abs(100.0 * value));
  }
  if (sizes.empty()) return;
  // A few cells near the medial axis change without bound; the scale is that of the rest.
  const auto nearly_all = sizes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), nearly_all, sizes.end());
  const double most = std::max(*nearly_all, 1e-6);
  mesh.scale = {translated("det F - 1 [%]"), scene::ColorMapName::CoolWarm, -most, most};
  scene::Style style;
  style.line_width = 0.0;
  panel.layers.push_back(
      {"dilatation", translated("Change of area"), style, std::move(mesh), seen, scene::InLegend::No});
}

/// What the restoration makes circles of.
void add_ellipses(scene::Panel& panel, const std::vector<Strain>& strains, double size) {
  std::vector<geom::Polyline> ellipses;
  for (const Strain& strain : strains) {
    geom::Polyline ellipse{{}, true};
    const double c = std::cos(strain.direction.radians());
    const double s = std::sin(strain.direction.radians());
    for (int i = 0; i < 48; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 48.0;
      const double along = size * strain.greatest * std::cos(angle);
      const double across = size * strain.least * std::sin(angle);
      ellipse.points.push_back(strain.at + geom::Vector{along * c - across * s, along * s + across * c});
    }
    ellipses.push_back(std::move(ellipse));
  }
  scene::Style style;
  style.line = {60, 60, 66, 255};
  style.line_width = 0.6;
  panel.layers.push_back(lines_layer("ellipses", translated("Strain ellipses"), style, std::move(ellipses)));
}

/// The units as they lie on each other, each with its mean restored thickness, beside the section to the same scale.
void add_column(scene::Panel& panel, const Section& section, const std::vector<LedgerUnit>& units,
                const std::vector<UnitRow>& rows) {
  const geom::Box box = scene::extent(panel);
  const double width = 0.035 * box.width();
  const double left = box.low.x - 0.015 * box.width() - width;  // names stand on the right
  double top = section.horizons.empty() ? box.high.y : box_of(section).high.y;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (!rows[i].thickness_after || !units[i].upper) continue;
    const double bottom = top - rows[i].thickness_after->mean;
    const std::size_t color = section.horizons[*units[i].upper].id.index();
    scene::Layer bed = region_layer("column_" + std::to_string(i), units[i].name, unit_color(color),
                                    {{{left, bottom}, {left + width, bottom}, {left + width, top}, {left, top}}, true});
    bed.style.line = pin_color;
    bed.style.line_width = 0.5;
    bed.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(bed));
    top = bottom;
  }
}

/// A change that rounds to nothing has no sign.
std::string percent_text(double value) {
  std::string text = fmt::format("{:+.2f}", value);
  return text == "-0.00" || text == "+0.00" ? "0.00" : text;
}

/// With as many decimals as give the largest number of its table five figures.
std::string fixed(double value, double largest) {
  const int decimals = largest > 0.0 ? std::clamp(4 - static_cast<int>(std::floor(std::log10(largest))), 0, 9) : 0;
  return fmt::format("{:.{}f}", value, decimals);
}

/// The ledger as tables, and what is to be said about it.
void add_ledger(scene::Picture& picture, const Model& model) {
  const Restoration& restoration = *model.restoration;
  scene::TextTable beds{translated("Beds"),
                        {translated("horizon"), translated("length before [m]"), translated("after [m]"),
                         translated("change [%]"), translated("shortening [m]"), translated("[%]")},
                        {}};
  std::vector<LineLength> rows = restoration.lengths;
  for (LineLength& total : totals_of(restoration.lengths)) {
    total.name += fmt::format(" ({})", translated("all pieces"));
    rows.push_back(std::move(total));
  }
  double longest = 0.0;
  for (const LineLength& row : rows) longest = std::max({longest, row.length_before, row.length_after});
  const auto metres = [&](double value) { return fixed(value, longest); };
  for (const LineLength& row : rows) {
    beds.rows.push_back({row.name, metres(row.length_before), metres(row.length_after),
                         percent_text(row.change_percent), metres(row.shortening),
                         percent_text(row.shortening_percent)});
  }
  scene::TextTable units{translated("Units"),
                         {translated("unit"), translated("area before [m\u00b2]"), translated("after [m\u00b2]"),
                          translated("change [%]"), translated("thickness before [m]"), translated("after [m]")},
                         {}};
  const auto mean = [&](const std::optional<Range>& range) { return range ? metres(range->mean) : std::string("-"); };
  double largest = 0.0;
  for (const UnitRow& row : restoration.ledger.units) largest = std::max({largest, row.area_before, row.area_after});
  const auto area = [&](double value) { return fixed(value, largest); };
  for (const UnitRow& row : restoration.ledger.units) {
    units.rows.push_back({row.name, area(row.area_before), area(row.area_after), percent_text(row.change_percent),
                          mean(row.thickness_before), mean(row.thickness_after)});
  }
  picture.tables = {std::move(beds)};
  if (!units.rows.empty()) picture.tables.push_back(std::move(units));
  std::string sentence = what_it_keeps(restoration.params.method);
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  picture.notes = {sentence + '.', fmt::format("{}{}. {}", translated("Verdict: "), restoration.remarks.back(),
                                               translated("Both states to the same scale, no vertical exaggeration."))};
}

/// Lines through the map, thinned to what a page can show.
std::vector<geom::Polyline> images_of(const std::vector<geom::Polyline>& lines, const SectionMap& map) {
  constexpr std::size_t most_points = 2000;
  return base::parallel_map<geom::Polyline>(lines.size(), [&](std::size_t i) {
    geom::Polyline thin;
    const std::vector<geom::Point>& points = lines[i].points;
    const std::size_t stride = 1 + points.size() / most_points;
    for (std::size_t k = 0; k < points.size(); k += stride) thin.points.push_back(points[k]);
    if (thin.points.size() < 2 || thin.points.back() != points.back()) thin.points.push_back(points.back());
    return map.forward(thin).after;
  });
}

/// Is the grid of the target line what the source grid becomes?
bool goes_to_target_grid(const Model& model) {
  return !model.restoration ||
         (model.restoration->params.method == RestoreMethod::Constant && model.restoration->params.percent == 100.0);
}

/// The target grid of the method: the grid of the target line where columns go to columns, else what becomes of the
/// source grid.
Grid restored_grid(const Model& model) {
  if (goes_to_target_grid(model)) return model.target->grid;
  Grid grid;
  for (const GridCurve& curve : model.source->grid.curves)
    grid.curves.push_back({curve.distance, images_of(curve.pieces, model.restoration->map)});
  grid.rungs = images_of(model.source->grid.rungs, model.restoration->map);
  return grid;
}

/// Horizons with their pieces, each list in the order of the section.
std::vector<std::vector<const Horizon*>> whole_horizons(const Section& section) {
  std::vector<std::vector<const Horizon*>> wholes;
  for (const Horizon& horizon : section.horizons) {
    const auto same = [&](const auto& whole) { return whole_name(*whole.front()) == whole_name(horizon); };
    const auto found = std::find_if(wholes.begin(), wholes.end(), same);
    if (found != wholes.end())
      found->push_back(&horizon);
    else
      wholes.push_back({&horizon});
  }
  return wholes;
}

void add_horizons(scene::Panel& panel, const Section& section) {
  for (const std::vector<const Horizon*>& pieces : whole_horizons(section)) {
    const Horizon& first = *pieces.front();
    scene::Style style;
    style.line = horizon_color(first.id);
    style.line_width = 1.6;
    scene::Lines lines;
    for (const Horizon* piece : pieces) {
      lines.lines.push_back(piece->line);
      lines.ids.push_back(static_cast<std::uint32_t>(piece->id.index()));
    }
    panel.layers.push_back({"horizon_" + std::to_string(first.id.index()), whole_name(first), style, std::move(lines),
                            true, scene::InLegend::Yes});
  }
}

/// Names at the right ends; the layout makes room for them. The highest choose first, the others stand below.
void add_names(scene::Panel& panel, const Section& section) {
  struct Name {
    const Horizon* first;
    geom::Point at;
  };
  std::vector<Name> names;
  for (const std::vector<const Horizon*>& pieces : whole_horizons(section)) {
    const Horizon* last = *std::max_element(pieces.begin(), pieces.end(), [](const Horizon* a, const Horizon* b) {
      return a->line.points.back().x < b->line.points.back().x;
    });
    names.push_back({pieces.front(), last->line.points.back()});
  }
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.at.y < b.at.y; });
  for (const Name& name : names) {
    scene::Style style;
    style.line = horizon_color(name.first->id);
    style.text_size = 8.0;
    const std::string& text = whole_name(*name.first);
    panel.layers.push_back({"name_" + std::to_string(name.first->id.index()), text, style,
                            scene::Labels{{{name.at, text, scene::Anchor::Right}}}, true, scene::InLegend::No});
  }
}

/// A line along the normal at the pin, from a little above the base down to the deepest curve.
geom::Polyline pin_line(const Columns& columns, ColumnPoint pin, double deepest) {
  const double above = 0.04 * columns.base_line().box().diagonal();
  const auto at_depth = [&](double depth) {
    pin.depth = depth;
    return columns.point(pin);
  };
  return {{at_depth(-above), at_depth(std::max(deepest, above))}, false};
}

void add_pin(scene::Panel& panel, const geom::Polyline& line) {
  const geom::Point top = line.points.front();
  const geom::Point bottom = line.points.back();
  scene::Style style;
  style.line = pin_color;
  style.line_width = 1.0;
  style.dash = scene::Dash::Dashed;
  panel.layers.push_back(lines_layer("pin", translated("Pin line"), style, {line}));
  scene::Style text;
  text.line = pin_color;
  text.text_size = 8.0;
  const scene::Anchor anchor = top.y >= bottom.y ? scene::Anchor::Above : scene::Anchor::Below;
  panel.layers.push_back({"pin_name", translated("Pin"), text, scene::Labels{{{top, translated("pin"), anchor}}}, true,
                          scene::InLegend::No});
}

scene::Panel panel(std::string key, std::string title) {
  scene::Panel made;
  made.key = std::move(key);
  made.title = std::move(title);
  made.axes = {translated("x [m]"), translated("z [m]")};
  return made;
}

}  // namespace

scene::Color horizon_color(HorizonId id) {
  static constexpr std::array<scene::Color, 8> palette{{{176, 58, 46, 255},
                                                        {205, 133, 32, 255},
                                                        {66, 122, 72, 255},
                                                        {28, 122, 135, 255},
                                                        {106, 76, 147, 255},
                                                        {128, 84, 50, 255},
                                                        {190, 70, 122, 255},
                                                        {46, 76, 150, 255}}};
  return palette[id.index() % palette.size()];
}

scene::Picture picture_of(const Model& model) {
  scene::Picture picture;
  scene::Panel before = panel("deformed", translated("Deformed section"));
  add_backdrops(before, model.section);
  std::vector<LedgerUnit> units;
  if (model.restoration) {
    const Restoration& restoration = *model.restoration;
    units = ledger_units(model.section, restoration.order);
    const bool keeps_area = restoration.params.method == RestoreMethod::Flexural ||
                            restoration.params.method == RestoreMethod::Shear ||
                            restoration.params.method == RestoreMethod::Variable;
    add_units(before, model.section, units);
    add_face_units(before, model.section, restoration.ledger, units.size(), &UnitRow::faces_before);
    add_dilatation(before, restoration.ledger.field, !keeps_area);
    add_ellipses(before, restoration.ledger.strains, 0.008 * box_of(model.section).diagonal());
  } else {
    add_units(before, model.section, ledger_units(model.section, {}));
  }
  if (!model.section.backdrops.empty()) make_translucent(before);
  if (model.source) add_grid(before, model.source->grid, "source_grid");
  add_items(before, model.section);
  add_horizons(before, model.section);
  const geom::Box box = scene::extent(before);
  if (box.width() > wide * box.height()) picture.arrangement = scene::Arrangement::Column;
  if (model.target) {
    const Target& target = *model.target;
    const ColumnPoint pin = target.map.locate(target.source_pin).at;
    const double deepest = model.source->options.distances.back();
    const geom::Polyline source_pin = pin_line(target.map.source(), pin, deepest);
    add_pin(before, source_pin);
    add_names(before, model.section);
    scene::Panel after =
        panel("restored", model.restoration ? translated("Restored section") : translated("Target grid"));
    if (model.restoration) {
      add_units(after, model.restoration->section, units);
      add_face_units(after, model.section, model.restoration->ledger, units.size(), &UnitRow::faces_after);
    }
    add_grid(after, restored_grid(model), "target_grid");
    if (model.restoration) {
      add_items(after, model.restoration->section);
      add_horizons(after, model.restoration->section);
    } else {
      scene::Style style;
      const Horizon* top = find_horizon(model.section, model.source->top);
      style.line = horizon_color(top != nullptr ? first_piece(model.section, whole_name(*top))->id : model.source->top);
      style.line_width = 1.6;
      after.layers.push_back(lines_layer("target", translated("Target"), style, {target.map.target().base_line()}));
    }
    add_pin(after, goes_to_target_grid(model) ? pin_line(target.map.target(), pin, deepest)
                                              : images_of({source_pin}, model.restoration->map).front());
    if (model.restoration) {
      add_names(after, model.restoration->section);
      add_column(after, model.restoration->section, units, model.restoration->ledger.units);
      add_ledger(picture, model);
    }
    // The legend of the first panel stands for both.
    for (scene::Layer& layer : after.layers) {
      const bool known = std::any_of(before.layers.begin(), before.layers.end(),
                                     [&](const auto& l) { return l.title == layer.title; });
      if (known) layer.in_legend = scene::InLegend::No;
    }
    picture.panels = {std::move(before), std::move(after)};
  } else {
    add_names(before, model.section);
    picture.panels = {std::move(before)};
  }
  return picture;
}

}  // namespace recon::core
