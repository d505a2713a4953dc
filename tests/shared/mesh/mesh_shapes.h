#pragma once
// Inputs that several tests of the mesher share.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/mesh/front/fill_engine.h"
#include "tests/support/corpus.h"

namespace dobra::mesh::test {

using geom::Point;

inline std::vector<Point> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = unit(random);
    points.push_back({x, unit(random)});
  }
  return points;
}

inline delaunay::MeshInput square(double side, int segments) {
  std::vector<Point> loop;
  const std::vector<Point> corner{{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < segments; ++i)
      loop.push_back(geom::interpolate(corner[k], corner[(k + 1) % 4], double(i) / segments));
  }
  delaunay::MeshInput input;
  add_chain(input, loop, delaunay::Closure::Closed, {"outer", delaunay::EdgeKind::Boundary});
  return input;
}

/// Quarter circle about the origin from (radius, 0) to (0, radius), its ends exactly on the axes.
inline std::vector<Point> quarter_arc(double radius, int segments) {
  std::vector<Point> points{{radius, 0.0}};
  for (int i = 1; i < segments; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / segments;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  points.push_back({0.0, radius});
  return points;
}

/// Positions from `from` to `to`, spacing growing by `ratio`.
inline std::vector<double> graded(double from, double to, int segments, double ratio) {
  double sum = 0.0;
  for (int i = 0; i < segments; ++i) sum += std::pow(ratio, i);
  std::vector<double> positions{from};
  double step = (to - from) / sum;
  for (int i = 0; i + 1 < segments; ++i, step *= ratio) positions.push_back(positions.back() + step);
  positions.push_back(to);
  return positions;
}

struct Ring {
  double radius;
  int segments;
};

/// [0,5]^2 minus the disc of radius 1; `axis`: nodes on both axes; `outer`: segments of the two outer sides.
inline delaunay::MeshInput quarter_plate(const std::vector<double>& axis, int hole, int outer,
                                         const std::vector<Ring>& rings) {
  std::vector<Point> bottom, left, right, top;
  for (const double a : axis) bottom.push_back({a, 0.0});
  for (auto a = axis.rbegin(); a != axis.rend(); ++a) left.push_back({0.0, *a});
  for (int i = 0; i <= outer; ++i) right.push_back({5.0, 5.0 * i / outer});
  for (int i = 0; i <= outer; ++i) top.push_back({5.0 - 5.0 * i / outer, 5.0});
  std::vector<Point> arc = quarter_arc(1.0, hole);
  delaunay::MeshInput input;
  add_chain(input, bottom, delaunay::Closure::Open, {"bottom", delaunay::EdgeKind::Boundary});
  add_chain(input, right, delaunay::Closure::Open, {"right", delaunay::EdgeKind::Boundary});
  add_chain(input, top, delaunay::Closure::Open, {"top", delaunay::EdgeKind::Boundary});
  add_chain(input, left, delaunay::Closure::Open, {"left", delaunay::EdgeKind::Boundary});
  add_chain(input, {arc.rbegin(), arc.rend()}, delaunay::Closure::Open, {"hole", delaunay::EdgeKind::Boundary});
  for (std::size_t k = 0; k < rings.size(); ++k) {
    add_chain(input, quarter_arc(rings[k].radius, rings[k].segments), delaunay::Closure::Open,
              {"constraint " + std::to_string(k + 1), delaunay::EdgeKind::Constraint});
  }
  return input;
}

/// Area of quarter_plate: the hole is a polygon.
inline double quarter_plate_area(int hole) { return 25.0 - 0.5 * hole * std::sin(0.5 * std::numbers::pi / hole); }

/// Quarter plate: hole arc of 24 segments, five on each outer side and on each axis.
inline delaunay::MeshInput que_d() { return quarter_plate(graded(1.0, 5.0, 5, 1.0), 24, 5, {}); }

/// The same with the six constraints d0 = 0.065, f = 1.3, whose nodes stand at the local ring spacing: the mean of the
/// gaps on both sides. Beyond the last constraint the axes have five segments.
inline delaunay::MeshInput que_e() {
  std::vector<double> axis{1.0};
  std::vector<Ring> rings;
  double gap = 0.065;
  for (int k = 0; k < 6; ++k, gap *= 1.3) {
    axis.push_back(axis.back() + gap);
    const double spacing = 0.5 * (gap + 1.3 * gap);
    rings.push_back({axis.back(), static_cast<int>(std::lround(0.5 * std::numbers::pi * axis.back() / spacing))});
  }
  const std::vector<double> rest = graded(axis.back(), 5.0, 5, 1.35);
  axis.insert(axis.end(), rest.begin() + 1, rest.end());
  return quarter_plate(axis, 24, 5, rings);
}

/// [0,10]^2 minus the disc of radius 1, with sides as long as `size(distance from the hole)` asks: one boundary set,
/// anticlockwise. For benchmarks: linear in the number of points.
template <class Size>
delaunay::MeshInput large_plate(const Size& size) {
  delaunay::MeshInput input;
  input.sets.push_back({"outline", delaunay::EdgeKind::Boundary});
  // Points from `from` up to, but without, `to`, spaced by the size there, stretched to end exactly.
  const auto line = [&](Point from, Point to) {
    const double length = geom::distance(from, to);
    const auto size_at = [&](double s) {
      const Point p = geom::interpolate(from, to, s / length);
      return size(std::hypot(p.x, p.y) - 1.0);
    };
    std::vector<double> positions{0.0};
    while (positions.back() < length) {
      const double middle = positions.back() + 0.5 * size_at(positions.back());
      positions.push_back(positions.back() + size_at(std::min(middle, length)));
    }
    if (positions.size() > 2 && positions.back() - length > 0.5 * (positions.back() - positions[positions.size() - 2]))
      positions.pop_back();
    const double stretch = length / positions.back();
    positions.pop_back();
    for (const double s : positions) input.points.push_back(geom::interpolate(from, to, stretch * s / length));
  };
  line({1, 0}, {10, 0});
  line({10, 0}, {10, 10});
  line({10, 10}, {0, 10});
  line({0, 10}, {0, 1});
  const int arc = static_cast<int>(std::lround(0.5 * std::numbers::pi / size(0.0)));
  std::vector<Point> hole = quarter_arc(1.0, arc);
  input.points.insert(input.points.end(), hole.rbegin(), hole.rend() - 1);
  const std::size_t count = input.points.size();
  for (std::size_t i = 0; i < count; ++i) input.edges.push_back({{NodeId(i), NodeId((i + 1) % count)}, 0});
  return input;
}

/// About `triangles` of one size.
inline delaunay::MeshInput uniform_plate(double triangles) {
  const double size = std::sqrt((100.0 - 0.25 * std::numbers::pi) * 4.0 / std::numbers::sqrt3 / triangles);
  return large_plate([size](double) { return size; });
}

/// A thousand times as large in the far corner as on the hole, linear in between; and the growth that makes it so.
struct GradedPlate {
  delaunay::MeshInput input;
  double growth = 0.0;
};
inline GradedPlate graded_plate(double triangles) {
  const double far = std::sqrt(200.0) - 1.0;
  // Between the hole and the circle of radius 10: integral of 4 / sqrt(3) * pi / 2 * r / size^2.
  double smallest = 1e-3;
  for (int k = 0; k < 50; ++k) {
    const double slope = 999.0 * smallest / far;
    const auto integral = [&](double r) {
      const double size = smallest + slope * (r - 1.0);
      return (std::log(size) + (smallest - slope) / size) / (slope * slope);
    };
    const double count = 2.0 * std::numbers::pi / std::numbers::sqrt3 * (integral(10.0) - integral(1.0));
    smallest *= std::sqrt(count / triangles);
  }
  const double slope = 999.0 * smallest / far;
  return {large_plate([=](double d) { return smallest + slope * d; }), 1.0 + slope};
}

/// The corpus of contours; empty where DOBRA_TEST_DATA does not name the folder that holds it.
inline std::filesystem::path contours_folder() {
  const auto data = dobra::test::data_folder();
  return data && std::filesystem::is_directory(*data / "contours") ? *data / "contours" : std::filesystem::path();
}

/// cdt_*.txt ("points edges", points, index pairs) or a *.dat outline, as one boundary set.
inline delaunay::MeshInput read_contour(const std::filesystem::path& file) {
  std::ifstream in(file);
  delaunay::MeshInput input;
  if (file.extension() == ".dat") {
    std::vector<Point> loop;
    for (Point p; in >> p.x >> p.y;) loop.push_back(p);
    add_chain(input, loop, delaunay::Closure::Closed, {"outline", delaunay::EdgeKind::Boundary});
    return input;
  }
  std::size_t points = 0;
  std::size_t edges = 0;
  in >> points >> edges;
  input.points.resize(points);
  for (Point& p : input.points) in >> p.x >> p.y;
  input.sets.push_back({"outline", delaunay::EdgeKind::Boundary});
  for (std::size_t i = 0; i < edges; ++i) {
    std::size_t a = 0;
    std::size_t b = 0;
    in >> a >> b;
    input.edges.push_back({{NodeId(a), NodeId(b)}, 0});
  }
  return input;
}

/// `input` with its edges cut into pieces no longer than `size`.
inline delaunay::MeshInput divided(const delaunay::MeshInput& input, double size) {
  delaunay::MeshInput result = input;
  result.edges.clear();
  for (const delaunay::InputEdge& edge : input.edges) {
    const Point a = input.points[edge.nodes[0].index()];
    const Point b = input.points[edge.nodes[1].index()];
    const int pieces = std::max(1, static_cast<int>(std::ceil(geom::distance(a, b) / size)));
    NodeId from = edge.nodes[0];
    for (int i = 1; i <= pieces; ++i) {
      const NodeId to = i < pieces ? NodeId(result.points.size()) : edge.nodes[1];
      if (i < pieces) result.points.push_back(geom::interpolate(a, b, static_cast<double>(i) / pieces));
      result.edges.push_back({{from, to}, edge.set});
      from = to;
    }
  }
  return result;
}

inline base::Result<void> run_to_end(front::FillEngine& engine, const base::Progress& progress = {}) {
  while (!engine.done()) DOBRA_TRY_VOID(engine.step(1000, progress));
  return {};
}

/// Area enclosed by the boundary edges: sum of their moments about the middle, signed by the direction of each loop;
/// holes must run against their outer loop.
inline double boundary_area(const TriangleMesh& mesh) {
  double area = 0.0;
  const Point origin = mesh.box().centre();
  for (const auto& [name, edges] : mesh.boundary_sets) {
    for (const Edge& edge : edges)
      area += 0.5 * geom::cross(mesh.point(edge[0]) - origin, mesh.point(edge[1]) - origin);
  }
  return area;
}

}  // namespace dobra::mesh::test
