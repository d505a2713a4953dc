// Random pairs of every kind: volumes, validity, and points classified by a way of the test's own.

#include <gmock/gmock.h>

#include <cstdlib>

#include "shared/solid/check/validate.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;
using Random = std::mt19937_64;
__extension__ typedef __int128 Wide;

int cases(int usual) { return cases_asked() > 0 ? cases_asked() : usual; }
/// Of each pair; more by DOBRA_SOLID_POINTS.
int points_of_a_pair() {
  const char* wanted = std::getenv("DOBRA_SOLID_POINTS");
  return wanted != nullptr ? std::atoi(wanted) : 10;
}
std::uint64_t first_seed() {
  const char* wanted = std::getenv("DOBRA_SOLID_FIRST");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 1;
}

int whole(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
}

/// Coordinates of the kinds below are whole multiples of this, so that the test can decide in whole numbers.
constexpr double step = 0x1p-16;

PolygonMesh on_grid(PolygonMesh mesh) {
  for (Point3& p : mesh.points)
    p = {std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
  return mesh;
}

PolygonMesh lattice_box(Random& random) {
  Point3 low;
  Point3 high;
  for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
    const int a = whole(random, 0, 3);
    low.*axis = a;
    high.*axis = whole(random, a + 1, 4);
  }
  return box(low, high);
}

/// Of a field of heights that goes on without end, the same for the same number: above nought, below three.
double height(int field, long i, long j) {
  Random there(static_cast<std::uint64_t>(1000000 * field + 1000 * i + j));
  if (field == 0) return whole(there, 1, 2);
  if (field == 1) return static_cast<double>(whole(there, 2, 10)) / 4.0;
  return static_cast<double>(whole(there, 20000, 180000)) * step;
}

/// The block under a window of a field. Blocks of one field have tops that coincide where they overlap, unless they are
/// shifted by less than a cell, or in height.
PolygonMesh terrain_block(Random& random, int field, bool on_lattice) {
  const int columns = whole(random, 1, 4);
  const int rows = whole(random, 1, 4);
  const int first = whole(random, 0, 2);
  const int second = whole(random, 0, 2);
  const auto shift = [&] { return on_lattice ? 0.0 : static_cast<double>(whole(random, 1, 65535)) * step; };
  const geom::Vector3 by{shift(), shift(), on_lattice ? static_cast<double>(whole(random, 0, 1)) : shift()};
  const double low = -0.5 * whole(random, 0, 2);
  return moved(terrain(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), low,
                       [&](std::uint32_t i, std::uint32_t j) {
                         const long x = first + static_cast<long>(i);
                         const long y = second + static_cast<long>(j);
                         return Point3{static_cast<double>(x), static_cast<double>(y), height(field, x, y)};
                       }),
               by);
}

PolygonMesh shape(Random& random) {
  const auto size = [&] { return 0.5 + static_cast<double>(whole(random, 0, 8)) / 4.0; };
  switch (whole(random, 0, 7)) {
    case 0:
    case 1:
      return lattice_box(random);
    case 2:
      return on_grid(rotated(lattice_box(random), {1, 1, 1}, 2.0 * std::numbers::pi * whole(random, 1, 11) / 12.0));
    case 3:
      return on_grid(
          moved(prism(regular(whole(random, 3, 12), size()), 0, size()), {2, 2, double(whole(random, 0, 2))}));
    case 4:
      return on_grid(moved(prism(gear(whole(random, 3, 9), 1, 1.5, whole(random, 0, 3)), 0, size()), {2, 2, 1}));
    case 5:
      return on_grid(sphere({2, 2, double(whole(random, 0, 2))}, size(), 5, 7));
    case 6:
      return terrain_block(random, whole(random, 0, 2), whole(random, 0, 1) == 0);
    default: {
      const auto corner = [&] {
        return Point3{double(whole(random, 0, 4)), double(whole(random, 0, 4)), double(whole(random, 0, 4))};
      };
      while (true) {
        const Point3 a = corner();
        const Point3 b = corner();
        const Point3 c = corner();
        const Point3 d = corner();
        if (dot(cross(b - a, c - a), d - a) != 0.0) return tetrahedron(a, b, c, d);
      }
    }
  }
}

struct Place {
  long x, y, z;
};
Place on(const Point3& p) { return {std::lround(p.x / step), std::lround(p.y / step), std::lround(p.z / step)}; }

int side(const Place& a, const Place& b, const Place& c, const Place& d) {
  const Wide ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const Wide vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  const Wide wx = d.x - a.x, wy = d.y - a.y, wz = d.z - a.z;
  const Wide value = wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx);
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// A face that is not plane, as rounding leaves turned ones, may be cut into triangles in several ways, all of which
/// lie between its outermost corners: whether p does so too.
bool between_ways_to_cut(const PolygonMesh& mesh, const std::vector<std::uint32_t>& face, const Place& place) {
  if (face.size() == 3) return false;
  const Point3 p{static_cast<double>(place.x) * step, static_cast<double>(place.y) * step,
                 static_cast<double>(place.z) * step};
  const Point3 origin = mesh.points[face[0]];
  geom::Vector3 area{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
    area = area + cross(mesh.points[face[i]] - origin, mesh.points[face[i + 1]] - origin);
  const geom::Vector3 normal = normalised(area);
  double low = 0.0;
  double high = 0.0;
  for (const std::uint32_t corner : face) {
    const double height = dot(normal, mesh.points[corner] - origin);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  const double height = dot(normal, p - origin);
  return low <= height && height <= high;
}

/// Whether p is inside, by the parity of the triangles that a segment to a far point crosses; none if p is on one.
/// Faces of more than three corners are fans from a corner: signed, so that it does not matter if they are not convex.
/// None, too, where faces that are not plane leave a doubt.
std::optional<bool> inside(const PolygonMesh& mesh, const Place& p, Random& random) {
  for (const auto& face : mesh.faces) {
    if (between_ways_to_cut(mesh, face, p)) return std::nullopt;
  }
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Place q{1000003L + whole(random, 0, 999), 900001L + whole(random, 0, 999), 800011L + whole(random, 0, 999)};
    int sum = 0;
    bool doubtful = false;
    for (const auto& face : mesh.faces) {
      for (std::size_t i = 1; i + 1 < face.size() && !doubtful; ++i) {
        const Place a = on(mesh.points[face[0]]);
        const Place b = on(mesh.points[face[i]]);
        const Place c = on(mesh.points[face[i + 1]]);
        const int from = side(a, b, c, p);
        const int to = side(a, b, c, q);
        if (from == to && from != 0) continue;
        const int s = side(p, q, a, b);
        const int t = side(p, q, b, c);
        const int u = side(p, q, c, a);
        if (s * t < 0 || t * u < 0 || s * u < 0) continue;
        if (from == 0 || to == 0 || s == 0 || t == 0 || u == 0) {
          doubtful = true;
        } else {
          sum += from;
        }
      }
    }
    if (!doubtful) return sum != 0;
  }
  return std::nullopt;
}

void check_points(const PolygonMesh& a, const PolygonMesh& b, const Solid& united, const Solid& both, const Solid& rest,
                  int count, Random& random) {
  const PointLocator in_union(united);
  const PointLocator in_both(both);
  const PointLocator in_rest(rest);
  for (int i = 0; i < count; ++i) {
    const long spread = std::lround(5.0 / step);
    const auto coordinate = [&] {
      return static_cast<long>(random() % static_cast<std::uint64_t>(spread)) - spread / 10;
    };
    const Place p{coordinate(), coordinate(), coordinate()};
    const auto in_a = inside(a, p, random);
    const auto in_b = inside(b, p, random);
    if (!in_a || !in_b) continue;
    const Point3 at{static_cast<double>(p.x) * step, static_cast<double>(p.y) * step, static_cast<double>(p.z) * step};
    const auto expect = [&](const PointLocator& locator, bool expected, const char* what) {
      EXPECT_EQ(locator.locate(at), expected ? Location::Inside : Location::Outside)
          << what << " at " << at.x << " " << at.y << " " << at.z;
    };
    expect(in_union, *in_a || *in_b, "union");
    expect(in_both, *in_a && *in_b, "intersection");
    expect(in_rest, *in_a && !*in_b, "difference");
  }
}

void check_pair(const PolygonMesh& first, const PolygonMesh& second, int points, Random& random) {
  const auto a = from_mesh(first);
  const auto b = from_mesh(second);
  ASSERT_TRUE(a.ok()) << a.error().message;
  ASSERT_TRUE(b.ok()) << b.error().message;
  const Solid united = unite({*a, *b});
  const Solid both = common({*a, *b});
  const Solid rest = subtract({*a, *b});
  const Solid other = subtract({*b, *a});
  for (const Solid& s : {*a, *b, united, both, rest, other}) {
    EXPECT_THAT(check::violations(s), testing::IsEmpty());
    EXPECT_TRUE(euler_holds(s.counts()));
  }
  const double sum = volume(*a) + volume(*b);
  EXPECT_NEAR(volume(united) + volume(both), sum, 1e-12 * sum);
  EXPECT_NEAR(volume(rest) + volume(both), volume(*a), 1e-12 * sum);
  EXPECT_NEAR(volume(other) + volume(both), volume(*b), 1e-12 * sum);
  // Chains: what was taken away put back, idempotence.
  const Solid whole_again = unite({rest, both});
  EXPECT_NEAR(volume(whole_again), volume(*a), 1e-12 * sum);
  EXPECT_EQ(whole_again.counts(), a->counts());
  EXPECT_EQ(unite({united, united}).counts(), united.counts());
  EXPECT_TRUE(subtract({rest, rest}).empty());
  EXPECT_TRUE(common({rest, both}).empty());
  check_points(first, second, united, both, rest, points, random);
}

TEST(SolidRandom, PairsOfLatticeBoxesMeetInEveryWay) {
  const std::uint64_t first = first_seed();
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(cases(60)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PolygonMesh a = lattice_box(random);
    const PolygonMesh b = lattice_box(random);
    check_pair(a, b, points_of_a_pair(), random);
    if (HasFailure()) return;
  }
}

TEST(SolidRandom, PairsOfAllKindsKeepTheirVolumesAndPoints) {
  const std::uint64_t first = first_seed();
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(cases(40)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed + 77000000);
    const PolygonMesh a = shape(random);
    const PolygonMesh b = shape(random);
    check_pair(a, b, points_of_a_pair(), random);
    if (HasFailure()) return;
  }
}

TEST(SolidRandom, PairsOfTerrainBlocksMeetAlongTheirTopsOrCrossThem) {
  const std::uint64_t first = first_seed();
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(cases(40)); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed + 99000000);
    const int field = whole(random, 0, 2);
    const PolygonMesh a = terrain_block(random, field, true);
    const PolygonMesh b = terrain_block(random, field, whole(random, 0, 1) == 0);
    check_pair(a, b, points_of_a_pair(), random);
    if (HasFailure()) return;
  }
}

// The ridge touches the top of the block from below. Its middle is a corner of one slope and none of the other, which
// is plane, so that the top has a corner within an edge of its own.
TEST(SolidRandom, ARidgeThatTouchesAFaceFromWithinIsTakenAwayAndPutBack) {
  const PolygonMesh block = box({0, 0, 0}, {4, 4, 3});
  const double heights[3][3] = {{2, 1.5, 2}, {3, 3, 3}, {2, 2, 2}};
  const PolygonMesh ridge = terrain(2, 2, 1.0, [&](std::uint32_t i, std::uint32_t j) {
    return Point3{1.0 + i, 1.0 + j, heights[j][i]};
  });
  Random random(1);
  check_pair(block, ridge, 20, random);
}

TEST(SolidRandom, TetrahedraThatShareAFaceBecomeOneWithoutIt) {
  Random random(5);
  std::uniform_real_distribution<double> real(0.0, 1.0);
  const auto corner = [&] { return Point3{real(random), real(random), real(random)}; };
  for (int i = 0; i < cases(300); ++i) {
    SCOPED_TRACE(i);
    const Point3 a = corner();
    const Point3 b = corner();
    const Point3 c = corner();
    const Point3 d = corner();
    Point3 e = corner();
    const auto height = [&](Point3 p) { return dot(cross(b - a, c - a), p - a); };
    if (height(d) * height(e) > 0.0) {
      // On the other side: mirrored in a, roughly.
      e = a + (a - e);
      if (height(d) * height(e) > 0.0) continue;
    }
    const Solid one = solid(tetrahedron(a, b, c, d));
    const Solid two = solid(tetrahedron(a, b, c, e));
    const Combined united = combined({one, two}, Operation::Union);
    EXPECT_EQ(united.contact, Contact::Face);
    EXPECT_EQ(united.solid.counts(), (Counts{5, 9, 6, 0, 1, 0}));
    EXPECT_NEAR(volume(united.solid), volume(one) + volume(two), 4e-16 * volume(united.solid));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace dobra::solid
