// Solids whose numbers are known from elsewhere, and laws that hold for all.

#include <gmock/gmock.h>

#include "shared/solid/check/validate.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;

PolygonMesh scaled(PolygonMesh mesh, double factor) {
  for (Point3& p : mesh.points) p = {factor * p.x, factor * p.y, factor * p.z};
  return mesh;
}

using Loop = std::vector<std::array<double, 3>>;

/// All faces as sorted loops from their least corner on, so that equal solids are equal whatever their order.
std::vector<std::vector<Loop>> canonical(const Solid& s) {
  std::vector<std::vector<Loop>> faces;
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    std::vector<Loop> loops;
    for (const HalfEdgeId first : s.loops(FaceId(f))) {
      Loop loop;
      HalfEdgeId h = first;
      do {
        const Point3 p = s.point(h);
        loop.push_back({p.x, p.y, p.z});
        h = s.next(h);
      } while (h != first);
      std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
      loops.push_back(loop);
    }
    std::sort(loops.begin(), loops.end());
    faces.push_back(loops);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

TEST(SolidIdentity, SOL_d_ExtrusionsHaveTheirVolumes) {
  EXPECT_EQ(volume(solid(prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0, 2))), 2.0);
  const std::vector<std::pair<int, std::array<double, 2>>> expected{
      {16, {6.122935, 2.040978}}, {32, {6.242890, 2.080963}}, {64, {6.273097, 2.091032}}};
  for (const auto& [corners, volumes] : expected) {
    EXPECT_NEAR(volume(solid(prism(regular(corners, 1), 0, 2))), volumes[0], 5e-7);
    PolygonMesh cone;
    for (const auto& [x, y] : regular(corners, 1)) cone.points.push_back({x, y, 0});
    cone.points.push_back({0, 0, 2});
    const auto n = static_cast<std::uint32_t>(corners);
    cone.faces.emplace_back();
    for (std::uint32_t i = 0; i < n; ++i) {
      cone.faces[0].push_back(n - 1 - i);
      cone.faces.push_back({i, (i + 1) % n, n});
    }
    EXPECT_NEAR(volume(solid(cone)), volumes[1], 5e-7);
  }
}

TEST(SolidIdentity, SOL_e_ATurnedSquareIsATorus) {
  for (const auto& [m, expected] : {std::pair{8, 11.313708}, std::pair{16, 12.245870}, std::pair{64, 12.546194}}) {
    PolygonMesh torus;
    const auto n = static_cast<std::uint32_t>(m);
    for (const auto& [x, y] : regular(m, 1)) {
      for (const auto& [r, z] : {std::pair{1.5, 0.0}, std::pair{2.5, 0.0}, std::pair{2.5, 1.0}, std::pair{1.5, 1.0}}) {
        torus.points.push_back({r * x, r * y, z});
      }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t here = 4 * i;
      const std::uint32_t there = 4 * ((i + 1) % n);
      for (std::uint32_t k = 0; k < 4; ++k) {
        const std::uint32_t l = (k + 1) % 4;
        torus.faces.push_back({here + k, there + k, there + l, here + l});
      }
    }
    for (auto& face : torus.faces) std::reverse(face.begin(), face.end());
    FromMeshOptions options;  // of one name each, so that no two neighbours become one face
    for (std::size_t f = 0; f < torus.faces.size(); ++f) options.face_names.push_back(std::to_string(f));
    auto made = from_mesh(torus, options);
    if (!made) {
      for (auto& face : torus.faces) std::reverse(face.begin(), face.end());
      made = from_mesh(torus, options);
    }
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_NEAR(volume(*made), expected, 5e-7);
    EXPECT_EQ(made->counts().handles, 1);
  }
}

TEST(SolidIdentity, SOL_k_CombinesIntervalsOfALine) {
  const auto interval = [](double from, double to) { return box_solid({from, 0, 0}, {to, 1, 1}); };
  const std::vector<Solid> leaves{interval(0, 6), interval(2, 8), interval(7, 12), interval(9, 10)};
  const Combined all =
      combine(leaves, [](const std::vector<bool>& in) { return (in[0] && in[1]) || (in[2] && !in[3]); }).value();
  EXPECT_EQ(volume(all.solid), 8.0);
  EXPECT_EQ(all.solid.counts().shells, 3U);
  EXPECT_EQ(canonical(all.solid), canonical(unite({interval(2, 6), interval(7, 9), interval(10, 12)})));
}

TEST(SolidIdentity, SOL_l_ATreeInOneGoIsTheTreeStepByStep) {
  const Solid a = solid(sphere({0, 0, 0}, 2.0, 7, 9));
  const Solid b = box_solid({0, 0, 0}, {3, 3, 3});
  const Solid c = solid(rotated(box({-3, -0.5, -0.5}, {3, 0.5, 0.5}), {1, 1, 0}, 0.7));
  const Solid d = solid(moved(prism(gear(5, 1, 1.4), -1, 1), {1, 1, 0}));
  const Solid e = box_solid({1, 1, -3}, {1.5, 1.5, 3});
  const auto rule = [](const std::vector<bool>& in) { return (in[0] && !(in[1] || in[2])) || (in[3] && !in[4]); };
  const Solid at_once = combine(std::vector{a, b, c, d, e}, rule).value().solid;
  const Solid stepwise = unite({subtract({a, unite({b, c})}), subtract({d, e})});
  EXPECT_THAT(check::violations(stepwise), testing::IsEmpty());
  EXPECT_EQ(at_once.counts(), stepwise.counts());
  EXPECT_NEAR(volume(at_once), volume(stepwise), 1e-14);
  const PointLocator one(at_once);
  const PointLocator other(stepwise);
  std::vector<PointLocator> leaves;
  for (const Solid& leaf : {a, b, c, d, e}) leaves.emplace_back(leaf);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> real(-2.5, 2.5);
  for (int i = 0; i < 10000; ++i) {
    const Point3 p{real(random), real(random), real(random)};
    std::vector<bool> in;
    for (const PointLocator& leaf : leaves) in.push_back(leaf.locate(p) == Location::Inside);
    const Location expected = rule(in) ? Location::Inside : Location::Outside;
    ASSERT_EQ(one.locate(p), expected);
    ASSERT_EQ(other.locate(p), expected);
  }
  // Scaling one operand is not scaling the other.
  const PolygonMesh l = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1);
  const PolygonMesh hole = box({0.25, 0.25, -1}, {0.75, 0.75, 2});
  EXPECT_EQ(volume(subtract({solid(scaled(l, 2)), solid(hole)})), 24.0 - 0.5);
  EXPECT_EQ(volume(subtract({solid(l), solid(scaled(hole, 2))})), 3.0 - 0.75);
}

TEST(SolidIdentity, MengerSpongesHaveTheirVolumeAndSurface) {
  const std::array<double, 3> volumes{0.740741, 0.548697, 0.406442};
  const std::array<double, 3> surfaces{8.0, 13.037037, 24.757202};
  for (int depth = 1; depth <= 2; ++depth) {
    const Solid sponge = subtract(menger_operands(depth));
    const Measures m = measure(sponge);
    const auto i = static_cast<std::size_t>(depth - 1);
    EXPECT_NEAR(m.volume / (27.0 * 27.0 * 27.0), volumes[i], 5e-7);
    EXPECT_NEAR(m.area / (27.0 * 27.0), surfaces[i], 5e-7);
    EXPECT_EQ(m.volume, 27.0 * 27.0 * 27.0 * std::pow(20.0, depth) / std::pow(27.0, depth));
    EXPECT_EQ(sponge.counts().shells, 1U);
    EXPECT_THAT(check::violations(sponge), testing::IsEmpty());
    EXPECT_EQ(sponge.counts().handles, depth == 1 ? 5 : 81);
  }
  const Solid third = subtract(menger_operands(3));
  EXPECT_EQ(volume(third), 8000.0);
  EXPECT_NEAR(measure(third).area / (27.0 * 27.0), surfaces[2], 5e-7);
  if (cases_asked() < 1000) return;
  const Solid fourth = subtract(menger_operands(4, 81.0));
  EXPECT_EQ(volume(fourth), 160000.0);
  EXPECT_NEAR(measure(fourth).area / (81.0 * 81.0), 51.270233, 5e-7);
  EXPECT_EQ(fourth.counts().shells, 1U);
}

TEST(SolidIdentity, TwoBarsOnTheDividingWallLeaveOneShellOfGenusTwo) {
  // The bars are flush with both holes, with the ends of the block, and touch four edges of the outline.
  const PolygonMesh block =
      prism({{2, 0}, {3, 0}, {3, 1}, {5, 1}, {5, 4}, {3, 4}, {3, 5}, {2, 5}, {2, 4}, {0, 4}, {0, 1}, {2, 1}}, 0, 5);
  EXPECT_EQ(volume(solid(block)), 5.0 * 17.0);
  const Solid holed =
      subtract({solid(block), box_solid({1, 1.5, -1}, {2, 3.5, 6}), box_solid({3, 1.5, -1}, {4, 3.5, 6})});
  EXPECT_EQ(holed.counts().handles, 2);
  const Solid bars = subtract({holed, box_solid({2, 1, 0}, {3, 4, 1}), box_solid({2, 1, 4}, {3, 4, 5})});
  EXPECT_EQ(volume(bars), 59.0);
  EXPECT_EQ(bars.counts().shells, 1U);
  EXPECT_EQ(bars.counts().handles, 2);
  EXPECT_THAT(check::violations(bars), testing::IsEmpty());
  // Bars through the middle of the wall make windows, each a handle more.
  const Solid windows = subtract({holed, box_solid({2, 2, 1}, {3, 3, 2}), box_solid({2, 2, 3}, {3, 3, 4})});
  EXPECT_EQ(windows.counts().handles, 4);
}

TEST(SolidIdentity, CylindersThatCrossHaveTheSolidsOfArchimedes) {
  // Bars with a regular 64-gon as section along x, y, z; the deviation is of second order in 1/64.
  const auto bar = [](int corners) { return prism(regular(corners, 1), -2, 2); };
  const auto turned_to = [](PolygonMesh mesh, int times) {
    for (Point3& p : mesh.points) {
      for (int i = 0; i < times; ++i) p = {p.z, p.x, p.y};
    }
    return mesh;
  };
  std::array<double, 2> two{};
  std::array<double, 2> three{};
  for (const std::size_t i : {0U, 1U}) {
    const int corners = i == 0 ? 32 : 64;
    const Solid z = solid(bar(corners));
    const Solid x = solid(turned_to(bar(corners), 1));
    const Solid y = solid(turned_to(bar(corners), 2));
    two[i] = volume(common({x, y}));
    three[i] = volume(common({x, y, z}));
  }
  EXPECT_NEAR(two[1], 16.0 / 3.0, 0.02);
  EXPECT_NEAR(three[1], 4.686292, 0.02);
  EXPECT_NEAR((16.0 / 3.0 - two[0]) / (16.0 / 3.0 - two[1]), 4.0, 0.2);
  EXPECT_NEAR((4.686292 - three[0]) / (4.686292 - three[1]), 4.0, 0.3);
}

TEST(SolidIdentity, ManyBoxesTakenOutAndPutBackLeaveTheBox) {
  const Solid block = box_solid({0, 0, 0}, {20, 20, 20});
  std::mt19937_64 random(8);
  std::vector<Solid> operands{block};
  const auto at = [&](double most) {
    return std::floor(most * static_cast<double>(random() % 1000) / 1000.0 * 4.0) / 4.0;
  };
  const int boxes = cases_asked() < 1000 ? 200 : 1000;
  for (int i = 0; i < boxes; ++i) {
    const Point3 low{at(18), at(18), at(18)};
    operands.push_back(box_solid(low, low + geom::Vector3{0.5 + at(1.5), 0.5 + at(1.5), 0.5 + at(1.5)}));
  }
  const Solid pierced = subtract(operands);
  EXPECT_THAT(check::violations(pierced), testing::IsEmpty());
  EXPECT_GT(pierced.counts().shells, 1U);
  operands[0] = pierced;
  const Solid back = unite(operands);
  EXPECT_EQ(canonical(back), canonical(block));
  EXPECT_EQ(back.counts(), block.counts());
}

TEST(SolidIdentity, LawsHoldToTheByte) {
  const Solid a = solid(sphere({0, 0, 0}, 1.5, 6, 8));
  const Solid b = box_solid({0, 0, 0}, {2, 2, 2});
  const Solid c = solid(prism(regular(6, 1), -1, 1));
  EXPECT_EQ(canonical(unite({a, b})), canonical(unite({b, a})));
  EXPECT_EQ(canonical(common({a, b})), canonical(common({b, a})));
  EXPECT_EQ(canonical(unite({unite({a, b}), c})), canonical(unite({a, unite({b, c})})));
  EXPECT_EQ(canonical(unite({unite({a, b}), c})), canonical(unite({a, b, c})));
  EXPECT_EQ(canonical(common({common({a, b}), c})), canonical(common({a, common({b, c})})));
  EXPECT_EQ(canonical(unite({a, a})), canonical(a));
  EXPECT_EQ(canonical(common({a, a})), canonical(a));
  EXPECT_TRUE(subtract({a, a}).empty());
  // De Morgan.
  EXPECT_EQ(canonical(subtract({a, b, c})), canonical(common({subtract({a, b}), subtract({a, c})})));
  EXPECT_EQ(canonical(subtract({a, common({b, c})})), canonical(unite({subtract({a, b}), subtract({a, c})})));
}

TEST(SolidIdentity, HoldsFarFromTheOriginAtAnySizeAndOneUnitApart) {
  for (const double factor : {1e-6, 1.0, 1e6, 0x1p-90, 0x1p90}) {
    const Solid a = solid(scaled(sphere({0, 0, 0}, 1.0, 6, 7), factor));
    const Solid b = solid(scaled(box({0, 0, 0}, {1, 1, 1}), factor));
    const double sum = volume(a) + volume(b);
    EXPECT_NEAR(volume(unite({a, b})) + volume(common({a, b})), sum, 1e-14 * sum);
  }
  const geom::Vector3 far{677000.125, 7459000.25, 812.5};
  const Solid a = solid(moved(sphere({0, 0, 0}, 10.0, 6, 7), far));
  const Solid b = solid(moved(rotated(box({0, 0, 0}, {10, 10, 10}), {1, 2, 3}, 0.4), far));
  const double sum = volume(a) + volume(b);
  EXPECT_NEAR(volume(unite({a, b})) + volume(common({a, b})), sum, 1e-14 * sum);
  // The upper face of one is one unit in the last place below that of the other, or just as high, or above.
  const Solid lower = box_solid({0, 0, 0}, {1, 1, 1});
  const double next = std::nextafter(1.0, 2.0);
  const Solid higher = box_solid({0.25, 0.25, 0}, {0.75, 0.75, next});
  EXPECT_EQ(unite({lower, higher}).counts(), (Counts{16, 24, 11, 1, 1, 0}));
  EXPECT_EQ(unite({lower, box_solid({0.25, 0.25, 0}, {0.75, 0.75, 1})}).counts(), (Counts{8, 12, 6, 0, 1, 0}));
  EXPECT_EQ(volume(subtract({higher, lower})), 0.25 * (next - 1.0));
  EXPECT_TRUE(subtract({box_solid({0.25, 0.25, 0}, {0.75, 0.75, std::nextafter(1.0, 0.0)}), lower}).empty());
}

TEST(SolidIdentity, ACubeUnitedWithItsTurnsKeepsItsVolumeInOrder) {
  // Turned n times by 360/n: back to where it was up to rounding, and still a good solid.
  std::vector<Solid> turns;
  for (int i = 0; i < 9; ++i) {
    turns.push_back(solid(rotated(box({-1, -1, -1}, {1, 1, 1}), {0, 0, 1}, 2.0 * std::numbers::pi * i / 9.0)));
  }
  const Solid star = unite(turns);
  EXPECT_THAT(check::violations(star), testing::IsEmpty());
  EXPECT_EQ(star.counts().handles, 0);
  EXPECT_EQ(star.counts().shells, 1U);
  // Its section in polar coordinates: the farthest of the squares in every direction.
  double area = 0.0;
  const int steps = 200000;
  for (int k = 0; k < steps; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / steps;
    double radius = 0.0;
    for (int i = 0; i < 9; ++i) {
      const double t = angle - 2.0 * std::numbers::pi * i / 9.0;
      radius = std::max(radius, 1.0 / std::max(std::abs(std::cos(t)), std::abs(std::sin(t))));
    }
    area += 0.5 * radius * radius * 2.0 * std::numbers::pi / steps;
  }
  EXPECT_NEAR(volume(star), 2.0 * area, 1e-4);
}

TEST(SolidIdentity, MeasuresOfABoxAreThoseOfTheBook) {
  const Measures m = measure(box_solid({1, 2, 3}, {3, 5, 7}));
  EXPECT_EQ(m.volume, 24.0);
  EXPECT_EQ(m.area, 2.0 * (6.0 + 8.0 + 12.0));
  EXPECT_EQ(m.centre, (Point3{2, 3.5, 5}));
  EXPECT_THAT(m.inertia,
              testing::ElementsAre(24.0 * (9 + 16) / 12, 24.0 * (4 + 16) / 12, 24.0 * (4 + 9) / 12, 0, 0, 0));
  const Measures t = measure(solid(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})));
  EXPECT_EQ(t.volume, 1.0 / 6.0);
  EXPECT_EQ(t.centre, (Point3{0.25, 0.25, 0.25}));
  EXPECT_NEAR(t.inertia[0], 1.0 / 80.0, 1e-17);
  EXPECT_NEAR(t.inertia[3], 1.0 / 480.0, 1e-17);
}

}  // namespace
}  // namespace dobra::solid
