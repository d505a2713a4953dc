// Figures of paper_mesher.md, surface_border.md and surface_front.md.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shared/mesh/quality.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/paper/paper_mesher.h"
#include "tests/figures/figures.h"
#include "tests/support/surface_stand_ins.h"

namespace dobra::figures {
namespace {

using geom::Point;
using geom::Point3;
using surf::mesh::ChartInput;
using surf::paper::ChartQuadtree;
using surf::paper::PaperMesher;

const scene::Axes no_axes{"", "", scene::AxisScale::None};

/// From the south-west, 30 degrees above the plane.
Point from_south_west(Point3 p) {
  return {(p.x - p.y) * std::sqrt(0.5), std::sqrt(0.75) * p.z + (p.x + p.y) * std::sqrt(1.0 / 8.0)};
}
/// How far away it is from there.
double depth_of(Point3 p) { return (p.x + p.y) * std::sqrt(3.0 / 8.0) - 0.5 * p.z; }

/// The chart of Coons's patch, which is as wide as 1, beside the patch, which is as wide as 10.
constexpr double beside = 10.0;
Point enlarged(Point uv) { return {beside * uv.x, beside * uv.y}; }
std::vector<Point> enlarged(const std::vector<Point>& places) {
  std::vector<Point> all;
  for (const Point uv : places) all.push_back(enlarged(uv));
  return all;
}

surf::test::StandIn stand_in(const std::string& name) {
  const auto all = surf::test::stand_ins();
  return *std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
}

base::Result<surf::mesh::Division> divided(const surf::test::StandIn& s, surf::mesh::DivisionKind kind) {
  surf::mesh::DivisionOptions options;
  options.kind = kind;
  options.sizes.largest = s.largest;
  options.sizes.turn = s.turn;
  return surf::mesh::divide({&s.face, 1}, options);
}

/// Straight lines of the chart as they run on the surface.
geom::Polyline on_surface(const surf::Surface& surface, Point a, Point b) {
  std::vector<Point> points;
  constexpr int parts = 4;
  for (int i = 0; i <= parts; ++i) {
    points.push_back(from_south_west(surface.at(geom::interpolate(a, b, static_cast<double>(i) / parts))));
  }
  return chain(std::move(points));
}

/// The triangles, what is farther from the eye first, coloured by alpha in space.
scene::Layer triangles_in(const PaperMesher::View& view, const std::vector<Point>& points, double width = 0.3) {
  std::vector<std::size_t> order(view.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto depth = [&](std::size_t t) {
    double sum = 0.0;
    for (const std::uint32_t n : view.triangles[t]) sum += depth_of(view.points[n]);
    return sum;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depth(a) > depth(b); });
  scene::Mesh mesh{.values_at = scene::ValuesAt::Triangles};
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<double> values;
  for (const std::size_t t : order) {
    const auto& c = view.triangles[t];
    corners.push_back(c);
    values.push_back(mesh::alpha_in_space(view.points[c[0]], view.points[c[1]], view.points[c[2]]));
  }
  mesh.points = points;
  mesh.triangles = std::move(corners);
  mesh.values = std::move(values);
  mesh.scale = {"alpha", scene::ColorMapName::Quality, 0.0, 1.0};
  return {{}, {}, stroke({38, 50, 56, 170}, width), std::move(mesh), true, InLegend::No};
}

scene::Panel in_chart(std::string title, const PaperMesher::View& view) {
  return panel(std::move(title), {triangles_in(view, enlarged(view.places))}, 0.2, no_axes);
}
scene::Panel in_space(std::string title, const PaperMesher::View& view) {
  std::vector<Point> points;
  for (const Point3 p : view.points) points.push_back(from_south_west(p));
  return panel(std::move(title), {triangles_in(view, points)}, 0.5, no_axes);
}

base::Result<PaperMesher> started(const surf::test::StandIn& s, const ChartInput& input) {
  return PaperMesher::start(input, {.largest = s.largest, .turn = s.turn});
}

/// The surface of fig. 2 of the paper, by its stand-in, with the cells of its quadtree.
base::Result<scene::Picture> paper_quadtree() {
  const surf::test::StandIn s = stand_in("6a");
  DOBRA_TRY(const surf::mesh::Division division, divided(s, surf::mesh::DivisionKind::Halving));
  const ChartInput& input = division.faces[0];
  DOBRA_TRY(const ChartQuadtree tree, ChartQuadtree::build(input, {.largest = s.largest, .turn = s.turn}));
  std::vector<geom::Polyline> cells, bent;
  for (const auto leaf : tree.leaves()) {
    const geom::Box box = tree.box(leaf);
    cells.push_back(outline({enlarged(box.low), enlarged(box.high)}));
    const Point a = box.low, b{box.high.x, box.low.y}, c = box.high, d{box.low.x, box.high.y};
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
      bent.push_back(on_surface(input.surface, from, to));
    }
  }
  std::vector<Point> nodes;
  for (const Point3 p : input.at) nodes.push_back(from_south_west(p));
  scene::Picture picture;
  picture.panels.push_back(panel("on the surface",
                                 {lines({}, stroke(grey, 0.5), std::move(bent)), markers({}, dots(blue, 3), nodes)},
                                 0.5, no_axes));
  picture.panels.push_back(
      panel("in the chart",
            {lines({}, stroke(grey, 0.6), std::move(cells)), markers({}, dots(blue, 3), enlarged(input.chart.points))},
            0.5, no_axes));
  return picture;
}

base::Result<scene::Picture> paper_front() {
  const surf::test::StandIn s = stand_in("6a");
  DOBRA_TRY(const surf::mesh::Division division, divided(s, surf::mesh::DivisionKind::Halving));
  DOBRA_TRY(PaperMesher mesher, started(s, division.faces[0]));
  scene::Picture picture;
  for (const std::uint32_t level : {1U, 2U, 4U, 7U}) {
    while (mesher.next().stage == PaperMesher::Stage::Front && mesher.next().level < level) {
      DOBRA_TRY_VOID(mesher.step(1));
    }
    const auto view = mesher.view();
    scene::Panel made = in_chart("after " + std::to_string(level) + (level == 1 ? " level" : " levels"), view);
    std::vector<geom::Polyline> front;
    for (const auto& side : view.front)
      front.push_back(chain({enlarged(view.places[side.nodes[0]]), enlarged(view.places[side.nodes[1]])}));
    scene::Layer sides = lines({}, stroke(blue, 1.5), std::move(front));
    sides.key = "front";
    made.layers.push_back(std::move(sides));
    picture.panels.push_back(std::move(made));
  }
  return picture;
}

base::Result<scene::Picture> paper_smooth() {
  const surf::test::StandIn s = stand_in("6a");
  DOBRA_TRY(const surf::mesh::Division division, divided(s, surf::mesh::DivisionKind::Halving));
  DOBRA_TRY(PaperMesher mesher,
            PaperMesher::start(division.faces[0], {.largest = s.largest, .turn = s.turn, .passes = 5}));
  while (mesher.next().stage == PaperMesher::Stage::Front) DOBRA_TRY_VOID(mesher.step(100));
  const auto before = mesher.view();
  while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(1));
  const auto after = mesher.view();
  scene::Picture picture;
  picture.panels.push_back(in_chart("before", before));
  picture.panels.push_back(in_space("before", before));
  picture.panels.push_back(in_chart("after five passes", after));
  picture.panels.push_back(in_space("after five passes", after));
  return picture;
}

/// So far is a stand-in turned about the vertical, degrees, for what matters to be in front.
double turned_by(const std::string& name) { return name == "7b" ? 20.0 : name == "8d" ? 115.0 : 0.0; }
Point3 turned(Point3 p, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
  return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

/// The whole mesh of a stand-in as seen from the south-west, in a square of 1 whose middle is at a place.
base::Result<scene::Layer> meshed(const std::string& name, double turn, Point place) {
  surf::test::StandIn s = stand_in(name);
  s.turn = std::max(s.turn, turn);
  DOBRA_TRY(const surf::mesh::Division division, divided(s, surf::mesh::DivisionKind::Halving));
  DOBRA_TRY(PaperMesher mesher, started(s, division.faces[0]));
  while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(10'000));
  PaperMesher::View view = mesher.view();
  for (Point3& p : view.points) p = turned(p, turned_by(name));
  std::vector<Point> points;
  for (const Point3 p : view.points) points.push_back(from_south_west(p));
  const geom::Box box = geom::box_of(points);
  const double scale = 1.0 / std::max(box.width(), box.height());
  const Point middle = box.centre();
  for (Point& p : points) p = {place.x + scale * (p.x - middle.x), place.y + scale * (p.y - middle.y)};
  return triangles_in(view, points, 0.2);
}

/// Three in a row.
base::Result<scene::Picture> meshed(const std::vector<std::string>& names, double turn = 0.0) {
  constexpr std::size_t columns = 3;
  std::vector<scene::Layer> layers;
  std::vector<scene::Label> titles;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Point place{1.2 * static_cast<double>(i % columns), -1.15 * static_cast<double>(i / columns)};
    DOBRA_TRY(scene::Layer made, meshed(names[i], turn, place));
    layers.push_back(std::move(made));
    titles.push_back({.at = {place.x - 0.52, place.y + 0.48}, .text = names[i]});
  }
  layers.push_back(labels(ink, std::move(titles), 12.0));
  scene::Picture picture;
  picture.panels.push_back(panel("", std::move(layers), 0.05, no_axes));
  return picture;
}
base::Result<scene::Picture> paper_coons() { return meshed({"6a", "6b", "6c"}); }
base::Result<scene::Picture> paper_curvatures() { return meshed({"7a", "7b", "7c", "7d", "7e", "7f"}, 10.0); }
base::Result<scene::Picture> paper_trims() { return meshed({"8a", "8b", "8c", "8d", "8e", "8f"}); }

/// Alpha of a triangle over the base 1 with equal legs, by its height.
base::Result<scene::Picture> paper_alpha() {
  std::vector<Point> curve;
  for (int i = 10; i <= 200; ++i) {
    const double height = 0.01 * i;
    curve.push_back({height, mesh::alpha_in_space({0, 0, 0}, {1, 0, 0}, {0.5, height, 0})});
  }
  scene::Layer good = lines("alpha 0.9", stroke(grey, 1.0, scene::Dash::Dashed), {chain({{0.1, 0.9}, {2.0, 0.9}})});
  scene::Picture picture;
  picture.panels.push_back(panel("", {lines("alpha", stroke(blue, 1.5), {chain(std::move(curve))}), std::move(good)},
                                 0.05, {"H / L", "alpha", scene::AxisScale::Diagram}));
  return picture;
}

base::Result<scene::Picture> surface_border() {
  const surf::test::StandIn s = stand_in("8f");
  scene::Picture picture;
  for (const auto kind : {surf::mesh::DivisionKind::Halving, surf::mesh::DivisionKind::Even}) {
    DOBRA_TRY(const surf::mesh::Division division, divided(s, kind));
    const ChartInput& input = division.faces[0];
    std::vector<geom::Polyline> sides;
    std::vector<Point> nodes;
    for (const auto& edge : input.chart.edges) {
      sides.push_back(
          chain({from_south_west(input.at[edge.nodes[0].index()]), from_south_west(input.at[edge.nodes[1].index()])}));
    }
    for (const Point3 p : input.at) nodes.push_back(from_south_west(p));
    picture.panels.push_back(panel(
        kind == surf::mesh::DivisionKind::Halving ? "halving" : "even",
        {lines({}, stroke(ink, 1.0), std::move(sides)), markers({}, dots(red, 4), std::move(nodes))}, 0.5, no_axes));
  }
  return picture;
}

/// What engine `front` makes of the same border.
base::Result<scene::Picture> surface_front() {
  const surf::test::StandIn s = stand_in("8f");
  DOBRA_TRY(const surf::mesh::Division division, divided(s, surf::mesh::DivisionKind::Even));
  DOBRA_TRY(const surf::mesh::FaceMesh face,
            surf::mesh::mesh_chart(division.faces[0], {.sizes = {.largest = s.largest, .turn = s.turn}}));
  PaperMesher::View view{.places = face.chart.points, .points = face.at, .triangles = {}, .front = {}};
  for (const auto& c : face.chart.triangles) {
    const auto index = [&](std::size_t i) { return static_cast<std::uint32_t>(c[i].index()); };
    view.triangles.push_back({index(0), index(1), index(2)});
  }
  scene::Picture picture;
  picture.panels.push_back(in_chart("in the chart", view));
  picture.panels.push_back(in_space("in space", view));
  return picture;
}

}  // namespace

std::vector<Figure> paper_figures() {
  return {{"surface_border", surface_border},
          {"surface_front", surface_front},
          {"paper_quadtree", paper_quadtree},
          {"paper_front", paper_front},
          {"paper_smooth", paper_smooth},
          {"paper_alpha", paper_alpha, 500.0},
          {"paper_coons", paper_coons, 900.0, true},
          {"paper_curvatures", paper_curvatures, 900.0, true},
          {"paper_trims", paper_trims, 900.0, true}};
}

}  // namespace dobra::figures
