#include "recon/core/move_step.h"

#include <fmt/format.h>

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "recon/core/slip_arrows.h"
#include "recon/section/section_faces.h"
#include "shared/base/text.h"
#include "shared/io/gis/geojson.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace io = dobra::io;
namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color block_color{235, 175, 60, 70};
constexpr scene::Color moving_fault_color{150, 20, 30, 255};

void add_move_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.moved) return;
  const moving::Moved& moved = *model.moved;
  quantities.push_back({"move.slip", moved.motion.slip, "m"});
  for (const auto& [name, value] : moved.motion.figures) quantities.push_back({"move." + name, value, ""});
  for (const moving::Misfit& misfit : moved.misfit) {
    const std::string prefix = "move.misfit." + misfit.horizon + '.';
    quantities.push_back({prefix + "along", misfit.along, "m"});
    quantities.push_back({prefix + "gap", misfit.gap, "m"});
    quantities.push_back({prefix + "overlap", misfit.overlap, "m"});
  }
  if (moved.whole_wall) {
    quantities.push_back({"move.gap_area", moved.opened.gap, "m2"});
    quantities.push_back({"move.overlap_area", moved.opened.overlap, "m2"});
  }
  for (const balance::LineLength& row : balance::whole_beds(moved.lengths)) {
    quantities.push_back({"horizon." + row.name + ".length_before", row.length_before, "m"});
    quantities.push_back({"horizon." + row.name + ".length_after", row.length_after, "m"});
  }
  for (const balance::UnitRow& row : moved.units) {
    quantities.push_back({"unit." + row.name + ".area_before", row.area_before, "m2"});
    quantities.push_back({"unit." + row.name + ".area_after", row.area_after, "m2"});
  }
}

void add_move_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (!model.moved) return;
  scenario::DataTable misfits{"misfit", {"horizon", "along the fault [m]", "gap [m]", "overlap [m]"}, {}};
  for (const moving::Misfit& misfit : model.moved->misfit)
    misfits.rows.push_back({misfit.horizon, misfit.along, misfit.gap, misfit.overlap});
  tables.push_back(std::move(misfits));
  scenario::DataTable moved{"moved", {"name", "kind", "x [m]", "z [m]"}, {}};
  for (const moving::MovedPiece& piece : model.moved->pieces) {
    for (const geom::Point p : piece.after.points) moved.rows.push_back({piece.name, piece.kind, p.x, p.y});
  }
  tables.push_back(std::move(moved));
}

void add_move_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (model.moved) append(model.moved->remarks, remarks);
}

void add_move_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->moved) return;
  outputs.push_back({"moved.geojson", [model](const std::filesystem::path& path) {
                       return io::gis::write_geojson(path.string(), restored_features(model->moved->section));
                     }});
}

/// The polygons, or without any what lies between two horizons.
std::vector<scene::Layer> rock(const section::Section& section, const section::Palette& palette) {
  if (!section.units.empty()) return filled_units(section, palette);
  std::vector<scene::Layer> layers;
  const auto faces = section.faces ? base::Result<section::SectionFaces>(*section.faces) : faces_of(section);
  for (const section::RockUnit& unit : faces ? faces->units : std::vector<section::RockUnit>{}) {
    if (!unit.top || !unit.base) continue;
    const std::string& name = whole_name(section.horizons[*unit.top]);
    layers.push_back(region_layer(fmt::format("unit_{}", layers.size()), unit.name, palette.of(name), {}));
    layers.back().legend = name;
    std::get<scene::Regions>(layers.back().content).regions = {scene::Region{unit.contours}};
  }
  return over_backdrops(section, std::move(layers));
}

/// The part of an area on one side of a line: where `inside` is not below 0.
template <class Inside>
geom::Polyline cut_off(const geom::Polyline& area, const Inside& inside) {
  geom::Polyline kept{{}, true};
  for (std::size_t i = 0; i < area.segment_count(); ++i) {
    const auto [from, to] = area.segment(i);
    const double a = inside(from), b = inside(to);
    if (a >= 0.0) kept.points.push_back(from);
    if ((a >= 0.0) != (b >= 0.0)) kept.points.push_back(geom::interpolate(from, to, a / (a - b)));
  }
  return kept;
}

/// Areas within a box, for pictures: blocks go on far beyond the rock.
std::vector<geom::Polyline> within(const geom::Box& box, std::vector<geom::Polyline> areas) {
  for (geom::Polyline& area : areas) {
    area = cut_off(area, [&](geom::Point p) { return p.x - box.low.x; });
    area = cut_off(area, [&](geom::Point p) { return box.high.x - p.x; });
    area = cut_off(area, [&](geom::Point p) { return p.y - box.low.y; });
    area = cut_off(area, [&](geom::Point p) { return box.high.y - p.y; });
  }
  std::erase_if(areas, [](const geom::Polyline& area) { return area.points.size() < 3; });
  return areas;
}

/// What moves, and the fault that it moves along.
void add_block(const moving::MovingPart& part, const section::Section& section, const std::string& fault,
               PanelParts& parts) {
  scene::Style style;
  style.fill = block_color;
  style.line_width = 0.0;
  if (!part.contours().empty()) {
    parts.under.push_back({"block", translated("Block that moves"), style,
                           scene::Regions{{{within(box_of(section), part.contours())}}, {}}, true,
                           scene::InLegend::Yes});
  }
  scene::Style bold;
  bold.line = moving_fault_color;
  bold.line_width = 3.0;
  std::vector<geom::Polyline> lines;
  for (const section::SectionLine& line : section.lines) {
    if (line.kind == section::LineKind::Fault && (line.name == fault || whole_name(line) == fault))
      lines.push_back(line.line);
  }
  parts.grid.push_back(lines_layer("moving_fault", translated("Fault of the move"), bold, std::move(lines)));
}

scene::Panel moved_panel(const model::Model& model) {
  const moving::Moved& moved = *model.moved;
  const section::Palette palette(moved.section);
  PanelParts parts;
  parts.under = rock(moved.section, palette);
  add_block(moved.after, moved.section, moved.params.fault, parts);
  return section_panel(empty_panel("moved", translated("Section after the move"), model.section), moved.section,
                       palette, std::move(parts));
}

/// Both states to one scale.
void draw_moved(const model::Model& model, scene::Picture& picture) {
  if (!model.moved) return;
  const section::Palette palette(model.section);
  PanelParts parts;
  parts.under = rock(model.section, palette);
  add_block(model.moved->before, model.section, model.moved->params.fault, parts);
  if (const double slip = model.moved->motion.slip; slip != 0.0) {
    parts.pin.push_back(slip_arrows("slip", model.moved->fault, slip > 0.0 ? SlipSign::Up : SlipSign::Down,
                                    box_of(model.section).diagonal()));
  }
  std::vector<scene::Panel> panels{current_panel(model, palette, std::move(parts)), moved_panel(model)};
  geom::Box box = box_of(model.section);
  box.add(box_of(model.moved->section));
  for (scene::Panel& panel : panels) panel.extent = box.grown(0.04 * box.diagonal());
  show(std::move(panels), model.section, picture);
}

}  // namespace

base::Result<model::Model> run_move(const model::Model& model, const moving::MoveParams& params,
                                    const scenario::Context&, const base::Progress& progress) {
  DOBRA_TRY(model::Model next, next_stage(model));
  next.findings.forget_after(next.earlier.size());
  DOBRA_TRY(next.moved, move_block(next.section, params, progress));
  return next;
}

scenario::Operation move_step() {
  return scenario::make_operation<model::Model, moving::MoveParams>(
      "move", "Move on fault", "Moves blocks along a fault, back to an earlier state or on to a later one.", run_move,
      {.quantities = add_move_quantities,
       .tables = add_move_tables,
       .remarks = add_move_remarks,
       .outputs = add_move_outputs,
       .draw = draw_moved});
}

}  // namespace recon::core
