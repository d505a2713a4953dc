#include "shared/io/faces/unlike_edges.h"

#include <gtest/gtest.h>

namespace dobra::io::faces {
namespace {

using surf::trim::ChartEdge;
using surf::trim::TrimmedSurface;

/// A square of the plane z = 0 from x to x + 1; its side at `shared_x` is curve 7.
TrimmedSurface square(double x, double shared_x, double longer = 0.0, bool against = false) {
  TrimmedSurface face{.surface = *surf::Surface::plane({}, {{-5, -5}, {5, 5}})};
  const std::vector<geom::Point> corners{{x, 0}, {x + 1, 0}, {x + 1, 1 + longer}, {x, 1 + longer}};
  face.loops.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) {
    const geom::Point a = corners[i], b = corners[(i + 1) % 4];
    ChartEdge edge{.curve = *surf::Curve::line({a.x, a.y, 0}, {b.x, b.y, 0})};
    if (a.x == shared_x && b.x == shared_x) edge.shared = surf::trim::SharedCurveId(7), edge.against = against;
    edge.name = "edge 8";
    face.loops[0].edges.push_back(edge);
  }
  return face;
}

std::size_t apart(std::vector<TrimmedSurface>& faces, std::vector<surf::mesh::Finding>& findings) {
  part_unlike_edges(faces, std::vector<base::Place>(faces.size()), findings);
  return findings.size();
}

TEST(UnlikeEdges, StayOneWhereTheyAreOne) {
  // The right side of the first runs up, the left side of the second down.
  std::vector<TrimmedSurface> faces{square(0, 1), square(1, 1, 0.0, true), square(1, 1, 0.05, true)};
  std::vector<surf::mesh::Finding> findings;
  EXPECT_EQ(apart(faces, findings), 0U);
  for (const TrimmedSurface& face : faces) {
    EXPECT_EQ(std::count_if(face.loops[0].edges.begin(), face.loops[0].edges.end(),
                            [](const ChartEdge& edge) { return edge.shared.has_value(); }),
              1);
  }
}

TEST(UnlikeEdges, ArePartedAndToldWhereTheyAreNot) {
  // Turned, elsewhere, and longer by half.
  for (TrimmedSurface& wrong :
       std::vector<TrimmedSurface>{square(1, 1), square(2, 2, 0.0, true), square(1, 1, 0.5, true)}) {
    std::vector<TrimmedSurface> faces{square(0, 1), wrong, square(1, 1, 0.0, true)};
    std::vector<surf::mesh::Finding> findings;
    ASSERT_EQ(apart(faces, findings), 1U);
    EXPECT_EQ(findings[0].code, "edge_apart");
    EXPECT_NE(findings[0].message.find("edge 8 ends"), std::string::npos);
    EXPECT_TRUE(findings[0].place.x.has_value());
    const auto shared = [](const TrimmedSurface& face) {
      return std::any_of(face.loops[0].edges.begin(), face.loops[0].edges.end(),
                         [](const ChartEdge& edge) { return edge.shared.has_value(); });
    };
    EXPECT_TRUE(shared(faces[0]));
    EXPECT_FALSE(shared(faces[1]));
    EXPECT_TRUE(shared(faces[2]));
  }
}

}  // namespace
}  // namespace dobra::io::faces
