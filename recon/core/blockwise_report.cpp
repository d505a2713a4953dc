#include "recon/core/blockwise_report.h"

#include <fmt/format.h>

#include <array>

#include "recon/core/section_picture.h"
#include "shared/base/text.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using base::translated;

std::vector<RowCell> cells_of(const jigsaw::RestoredFault& fault) {
  const auto if_measured = [&](double value) { return fault.measured ? std::optional(value) : std::nullopt; };
  return {{"gap_area", "m2", if_measured(fault.opening.gap)},
          {"overlap_area", "m2", if_measured(fault.opening.overlap)},
          {"dip_restored", "deg", fault.dip},
          {"shortening", "m", fault.shortening}};
}

void add_blockwise_quantities(const Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.blockwise) return;
  const jigsaw::Blockwise& made = *model.blockwise;
  for (const balance::LineLength& row : made.lengths)
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  for (const balance::LineLength& row : totals_of(made.lengths))
    add_cells("horizon." + row.name + ".", cells_of(row), quantities);
  for (const balance::UnitRow& row : made.units) add_cells("unit." + row.name + ".", cells_of(row), quantities);
  for (const jigsaw::BlockRow& row : made.rows) {
    if (row.shift) quantities.push_back({"block." + row.name + ".shift", *row.shift, "m"});
  }
  for (const jigsaw::RestoredFault& fault : made.faults)
    add_cells("fault." + fault.name + ".", cells_of(fault), quantities);
  if (made.how.jigsaw) {
    const jigsaw::Widths& widths = made.widths;
    quantities.push_back({"width_before", widths.before, "m"});
    quantities.push_back({"width_after", widths.after, "m"});
    quantities.push_back({"shortening", widths.shortening(), "m"});
    quantities.push_back({"shortening_percent", 100.0 * widths.shortening() / widths.after, "%"});
    quantities.push_back({"shortening_by_folding", widths.folding(), "m"});
    quantities.push_back({"greatest_opening_percent", made.greatest_opening_percent, "%"});
  }
  const balance::Balance& balance = made.balance;
  quantities.push_back({"greatest_change_percent", balance.greatest_change_percent, "%"});
  quantities.push_back({"greatest_area_change_percent", balance.greatest_area_change_percent, "%"});
  quantities.push_back({"inconsistency_percent", balance.consistency.worst.percent, "%"});
  if (balance.verdict != balance::BalanceVerdict::NotJudged)
    quantities.push_back({"balanced", balance.verdict == balance::BalanceVerdict::Balanced ? 1.0 : 0.0, ""});
}

void add_blockwise_tables(const Model& model, std::vector<scenario::DataTable>& tables) {
  if (!model.blockwise) return;
  const jigsaw::Blockwise& made = *model.blockwise;
  tables.push_back(row_table("line_length", "horizon", made.lengths));
  if (const auto totals = totals_of(made.lengths); !totals.empty())
    tables.push_back(row_table("horizons_in_pieces", "horizon", totals));
  tables.push_back(row_table("units", "unit", made.units));
  scenario::DataTable blocks{"restored_blocks", {"block", "shift [m]"}, {}};
  for (const jigsaw::BlockRow& row : made.rows) {
    if (row.shift) blocks.rows.push_back({row.name, *row.shift});
  }
  tables.push_back(std::move(blocks));
  if (made.how.jigsaw) tables.push_back(row_table("restored_faults", "fault", made.faults));
}

namespace {

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
    lines.push_back({{at + geom::Vector{0.0, 0.5 * length}, at - geom::Vector{0.0, 0.5 * length}}, false});
  }
  scene::Style style;
  style.line = ink;
  style.line_width = 1.2;
  return {lines_layer("pins", translated("Pins"), style, std::move(lines))};
}

}  // namespace

void draw_blockwise(const Model& model, scene::Picture& picture) {
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

}  // namespace recon::core
