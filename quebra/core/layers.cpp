#include "quebra/core/layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "quebra/core/domain.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/inp.h"
#include "shared/io/msh.h"
#include "shared/io/node_ele.h"
#include "shared/io/vtu.h"

namespace quebra::core {
namespace {

using namespace dobra;
using base::translated;
using scene::Color;

constexpr Color ink{38, 50, 56};
constexpr Color constraint_blue{13, 71, 161};
constexpr Color material{236, 239, 241};
constexpr Color mesh_line{55, 71, 79, 150};

scene::Layer boundary_layer(const Domain& domain) {
  scene::Lines lines;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    lines.lines.push_back(trace(domain.curves[c], trace_turn).line);
    lines.ids.push_back(static_cast<std::uint32_t>(c));
  }
  return {"boundary", translated("Boundary"), {.line = ink, .line_width = 1.8}, std::move(lines)};
}

scene::Layer domain_layer(const Domain& domain) {
  scene::Region region;
  for (const auto& loop : domain.loops) region.contours.push_back(contour(domain, loop));
  return {"domain", translated("Domain"), {.line_width = 0.0, .fill = material}, scene::Regions{{std::move(region)}, {}}};
}

scene::Layer constraint_layer(const std::vector<Constraint>& constraints) {
  scene::Lines lines;
  for (const Constraint& constraint : constraints) lines.lines.push_back(constraint.line);
  return {"constraints", translated("Offset constraints"), {.line = constraint_blue, .line_width = 1.2}, std::move(lines)};
}

io::MeshFields quality_fields(const mesh::TriangleMesh& mesh) {
  io::MeshField alpha{"alpha", 1, {}};
  for (const auto& [a, b, c] : mesh.triangles) alpha.values.push_back(mesh::alpha(mesh.point(a), mesh.point(b), mesh.point(c)));
  return {{}, {std::move(alpha)}};
}

scene::Layer mesh_layer(const mesh::TriangleMesh& mesh) {
  scene::Mesh content;
  content.points = mesh.points;
  content.values_at = scene::ValuesAt::Triangles;
  for (const auto& corners : mesh.triangles) {
    content.triangles.push_back({static_cast<std::uint32_t>(corners[0].index()), static_cast<std::uint32_t>(corners[1].index()),
                                 static_cast<std::uint32_t>(corners[2].index())});
  }
  content.values = quality_fields(mesh).at_triangles.front().values;
  content.scale = {translated("quality alpha"), scene::ColorMapName::Quality, 0.5, 1.0};
  // Outlines thin out as triangles get many, so that they do not hide the colours.
  const double width = std::clamp(25.0 / std::sqrt(static_cast<double>(content.triangles.size()) + 1.0), 0.05, 0.5);
  return {"mesh", translated("Mesh"), {.line = mesh_line, .line_width = width}, std::move(content), true, scene::InLegend::No};
}

scene::Layer node_layer(const mesh::TriangleMesh& mesh) {
  scene::Layer layer{"nodes", translated("Nodes"), {.line = ink, .marker_size = 2.0}, scene::Markers{mesh.points, {}}};
  layer.visible = false;
  layer.in_legend = scene::InLegend::No;
  return layer;
}

scene::Panel domain_panel(const Model& model) {
  scene::Panel panel{.key = "domain", .title = translated("Domain"), .axes = {}, .layers = {}};
  panel.layers.push_back(domain_layer(model.domain));
  if (!model.constraints.empty()) panel.layers.push_back(constraint_layer(model.constraints));
  panel.layers.push_back(boundary_layer(model.domain));
  return panel;
}

scene::Panel mesh_panel(const Model& model, const Meshed& meshed, std::size_t number) {
  scene::Panel panel{.key = fmt::format("mesh_{}", number), .title = {}, .axes = {}, .layers = {}};
  panel.title = fmt::format("{}: {} {}", meshed.name, meshed.quality.triangles, translated("triangles"));
  panel.layers.push_back(mesh_layer(meshed.mesh));
  if (meshed.constraints > 0) {
    panel.layers.push_back(constraint_layer({model.constraints.begin(), model.constraints.begin() + static_cast<std::ptrdiff_t>(meshed.constraints)}));
  }
  panel.layers.push_back(boundary_layer(model.domain));
  panel.layers.push_back(node_layer(meshed.mesh));
  return panel;
}

/// Elements with alpha in each of the bins of MeshQuality::histogram, as a table.
scenario::DataTable histogram(const Meshed& meshed) {
  scenario::DataTable table{"alpha_histogram", {"alpha_from", "alpha_to", "elements"}, {}};
  const auto& bins = meshed.quality.histogram;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double n = static_cast<double>(bins.size());
    table.rows.push_back({static_cast<double>(i) / n, static_cast<double>(i + 1) / n, static_cast<double>(bins[i])});
  }
  return table;
}

void add_quality(std::vector<scenario::Quantity>& quantities, const std::string& prefix, const Meshed& meshed) {
  const auto& q = meshed.quality;
  const auto add = [&](const char* name, double value, const char* unit = "") { quantities.push_back({prefix + name, value, unit}); };
  std::size_t constraint_edges = 0;
  for (const auto& [name, edges] : meshed.mesh.constraint_sets) constraint_edges += edges.size();
  add("elements", static_cast<double>(q.triangles));
  add("nodes", static_cast<double>(q.nodes));
  add("area", q.area, "m2");
  add("alpha_mean", q.alpha_mean);
  add("alpha_90", 100.0 * q.alpha_90, "%");
  add("alpha_min", q.alpha_min);
  add("min_angle", q.angle_min.degrees(), "deg");
  add("max_angle", q.angle_max.degrees(), "deg");
  add("gradation_p95", q.gradation_p95);
  add("constraints", static_cast<double>(meshed.constraints));
  add("constraint_edges", static_cast<double>(constraint_edges));
}

base::Result<void> write_text(const base::Result<std::string>& text, const std::filesystem::path& path) {
  if (!text) return text.error();
  return io::write_file(path, *text);
}

}  // namespace

scene::Picture picture_of(const Model& model) {
  scene::Picture picture;
  const std::size_t n = model.meshes.size();
  if (n == 0) picture.panels.push_back(domain_panel(model));
  // The two last meshes side by side: before and after.
  for (std::size_t i = n > 2 ? n - 2 : 0; i < n; ++i) picture.panels.push_back(mesh_panel(model, *model.meshes[i], i + 1));
  return picture;
}

std::vector<scenario::Quantity> quantities_of(const Model& model) {
  std::vector<scenario::Quantity> quantities;
  quantities.push_back({"curves", static_cast<double>(model.domain.curves.size()), ""});
  quantities.push_back({"loops", static_cast<double>(model.domain.loops.size()), ""});
  quantities.push_back({"offset_constraints", static_cast<double>(model.constraints.size()), ""});
  for (std::size_t i = 0; i < model.constraints.size(); ++i) {
    quantities.push_back({fmt::format("constraint.{}.distance", model.constraints[i].name), model.constraints[i].distance, "m"});
  }
  if (!model.meshes.empty()) add_quality(quantities, "", *model.meshes.back());
  for (std::size_t i = 0; i < model.meshes.size(); ++i) add_quality(quantities, fmt::format("mesh.{}.", i + 1), *model.meshes[i]);
  return quantities;
}

std::vector<scenario::DataTable> tables_of(const Model& model) {
  scenario::DataTable table{"quality",
                            {"mesh", "elements", "nodes", "alpha_mean", "alpha_90 [%]", "alpha_min", "min_angle [deg]", "max_angle [deg]", "gradation_p95", "constraints"},
                            {}};
  for (const auto& meshed : model.meshes) {
    const auto& q = meshed->quality;
    table.rows.push_back({meshed->name, static_cast<double>(q.triangles), static_cast<double>(q.nodes), q.alpha_mean, 100.0 * q.alpha_90,
                          q.alpha_min, q.angle_min.degrees(), q.angle_max.degrees(), q.gradation_p95, static_cast<double>(meshed->constraints)});
  }
  if (table.rows.empty()) return {};
  return {table, histogram(*model.meshes.back())};
}

std::vector<scenario::Output> outputs_of(const std::shared_ptr<const Model>& model) {
  if (model->meshes.empty()) return {};
  const std::shared_ptr<const Meshed> meshed = model->meshes.back();
  return {
      {"mesh.vtu", [meshed](const auto& path) { return io::write_vtu(path.string(), meshed->mesh, quality_fields(meshed->mesh)); }},
      {"mesh.msh", [meshed](const auto& path) { return io::write_msh(path.string(), meshed->mesh); }},
      {"mesh.inp", [meshed](const auto& path) { return io::write_inp(path.string(), meshed->mesh); }},
      {"mesh.node", [meshed](const auto& path) { return write_text(io::node_text(io::node_file_of(meshed->mesh)), path); }},
      {"mesh.ele", [meshed](const auto& path) { return write_text(io::ele_text(io::ele_file_of(meshed->mesh)), path); }},
  };
}

}  // namespace quebra::core
