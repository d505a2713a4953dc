#include "quebra/core/solid_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "quebra/core/layers.h"
#include "shared/base/check.h"
#include "shared/base/text.h"
#include "shared/mesh/delaunay/delaunay.h"
#include "shared/scene/unit_colors.h"
#include "shared/solid/cap.h"
#include "shared/solid/mesh_solid.h"

namespace quebra::core {

using namespace dobra;
using base::translated;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

constexpr scene::Color one_body{205, 214, 222};
constexpr scene::Color edge_color{38, 50, 56};
constexpr double edge_width = 1.1;
const double sharp = std::cos(std::numbers::pi / 6.0);  // an edge between faces that turn by more is drawn
constexpr double explosion = 0.7;                       // of the way of a shell from the middle of all

/// The triangles of a solid, and where each comes from.
struct Triangles {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::string> names;
  std::vector<std::uint32_t> shells;
};

std::optional<Triangles> triangles_of(const solid::Solid& solid) {
  auto made = solid::to_mesh(solid, solid::FacesAs::Triangles);
  if (!made) return std::nullopt;
  Triangles all;
  all.points = std::move(made->mesh.points);
  for (const auto& face : made->mesh.faces) all.corners.push_back({face[0], face[1], face[2]});
  all.names = std::move(made->names);
  // Triangles follow each other as their faces do; a face of n corners in m loops has n + 2 m - 4.
  for (std::uint32_t f = 0; f < solid.face_count(); ++f) {
    const solid::FaceId face(f);
    const auto loops = solid.loops(face);
    std::size_t corners = 0;
    for (const solid::HalfEdgeId first : loops) {
      solid::HalfEdgeId at = first;
      do ++corners, at = solid.next(at);
      while (at != first);
    }
    all.shells.insert(all.shells.end(), corners + 2 * loops.size() - 4,
                      static_cast<std::uint32_t>(solid.shell(face).index()));
  }
  DOBRA_CHECK(all.shells.size() == all.corners.size());
  return all;
}

/// An edge at which a name ends or the surface turns.
struct Edge {
  Point3 from, to;
  std::string name;
  std::uint32_t shell = 0;
};

Vector3 normal_of(const solid::Solid& solid, solid::FaceId face) {
  Vector3 sum{};
  for (const solid::HalfEdgeId first : solid.loops(face)) {
    const Point3 origin = solid.point(first);
    for (solid::HalfEdgeId h = solid.next(first); h != first; h = solid.next(h))
      sum = sum + geom::cross(solid.point(h) - origin, solid.point(solid.next(h)) - origin);
  }
  const double size = length(sum);
  return size > 0.0 ? sum / size : sum;
}

std::vector<Edge> edges_of(const solid::Solid& solid) {
  std::vector<Vector3> normals;
  for (std::uint32_t f = 0; f < solid.face_count(); ++f) normals.push_back(normal_of(solid, solid::FaceId(f)));
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < 2 * solid.edge_count(); ++i) {
    const solid::HalfEdgeId h(i), mate = solid.mate(h);
    if (mate.index() < h.index()) continue;
    const solid::FaceId a = solid.face(h), b = solid.face(mate);
    const std::string &here = solid.name(a), &there = solid.name(b);
    if (here == there && dot(normals[a.index()], normals[b.index()]) > sharp) continue;
    edges.push_back({solid.point(h), solid.point(mate), here == there ? here : fmt::format("{}, {}", here, there),
                     static_cast<std::uint32_t>(solid.shell(a).index())});
  }
  return edges;
}

scene::Color color_of_body(const solids::Part& part, std::size_t body) {
  return part.bodies.size() == 1 ? one_body : scene::unit_style(body).fill;
}

/// How far each shell of each body is moved, to be seen by itself.
using Shifts = std::vector<std::vector<Vector3>>;

/// A part as layers; bodies may be moved by shells.
void add_part(const solids::Part& part, const std::string& key, std::string title, bool visible, const Shifts& shifts,
              const char* edges_key, std::vector<scene::space::Layer>& layers) {
  const std::vector<std::string> names = face_names(part);
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint32_t> ids;
  std::vector<scene::Color> colors;
  std::vector<std::vector<Point3>> lines;
  std::vector<std::string> line_names;
  for (std::size_t b = 0; b < part.bodies.size(); ++b) {
    const solid::Solid& solid = part.bodies[b].solid;
    if (solid.empty()) continue;
    const auto triangles = triangles_of(solid);
    if (!triangles) continue;
    const auto shift = [&](std::uint32_t shell) { return shifts.empty() ? Vector3{} : shifts[b][shell]; };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> taken;  // points of a shell, which faces share
    for (std::size_t t = 0; t < triangles->corners.size(); ++t) {
      const std::uint32_t shell = triangles->shells[t];
      auto& triangle = corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t corner = triangles->corners[t][i];
        const auto [place, fresh] = taken.try_emplace({shell, corner}, static_cast<std::uint32_t>(points.size()));
        if (fresh) points.push_back(triangles->points[corner] + shift(shell));
        triangle[i] = place->second;
      }
      const auto name = std::lower_bound(names.begin(), names.end(), triangles->names[t]);
      ids.push_back(static_cast<std::uint32_t>(name - names.begin()));
      colors.push_back(color_of_body(part, b));
    }
    if (edges_key == nullptr) continue;
    for (Edge& edge : edges_of(solid)) {
      lines.push_back({edge.from + shift(edge.shell), edge.to + shift(edge.shell)});
      line_names.push_back(std::move(edge.name));
    }
  }
  if (corners.empty()) return;
  scene::space::Surface surface;
  surface.points = std::move(points), surface.triangles = std::move(corners);
  surface.ids = std::move(ids), surface.colors = std::move(colors);
  layers.push_back({.key = key,
                    .title = std::move(title),
                    .style = {.line_width = 0.0, .fill = one_body},
                    .content = std::move(surface),
                    .visible = visible,
                    .in_legend = scene::InLegend::No,
                    .legend = {},
                    .names = names});
  if (lines.empty()) return;
  scene::space::Lines edges;
  edges.lines = std::move(lines);
  layers.push_back({.key = edges_key,
                    .title = translated("Edges"),
                    .style = {.line = edge_color, .line_width = edge_width},
                    .content = std::move(edges),
                    .visible = visible,
                    .in_legend = scene::InLegend::No,
                    .legend = {},
                    .names = line_names});
}

/// Away from the middle of all; one that lies round the middle of all goes up.
Shifts shifts_of(const solids::Part& part) {
  geom::Box3 all;
  std::vector<std::vector<geom::Box3>> boxes;
  for (const solids::Body& body : part.bodies) {
    boxes.emplace_back(body.solid.shell_count());
    for (std::uint32_t i = 0; i < 2 * body.solid.edge_count(); ++i) {
      const solid::HalfEdgeId h(i);
      const Point3 p = body.solid.point(h);
      boxes.back()[body.solid.shell(body.solid.face(h)).index()].add(p);
      all.add(p);
    }
  }
  const double size = all.diagonal();
  Shifts shifts;
  std::size_t in_the_middle = 0;
  for (const auto& of_body : boxes) {
    shifts.emplace_back();
    for (const geom::Box3& box : of_body) {
      const Vector3 way = box.centre() - all.centre();
      constexpr double middle = 0.02;  // of the size
      if (length(way) >= middle * size) {
        shifts.back().push_back(explosion * way);
        continue;
      }
      // Of several round one middle, as a body and its cavity, the first stays.
      shifts.back().push_back({0.0, 0.0, static_cast<double>(in_the_middle) * 1.2 * (all.high.z - all.low.z)});
      ++in_the_middle;
    }
  }
  return shifts;
}

/// Directed sides as closed loops. Where several leave one place, any order gives the same area.
std::vector<std::vector<Point>> loops_of(const std::vector<geom::Segment>& sides) {
  std::map<std::pair<double, double>, std::vector<std::size_t>> leaving;
  const auto key = [](Point p) { return std::pair(p.x, p.y); };
  for (std::size_t i = sides.size(); i-- > 0;) leaving[key(sides[i].from)].push_back(i);
  std::vector<std::vector<Point>> loops;
  for (const geom::Segment& side : sides) {
    std::vector<Point> loop;
    Point at = side.from;
    while (!leaving[key(at)].empty()) {
      const std::size_t next = leaving[key(at)].back();
      leaving[key(at)].pop_back();
      loop.push_back(at);
      at = sides[next].to;
      if (at == loop.front()) break;
    }
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

/// The coordinate of a section along a direction: "x", or "-x", where that is an axis.
std::string axis_title(const Vector3& along, const std::string& otherwise) {
  constexpr double square = 1.0 - 1e-12;
  const std::array<std::pair<double, const char*>, 3> axes{{{along.x, "x"}, {along.y, "y"}, {along.z, "z"}}};
  for (const auto& [part, name] : axes) {
    if (part > square) return fmt::format("{} [m]", name);
    if (part < -square) return fmt::format("\u2212{} [m]", name);
  }
  return otherwise + " [m]";
}

}  // namespace

std::vector<std::string> face_names(const solids::Part& part) {
  std::vector<std::string> names;
  for (const solids::Body& body : part.bodies) {
    for (const std::string& name : body.solid.boundary().names) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void draw_solids(const model::Model& model, scene::space::SpacePicture& picture) {
  if (!model.solids || model.solids->parts.empty()) return;
  const auto& parts = model.solids->parts;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    add_part(parts[i], "part." + parts[i].name, parts[i].name, false, {}, nullptr, picture.layers);
  const solids::Part& last = parts.back();
  add_part(last, solid_layer, last.name, true, {}, solid_edges_layer, picture.layers);
  std::size_t shells = 0;
  for (const solids::Body& body : last.bodies) shells += body.solid.shell_count();
  if (shells > 1)
    add_part(last, exploded_layer, translated("Shells apart"), false, shifts_of(last), exploded_edges_layer,
             picture.layers);
  picture.camera = scene::space::camera_of(scene::space::StandardView::Isometric);
}

SolidSections::SolidSections(std::shared_ptr<const solids::Parts> parts)
    : parts_(std::move(parts)), sections_([this] {
        std::vector<solid::Solid> solids;
        for (const solids::Body& body : parts_->parts.back().bodies) {
          solids.push_back(body.solid);
          materials_.push_back(body.material);
        }
        return solid::Sections(solids);
      }()) {}

std::optional<SolidSections::Made> SolidSections::cut(const scene::space::CutPlane& plane) const {
  const Vector3 n = plane.normal / length(plane.normal);
  const auto section = sections_.cut({n.x, n.y, n.z, -dot(n, plane.through - Point3{})});
  if (!section) return std::nullopt;
  const solid::Cap cap = solid::cap_of(*section);
  if (cap.empty()) return std::nullopt;
  const solids::Part& part = parts_->parts.back();
  Made made;
  made.panel.key = section_panel_key;
  made.panel.title = translated("Section");
  made.panel.axes.x_title = axis_title(cap.frame.along, translated("along the section"));
  made.panel.axes.y_title = axis_title(cap.frame.up, translated("up the section"));
  std::vector<scene::Regions> areas(part.bodies.size());
  scene::space::Surface caps;
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> ids;
  std::vector<scene::Color> colors;
  for (const solid::CapRegion& region : cap.regions) {
    scene::Region area;
    mesh::delaunay::MeshInput input;
    for (std::vector<Point>& loop : loops_of(region.sides)) {
      mesh::delaunay::add_chain(input, loop, mesh::delaunay::Closure::Closed, {"loop"});
      area.contours.push_back({std::move(loop), true});
    }
    areas[region.solid].regions.push_back(std::move(area));
    areas[region.solid].ids.push_back(region.solid);
    const auto flat = mesh::delaunay::constrained_delaunay(input, mesh::delaunay::Outside::Remove);
    if (!flat) continue;
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Point p : flat->mesh.points) points.push_back(cap.frame.in_space(p));
    for (const auto& t : flat->mesh.triangles) {
      triangles.push_back({first + static_cast<std::uint32_t>(t[0].index()),
                           first + static_cast<std::uint32_t>(t[1].index()),
                           first + static_cast<std::uint32_t>(t[2].index())});
      ids.push_back(region.solid);
      colors.push_back(scene::unit_style(region.solid).fill);
    }
  }
  for (std::size_t b = 0; b < areas.size(); ++b) {
    if (areas[b].regions.empty()) continue;
    const std::string& name = materials_[b].empty() ? part.name : materials_[b];
    made.panel.layers.push_back({.key = fmt::format("body.{}", b + 1),
                                 .title = name,
                                 .style = {.line_width = 0.0, .fill = scene::unit_style(b).fill},
                                 .content = std::move(areas[b])});
  }
  const std::vector<std::string> names = face_names(part);
  scene::Lines lines;
  for (const solid::CapLine& line : cap.lines) {
    lines.lines.push_back(line.line);
    const auto name = line.names.empty() ? names.end() : std::lower_bound(names.begin(), names.end(), line.names[0]);
    lines.ids.push_back(static_cast<std::uint32_t>(name - names.begin()));
  }
  made.panel.layers.push_back({.key = solid_layer,
                               .title = translated("Faces that are cut"),
                               .style = {.line = edge_color, .line_width = 1.6},
                               .content = std::move(lines),
                               .visible = true,
                               .in_legend = scene::InLegend::No,
                               .legend = {}});
  caps.points = std::move(points), caps.triangles = std::move(triangles);
  caps.ids = std::move(ids), caps.colors = std::move(colors);
  made.caps.push_back({.key = std::string(solid_layer) + std::string(scene::space::cap_end),
                       .title = translated("Section"),
                       .style = {.line_width = 0.0, .fill = one_body},
                       .content = std::move(caps),
                       .visible = true,
                       .in_legend = scene::InLegend::No,
                       .legend = {},
                       .names = materials_});
  return made;
}

}  // namespace quebra::core
