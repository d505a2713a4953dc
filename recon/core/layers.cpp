#include "recon/core/layers.h"

#include <algorithm>
#include <array>
#include <limits>

#include "shared/base/text.h"

namespace recon::core {

namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color grid_color{126, 147, 168, 255};
constexpr scene::Color rung_color{176, 190, 203, 255};
constexpr scene::Color pin_color{40, 40, 40, 255};
/// More rungs than this would be a grey area: then every k-th is shown.
constexpr std::size_t most_rungs = 160;
/// Sections longer than this many times their height stand one above the other, where they have the whole width of the
/// page.
constexpr double wide = 5.0;
/// Sizes of text as parts of the width of a plot, beside the other panel and alone in its row.
struct TextShare {
  double line;       ///< From label to label.
  double character;  ///< Width of one.
};
constexpr TextShare in_row{15.0 / 290.0, 4.8 / 290.0};
constexpr TextShare in_column{11.0 / 620.0, 4.8 / 620.0};

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

void add_horizons(scene::Panel& panel, const Section& section) {
  for (const Horizon& horizon : section.horizons) {
    scene::Style style;
    style.line = horizon_color(horizon.id);
    style.line_width = 1.6;
    scene::Layer layer =
        lines_layer("horizon_" + std::to_string(horizon.id.index()), horizon.name, style, {horizon.line});
    std::get<scene::Lines>(layer.content).ids = {static_cast<std::uint32_t>(horizon.id.index())};
    panel.layers.push_back(std::move(layer));
  }
}

/// Names at the right ends, moved apart vertically where they would cover each other; and room for them on the right.
void add_names(scene::Panel& panel, const Section& section, const TextShare& share) {
  std::vector<const Horizon*> order;
  for (const Horizon& horizon : section.horizons) order.push_back(&horizon);
  const auto end_of = [](const Horizon* horizon) { return horizon->line.points.back(); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return end_of(a).y > end_of(b).y; });
  const double width = std::max(box_of(section).width(), 1.5 * box_of(section).height());
  geom::Box room = scene::extent(panel);
  double limit = std::numeric_limits<double>::infinity();
  for (const Horizon* horizon : order) {
    const geom::Point at{end_of(horizon).x + 0.008 * width, std::min(end_of(horizon).y, limit)};
    limit = at.y - share.line * width;
    room.add(geom::Point{at.x + share.character * width * static_cast<double>(horizon->name.size()),
                         at.y - 0.5 * share.line * width});
    scene::Style style;
    style.line = horizon_color(horizon->id);
    style.text_size = 8.0;
    panel.layers.push_back({"name_" + std::to_string(horizon->id.index()), horizon->name, style,
                            scene::Labels{{{at, horizon->name, scene::Anchor::Right}}}, true, scene::InLegend::No});
  }
  panel.extent = room.grown(0.03 * width);
}

/// A line along the normal at the pin, from a little above the base down to the deepest curve.
void add_pin(scene::Panel& panel, const Columns& columns, ColumnPoint pin, double deepest) {
  const double above = 0.04 * columns.base_line().box().diagonal();
  const auto at_depth = [&](double depth) {
    pin.depth = depth;
    return columns.point(pin);
  };
  const geom::Point top = at_depth(-above);
  const geom::Point bottom = at_depth(std::max(deepest, above));
  scene::Style style;
  style.line = pin_color;
  style.line_width = 1.0;
  style.dash = scene::Dash::Dashed;
  panel.layers.push_back(lines_layer("pin", translated("Pin line"), style, {{{top, bottom}, false}}));
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
  if (model.source) add_grid(before, model.source->grid, "source_grid");
  add_horizons(before, model.section);
  const geom::Box box = scene::extent(before);
  if (box.width() > wide * box.height()) picture.arrangement = scene::Arrangement::Column;
  const bool side_by_side = model.target && picture.arrangement == scene::Arrangement::Row;
  const TextShare& share = side_by_side ? in_row : in_column;
  if (model.target) {
    const Target& target = *model.target;
    const ColumnPoint pin = target.map.locate(target.source_pin).at;
    add_pin(before, target.map.source(), pin, model.source->options.distances.back());
    add_names(before, model.section, share);
    scene::Panel after =
        panel("restored", model.restoration ? translated("Restored section") : translated("Target grid"));
    add_grid(after, target.grid, "target_grid");
    if (model.restoration) {
      add_horizons(after, model.restoration->section);
    } else {
      scene::Style style;
      style.line = horizon_color(model.source->top);
      style.line_width = 1.6;
      after.layers.push_back(lines_layer("target", translated("Target"), style, {target.map.target().base_line()}));
    }
    add_pin(after, target.map.target(), pin, model.source->options.distances.back());
    if (model.restoration) add_names(after, model.restoration->section, share);
    // The legend of the first panel stands for both.
    for (scene::Layer& layer : after.layers) {
      const bool known = std::any_of(before.layers.begin(), before.layers.end(),
                                     [&](const auto& l) { return l.title == layer.title; });
      if (known) layer.in_legend = scene::InLegend::No;
    }
    picture.panels = {std::move(before), std::move(after)};
  } else {
    add_names(before, model.section, share);
    picture.panels = {std::move(before)};
  }
  return picture;
}

}  // namespace recon::core
