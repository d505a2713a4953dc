#pragma once
// What the pictures of a section have in common. The stage in hand is drawn by the last of the operations that it has
// gone through; that one builds its panels from the parts below.

#include <string>
#include <vector>

#include "recon/balance/ledger.h"
#include "recon/maps/columns.h"
#include "recon/model/model.h"
#include "recon/section/palette.h"
#include "recon/unfold/grid.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// Of pins, markers and small text.
inline constexpr dobra::scene::Color ink{40, 40, 40, 255};

/// Layers of one panel, from the back to the front; the section's own lines stand between `grid` and `pin`.
struct PanelParts {
  std::vector<dobra::scene::Layer> under;  ///< Pictures behind the section, units, fields on them.
  std::vector<dobra::scene::Layer> grid;
  std::vector<dobra::scene::Layer> pin;
};
/// A section: its faults, other lines, markers, horizons and names of horizons, with the given parts. Items of horizon
/// layers have the horizon's id. Horizons stand in the legend unless there are many, and units that name them.
/// @param panel  an empty one.
dobra::scene::Panel section_panel(dobra::scene::Panel panel, const section::Section& section,
                                  const section::Palette& palette, PanelParts parts);
/// The same for the section of the stage in hand, which is called by its place in the chain.
dobra::scene::Panel current_panel(const model::Model& model, const section::Palette& palette, PanelParts parts);
/// Axes and ends of a section, and no layers.
dobra::scene::Panel empty_panel(const std::string& key, const std::string& title, const section::Section& section);

dobra::scene::Layer lines_layer(std::string key, std::string title, dobra::scene::Style style,
                                std::vector<geom::Polyline> lines);
dobra::scene::Layer region_layer(std::string key, std::string title, const dobra::scene::UnitStyle& unit,
                                 geom::Polyline contour);
/// Units filled: the polygons of the section, or what lies between neighbouring horizons.
std::vector<dobra::scene::Layer> unit_layers(const section::Section& section, const section::Palette& palette,
                                             const std::vector<balance::LedgerUnit>& units);
/// The pictures behind a section, and over them what fills it, then translucent.
std::vector<dobra::scene::Layer> over_backdrops(const section::Section& section,
                                                std::vector<dobra::scene::Layer> fills);
/// What fills a section that is not restored: its polygons, over its backdrops.
std::vector<dobra::scene::Layer> filled_units(const section::Section& section, const section::Palette& palette);
/// Curves and rungs of a grid; of very many rungs every k-th.
std::vector<dobra::scene::Layer> grid_layers(const unfold::Grid& grid, const std::string& key);
/// A line along the normal at the pin, from a little above the base down to the deepest curve.
geom::Polyline normal_at_pin(const maps::Columns& columns, maps::ColumnPoint pin, double deepest);
std::vector<dobra::scene::Layer> pin_layers(const geom::Polyline& line);

/// The sheet of the panels, which have one legend, arranged so that they are as large as can be; drawn by the section's
/// table of colours where it has one.
void show(std::vector<dobra::scene::Panel> panels, const section::Section& section, dobra::scene::Picture& picture);

/// The section before it has a grid.
void draw_section(const model::Model& model, dobra::scene::Picture& picture);

}  // namespace recon::core
