// Figures of trimming.md.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/common_edges.h"
#include "shared/surf/trim/open.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using geom::Point3;
using surf::trim::ChartEdge;
using surf::trim::ChartLoop;
using surf::trim::TrimLine;
using surf::trim::TrimmedSurface;
constexpr double pi = std::numbers::pi;

geom::Polyline along(const ChartEdge& edge) {
  std::vector<Point> points;
  constexpr int count = 96;
  for (int i = 0; i <= count; ++i) points.push_back(edge.at(std::lerp(edge.from, edge.to, 1.0 * i / count)));
  return chain(std::move(points));
}

/// The face filled, with its loops, and lines inside.
scene::Panel face_panel(std::string title, const TrimmedSurface& face, const scene::Axes& axes) {
  scene::Region region;
  std::vector<geom::Polyline> borders, shared, inside;
  for (const ChartLoop& loop : face.loops) {
    std::vector<Point> round;
    for (const ChartEdge& edge : loop.edges) {
      const geom::Polyline line = along(edge);
      round.insert(round.end(), line.points.begin(), line.points.end() - 1);
      (edge.shared ? shared : borders).push_back(line);
    }
    region.contours.push_back(contour(std::move(round)));
  }
  for (const surf::trim::ChartLine& line : face.lines) {
    for (const ChartEdge& edge : line.edges) inside.push_back(along(edge));
  }
  std::vector<scene::Layer> layers{regions("", filled(material), {region}), lines("loops", stroke(blue, 1.2), borders),
                                   lines("curves of two faces, seams", stroke(orange, 1.4), shared)};
  if (!inside.empty()) layers.push_back(lines("line inside", stroke(red, 1.2), inside));
  const double margin = 0.03 * region.contours.front().box().diagonal();
  return panel(std::move(title), std::move(layers), margin, axes);
}

base::Result<TrimLine> ellipse(Point middle, double a, double b) {
  DOBRA_TRY(const surf::Curve curve,
            surf::Curve::ellipse({middle.x, middle.y, 0}, {a, 0, 0}, {0, b, 0}, 0.0, 2.0 * pi));
  return TrimLine{{{{.curve = curve, .from = 0.0, .to = 2.0 * pi}}}, true};
}

base::Result<TrimmedSurface> picked(const surf::Surface& surface, const std::vector<TrimLine>& lines, Point at) {
  DOBRA_TRY(const surf::trim::Recognised found, surf::trim::recognise(surface, lines));
  DOBRA_TRY(const std::size_t face, found.pick(at));
  return found.faces()[face];
}

/// Sub-domains of a plate, a half pipe, a part of a sphere and a cone.
base::Result<scene::Picture> trimming() {
  scene::Picture picture;
  picture.arrangement = scene::Arrangement::Grid;
  DOBRA_TRY(const surf::Surface plate, surf::Surface::plane({}, {{0, 0}, {10, 10}}));
  DOBRA_TRY(const TrimLine hole, ellipse({3, 5}, 1.5, 1.5));
  DOBRA_TRY(const TrimmedSurface pierced,
            picked(plate, {hole, TrimLine{{{surf::trim::straight({6, 2}, {8, 8})}}}}, {1, 1}));
  picture.panels.push_back(face_panel("Plate, a hole and a line inside", pierced, {"u [m]", "v [m]"}));

  DOBRA_TRY(const surf::Surface half, surf::Surface::cylinder({}, 5.0, {{0, 0}, {pi, 10}}));
  DOBRA_TRY(const surf::Surface drill,
            surf::Surface::cylinder({{0, 0, 5}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, 2.0, {{0, 0}, {2.0 * pi, 8}}));
  DOBRA_TRY(const auto joint, surf::trim::common_edges(half, drill));
  TrimLine round;
  for (const surf::trim::CommonEdge& edge : joint) round.line.edges.push_back(edge.first);
  DOBRA_TRY(const TrimmedSurface drilled, picked(half, {round}, {0.2, 1}));
  picture.panels.push_back(face_panel("Half a pipe, drilled", drilled, {"u [rad]", "v [m]"}));

  DOBRA_TRY(const surf::Surface ball, surf::Surface::sphere({}, 5.0, {{0, -pi / 3.0}, {pi, pi / 3.0}}));
  DOBRA_TRY(const std::vector<ChartEdge> cut, surf::trim::plane_edges(ball, {3, 0, 0}, {1, 0, 1}));
  std::vector<TrimLine> cuts;
  for (const ChartEdge& edge : cut) cuts.push_back({{{edge}}});
  DOBRA_TRY(const TrimmedSurface kept, picked(ball, cuts, {2.5, 0}));
  picture.panels.push_back(face_panel("Part of a sphere where x + z <= 3", kept, {"u [rad]", "v [rad]"}));

  DOBRA_TRY(const surf::Surface cone, surf::Surface::cone({}, 0.0, 0.7, {{0, 0}, {2.0 * pi, 5}}));
  DOBRA_TRY(const TrimLine over_seam, ellipse({6.1, 3}, 1.0, 1.2));
  DOBRA_TRY(const TrimmedSurface open_cone, picked(cone, {over_seam}, {3, 1}));
  picture.panels.push_back(face_panel("Cone with a hole over its seam", open_cone, {"u [rad]", "v [m]"}));
  surf::trim::SharedNumbers numbers;
  DOBRA_TRY(const auto opened, surf::trim::open(open_cone, numbers));
  picture.panels.push_back(
      face_panel("The same, opened: the apex is a point", opened.front().face, {"x [m]", "y [m]"}));
  return picture;
}

}  // namespace

std::vector<Figure> trim_figures() { return {{"trimming", trimming, 760.0}}; }

}  // namespace dobra::figures
