// Random domains: every one gives a mesh that passes all checks, or an error that says what is wrong.
// DOBRA_RANDOM_CASES=10000 runs that many; DOBRA_RANDOM_FIRST is the first seed.

#include <gtest/gtest.h>

#include <chrono>
#include <ctime>
#include <set>

#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/mesh_check.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;

/// A kind of domain a seed; several kinds of trouble in each.
class DomainMaker {
 public:
  explicit DomainMaker(std::uint64_t seed) : seed_(seed), random_(seed) {}

  delaunay::MeshInput make() {
    using Make = void (DomainMaker::*)();
    static constexpr std::array<Make, 9> makers{
        &DomainMaker::star,   &DomainMaker::holes,         &DomainMaker::graded,
        &DomainMaker::wedge,  &DomainMaker::slits,         &DomainMaker::near_parallel,
        &DomainMaker::tangle, &DomainMaker::touching_lips, &DomainMaker::sieve};
    (this->*makers[seed_ % makers.size()])();
    if (seed_ % 3 == 0) add_requests();
    return std::move(input_);
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  int up_to(int most) { return static_cast<int>(random_() % static_cast<std::uint64_t>(most)); }
  /// 10^-x with x uniform: gaps of all sizes.
  double tiny() { return std::pow(10.0, -9.0 * unit()); }

  void loop(const std::vector<Point>& points, const char* name) {
    add_chain(input_, points, delaunay::Closure::Closed, {name, delaunay::EdgeKind::Boundary});
  }
  void chain(const std::vector<Point>& points, delaunay::EdgeKind kind) {
    add_chain(input_, points, delaunay::Closure::Open, {"inner", kind});
  }
  std::vector<Point> circle(Point centre, double radius, int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return points;
  }
  /// The sides of a polygon cut into pieces of about `size`, some of them at random places.
  std::vector<Point> cut(const std::vector<Point>& corners, double size) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point a = corners[i];
      const Point b = corners[(i + 1) % corners.size()];
      const int pieces = std::max(1, static_cast<int>(geom::distance(a, b) / size));
      for (int k = 0; k < pieces; ++k) {
        const double shift = k > 0 && unit() < 0.05 ? (unit() - 0.5) * (1.0 - 1e-6) : 0.0;
        points.push_back(geom::interpolate(a, b, (k + shift) / pieces));
      }
    }
    return points;
  }

  void star() {
    std::vector<Point> points;
    const int count = 5 + up_to(60);
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      const double radius = unit() < 0.1 ? 1e-3 + 0.1 * unit() : 0.3 + unit();
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      if (unit() < 0.1) points.push_back({points.back().x + 0.01 * tiny(), points.back().y});
    }
    loop(unit() < 0.5 ? points : cut(points, 0.02 + 0.2 * unit()), "outline");
    for (int k = up_to(4); k > 0; --k) {
      const Point a{0.2 * unit(), 0.2 * unit()};
      chain({a, {a.x + 0.05 * unit(), a.y + 1e-6 * unit()}}, delaunay::EdgeKind::Constraint);
    }
  }
  void holes() {
    loop(cut({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, 0.1 + 2.0 * unit()), "outline");
    const int rows = 1 + up_to(12);
    for (int i = 0; i < rows * rows; ++i) {
      const double step = 10.0 / rows;
      const double radius = step * (unit() < 0.2 ? 0.5 - 0.5 * tiny() : 0.1 + 0.35 * unit());
      loop(circle({step * (i % rows + 0.5), step * (i / rows + 0.5)}, radius, 3 + up_to(20)), "hole");
    }
  }
  void graded() {
    const double smallest = 0.005 + 0.05 * unit();
    const double slope = 0.02 + 0.5 * unit();
    input_ = test::large_plate([=](double d) { return smallest + slope * d; });
  }
  void wedge() {
    const double slope = std::tan((0.1 + 30.0 * unit() * unit()) * std::numbers::pi / 180.0);
    const double size = 0.05 + 0.3 * unit();
    loop(cut({{0, 0}, {2, 0}, {2, 2 * slope}}, size), "wedge");
  }
  void slits() {
    loop(cut({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.05 + 0.3 * unit()), "outline");
    // Edges out of one point, into the boundary, and nearly touching each other.
    const Point centre{1.0 + 2.0 * unit(), 1.0 + unit()};
    const double reach = 0.9 * unit();
    for (int k = 1 + up_to(7); k > 0; --k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.3 * unit()) / 8.0;
      const geom::Vector along{std::cos(angle), std::sin(angle)};
      std::vector<Point> points{centre};
      for (int i = 1 + up_to(20), n = i; i > 0; --i) points.push_back(centre + reach * (n - i + 1) / n * along);
      chain(points, unit() < 0.5 ? delaunay::EdgeKind::Constraint : delaunay::EdgeKind::Interface);
    }
    for (int k = up_to(10); k > 0; --k) input_.points.push_back({0.1 + 0.8 * unit(), 0.1 + 0.8 * unit()});
  }
  void near_parallel() {
    const double gap = tiny();
    loop(cut({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5 + gap}, {1, 0.5 + gap * unit()}, {1, 1}, {0, 1}},
             0.02 + 0.3 * unit()),
         "outline");
    chain({{0.1, 0.5}, {0.9, 0.5}}, delaunay::EdgeKind::Constraint);
    chain({{0.1, 0.5 + gap / 3.0}, {0.9, 0.5 + gap / 3.0}}, delaunay::EdgeKind::Constraint);
  }
  /// Two cracks whose lips touch each other, a boundary or a hole, or miss them by a hair; corners of 0.1 degree.
  void touching_lips() {
    loop(cut({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.1 + 0.3 * unit()), "outline");
    const double gap = unit() < 0.5 ? 0.0 : tiny();
    const double slope = std::tan((0.1 + unit()) * std::numbers::pi / 180.0);
    const Point tip{2.0, 1.5};
    chain({{1.0, 1.5}, {1.5, 1.5}, tip}, delaunay::EdgeKind::Constraint);
    chain({{tip.x, tip.y + gap}, {2.5, 1.5 + gap + 0.5 * slope}, {3.0, 1.5 + gap + slope}},
          delaunay::EdgeKind::Constraint);
    chain({{tip.x, tip.y + gap}, {2.5, 1.5 + gap + slope}, {3.0, 1.5 + gap + 2.0 * slope}},
          delaunay::EdgeKind::Constraint);
    if (unit() < 0.5) chain({{1.5, 1.5}, {1.5, 1.0}, {1.5, gap}}, delaunay::EdgeKind::Constraint);
    if (unit() < 0.5) loop(circle({3.5, 0.6}, 0.3, 3 + up_to(12)), "hole");
  }
  /// Many holes in a lattice, some nearly touching.
  void sieve() { sieve(100); }

 public:
  void sieve(int count) {
    const int rows = static_cast<int>(std::ceil(std::sqrt(count)));
    loop({{0, 0}, {1.0 * rows, 0}, {1.0 * rows, 1.0 * rows}, {0, 1.0 * rows}}, "outline");
    input_.sets.push_back({"holes", delaunay::EdgeKind::Boundary});
    for (int i = 0; i < count; ++i) {
      const double radius = unit() < 0.1 ? 0.5 - 0.5 * tiny() : 0.25 + 0.2 * unit();
      const std::size_t first = input_.points.size();
      const std::vector<Point> ring = circle({i % rows + 0.5, i / rows + 0.5}, radius, 3 + up_to(2));
      for (std::size_t k = 0; k < ring.size(); ++k) {
        input_.points.push_back(ring[k]);
        input_.edges.push_back({{NodeId(first + k), NodeId(first + (k + 1) % ring.size())},
                                static_cast<std::uint32_t>(input_.sets.size() - 1)});
      }
    }
  }
  delaunay::MeshInput take() { return std::move(input_); }

 private:
  /// Edges at random: mostly an error.
  void tangle() {
    loop(cut({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.1), "outline");
    for (int k = 1 + up_to(4); k > 0; --k) {
      const Point a{unit(), unit()};
      chain({a, {a.x + 0.5 * (unit() - 0.5), a.y + 0.5 * (unit() - 0.5)}}, delaunay::EdgeKind::Constraint);
    }
  }
  void add_requests() {
    const Point at = input_.points[random_() % input_.points.size()];
    input_.sizes.push_back({at, 0.02 + 0.1 * unit()});
  }

  std::uint64_t seed_;
  std::mt19937_64 random_;
  delaunay::MeshInput input_;
};

std::size_t number_from(const char* variable, std::size_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Pieces of an edge that was cut at points on it are edges of its set: lengths tell that none is missing.
void expect_lengths_kept(const delaunay::MeshInput& input, const TriangleMesh& mesh) {
  double wanted = 0.0;
  double found = 0.0;
  for (const delaunay::InputEdge& edge : input.edges) {
    wanted += geom::distance(input.points[edge.nodes[0].index()], input.points[edge.nodes[1].index()]);
  }
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges) found += geom::distance(mesh.point(edge[0]), mesh.point(edge[1]));
    }
  }
  EXPECT_NEAR(found, wanted, 1e-10 * wanted);
}

TEST(TriangulateRandom, QUE_b_EveryRandomDomainGivesAValidMeshOrANamedError) {
  const std::size_t cases = number_from("DOBRA_RANDOM_CASES", 300);
  const std::size_t first = number_from("DOBRA_RANDOM_FIRST", 1);
  std::size_t meshed = 0;
  double slowest = 0.0;
  for (std::size_t seed = first; seed < first + cases; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const delaunay::MeshInput input = DomainMaker(seed).make();
    MeshOptions options;
    options.points.max_triangles = 60'000;
    options.engine = seed % 5 == 0 ? Engine::Delaunay : Engine::Front;
    const auto start = std::chrono::steady_clock::now();
    const auto mesh = triangulate(input, options);
    slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    if (!mesh) {
      EXPECT_FALSE(mesh.error().message.empty());
      continue;
    }
    ++meshed;
    const auto valid = check(*mesh);
    EXPECT_TRUE(valid) << to_string(valid.error());
    const double wanted = test::boundary_area(*mesh);
    EXPECT_NEAR(area(*mesh), wanted, 1e-10 * wanted);
    expect_lengths_kept(input, *mesh);
  }
  RecordProperty("meshed", std::to_string(meshed));
  EXPECT_GT(meshed, cases / 2);
  EXPECT_LT(slowest, 10.0);
}

TEST(TriangulateRandom, TenThousandHolesMeshInTenSecondsWithBothEngines) {
  DomainMaker maker(1);
  maker.sieve(10'000);
  const delaunay::MeshInput input = maker.take();
  for (const Engine engine : {Engine::Front, Engine::Delaunay}) {
    MeshOptions options;
    options.engine = engine;
    options.sizes.growth = 2.0;
    const std::clock_t start = std::clock();
    const auto mesh = triangulate(input, options);
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 10.0);
    ASSERT_TRUE(mesh) << to_string(mesh.error());
    const auto valid = check(*mesh);
    EXPECT_TRUE(valid) << to_string(valid.error());
    EXPECT_EQ(topology_of(*mesh).holes(), 10'000U);
    RecordProperty(engine == Engine::Front ? "front triangles" : "delaunay triangles",
                   std::to_string(mesh->triangles.size()));
    const double wanted = test::boundary_area(*mesh);
    EXPECT_NEAR(area(*mesh), wanted, 1e-10 * wanted);
    expect_lengths_kept(input, *mesh);
  }
}

}  // namespace
}  // namespace dobra::mesh::front
