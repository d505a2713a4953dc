#include "shared/mesh/front_gaps.h"

#include <gtest/gtest.h>

#include "shared/mesh/mesh_check.h"
#include "shared/mesh/planar_domain.h"
#include "shared/mesh/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh {
namespace {

using Kernel = DelaunayKernel;

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

TEST(FrontGaps, AWholeDomainIsAGapThatCanBeFilled) {
  const MeshInput input = test::que_d();
  PlanarDomain domain = build_domain(input, Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  const SizeField field = size_field_of(input).value();
  ASSERT_TRUE(fill_gaps(domain.kernel, front, field, {}, {}));
  const TriangleMesh mesh = extract(domain, input).mesh;
  const auto valid = check(mesh);
  EXPECT_TRUE(valid) << to_string(valid.error());
  EXPECT_GT(mesh.triangles.size(), 150U);
  EXPECT_NEAR(area(mesh), test::quarter_plate_area(24), 1e-12);
}

TEST(FrontGaps, SidesThatCrossAreSaidToCross) {
  const MeshInput input = test::square(1.0, 4);
  PlanarDomain domain = build_domain(input, Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  const SizeField field = size_field_of(input).value();
  // A node of the front that got across the boundary.
  domain.kernel.move(domain.vertex_of_point[2], {0.5, 1.5});
  const auto filled = fill_gaps(domain.kernel, front, field, {}, {});
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, base::ErrorCode::SelfIntersection);
}

TEST(FrontGaps, SidesThatEncloseNothingAreRefused) {
  const MeshInput input = test::square(1.0, 4);
  PlanarDomain domain = build_domain(input, Outside::Remove, {}).value();
  Front front = whole_gap(domain.kernel);
  const SizeField field = size_field_of(input).value();
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
  const auto filled = fill_gaps(domain.kernel, front, field, {}, {});
  ASSERT_FALSE(filled);
  EXPECT_EQ(filled.error().code, base::ErrorCode::SelfIntersection);
}

}  // namespace
}  // namespace dobra::mesh
