#include "shared/solid/model.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <set>

#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using geom::Point3;

/// Every link from both sides, counts from scratch, connected parts, the relation.
std::vector<std::string> faults(const Model& m) {
  std::vector<std::string> found;
  std::set<std::size_t> vertices;
  std::set<std::size_t> shells;
  std::size_t loops = 0;
  const auto faces = m.faces();
  for (const FaceId f : faces) {
    shells.insert(m.shell(f).index());
    for (const LoopId l : m.loops(f)) {
      ++loops;
      if (m.face(l) != f) found.emplace_back("a loop is of another face");
      const auto halves = m.half_edges(l);
      if (halves.empty() != m.lone_vertex(l).valid()) found.emplace_back("a loop is neither edges nor a vertex");
      if (halves.empty()) vertices.insert(m.lone_vertex(l).index());
      for (const HalfEdgeId h : halves) {
        vertices.insert(m.origin(h).index());
        if (m.previous(m.next(h)) != h || m.loop(h) != l) found.emplace_back("links do not agree");
        if (m.origin(m.next(h)) != m.target(h)) found.emplace_back("an edge does not end where the next begins");
        if (m.shell(m.face(h)) != m.shell(m.face(Model::twin(h)))) found.emplace_back("an edge is between two shells");
      }
    }
  }
  const Counts c = m.counts();
  if (c.vertices != vertices.size() || c.edges != m.edges().size() || c.faces != faces.size() ||
      c.rings != loops - faces.size() || c.shells != shells.size()) {
    found.emplace_back("counts are wrong");
  }
  if (!shapes::euler_holds(c)) found.emplace_back("Euler's relation fails");
  return found;
}

/// v, e, f, r, h.
std::array<long, 5> numbers(const Model& m) {
  const Counts c = m.counts();
  return {long(c.vertices), long(c.edges), long(c.faces), long(c.rings), c.handles};
}

/// Raises the loop of a face by a vector: an edge from every corner, then the sides. The face keeps its id at the end.
void raise(Model& m, LoopId loop, geom::Vector3 by, const std::function<void()>& after_edges) {
  std::vector<HalfEdgeId> rim = m.half_edges(loop);
  std::vector<HalfEdgeId> up;
  for (const HalfEdgeId h : rim) up.push_back(m.mev(m.corner(h), m.point(m.origin(h)) + by).value());
  after_edges();
  HalfEdgeId start;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    // The new face is the side: below the new edge, from the next corner back.
    const HalfEdgeId here = Model::twin(up[i]);
    const HalfEdgeId there = i + 1 < rim.size() ? Model::twin(up[i + 1]) : start;
    const auto edge = m.mef(m.corner(here), m.corner(there));
    ASSERT_TRUE(edge.ok()) << edge.error().message;
    if (i == 0) start = *edge;
  }
}

TEST(SolidModel, SOL_a_BuildsABlockWithAHoleInElevenSteps) {
  Model m;
  std::vector<std::array<long, 5>> seen;
  std::vector<std::string> dumps;
  std::vector<std::size_t> lengths;
  const auto mark = [&] {
    seen.push_back(numbers(m));
    dumps.push_back(m.dump());
    lengths.push_back(m.operator_count());
    EXPECT_THAT(faults(m), testing::IsEmpty());
  };
  const FaceId base = m.mvsf({0, 0, 0});
  mark();  // a
  const VertexId first = m.lone_vertex(m.loops(base)[0]);
  const HalfEdgeId one = m.mev({first, {}}, {3, 0, 0}).value();
  mark();  // b
  const HalfEdgeId two = m.mev(m.corner(Model::twin(one)), {3, 3, 0}).value();
  const HalfEdgeId three = m.mev(m.corner(Model::twin(two)), {0, 3, 0}).value();
  mark();  // c
  ASSERT_TRUE(m.mef(m.corner(Model::twin(three)), m.corner(one)).ok());
  mark();                                  // d: the old face has the loop anticlockwise, seen from above
  raise(m, m.loop(one), {0, 0, 3}, mark);  // e
  mark();                                  // f
  // What was raised has stayed the base's id or moved: the upper face is that of the last edges.
  FaceId upper;
  FaceId lower;
  for (const FaceId f : m.faces()) {
    double low = 9.0;
    double high = -9.0;
    for (const HalfEdgeId h : m.half_edges(m.loops(f)[0])) {
      low = std::min(low, m.point(m.origin(h)).z);
      high = std::max(high, m.point(m.origin(h)).z);
    }
    if (low == 3.0) upper = f;
    if (high == 0.0) lower = f;
  }
  ASSERT_TRUE(upper.valid() && lower.valid());
  // The hole: a bridge, a square, the bridge out again.
  const HalfEdgeId bridge = m.mev(m.corner(m.first(m.loops(upper)[0])), {1, 1, 3}).value();
  mark();  // g
  HalfEdgeId at = bridge;
  for (const Point3 p : {Point3{1, 2, 3}, Point3{2, 2, 3}, Point3{2, 1, 3}}) {
    at = m.mev(m.corner(Model::twin(at)), p).value();
  }
  const HalfEdgeId last = m.mef(m.corner(Model::twin(at)), m.corner(Model::twin(bridge))).value();
  mark();  // h
  // One side of the square is a face of its own, the other still hangs on the bridge.
  ASSERT_TRUE(m.kemr(bridge).ok());
  mark();  // i
  const LoopId inner = m.loop(Model::twin(last));
  raise(m, inner, {0, 0, -3}, mark);  // j
  FaceId bottom;
  for (const FaceId f : m.faces()) {
    bool all = m.loops(f).size() == 1 && f != lower;
    for (const HalfEdgeId h : m.half_edges(m.loops(f)[0])) all = all && m.point(m.origin(h)).z == 0.0;
    if (all) bottom = f;
  }
  ASSERT_TRUE(bottom.valid());
  ASSERT_TRUE(m.kfmrh(lower, bottom).ok());
  mark();  // k
  EXPECT_THAT(seen, testing::ElementsAre(std::array<long, 5>{1, 0, 1, 0, 0}, std::array<long, 5>{2, 1, 1, 0, 0},
                                         std::array<long, 5>{4, 3, 1, 0, 0}, std::array<long, 5>{4, 4, 2, 0, 0},
                                         std::array<long, 5>{8, 8, 2, 0, 0}, std::array<long, 5>{8, 12, 6, 0, 0},
                                         std::array<long, 5>{9, 13, 6, 0, 0}, std::array<long, 5>{12, 17, 7, 0, 0},
                                         std::array<long, 5>{12, 16, 7, 1, 0}, std::array<long, 5>{16, 20, 7, 1, 0},
                                         std::array<long, 5>{16, 24, 10, 2, 1}));

  const auto made = to_solid(m);
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(volume(*made), 27.0 - 3.0);
  EXPECT_EQ(made->counts(), m.counts());

  // SOL-b: back by the inverses, the same at every step.
  while (m.operator_count() > 0) {
    const auto step = std::find(lengths.begin(), lengths.end(), m.operator_count());
    if (step != lengths.end()) {
      EXPECT_EQ(m.dump(), dumps[static_cast<std::size_t>(step - lengths.begin())]);
      EXPECT_EQ(numbers(m), seen[static_cast<std::size_t>(step - lengths.begin())]);
    }
    m.undo();
  }
  EXPECT_EQ(m.dump(), "");
  EXPECT_EQ(m.counts(), Counts{});
}

/// An operator at random; many are refused.
void any_operator(Model& m, std::mt19937_64& random) {
  const auto pick = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  const Counts c = m.counts();
  const auto faces = m.faces();
  if (faces.empty()) {
    m.mvsf({});
    return;
  }
  const FaceId f = faces[pick(faces.size())];
  const FaceId g = faces[pick(faces.size())];
  const LoopId l = m.loops(f)[pick(m.loops(f).size())];
  const LoopId k = m.loops(f)[pick(m.loops(f).size())];
  const auto corner_of = [&](LoopId loop) {
    const auto halves = m.half_edges(loop);
    return halves.empty() ? Corner{m.lone_vertex(loop), {}} : m.corner(halves[pick(halves.size())]);
  };
  const auto edges = m.edges();
  HalfEdgeId h;
  if (!edges.empty()) h = edges[pick(edges.size())];
  if (h.valid() && pick(2) == 0) h = Model::twin(h);
  const bool large = c.edges > 40;
  const Point3 p{static_cast<double>(pick(9)), static_cast<double>(pick(9)), static_cast<double>(pick(9))};
  switch (pick(12)) {
    case 0:
      if (c.shells < 4) m.mvsf(p);
      break;
    case 1:
      static_cast<void>(m.kvsf(f));
      break;
    case 2:
      if (!large) static_cast<void>(m.mev(corner_of(l), p));
      break;
    case 3:
      if (h.valid()) static_cast<void>(m.kev(h));
      break;
    case 4:
      if (!large) static_cast<void>(m.mef(corner_of(l), corner_of(l)));
      break;
    case 5:
      if (h.valid()) static_cast<void>(m.kef(h));
      break;
    case 6:
      if (h.valid()) static_cast<void>(m.kemr(h));
      break;
    case 7:
      static_cast<void>(m.mekr(corner_of(l), corner_of(k)));
      break;
    case 8:
      static_cast<void>(m.kfmrh(f, g));
      break;
    case 9:
      static_cast<void>(m.mfkrh(l));
      break;
    case 10:
      static_cast<void>(m.ksfmr(f, g));
      break;
    default:
      static_cast<void>(m.msfkr(l));
      break;
  }
}

TEST(SolidModel, SOL_b_RandomOperatorsGoBackToTheIdenticalDump) {
  const char* wanted = std::getenv("DOBRA_EULER_OPERATORS");
  const std::size_t count = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 100000;
  std::mt19937_64 random(9);
  Model m;
  std::vector<std::pair<std::size_t, std::string>> marks;
  std::array<long, 5> most{};
  while (m.operator_count() < count) {
    any_operator(m, random);
    const auto now = numbers(m);
    for (std::size_t i = 0; i < now.size(); ++i) most[i] = std::max(most[i], now[i]);
    if (m.operator_count() % 500 == 0 && (marks.empty() || marks.back().first != m.operator_count())) {
      ASSERT_THAT(faults(m), testing::IsEmpty());
      marks.emplace_back(m.operator_count(), m.dump());
    }
  }
  // It came to rings and handles, not to trees alone.
  EXPECT_GT(most[3], 2);
  EXPECT_GT(most[4], 2);
  while (m.operator_count() > 0) {
    if (!marks.empty() && marks.back().first == m.operator_count()) {
      ASSERT_EQ(m.dump(), marks.back().second);
      marks.pop_back();
    }
    m.undo();
  }
  EXPECT_EQ(m.dump(), "");
}

TEST(SolidModel, RefusesWhatBreaksThePreconditionsAndChangesNothing) {
  Model m;
  const FaceId f = m.mvsf({0, 0, 0});
  const HalfEdgeId h = m.mev({m.lone_vertex(m.loops(f)[0]), {}}, {1, 0, 0}).value();
  const HalfEdgeId g = m.mev(m.corner(Model::twin(h)), {1, 1, 0}).value();
  const std::string before = m.dump();
  EXPECT_FALSE(m.kvsf(f).ok());
  EXPECT_FALSE(m.kev(h).ok());  // its end has another edge
  EXPECT_FALSE(m.kef(h).ok());  // one face on both sides
  EXPECT_FALSE(m.kfmrh(f, f).ok());
  EXPECT_FALSE(m.ksfmr(f, f).ok());
  EXPECT_FALSE(m.mfkrh(m.loops(f)[0]).ok());  // no ring
  EXPECT_FALSE(m.msfkr(m.loops(f)[0]).ok());
  EXPECT_FALSE(m.mekr(m.corner(h), m.corner(g)).ok());  // one loop
  EXPECT_EQ(m.kev(HalfEdgeId(99)).error().code, base::ErrorCode::NotInSubdivision);
  EXPECT_EQ(m.dump(), before);
  EXPECT_EQ(m.operator_count(), 3U);
  EXPECT_FALSE(to_solid(m).ok());
}

}  // namespace
}  // namespace dobra::solid
