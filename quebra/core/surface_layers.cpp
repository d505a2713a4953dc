#include "quebra/core/surface_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "quebra/core/layers.h"
#include "quebra/core/surface_marks.h"
#include "quebra/model/mesh_files.h"
#include "shared/base/text.h"
#include "shared/mesh/quality.h"
#include "shared/scene/color_map.h"

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

constexpr scene::Color chart_crack_red{198, 40, 40};
constexpr scene::Color chart_mesh_line{55, 71, 79, 150};
constexpr scene::Color space_mesh_line{38, 50, 56};
constexpr scene::Color isocurve_pink{216, 27, 96};
constexpr scene::Color normal_violet{123, 31, 162};
constexpr scene::Color finding_orange{230, 81, 0};
constexpr scene::Color face_fill{150, 178, 204};  // lines are seen on it, dark ones on paper and white ones on black
constexpr scene::Color left_out_fill{224, 224, 224};
constexpr scene::Color left_out_line{158, 158, 158};
constexpr int samples_an_edge = 96;

/// Edges of a face, numbered alike in space and in charts: edges that are one curve have one number.
struct Numbered {
  const surf::trim::ChartEdge* edge;
  std::size_t face;
  std::uint32_t item;
  enum class Of { Border, Line, Crack, Seam } of;
};

std::vector<Numbered> edges_of(const std::vector<surf::trim::TrimmedSurface>& faces) {
  std::vector<Numbered> all;
  std::map<surf::trim::SharedCurveId, std::uint32_t> shared;
  std::uint32_t next = 0;
  const auto add = [&](const surf::trim::ChartEdge& edge, std::size_t face, Numbered::Of of) {
    std::uint32_t item = next;
    if (edge.shared) item = shared.try_emplace(*edge.shared, next).first->second;
    if (item == next) ++next;
    all.push_back({&edge, face, item, of});
  };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::map<surf::trim::SharedCurveId, int> sides;  // of the face itself; two are a seam
    for (const auto& loop : faces[f].loops) {
      for (const auto& edge : loop.edges) {
        if (edge.shared) ++sides[*edge.shared];
      }
    }
    for (const auto& loop : faces[f].loops) {
      for (const auto& edge : loop.edges) {
        const bool crack = edge.crack != surf::trim::ChartEdge::Crack::None;
        const bool seam = edge.shared && sides[*edge.shared] == 2;
        add(edge, f, crack ? Numbered::Of::Crack : seam ? Numbered::Of::Seam : Numbered::Of::Border);
      }
    }
    for (const auto& line : faces[f].lines) {
      const bool crack = line.kind == surf::trim::ChartLine::Kind::Crack;
      for (const auto& edge : line.edges) add(edge, f, crack ? Numbered::Of::Crack : Numbered::Of::Line);
    }
  }
  return all;
}

/// The layers of edges, of each kind that there is. @param put  adds an edge to a layer's content.
template <class Layer, class Content, class Put>
void add_edges(const std::vector<Numbered>& edges, std::vector<Layer>& layers, Put put) {
  Content borders, inner, cracks;
  for (const Numbered& edge : edges) {
    const bool border = edge.of == Numbered::Of::Border || edge.of == Numbered::Of::Seam;
    Content& to = border ? borders : edge.of == Numbered::Of::Crack ? cracks : inner;
    put(edge, to);
  }
  const auto add = [&](const char* key, std::string title, const scene::Style& style, Content content) {
    if (content.lines.empty()) return;
    Layer layer{key, std::move(title), style, std::move(content)};
    layers.push_back(std::move(layer));
  };
  add("boundary", translated("Boundary"), {.line = ink, .line_width = boundary_width}, std::move(borders));
  add("internal", translated("Internal lines"), {.line = ink, .line_width = 1.0}, std::move(inner));
  add("cracks", translated("Cracks"), {.line = chart_crack_red, .line_width = 1.8}, std::move(cracks));
}

template <class At>
auto sampled(const surf::trim::ChartEdge& edge, At at) {
  std::vector<decltype(at(geom::Point{}))> line;
  for (int i = 0; i <= samples_an_edge; ++i) {
    const double part = static_cast<double>(i) / samples_an_edge;
    line.push_back(at(edge.at(edge.from + part * (edge.to - edge.from))));
  }
  return line;
}

scene::Scale alpha_scale() { return {translated("quality alpha"), scene::ColorMapName::Quality, 0.5, 1.0}; }
constexpr std::size_t many_triangles = 20000;

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
    content.ids.push_back(static_cast<std::uint32_t>(t));
  }
  content.scale = alpha_scale();
  return {"mesh",
          translated("Mesh"),
          {.line = chart_mesh_line, .line_width = values.size() > many_triangles ? 0.1 : 0.35},
          std::move(content),
          true,
          scene::InLegend::No};
}

scene::Layer regions_layer(const char* key, std::string title, scene::Color fill, scene::Regions content) {
  return {key, std::move(title), {.line = left_out_line, .line_width = 0.5, .fill = fill}, std::move(content)};
}

/// What of a face's surface is not meant, numbered among those of all faces.
struct LeftOut {
  std::size_t face;
  const surf::trim::TrimmedSurface* part;
  std::uint32_t item;
};
std::vector<LeftOut> left_out(const model::SurfaceSet& set) {
  std::vector<LeftOut> all;
  for (std::size_t f = 0; f < set.parts.size(); ++f) {
    for (const std::size_t part : set.parts[f].left_out)
      all.push_back({f, &set.parts[f].recognised->faces()[part], static_cast<std::uint32_t>(all.size())});
  }
  return all;
}

scene::Layer isocurves_in_chart(const std::vector<Isocurve>& curves, std::size_t face, const DrawnChart& chart) {
  scene::Lines content;
  for (const Isocurve& curve : curves) {
    if (curve.face != face) continue;
    geom::Polyline line;
    for (const geom::Point uv : curve.chart) line.points.push_back(chart.at(uv));
    content.lines.push_back(std::move(line));
    content.ids.push_back(curve.item);
  }
  return {isocurves_layer,
          translated("Lines of constant u and v"),
          {.line = isocurve_pink, .line_width = 1.1},
          std::move(content),
          false};
}

/// What charts are drawn from.
struct Charts {
  explicit Charts(const model::Model& model) : set(*model.surfaces), edges(edges_of(set.faces)), left(left_out(set)) {
    if (model.surface_meshes.empty()) return;
    meshed = model.surface_meshes.back().get();
    curves = isocurves(meshed->mesh, set.faces);
  }
  const model::SurfaceSet& set;
  const std::vector<Numbered> edges;
  const std::vector<LeftOut> left;
  const model::SurfaceMeshed* meshed = nullptr;
  std::vector<Isocurve> curves;
};

scene::Panel chart_panel(const Charts& of, std::size_t f) {
  const auto& faces = of.set.faces;
  const DrawnChart chart(faces[f].surface);
  scene::Panel panel{.key = chart_key(f), .title = {}, .axes = {}, .layers = {}};
  panel.title = fmt::format("{}: {}", translated("Chart"), faces[f].name);
  panel.axes.x_title = translated("u (length) [m]");
  panel.axes.y_title = translated("v (length) [m]");
  const geom::Vector unit = of.set.chart_units[f];
  const auto names = f < of.set.unit_names.size() ? of.set.unit_names[f] : std::array<std::string, 2>{};
  panel.axes.x_reading = chart.u_reading(unit.x, names[0]);
  panel.axes.y_reading = chart.v_reading(unit.y, names[1]);
  scene::Regions out;
  for (const LeftOut& part : of.left) {
    if (part.face != f) continue;
    out.regions.push_back(region_of(part.part->loops, chart));
    out.ids.push_back(part.item);
  }
  if (!out.regions.empty())
    panel.layers.push_back(regions_layer(left_out_layer, translated("Parts left out"), left_out_fill, std::move(out)));
  if (of.meshed != nullptr) {
    panel.layers.push_back(mesh_layer(*of.meshed, f, chart));
    panel.layers.push_back(isocurves_in_chart(of.curves, f, chart));
  } else {
    scene::Regions face{{region_of(faces[f].loops, chart)}, {static_cast<std::uint32_t>(f)}};
    panel.layers.push_back(regions_layer(faces_layer, translated("Surface"), face_fill, std::move(face)));
  }
  std::vector<Numbered> own = of.edges;
  std::erase_if(own, [&](const Numbered& edge) { return edge.face != f; });
  add_edges<scene::Layer, scene::Lines>(own, panel.layers, [&](const Numbered& edge, scene::Lines& to) {
    to.lines.push_back({sampled(*edge.edge, [&](geom::Point uv) { return chart.at(uv); }), false});
    to.ids.push_back(edge.item);
  });
  return panel;
}

}  // namespace

scene::Panel chart_of(const model::Model& model, std::size_t face) { return chart_panel(Charts(model), face); }

void draw_surfaces(const model::Model& model, scene::Picture& picture) {
  picture.arrangement = scene::Arrangement::Grid;
  const auto& faces = model.surfaces->faces;
  const Charts charts(model);
  for (std::size_t f = 0; f < std::min(faces.size(), most_charts); ++f)
    picture.panels.push_back(chart_panel(charts, f));
  if (faces.size() > most_charts)
    picture.notes.push_back(fmt::format(fmt::runtime(translated("Charts are those of the first {} of {} surfaces.")),
                                        most_charts, faces.size()));
}

namespace {

scene::space::Layer space_mesh(const model::SurfaceMeshed& meshed) {
  scene::space::Surface content;
  std::vector<geom::Point3> points;
  std::vector<geom::Point> chart;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // A corner each, so that every one has its place in the chart of its face.
  for (std::size_t t = 0; t < meshed.mesh.triangles.size(); ++t) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::size_t i = 0; i < 3; ++i) {
      points.push_back(meshed.mesh.point(meshed.mesh.triangles[t][i]));
      chart.push_back(meshed.mesh.places[t][i]);
    }
    triangles.push_back({first, first + 1, first + 2});
  }
  content.points = std::move(points), content.chart = std::move(chart), content.triangles = std::move(triangles);
  content.values_at = scene::ValuesAt::Triangles;
  content.values = alphas(meshed.mesh);
  content.scale = alpha_scale();
  const bool many = meshed.mesh.triangles.size() > many_triangles;
  return {"mesh",
          translated("Mesh"),
          {.line = space_mesh_line, .line_width = many ? 0.0 : 0.6},
          std::move(content),
          true,
          scene::InLegend::No,
          {}};
}

/// Several areas as one layer.
void add_areas(const char* key, std::string title, scene::Color fill, const std::vector<scene::space::Surface>& areas,
               std::vector<scene::space::Layer>& layers) {
  scene::space::Surface all;
  for (const scene::space::Surface& area : areas) {
    const auto first = static_cast<std::uint32_t>(all.points.size());
    for (std::size_t i = 0; i < area.points.size(); ++i) {
      all.points.push_back(area.points[i]);
      all.chart.push_back(area.chart[i]);
    }
    for (std::size_t t = 0; t < area.triangles.size(); ++t) {
      const auto& corners = area.triangles[t];
      all.triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
      all.ids.push_back(area.ids[t]);
    }
  }
  if (all.triangles.empty()) return;
  layers.push_back(
      {key, std::move(title), {.line_width = 0.0, .fill = fill}, std::move(all), true, scene::InLegend::Yes, {}});
}

void add_faces(const model::SurfaceSet& set, bool meshed, std::vector<scene::space::Layer>& layers) {
  std::vector<scene::space::Surface> out, faces;
  for (const LeftOut& part : left_out(set))
    out.push_back(area_of(set.faces[part.face].surface, part.part->loops, part.item));
  add_areas(left_out_layer, translated("Parts left out"), left_out_fill, out, layers);
  if (meshed) return;
  for (std::size_t f = 0; f < set.faces.size(); ++f) {
    faces.push_back(area_of(set.faces[f].surface, set.faces[f].loops, static_cast<std::uint32_t>(f)));
    if (faces.back().triangles.empty()) {  // its loops go round it
      const auto* parts = f < set.parts.size() && set.parts[f].recognised ? &set.parts[f] : nullptr;
      faces.back() = area_of_parts(set.faces[f].surface, parts, static_cast<std::uint32_t>(f));
    }
  }
  add_areas(faces_layer, translated("Surface"), face_fill, faces, layers);
}

/// For the user to switch on.
void add_helping_lines(const model::SurfaceSet& set, const model::SurfaceMeshed& meshed,
                       std::vector<scene::space::Layer>& layers) {
  const auto add = [&](const char* key, std::string title, scene::Color color, double width,
                       scene::space::Lines content) {
    if (content.lines.empty()) return;
    layers.push_back({key,
                      std::move(title),
                      {.line = color, .line_width = width},
                      std::move(content),
                      false,
                      scene::InLegend::Yes,
                      {}});
  };
  scene::space::Lines curves, arrows;
  for (Isocurve& curve : isocurves(meshed.mesh, set.faces)) {
    curves.lines.push_back(std::move(curve.line));
    curves.ids.push_back(curve.item);
  }
  arrows.lines = normals(meshed.mesh);
  add(isocurves_layer, translated("Lines of constant u and v"), isocurve_pink, 1.3, std::move(curves));
  add(normals_layer, translated("Normals"), normal_violet, 0.9, std::move(arrows));
  if (!layers.empty() && layers.back().key == normals_layer) layers.back().in_extent = scene::space::InExtent::No;
}

/// Where something was told, with what was told.
void add_findings(const model::Model& model, std::vector<scene::space::Layer>& layers) {
  scene::space::Markers places;
  std::vector<std::string> messages;
  for (const surf::mesh::Finding& finding : findings_of(model)) {
    if (!finding.place.x || !finding.place.y || !finding.place.z) continue;
    places.points.push_back({*finding.place.x, *finding.place.y, *finding.place.z});
    messages.push_back(scenario::message_in_units(finding.message, model.units));
  }
  if (places.points.empty()) return;
  layers.push_back({.key = "findings",
                    .title = translated("Findings"),
                    .style = {.line = finding_orange, .marker_size = 9.0},
                    .content = std::move(places),
                    .visible = true,
                    .in_legend = scene::InLegend::Yes,
                    .legend = {},
                    .names = std::move(messages)});
}

}  // namespace

void draw_surfaces_in_space(const model::Model& model, scene::space::SpacePicture& picture) {
  if (!model.surfaces) return;
  const model::SurfaceSet& set = *model.surfaces;
  const bool meshed = !model.surface_meshes.empty();
  add_faces(set, meshed, picture.layers);
  if (meshed) {
    picture.layers.push_back(space_mesh(*model.surface_meshes.back()));
    add_helping_lines(set, *model.surface_meshes.back(), picture.layers);
  }
  add_edges<scene::space::Layer, scene::space::Lines>(
      edges_of(set.faces), picture.layers, [&](const Numbered& edge, scene::space::Lines& to) {
        if (edge.of == Numbered::Of::Seam) return;  // of the chart alone
        const surf::Surface& surface = set.faces[edge.face].surface;
        to.lines.push_back(sampled(*edge.edge, [&](geom::Point uv) { return surface.at(uv); }));
        to.ids.push_back(edge.item);
      });
  add_controls(set, picture.layers);
  add_findings(model, picture.layers);
  picture.camera = scene::space::camera_of(scene::space::StandardView::Isometric);
  // Good elements have a dark colour: the insides of shells, that the light passes by, are to show it with its edges.
  picture.light.ambient = 0.7;
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
