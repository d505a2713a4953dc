#include "recon/core/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "recon/core/face_ledger.h"
#include "recon/core/palette.h"
#include "recon/core/report.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/scene/color_map.h"
#include "shared/scene/unit_colors.h"
#include "shared/scene/view.h"

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
/// The room for plots on a sheet, points: which arrangement of two gives the larger scale.
constexpr double sheet_width = 760.0;
constexpr double sheet_height = 240.0;
constexpr double clearly = 1.4;
/// With more horizons than this the legend has only the units, each by the name of the horizon above it.
constexpr std::size_t most_horizons_in_legend = 12;
/// More lines or markers of one kind than this share an entry of the legend.
constexpr std::size_t most_of_a_kind = 3;
/// A column of more units has neither outlines nor names: the legend has them.
constexpr std::size_t most_names_of_column = 24;
/// More horizons than this are drawn with thin lines.
constexpr std::size_t most_thick_horizons = 20;
/// Strain ellipses are cut off here: at so many radii of the circle.
constexpr double longest_ellipse = 6.0;
/// What is shown round the section, a part of its diagonal.
constexpr double border_of_section = 0.07;
/// From this length on, m, axes are in kilometres.
constexpr double long_section = 10000.0;

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

scene::Layer region_layer(std::string key, std::string title, const scene::UnitStyle& unit, geom::Polyline contour) {
  scene::Style style;
  style.line_width = 0.0;
  style.fill = unit.fill;
  style.pattern = unit.pattern;
  return {std::move(key), std::move(title),    style, scene::Regions{{{{std::move(contour)}}}, {}},
          true,           scene::InLegend::Yes};
}

/// Units filled: the polygons of the section, or what lies between neighbouring horizons.
void add_units(scene::Panel& panel, const Section& section, const Palette& palette,
               const std::vector<LedgerUnit>& units) {
  const bool many = whole_horizons(section).size() > most_horizons_in_legend;
  for (std::size_t i = 0; i < units.size(); ++i) {
    const LedgerUnit& unit = units[i];
    const std::string key = "unit_" + std::to_string(i);
    if (unit.unit) {
      panel.layers.push_back(
          region_layer(key, unit.name, palette.of(*unit.unit), section.units[unit.unit->index()].contour));
      panel.layers.back().legend = palette.whole_of(*unit.unit);
      continue;
    }
    const Horizon& upper = section.horizons[*unit.upper];
    const Horizon& lower = section.horizons[*unit.lower];
    panel.layers.push_back(
        region_layer(key, unit.name, palette.of(whole_name(upper)), contour_between(upper.line, lower.line)));
    panel.layers.back().legend =
        many ? whole_name(upper) : fmt::format("{} - {}", whole_name(upper), whole_name(lower));
  }
}

/// Units that are measured by their faces: the rows of the ledger after those of `units`.
void add_face_units(scene::Panel& panel, const Section& section, const Palette& palette, const Ledger& ledger,
                    std::size_t first, std::vector<geom::Polyline> UnitRow::*faces) {
  for (std::size_t i = first; i < ledger.units.size(); ++i) {
    const UnitRow& row = ledger.units[i];
    scene::UnitStyle style{{226, 226, 226, 255}, {}};  // no horizon over it
    for (const RockUnit& unit : section.faces->units) {
      if (unit.name == row.name && unit.top) style = palette.of(whole_name(section.horizons[*unit.top]));
    }
    scene::Layer layer = region_layer("unit_" + std::to_string(i), row.name, style, {});
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
scene::Style style_of(const SectionLine& line, const Palette& palette) {
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
    style.line = palette.of(line.name).line;
    style.line_width = 1.2;
  }
  return style;
}

/// What many lines of a kind are called together in the legend.
std::string kind_title(LineKind kind) {
  switch (kind) {
    case LineKind::Fault:
      return translated("Faults");
    case LineKind::Pin:
      return translated("Pin lines");
    case LineKind::Datum:
      return translated("Datums");
    case LineKind::Eroded:
      return translated("Eroded");
    case LineKind::Topography:
      return translated("Topography");
    case LineKind::Loose:
      break;
  }
  return translated("Lines");
}

/// The name of a fault over its upper end.
scene::Layer fault_name(const SectionLine& line) {
  const std::vector<geom::Point>& points = line.line.points;
  const geom::Point top = points.front().y > points.back().y ? points.front() : points.back();
  scene::Style style;
  style.line = fault_color;
  style.text_size = 8.0;
  return {"fault_name_" + std::to_string(line.id.index()),         line.name, style,
          scene::Labels{{{top, line.name, scene::Anchor::Above}}}, true,      scene::InLegend::No};
}

/// Faults, pin and loose lines, markers.
void add_items(scene::Panel& panel, const Section& section, const Palette& palette) {
  std::map<LineKind, std::size_t> count;
  for (const SectionLine& line : section.lines) ++count[line.kind];
  bool eroded_told = false;
  for (const SectionLine& line : section.lines) {
    const bool eroded = line.kind == LineKind::Eroded;
    const bool many = count[line.kind] > most_of_a_kind;
    scene::Layer layer = lines_layer("line_" + std::to_string(line.id.index()),
                                     eroded ? fmt::format("{} ({})", line.name, translated("eroded")) : line.name,
                                     style_of(line, palette), {line.line});
    std::get<scene::Lines>(layer.content).ids = {static_cast<std::uint32_t>(line.id.index())};
    if (many) layer.legend = kind_title(line.kind);
    // Each has the colour of its horizon: the first stands for all.
    if (many && eroded && std::exchange(eroded_told, true)) layer.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(layer));
    if (line.kind == LineKind::Fault) panel.layers.push_back(fault_name(line));
  }
  for (const Marker& marker : section.markers) {
    scene::Style style;
    style.line = pin_color;
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
  constexpr double all = 100.0;  // det F itself, percent
  const bool noise = *nearly_all <= scene::rounding_part * all;
  const double most = noise ? *std::max_element(sizes.begin(), sizes.end()) : *nearly_all;
  mesh.scale = {translated("det F - 1 [%]"), scene::ColorMapName::CoolWarm, -most, most};
  scene::settle_constant(mesh, all);
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
      const double along = size * std::min(strain.greatest, longest_ellipse) * std::cos(angle);
      const double across = size * std::min(strain.least, longest_ellipse) * std::sin(angle);
      ellipse.points.push_back(strain.at + geom::Vector{along * c - across * s, along * s + across * c});
    }
    ellipses.push_back(std::move(ellipse));
  }
  scene::Style style;
  style.line = {60, 60, 66, 255};
  style.line_width = 0.6;
  panel.layers.push_back(lines_layer("ellipses", translated("Strain ellipses"), style, std::move(ellipses)));
}

/// What is to be said of ellipses that are cut off; empty if none is.
std::string note_on_ellipses(const std::vector<Strain>& strains) {
  const Strain* longest = nullptr;
  std::size_t cut = 0;
  for (const Strain& strain : strains) {
    if (strain.greatest <= longest_ellipse) continue;
    ++cut;
    if (longest == nullptr || strain.greatest > longest->greatest) longest = &strain;
  }
  if (longest == nullptr) return {};
  return fmt::format("{} {} {:.4g}, ({:.6g}, {:.6g}).", cut,
                     translated("strain ellipses are longer than they are drawn; the greatest stretch and its place:"),
                     longest->greatest, longest->at.x, longest->at.y);
}

/// The beds as they lie on each other, each once with its mean restored thickness, to the scale of the section.
void add_column(scene::Panel& panel, const Section& section, const Palette& palette,
                const std::vector<LedgerUnit>& units, const std::vector<UnitRow>& rows) {
  const geom::Box box = box_of(section);
  const double width = 0.03 * box.width();
  const double left = box.low.x - 0.03 * box.width() - width;
  scene::Labels names;
  const std::vector<RestoredBed> beds = restored_beds(section, units, rows);
  const bool few = beds.size() <= most_names_of_column;
  double top = box.high.y;
  for (std::size_t i = 0; i < beds.size(); ++i) {
    const double bottom = top - beds[i].thickness;
    const std::string& upper = whole_name(section.horizons[beds[i].upper]);
    scene::Layer bed = region_layer("column_" + std::to_string(i), beds[i].name, palette.of(upper),
                                    {{{left, bottom}, {left + width, bottom}, {left + width, top}, {left, top}}, true});
    bed.style.line = pin_color;
    bed.style.line_width = few ? 0.5 : 0.0;
    bed.in_legend = scene::InLegend::No;
    if (few) names.labels.push_back({{left, 0.5 * (top + bottom)}, beds[i].name, scene::Anchor::Left});
    panel.layers.push_back(std::move(bed));
    top = bottom;
  }
  scene::Style text;
  text.line = pin_color;
  text.text_size = 7.0;
  panel.layers.push_back(
      {"column_names", translated("Names of the column"), text, std::move(names), true, scene::InLegend::No});
}

/// A change that rounds to nothing has no sign.
std::string change_text(double value) {
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
    beds.rows.push_back({row.name, metres(row.length_before), metres(row.length_after), change_text(row.change_percent),
                         metres(row.shortening), change_text(row.shortening_percent)});
  }
  scene::TextTable units{translated("Units"),
                         {translated("unit"), translated("area before [m\u00b2]"), translated("after [m\u00b2]"),
                          translated("change [%]"), translated("thickness before [m]"), translated("after [m]")},
                         {}};
  const auto mean = [&](const std::optional<Range>& range) { return range ? metres(range->mean) : std::string("-"); };
  double largest = 0.0;
  const std::vector<UnitRow> rows_of_units = unit_rows(model);
  for (const UnitRow& row : rows_of_units) largest = std::max({largest, row.area_before, row.area_after});
  const auto area = [&](double value) { return fixed(value, largest); };
  for (const UnitRow& row : rows_of_units) {
    const std::string name =
        row.pieces > 1 ? fmt::format("{} ({} {})", row.name, row.pieces, translated("pieces")) : row.name;
    units.rows.push_back({name, area(row.area_before), area(row.area_after), change_text(row.change_percent),
                          mean(row.thickness_before), mean(row.thickness_after)});
  }
  picture.tables = {std::move(beds)};
  if (!units.rows.empty()) picture.tables.push_back(std::move(units));
  std::string sentence = what_it_keeps(restoration.params.method);
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  picture.notes = {sentence + '.', fmt::format("{}{}. {}", translated("Verdict: "), restoration.remarks.back(),
                                               translated("Both states to the same scale, no vertical exaggeration."))};
  if (std::string verdict = verdict_since_input(restored_stages(model)); !verdict.empty()) {
    verdict.front() = 'S';
    picture.notes.push_back(verdict + '.');
  }
  const std::string ellipses = note_on_ellipses(restoration.ledger.strains);
  if (!ellipses.empty()) picture.notes.push_back(ellipses);
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

void add_horizons(scene::Panel& panel, const Section& section, const Palette& palette) {
  const auto wholes = whole_horizons(section);
  const auto is_unit = [](const scene::Layer& layer) { return layer.key.starts_with("unit_"); };
  const bool units = std::any_of(panel.layers.begin(), panel.layers.end(), is_unit);
  const bool listed = !units || wholes.size() <= most_horizons_in_legend;
  for (const std::vector<const Horizon*>& pieces : wholes) {
    const Horizon& first = *pieces.front();
    scene::Style style;
    style.line = palette.of(whole_name(first)).line;
    style.line_width = wholes.size() <= most_thick_horizons ? 1.6 : 0.8;
    scene::Lines lines;
    for (const Horizon* piece : pieces) {
      lines.lines.push_back(piece->line);
      lines.ids.push_back(static_cast<std::uint32_t>(piece->id.index()));
    }
    panel.layers.push_back({"horizon_" + std::to_string(first.id.index()), whole_name(first), style, std::move(lines),
                            true, listed ? scene::InLegend::Yes : scene::InLegend::No});
  }
}

/// Names at the right ends; the layout makes room for them. The highest choose first, the others stand below.
void add_names(scene::Panel& panel, const Section& section, const Palette& palette) {
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
    style.line = palette.of(whole_name(*name.first)).line;
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

/// What the method holds at the pin: under shear the line along its direction, else the normal of the top.
geom::Polyline source_pin_line(const Model& model, double deepest) {
  const Target& target = *model.target;
  const Columns& columns = target.map.source();
  geom::Polyline line = pin_line(columns, target.map.locate(target.source_pin).at, deepest);
  if (!model.restoration || model.restoration->params.method != RestoreMethod::Shear) return line;
  const double angle = model.restoration->params.angle.radians();
  const geom::Vector up{std::sin(angle), std::cos(angle)};
  for (geom::Point& end : line.points) {
    const double length = geom::distance(end, target.source_pin);
    const bool upper = (&end == &line.points.front()) == (model.source->side == LayerSide::Below);
    end = target.source_pin + (upper ? length : -length) * up;
  }
  return line;
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

scene::Panel panel(std::string key, std::string title, const Section& section) {
  scene::Panel made;
  made.key = std::move(key);
  made.title = std::move(title);
  made.axes = {translated("x [m]"), translated("z [m]")};
  if (box_of(section).width() >= long_section) made.axes = {translated("x [km]"), translated("z [km]")};
  if (box_of(section).width() >= long_section) made.axes.unit = 1000.0;
  made.left_end = section.left_end;
  made.right_end = section.right_end;
  return made;
}

/// The section with what of grid and pin lies near it: images of the grid may go far astray.
geom::Box part_to_show(const scene::Panel& panel) {
  geom::Box section;
  for (const scene::Layer& layer : panel.layers) {
    const bool aid = layer.key.find("_grid") != std::string::npos || layer.key.starts_with("pin");
    if (!aid && layer.key != "ellipses") section.add(scene::extent(layer));
  }
  const geom::Box near = section.grown(border_of_section * section.diagonal());
  const geom::Box all = scene::comfortable(scene::extent(panel));
  return {{std::max(near.low.x, all.low.x), std::max(near.low.y, all.low.y)},
          {std::min(near.high.x, all.high.x), std::min(near.high.y, all.high.y)}};
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

/// Of the section that the earlier stages have left.
std::string stage_title(const Model& model) {
  return fmt::format("{} {}", translated("Section after restoration"), model.earlier.size());
}

}  // namespace

void draw(const Model& model, scene::Picture& picture) {
  picture.paper = scene::Paper::A4Landscape;
  const Palette palette(model.section);
  scene::Panel before =
      panel("deformed", model.earlier.empty() ? translated("Deformed section") : stage_title(model), model.section);
  add_backdrops(before, model.section);
  std::vector<LedgerUnit> units;
  if (model.restoration) {
    const Restoration& restoration = *model.restoration;
    units = ledger_units(model.section, restoration.order, model.source->side);
    const bool keeps_area = restoration.params.method == RestoreMethod::Flexural ||
                            restoration.params.method == RestoreMethod::Shear ||
                            restoration.params.method == RestoreMethod::Variable;
    add_units(before, model.section, palette, units);
    add_face_units(before, model.section, palette, restoration.ledger, units.size(), &UnitRow::faces_before);
    add_dilatation(before, restoration.ledger.field, !keeps_area);
    add_ellipses(before, restoration.ledger.strains, 0.008 * box_of(model.section).diagonal());
  } else {
    add_units(before, model.section, palette, ledger_units(model.section, {}, LayerSide::Below));
  }
  if (!model.section.backdrops.empty()) make_translucent(before);
  if (model.source) add_grid(before, model.source->grid, "source_grid");
  add_items(before, model.section, palette);
  add_horizons(before, model.section, palette);
  if (model.target) {
    const Target& target = *model.target;
    const ColumnPoint pin = target.map.locate(target.source_pin).at;
    const double deepest = model.source->options.distances.back();
    const geom::Polyline source_pin = source_pin_line(model, deepest);
    add_pin(before, source_pin);
    add_names(before, model.section, palette);
    scene::Panel after = panel(
        "restored", model.restoration ? translated("Restored section") : translated("Target grid"), model.section);
    if (model.restoration) {
      add_units(after, model.restoration->section, palette, units);
      add_face_units(after, model.section, palette, model.restoration->ledger, units.size(), &UnitRow::faces_after);
    }
    add_grid(after, restored_grid(model), "target_grid");
    if (model.restoration) {
      add_items(after, model.restoration->section, palette);
      add_horizons(after, model.restoration->section, palette);
    } else {
      scene::Style style;
      const Horizon* top = find_horizon(model.section, model.source->top);
      if (top != nullptr) style.line = palette.of(whole_name(*top)).line;
      style.line_width = 1.6;
      after.layers.push_back(lines_layer("target", translated("Target"), style, {target.map.target().base_line()}));
    }
    add_pin(after, goes_to_target_grid(model) ? pin_line(target.map.target(), pin, deepest)
                                              : images_of({source_pin}, model.restoration->map).front());
    if (model.restoration) {
      add_names(after, model.restoration->section, palette);
      add_column(after, model.restoration->section, palette, units, model.restoration->ledger.units);
      add_ledger(picture, model);
    }
    // The legend of the first panel stands for both.
    for (scene::Layer& layer : after.layers) {
      const bool known = std::any_of(before.layers.begin(), before.layers.end(),
                                     [&](const auto& l) { return scene::legend_name(l) == scene::legend_name(layer); });
      if (known) layer.in_legend = scene::InLegend::No;
    }
    picture.panels = {std::move(before), std::move(after)};
    if (model.restoration) {
      for (scene::Panel& shown : picture.panels) shown.extent = part_to_show(shown);
    }
    picture.arrangement = arrangement_of(picture.panels);
  } else {
    add_names(before, model.section, palette);
    picture.panels = {std::move(before)};
  }
  if (model.section.colors) scene::paint(picture, *model.section.colors);
}

}  // namespace recon::core
