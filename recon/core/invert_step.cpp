#include "recon/core/invert_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "shared/base/text.h"

namespace recon::core {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using base::translated;

namespace {

constexpr scene::Color found_color{150, 20, 30, 255};

const inversion::Inversion* inversion_of(const model::Model& model) {
  const auto* found = model.findings.get<FoundKinematics>();
  return found == nullptr ? nullptr : &found->inversion;
}

std::vector<RowCell> estimate_cells(const inversion::Estimate& estimate) {
  return {{"best", "", estimate.best},
          {"low", "", estimate.low},
          {"high", "", estimate.high},
          {"from", "", estimate.unknown.low},
          {"to", "", estimate.unknown.high}};
}

std::vector<RowCell> bed_cells(const inversion::BedMisfit& bed) {
  return {{"points", "", count_of(bed.points)}, {"rms_before", "m", bed.before},
          {"rms_restored", "m", bed.after},     {"dip_restored", "deg", bed.dip.degrees()},
          {"correlation", "", bed.correlation}, {"correlation_length", "m", bed.correlation_length}};
}

void add_inversion_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const inversion::Inversion* found = inversion_of(model);
  if (found == nullptr) return;
  for (const inversion::Estimate& estimate : found->fit.estimates) {
    const std::string name = "invert." + estimate.unknown.key;
    quantities.push_back({name, estimate.best, estimate.unknown.unit});
    if (estimate.low) quantities.push_back({name + ".low", *estimate.low, estimate.unknown.unit});
    if (estimate.high) quantities.push_back({name + ".high", *estimate.high, estimate.unknown.unit});
  }
  quantities.push_back({"invert.misfit", found->fit.rms, "m"});
  quantities.push_back({"invert.misfit_before", found->fit.before, "m"});
  if (found->fit.region) quantities.push_back({"invert.misfit_region", *found->fit.region, "m"});
  for (const inversion::BedMisfit& bed : found->fit.beds)
    quantities.push_back({"invert.misfit." + bed.name, bed.after, "m"});
}

std::string axis_title(const inversion::MisfitMap& map, const inversion::Fit& fit, std::size_t axis) {
  const inversion::Unknown& unknown = fit.estimates[map.axes[axis]].unknown;
  return unknown.unit.empty() ? unknown.key : fmt::format("{} [{}]", unknown.key, unknown.unit);
}

scenario::DataTable map_table(const inversion::MisfitMap& map, const inversion::Fit& fit) {
  scenario::DataTable table{"misfit_map", {axis_title(map, fit, 0), axis_title(map, fit, 1), "misfit [m]"}, {}};
  for (std::size_t i = 0; i < map.rms.size(); ++i)
    table.rows.push_back({map.at[0][i % map.at[0].size()], map.at[1][i / map.at[0].size()], map.rms[i]});
  return table;
}

void add_inversion_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const inversion::Inversion* found = inversion_of(model);
  if (found == nullptr) return;
  scenario::DataTable values = table_of_cells("kinematics", "value", estimate_cells({}));
  for (const inversion::Estimate& estimate : found->fit.estimates)
    add_row(estimate.unknown.key, estimate_cells(estimate), values);
  scenario::DataTable beds = table_of_cells("bed_misfits", "bed", bed_cells({}));
  for (const inversion::BedMisfit& bed : found->fit.beds) add_row(bed.name, bed_cells(bed), beds);
  tables.push_back(std::move(values));
  tables.push_back(std::move(beds));
  if (found->map) tables.push_back(map_table(*found->map, found->fit));
}

void add_inversion_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const inversion::Inversion* found = inversion_of(model)) append(found->remarks, remarks);
}

/// The section with the ramp and the triangle that were found.
scene::Panel kinematics_panel(const FoundKinematics& found, const section::Palette& palette) {
  PanelParts parts;
  parts.under = filled_units(found.section, palette);
  scene::Style bold;
  bold.line = found_color;
  bold.line_width = 2.5;
  scene::Style dashed = bold;
  dashed.line_width = 1.0;
  dashed.dash = scene::Dash::Dashed;
  if (!found.inversion.fault.points.empty())
    parts.pin.push_back(lines_layer("found_ramp", translated("Ramp found"), bold, {found.inversion.fault}));
  if (!found.inversion.triangle.empty())
    parts.pin.push_back(lines_layer("found_triangle", translated("Trishear zone"), dashed, found.inversion.triangle));
  return section_panel(empty_panel("kinematics", translated("Kinematics found"), found.section), found.section, palette,
                       std::move(parts));
}

/// The beds taken back.
scene::Panel restored_panel(const FoundKinematics& found, const section::Palette& palette) {
  section::Section restored;
  restored.convention = found.section.convention;
  restored.left_end = found.section.left_end;
  restored.right_end = found.section.right_end;
  for (std::size_t i = 0; i < found.inversion.restored.size(); ++i) {
    const section::Horizon* horizon = find_horizon(found.section, found.inversion.restored_names[i]);
    restored.horizons.push_back(*horizon);
    restored.horizons.back().line = found.inversion.restored[i];
  }
  return section_panel(empty_panel("restored_beds", translated("Beds restored"), restored), restored, palette, {});
}

/// The map as a mesh, two triangles a cell. What has no map has the highest value.
scene::Mesh map_mesh(const inversion::MisfitMap& map, double unit, double low, double high) {
  scene::Mesh mesh;
  mesh.values_at = scene::ValuesAt::Points;
  const std::size_t columns = map.at[0].size();
  for (std::size_t i = 0; i < map.rms.size(); ++i) {
    mesh.points.push_back({unit * map.at[0][i % columns], unit * map.at[1][i / columns]});
    mesh.values.push_back(std::isfinite(map.rms[i]) ? map.rms[i] : high);
    if (i % columns + 1 == columns || i / columns + 1 == map.at[1].size()) continue;
    const auto n = static_cast<std::uint32_t>(i);
    const auto w = static_cast<std::uint32_t>(columns);
    mesh.triangles.push_back({n, n + 1, n + w + 1});
    mesh.triangles.push_back({n, n + w + 1, n + w});
  }
  mesh.scale = {translated("misfit [m]"), scene::ColorMapName::Viridis, low, high};
  return mesh;
}

/// Where the values of a mesh pass a level.
std::vector<geom::Polyline> contour_at(const scene::Mesh& mesh, double level) {
  std::vector<geom::Polyline> lines;
  for (const auto& triangle : mesh.triangles) {
    geom::Polyline line;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      if ((mesh.values[a] < level) == (mesh.values[b] < level)) continue;
      const double t = (level - mesh.values[a]) / (mesh.values[b] - mesh.values[a]);
      line.points.push_back(geom::interpolate(mesh.points[a], mesh.points[b], t));
    }
    if (line.points.size() == 2) lines.push_back(std::move(line));
  }
  return lines;
}

/// The misfit over two values, as wide as a part of the section and nearly as high as wide; with the best place and the
/// region of confidence.
scene::Panel map_panel(const inversion::MisfitMap& map, const inversion::Fit& fit, double section_width) {
  const double width = map.at[0].back() - map.at[0].front();
  const double height = map.at[1].back() - map.at[1].front();
  const double unit = 0.6 * section_width / width;
  double low = fit.rms, high = fit.rms;
  for (const double rms : map.rms) {
    if (std::isfinite(rms)) low = std::min(low, rms), high = std::max(high, rms);
  }
  high = std::min(high, std::max(map.region, low) * 3.0);
  scene::Panel panel;
  panel.key = "misfit_map";
  panel.title = translated("Misfit");
  panel.axes = {axis_title(map, fit, 0), axis_title(map, fit, 1), scene::AxisScale::Diagram, unit};
  panel.vertical_exaggeration = 0.8 * width / height;
  scene::Mesh mesh = map_mesh(map, unit, low, high);
  scene::Style line;
  line.line = {255, 255, 255, 255};
  line.line_width = 1.5;
  const std::vector<geom::Polyline> region = contour_at(mesh, map.region);
  scene::Style filled;
  filled.line_width = 0.0;
  panel.layers.push_back({"misfit", translated("Misfit"), filled, std::move(mesh), true, scene::InLegend::No});
  if (!region.empty()) {
    panel.layers.push_back(lines_layer("region", translated("Region of confidence"), line, std::move(region)));
    panel.layers.back().in_legend = scene::InLegend::No;
  }
  scene::Style mark;
  mark.line = found_color;
  mark.fill = found_color;
  mark.marker_size = 7.0;
  const geom::Point best{unit * fit.estimates[map.axes[0]].best, unit * fit.estimates[map.axes[1]].best};
  panel.layers.push_back({"best", translated("Best"), mark, scene::Markers{{best}, {}}, true, scene::InLegend::Yes});
  return panel;
}

void draw_inversion(const model::Model& model, scene::Picture& picture) {
  const auto* found = model.findings.get<FoundKinematics>();
  if (found == nullptr || is_done(model)) return;
  const section::Palette palette(found->section);
  std::vector<scene::Panel> panels{kinematics_panel(*found, palette), restored_panel(*found, palette)};
  if (found->inversion.map) {
    const double width = box_of(found->section).width();
    panels.push_back(map_panel(*found->inversion.map, found->inversion.fit, width));
  }
  show(std::move(panels), found->section, picture);
}

}  // namespace

base::Result<model::Model> run_invert(const model::Model& model, const inversion::InvertParams& params,
                                      const scenario::Context&, const base::Progress& progress) {
  FoundKinematics found;
  found.section = current_section(model);
  DOBRA_TRY(found.inversion, inversion::invert(found.section, params, progress));
  model::Model next = model;
  const std::size_t state = model.earlier.size() + (is_done(model) ? 1U : 0U);
  next.findings.set(std::move(found), {.state = state, .outlives = model::Outlives::Nothing});
  return next;
}

scenario::Operation invert_step() {
  return scenario::make_operation<model::Model, inversion::InvertParams>(
      "invert", "Kinematics from beds",
      "Finds the values of trishear, or of inclined shear, that take the beds of a fold back to straight lines best.",
      run_invert,
      {.quantities = add_inversion_quantities,
       .tables = add_inversion_tables,
       .remarks = add_inversion_remarks,
       .draw = draw_inversion});
}

}  // namespace recon::core
