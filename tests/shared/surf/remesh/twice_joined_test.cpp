#include "shared/surf/remesh/twice_joined.h"

#include <gtest/gtest.h>

#include <map>
#include <numbers>
#include <set>

namespace dobra::surf::remesh {
namespace {

using dobra::mesh::NodeId;
using geom::Point;

/// A tube, open below and above, of three sides around, whose chart is cut along one line of it and filled with a fan.
struct Tube {
  mesh::Division division;
  std::vector<mesh::FaceMesh> faces{1};
  std::vector<trim::TrimmedSurface> surfaces;

  Tube() {
    constexpr double third = 2.0 * std::numbers::pi / 3.0;
    surfaces.push_back({*Surface::cylinder({}, 1.0, {{0.0, 0.0}, {3.0 * third, 1.0}})});
    mesh::ChartInput input{surfaces[0].surface, {}, {}, {0, 1, 2, 0, 3, 4, 5, 3}};
    for (int k = 0; k < 4; ++k) input.chart.points.emplace_back(third * k, 0.0);
    for (int k = 3; k >= 0; --k) input.chart.points.emplace_back(third * k, 1.0);
    dobra::mesh::TriangleMesh& chart = faces[0].chart;
    chart.points = input.chart.points;
    chart.points.emplace_back(1.5 * third, 0.5);
    for (std::size_t k = 0; k < 8; ++k) {
      input.chart.edges.push_back({{NodeId(k), NodeId((k + 1) % 8)}, 0});
      chart.triangles.push_back({NodeId(k), NodeId((k + 1) % 8), NodeId(8)});
    }
    chart.regions.assign(8, 0);
    for (const Point uv : chart.points) faces[0].at.push_back(surfaces[0].surface.at(uv));
    faces[0].at[3] = faces[0].at[0], faces[0].at[4] = faces[0].at[7];
    input.at.assign(faces[0].at.begin(), faces[0].at.end() - 1);
    division.faces.push_back(input);
    division.nodes = 6;
  }

  /// By sides: the triangles at it.
  [[nodiscard]] std::map<std::set<std::size_t>, int> sides() const {
    std::map<std::set<std::size_t>, int> count;
    const auto joined = mesh::join(surfaces, division, faces);
    EXPECT_TRUE(joined) << joined.error().message;
    for (const auto& t : joined->triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++count[{t[i].index(), t[(i + 1) % 3].index()}];
    }
    return count;
  }
};

int most(const std::map<std::set<std::size_t>, int>& sides) {
  int most = 0;
  for (const auto& [side, count] : sides) most = std::max(most, count);
  return most;
}

TEST(TwiceJoined, ANodeInsideThatIsJoinedWithBothBanksOfACutGetsSidesOfItsOwn) {
  Tube tube;
  ASSERT_EQ(most(tube.sides()), 4);  // of the node inside and the cut
  part_twice_joined(tube.faces, tube.division, tube.surfaces);
  const auto sides = tube.sides();
  EXPECT_EQ(most(sides), 2);
  std::set<std::size_t> nodes;
  std::size_t border = 0;
  for (const auto& [side, count] : sides) {
    nodes.insert(side.begin(), side.end());
    border += count == 1 ? 1U : 0U;
  }
  EXPECT_EQ(border, 6U);
  EXPECT_EQ(nodes.size() + mesh::join(tube.surfaces, tube.division, tube.faces)->triangles.size(),
            sides.size());  // a tube
}

}  // namespace
}  // namespace dobra::surf::remesh
