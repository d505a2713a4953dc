#include "shared/mesh/triangulate.h"

#include <algorithm>

#include "shared/mesh/front_gaps.h"
#include "shared/mesh/planar_domain.h"

// 1. Constrained Delaunay triangulation of the input; outside and holes told apart.
// 2. Quadtree and size field from the edges as they came out of step 1.
// 3. Interior points. 4. Flips and smoothing, in rounds.

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;

namespace {

Result<void> validate(const MeshOptions& options) {
  const auto wrong = [](const char* text) { return Error{ErrorCode::InvalidOption, text}; };
  if (!(options.points.accept > 1.0))
    return wrong("accept must be greater than 1: 1 asks for equilateral triangles only");
  if (!(options.points.least_spacing > 0.0)) return wrong("least_spacing must be greater than 0");
  if (!(options.points.least_wall > 0.0)) return wrong("least_wall must be greater than 0");
  if (options.rounds < 0 || options.smoothing.passes < 0) return wrong("rounds and passes must not be negative");
  if (!(options.smoothing.phi >= 0.0 && options.smoothing.phi <= 1.0)) return wrong("phi must lie between 0 and 1");
  return {};
}

std::vector<SizedEdge> sized_edges(const PlanarDomain& domain, const MeshInput& input) {
  std::vector<SizedEdge> edges;
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    const bool boundary = input.sets[input.edges[i].set].kind == EdgeKind::Boundary;
    for (std::size_t k = domain.chain_first[i]; k + 1 < domain.chain_first[i + 1]; ++k) {
      edges.push_back({{domain.kernel.point(domain.chain[k]), domain.kernel.point(domain.chain[k + 1])},
                       boundary ? SizeRole::Boundary : SizeRole::Internal});
    }
  }
  return edges;
}

/// The front, and between what it leaves standing points placed one by one. Should sides of the front cross, again with
/// a front that takes no risk; should they cross even then, points are placed everywhere.
Result<void> fill(DelaunayKernel& kernel, const SizeField& field, const FrontalOptions& options,
                  const Progress& progress) {
  const DelaunayKernel given = kernel;
  for (const Meetings meetings : {Meetings::Join, Meetings::LeaveOpen}) {
    const auto filled = [&]() -> Result<void> {
      DOBRA_TRY(Front front, advance_front(kernel, field, options, meetings, progress.part(0.0, 0.7)));
      return fill_gaps(kernel, front, field, options, progress.part(0.7, 1.0));
    }();
    if (filled || filled.error().code != ErrorCode::SelfIntersection) return filled;
    kernel = given;
  }
  DOBRA_TRY_VOID(place_points(kernel, field, options, progress));
  return {};
}

}  // namespace

Result<SizeField> size_field_of(const MeshInput& input, const SizeFieldOptions& options) {
  DOBRA_TRY(const PlanarDomain domain, build_domain(input, Outside::Remove, {}));
  return SizeField::build(sized_edges(domain, input), input.sizes, options);
}

Result<TriangleMesh> triangulate(const MeshInput& input, const MeshOptions& options, const Progress& progress) {
  DOBRA_TRY_VOID(validate(options));
  DOBRA_TRY(PlanarDomain domain, build_domain(input, Outside::Remove, progress.part(0.0, 0.1)));
  DOBRA_TRY(const SizeField field, SizeField::build(sized_edges(domain, input), input.sizes, options.sizes));
  DOBRA_TRY_VOID(progress.check());
  const std::size_t given = domain.kernel.vertex_count();
  DOBRA_TRY_VOID(fill(domain.kernel, field, options.points, progress.part(0.1, 0.8)));
  // Input points are wanted where they are: they stay, as nodes of the boundary and of constraints do.
  std::vector<std::uint8_t> fixed(domain.kernel.vertex_count(), 0);
  std::fill(fixed.begin(), fixed.begin() + static_cast<std::ptrdiff_t>(given), std::uint8_t{1});
  DOBRA_TRY_VOID(improve(domain.kernel, fixed, options.smoothing, options.rounds, progress.part(0.8, 1.0)));
  return std::move(extract(domain, input).mesh);
}

}  // namespace dobra::mesh
