// Figure of import_of_faces.md.
#include <cmath>
#include <numbers>

#include "shared/io/brep/faces.h"
#include "shared/io/faces/geometry.h"
#include "shared/io/faces/import.h"
#include "tests/figures/figures.h"
#include "tests/support/brep_writer.h"

namespace dobra::figures {
namespace {

using geom::Point;
using support::DraftFace;

constexpr double round_axis = 2.0 * std::numbers::pi;

/// A pipe without a seam among its edges, with a hole of which two edges lie a turn beside the others, and which runs
/// the wrong way.
std::string pipe_without_seam() {
  DraftFace face;
  face.surface = {fmt::format("2 0 0 0 0 0 1 1 0 0 0 1 0 {}\n", 1.0), [](Point uv) {
                    return geom::Point3{std::cos(uv.x), std::sin(uv.x), uv.y};
                  }};
  const auto add = [&](Point a, Point b, std::size_t first, std::size_t last) {
    return face.add_edge({.path = support::line_path(a, b), .a = first, .b = last});
  };
  const std::size_t low = face.add_vertex({0.0, 0.0}), high = face.add_vertex({0.0, 3.0});
  face.wires.push_back({{add({0.0, 0.0}, {round_axis, 0.0}, low, low)}});
  face.wires.push_back({{add({round_axis, 3.0}, {0.0, 3.0}, high, high)}});
  const std::vector<Point> corners{{1.0, 0.8}, {2.2, 0.6}, {2.6, 1.7}, {1.8, 2.4}, {1.1, 1.9}};
  std::vector<std::size_t> vertices;
  for (const Point corner : corners) vertices.push_back(face.add_vertex(corner));
  std::vector<DraftFace::Use> hole;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    const geom::Vector aside{i == 1 || i == 2 ? round_axis : 0.0, 0.0};
    hole.push_back({add(corners[i] + aside, corners[next] + aside, vertices[i], vertices[next])});
  }
  face.wires.push_back(std::move(hole));
  return support::brep_text(face);
}

/// With a head half-way that says where it goes.
void add_curve(std::vector<geom::Polyline>& all, const std::function<Point(double)>& at) {
  std::vector<Point> points;
  constexpr int parts = 24;
  for (int i = 0; i <= parts; ++i) points.push_back(at(static_cast<double>(i) / parts));
  const geom::Vector along = geom::normalised(points[13] - points[11]), left = geom::left_of(along);
  all.push_back(chain({points[12] - 0.16 * along + 0.08 * left, points[12], points[12] - 0.16 * along - 0.08 * left}));
  all.push_back(chain(std::move(points)));
}

base::Result<scene::Picture> import_of_faces() {
  DOBRA_TRY(const io::brep::Model model, io::brep::parse_brep(pipe_without_seam(), "pipe.brep"));
  DOBRA_TRY(const std::vector<io::brep::TrimmedFace> faces, io::brep::faces_of(model));
  std::vector<geom::Polyline> read;
  for (const auto& wire : faces[0].loops) {
    for (const io::brep::LoopEdge& edge : wire) {
      const io::brep::ChartPart& part = *edge.chart;
      DOBRA_TRY(const surf::Curve curve, io::faces::to_curve(*model.chart_curves[part.curve], part.from, part.to));
      add_curve(read, [&](double s) {
        const geom::Point3 p = curve.at(std::lerp(part.from, part.to, s));
        return Point{p.x, p.y};
      });
    }
  }
  DOBRA_TRY(const io::faces::Imported made, io::faces::faces_of_model(model));
  std::vector<geom::Polyline> mended, seam;
  for (const surf::trim::ChartLoop& loop : made.faces.at(0).loops) {
    for (const surf::trim::ChartEdge& edge : loop.edges) {
      const auto at = [&](double s) { return edge.at(std::lerp(edge.from, edge.to, s)); };
      add_curve(at(0.0).x == at(1.0).x ? seam : mended, at);
    }
  }
  scene::Picture picture;
  const scene::Axes axes{"u", "v", scene::AxisScale::Diagram};
  picture.panels.push_back(panel("in the file", {lines({}, stroke(red, 1.2), std::move(read))}, 0.3, axes));
  picture.panels.push_back(
      panel("as it is meshed",
            {lines("loops", stroke(blue, 1.2), std::move(mended)), lines("seam", stroke(orange, 1.2), std::move(seam))},
            0.3, axes));
  return picture;
}

}  // namespace

std::vector<Figure> import_figures() { return {{"import_of_faces", import_of_faces}}; }

}  // namespace dobra::figures
