#include "shared/mesh/front/triangulate.h"

#include <algorithm>

#include "shared/base/check.h"
#include "shared/mesh/delaunay/planar_domain.h"

// 1. Constrained Delaunay triangulation of the input; outside and holes told apart.
// 2. Quadtree and size field from the edges as they came out of step 1.
// 3. Interior nodes, by an engine. 4. Flips and smoothing, in rounds.

namespace dobra::mesh::front {

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

std::vector<sizing::SizedEdge> sized_edges(const delaunay::PlanarDomain& domain, const delaunay::MeshInput& input) {
  std::vector<sizing::SizedEdge> edges;
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    const bool boundary = input.sets[input.edges[i].set].kind == delaunay::EdgeKind::Boundary;
    for (std::size_t k = domain.chain_first[i]; k + 1 < domain.chain_first[i + 1]; ++k) {
      edges.push_back({{domain.kernel.point(domain.chain[k]), domain.kernel.point(domain.chain[k + 1])},
                       boundary ? sizing::SizeRole::Boundary : sizing::SizeRole::Internal});
    }
  }
  return edges;
}

}  // namespace

Result<sizing::SizeField> size_field_of(const delaunay::MeshInput& input, const sizing::SizeFieldOptions& options) {
  DOBRA_TRY(const delaunay::PlanarDomain domain, build_domain(input, delaunay::Outside::Remove, {}));
  return sizing::SizeField::build(sized_edges(domain, input), input.sizes, options);
}

struct Mesher::State {
  delaunay::MeshInput input;
  MeshOptions options;
  delaunay::PlanarDomain domain;
  sizing::SizeField field;
  std::size_t given = 0;  ///< Vertices of the input.
  std::unique_ptr<FillEngine> engine = nullptr;
  Stage stage = Stage::Filling;

  /// Input points are wanted where they are: they stay, as nodes of the boundary and of constraints do.
  Result<void> improve(const Progress& progress) {
    std::vector<std::uint8_t> fixed(domain.kernel.vertex_count(), 0);
    std::fill(fixed.begin(), fixed.begin() + static_cast<std::ptrdiff_t>(given), std::uint8_t{1});
    return front::improve(domain.kernel, fixed, options.smoothing, options.rounds, progress);
  }
};

void Mesher::Destroy::operator()(State* state) const { delete state; }
Mesher::Mesher(std::unique_ptr<State> state) : state_(state.release()) {}

Result<Mesher> Mesher::start(const delaunay::MeshInput& input, const MeshOptions& options, const Progress& progress) {
  DOBRA_TRY_VOID(validate(options));
  DOBRA_TRY(delaunay::PlanarDomain domain, build_domain(input, delaunay::Outside::Remove, progress.part(0.0, 0.1)));
  DOBRA_TRY(sizing::SizeField field, sizing::SizeField::build(sized_edges(domain, input), input.sizes, options.sizes));
  DOBRA_TRY_VOID(progress.check());
  auto state = std::make_unique<State>(State{input, options, std::move(domain), std::move(field)});
  State& s = *state;
  s.given = s.domain.kernel.vertex_count();
  s.engine = make_engine(s.options.engine, s.domain.kernel, s.field, s.options.points);
  return Mesher(std::move(state));
}

Mesher::Stage Mesher::stage() const { return state_->stage; }

const sizing::SizeField& Mesher::sizes() const { return state_->field; }

Result<void> Mesher::step(std::size_t count, const Progress& progress) {
  State& s = *state_;
  DOBRA_CHECK(!done());
  if (s.stage == Stage::Improving) {
    DOBRA_TRY_VOID(s.improve(progress.part(0.8, 1.0)));
    s.stage = Stage::Done;
    return {};
  }
  DOBRA_TRY_VOID(s.engine->step(count, progress.part(0.1, 0.8)));
  if (!s.engine->done()) return {};
  s.engine.reset();
  s.stage = Stage::Improving;
  return {};
}

Mesher::View Mesher::view() const {
  View view;
  const delaunay::DelaunayKernel& kernel = state_->domain.kernel;
  std::vector<NodeId> number(kernel.vertex_count());
  for (delaunay::DelaunayKernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const delaunay::DelaunayKernel::Triangle& cell = kernel.cell(c);
    if (cell.region < 0) continue;
    view.triangles.regions.push_back(cell.region);
    auto& corners = view.triangles.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      NodeId& node = number[cell.vertex[i]];
      if (!node.valid()) {
        node = NodeId(view.triangles.points.size());
        view.triangles.points.push_back(kernel.point(cell.vertex[i]));
      }
      corners[i] = node;
    }
  }
  if (state_->engine) view.front = state_->engine->front();
  return view;
}

TriangleMesh Mesher::mesh() const {
  DOBRA_CHECK(done());
  return std::move(extract(state_->domain, state_->input).mesh);
}

Result<TriangleMesh> triangulate(const delaunay::MeshInput& input, const MeshOptions& options,
                                 const Progress& progress) {
  constexpr std::size_t between_checks = 8192;
  DOBRA_TRY(Mesher mesher, Mesher::start(input, options, progress));
  while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(between_checks, progress));
  return mesher.mesh();
}

}  // namespace dobra::mesh::front
