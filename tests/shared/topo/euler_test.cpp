// Each Euler operator and its inverse: what was there before comes back, names included.

#include <random>

#include "shared/geom/intersect.h"
#include "shared/topo/locate.h"
#include "tests/shared/topo/snapshot.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Segment;

/// Segments on a coarse lattice, contours in contours, dangling edges, isolated points; some edges removed again, so
/// that freed names are about; everything named by an attribute.
Subdivision sketch(std::mt19937& random) {
  Subdivision s;
  std::uniform_int_distribution<int> at(0, 12);
  const auto point = [&] { return Point{double(at(random)), double(at(random))}; };
  for (int i = 0; i < 14; ++i) {
    const Segment g{point(), point()};
    if (g.from != g.to) insert(s, g).value();
    EXPECT_TRUE(insert(s, point() + geom::Vector{0.25, 0.125}).ok());
  }
  for (int i = 0; i < 4; ++i) {
    const Point p = point() + geom::Vector{0.3, 0.6};
    EXPECT_TRUE(insert(s, geom::Polyline{{p, p + geom::Vector{0.2, 0}, p + geom::Vector{0.1, 0.15}}, true}).ok());
  }
  for (int i = 0; i < 4; ++i) {
    const auto edges = s.edges();
    EXPECT_TRUE(remove(s, edges[random() % edges.size()], i % 2 == 0 ? Bare::Keep : Bare::Remove).ok());
  }
  std::size_t name = 0;
  for (const VertexId v : s.vertices()) s.attribute(v) = "v" + std::to_string(name++);
  for (const EdgeId e : s.edges()) s.attribute(e) = "e" + std::to_string(name++);
  for (const FaceId f : s.faces()) s.attribute(f) = "f" + std::to_string(name++);
  return s;
}

/// True if the segment between two vertices meets nothing else.
bool sees(const Subdivision& s, const Segment& g) {
  for (const EdgeId e : s.edges()) {
    const auto meet = geom::intersect(g, s.segment(e));
    if (meet.kind == geom::IntersectionKind::Overlap) return false;
    if (meet.kind == geom::IntersectionKind::Point && meet.start.on_first == geom::At::Interior) return false;
  }
  for (const VertexId v : s.vertices()) {
    if (s.point(v) != g.from && s.point(v) != g.to && geom::point_on_segment(s.point(v), g)) return false;
  }
  return true;
}

void expect_undone(const Subdivision& s, const Snapshot& before) {
  expect_sound(s);
  EXPECT_TRUE(snapshot(s) == before);
}

class Euler : public ::testing::TestWithParam<std::uint32_t> {
 protected:
  std::mt19937 random{GetParam()};
  Subdivision s{sketch(random)};
  Snapshot before{snapshot(s)};
};

TEST_P(Euler, KvsfUndoesMvsfInAnyFace) {
  std::uniform_real_distribution<double> at(-1.0, 13.0);
  for (int i = 0; i < 20; ++i) {
    const Point p{at(random), at(random)};
    const Location where = locate(s, p);
    ASSERT_EQ(where.where, Where::Face);
    const VertexId v = s.mvsf(where.face, p);
    expect_sound(s);
    EXPECT_EQ(s.component_count(), before.components + 1);
    s.kvsf(v);
    expect_undone(s, before);
  }
}

TEST_P(Euler, KevUndoesMevAtAnyVertex) {
  for (const VertexId v : s.vertices()) {
    const Point p = s.point(v) + geom::Vector{1.3e-7, (random() % 2 == 0 ? 1.7e-7 : -2.9e-7)};
    const HalfEdgeId h = s.mev(s.corner(v, p), p);
    if (v.index() % 8 == 0) expect_sound(s);
    EXPECT_EQ(s.component_count(), before.components);
    s.kev(h);
    EXPECT_TRUE(snapshot(s) == before) << v;
  }
  expect_sound(s);
}

TEST_P(Euler, KefUndoesMefAndKemrUndoesMekrBetweenAnyTwoVerticesThatSeeEachOther) {
  int faces_made = 0;
  int rings_killed = 0;
  const auto vertices = s.vertices();
  for (int i = 0; i < 1500; ++i) {
    const VertexId a = vertices[random() % vertices.size()];
    const VertexId b = vertices[random() % vertices.size()];
    if (a == b || s.between(a, b).valid() || !sees(s, {s.point(a), s.point(b)})) continue;
    const Corner from = s.corner(a, s.point(b));
    const Corner to = s.corner(b, s.point(a));
    const FaceId in = s.face(from);
    const bool same_loop = s.loop(from) == s.loop(to);
    const HalfEdgeId h = same_loop ? s.mef(from, to) : s.mekr(from, to);
    if (i % 16 == 0) expect_sound(s);
    ++(same_loop ? faces_made : rings_killed);
    if (same_loop) {
      EXPECT_EQ(text(s.attribute(s.face(h))), text(s.attribute(s.face(Subdivision::twin(h)))));
      EXPECT_EQ(s.kef(s.face(h) == in ? h : Subdivision::twin(h)), in);
    } else {
      s.kemr(h);
    }
    ASSERT_TRUE(snapshot(s) == before) << a << b;
  }
  expect_sound(s);
  EXPECT_GT(faces_made, 5);
  EXPECT_GT(rings_killed, 5);
}

TEST_P(Euler, JoinUndoesSplitOfAnyEdge) {
  for (const EdgeId e : s.edges()) {
    const VertexId v = s.split(e, geom::midpoint(s.segment(e).from, s.segment(e).to), Room::Unknown);
    expect_sound(s);
    EXPECT_EQ(s.join(v, e), e);
    EXPECT_TRUE(snapshot(s) == before) << e;
  }
}

INSTANTIATE_TEST_SUITE_P(Sketches, Euler, ::testing::Range(0U, 8U));

}  // namespace
}  // namespace dobra::topo
