#include "shared/topo/subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "shared/topo/adjacency.h"
#include "shared/topo/locate.h"
#include "tests/shared/topo/snapshot.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Polyline;
using geom::Segment;

struct Counts {
  std::size_t v, e, f, c;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& n) {
    return out << "V" << n.v << " E" << n.e << " F" << n.f << " C" << n.c;
  }
};

Counts counts(const Subdivision& s) { return {s.vertex_count(), s.edge_count(), s.face_count(), s.component_count()}; }

Inserted put(Subdivision& s, const Polyline& p) { return insert(s, p).value(); }
Inserted put(Subdivision& s, Point a, Point b) { return insert(s, Segment{a, b}).value(); }

double bounded_area(const Subdivision& s) {
  double sum = 0.0;
  for (const FaceId f : s.faces()) {
    if (f != Subdivision::unbounded()) sum += area(s, f);
  }
  return sum;
}

std::vector<Segment> chords(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(0.0, 4.0);
  const auto on_border = [&] {
    const double t = at(random);
    if (t < 1.0) return Point{t, 0.0};
    if (t < 2.0) return Point{1.0, t - 1.0};
    if (t < 3.0) return Point{3.0 - t, 1.0};
    return Point{0.0, 4.0 - t};
  };
  std::vector<Segment> all;
  while (all.size() < count) {
    const Segment s{on_border(), on_border()};
    if (s.from != s.to) all.push_back(s);
  }
  return all;
}

TEST(Subdivision, EmptyHasOneUnboundedFace) {
  const Subdivision s;
  EXPECT_EQ(counts(s), (Counts{0, 0, 1, 0}));
  expect_sound(s);
}

TEST(Subdivision, HED_a_SquareHasFourVerticesFourEdgesTwoFaces) {
  Subdivision s;
  const Inserted in = put(s, square(0, 0, 1));
  EXPECT_EQ(counts(s), (Counts{4, 4, 2, 1}));
  EXPECT_EQ(in.path.size(), 4U);
  EXPECT_EQ(in.edges.size(), 4U);
  ASSERT_EQ(in.faces.size(), 1U);
  EXPECT_DOUBLE_EQ(area(s, in.faces[0]), 1.0);
  expect_sound(s);
}

TEST(Subdivision, HED_b_DiagonalMakesThreeFaces) {
  Subdivision s;
  put(s, square(0, 0, 1));
  const Inserted in = put(s, {0, 0}, {1, 1});
  EXPECT_EQ(counts(s), (Counts{4, 5, 3, 1}));
  ASSERT_EQ(in.faces.size(), 1U);
  EXPECT_DOUBLE_EQ(area(s, in.faces[0]), 0.5);
  expect_sound(s);
}

TEST(Subdivision, HED_c_CrossingSegmentsHaveFiveVerticesFourEdgesOneFace) {
  Subdivision s;
  put(s, {0, 0}, {1, 1});
  const Inserted in = put(s, {0, 1}, {1, 0});
  EXPECT_EQ(counts(s), (Counts{5, 4, 1, 1}));
  EXPECT_EQ(in.path.size(), 2U);
  EXPECT_EQ(in.edges.size(), 2U);
  EXPECT_TRUE(s.vertex_at({0.5, 0.5}).has_value());
  expect_sound(s);
}

TEST(Subdivision, HED_d_HashHasOneBoundedFaceOfExactArea) {
  Subdivision s;
  put(s, {0, 1}, {4, 1});
  put(s, {0, 3}, {4, 3});
  put(s, {1, 0}, {1, 4});
  put(s, {3, 0}, {3, 4});
  EXPECT_EQ(counts(s), (Counts{12, 12, 2, 1}));
  EXPECT_EQ(bounded_area(s), 4.0);
  expect_sound(s);
}

TEST(Subdivision, HED_e_SquareInSquareHasAFaceWithTwoLoops) {
  for (const bool inner_first : {false, true}) {
    Subdivision s;
    put(s, inner_first ? square(1, 1, 1) : square(0, 0, 3));
    put(s, inner_first ? square(0, 0, 3) : square(1, 1, 1));
    EXPECT_EQ(counts(s), (Counts{8, 8, 3, 2}));
    const Location middle = locate(s, {0.5, 0.5});
    ASSERT_EQ(middle.where, Where::Face);
    EXPECT_EQ(s.loops(middle.face).size(), 2U);
    EXPECT_EQ(area(s, middle.face), 8.0);
    expect_sound(s);
  }
}

TEST(Subdivision, HED_f_CoincidentPartsAreMerged) {
  Subdivision s;
  put(s, {0, 0}, {2, 0});
  const Inserted half = put(s, {1, 0}, {3, 0});  // overlaps half
  EXPECT_EQ(counts(s), (Counts{4, 3, 1, 1}));
  EXPECT_EQ(half.path.size(), 2U);
  EXPECT_EQ(half.edges.size(), 1U);
  put(s, {0.5, 1}, {0.5, 0});  // ends on an edge
  EXPECT_EQ(counts(s), (Counts{6, 5, 1, 1}));
  put(s, {0.5, 1}, {3, 0});  // ends on vertices
  EXPECT_EQ(counts(s), (Counts{6, 6, 2, 1}));
  const Inserted again = put(s, {3, 0}, {0, 0});  // all there already, the other way
  EXPECT_EQ(counts(s), (Counts{6, 6, 2, 1}));
  EXPECT_TRUE(again.edges.empty());
  ASSERT_EQ(again.path.size(), 4U);
  EXPECT_EQ(s.point(s.origin(again.path.front())), (Point{3, 0}));
  EXPECT_EQ(s.point(s.target(again.path.back())), (Point{0, 0}));
  expect_sound(s);
}

TEST(Subdivision, HED_f_ZeroLengthIsRefusedWithAMessageAndPlace) {
  Subdivision s;
  const auto refused = insert(s, Segment{{2, 3}, {2, 3}});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::DegenerateCurve);
  ASSERT_TRUE(refused.error().place.has_value());
  EXPECT_EQ(refused.error().place->x, 2.0);
  EXPECT_FALSE(insert(s, Segment{{0, 0}, {std::nan(""), 1}}).ok());
  EXPECT_EQ(counts(s), (Counts{0, 0, 1, 0}));
}

TEST(Subdivision, HED_g_TwoHundredChordsTileTheUnitSquare) {
  Subdivision s;
  put(s, square(0, 0, 1));
  for (const Segment& chord : chords(200, 7)) {
    const Inserted in = insert(s, chord).value();
    EXPECT_EQ(s.point(s.origin(in.path.front())), chord.from);
    EXPECT_EQ(s.point(s.target(in.path.back())), chord.to);
    for (std::size_t i = 1; i < in.path.size(); ++i) EXPECT_EQ(s.origin(in.path[i]), s.target(in.path[i - 1]));
  }
  EXPECT_EQ(s.vertex_count() + s.face_count(), s.edge_count() + 1 + s.component_count());
  EXPECT_NEAR(bounded_area(s), 1.0, 1e-9);
  EXPECT_GT(s.face_count(), 5000U);
  expect_sound(s);
}

TEST(Subdivision, HED_h_RemovingAllEdgesInAnyOrderLeavesOneFace) {
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U}) {
    Subdivision s;
    put(s, square(0, 0, 1));
    put(s, square(0.4, 0.4, 0.1));
    for (const Segment& chord : chords(12, seed)) ASSERT_TRUE(insert(s, chord).ok());
    std::vector<EdgeId> edges = s.edges();
    std::shuffle(edges.begin(), edges.end(), std::mt19937(seed));
    for (const EdgeId e : edges) {
      ASSERT_TRUE(remove(s, e).ok());
      expect_sound(s);
      ASSERT_FALSE(::testing::Test::HasFailure());
    }
    EXPECT_EQ(counts(s), (Counts{0, 0, 1, 0}));
  }
}

TEST(Subdivision, HED_i_SplitFaceCopiesTheAttributeAndMergedFaceKeepsItsOwn) {
  Subdivision s;
  const FaceId f = put(s, square(0, 0, 1)).faces.at(0);
  s.attribute(f) = std::string("sandstone");
  const Inserted in = put(s, {0, 0}, {1, 1});
  const FaceId g = in.faces.at(0);
  EXPECT_EQ(std::any_cast<std::string>(s.attribute(g)), "sandstone");
  EXPECT_EQ(std::any_cast<std::string>(s.attribute(f)), "sandstone");
  s.attribute(f) = 1;
  s.attribute(g) = 2;
  const HalfEdgeId h = Subdivision::half_edge(in.edges.at(0));
  EXPECT_EQ(s.kef(s.face(h) == g ? h : Subdivision::twin(h)), g);
  EXPECT_EQ(std::any_cast<int>(s.attribute(g)), 2);
  EXPECT_FALSE(s.contains(f));
  const EdgeId e = in.edges.at(0) == EdgeId(0) ? EdgeId(1) : EdgeId(0);
  s.attribute(e) = 5;
  const VertexId v = s.split(e, geom::midpoint(s.segment(e).from, s.segment(e).to));
  for (const HalfEdgeId out : s.round(v)) EXPECT_EQ(std::any_cast<int>(s.attribute(Subdivision::edge(out))), 5);
}

TEST(Subdivision, HED_j_NineAdjacencyQueriesOfACube) {
  Subdivision s;  // the cube's graph in the plane: the outer square is a face of the cube too
  put(s, square(0, 0, 3));
  put(s, square(1, 1, 1));
  for (const auto& [a, b] :
       {std::pair<Point, Point>{{0, 0}, {1, 1}}, {{3, 0}, {2, 1}}, {{3, 3}, {2, 2}}, {{0, 3}, {1, 2}}})
    put(s, a, b);
  ASSERT_EQ(counts(s), (Counts{8, 12, 6, 1}));
  for (const VertexId v : s.vertices()) {
    EXPECT_EQ(vertices_of_vertex(s, v).size(), 3U);
    EXPECT_EQ(edges_of_vertex(s, v).size(), 3U);
    EXPECT_EQ(faces_of_vertex(s, v).size(), 3U);
  }
  for (const EdgeId e : s.edges()) {
    EXPECT_EQ(vertices_of_edge(s, e).size(), 2U);
    EXPECT_EQ(edges_of_edge(s, e).size(), 4U);
    EXPECT_EQ(faces_of_edge(s, e).size(), 2U);
  }
  for (const FaceId f : s.faces()) {
    EXPECT_EQ(vertices_of_face(s, f).size(), 4U);
    EXPECT_EQ(edges_of_face(s, f).size(), 4U);
    EXPECT_EQ(faces_of_face(s, f).size(), 4U);
  }
}

TEST(Subdivision, HED_j_NineAdjacencyQueriesOfASquareInASquare) {
  Subdivision s;
  put(s, square(0, 0, 3));
  put(s, square(1, 1, 1));
  const FaceId middle = locate(s, {0.5, 0.5}).face;
  EXPECT_EQ(vertices_of_face(s, middle).size(), 8U);
  EXPECT_EQ(edges_of_face(s, middle).size(), 8U);
  EXPECT_EQ(faces_of_face(s, middle).size(), 2U);
  const FaceId inner = locate(s, {1.5, 1.5}).face;
  EXPECT_EQ(faces_of_face(s, inner), std::vector<FaceId>{middle});
  EXPECT_EQ(faces_of_face(s, Subdivision::unbounded()), std::vector<FaceId>{middle});
  const VertexId v = *s.vertex_at({0, 0});
  EXPECT_EQ(vertices_of_vertex(s, v).size(), 2U);
  EXPECT_EQ(edges_of_vertex(s, v).size(), 2U);
  EXPECT_EQ(faces_of_vertex(s, v).size(), 2U);
  const EdgeId e = edges_of_vertex(s, v)[0];
  EXPECT_EQ(vertices_of_edge(s, e).size(), 2U);
  EXPECT_EQ(edges_of_edge(s, e).size(), 2U);
  EXPECT_EQ(faces_of_edge(s, e).size(), 2U);
}

TEST(Subdivision, EulerOperatorsAreUndoneByTheirInverses) {
  Subdivision s;
  const VertexId a = s.mvsf(Subdivision::unbounded(), {0, 0});
  EXPECT_EQ(counts(s), (Counts{1, 0, 1, 1}));
  const HalfEdgeId ab = s.mev(s.corner(a, {1, 0}), {1, 0});
  const HalfEdgeId bc = s.mev(s.corner(s.target(ab), {1, 1}), {1, 1});
  EXPECT_EQ(counts(s), (Counts{3, 2, 1, 1}));
  const VertexId c = s.target(bc);
  const VertexId lone = s.mvsf(Subdivision::unbounded(), {0.75, 0.25});
  const HalfEdgeId ca = s.mef(s.corner(c, {0, 0}), s.corner(a, {1, 1}));
  EXPECT_EQ(counts(s), (Counts{4, 3, 2, 2}));
  EXPECT_NE(s.face(s.lone_loop(lone)), Subdivision::unbounded());  // the new face took what it encloses
  expect_sound(s);
  const HalfEdgeId bridge = s.mekr(s.corner(a, {0.75, 0.25}), s.corner(lone, {0, 0}));
  EXPECT_EQ(counts(s), (Counts{4, 4, 2, 1}));
  expect_sound(s);
  s.kemr(bridge);
  EXPECT_EQ(counts(s), (Counts{4, 3, 2, 2}));
  expect_sound(s);
  const VertexId middle = s.split(Subdivision::edge(ca), {0.5, 0.5});
  expect_sound(s);
  EXPECT_EQ(s.join(middle), Subdivision::edge(ca));
  expect_sound(s);
  s.kef(Subdivision::half_edge(Subdivision::edge(ca)));
  EXPECT_EQ(s.face(s.lone_loop(lone)), Subdivision::unbounded());
  s.kvsf(lone);
  s.kev(bc);
  s.kev(ab);
  EXPECT_EQ(counts(s), (Counts{1, 0, 1, 1}));
  s.kvsf(a);
  EXPECT_EQ(counts(s), (Counts{0, 0, 1, 0}));
  expect_sound(s);
}

TEST(Subdivision, StaysSoundForIntegerAndNearlyDegenerateSegmentsInserted) {
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    std::mt19937 random(seed);
    Subdivision s;
    std::uniform_int_distribution<int> grid(0, 8);
    std::uniform_real_distribution<double> real(0.0, 1.0);
    for (int i = 0; i < 60; ++i) {
      Segment g;
      if (seed % 3 == 0) {
        g = {{double(grid(random)), double(grid(random))}, {double(grid(random)), double(grid(random))}};
      } else if (seed % 3 == 1) {  // a sheaf of nearly parallel segments: crossings crowd together
        g = {{real(random) * 1e-3, real(random) * 1e-13}, {1.0 - real(random) * 1e-3, real(random) * 1e-13}};
      } else {  // few bits: rounding moves crossings much
        const double base = 1e15;
        g = {{base + grid(random), base + grid(random)}, {base + grid(random), base + grid(random)}};
      }
      if (g.from == g.to) continue;
      const auto in = insert(s, g);
      ASSERT_TRUE(in.ok()) << in.error().message;
      EXPECT_EQ(s.point(s.origin(in->path.front())), g.from);
      EXPECT_EQ(s.point(s.target(in->path.back())), g.to);
    }
    expect_sound(s);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
  }
}

TEST(Subdivision, PointsAreLocatedInVertexEdgeAndFace) {
  Subdivision s;
  put(s, square(0, 0, 4));
  put(s, square(1, 1, 2));
  put(s, {0, 0}, {-1, -1});
  EXPECT_EQ(locate(s, {4, 4}).where, Where::Vertex);
  EXPECT_EQ(locate(s, {1, 2}).where, Where::Edge);
  EXPECT_EQ(locate(s, {-0.5, -0.5}).where, Where::Edge);
  EXPECT_EQ(locate(s, {-0.5, -0.25}).face, Subdivision::unbounded());
  EXPECT_EQ(area(s, locate(s, {2, 2}).face), 4.0);
  EXPECT_EQ(area(s, locate(s, {2, 0.5}).face), 12.0);
  EXPECT_EQ(area(s, locate(s, {1, 0.5}).face), 12.0);  // below a vertex and a vertical edge
  EXPECT_EQ(locate(s, {1, 5}).face, Subdivision::unbounded());
}

TEST(Subdivision, ManySeparateSquaresAndOneRoundThemAllKeepTheirFaces) {
  Subdivision s;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) put(s, square(i, j, 0.5));
  }
  put(s, square(-1, -1, 22));
  EXPECT_EQ(counts(s), (Counts{1604, 1604, 402, 401}));
  EXPECT_EQ(area(s, locate(s, {0.75, 0.75}).face), 484.0 - 100.0);
  put(s, {0.75, -1}, {0.75, 21});  // cuts the middle face in two
  expect_sound(s);
}

}  // namespace
}  // namespace dobra::topo
