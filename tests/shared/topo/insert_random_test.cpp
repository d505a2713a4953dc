// Whatever goes in and out: the subdivision is sound after every step.

#include <random>

#include "shared/topo/adjacency.h"
#include "shared/topo/locate.h"
#include "tests/shared/topo/snapshot.h"

namespace dobra::topo {
namespace {

using geom::Point;
using geom::Polyline;

/// Where the next point comes from; the worse for arithmetic the further down.
enum class Family { Lattice, Real, NearPoints, HairGaps, Collinear, Huge, Tiny, Mixed, FarOff, Sheaf, count };

class Source {
 public:
  Source(Family family, std::uint32_t seed) : family_(family), random_(seed) {}

  Point point() {
    switch (family_) {
      case Family::Lattice:
        return {double(whole(6)), double(whole(6))};
      case Family::Real:
        return {real(), real()};
      case Family::NearPoints:
        return {near(whole(4)), near(whole(4))};
      case Family::HairGaps:
        return {double(whole(4)) + 1e-16 * whole(3), 1e-16 * whole(8)};
      case Family::Collinear:
        return on_line();
      case Family::Huge:
        return {3e150 * (real() - 0.5), 3e150 * (real() - 0.5)};
      case Family::Tiny:
        return {whole(9) * 4.9e-324, whole(9) * 4.9e-324};
      case Family::Mixed:
        return {std::ldexp(real() - 0.5, whole(300) - 150), std::ldexp(real() - 0.5, whole(300) - 150)};
      case Family::FarOff:
        return {4503599627370000.0 + whole(9), -9007199254740000.0 + whole(9)};
      case Family::Sheaf:
        return {whole(2) + 1e-3 * real(), 1e-15 * whole(16)};
      case Family::count:
        break;
    }
    return {};
  }
  int whole(int below) { return static_cast<int>(random_() % static_cast<std::uint32_t>(below)); }

 private:
  double real() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  double near(int value) {
    double x = value / 3.0;
    for (int i = whole(3); i > 0; --i) x = std::nextafter(x, 2.0);
    return x;
  }
  Point on_line() {
    const double t = whole(12) / 7.0;  // in doubles the points of 3 lines lie on them, or beside them by an ulp
    switch (whole(3)) {
      case 0:
        return {t, t};
      case 1:
        return {t, 1.0 - t / 3.0};
      default:
        return {t, 0.1 * t};
    }
  }

  Family family_;
  std::mt19937 random_;
};

/// A segment, a chain with repeats, or a contour that may cross itself.
Polyline curve(Source& source) {
  Polyline made;
  const int points = source.whole(4) == 0 ? 3 + source.whole(4) : 2;
  for (int i = 0; i < points; ++i)
    made.points.push_back(i > 0 && source.whole(6) == 0 ? made.points.back() : source.point());
  made.closed = points > 2 && source.whole(2) == 0;
  return made;
}

/// The path must lead from the first point to the last through all others, and never stray from the curve by more than
/// rounding.
void expect_path(const Subdivision& s, const Polyline& curve, const Inserted& in) {
  double size = 0.0;
  for (const VertexId v : s.vertices()) size = std::max({size, std::abs(s.point(v).x), std::abs(s.point(v).y)});
  // Measured where squares neither overflow nor vanish.
  const int exponent = size > 0.0 ? -std::ilogb(size) : 0;
  const auto scaled = [&](Point p) { return Point{std::scalbn(p.x, exponent), std::scalbn(p.y, exponent)}; };
  const double rounding = std::max(1e-12, std::scalbn(8 * std::numeric_limits<double>::denorm_min(), exponent));
  ASSERT_FALSE(in.path.empty());
  EXPECT_EQ(s.point(s.origin(in.path.front())), curve.points.front());
  EXPECT_EQ(s.point(s.target(in.path.back())), curve.closed ? curve.points.front() : curve.points.back());
  std::size_t reached = 0;
  while (reached < curve.points.size() && curve.points[reached] == curve.points.front()) ++reached;
  for (std::size_t i = 0; i < in.path.size(); ++i) {
    if (i > 0) {
      ASSERT_EQ(s.origin(in.path[i]), s.target(in.path[i - 1]));
    }
    const Point p = s.point(s.target(in.path[i]));
    double away = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < curve.segment_count(); ++k) {
      const geom::Segment g = curve.segment(k);
      away = std::min(away, geom::distance(geom::Segment{scaled(g.from), scaled(g.to)}, scaled(p)));
    }
    EXPECT_LE(away, rounding);
    while (reached < curve.points.size() && curve.points[reached] == p) ++reached;
  }
  EXPECT_EQ(reached, curve.points.size());
  for (const EdgeId e : in.edges) EXPECT_TRUE(s.contains(e));
  for (const FaceId f : in.faces) EXPECT_TRUE(s.contains(f));
}

class InsertRandom : public ::testing::TestWithParam<std::tuple<int, std::uint32_t>> {};

TEST_P(InsertRandom, HED_g_SoundAfterEveryInsertionAndRemovalWhateverTheInput) {
  const auto family = static_cast<Family>(std::get<0>(GetParam()));
  Source source(family, 977 * std::get<1>(GetParam()) + 5);
  Subdivision s;
  for (int step = 0; step < 60; ++step) {
    const auto edges = s.edges();
    if (source.whole(3) == 0 && !edges.empty()) {
      const EdgeId e = edges[static_cast<std::size_t>(source.whole(1 << 20)) % edges.size()];
      ASSERT_TRUE(remove(s, e, source.whole(2) == 0 ? Bare::Keep : Bare::Remove).ok());
    } else if (source.whole(8) == 0) {
      const Point p = source.point();
      const auto v = insert(s, p);
      ASSERT_TRUE(v.ok());
      EXPECT_EQ(s.point(*v), p);
    } else {
      const Polyline line = curve(source);
      const auto in = insert(s, line);
      if (!in.ok()) {
        ASSERT_EQ(in.error().code, base::ErrorCode::DegenerateCurve);
        continue;
      }
      expect_path(s, line, *in);
    }
    expect_sound(s);
    ASSERT_FALSE(HasFailure()) << "step " << step;
  }
}

TEST_P(InsertRandom, HED_h_RemovingEverythingInAnyOrderLeavesOneFace) {
  const auto family = static_cast<Family>(std::get<0>(GetParam()));
  Source source(family, 31 * std::get<1>(GetParam()) + 2);
  Subdivision s;
  for (int i = 0; i < 20; ++i) (void)insert(s, curve(source)).ok();
  while (s.edge_count() > 0) {
    const auto edges = s.edges();
    ASSERT_TRUE(remove(s, edges[static_cast<std::size_t>(source.whole(1 << 20)) % edges.size()]).ok());
    if (s.edge_count() % 8 == 0) expect_sound(s);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(s.vertex_count(), 0U);
  EXPECT_EQ(s.face_count(), 1U);
  EXPECT_EQ(s.loop_count(), 0U);
  EXPECT_EQ(s.component_count(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Families, InsertRandom,
                         ::testing::Combine(::testing::Range(0, static_cast<int>(Family::count)),
                                            ::testing::Range(0U, 6U)));

/// The same from the read-only side by brute force: a face is where the number of edges above is odd or even for each
/// loop.
TEST(Locate, AgreesWithTheParityOfEveryLoop) {
  Source source(Family::Real, 3);
  Subdivision s;
  for (int i = 0; i < 60; ++i) (void)insert(s, curve(source)).ok();
  const auto inside = [&](LoopId l, Point p) {
    bool odd = false;
    for (const HalfEdgeId h : s.half_edges(l)) {
      const auto g = s.segment(h);
      if ((g.from.x <= p.x) != (g.to.x <= p.x) &&
          g.from.y + (p.x - g.from.x) / (g.to.x - g.from.x) * (g.to.y - g.from.y) > p.y)
        odd = !odd;
    }
    return odd;
  };
  for (int i = 0; i < 500; ++i) {
    const Point p = source.point();
    const FaceId found = locate(s, p).face;
    for (const FaceId f : s.faces()) {
      bool in = true;
      for (const LoopId l : s.loops(f)) in = in && (l == s.outer_loop(f)) == inside(l, p);
      EXPECT_EQ(in, f == found);
    }
  }
}

TEST(Adjacency, HED_j_IsolatedVerticesDanglingEdgesAndRepeatedNeighboursCountOnce) {
  Subdivision s;
  insert(s, Polyline{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true}).value();
  insert(s, geom::Segment{{0, 0}, {1, 1}}).value();  // dangles
  const VertexId lone = insert(s, Point{3, 1}).value();
  const FaceId f = locate(s, {2, 3}).face;
  EXPECT_TRUE(vertices_of_vertex(s, lone).empty());
  EXPECT_TRUE(edges_of_vertex(s, lone).empty());
  EXPECT_EQ(faces_of_vertex(s, lone), std::vector<FaceId>{f});
  EXPECT_EQ(vertices_of_face(s, f).size(), 6U);
  EXPECT_EQ(edges_of_face(s, f).size(), 5U);  // the dangling one once
  EXPECT_EQ(faces_of_face(s, f), std::vector<FaceId>{Subdivision::unbounded()});
  const VertexId corner = *s.vertex_at({0, 0});
  EXPECT_EQ(vertices_of_vertex(s, corner).size(), 3U);
  EXPECT_EQ(faces_of_vertex(s, corner).size(), 2U);
  const EdgeId dangling = Subdivision::edge(s.between(corner, *s.vertex_at({1, 1})));
  EXPECT_EQ(faces_of_edge(s, dangling), std::vector<FaceId>{f});
  EXPECT_EQ(edges_of_edge(s, dangling).size(), 2U);
}

TEST(Remove, HED_h_AnEdgeThatIsNotThereIsRefused) {
  Subdivision s;
  const EdgeId e = insert(s, geom::Segment{{0, 0}, {1, 0}}).value().edges.at(0);
  ASSERT_TRUE(remove(s, e).ok());
  const auto again = remove(s, e);
  ASSERT_FALSE(again.ok());
  EXPECT_EQ(again.error().code, base::ErrorCode::NotInSubdivision);
}

}  // namespace
}  // namespace dobra::topo
