// Figure of subdivision.md.
#include <fmt/format.h>

#include "shared/topo/insert.h"
#include "shared/topo/locate.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using topo::Subdivision;

/// A contour cut by a line that ends inside, a hole, a dangling edge in it, and an isolated vertex.
std::vector<geom::Polyline> curves() {
  return {contour({{0, 0}, {9, 0}, {9, 6}, {0, 6}}), chain({{-1, 3.4}, {2.5, 2.6}, {4.0, 4.0}, {4.6, 7}}),
          contour({{5.2, 1.2}, {7.6, 1.2}, {7.6, 3.4}, {5.2, 3.4}}), chain({{9, 6}, {7.2, 4.2}}),
          chain({{4.2, -0.9}, {3.4, 1.4}})};
}
constexpr Point isolated{1.3, 1.2};

scene::Region area_of(const Subdivision& s, topo::FaceId face) {
  scene::Region region;
  for (const topo::LoopId loop : s.loops(face)) {
    geom::Polyline round{{}, true};
    for (const topo::HalfEdgeId h : s.half_edges(loop)) round.points.push_back(s.point(s.origin(h)));
    if (!round.points.empty()) region.contours.push_back(std::move(round));
  }
  return region;
}

/// A half-edge as an arrow beside its edge, in the face that it bounds.
geom::Polyline arrow(const geom::Segment& edge) {
  constexpr double gap = 0.11;
  const geom::Vector along = geom::normalised(edge.to - edge.from);
  const geom::Vector left = geom::left_of(along);
  const Point from = edge.from + 3.2 * gap * along + gap * left;
  const Point to = edge.to - 3.2 * gap * along + gap * left;
  return chain({from, to, to - 1.6 * gap * along + 0.9 * gap * left});
}

std::vector<geom::Polyline> arrows(const Subdivision& s) {
  std::vector<geom::Polyline> all;
  for (const topo::EdgeId e : s.edges()) {
    all.push_back(arrow(s.segment(Subdivision::half_edge(e))));
    all.push_back(arrow(s.segment(Subdivision::twin(Subdivision::half_edge(e)))));
  }
  return all;
}

std::vector<scene::Layer> faces(const Subdivision& s) {
  static constexpr std::array<scene::Color, 4> fills{
      {{214, 226, 240}, {247, 228, 198}, {214, 232, 214}, {240, 216, 212}}};
  std::vector<scene::Layer> layers;
  for (const topo::FaceId f : s.faces()) {
    if (f == Subdivision::unbounded()) continue;
    layers.push_back(regions({}, filled(fills[f.index() % fills.size()]), {area_of(s, f)}));
  }
  return layers;
}

/// Each face named where `locate` finds it.
std::vector<scene::Label> face_names(const Subdivision& s) {
  std::vector<scene::Label> names;
  for (const Point p : {Point{2.2, 5.0}, Point{6.1, 5.2}, Point{6.4, 2.3}, Point{6.6, 6.6}}) {
    const topo::FaceId f = topo::locate(s, p).face;
    const std::string loops = s.loops(f).size() == 1 ? "1 loop" : fmt::format("{} loops", s.loops(f).size());
    names.push_back({p, fmt::format("face {}: {}", f.index(), loops)});
  }
  return names;
}

base::Result<scene::Picture> subdivision() {
  Subdivision s;
  for (const geom::Polyline& curve : curves()) DOBRA_TRY_VOID(topo::insert(s, curve));
  DOBRA_TRY_VOID(topo::insert(s, isolated));
  std::vector<geom::Polyline> edges;
  for (const topo::EdgeId e : s.edges()) edges.push_back(chain({s.segment(e).from, s.segment(e).to}));
  std::vector<Point> vertices;
  for (const topo::VertexId v : s.vertices()) vertices.push_back(s.point(v));

  std::vector<scene::Layer> layers = faces(s);
  layers.push_back(lines("edges", stroke(ink, 1.6), edges));
  layers.push_back(lines("half-edges, their face on the left", stroke(blue, 1.0), arrows(s)));
  layers.push_back(markers("vertices", dots(red, 5.5), vertices));
  layers.push_back(labels(ink, face_names(s), 9.0));
  const std::string title = fmt::format("V \u2212 E + F = {} \u2212 {} + {} = 1 + {} components", s.vertex_count(),
                                        s.edge_count(), s.face_count(), s.component_count());
  return scene::Picture{{}, {panel(title, std::move(layers), 0.4)}};
}

}  // namespace

std::vector<Figure> topo_figures() { return {{"subdivision", subdivision}}; }

}  // namespace dobra::figures
