#include "shared/mesh/front/front_gaps.h"

#include <gtest/gtest.h>

#include "shared/geom/predicates.h"
#include "shared/mesh/delaunay/planar_domain.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/mesh_check.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

using geom::Point;
using Kernel = delaunay::DelaunayKernel;

/// A front that has not begun: the boundary of `input`, all of it a gap.
Front whole_gap(Kernel& kernel) {
  Front front;
  std::map<Kernel::Vertex, std::uint32_t> starting_at;
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    if (kernel.cell(c).region < 0) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      if (kernel.mark(e) == 0) continue;
      starting_at[kernel.origin(e)] = static_cast<std::uint32_t>(front.sides.size());
      FrontSide side;
      side.from = kernel.origin(e);
      side.next = kernel.target(e);  // A vertex for now.
      side.back = kernel.twin(e);
      side.mark = kernel.mark(e);
      front.sides.push_back(side);
    }
  }
  for (FrontSide& side : front.sides) side.next = starting_at.at(side.next);
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    if (kernel.cell(c).region >= 0) kernel.set_region(c, replaced_region);
  }
  return front;
}

base::Result<void> fill(Kernel& kernel, Front& front, const delaunay::MeshInput& input) {
  const sizing::SizeField field = size_field_of(input).value();
  const FrontalOptions options;
  return test::run_to_end(*gap_filler(kernel, front, field, options), {});
}

TEST(FrontGaps, AWholeDomainIsAGapThatCanBeFilled) {
  const delaunay::MeshInput input = test::que_d();
  delaunay::PlanarDomain domain = build_domain(input, delaunay::Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  ASSERT_TRUE(fill(domain.kernel, front, input));
  const TriangleMesh mesh = extract(domain, input).mesh;
  const auto valid = check(mesh);
  EXPECT_TRUE(valid) << to_string(valid.error());
  EXPECT_GT(mesh.triangles.size(), 150U);
  EXPECT_NEAR(area(mesh), test::quarter_plate_area(24), 1e-12);
}

TEST(FrontGaps, SidesThatCrossAreSaidToCross) {
  const delaunay::MeshInput input = test::square(1.0, 4);
  delaunay::PlanarDomain domain = build_domain(input, delaunay::Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  // A node of the front that got across the boundary.
  domain.kernel.move(domain.vertex_of_point[2], {0.5, 1.5});
  const auto filled = fill(domain.kernel, front, input);
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, base::ErrorCode::SelfIntersection);
}

bool all_anticlockwise(const Kernel& kernel) {
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const auto& [a, b, d] = kernel.cell(c).vertex;
    if (kernel.cell(c).region < 0) continue;
    if (geom::orient2d(kernel.point(a), kernel.point(b), kernel.point(d)) != geom::Sign::Positive) return false;
  }
  return true;
}

TEST(FrontGaps, WhereSidesOfTheFrontCrossOnlyTheTrianglesBehindThemAreMadeAgain) {
  const delaunay::MeshInput input = test::uniform_plate(3000);
  const sizing::SizeField field = size_field_of(input).value();
  const FrontalOptions options;
  std::size_t crossed = 0;
  for (std::size_t k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    delaunay::PlanarDomain domain = build_domain(input, delaunay::Outside::Remove, {}).value();
    Kernel& kernel = domain.kernel;
    const std::size_t given = kernel.vertex_count();
    Front front;
    ASSERT_TRUE(test::run_to_end(*advancing_front(kernel, field, options, front)));
    // A node that got across the front, as far as its triangles stay anticlockwise.
    std::vector<const FrontSide*> standing;
    for (const FrontSide& side : front.sides) {
      if (side.from != FrontSide::free && side.from >= given) standing.push_back(&side);
    }
    ASSERT_FALSE(standing.empty());
    const FrontSide& side = *standing[k * standing.size() / 40];
    const Kernel::Vertex moved = side.from;
    const Point from = kernel.point(moved);
    const geom::Vector into_gap =
        geom::left_of(kernel.point(front.to(side)) - kernel.point(front.sides[side.previous].from));
    for (double reach = 6.0; reach > 0.1; reach *= 0.8) {
      kernel.move(moved, from + reach * into_gap);
      if (all_anticlockwise(kernel)) break;
    }
    const std::size_t triangles = kernel.cell_count();
    ASSERT_TRUE(test::run_to_end(*gap_filler(kernel, front, field, options)));
    const TriangleMesh mesh = extract(domain, input).mesh;
    const auto valid = check(mesh);
    EXPECT_TRUE(valid) << to_string(valid.error());
    const double wanted = test::boundary_area(mesh);
    EXPECT_NEAR(area(mesh), wanted, 1e-12 * wanted);
    EXPECT_GT(mesh.triangles.size(), triangles / 2);
    crossed += std::find(mesh.points.begin(), mesh.points.end(), kernel.point(moved)) == mesh.points.end() ? 1U : 0U;
  }
  EXPECT_GE(crossed, 15U) << "the front is hardly ever made to cross: the test says nothing";
}

TEST(FrontGaps, SidesThatEncloseNothingAreRefused) {
  const delaunay::MeshInput input = test::square(1.0, 4);
  delaunay::PlanarDomain domain = build_domain(input, delaunay::Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  // The loop the other way round: its left is the outside.
  std::vector<FrontSide> turned;
  for (const FrontSide& side : front.sides) {
    FrontSide back = side;
    back.from = front.to(side);
    back.next = static_cast<std::uint32_t>(std::find_if(front.sides.begin(), front.sides.end(),
                                                        [&](const FrontSide& s) { return front.to(s) == side.from; }) -
                                           front.sides.begin());
    turned.push_back(back);
  }
  front.sides = turned;
  const auto filled = fill(domain.kernel, front, input);
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, base::ErrorCode::SelfIntersection);
}

}  // namespace
}  // namespace dobra::mesh::front
