#include "shared/surf/mesh/chart_mesher.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "shared/base/check.h"
#include "shared/geom/predicates.h"
#include "shared/mesh/delaunay/planar_domain.h"
#include "shared/mesh/front/front_engine.h"
#include "shared/mesh/front/smoother.h"
#include "shared/surf/mesh/chart_space.h"
#include "shared/surf/mesh/tidy.h"
#include "shared/surf/mesh/tips.h"
#include "shared/surf/trim/finding.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Progress;
using base::Result;
using dobra::mesh::delaunay::MeshInput;
using dobra::mesh::delaunay::PlanarDomain;
using dobra::mesh::front::FrontEngine;
using dobra::mesh::front::Mesher;
using Kernel = dobra::mesh::delaunay::DelaunayKernel;

namespace {

Result<void> validate(const ChartInput& input, const ChartMeshOptions& options) {
  const auto wrong = [](const char* text) { return Error{ErrorCode::InvalidOption, text}; };
  if (input.at.size() != input.chart.points.size()) return wrong("each point of the chart needs its place in space");
  for (std::size_t i = 0; i < input.at.size(); ++i) {
    if (geom::is_finite(input.at[i]) && geom::is_finite(input.chart.points[i])) continue;
    return Error{ErrorCode::NotFinite, fmt::format("point {} of the face is not finite", i + 1)};
  }
  const geom::Box box = geom::box_of(input.chart.points);
  if (!(box.width() > 0.0 && box.height() > 0.0))
    return Error{ErrorCode::CannotMesh, "the face has no extent in its chart: give a boundary"};
  if (!(options.points.accept > 1.0))
    return wrong("accept must be greater than 1: 1 asks for equilateral triangles only");
  if (!(options.points.least_spacing > 0.0)) return wrong("least_spacing must be greater than 0");
  if (!(options.points.least_wall > 0.0)) return wrong("least_wall must be greater than 0");
  if (options.rounds < 0 || options.smoothing.passes < 0) return wrong("rounds and passes must not be negative");
  if (!(options.smoothing.phi >= 0.0 && options.smoothing.phi <= 1.0)) return wrong("phi must lie between 0 and 1");
  return {};
}

MeshInput scaled(const MeshInput& input, const ScaledChart& chart) {
  MeshInput made = input;
  for (geom::Point& p : made.points) p = chart.scaled(p);
  for (auto& region : made.regions) region.at = chart.scaled(region.at);
  for (geom::Point& p : made.holes) p = chart.scaled(p);
  for (auto& request : made.sizes) request.at = chart.scaled(request.at);
  return made;
}

bool is_on_kink(const Surface& surface, geom::Point uv) {
  constexpr double rounding = 1e-12;  // of the chart
  const geom::Box& chart = surface.chart();
  const auto on = [](const std::vector<double>& lines, double at, double near) {
    if (lines.size() <= 2) return false;  // the ends of the chart
    const auto above = std::lower_bound(lines.begin() + 1, lines.end() - 1, at - near);
    return above != lines.end() - 1 && *above <= at + near;
  };
  return on(surface.kinks().u, uv.x, rounding * chart.width()) ||
         on(surface.kinks().v, uv.y, rounding * chart.height());
}

/// Errors of the plane's triangulation say places of the scaled chart.
Error unscaled(Error error, const ScaledChart& chart) {
  if (!error.place || !error.place->x || !error.place->y) return error;
  const geom::Point uv = chart.unscaled({*error.place->x, *error.place->y});
  error.place->x = uv.x;
  error.place->y = uv.y;
  return error;
}

}  // namespace

struct ChartMesher::State {
  ChartInput input;
  ChartMeshOptions options;
  std::vector<Tip> tips;
  ScaledChart chart;
  MeshInput scaled_input;
  PlanarDomain domain;
  ChartSpace space;
  std::optional<ChartSizes> sizes;
  std::size_t given = 0;  ///< Vertices of the input.
  std::unique_ptr<FrontEngine<ChartSpace>> engine = nullptr;
  Stage stage = Stage::Filling;

  Result<void> prepare(const Progress& progress);
  /// With the place where sizes are least.
  [[nodiscard]] Error too_many() const {
    const auto& tree = sizes->field.quadtree();
    double least = std::numeric_limits<double>::infinity();
    geom::Point at = geom::box_of(scaled_input.points).centre();
    for (const auto leaf : tree.leaves()) {
      if (!(sizes->triangles[leaf.index()] != 0.0)) continue;
      const auto corners = sizes->field.corner_sizes(leaf);
      const double size = *std::min_element(corners.begin(), corners.end());
      if (size >= least) continue;
      least = size;
      at = tree.box(leaf).centre();
    }
    return {ErrorCode::TooManyElements,
            fmt::format("the mesh would have more than {} triangles, the least of them here: use a greater size, turn "
                        "or growth, trim this part of the surface away, or raise the limit",
                        options.points.max_triangles),
            trim::place_of(input.surface, chart.held(at))};
  }
  Result<void> improve(const Progress& progress) {
    std::vector<std::uint8_t> fixed(domain.kernel.vertex_count(), 0);
    std::fill(fixed.begin(), fixed.begin() + static_cast<std::ptrdiff_t>(given), fixed_node);
    const std::size_t triangles = domain.kernel.cell_count();
    const bool large = triangles > options.large;
    const int before = std::min(options.rounds, large ? 1 : 2);
    const int after = large ? before : options.rounds + (options.rounds > 0 && triangles < options.few ? 1 : 0);
    // Nodes need not be quite where they belong before sides are flipped.
    dobra::mesh::front::SmoothOptions rough = options.smoothing;
    rough.least_step *= 2.0;
    DOBRA_TRY_VOID(dobra::mesh::front::improve(domain.kernel, space, fixed, rough, before, progress.part(0.0, 0.5)));
    DOBRA_TRY(auto changed, unfold(domain.kernel, space, options.unfold, progress));
    DOBRA_TRY(const auto flipped, tidy(domain.kernel, space, fixed, options.tidy, progress.part(0.5, 0.8)));
    changed.insert(changed.end(), flipped.begin(), flipped.end());
    const auto& last = large ? rough : options.smoothing;
    DOBRA_TRY_VOID(dobra::mesh::front::improve(domain.kernel, space, resting_but(changed, fixed), last, after,
                                               progress.part(0.8, 0.95)));
    DOBRA_TRY(const auto unfolded, unfold(domain.kernel, space, options.unfold, progress));
    if (unfolded.empty()) return {};
    return dobra::mesh::front::improve(domain.kernel, space, resting_but(unfolded, fixed), options.smoothing,
                                       options.rounds, progress.part(0.95, 1.0));
  }
  static constexpr std::uint8_t fixed_node = 1;
  /// All nodes rest but these and the fixed ones.
  [[nodiscard]] static std::vector<std::uint8_t> resting_but(std::span<const Kernel::Vertex> these,
                                                             const std::vector<std::uint8_t>& fixed) {
    constexpr std::uint8_t resting = 2;
    std::vector<std::uint8_t> flags(fixed.size(), resting);
    for (const Kernel::Vertex v : these) flags[v] = 0;
    for (std::size_t v = 0; v < fixed.size(); ++v) flags[v] = fixed[v] == fixed_node ? fixed_node : flags[v];
    return flags;
  }
};

Result<void> ChartMesher::State::prepare(const Progress& progress) {
  chart = ScaledChart(input.surface, geom::box_of(input.chart.points));
  scaled_input = scaled(input.chart, chart);
  auto built = build_domain(scaled_input, dobra::mesh::delaunay::Outside::Remove, progress.part(0.0, 0.5));
  if (!built) return unscaled(built.error(), chart);
  domain = std::move(*built);
  Kernel& kernel = domain.kernel;
  given = kernel.vertex_count();
  std::vector<geom::Point3> at(given);
  std::vector<std::uint8_t> on_kink(given, 0);
  for (std::size_t p = 0; p < input.at.size(); ++p) {
    at[domain.vertex_of_point[p]] = input.at[p];
    on_kink[domain.vertex_of_point[p]] = is_on_kink(input.surface, input.chart.points[p]) ? 1 : 0;
  }
  std::vector<GivenSide> sides;
  for (std::size_t i = 0; i < input.chart.edges.size(); ++i) {
    for (std::size_t k = domain.chain_first[i]; k + 1 < domain.chain_first[i + 1]; ++k) {
      const Kernel::Vertex a = domain.chain[k], b = domain.chain[k + 1];
      sides.push_back({{kernel.point(a), kernel.point(b)}, geom::distance(at[a], at[b])});
    }
  }
  DOBRA_TRY(ChartSizes found,
            chart_sizes(chart, sides, scaled_input.sizes, tips, options.sizes, progress.part(0.5, 1.0)));
  sizes = std::move(found);
  space = ChartSpace(chart, *sizes, kernel);
  for (Kernel::Vertex v = 0; v < given; ++v) space.enter(v, at[v], on_kink[v] != 0);
  constexpr double doubtful = 1.25;
  // Nor where a size is no number.
  if (!(space.expected_triangles() <= doubtful * static_cast<double>(options.points.max_triangles))) return too_many();
  space.rule();
  return {};
}

void ChartMesher::Destroy::operator()(State* state) const { delete state; }
ChartMesher::ChartMesher(std::unique_ptr<State> state) : state_(state.release()) {}

Result<ChartMesher> ChartMesher::start(const ChartInput& input, const ChartMeshOptions& options,
                                       const Progress& progress) {
  DOBRA_TRY_VOID(validate(input, options));
  Tips tips = with_wheels(input, options.sizes, largest_size(input.surface, options.sizes));
  auto state = std::make_unique<State>(State{std::move(tips.input), options, std::move(tips.tips), {}, {}, {}, {}, {}});
  State& s = *state;
  DOBRA_TRY_VOID(s.prepare(progress.part(0.0, 0.1)));
  s.engine = std::make_unique<FrontEngine<ChartSpace>>(s.domain.kernel, s.space, s.sizes->field, s.options.points);
  return ChartMesher(std::move(state));
}

ChartMesher::Stage ChartMesher::stage() const { return state_->stage; }

double ChartMesher::size_at(geom::Point uv) const { return state_->sizes->field.size_at(state_->chart.scaled(uv)); }

Result<void> ChartMesher::step(std::size_t count, const Progress& progress) {
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

Mesher::View ChartMesher::view() const {
  Mesher::View view;
  const State& s = *state_;
  const Kernel& kernel = s.domain.kernel;
  std::vector<NodeId> number(kernel.vertex_count());
  for (Kernel::Cell c = 0; c < kernel.cell_count(); ++c) {
    const Kernel::Triangle& cell = kernel.cell(c);
    if (cell.region < 0) continue;
    view.triangles.regions.push_back(cell.region);
    auto& corners = view.triangles.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      NodeId& node = number[cell.vertex[i]];
      if (!node.valid()) {
        node = NodeId(view.triangles.points.size());
        view.triangles.points.push_back(s.chart.unscaled(kernel.point(cell.vertex[i])));
      }
      corners[i] = node;
    }
  }
  if (s.engine) {
    for (const geom::Segment& side : s.engine->front())
      view.front.push_back({s.chart.unscaled(side.from), s.chart.unscaled(side.to)});
  }
  return view;
}

FaceMesh ChartMesher::mesh() const {
  DOBRA_CHECK(done());
  const State& s = *state_;
  auto extracted = dobra::mesh::delaunay::extract(s.domain, s.scaled_input);
  FaceMesh made{std::move(extracted.mesh), {}};
  made.at.resize(made.chart.points.size());
  for (Kernel::Vertex v = 0; v < s.domain.kernel.vertex_count(); ++v) {
    const NodeId node = extracted.node_of_vertex[v];
    if (!node.valid()) continue;
    made.at[node.index()] = s.space.at(v);
    made.chart.points[node.index()] = s.chart.unscaled(s.domain.kernel.point(v));
  }
  for (std::size_t p = 0; p < s.input.at.size(); ++p) {
    const NodeId node = extracted.node_of_point[p];
    if (node.valid()) made.chart.points[node.index()] = s.input.chart.points[p];
  }
  return made;
}

namespace {

/// Triangles that look against the surface at their middle or are far longer than asked, with the first of them, and
/// those that are nearly flat though no sharp corner makes them so: with an angle beyond 120 degrees.
struct Faults {
  std::size_t folded = 0, stray = 0, flat = 0;
  geom::Point first;
  [[nodiscard]] std::size_t grave() const { return folded + stray; }
};

/// @param largest  the size asked for, m
Faults faults_of(const FaceMesh& face, const Surface& surface, double largest) {
  constexpr double far_longer = 4.0;
  constexpr double none = 1e-9;     // of the sides: where two corners are one node at a pole there is no area
  constexpr double flattest = 0.1;  // alpha
  Faults faults;
  for (const auto& corners : face.chart.triangles) {
    const auto at = [&](std::size_t i) { return face.at[corners[i].index()]; };
    const auto place = [&](std::size_t i) { return face.chart.points[corners[i].index()] - geom::Point{}; };
    const geom::Vector3 u = at(1) - at(0), v = at(2) - at(0), w = at(2) - at(1);
    const geom::Vector3 area = cross(u, v);
    const std::array<double, 3> squares{dot(u, u), dot(v, v), dot(w, w)};
    const double longest = *std::max_element(squares.begin(), squares.end());
    const double sum = squares[0] + squares[1] + squares[2];
    const geom::Point middle = geom::Point{} + (place(0) + place(1) + place(2)) / 3.0;
    // Rounding from the scaled chart to that of the surface may turn a sliver round.
    const auto in_chart = [&](std::size_t i) { return face.chart.points[corners[i].index()]; };
    if (geom::orient2d(in_chart(0), in_chart(1), in_chart(2)) != geom::Sign::Positive) {
      if (faults.folded++ + faults.stray == 0) faults.first = middle;
      continue;
    }
    if (longest > far_longer * far_longer * largest * largest && faults.stray++ + faults.folded == 0)
      faults.first = middle;
    if (length(area) <= none * longest) continue;
    // Beyond 120 degrees: a^2 > b^2 + c^2 + b c, and b c is (b^2 + c^2) / 2 at most.
    const bool obtuse = longest > 1.5 * (sum - longest);
    if (obtuse && 2.0 * std::numbers::sqrt3 * length(area) < flattest * sum) ++faults.flat;
    const auto normal = surf::normal(surface, middle);
    if (!normal || dot(*normal, area) >= 0.0) continue;
    if (faults.folded++ + faults.stray == 0) faults.first = middle;
  }
  return faults;
}

}  // namespace

Result<FaceMesh> mesh_chart(const ChartInput& input, const ChartMeshOptions& options, const Progress& progress) {
  constexpr std::size_t between_checks = 8192;
  ChartMeshOptions own = options;
  own.sizes.largest = largest_size(input.surface, options.sizes);
  double largest = own.sizes.largest;  // or a side that was given
  for (const auto& edge : input.chart.edges)
    largest = std::max(largest, geom::distance(input.at[edge.nodes[0].index()], input.at[edge.nodes[1].index()]));
  std::optional<FaceMesh> best;
  Faults fewest, before;
  int alike = 0;  // attempts that folded where the one before did
  for (int attempt = 0; attempt <= options.attempts || (best && fewest.grave() > 0 && attempt <= options.unfolding);
       ++attempt) {
    DOBRA_TRY(ChartMesher mesher, ChartMesher::start(input, own, progress));
    while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(between_checks, progress));
    FaceMesh made = mesher.mesh();
    const Faults faults = faults_of(made, input.surface, largest);
    alike = faults.grave() > 0 && faults.grave() == before.grave() && faults.first == before.first ? alike + 1 : 0;
    before = faults;
    if (!best || std::pair(faults.grave(), faults.flat) < std::pair(fewest.grave(), fewest.flat)) {
      best = std::move(made);
      fewest = faults;
    }
    const bool large = best->chart.triangles.size() > options.large;
    if (fewest.grave() == 0 && (fewest.flat == 0 || large)) break;
    const bool sideways = std::isfinite(size_by_chart(input.surface.jet(faults.first), own.sizes));
    if ((fewest.grave() > options.hopeless && !sideways) || alike >= options.alike) break;
    own.sizes.sideways *= options.less_sideways;
    own.sizes.largest *= options.smaller;
    own.sizes.turn *= options.smaller;
  }
  if (fewest.grave() == 0 || options.keep_folds) return *std::move(best);
  const geom::Point3 p = input.surface.at(fewest.first);
  return Error{ErrorCode::CannotMesh,
               fewest.folded > 0 ? "the mesh folds over itself here: use another size, smaller ones, or a smaller turn"
                                 : "a triangle here is far longer than the size asked for: use another size",
               base::Place{.x = p.x, .y = p.y, .z = p.z, .u = fewest.first.x, .v = fewest.first.y}};
}

}  // namespace dobra::surf::mesh
