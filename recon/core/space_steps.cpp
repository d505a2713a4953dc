#include "recon/core/space_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recon/core/report.h"
#include "recon/core/section_picture.h"
#include "recon/space/surface_file.h"
#include "shared/base/finding_text.h"
#include "shared/base/text.h"
#include "shared/io/formats/line_files.h"

namespace recon::core {

namespace io = dobra::io;
namespace loft = dobra::surf::loft;
namespace scenario = dobra::scenario;
namespace scene = dobra::scene;
using base::translated;

// --- surface

namespace {

const space::MadeSurfaces* surfaces_of(const model::Model& model) { return model.findings.get<space::MadeSurfaces>(); }

double greatest_mistie(const space::SurfaceRow& row) {
  double most = 0.0;
  for (const loft::Mistie& mistie : row.misties) most = std::max(most, std::abs(mistie.difference));
  return most;
}

void add_surface_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* made = surfaces_of(model);
  if (made == nullptr) return;
  quantities.push_back({"surfaces", count_of(made->rows.size()), ""});
  for (const space::SurfaceRow& row : made->rows) {
    const std::string prefix = "surface." + row.name + ".";
    quantities.push_back({prefix + "area", row.measures.area, "m2"});
    quantities.push_back({prefix + "dip_mean", row.measures.dip_mean.degrees(), "deg"});
    quantities.push_back({prefix + "pieces", count_of(row.pieces), ""});
    quantities.push_back({prefix + "greatest_mistie", greatest_mistie(row), "m"});
  }
  for (const space::VolumeRow& row : made->volumes)
    quantities.push_back({fmt::format("between.{}.{}.volume", row.upper, row.lower), row.volume.value, "m3"});
}

void add_surface_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto* made = surfaces_of(model);
  if (made == nullptr) return;
  scenario::DataTable surfaces{
      "surfaces", {"surface", "kind", "area [m2]", "area on the map [m2]", "mean dip [deg]", "pieces"}, {}};
  scenario::DataTable misties{"misties", {"line", "section", "other section", "x [m]", "y [m]", "difference [m]"}, {}};
  scenario::DataTable volumes{"volumes", {"upper", "lower", "volume [m3]", "area on the map [m2]"}, {}};
  for (const space::SurfaceRow& row : made->rows)
    surfaces.rows.push_back({row.name, std::string(loft::kind_name(row.kind)), row.measures.area, row.measures.plan,
                             row.measures.dip_mean.degrees(), count_of(row.pieces)});
  for (const loft::Mistie& m : made->made.misties)
    misties.rows.push_back(
        {m.line, made->made.sections[m.first].name, made->made.sections[m.second].name, m.at.x, m.at.y, m.difference});
  for (const space::VolumeRow& row : made->volumes)
    volumes.rows.push_back({row.upper, row.lower, row.volume.value, row.volume.plan});
  tables.push_back(std::move(surfaces));
  if (!misties.rows.empty()) tables.push_back(std::move(misties));
  if (!volumes.rows.empty()) tables.push_back(std::move(volumes));
}

/// A line each, with its place.
std::vector<std::string> surface_remarks(const std::vector<loft::Finding>& findings) {
  std::vector<std::string> remarks;
  for (const loft::Finding& finding : findings) remarks.push_back(base::line_of(finding));
  return remarks;
}

void add_surface_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* made = surfaces_of(model)) append(surface_remarks(made->made.findings), remarks);
}

std::vector<io::lines::Feature> contour_features(const space::MadeSurfaces& made) {
  std::vector<io::lines::Feature> features;
  for (std::size_t i = 0; i < made.contours.size(); ++i) {
    for (const loft::Contour& contour : made.contours[i]) {
      io::lines::Feature feature;
      feature.name = fmt::format("{} {:g} m", made.rows[i].name, contour.level);
      feature.kind = "contour";
      for (const auto& line : contour.lines) {
        geom::Polyline& part = feature.parts.emplace_back();
        std::vector<double>& heights = feature.heights.emplace_back();
        for (const geom::Point3 p : line) {
          if (!part.points.empty() && part.points.back() == geom::Point{p.x, p.y}) continue;
          part.points.push_back({p.x, p.y});
          heights.push_back(contour.level);
        }
        if (part.points.size() < 2) feature.parts.pop_back(), feature.heights.pop_back();
      }
      if (!feature.parts.empty()) features.push_back(std::move(feature));
    }
  }
  return features;
}

void add_surface_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  const auto* made = surfaces_of(*model);
  if (made == nullptr) return;
  outputs.push_back({"surfaces.ts", [model](const std::filesystem::path& path) {
                       return space::write_surfaces(path.string(), *surfaces_of(*model));
                     }});
  if (made->contours.empty()) return;
  outputs.push_back({"contours.geojson", [model](const std::filesystem::path& path) -> base::Result<void> {
                       io::formats::LineWork work;
                       work.features = contour_features(*surfaces_of(*model));
                       std::vector<std::string> losses;
                       return io::formats::write_any_lines(path.string(), work, {}, losses);
                     }});
}

}  // namespace

base::Result<model::Model> run_surface(const model::Model& model, const space::SurfaceParams& params,
                                       const scenario::Context&, const base::Progress& progress) {
  const auto* placed = model.findings.get<space::PlacedSections>();
  if (placed == nullptr)
    return base::Error{base::ErrorCode::CannotRestore,
                       "the document holds one section; name several in [[input.section]], each with its file and its "
                       "trace"};
  model::Model next = model;
  DOBRA_TRY(space::MadeSurfaces made, make_surfaces(*placed, params, progress));
  next.findings.set(std::move(made), {});
  return next;
}

scenario::Operation surface_step() {
  return scenario::make_operation<model::Model, space::SurfaceParams>(
      "surface", "Surfaces", "Horizons and faults as surfaces through equally named lines of several sections.",
      run_surface,
      {.quantities = add_surface_quantities,
       .tables = add_surface_tables,
       .remarks = add_surface_remarks,
       .outputs = add_surface_outputs});
}

// --- cut

namespace {

void add_cut_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  const auto* cut = model.findings.get<space::CutSection>();
  if (cut == nullptr) return;
  quantities.push_back({"cut.length", cut->trace.length(), "m"});
  quantities.push_back({"cut.horizons", count_of(cut->section.horizons.size()), ""});
}

void add_cut_remarks(const model::Model& model, std::vector<std::string>& remarks) {
  if (const auto* cut = model.findings.get<space::CutSection>()) append(surface_remarks(cut->findings), remarks);
}

void add_cut_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (model->findings.get<space::CutSection>() == nullptr) return;
  outputs.push_back({"section.toml", [model](const std::filesystem::path& path) {
                       const auto* cut = model->findings.get<space::CutSection>();
                       return scenario::write_document(document_of(*cut, "Section cut from surfaces"), path);
                     }});
}

}  // namespace

scenario::Document document_of(const space::CutSection& cut, const std::string& title) {
  scenario::Document document;
  document.program = "recon";
  document.title = title;
  document.input = cut.input;
  return document;
}

base::Result<model::Model> run_cut(const model::Model& model, const space::CutParams& params, const scenario::Context&,
                                   const base::Progress&) {
  const auto* surfaces = model.findings.get<space::MadeSurfaces>();
  if (surfaces == nullptr)
    return base::Error{base::ErrorCode::CannotRestore, "there are no surfaces yet; put a step 'surface' before it"};
  DOBRA_TRY(space::CutSection cut, cut_section(*surfaces, params));
  model::Model next;
  next.findings = model.findings;
  next.remarks = model.remarks;
  append(cut.remarks, next.remarks);
  next.section = cut.section;
  next.findings.set(std::move(cut), {});
  return next;
}

scenario::Operation cut_step() {
  return scenario::make_operation<model::Model, space::CutParams>(
      "cut", "Cut a section", "A new section where a trace crosses the surfaces; the steps behind work on it.", run_cut,
      {.quantities = add_cut_quantities, .remarks = add_cut_remarks, .outputs = add_cut_outputs});
}

// --- pictures

namespace {

scene::Panel panel_of(const std::string& key, const std::string& title, const section::Section& section) {
  const section::Palette palette(section);
  PanelParts parts;
  parts.under = filled_units(section, palette);
  return section_panel(empty_panel(key, title, section), section, palette, std::move(parts));
}

scene::space::Layer curtain(const std::string& key, const std::string& title, const section::Section& section,
                            const loft::PlanTrace& trace) {
  scene::space::Layer layer;
  layer.key = key;
  layer.title = title;
  layer.content = scene::space::Curtain{trace.corners(), 0.0, panel_of(key, title, section)};
  layer.in_legend = scene::InLegend::No;
  return layer;
}

/// Where surfaces go through the lines, the legend has their names, and a name of a line that a surface hides would
/// stand before it. The curtain has a name of its own there, at the right end of its highest horizon.
void call_section(scene::space::Layer& curtain, const section::Section& section) {
  scene::Panel& panel = std::get<scene::space::Curtain>(curtain.content).section;
  std::erase_if(panel.layers, [](const scene::Layer& layer) {
    return std::holds_alternative<scene::Labels>(layer.content) && layer.key.starts_with("name_");
  });
  std::optional<geom::Point> at;
  for (const section::Horizon& horizon : section.horizons) {
    const geom::Point end = horizon.line.points.back();
    if (!at || end.x > at->x || (end.x == at->x && end.y > at->y)) at = end;
  }
  if (!at) return;
  scene::Style style;
  style.line = {38, 50, 56, 255};
  style.text_size = 8.0;
  panel.layers.push_back({"name_of_section", curtain.title, style,
                          scene::Labels{{{*at, curtain.title, scene::Anchor::Centre}}}, true, scene::InLegend::No});
}

/// The colour of a horizon is that of the first section that has it.
scene::Color color_of(const loft::NamedSurface& surface, const space::PlacedSections& placed) {
  if (surface.kind == loft::LineKind::Fault) return {176, 42, 42, 255};
  for (const space::PlacedSection& one : placed.sections) {
    const auto& horizons = one.section.horizons;
    const bool has = std::any_of(horizons.begin(), horizons.end(),
                                 [&](const section::Horizon& h) { return whole_name(h) == surface.name; });
    if (has) return section::Palette(one.section).of(surface.name).fill;
  }
  return {150, 150, 150, 255};
}

scene::space::Layer surface_layer(const loft::NamedSurface& surface, std::size_t number,
                                  const space::PlacedSections& placed) {
  std::vector<geom::Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const loft::Patch& patch : surface.patches) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), patch.points.begin(), patch.points.end());
    for (const auto& t : patch.triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  scene::space::Layer layer;
  layer.key = fmt::format("surface_{}", number);
  layer.title = surface.name;
  layer.style.fill = color_of(surface, placed);
  layer.style.line_width = 0.0;
  scene::space::Surface content;
  content.points = std::move(points);
  content.triangles = std::move(triangles);
  layer.content = std::move(content);
  return layer;
}

}  // namespace

void draw_placed(const model::Model& model, scene::Picture& picture) {
  const auto* placed = model.findings.get<space::PlacedSections>();
  if (placed == nullptr || model.findings.get<space::CutSection>() != nullptr) return;
  std::vector<scene::Panel> panels;
  for (std::size_t k = 0; k < placed->sections.size(); ++k) {
    const space::PlacedSection& one = placed->sections[k];
    panels.push_back(panel_of(fmt::format("section_{}", k), one.name, one.section));
  }
  show(std::move(panels), placed->sections.front().section, picture);
}

void draw_placed_in_space(const model::Model& model, scene::space::SpacePicture& picture) {
  const auto* placed = model.findings.get<space::PlacedSections>();
  if (placed == nullptr) return;
  picture.camera = scene::space::camera_of(scene::space::StandardView::Isometric);
  const bool surfaces = model.findings.get<space::MadeSurfaces>() != nullptr;
  for (std::size_t k = 0; k < placed->sections.size(); ++k) {
    const space::PlacedSection& one = placed->sections[k];
    picture.layers.push_back(curtain(fmt::format("section_{}", k), one.name, one.section, one.trace));
    if (surfaces) call_section(picture.layers.back(), one.section);
  }
  if (const auto* made = model.findings.get<space::MadeSurfaces>()) {
    for (std::size_t i = 0; i < made->made.surfaces.size(); ++i)
      picture.layers.push_back(surface_layer(made->made.surfaces[i], i, *placed));
  }
  const auto* cut = model.findings.get<space::CutSection>();
  if (cut == nullptr) return;
  picture.layers.push_back(curtain("cut", translated("New section"), cut->section, cut->trace));
  call_section(picture.layers.back(), cut->section);
  if (!is_done(model)) return;
  scene::space::Layer after = curtain("restored", translated("Restored section"), current_section(model), cut->trace);
  after.visible = false;  // it would stand in the one before
  picture.layers.push_back(std::move(after));
}

}  // namespace recon::core
