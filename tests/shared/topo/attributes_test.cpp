// The rules of attributes: split copies, merge keeps the survivor's, and a face stays itself where rounding makes an
// edge leave and come in again another way.

#include <random>

#include "shared/topo/adjacency.h"
#include "shared/topo/locate.h"
#include "tests/shared/topo/snapshot.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Polyline;
using geom::Segment;

std::any name(const char* text) { return std::string(text); }

TEST(Attributes, HED_i_FaceOfASplitIsCopiedAlsoToTheFaceRoundAHole) {
  Subdivision s;
  const FaceId f = insert(s, square(0, 0, 8)).value().faces.at(0);
  s.attribute(f) = name("shale");
  const FaceId hole = insert(s, square(2, 2, 2)).value().faces.at(0);
  EXPECT_EQ(text(s.attribute(hole)), "shale");
  insert(s, Segment{{0, 6}, {8, 6}}).value();
  for (const Point p : {Point{1, 1}, Point{3, 3}, Point{4, 7}})
    EXPECT_EQ(text(s.attribute(locate(s, p).face)), "shale");
}

TEST(Attributes, HED_i_MergedFacesKeepTheSurvivorsAndTheUnboundedFaceItsOwn) {
  Subdivision s;
  s.attribute(Subdivision::unbounded()) = name("outside");
  const FaceId f = insert(s, square(0, 0, 2)).value().faces.at(0);
  const FaceId g = insert(s, Segment{{1, 0}, {1, 2}}).value().faces.at(0);
  s.attribute(f) = name("f");
  s.attribute(g) = name("g");
  const HalfEdgeId middle = s.between(*s.vertex_at({1, 0}), *s.vertex_at({1, 2}));
  ASSERT_TRUE(remove(s, Subdivision::edge(middle)).ok());  // the lower id survives
  EXPECT_EQ(text(s.attribute(std::min(f, g))), f < g ? "f" : "g");
  ASSERT_TRUE(remove(s, edges_of_face(s, std::min(f, g)).front()).ok());
  EXPECT_EQ(s.face_count(), 1U);
  EXPECT_EQ(text(s.attribute(Subdivision::unbounded())), "outside");
}

TEST(Attributes, HED_i_EdgesCopyOnSplitAndKeepTheirOwnWhereACurveCoincides) {
  Subdivision s;
  const EdgeId e = insert(s, Segment{{0, 0}, {4, 0}}).value().edges.at(0);
  s.attribute(e) = name("fault");
  insert(s, Segment{{2, -1}, {2, 1}}).value();  // splits it
  insert(s, Segment{{3, 0}, {6, 0}}).value();   // overlaps it
  std::size_t named = 0;
  for (const EdgeId part : s.edges()) {
    const Segment g = s.segment(part);
    const bool old = g.from.y == 0 && g.to.y == 0 && std::max(g.from.x, g.to.x) <= 4;
    EXPECT_EQ(text(s.attribute(part)), old ? "fault" : "");
    named += old ? 1U : 0U;
  }
  EXPECT_EQ(named, 3U);
  const VertexId v = *s.vertex_at({3, 0});
  s.attribute(Subdivision::edge(s.between(v, *s.vertex_at({4, 0})))) = name("other");
  const EdgeId kept = Subdivision::edge(s.between(v, *s.vertex_at({2, 0})));
  s.join(v, kept);
  EXPECT_EQ(text(s.attribute(kept)), "fault");
}

TEST(Attributes, VerticesKeepTheirsUntilTheyGoAndAFreedNameStartsWithout) {
  Subdivision s;
  s.attribute() = name("model");
  const VertexId v = insert(s, Point{1, 1}).value();
  s.attribute(v) = name("well");
  insert(s, Segment{{0, 0}, {2, 2}}).value();
  EXPECT_EQ(s.vertex_at({1, 1}), v);
  EXPECT_EQ(text(s.attribute(v)), "well");
  for (const EdgeId e : s.edges()) ASSERT_TRUE(remove(s, e).ok());
  EXPECT_EQ(s.vertex_count(), 0U);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(s.attribute(insert(s, Point{double(i), 0}).value()).has_value());
  EXPECT_EQ(text(s.attribute()), "model");
}

/// A fan of thin triangles, each face named by where it is; then segments so placed that crossings are within rounding
/// of other edges, and edges have to be led another way.
TEST(Attributes, HED_i_FacesStayThemselvesWhereRoundingLeadsTheirEdgesAnotherWay) {
  std::size_t judged = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> real(0.0, 1.0);
    const double base = seed % 2 == 0 ? 0.0 : 1e6;
    Subdivision s;
    const int slices = 24;
    const auto rim = [&](int i) { return Point{base + i, base + 20}; };
    for (int i = 0; i <= slices; ++i) insert(s, Segment{{base + 12, base}, rim(i)}).value();
    for (int i = 0; i < slices; ++i) insert(s, Segment{rim(i), rim(i + 1)}).value();
    const auto middle = [&](int i) { return Point{base + 0.9 * (i + 0.5) + 1.2, base + 18}; };
    for (int i = 0; i < slices; ++i) s.attribute(locate(s, middle(i)).face) = std::to_string(i);
    // A sheaf of segments through the apex, where all edges crowd.
    const double eps = std::ldexp(base + 12, -50);
    for (int i = 0; i < 30; ++i) {
      const double y = base + eps * std::floor(40 * real(random));
      const Segment g{{base + 11 + real(random), y + eps * std::floor(9 * real(random))},
                      {base + 13 - 0.5 * real(random), y}};
      ASSERT_TRUE(insert(s, g).ok());
    }
    expect_sound(s);
    ASSERT_FALSE(HasFailure()) << seed;
    for (int i = 0; i < slices; ++i) {
      const Location at = locate(s, middle(i));
      ASSERT_EQ(at.where, Where::Face);
      EXPECT_EQ(text(s.attribute(at.face)), std::to_string(i)) << "seed " << seed;
      ++judged;
    }
    EXPECT_FALSE(s.attribute(Subdivision::unbounded()).has_value());
  }
  EXPECT_EQ(judged, 40U * 24U);
}

}  // namespace
}  // namespace dobra::topo
