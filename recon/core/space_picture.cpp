#include "recon/core/space_picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/section_picture.h"
#include "shared/base/text.h"

namespace recon::core {

namespace loft = dobra::surf::loft;
namespace scene = dobra::scene;
using base::translated;

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
  for (std::size_t k = 0; k < placed->sections.size(); ++k) {
    const space::PlacedSection& one = placed->sections[k];
    picture.layers.push_back(curtain(fmt::format("section_{}", k), one.name, one.section, one.trace));
  }
  if (const auto* made = model.findings.get<space::MadeSurfaces>()) {
    for (std::size_t i = 0; i < made->made.surfaces.size(); ++i)
      picture.layers.push_back(surface_layer(made->made.surfaces[i], i, *placed));
  }
  if (const auto* cut = model.findings.get<space::CutSection>())
    picture.layers.push_back(curtain("cut", translated("New section"), cut->section, cut->trace));
}

}  // namespace recon::core
