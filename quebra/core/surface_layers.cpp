#include "quebra/core/surface_layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "quebra/core/layers.h"
#include "quebra/model/mesh_files.h"
#include "shared/base/text.h"
#include "shared/mesh/quality.h"
#include "shared/scene/color_map.h"
#include "shared/surf/measure.h"

namespace quebra::core {

using namespace dobra;
using base::translated;

namespace {

std::size_t quadrilaterals_of(const mesh::ElementMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.types.begin(), mesh.types.end(),
                                                [](mesh::ElementType type) { return mesh::corner_count(type) == 4; }));
}

void add_quality(std::vector<scenario::Quantity>& quantities, const std::string& prefix,
                 const model::SurfaceMeshed& meshed) {
  const auto add = [&](const char* name, double value, const char* unit = "") {
    quantities.push_back({prefix + name, value, unit});
  };
  const auto& quality = meshed.quality;
  add("elements", static_cast<double>(meshed.elements.mesh.element_count()));
  add("quadrilaterals", static_cast<double>(quadrilaterals_of(meshed.elements.mesh)));
  add("nodes", static_cast<double>(meshed.elements.mesh.points.size()));
  add("area", quality.area, "m2");
  add("area_surface", meshed.area_surface, "m2");
  add("alpha_mean", quality.alpha_mean);
  add("alpha_90", 100.0 * quality.alpha_90, "%");
  add("alpha_min", quality.alpha_min);
  add("min_angle", quality.angle_min.degrees(), "deg");
  add("max_angle", quality.angle_max.degrees(), "deg");
  add("side_min", quality.side_min, "m");
  add("side_max", quality.side_max, "m");
  add("euler", static_cast<double>(quality.euler));
  add("loops", static_cast<double>(quality.loops));
}

/// The alpha of every triangle, in space.
std::vector<double> alphas(const surf::mesh::SurfaceMesh& mesh) {
  std::vector<double> values;
  for (const auto& corners : mesh.triangles) {
    const geom::Point3 a = mesh.point(corners[0]), b = mesh.point(corners[1]), c = mesh.point(corners[2]);
    const double sides = dot(b - a, b - a) + dot(c - b, c - b) + dot(a - c, a - c);
    values.push_back(sides > 0.0 ? 2.0 * std::sqrt(3.0) * length(cross(b - a, c - a)) / sides : 0.0);
  }
  return values;
}

}  // namespace

std::vector<surf::mesh::Finding> findings_of(const model::Model& model) {
  std::vector<surf::mesh::Finding> all = model.surface_findings;
  if (!model.surface_meshes.empty()) {
    const auto& last = model.surface_meshes.back()->findings;
    all.insert(all.end(), last.begin(), last.end());
  }
  return all;
}

namespace {

/// A chart stretched so that its middle lines are as long as in space: places of all charts can be drawn to one scale.
class DrawnChart {
 public:
  explicit DrawnChart(const surf::Surface& surface) : low_(surface.chart().low) {
    const geom::Box& box = surface.chart();
    const geom::Point middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
    u_ = surf::length(surface, {box.low.x, middle.y}, {box.high.x, middle.y}) / box.width();
    v_ = surf::length(surface, {middle.x, box.low.y}, {middle.x, box.high.y}) / box.height();
  }
  [[nodiscard]] geom::Point at(geom::Point uv) const { return {u_ * (uv.x - low_.x), v_ * (uv.y - low_.y)}; }

 private:
  geom::Point low_;
  double u_ = 1.0, v_ = 1.0;
};

constexpr scene::Color chart_crack_red{198, 40, 40};
constexpr scene::Color chart_mesh_line{55, 71, 79, 150};
constexpr int samples_an_edge = 96;

geom::Polyline drawn(const surf::trim::ChartEdge& edge, const DrawnChart& chart) {
  geom::Polyline line;
  for (int i = 0; i <= samples_an_edge; ++i) {
    const double part = static_cast<double>(i) / samples_an_edge;
    line.points.push_back(chart.at(edge.at(edge.from + part * (edge.to - edge.from))));
  }
  return line;
}

void add_lines(const surf::trim::TrimmedSurface& face, const DrawnChart& chart, std::vector<scene::Layer>& layers) {
  scene::Lines borders, inner, cracks;
  for (const auto& loop : face.loops) {
    for (const auto& edge : loop.edges) borders.lines.push_back(drawn(edge, chart));
  }
  for (const auto& line : face.lines) {
    auto& to = line.kind == surf::trim::ChartLine::Kind::Crack ? cracks : inner;
    for (const auto& edge : line.edges) to.lines.push_back(drawn(edge, chart));
  }
  const auto add = [&](const char* key, std::string title, const scene::Style& style, scene::Lines lines) {
    if (!lines.lines.empty()) layers.push_back({key, std::move(title), style, std::move(lines)});
  };
  add("boundary", translated("Boundary"), {.line = ink, .line_width = boundary_width}, std::move(borders));
  add("internal", translated("Internal lines"), {.line = ink, .line_width = 1.0}, std::move(inner));
  add("cracks", translated("Cracks"), {.line = chart_crack_red, .line_width = 1.8}, std::move(cracks));
}

scene::Layer mesh_layer(const model::SurfaceMeshed& meshed, std::size_t face, const DrawnChart& chart) {
  scene::Mesh content;
  content.values_at = scene::ValuesAt::Triangles;
  const std::vector<double> values = alphas(meshed.mesh);
  for (std::size_t t = 0; t < values.size(); ++t) {
    if (meshed.mesh.faces[t] != face) continue;
    const auto first = static_cast<std::uint32_t>(content.points.size());
    for (const geom::Point uv : meshed.mesh.places[t]) content.points.push_back(chart.at(uv));
    content.triangles.push_back({first, first + 1, first + 2});
    content.values.push_back(values[t]);
  }
  content.scale = {translated("quality alpha"), scene::ColorMapName::Quality, 0.5, 1.0};
  return {"mesh",
          translated("Mesh"),
          {.line = chart_mesh_line, .line_width = values.size() > 20000 ? 0.1 : 0.35},
          std::move(content),
          true,
          scene::InLegend::No};
}

}  // namespace

void draw_surfaces(const model::Model& model, scene::Picture& picture) {
  constexpr std::size_t most_charts = 4;
  picture.arrangement = scene::Arrangement::Grid;
  const auto& faces = model.surfaces->faces;
  for (std::size_t f = 0; f < std::min(faces.size(), most_charts); ++f) {
    const DrawnChart chart(faces[f].surface);
    scene::Panel panel{.key = fmt::format("chart_{}", f + 1), .title = {}, .axes = {}, .layers = {}};
    panel.title = fmt::format("{}: {}", translated("Chart"), faces[f].name);
    panel.axes.x_title = translated("u, by the length in the middle [m]");
    panel.axes.y_title = translated("v, by the length in the middle [m]");
    if (!model.surface_meshes.empty()) panel.layers.push_back(mesh_layer(*model.surface_meshes.back(), f, chart));
    add_lines(faces[f], chart, panel.layers);
    picture.panels.push_back(std::move(panel));
  }
}

namespace {

scene::space::Layer space_mesh(const model::SurfaceMeshed& meshed) {
  scene::space::Surface content;
  std::vector<geom::Point3> points;
  std::vector<geom::Point> chart;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> ids;
  // A corner each, so that every one has its place in the chart of its face.
  for (std::size_t t = 0; t < meshed.mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::size_t i = 0; i < 3; ++i) {
      points.push_back(meshed.mesh.point(meshed.mesh.triangles[t][i]));
      chart.push_back(meshed.mesh.places[t][i]);
    }
    triangles.push_back({first, first + 1, first + 2});
    ids.push_back(meshed.mesh.faces[t]);
  }
  content.points = std::move(points), content.chart = std::move(chart), content.triangles = std::move(triangles);
  content.ids = std::move(ids);
  content.values_at = scene::ValuesAt::Triangles;
  content.values = alphas(meshed.mesh);
  content.scale = {translated("quality alpha"), scene::ColorMapName::Quality, 0.5, 1.0};
  const bool many = meshed.mesh.triangles.size() > 20000;
  return {"mesh",
          translated("Mesh"),
          {.line = chart_mesh_line, .line_width = many ? 0.0 : 0.35},
          std::move(content),
          true,
          scene::InLegend::No,
          {}};
}

std::vector<geom::Point3> in_space(const surf::trim::ChartEdge& edge, const surf::Surface& surface) {
  std::vector<geom::Point3> line;
  for (int i = 0; i <= samples_an_edge; ++i) {
    const double part = static_cast<double>(i) / samples_an_edge;
    line.push_back(surface.at(edge.at(edge.from + part * (edge.to - edge.from))));
  }
  return line;
}

}  // namespace

void draw_surfaces_in_space(const model::Model& model, scene::space::SpacePicture& picture) {
  if (!model.surfaces) return;
  std::vector<std::vector<geom::Point3>> borders, inner, cracks;
  for (const auto& face : model.surfaces->faces) {
    for (const auto& loop : face.loops) {
      for (const auto& edge : loop.edges) borders.push_back(in_space(edge, face.surface));
    }
    for (const auto& line : face.lines) {
      auto& to = line.kind == surf::trim::ChartLine::Kind::Crack ? cracks : inner;
      for (const auto& edge : line.edges) to.push_back(in_space(edge, face.surface));
    }
  }
  if (!model.surface_meshes.empty()) picture.layers.push_back(space_mesh(*model.surface_meshes.back()));
  const auto add = [&](const char* key, std::string title, const scene::Style& style,
                       std::vector<std::vector<geom::Point3>> lines) {
    if (lines.empty()) return;
    scene::space::Lines content;
    content.lines = std::move(lines);
    picture.layers.push_back({key, std::move(title), style, std::move(content), true, scene::InLegend::Yes, {}});
  };
  add("boundary", translated("Boundary"), {.line = ink, .line_width = boundary_width}, std::move(borders));
  add("internal", translated("Internal lines"), {.line = ink, .line_width = 1.0}, std::move(inner));
  add("cracks", translated("Cracks"), {.line = chart_crack_red, .line_width = 1.8}, std::move(cracks));
  picture.camera = scene::space::camera_of(scene::space::StandardView::Isometric);
}

void add_surface_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  quantities.push_back({"faces", static_cast<double>(model.surfaces->faces.size()), ""});
  quantities.push_back({"findings", static_cast<double>(findings_of(model).size()), ""});
  if (!model.surface_meshes.empty()) add_quality(quantities, "", *model.surface_meshes.back());
  for (std::size_t i = 0; i < model.surface_meshes.size(); ++i)
    add_quality(quantities, fmt::format("mesh.{}.", i + 1), *model.surface_meshes[i]);
}

void add_surface_finding_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  const auto findings = findings_of(model);
  if (findings.empty()) return;
  scenario::DataTable table{"findings", {"code", "message", "x [m]", "y [m]", "z [m]", "u", "v"}, {}};
  const auto number = [](const std::optional<double>& value) -> std::variant<double, std::string> {
    if (value) return *value;
    return std::string();
  };
  for (const auto& finding : findings) {
    table.rows.push_back({finding.code, scenario::message_in_units(finding.message, model.units),
                          number(finding.place.x), number(finding.place.y), number(finding.place.z),
                          number(finding.place.u), number(finding.place.v)});
  }
  tables.push_back(std::move(table));
}

void add_surface_mesh_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (model.surface_meshes.empty()) return;
  scenario::DataTable table{"quality",
                            {"mesh", "elements", "nodes", "area [m2]", "area_surface [m2]", "alpha_mean",
                             "alpha_90 [%]", "alpha_min", "min_angle [deg]", "max_angle [deg]", "quadrilaterals"},
                            {}};
  for (const auto& meshed : model.surface_meshes) {
    const auto& q = meshed->quality;
    table.rows.push_back({meshed->name, static_cast<double>(meshed->elements.mesh.element_count()),
                          static_cast<double>(meshed->elements.mesh.points.size()), q.area, meshed->area_surface,
                          q.alpha_mean, 100.0 * q.alpha_90, q.alpha_min, q.angle_min.degrees(), q.angle_max.degrees(),
                          static_cast<double>(quadrilaterals_of(meshed->elements.mesh))});
  }
  tables.push_back(std::move(table));
}

void add_surface_mesh_outputs(const std::shared_ptr<const model::Model>& model,
                              std::vector<scenario::Output>& outputs) {
  if (model->surface_meshes.empty()) return;
  const std::shared_ptr<const model::SurfaceMeshed> meshed = model->surface_meshes.back();
  const scenario::UnitSystem units = model->units;
  outputs.push_back({"mesh.vtu", [meshed, units](const auto& path) {
                       io::meshes::MeshFields fields;
                       std::vector<double> faces(meshed->elements.faces.begin(), meshed->elements.faces.end());
                       fields.at_elements.push_back({"face", 1, std::move(faces)});
                       if (meshed->elements.mesh.element_count() == meshed->mesh.triangles.size())
                         fields.at_elements.push_back({"alpha", 1, alphas(meshed->mesh)});
                       return model::write_vtu(path.string(), meshed->elements, fields, units);
                     }});
  for (const char* const name : {"mesh.msh", "mesh.inp", "mesh.bdf", "mesh.obj"}) {
    outputs.push_back(
        {name, [meshed, units](const auto& path) { return model::write_mesh(path.string(), meshed->elements, units); },
         io::formats::losses(name, meshed->elements.mesh)});
  }
}

}  // namespace quebra::core
