// Random patches with random loops, lines and points: each is meshed, and the mesh holds what is checked here without
// the mesher, or is refused with a place. DOBRA_RANDOM_CASES=5000 for more, DOBRA_RANDOM_FIRST for the first seed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "shared/geom/predicates.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/mesh/free_borders.h"
#include "shared/surf/trim/mend.h"
#include "shared/surf/trim/open.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf::mesh::random_patches {
namespace {

using geom::Point;
using geom::Point3;
using geom::Vector;
using geom::Vector3;
using surf::test::Chance;
constexpr double pi = surf::test::pi;

// ---- what is meshed; places of holes, lines and points are parts of the ranges of the chart

struct Patch {
  std::string kind;
  Surface surface;
  int euler = 1;  ///< Of the surface without holes.
};

/// A closed line with no point outside its circle, of which it is a touching one at least.
struct Hole {
  Point middle;
  double radius = 0.0;
  Curve curve;  ///< In parts of the chart.
  std::vector<Point> ring;
};

struct Case {
  Patch patch;
  std::vector<Hole> holes;
  std::vector<Curve> lines;
  std::vector<Point> points;
  SizeOptions sizes;
};

Point3 jittered(Chance& chance, double x, double y, double much) {
  return {x + chance(-much, much), y + chance(-much, much), chance(-much, much)};
}

Surface net(Chance& chance, std::size_t n, double range_u, double range_v, double much, const std::string& collapse) {
  std::vector<Point3> points;
  std::vector<double> weights;
  const double step = 10.0 / static_cast<double>(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      points.push_back(jittered(chance, step * static_cast<double>(i), step * static_cast<double>(j), much * step));
      weights.push_back(chance(0.5, 2.0));
    }
  }
  const auto one = [&](auto&& of_side) {
    std::vector<std::size_t> side;
    for (std::size_t k = 0; k < n; ++k) side.push_back(of_side(k));
    for (const std::size_t k : side) points[k] = points[side[n / 2]];
  };
  for (const char side : collapse) {
    if (side == 'l') one([&](std::size_t k) { return k; });
    if (side == 'r') one([&](std::size_t k) { return (n - 1) * n + k; });
    if (side == 'b') one([&](std::size_t k) { return k * n; });
    if (side == 't') one([&](std::size_t k) { return k * n + n - 1; });
  }
  const std::size_t degree = std::min<std::size_t>(3, n - 1);
  const auto knots = [&](double range) {
    std::vector<double> values(degree + 1, 0.0);
    for (std::size_t k = 1; k + degree < n; ++k)
      values.push_back(range * static_cast<double>(k) / static_cast<double>(n - degree));
    values.insert(values.end(), degree + 1, range);
    return values;
  };
  return *Surface::nurbs(degree, knots(range_u), degree, knots(range_v), points, weights);
}

Patch coons_patch(Chance& chance) {
  const double much = chance.random() % 10 == 0 ? 8.0 : 2.5;  // of ten: the first may fold
  std::array<Point3, 4> corner;
  for (std::size_t i = 0; i < 4; ++i) corner[i] = jittered(chance, i % 2 ? 10.0 : 0.0, i / 2 ? 10.0 : 0.0, 1.0);
  const auto border = [&](Point3 a, Point3 b) {
    const Vector3 way = b - a;
    const auto near = [&](double t) { return a + (t * way + (jittered(chance, 0.0, 0.0, much) - Point3{})); };
    return *Curve::bezier({a, near(1.0 / 3.0), near(2.0 / 3.0), b});
  };
  return {"coons", *Surface::coons(border(corner[0], corner[1]), border(corner[2], corner[3]),
                                   border(corner[0], corner[2]), border(corner[1], corner[3]))};
}

Patch round_patch(Chance& chance, int kind) {
  const Frame frame = surf::test::tilted();
  const bool part = chance.random() % 3 == 0;
  const double from = chance(-3.0, 3.0), turn = part ? chance(0.5, 6.0) : 2.0 * pi;
  switch (kind) {
    case 0:
      return {"cylinder", *Surface::cylinder(frame, 3.0, {{from, 0.0}, {from + turn, chance(3.0, 12.0)}}),
              part ? 1 : 0};
    case 1: {
      const double low = chance.random() % 2 ? -0.5 * pi : chance(-1.2, 0.0);
      const double high = chance.random() % 2 ? 0.5 * pi : chance(0.3, 1.2);
      const int poles = (low == -0.5 * pi ? 1 : 0) + (high == 0.5 * pi ? 1 : 0);
      return {"sphere", *Surface::sphere(frame, 4.0, {{from, low}, {from + turn, high}}), part ? 1 : poles};
    }
    case 2: {
      const bool piece = chance.random() % 3 == 0;
      const double start = chance(-3.0, 3.0), round = piece ? chance(1.0, 6.0) : 2.0 * pi;
      return {"torus", *Surface::torus(frame, 5.0, chance(0.5, 3.0), {{from, start}, {from + turn, start + round}}),
              part && piece ? 1 : 0};
    }
    case 3: {
      const bool apex = chance.random() % 3 != 0;
      return {"cone",
              *Surface::cone(frame, 0.0, chance(0.2, 1.3), {{from, apex ? 0.0 : chance(0.5, 2.0)}, {from + turn, 8.0}}),
              part || apex ? 1 : 0};
    }
    default: {
      const Curve profile = *Curve::bezier({{3.0, 0.0, 0.0},
                                            jittered(chance, 5.0, 0.0, 1.0),
                                            {chance(2.0, 4.0), 0.0, 4.0},
                                            {chance(2.0, 6.0), 0.0, 8.0}});
      return {"revolved", *Surface::revolved(profile, {0, 0, 0}, {0, 0, 1}, from, from + turn), part ? 1 : 0};
    }
  }
}

Patch random_patch(Chance& chance) {
  switch (chance.random() % 10) {
    case 0: {
      static const char* const collapsed[] = {"", "", "", "b"};
      return {"bilinear", net(chance, 2, 1.0, 1.0, 0.25, collapsed[chance.random() % 4])};
    }
    case 1:
      return coons_patch(chance);
    case 2: {
      static const char* const collapsed[] = {"", "l", "t", "lr", "bt", "r", "b", "lb"};
      return {"nurbs", net(chance, 4 + chance.random() % 3, 1.0, 1.0, 0.3, collapsed[chance.random() % 8])};
    }
    case 3: {
      const double shear = chance(0.0, 20.0);
      return {"skewed", *Surface::plane({{1, 2, 3}, {1, 0, 0}, {shear, 1, 0.3 * shear}, {}}, {{0, 0}, {10, 10}})};
    }
    case 4: {
      const double ratio = std::pow(10.0, chance(-3.0, 3.0));
      return {"stretched", net(chance, 4, ratio, 1.0, 0.25, chance.random() % 3 ? "" : "l")};
    }
    default:
      return round_patch(chance, static_cast<int>(chance.random() % 5));
  }
}

/// A gap between 1e-2 and 1e-9.
double small_gap(Chance& chance) { return std::pow(10.0, chance(-9.0, -2.0)); }
Point on_circle(Point middle, double radius, double angle) {
  return middle + radius * Vector{std::cos(angle), std::sin(angle)};
}

Curve hole_curve(Chance& chance, Point middle, double radius, double towards) {
  if (chance.random() % 2) {
    return *Curve::arc({middle.x, middle.y, 0.0}, {radius, 0.0, 0.0}, {0.0, radius, 0.0}, towards, towards + 2.0 * pi);
  }
  std::vector<Point3> corners;
  const bool star = chance.random() % 2;
  const std::size_t n = 3 + chance.random() % 6;
  for (std::size_t i = 0; i < n; ++i) {
    const double step = 2.0 * pi / static_cast<double>(n), angle = towards + step * static_cast<double>(i);
    const Point out = on_circle(middle, radius, angle), in = on_circle(middle, 0.4 * radius, angle + 0.5 * step);
    corners.push_back({out.x, out.y, 0.0});
    if (star) corners.push_back({in.x, in.y, 0.0});
  }
  corners.push_back(corners.front());
  return *Curve::polyline(corners);
}

class CaseMaker {
 public:
  CaseMaker(Chance& chance, Case& made) : chance_(chance), made_(made) {}

  void run() {
    const std::size_t holes = chance_.random() % 5;
    for (std::size_t i = 0; i < holes; ++i) add_hole();
    const std::size_t lines = chance_.random() % 3;
    for (std::size_t i = 0; i < lines; ++i) add_line();
    const std::size_t points = chance_.random() % 3;
    for (std::size_t i = 0; i < points; ++i) {
      const Point p = place();
      if (!in_a_circle(p)) made_.points.push_back(p);
    }
    made_.sizes.largest = made_.patch.surface.size() / chance_(8.0, 20.0);
    made_.sizes.turn = chance_(12.0, 30.0);
  }

 private:
  [[nodiscard]] bool closed_u() const { return made_.patch.surface.closed_u(); }
  [[nodiscard]] bool closed_v() const { return made_.patch.surface.closed_v(); }
  [[nodiscard]] double apart(Point a, Point b) const {
    double x = std::abs(a.x - b.x), y = std::abs(a.y - b.y);
    if (closed_u()) x = std::min(x, std::abs(1.0 - x));
    if (closed_v()) y = std::min(y, std::abs(1.0 - y));
    return std::hypot(x, y);
  }
  /// Distances keep a rounding error of the gaps away from it.
  [[nodiscard]] bool free(Point middle, double radius) const {
    constexpr double least = 0.9e-9;
    if (!closed_u() && (middle.x - radius < least || middle.x + radius > 1.0 - least)) return false;
    if (!closed_v() && (middle.y - radius < least || middle.y + radius > 1.0 - least)) return false;
    if (middle.x < 0.0 || middle.x > 1.0 || middle.y < 0.0 || middle.y > 1.0) return false;
    return std::all_of(made_.holes.begin(), made_.holes.end(),
                       [&](const Hole& hole) { return apart(hole.middle, middle) >= hole.radius + radius + least; });
  }
  [[nodiscard]] bool in_a_circle(Point p) const {
    return std::any_of(made_.holes.begin(), made_.holes.end(),
                       [&](const Hole& hole) { return apart(hole.middle, p) <= hole.radius; });
  }

  void add_hole() {
    for (int attempt = 0; attempt < 50; ++attempt) {
      const double radius = chance_(0.02, 0.15);
      Point middle{chance_(0.0, 1.0), chance_(0.0, 1.0)};
      double towards = chance_(0.0, 2.0 * pi);
      if (const auto how = chance_.random() % 3; how == 0 && !made_.holes.empty()) {
        const Hole& other = made_.holes[chance_.random() % made_.holes.size()];
        middle = on_circle(other.middle, other.radius + radius + small_gap(chance_), towards);
        towards += pi;
      } else if (how == 1) {
        (chance_.random() % 2 ? middle.x : middle.y) =
            chance_.random() % 2 ? radius + small_gap(chance_) : 1.0 - radius - small_gap(chance_);
      }
      if (!free(middle, radius)) continue;
      Hole hole{middle, radius, hole_curve(chance_, middle, radius, towards), {}};
      constexpr std::size_t samples = 240;
      for (std::size_t i = 0; i < samples; ++i) {
        const Point3 p =
            hole.curve.at(std::lerp(hole.curve.low(), hole.curve.high(), static_cast<double>(i) / samples));
        hole.ring.push_back({p.x, p.y});
      }
      made_.holes.push_back(std::move(hole));
      return;
    }
  }

  /// Anywhere, beside a hole, or beside a side of the chart.
  Point place() {
    const auto how = chance_.random() % 4;
    if (how == 0 && !made_.holes.empty()) {
      const Hole& hole = made_.holes[chance_.random() % made_.holes.size()];
      const Point p = on_circle(hole.middle, hole.radius + small_gap(chance_), chance_(0.0, 2.0 * pi));
      if (p.x > 0.0 && p.x < 1.0 && p.y > 0.0 && p.y < 1.0) return p;
    }
    if (how == 1) return {chance_(0.1, 0.9), small_gap(chance_)};
    return {chance_(0.05, 0.95), chance_(0.05, 0.95)};
  }

  void add_line() {
    std::vector<Point3> through;
    const std::size_t n = 2 + chance_.random() % 3;
    for (std::size_t i = 0; i < n; ++i) {
      const Point p = i == 0 || i + 1 == n ? place() : Point{chance_(0.2, 0.8), chance_(0.2, 0.8)};
      through.push_back({p.x, p.y, 0.0});
    }
    made_.lines.push_back(*Curve::polyline(through));
  }

  Chance& chance_;
  Case& made_;
};

Case random_case(int seed) {
  Chance chance{std::mt19937(static_cast<unsigned>(seed + 1))};
  Case made{random_patch(chance), {}, {}, {}, {}};
  CaseMaker(chance, made).run();
  return made;
}

// ---- what is made of it

struct Made {
  trim::TrimmedSurface face;
  std::vector<trim::TrimmedSurface> charts;
  Division division;
  std::vector<FaceMesh> meshes;
  SurfaceMesh mesh;
};

/// From parts of the ranges to the chart.
Curve in_chart(const Curve& curve, const geom::Box& box) {
  return curve.moved({box.width(), 0, 0}, {0, box.height(), 0}, {0, 0, 1}, {box.low.x, box.low.y, 0});
}
Point in_chart(Point p, const geom::Box& box) {
  return {box.low.x + p.x * box.width(), box.low.y + p.y * box.height()};
}

base::Result<trim::TrimmedSurface> trimmed(const Case& given, trim::SharedNumbers& numbers) {
  const Surface& surface = given.patch.surface;
  const geom::Box& box = surface.chart();
  std::vector<trim::TrimLine> lines;
  const auto add = [&](const Curve& curve, const std::string& name, bool closed) {
    lines.push_back(
        {{{{.curve = in_chart(curve, box), .from = curve.low(), .to = curve.high(), .name = name}}}, closed, closed});
  };
  for (const Hole& hole : given.holes) add(hole.curve, "hole", true);
  for (std::size_t i = 0; i < given.lines.size(); ++i) add(given.lines[i], "line" + std::to_string(i), false);
  DOBRA_TRY(const trim::Recognised found, trim::recognise(surface, lines, numbers));
  std::set<std::size_t> wanted;
  for (std::size_t f = 0; f < found.faces().size(); ++f) wanted.insert(f);
  for (const Hole& hole : given.holes) {
    DOBRA_TRY(const std::size_t gone, found.pick(in_chart(hole.middle, box)));
    wanted.erase(gone);
  }
  const std::vector<std::size_t> kept(wanted.begin(), wanted.end());
  trim::TrimmedSurface face = kept.size() == 1 ? found.faces()[kept[0]] : found.united(kept, trim::CommonLines::Keep);
  for (std::size_t i = 0; i < given.points.size(); ++i)
    face.points.push_back({in_chart(given.points[i], box), "point" + std::to_string(i)});
  return face;
}

base::Result<Made> made_of(const Case& given) {
  trim::SharedNumbers numbers;
  DOBRA_TRY(trim::TrimmedSurface face, trimmed(given, numbers));
  Made made{std::move(face), {}, {}, {}, {}};
  if (auto fold = trim::find_fold(made.face)) return *std::move(fold);
  DOBRA_TRY(const std::vector<trim::Opened> opened, trim::open(made.face, numbers));
  for (const trim::Opened& one : opened) made.charts.push_back(one.face);
  DOBRA_TRY(made.division, divide(made.charts, {.sizes = given.sizes}));
  for (const ChartInput& input : made.division.faces) {
    DOBRA_TRY(FaceMesh mesh, mesh_chart(input, {.sizes = given.sizes}));
    made.meshes.push_back(std::move(mesh));
  }
  DOBRA_TRY(made.mesh, assemble(made.charts, made.division, made.meshes));
  const std::vector<std::size_t> owner(made.charts.size(), 0);
  free_borders(made.mesh, made.charts, owner, trim::artificial_border);
  DOBRA_TRY_VOID(check(made.mesh));
  return made;
}

// ---- what must hold of it

using Side = std::array<std::size_t, 2>;

/// Sides of triangles by their ends in order, with the number of triangles.
std::map<Side, int> sides_of(const std::vector<dobra::mesh::Corners>& triangles) {
  std::map<Side, int> sides;
  for (const auto& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = corners[i].index(), b = corners[(i + 1) % 3].index();
      ++sides[{std::min(a, b), std::max(a, b)}];
    }
  }
  return sides;
}

/// Triangles run anticlockwise; what has one triangle is a boundary edge of the input and the reverse; the areas are
/// those within the edges.
void check_chart(const ChartInput& input, const FaceMesh& mesh) {
  using dobra::mesh::delaunay::EdgeKind;
  double area = 0.0, within = 0.0;
  for (const auto& corners : mesh.chart.triangles) {
    const Point p = mesh.chart.point(corners[0]), q = mesh.chart.point(corners[1]), r = mesh.chart.point(corners[2]);
    ASSERT_EQ(geom::orient2d(p, q, r), geom::Sign::Positive);
    area += 0.5 * cross(q - p, r - p);
  }
  const std::map<Side, int> sides = sides_of(mesh.chart.triangles);
  std::set<Side> border;
  const Point from = input.chart.points.at(0);
  for (const auto& edge : input.chart.edges) {
    const std::size_t a = edge.nodes[0].index(), b = edge.nodes[1].index();
    const auto found = sides.find({std::min(a, b), std::max(a, b)});
    ASSERT_TRUE(found != sides.end()) << "an edge is missing at " << input.chart.points[a];
    if (input.chart.sets[edge.set].kind != EdgeKind::Boundary) continue;
    within += 0.5 * cross(input.chart.points[a] - from, input.chart.points[b] - from);
    border.insert(found->first);
  }
  const double size = geom::box_of(input.chart.points).diagonal();
  EXPECT_NEAR(area, within, 1e-12 * size * size);
  for (const auto& [side, count] : sides) {
    ASSERT_LE(count, 2);
    ASSERT_TRUE(count == 2 || border.count(side) == 1U) << "a side of the border is none that was given";
  }
}

bool inside(const std::vector<Point>& ring, Point p) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Point a = ring[i], b = ring[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
  }
  return in;
}

/// Whether a place, by parts of the chart, is in a hole.
bool in_hole(const Case& given, Point p) {
  for (const Hole& hole : given.holes) {
    for (const double x : {-1.0, 0.0, 1.0}) {
      for (const double y : {-1.0, 0.0, 1.0}) {
        if ((x != 0.0 && !given.patch.surface.closed_u()) || (y != 0.0 && !given.patch.surface.closed_v())) continue;
        const Point there = p + Vector{x, y};
        if (geom::distance(there, hole.middle) <= hole.radius && inside(hole.ring, there)) return true;
      }
    }
  }
  return false;
}

/// By the rule of the middle on squares of the chart.
double area_by_squares(const Case& given) {
  constexpr int n = 96;
  const geom::Box& box = given.patch.surface.chart();
  double area = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Point p{(i + 0.5) / n, (j + 0.5) / n};
      if (in_hole(given, p)) continue;
      const Jet jet = given.patch.surface.jet(in_chart(p, box));
      area += length(cross(jet.u, jet.v));
    }
  }
  return area * box.width() * box.height() / (n * n);
}

double area_of(const SurfaceMesh& mesh) {
  double area = 0.0;
  for (const auto& corners : mesh.triangles) {
    const Point3 a = mesh.point(corners[0]);
    area += 0.5 * length(cross(mesh.point(corners[1]) - a, mesh.point(corners[2]) - a));
  }
  return area;
}

/// Nodes - edges + triangles, whatever the umbrellas.
int euler_of(const SurfaceMesh& mesh) {
  std::set<std::size_t> nodes;
  for (const auto& corners : mesh.triangles) {
    for (const NodeId node : corners) nodes.insert(node.index());
  }
  return static_cast<int>(nodes.size()) - static_cast<int>(sides_of(mesh.triangles).size()) +
         static_cast<int>(mesh.triangles.size());
}

/// What of a line lies in no hole is as long as its edges.
void check_line(const Case& given, const SurfaceMesh& mesh, std::size_t i) {
  const geom::Box& box = given.patch.surface.chart();
  const Curve& line = given.lines[i];
  constexpr int n = 2000;
  double length = 0.0;
  for (int k = 0; k < n; ++k) {
    const auto at = [&](double part) {
      const Point3 p = line.at(std::lerp(line.low(), line.high(), part / n));
      return Point{p.x, p.y};
    };
    if (in_hole(given, at(k + 0.5))) continue;
    length +=
        geom::distance(given.patch.surface.at(in_chart(at(k), box)), given.patch.surface.at(in_chart(at(k + 1), box)));
  }
  double held = 0.0;
  // What lies on a border within what counts as one point is in the set of the border.
  for (const auto* sets : {&mesh.constraint_sets, &mesh.boundary_sets}) {
    const auto set = sets->find("line" + std::to_string(i));
    if (set == sets->end()) continue;
    const std::map<Side, int> sides = sides_of(mesh.triangles);
    for (const Edge& edge : set->second) {
      const std::size_t a = edge[0].index(), b = edge[1].index();
      EXPECT_EQ(sides.count({std::min(a, b), std::max(a, b)}), 1U);
      held += geom::distance(mesh.point(edge[0]), mesh.point(edge[1]));
    }
  }
  EXPECT_NEAR(held, length, 0.02 * length + 2e-3 * given.patch.surface.size()) << "line " << i;
}

void check_mesh(const Case& given, const Made& made) {
  for (std::size_t f = 0; f < made.meshes.size(); ++f) check_chart(made.division.faces[f], made.meshes[f]);
  if (testing::Test::HasFatalFailure()) return;
  const SurfaceMesh& mesh = made.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& place = mesh.places[t];
    ASSERT_EQ(geom::orient2d(place[0], place[1], place[2]), geom::Sign::Positive) << "after seams were freed";
    const Point middle = place[0] + ((place[1] - place[0]) + (place[2] - place[0])) / 3.0;
    const Jet jet = made.charts[mesh.faces[t]].surface.jet(middle);
    const Point3 a = mesh.point(mesh.triangles[t][0]);
    const Vector3 normal = cross(mesh.point(mesh.triangles[t][1]) - a, mesh.point(mesh.triangles[t][2]) - a);
    ASSERT_GE(dot(cross(jet.u, jet.v), normal), -1e-9 * length(cross(jet.u, jet.v)) * length(normal)) << "it folds";
  }
  EXPECT_EQ(euler_of(mesh), given.patch.euler - static_cast<int>(given.holes.size()));
  EXPECT_LT(quality_of(mesh).gauss_bonnet, 1e-8);
  const double area = area_by_squares(given);
  EXPECT_NEAR(area_of(mesh), area, 0.02 * area);
  for (std::size_t i = 0; i < given.lines.size(); ++i) check_line(given, mesh, i);
  for (std::size_t i = 0; i < given.points.size(); ++i) {
    const auto set = mesh.node_sets.find("point" + std::to_string(i));
    ASSERT_TRUE(set != mesh.node_sets.end() && set->second.size() == 1U) << "point " << i;
    const Point3 at = given.patch.surface.at(in_chart(given.points[i], given.patch.surface.chart()));
    EXPECT_LE(geom::distance(mesh.point(set->second[0]), at), 2e-6 * given.patch.surface.size());
  }
}

int number_of(const char* name, int otherwise) {
  const char* const asked = std::getenv(name);
  return asked ? std::atoi(asked) : otherwise;
}

struct Tally {
  int meshed = 0;
  std::size_t triangles = 0;
  double slowest = 0.0;
  int slowest_seed = 0;
  std::map<std::string, int> refused;
};

void try_case(int seed, bool tells, Tally& tally) {
  const Case given = random_case(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ", " + given.patch.kind);
  const auto start = std::chrono::steady_clock::now();
  const auto made = made_of(given);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (seconds > tally.slowest) tally.slowest = seconds, tally.slowest_seed = seed;
  if (made) {
    ++tally.meshed;
    tally.triangles += made->mesh.triangles.size();
    check_mesh(given, *made);
    return;
  }
  const base::Error& error = made.error();
  EXPECT_FALSE(error.message.empty());
  EXPECT_TRUE(error.place && (error.place->x || error.place->u)) << error.message;
  constexpr std::size_t beginning = 44;
  ++tally.refused[given.patch.kind + ": " + error.message.substr(0, beginning)];
  if (tells) printf("seed %d, %s: %s\n", seed, given.patch.kind.c_str(), base::to_string(error).c_str());
}

TEST(RandomPatches, AreMeshedAsAskedOrRefusedWithAPlace) {
  const bool asked = std::getenv("DOBRA_RANDOM_CASES") != nullptr;
  const int cases = number_of("DOBRA_RANDOM_CASES", 24), first = number_of("DOBRA_RANDOM_FIRST", 60);
  Tally tally;
  for (int seed = first; seed < first + cases; ++seed) try_case(seed, asked, tally);
  EXPECT_GE(tally.meshed, cases * 4 / 5);
  if (!asked) return;
  printf("%d patches, %d meshed with %zu triangles, slowest %.2f s (seed %d)\n", cases, tally.meshed, tally.triangles,
         tally.slowest, tally.slowest_seed);
  for (const auto& [what, count] : tally.refused) printf("%5d refused, %s\n", count, what.c_str());
}

/// A sphere, a cone and a cylinder of which a hole comes nearer to the seam than what counts as one point.
TEST(RandomPatches, SeamsThatAHoleTouchesStayClosed) {
  Tally tally;
  for (const int seed : {21, 39, 84}) try_case(seed, false, tally);
  EXPECT_EQ(tally.meshed, 3);
}

/// The front goes over a point that was given alone, and takes the triangles back that cover it.
TEST(RandomPatches, APointThatTheFrontWentOverIsANode) {
  Tally tally;
  for (const int seed : {2231, 2702}) try_case(seed, false, tally);
  EXPECT_EQ(tally.meshed, 2);
}

}  // namespace
}  // namespace dobra::surf::mesh::random_patches
