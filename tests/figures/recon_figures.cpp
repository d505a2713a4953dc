// Figures of grid.md and unfold.md.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/section/palette.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
namespace core = recon::core;

const scene::Axes section_axes{"x [m]", "z [m]"};

recon::section::Section section_of(const std::vector<geom::Polyline>& beds) {
  recon::section::Section section;
  for (std::size_t i = 0; i < beds.size(); ++i) {
    section.horizons.push_back({recon::section::HorizonId(i), i == 0 ? "top" : fmt::format("bed {}", i), beds[i], {}});
  }
  return section;
}

base::Result<scene::Panel> grid_panel(const std::string& title, recon::unfold::Treatment treatment, double distance,
                                      int count) {
  recon::unfold::GridParams params;
  params.count = count;
  params.distance = distance;
  params.treatment = treatment;
  params.side = recon::section::LayerSide::Below;
  DOBRA_TRY(const recon::unfold::SourceGrid source,
            recon::unfold::make_source_grid(section_of({cosine()}), params, {}));
  std::vector<geom::Polyline> curves;
  for (const recon::unfold::GridCurve& curve : source.grid.curves)
    curves.insert(curves.end(), curve.pieces.begin(), curve.pieces.end());
  return panel(title,
               {lines("rungs", stroke(grey, 0.6), source.grid.rungs), lines("offset curves", stroke(blue, 0.8), curves),
                lines("top", stroke(red, 2.0), {source.base})},
               0.2, section_axes);
}

base::Result<scene::Picture> grid() {
  scene::Picture picture{{}, {}, scene::Arrangement::Column};
  DOBRA_TRY(scene::Panel untreated, grid_panel("Untreated", recon::unfold::Treatment::Untreated, 0.2, 13));
  DOBRA_TRY(scene::Panel treated, grid_panel("Treated", recon::unfold::Treatment::Treated, 0.2, 13));
  treated.extent->add(*untreated.extent);
  picture.panels = {std::move(untreated), std::move(treated)};
  return picture;
}

/// The columns first .. last - 1 together, down to a depth.
scene::Region columns_between(const recon::maps::Columns& columns, std::size_t first, std::size_t last, double depth) {
  geom::Polyline round{{}, true};
  for (std::size_t i = first; i <= last; ++i) round.points.push_back(columns.foot(i));
  for (std::size_t i = last + 1; i-- > first;) round.points.push_back(columns.foot(i) + depth * columns.rung_vector(i));
  return {{round}};
}

/// Every second group of eight columns, shaded.
scene::Layer shaded_columns(const recon::maps::Columns& columns, double depth) {
  std::vector<scene::Region> groups;
  for (std::size_t i = 0; i + 8 < columns.rung_count(); i += 16)
    groups.push_back(columns_between(columns, i, i + 8, depth));
  return regions("every second group of 8 columns", filled({250, 236, 196}), std::move(groups));
}

scene::Panel unfold_panel(const std::string& title, const recon::section::Section& section,
                          const recon::maps::Columns& columns, double depth) {
  std::vector<scene::Layer> layers{shaded_columns(columns, depth)};
  for (const recon::section::Horizon& horizon : section.horizons) {
    layers.push_back(
        lines(horizon.name, stroke(recon::section::Palette(section).of(horizon.name).line, 1.8), {horizon.line}));
  }
  return panel(title, std::move(layers), 0.25, section_axes);
}

/// A point and its name, the same in both panels; the name stands `above` the point.
void add_point(scene::Panel& panel, Point p, const recon::maps::ColumnPoint& name, double above) {
  const Point at{p.x, p.y + above};
  const std::string text =
      fmt::format("column {}, depth {:.2f} m, along {:.2f}", name.column.index(), name.depth, name.along);
  scene::Layer leader = lines({}, stroke(ink, 0.8, scene::Dash::Dotted), {chain({p, at})});
  scene::Layer point = markers({}, dots(ink, 6.0), {p});
  scene::Layer name_layer = labels(ink, {{at, text, scene::Anchor::Above}});
  leader.key = "leader";
  point.key = "point";
  name_layer.key = "name";
  for (const scene::Layer& layer : {leader, point, name_layer}) panel.layers.push_back(layer);
  panel.extent->add(Point{at.x, at.y + 0.3});
}

base::Result<recon::model::Model> restored_fold() {
  const geom::Polyline top = cosine();
  geom::Polyline middle;
  geom::Polyline low;
  for (const Point p : top.points) {
    middle.points.push_back({p.x, 0.9 * p.y - 0.35});
    low.points.push_back({p.x, 0.8 * p.y - 0.65});
  }
  recon::unfold::GridParams grid_params;
  grid_params.count = 8;
  recon::model::Model model;
  model.section = section_of({top, middle, low});
  DOBRA_TRY(recon::model::Model with_grid, core::run_grid(model, grid_params, {}, {}));
  DOBRA_TRY(recon::model::Model with_target, core::run_target(with_grid, {}, {}, {}));
  return core::run_restore(with_target, {}, {}, {});
}

base::Result<scene::Picture> unfold() {
  DOBRA_TRY(const recon::model::Model model, restored_fold());
  const recon::maps::ColumnMap& map = model.target->map;
  constexpr double depth = 0.6;
  scene::Picture picture{{}, {}, scene::Arrangement::Column};
  picture.panels.push_back(unfold_panel("Deformed", model.section, map.source(), depth));
  picture.panels.push_back(unfold_panel("Restored", model.restoration->section, map.target(), depth));
  const Point p{6.5, -1.1};
  const recon::maps::ColumnPoint name = map.locate(p).at;
  add_point(picture.panels[0], p, name, 1.8);
  add_point(picture.panels[1], map.image(name), name, 0.6);
  return picture;
}

}  // namespace

std::vector<Figure> recon_figures() { return {{"grid", grid}, {"unfold", unfold}}; }

}  // namespace dobra::figures
