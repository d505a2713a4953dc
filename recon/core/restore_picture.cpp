#include "recon/core/restore_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "recon/balance/face_ledger.h"
#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "recon/model/chain.h"
#include "shared/base/parallel.h"
#include "shared/base/text.h"
#include "shared/geom/place.h"
#include "shared/scene/color_map.h"
#include "shared/scene/view.h"

namespace recon::core {

namespace scene = dobra::scene;
using base::translated;

namespace {

/// Strain ellipses are cut off here: at so many radii of the circle.
constexpr double longest_ellipse = 6.0;
/// What is shown round the section, a part of its diagonal.
constexpr double border_of_section = 0.07;
/// A column of more units has neither outlines nor names: the legend has them.
constexpr std::size_t most_names_of_column = 24;

/// Units that are measured by their faces: the rows of the ledger after those of `units`.
void add_face_units(const section::Section& section, const section::Palette& palette, const balance::Ledger& ledger,
                    std::size_t first, std::vector<geom::Polyline> balance::UnitRow::*faces,
                    std::vector<scene::Layer>& layers) {
  for (std::size_t i = first; i < ledger.units.size(); ++i) {
    const balance::UnitRow& row = ledger.units[i];
    scene::UnitStyle style{{226, 226, 226, 255}, {}};  // no horizon over it
    for (const section::RockUnit& unit : section.faces->units) {
      if (unit.name == row.name && unit.top) style = palette.of(whole_name(section.horizons[*unit.top]));
    }
    scene::Layer layer = region_layer("unit_" + std::to_string(i), row.name, style, {});
    std::get<scene::Regions>(layer.content).regions = {scene::Region{row.*faces}};
    layers.push_back(std::move(layer));
  }
}

/// det F - 1 in percent; seen where the method does not keep areas.
void add_dilatation(const balance::DilatationField& field, bool seen, std::vector<scene::Layer>& layers) {
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
  layers.push_back({"dilatation", translated("Change of area"), style, std::move(mesh), seen, scene::InLegend::No});
}

/// What the restoration makes circles of.
scene::Layer ellipses_layer(const std::vector<maps::Strain>& strains, double size) {
  std::vector<geom::Polyline> ellipses;
  for (const maps::Strain& strain : strains) {
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
  return lines_layer("ellipses", translated("Strain ellipses"), style, std::move(ellipses));
}

/// What is to be said of ellipses that are cut off; empty if none is.
std::string note_on_ellipses(const std::vector<maps::Strain>& strains) {
  const maps::Strain* longest = nullptr;
  std::size_t cut = 0;
  for (const maps::Strain& strain : strains) {
    if (strain.greatest <= longest_ellipse) continue;
    ++cut;
    if (longest == nullptr || strain.greatest > longest->greatest) longest = &strain;
  }
  if (longest == nullptr) return {};
  return fmt::format("{} {} {:.4g}, {}.", cut,
                     translated("strain ellipses are longer than they are drawn; the greatest stretch and its place:"),
                     longest->greatest, longest->at);
}

/// The beds as they lie on each other, each once with its mean restored thickness, to the scale of the section.
void add_column(scene::Panel& panel, const section::Section& section, const section::Palette& palette,
                const std::vector<balance::LedgerUnit>& units, const std::vector<balance::UnitRow>& rows) {
  const geom::Box box = box_of(section);
  const double width = 0.03 * box.width();
  const double left = box.low.x - 0.03 * box.width() - width;
  scene::Labels names;
  const std::vector<balance::RestoredBed> beds = restored_beds(section, units, rows);
  const bool few = beds.size() <= most_names_of_column;
  double top = box.high.y;
  for (std::size_t i = 0; i < beds.size(); ++i) {
    const double bottom = top - beds[i].thickness;
    const std::string& upper = whole_name(section.horizons[beds[i].upper]);
    scene::Layer bed = region_layer("column_" + std::to_string(i), beds[i].name, palette.of(upper),
                                    {{{left, bottom}, {left + width, bottom}, {left + width, top}, {left, top}}, true});
    bed.style.line = ink;
    bed.style.line_width = few ? 0.5 : 0.0;
    bed.in_legend = scene::InLegend::No;
    if (few) names.labels.push_back({{left, 0.5 * (top + bottom)}, beds[i].name, scene::Anchor::Left});
    panel.layers.push_back(std::move(bed));
    top = bottom;
  }
  scene::Style text;
  text.line = ink;
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
void add_ledger(scene::Picture& picture, const model::Model& model) {
  const unfold::Restoration& restoration = *model.restoration;
  scene::TextTable beds{translated("Beds"),
                        {translated("horizon"), translated("length before [m]"), translated("after [m]"),
                         translated("change [%]"), translated("shortening [m]"), translated("[%]")},
                        {}};
  std::vector<balance::LineLength> rows = restoration.lengths;
  for (balance::LineLength& total : totals_of(restoration.lengths)) {
    total.name += fmt::format(" ({})", translated("all pieces"));
    rows.push_back(std::move(total));
  }
  double longest = 0.0;
  for (const balance::LineLength& row : rows) longest = std::max({longest, row.length_before, row.length_after});
  const auto metres = [&](double value) { return fixed(value, longest); };
  for (const balance::LineLength& row : rows) {
    beds.rows.push_back({row.name, metres(row.length_before), metres(row.length_after), change_text(row.change_percent),
                         metres(row.shortening), change_text(row.shortening_percent)});
  }
  scene::TextTable units{translated("Units"),
                         {translated("unit"), translated("area before [m\u00b2]"), translated("after [m\u00b2]"),
                          translated("change [%]"), translated("thickness before [m]"), translated("after [m]")},
                         {}};
  const auto mean = [&](const std::optional<balance::Range>& range) {
    return range ? metres(range->mean) : std::string("-");
  };
  double largest = 0.0;
  const std::vector<balance::UnitRow> rows_of_units = unit_rows(model);
  for (const balance::UnitRow& row : rows_of_units) largest = std::max({largest, row.area_before, row.area_after});
  const auto area = [&](double value) { return fixed(value, largest); };
  for (const balance::UnitRow& row : rows_of_units) {
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
std::vector<geom::Polyline> images_of(const std::vector<geom::Polyline>& lines, const maps::SectionMap& map) {
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
bool goes_to_target_grid(const model::Model& model) {
  return model.restoration->params.method == unfold::RestoreMethod::Constant &&
         model.restoration->params.percent == 100.0;
}

/// The target grid of the method: the grid of the target line where columns go to columns, else what becomes of the
/// source grid.
unfold::Grid restored_grid(const model::Model& model) {
  if (goes_to_target_grid(model)) return model.target->grid;
  unfold::Grid grid;
  for (const unfold::GridCurve& curve : model.source->grid.curves)
    grid.curves.push_back({curve.distance, images_of(curve.pieces, model.restoration->map)});
  grid.rungs = images_of(model.source->grid.rungs, model.restoration->map);
  return grid;
}

/// What the method holds at the pin: under shear the line along its direction, else the normal of the top.
geom::Polyline source_pin_line(const model::Model& model, double deepest) {
  const unfold::Target& target = *model.target;
  const maps::Columns& columns = target.map.source();
  geom::Polyline line = normal_at_pin(columns, target.map.locate(target.source_pin).at, deepest);
  if (model.restoration->params.method != unfold::RestoreMethod::Shear) return line;
  const double angle = model.restoration->params.angle.radians();
  const geom::Vector up{std::sin(angle), std::cos(angle)};
  for (geom::Point& end : line.points) {
    const double length = geom::distance(end, target.source_pin);
    const bool upper = (&end == &line.points.front()) == (model.source->side == section::LayerSide::Below);
    end = target.source_pin + (upper ? length : -length) * up;
  }
  return line;
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

bool keeps_areas(unfold::RestoreMethod method) {
  return method == unfold::RestoreMethod::Flexural || method == unfold::RestoreMethod::Shear ||
         method == unfold::RestoreMethod::Variable;
}

/// The section with its units, what became of them in colours and ellipses, the grid and the pin.
scene::Panel panel_before(const model::Model& model, const section::Palette& palette,
                          const std::vector<balance::LedgerUnit>& units, const geom::Polyline& pin) {
  const unfold::Restoration& restoration = *model.restoration;
  std::vector<scene::Layer> fills = unit_layers(model.section, palette, units);
  add_face_units(model.section, palette, restoration.ledger, units.size(), &balance::UnitRow::faces_before, fills);
  add_dilatation(restoration.ledger.field, !keeps_areas(restoration.params.method), fills);
  fills.push_back(ellipses_layer(restoration.ledger.strains, 0.008 * box_of(model.section).diagonal()));
  PanelParts parts;
  parts.under = over_backdrops(model.section, std::move(fills));
  parts.grid = grid_layers(model.source->grid, "source_grid");
  parts.pin = pin_layers(pin);
  return current_panel(model, palette, std::move(parts));
}

scene::Panel panel_after(const model::Model& model, const section::Palette& palette,
                         const std::vector<balance::LedgerUnit>& units, const geom::Polyline& pin) {
  const unfold::Restoration& restoration = *model.restoration;
  PanelParts parts;
  parts.under = unit_layers(restoration.section, palette, units);
  add_face_units(model.section, palette, restoration.ledger, units.size(), &balance::UnitRow::faces_after, parts.under);
  parts.grid = grid_layers(restored_grid(model), "target_grid");
  parts.pin = pin_layers(pin);
  scene::Panel panel = section_panel(empty_panel("restored", translated("Restored section"), model.section),
                                     restoration.section, palette, std::move(parts));
  add_column(panel, restoration.section, palette, units, restoration.ledger.units);
  return panel;
}

/// Translucent, so that units show through.
constexpr std::array<scene::Color, 6> block_colors{{{214, 120, 60, 90},
                                                    {70, 130, 180, 90},
                                                    {120, 170, 80, 90},
                                                    {170, 110, 170, 90},
                                                    {220, 190, 70, 90},
                                                    {90, 170, 165, 90}}};

enum class When { Before, After };

/// The rock of an unfolded block: as it is, or as it becomes.
std::vector<geom::Polyline> contours_of_block(const jigsaw::Blockwise& made, std::size_t block, When when) {
  std::vector<geom::Polyline> contours;
  for (const geom::Polyline& contour : made.parts[made.blocks[block].part].contours)
    contours.push_back(when == When::After ? made.blocks[block].forward(contour) : contour);
  return contours;
}

std::vector<scene::Layer> block_fills(const jigsaw::Blockwise& made, When when) {
  std::vector<scene::Layer> layers;
  for (std::size_t b = 0; b < made.blocks.size(); ++b) {
    scene::Style style;
    style.fill = block_colors[b % block_colors.size()];
    style.line_width = 0.0;
    layers.push_back({"block_" + std::to_string(b), made.blocks[b].name, style,
                      scene::Regions{{{contours_of_block(made, b, when)}}, {}}, true, scene::InLegend::Yes});
  }
  return layers;
}

std::vector<scene::Layer> pins_of(const jigsaw::Blockwise& made, When when, double length) {
  std::vector<geom::Polyline> lines;
  for (const jigsaw::UnfoldedBlock& block : made.blocks) {
    const geom::Point at = when == When::After ? block.forward(block.pin) : block.pin;
    const geom::Vector upright{0.0, 0.5 * length};
    const geom::Vector half = when == When::After ? block.placed.turned(upright) : upright;
    lines.push_back({{at + half, at - half}, false});
  }
  scene::Style style;
  style.line = ink;
  style.line_width = 1.2;
  return {lines_layer("pins", translated("Pins"), style, std::move(lines))};
}

/// Both states to one scale, blocks in colours.
void draw_blockwise(const model::Model& model, scene::Picture& picture) {
  if (!model.blockwise) return;
  const jigsaw::Blockwise& made = *model.blockwise;
  const section::Palette palette(made.section);
  const double pin = 0.03 * made.size;
  const auto parts_of = [&](const section::Section& section, When when) {
    PanelParts parts;
    parts.under = filled_units(section, palette);
    for (scene::Layer& layer : block_fills(made, when)) parts.under.push_back(std::move(layer));
    parts.pin = pins_of(made, when, pin);
    return parts;
  };
  std::vector<scene::Panel> panels{current_panel(model, palette, parts_of(model.section, When::Before)),
                                   section_panel(empty_panel("restored", translated("Restored section"), model.section),
                                                 made.section, palette, parts_of(made.section, When::After))};
  geom::Box box = box_of(model.section);
  box.add(box_of(made.section));
  for (scene::Panel& panel : panels) panel.extent = box.grown(0.04 * box.diagonal());
  picture.notes = {fmt::format("{}{}. {}", translated("Verdict: "), made.remarks.back(),
                               translated("Both states to the same scale, no vertical exaggeration."))};
  show(std::move(panels), model.section, picture);
}

}  // namespace

void draw_restored(const model::Model& model, scene::Picture& picture) {
  draw_blockwise(model, picture);
  if (!model.restoration) return;
  const section::Palette palette(model.section);
  const unfold::Target& target = *model.target;
  const double deepest = model.source->options.distances.back();
  const geom::Polyline pin = source_pin_line(model, deepest);
  const maps::ColumnPoint at = target.map.locate(target.source_pin).at;
  const geom::Polyline pin_after = goes_to_target_grid(model) ? normal_at_pin(target.map.target(), at, deepest)
                                                              : images_of({pin}, model.restoration->map).front();
  const std::vector<balance::LedgerUnit> units =
      balance::ledger_units(model.section, model.restoration->order, model.source->side);
  std::vector<scene::Panel> panels = {panel_before(model, palette, units, pin),
                                      panel_after(model, palette, units, pin_after)};
  for (scene::Panel& panel : panels) panel.extent = part_to_show(panel);
  add_ledger(picture, model);
  show(std::move(panels), model.section, picture);
}

}  // namespace recon::core
