#include "quebra/core/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "quebra/analysis/problem.h"
#include "quebra/model/mesh_files.h"
#include "shared/base/text.h"
#include "shared/io/file.h"
#include "shared/io/formats/mesh_file.h"
#include "shared/io/meshes/node_ele.h"
#include "shared/io/meshes/vtu.h"
#include "shared/mesh/order2.h"
#include "shared/scene/color_map.h"
#include "shared/scene/decimal_mark.h"

namespace quebra::core {
namespace {

using namespace dobra;
using base::translated;
using scene::Color;

constexpr Color constraint_blue{13, 71, 161};
constexpr Color crack_red{198, 40, 40};
constexpr Color region_green{46, 125, 50};
constexpr Color front_orange{230, 81, 0};
constexpr Color material{236, 239, 241};
constexpr Color mesh_line{55, 71, 79, 150};

/// The curves of some roles; empty lines if there are none.
scene::Lines curves_of(const domain::Domain& domain, bool (*wanted)(sketch::Role)) {
  scene::Lines lines;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (!wanted(domain.curves[c].role)) continue;
    lines.lines.push_back(trace(domain.curves[c]).line);
    lines.ids.push_back(static_cast<std::uint32_t>(c));
  }
  return lines;
}

/// Boundary, internal lines, cracks and named points, as far as there are any.
void add_curves(const domain::Domain& domain, std::vector<scene::Layer>& layers) {
  const auto add = [&](const char* key, std::string title, const scene::Style& style, scene::Lines lines) {
    if (!lines.lines.empty()) layers.push_back({key, std::move(title), style, std::move(lines)});
  };
  add("boundary", translated("Boundary"), {.line = ink, .line_width = boundary_width},
      curves_of(domain,
                [](sketch::Role role) { return role == sketch::Role::Boundary || role == sketch::Role::Hole; }));
  add("internal", translated("Internal lines"), {.line = ink, .line_width = 1.0},
      curves_of(domain, [](sketch::Role role) { return role == sketch::Role::Internal; }));
  add("cracks", translated("Cracks"), {.line = crack_red, .line_width = 1.8},
      curves_of(domain, [](sketch::Role role) { return role == sketch::Role::Crack; }));
  scene::Markers markers;
  for (std::uint32_t i = 0; i < domain.points.size(); ++i) {
    if (domain.points[i].name.empty()) continue;
    markers.points.push_back(domain.points[i].at);
    markers.ids.push_back(i);
  }
  if (!markers.points.empty())
    layers.push_back({"points", translated("Points"), {.line = ink, .marker_size = 5.0}, std::move(markers)});
}

scene::Layer domain_layer(const domain::Domain& domain) {
  scene::Region region;
  for (const auto& loop : domain.loops) region.contours.push_back(contour(domain, loop));
  return {
      "domain", translated("Domain"), {.line_width = 0.0, .fill = material}, scene::Regions{{std::move(region)}, {}}};
}

scene::Layer constraint_layer(const std::vector<model::Constraint>& constraints) {
  scene::Lines lines;
  for (const model::Constraint& constraint : constraints) lines.lines.push_back(constraint.line);
  return {
      "constraints", translated("Offset constraints"), {.line = constraint_blue, .line_width = 1.2}, std::move(lines)};
}

/// Outlines thin out as elements get many.
double width_among(std::size_t elements) {
  return std::clamp(25.0 / std::sqrt(static_cast<double>(elements) + 1.0), 0.05, 0.5);
}

bool only_triangles(const mesh::ElementMesh& mesh) {
  return std::all_of(mesh.types.begin(), mesh.types.end(),
                     [](mesh::ElementType type) { return type == mesh::ElementType::T3; });
}

/// At each element: its shape, and of second order its Jacobian too.
io::meshes::MeshFields quality_fields(const mesh::ElementMesh& mesh) {
  io::meshes::MeshFields fields;
  io::meshes::MeshField shape{only_triangles(mesh) ? "alpha" : "shape", 1, {}};
  io::meshes::MeshField jacobian{"scaled_jacobian", 1, {}};
  bool bent = false;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    shape.values.push_back(mesh::shape_of(mesh, mesh::ElementId(e)));
    bent = bent || mesh::node_count(mesh.types[e]) != mesh::corner_count(mesh.types[e]);
    jacobian.values.push_back(
        mesh::is_quarter_point(mesh, mesh::ElementId(e)) ? 0.0 : mesh::scaled_jacobian_bound(mesh, mesh::ElementId(e)));
  }
  fields.at_elements.push_back(std::move(shape));
  if (bent) fields.at_elements.push_back(std::move(jacobian));
  return fields;
}

/// The outline of every element once, mid-sides included.
scene::Layer outline_layer(const mesh::ElementMesh& mesh) {
  scene::Lines lines;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    geom::Polyline outline{{}, true};
    for (std::uint32_t i = 0; i < mesh::corner_count(mesh.types[e]); ++i) {
      const auto [from, to, middle] = side_nodes(mesh, {mesh::ElementId(e), i});
      outline.points.push_back(mesh.point(from));
      if (middle.valid()) outline.points.push_back(mesh.point(middle));
    }
    lines.lines.push_back(std::move(outline));
    lines.ids.push_back(static_cast<std::uint32_t>(e));
  }
  const double width = outline_width(mesh);
  scene::Layer layer{"elements", translated("Elements"), {.line = mesh_line, .line_width = width}, std::move(lines)};
  layer.in_legend = scene::InLegend::No;
  return layer;
}

scene::Layer mesh_layer(const mesh::ElementMesh& mesh) {
  scene::Mesh content;
  content.points = mesh.points;
  content.values_at = scene::ValuesAt::Triangles;
  const std::vector<double> values = quality_fields(mesh).at_elements.front().values;
  auto& triangles = content.triangles.edit();
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    add_triangles(mesh, e, triangles);
    content.values.edit().resize(triangles.size(), values[e]);
  }
  content.scale = {
      only_triangles(mesh) ? translated("quality alpha") : translated("quality (alpha, shape of quadrilaterals)"),
      scene::ColorMapName::Quality, 0.5, 1.0};
  // Triangles alone are drawn with their outlines; of other elements the outlines are a layer of their own.
  const double width = only_triangles(mesh) ? outline_width(mesh) : 0.0;
  return {"mesh", translated("Mesh"), {.line = mesh_line, .line_width = width}, std::move(content),
          true,   scene::InLegend::No};
}

scene::Layer node_layer(const mesh::ElementMesh& mesh) {
  scene::Layer layer{"nodes", translated("Nodes"), {.line = ink, .marker_size = 2.0}, scene::Markers{mesh.points, {}}};
  layer.visible = false;
  layer.in_legend = scene::InLegend::No;
  return layer;
}

/// Sizes wanted, over the domain; hidden.
scene::Layer size_layer(const model::Meshed& meshed) {
  scene::Mesh content;
  content.points = meshed.mesh.points;
  content.values_at = scene::ValuesAt::Points;
  mesh::sizing::SizeSampler sampler(*meshed.sizes);
  for (const geom::Point p : content.points) content.values.push_back(sampler.at(p));
  for (std::size_t e = 0; e < meshed.mesh.element_count(); ++e) add_triangles(meshed.mesh, e, content.triangles.edit());
  const auto [least, greatest] = std::minmax_element(content.values.begin(), content.values.end());
  constexpr double many = 20.0;
  content.scale = {.title = translated("size [m]"),
                   .map = scene::ColorMapName::Viridis,
                   .low = *least,
                   .high = *greatest,
                   .least = *least,
                   .greatest = *greatest};
  if (*greatest > many * *least) {
    scene::Scale& scale = content.scale;
    scale.ticks = scene::AxisScale::Log10;
    for (double* end : {&scale.low, &scale.high, &*scale.least, &*scale.greatest}) *end = std::log10(*end);
    for (double& value : content.values.edit()) value = std::log10(value);
  } else {
    scene::settle_constant(content, *greatest);
  }
  return {"size_field", translated("Size field"), {.line_width = 0.0}, std::move(content), false};
}

/// Leaves of the tree that carries the sizes, as far as they lie in the domain's box; hidden.
scene::Layer quadtree_layer(const domain::Domain& domain, const mesh::sizing::SizeField& sizes) {
  const geom::Box all = domain.box();
  const mesh::sizing::Quadtree& tree = sizes.quadtree();
  scene::Lines lines;
  for (const mesh::sizing::QuadCellId leaf : tree.leaves()) {
    geom::Box box = tree.box(leaf);
    if (!box.overlaps(all)) continue;
    box = {{std::max(box.low.x, all.low.x), std::max(box.low.y, all.low.y)},
           {std::min(box.high.x, all.high.x), std::min(box.high.y, all.high.y)}};
    lines.lines.push_back({{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, true});
  }
  const double width = std::clamp(25.0 / std::sqrt(static_cast<double>(lines.lines.size()) + 1.0), 0.05, 0.5);
  return {"quadtree",
          translated("Quadtree of the sizes"),
          {.line = mesh_line, .line_width = width},
          std::move(lines),
          false};
}

/// Where regions are named; nothing if none is.
void add_region_names(const domain::Domain& domain, std::vector<scene::Layer>& layers) {
  scene::Markers markers;
  for (const sketch::RegionName& region : domain.regions) markers.points.push_back(region.at);
  if (markers.points.empty()) return;
  layers.push_back({"regions",
                    translated("Regions"),
                    {.line = region_green, .marker_size = 5.0},
                    std::move(markers),
                    true,
                    scene::InLegend::No});
}

scene::Panel domain_panel(const model::Model& model) {
  scene::Panel panel{.key = "domain", .title = translated("Domain"), .axes = {}, .layers = {}};
  panel.layers.push_back(domain_layer(model.domain));
  if (!model.constraints.empty()) panel.layers.push_back(constraint_layer(model.constraints));
  add_curves(model.domain, panel.layers);
  add_region_names(model.domain, panel.layers);
  return panel;
}

scene::Panel mesh_panel(const model::Model& model, const model::Meshed& meshed, std::size_t number) {
  scene::Panel panel{.key = fmt::format("mesh_{}", number), .title = {}, .axes = {}, .layers = {}};
  panel.title = fmt::format("{}: {} {}", shown_name(meshed.name), meshed.mesh.element_count(), translated("elements"));
  panel.layers.push_back(mesh_layer(meshed.mesh));
  if (!only_triangles(meshed.mesh)) panel.layers.push_back(outline_layer(meshed.mesh));
  if (meshed.constraints > 0) {
    panel.layers.push_back(constraint_layer(
        {model.constraints.begin(), model.constraints.begin() + static_cast<std::ptrdiff_t>(meshed.constraints)}));
  }
  add_curves(model.domain, panel.layers);
  panel.layers.push_back(node_layer(meshed.mesh));
  if (meshed.sizes) {
    panel.layers.push_back(size_layer(meshed));
    panel.layers.push_back(quadtree_layer(model.domain, *meshed.sizes));
  }
  return panel;
}

/// Triangles made so far, and the front in its own colour.
scene::Panel work_panel(const model::Model& model, const model::MeshWork& work) {
  scene::Panel panel{.key = "work", .title = {}, .axes = {}, .layers = {}};
  panel.title = fmt::format("{}: {} {}, {} {}", shown_name(work.name), work.steps, translated("steps"),
                            work.triangles.size(), translated("triangles"));
  panel.layers.push_back(domain_layer(model.domain));
  scene::Mesh content;
  content.points = work.points;
  content.values_at = scene::ValuesAt::Triangles;
  for (const mesh::Corners& t : work.triangles) {
    content.triangles.push_back({static_cast<std::uint32_t>(t[0].index()), static_cast<std::uint32_t>(t[1].index()),
                                 static_cast<std::uint32_t>(t[2].index())});
    content.values.push_back(
        mesh::alpha(work.points[t[0].index()], work.points[t[1].index()], work.points[t[2].index()]));
  }
  content.scale = {translated("quality alpha"), scene::ColorMapName::Quality, 0.5, 1.0};
  panel.layers.push_back({"mesh",
                          translated("Mesh"),
                          {.line = mesh_line, .line_width = width_among(work.triangles.size())},
                          std::move(content),
                          true,
                          scene::InLegend::No});
  add_curves(model.domain, panel.layers);
  scene::Lines front;
  for (const geom::Segment& side : work.front) front.lines.push_back({{side.from, side.to}, false});
  panel.layers.push_back({"front", translated("Front"), {.line = front_orange, .line_width = 2.0}, std::move(front)});
  return panel;
}

/// Elements in each of the bins of a measure, as a table.
scenario::DataTable histogram(const std::string& measure, const std::array<std::size_t, 20>& bins) {
  scenario::DataTable table{measure + "_histogram", {measure + "_from", measure + "_to", "elements"}, {}};
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double n = static_cast<double>(bins.size());
    table.rows.push_back({static_cast<double>(i) / n, static_cast<double>(i + 1) / n, static_cast<double>(bins[i])});
  }
  return table;
}

void add_quality(std::vector<scenario::Quantity>& quantities, const std::string& prefix, const model::Meshed& meshed) {
  const auto& q = meshed.quality;
  const auto add = [&](const char* name, double value, const char* unit = "") {
    quantities.push_back({prefix + name, value, unit});
  };
  const auto& types = meshed.mesh.types;
  add("elements", static_cast<double>(types.size()));
  add("quadrilaterals", static_cast<double>(std::count_if(types.begin(), types.end(),
                                                          [](auto type) { return mesh::corner_count(type) == 4; })));
  add("nodes", static_cast<double>(meshed.mesh.points.size()));
  add("tips", static_cast<double>(meshed.mesh.tips.size()));
  add("area", mesh::area(meshed.mesh), "m2");
  add("alpha_mean", q.alpha_mean);
  add("alpha_90", 100.0 * q.alpha_90, "%");
  add("alpha_min", q.alpha_min);
  add("min_angle", q.angle_min.degrees(), "deg");
  add("max_angle", q.angle_max.degrees(), "deg");
  add("gradation_p95", q.gradation_p95);
  add("jacobian_min", meshed.elements.jacobian_min);
  if (meshed.elements.quarter_points > 0)
    add("quarter_point_elements", static_cast<double>(meshed.elements.quarter_points));
  if (meshed.elements.quadrilaterals > 0) {
    add("quad_shape_mean", meshed.elements.shape_mean);
    add("quad_shape_min", meshed.elements.shape_min);
  }
  add("constraints", static_cast<double>(meshed.constraints));
  add("constraint_edges", static_cast<double>(meshed.constraint_edges));
}

}  // namespace

std::string shown_name(const std::string& name) {
  for (const char* const given : {"Mesh", "Cycle"}) {
    const std::string start = std::string(given) + ' ';
    const bool numbered = name.starts_with(start) && name.size() > start.size() &&
                          name.find_first_not_of("0123456789", start.size()) == std::string::npos;
    if (numbered) return translated(given) + name.substr(start.size() - 1);
  }
  return name;
}

double outline_width(const mesh::ElementMesh& mesh) { return width_among(mesh.element_count()); }

void add_triangles(const mesh::ElementMesh& mesh, std::size_t element,
                   std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto nodes = mesh.nodes_of(mesh::ElementId(element));
  const auto add = [&](std::initializer_list<std::size_t> corners) {
    std::array<std::uint32_t, 3> triangle{};
    std::transform(corners.begin(), corners.end(), triangle.begin(),
                   [&](std::size_t i) { return static_cast<std::uint32_t>(nodes[i].index()); });
    triangles.push_back(triangle);
  };
  switch (mesh.types[element]) {
    case mesh::ElementType::T3:
      return add({0, 1, 2});
    case mesh::ElementType::Q4:
      add({0, 1, 2});
      return add({0, 2, 3});
    case mesh::ElementType::T6:
      add({0, 3, 5});
      add({3, 1, 4});
      add({5, 4, 2});
      return add({3, 4, 5});
    case mesh::ElementType::Q8:
      add({0, 4, 7});
      add({4, 1, 5});
      add({5, 2, 6});
      add({6, 3, 7});
      add({4, 5, 7});
      return add({5, 6, 7});
  }
}

namespace {

/// The middle of the longest side: away from corners, where curves meet.
geom::Point place_of_name(const sketch::Curve& curve) {
  const auto* chain = std::get_if<geom::Polyline>(&curve.shape);
  if (chain == nullptr || chain->segment_count() == 0) return point(curve, 0.5 * length(curve));
  geom::Segment longest = chain->segment(0);
  for (std::size_t i = 1; i < chain->segment_count(); ++i) {
    const geom::Segment side = chain->segment(i);
    if (side.length() > (1.0 + 1e-9) * longest.length()) longest = side;
  }
  return interpolate(longest.from, longest.to, 0.5);
}

}  // namespace

scene::Picture names_picture(const model::Model& model) {
  const domain::Domain& domain = model.domain;
  scene::Panel panel = domain_panel(model);
  scene::Labels curves, points, regions;
  for (const sketch::Curve& curve : domain.curves)
    curves.labels.push_back({place_of_name(curve), curve.name, scene::Anchor::Callout});
  for (const sketch::NamedPoint& point : domain.points)
    points.labels.push_back({point.at, point.name, scene::Anchor::Right});
  for (const domain::Face& face : domain.faces) {
    const auto name = domain.region_names.find(face.region);
    if (name != domain.region_names.end())
      regions.labels.push_back({face.inside, name->second, scene::Anchor::Callout});
  }
  constexpr Color region_green{46, 125, 50};
  const auto add = [&](const char* key, std::string title, Color color, scene::Labels labels) {
    if (!labels.labels.empty())
      panel.layers.push_back({key, std::move(title), {.line = color}, std::move(labels), true, scene::InLegend::No});
  };
  add("curve_names", translated("Boundary"), constraint_blue, std::move(curves));
  add("point_names", translated("Points"), ink, std::move(points));
  add("region_names", translated("Regions"), region_green, std::move(regions));
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

scene::Picture histogram_picture(const model::Meshed& meshed) {
  const auto& bins = meshed.quality.histogram;
  const double all = static_cast<double>(std::accumulate(bins.begin(), bins.end(), std::size_t{0}));
  const double width = 1.0 / static_cast<double>(bins.size());
  const auto& q = meshed.quality;
  scene::Panel panel{.key = "histogram",
                     .title = {},
                     .axes = {translated("alpha"), translated("share of the elements"), scene::AxisScale::Diagram},
                     .layers = {}};
  panel.title = fmt::format("{}: {} {}", shown_name(meshed.name), meshed.mesh.element_count(), translated("elements"));
  double highest = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i] == 0) continue;
    const double left = static_cast<double>(i) * width;
    const double share = static_cast<double>(bins[i]) / all;
    highest = std::max(highest, share);
    const geom::Polyline bar{{{left, 0.0}, {left + width, 0.0}, {left + width, share}, {left, share}}, true};
    const scene::Color color = scene::color_of({{}, scene::ColorMapName::Quality, 0.5, 1.0}, left + 0.5 * width);
    scene::Layer layer{fmt::format("bin_{}", i),
                       scene::with_decimal_mark(fmt::format("{:.2f} - {:.2f}", left, left + width)),
                       {.line = ink, .line_width = 0.5, .fill = color},
                       scene::Regions{{{{bar}}}}};
    layer.in_legend = scene::InLegend::No;
    panel.layers.push_back(std::move(layer));
  }
  const auto shown = [](const char* what, double value) {
    return fmt::format("{} {}", translated(what), scene::with_decimal_mark(fmt::format("{:.3f}", value)));
  };
  const auto mark = [&](const char* key, const std::string& title, double alpha, scene::Dash dash) {
    panel.layers.push_back({key,
                            title,
                            {.line = ink, .line_width = 1.0, .dash = dash},
                            scene::Lines{{{{{alpha, 0.0}, {alpha, highest}}, false}}}});
  };
  mark("mean", shown("mean", q.alpha_mean), q.alpha_mean, scene::Dash::Dashed);
  mark("least", shown("least", q.alpha_min), q.alpha_min, scene::Dash::Dotted);
  // Of bent elements and quadrilaterals the least scaled Jacobian on the same axis, both from 0 to 1.
  if (meshed.elements.worst_jacobian.valid()) {
    const double least = meshed.elements.jacobian_min;
    mark("jacobian", shown("least scaled Jacobian", least), least, scene::Dash::Solid);
  }
  panel.extent = geom::Box{{0.0, 0.0}, {1.0, 1.05 * highest}};
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

scene::Picture size_field_picture(const model::Model& model, const model::Meshed& meshed) {
  scene::Panel panel = mesh_panel(model, meshed, 1);
  panel.title = fmt::format("{}: {}", shown_name(meshed.name), translated("sizes wanted"));
  // The field below, the tree and the curves above it.
  const auto is_below = [](const scene::Layer& layer) { return layer.key == "size_field" || layer.key == "quadtree"; };
  std::stable_partition(panel.layers.begin(), panel.layers.end(), is_below);
  for (scene::Layer& layer : panel.layers) {
    if (is_below(layer)) layer.visible = true;
    if (layer.key == "mesh" || layer.key == "elements") layer.visible = false;
  }
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

void draw(const model::Model& model, scene::Picture& picture) {
  picture.arrangement = scene::Arrangement::Grid;
  const std::size_t n = model.meshes.size();
  if (n == 0 && !model.work) picture.panels.push_back(domain_panel(model));
  // The two last meshes side by side: before and after.
  const std::size_t shown = model.work ? 1 : 2;
  for (std::size_t i = n > shown ? n - shown : 0; i < n; ++i)
    picture.panels.push_back(mesh_panel(model, *model.meshes[i], i + 1));
  if (model.work) picture.panels.push_back(work_panel(model, *model.work));
}

void add_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  quantities.push_back({"curves", static_cast<double>(model.domain.curves.size()), ""});
  quantities.push_back({"loops", static_cast<double>(model.domain.loops.size()), ""});
  const auto& curves = model.domain.curves;
  const auto cracks = std::count_if(curves.begin(), curves.end(),
                                    [](const sketch::Curve& curve) { return curve.role == sketch::Role::Crack; });
  quantities.push_back({"findings", static_cast<double>(model.findings.size()), ""});
  quantities.push_back({"cracks", static_cast<double>(cracks), ""});
  quantities.push_back({"parts", static_cast<double>(model.domain.faces.size()), ""});
  quantities.push_back({"offset_constraints", static_cast<double>(model.constraints.size()), ""});
  for (std::size_t i = 0; i < model.constraints.size(); ++i) {
    quantities.push_back(
        {fmt::format("constraint.{}.distance", model.constraints[i].name), model.constraints[i].distance, "m"});
  }
  if (model.work) {
    quantities.push_back({"work.steps", static_cast<double>(model.work->steps), ""});
    quantities.push_back({"work.triangles", static_cast<double>(model.work->triangles.size()), ""});
    quantities.push_back({"work.front", static_cast<double>(model.work->front.size()), ""});
  }
  if (!model.meshes.empty()) add_quality(quantities, "", *model.meshes.back());
  for (std::size_t i = 0; i < model.meshes.size(); ++i)
    add_quality(quantities, fmt::format("mesh.{}.", i + 1), *model.meshes[i]);
}

void add_finding_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (model.findings.empty()) return;
  scenario::DataTable findings{"findings", {"what", "x [m]", "y [m]", "curve", "mend"}, {}};
  for (const sketch::Finding& finding : model.findings) {
    findings.rows.push_back({std::string(name_of(finding.wrong)), finding.at.x, finding.at.y, finding.curve,
                             scenario::message_in_units(finding.mend, model.units)});
  }
  tables.push_back(std::move(findings));
}

void add_mesh_tables(const model::Model& model, std::vector<scenario::DataTable>& tables) {
  if (model.meshes.empty()) return;
  scenario::DataTable table{
      "quality",
      {"mesh", "elements", "nodes", "alpha_mean", "alpha_90 [%]", "alpha_min", "min_angle [deg]", "max_angle [deg]",
       "gradation_p95", "constraints", "jacobian_min", "quadrilaterals", "quad_shape_min"},
      {}};
  for (const auto& meshed : model.meshes) {
    const auto& q = meshed->quality;
    table.rows.push_back({meshed->name, static_cast<double>(meshed->mesh.element_count()),
                          static_cast<double>(meshed->mesh.points.size()), q.alpha_mean, 100.0 * q.alpha_90,
                          q.alpha_min, q.angle_min.degrees(), q.angle_max.degrees(), q.gradation_p95,
                          static_cast<double>(meshed->constraints), meshed->elements.jacobian_min,
                          static_cast<double>(meshed->elements.quadrilaterals), meshed->elements.shape_min});
  }
  tables.push_back(std::move(table));
  tables.push_back(histogram("alpha", model.meshes.back()->quality.histogram));
  tables.push_back(histogram("scaled_jacobian", model.meshes.back()->elements.jacobians));
}

io::meshes::InpElement inp_element_of(const model::Model& model) {
  return model.problem && model.problem->state == analysis::Plane::Strain ? io::meshes::InpElement::PlaneStrain
                                                                          : io::meshes::InpElement::PlaneStress;
}

void add_mesh_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (model->meshes.empty()) return;
  const std::shared_ptr<const model::Meshed> meshed = model->meshes.back();
  const scenario::UnitSystem units = model->units;
  outputs.push_back({"mesh.vtu", [meshed, units](const auto& path) {
                       return model::write_vtu(path.string(), meshed->mesh, quality_fields(meshed->mesh), units);
                     }});
  const io::meshes::InpElement element = inp_element_of(*model);
  for (const char* const name : {"mesh.msh", "mesh.inp", "mesh.bdf", "mesh.nf"}) {
    outputs.push_back({name,
                       [meshed, element, units](const auto& path) {
                         return model::write_mesh(path.string(), meshed->mesh, element, units);
                       },
                       io::formats::losses(name, meshed->mesh)});
  }
  // These hold triangles of one order only.
  if (io::meshes::ele_file_of(meshed->mesh)) {
    const auto write = [meshed, units](const auto& path, const auto& text_of) -> base::Result<void> {
      DOBRA_TRY_VOID(io::write_text(path, text_of(model::in_units(meshed->mesh, units))));
      return io::formats::add_note(path.string(), model::note_of(units));
    };
    outputs.push_back(
        {"mesh.node", [write](const auto& path) {
           return write(path, [](const auto& mesh) { return io::meshes::node_text(io::meshes::node_file_of(mesh)); });
         }});
    outputs.push_back(
        {"mesh.ele", [write](const auto& path) {
           return write(path, [](const auto& mesh) { return io::meshes::ele_text(*io::meshes::ele_file_of(mesh)); });
         }});
  }
}

}  // namespace quebra::core
