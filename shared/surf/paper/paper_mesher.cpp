#include "shared/surf/paper/paper_mesher.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/quality.h"
#include "shared/surf/closest.h"
#include "shared/surf/paper/paper_front.h"
#include "shared/surf/paper/paper_smooth.h"

namespace dobra::surf::paper {

using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::mesh::Edge;
using dobra::mesh::NodeId;
using dobra::mesh::TriangleMesh;
using geom::Point;
using geom::Point3;
using geom::Vector;
using geom::Vector3;

using Corner = PaperFront::Corner;
using SegmentIndex = PaperFront::SegmentIndex;

namespace {

/// The border, triangulated without a new node: it says what is inside, which regions there are and what is wrong.
Result<TriangleMesh> triangulated_border(const mesh::ChartInput& input, const base::Progress& progress) {
  using namespace dobra::mesh::delaunay;
  auto made = constrained_delaunay(input.chart, Outside::Remove, progress);
  if (!made) {
    Error error = made.error();
    if (error.place && error.place->x && error.place->y) {
      error.place->u = error.place->x;
      error.place->v = error.place->y;
      const Point3 at = input.surface.at({*error.place->u, *error.place->v});
      error.place->x = at.x;
      error.place->y = at.y;
      error.place->z = at.z;
    }
    return error;
  }
  for (std::size_t i = 0; i < made->node_of_point.size(); ++i) {
    if (made->node_of_point[i] == NodeId(i)) continue;
    const Point uv = input.chart.points[i];
    const Point3 at = input.at[i];
    return Error{ErrorCode::CannotMesh, "two points of the chart are the same, or one lies outside",
                 base::Place{.x = at.x, .y = at.y, .z = at.z, .u = uv.x, .v = uv.y}};
  }
  return std::move(made->mesh);
}

Result<void> check_options(const PaperOptions& options) {
  const auto refuse = [](std::string what) { return Error{ErrorCode::InvalidOption, std::move(what)}; };
  if (!(options.phi >= 0.0 && options.phi <= 1.0)) {
    return refuse(fmt::format("phi must be from 0 to 1 and is {}", options.phi));
  }
  if (!(options.largest >= 0.0)) {
    return refuse(fmt::format("the largest size must not be negative and is {}", options.largest));
  }
  if (!(options.least_distance >= 0.0)) {
    return refuse(
        fmt::format("the least distance of a new node must not be negative and is {}", options.least_distance));
  }
  if (!(options.height > 0.0)) {
    return refuse(fmt::format("the height of the ideal triangle must be positive and is {}", options.height));
  }
  if (!(options.sphere > 0.0)) {
    return refuse(fmt::format("the radius of the sphere must be positive and is {}", options.sphere));
  }
  return {};
}

/// L where none is given: the longest side of the border.
double longest_side(const mesh::ChartInput& input) {
  double longest = 0.0;
  for (const auto& edge : input.chart.edges) {
    longest = std::max(longest, distance(input.at[edge.nodes[0].index()], input.at[edge.nodes[1].index()]));
  }
  return longest;
}

/// The place of the surface next to a point, by Newton from a place near it; `closest` where that does not settle.
Foot foot_near(const Surface& surface, Point3 point, Point near) {
  const geom::Box& chart = surface.chart();
  Point uv = near;
  const double enough = 1e-10 * surface.size();
  constexpr int most = 8;
  for (int i = 0; i < most; ++i) {
    const Jet jet = surface.jet(uv);
    const Vector3 to = point - jet.at;
    const double a = dot(jet.u, jet.u) - dot(to, jet.uu), b = dot(jet.u, jet.v) - dot(to, jet.uv);
    const double c = dot(jet.v, jet.v) - dot(to, jet.vv);
    const double along_u = dot(to, jet.u), along_v = dot(to, jet.v);
    const double determinant = a * c - b * b;
    if (!(a > 0.0 && determinant > 0.0)) break;
    const Vector step{(c * along_u - b * along_v) / determinant, (a * along_v - b * along_u) / determinant};
    uv = {std::clamp(uv.x + step.x, chart.low.x, chart.high.x), std::clamp(uv.y + step.y, chart.low.y, chart.high.y)};
    if (geom::length(step.x * jet.u + step.y * jet.v) > enough) continue;
    const Point3 at = surface.at(uv);
    return {uv, at, distance(at, point)};
  }
  return closest(surface, point, near);
}

}  // namespace

// ---- steps i to xvi

struct PaperMesher::State {
  State(const mesh::ChartInput& given, const PaperOptions& wanted, ChartQuadtree quadtree)
      : input(given), options(wanted), tree(std::move(quadtree)), front(tree) {}

  /// What is done while no level makes progress.
  enum class Ease : std::uint8_t { None, NoDistance, Closing };

  mesh::ChartInput input;
  PaperOptions options;
  ChartQuadtree tree;
  PaperFront front;
  TriangleMesh border;
  std::vector<Made> made;
  std::vector<std::int32_t> regions;
  Stage stage = Stage::Front;
  Ease ease = Ease::None;
  std::uint32_t level = 0;
  bool progressed = false;
  std::size_t free_nodes = 0;  ///< New nodes that Ease::NoDistance may still make.
  int pass = 0;
  mesh::FaceMesh face;
  std::vector<std::uint8_t> fixed;

  /// Active segments, the shortest first; those that are gone since are passed over.
  using Waiting = std::pair<double, SegmentIndex>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> shortest;
  std::vector<std::uint32_t> found;

  void begin();
  void activate();
  SegmentIndex shortest_active();
  bool use(SegmentIndex segment);
  bool close(SegmentIndex segment, Point middle, double size);
  bool close_corner(SegmentIndex segment, double size);
  bool halve_corner(SegmentIndex segment, const PaperFront::Neighbour& neighbour, bool at_start, double size);
  std::optional<Corner> ideal(const Segment& segment, double size) const;
  bool to_best(SegmentIndex segment, const std::vector<std::uint32_t>& nodes, Rule rule);
  void make(SegmentIndex segment, const Corner& corner, Rule rule);
  Result<void> next_level();
  void finish_front();
  [[nodiscard]] double least_distance(double size) const {
    return ease == Ease::None ? options.least_distance * size : 0.0;
  }
  [[nodiscard]] Vector reach(Point uv, double length) const {
    constexpr double bend = 1.5;  // of the metric on the way
    return bend * reach_of(input.surface, uv, length);
  }
};

/// The sides of loops, and both sides of lines inside.
void PaperMesher::State::begin() {
  std::vector<std::uint8_t> used(input.at.size(), 0);
  for (const auto& edge : input.chart.edges) used[edge.nodes[0].index()] = used[edge.nodes[1].index()] = 1;
  for (std::uint32_t n = 0; n < input.at.size(); ++n) {
    front.add_node(input.chart.points[n], input.at[n], used[n] == 0);
  }
  std::vector<Edge> lines;
  for (const auto& [name, edges] : border.constraint_sets) lines.insert(lines.end(), edges.begin(), edges.end());
  std::vector<Edge> wanted = dobra::mesh::boundary_edges(border);
  for (const Edge& edge : lines) {
    wanted.push_back(edge);
    wanted.push_back({edge[1], edge[0]});
  }
  std::unordered_map<std::uint64_t, std::int32_t> region_of;
  for (std::size_t t = 0; t < border.triangles.size(); ++t) {
    const auto& c = border.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      region_of[(std::uint64_t{c[i].index()} << 32U) | c[(i + 1) % 3].index()] = border.regions[t];
    }
  }
  for (const Edge& edge : wanted) {
    const auto from = static_cast<std::uint32_t>(edge[0].index()), to = static_cast<std::uint32_t>(edge[1].index());
    const auto region = region_of.find((std::uint64_t{from} << 32U) | to);
    if (region == region_of.end() || front.find(from, to) != PaperFront::none) continue;
    front.add_segment(from, to, region->second, 0);
  }
  activate();
}

void PaperMesher::State::activate() {
  for (SegmentIndex s = 0; s < front.segments().size(); ++s) {
    Segment& segment = front.segment(s);
    if (!segment.alive) continue;
    // What is one point in space is the side of a triangle that goes on to it, never its base, but for the last ones.
    segment.active = segment.length > 0.0 || ease == Ease::Closing;
    if (segment.active) shortest.push({segment.length, s});
  }
}

SegmentIndex PaperMesher::State::shortest_active() {
  while (!shortest.empty()) {
    const SegmentIndex s = shortest.top().second;
    if (front.segment(s).active) return s;
    shortest.pop();
  }
  return PaperFront::none;
}

/// Steps iii to xiv for one segment; false if it waits for the next level.
bool PaperMesher::State::use(SegmentIndex index) {
  const Segment segment = front.segment(index);
  const Point middle = geom::midpoint(front.places()[segment.from], front.places()[segment.to]);
  const double size = tree.size_at(middle);
  if (ease == Ease::Closing) return close(index, middle, size);
  if (close_corner(index, size)) return true;
  const std::optional<Corner> apex = ideal(segment, size);
  if (!apex) return false;
  front.near(apex->uv, apex->at, options.sphere * size, reach(apex->uv, size), found);
  if (to_best(index, found, Rule::Node)) return true;
  if (ease == Ease::NoDistance && free_nodes == 0) return false;
  if (!front.valid(segment.from, segment.to, *apex, least_distance(size))) return false;
  if (ease == Ease::NoDistance) --free_nodes;
  make(index, *apex, Rule::NewNode);
  return true;
}

/// To the best node that there is, near ones first. One of all nodes always does: every polygon can be triangulated.
bool PaperMesher::State::close(SegmentIndex index, Point middle, double size) {
  const Segment segment = front.segment(index);
  const Point3 at = front.points()[segment.from];
  const geom::Box& chart = input.surface.chart();
  for (double radius = std::max(size, 2.0 * segment.length);; radius *= 2.0) {
    const Vector wide = reach(middle, radius);
    if (wide.x >= chart.width() && wide.y >= chart.height()) break;
    front.near(middle, at, radius, wide, found);
    if (to_best(index, found, Rule::Closing)) return true;
  }
  return to_best(index, front.nodes(), Rule::Closing);
}

/// Steps iv to vi.
bool PaperMesher::State::close_corner(SegmentIndex index, double size) {
  const Segment segment = front.segment(index);
  const PaperFront::Neighbour before = front.before(index), after = front.after(index);
  const double most = options.corner * std::numbers::pi / 180.0;
  if (std::min(before.angle, after.angle) >= most) return false;
  const bool at_start = before.angle <= after.angle;
  const PaperFront::Neighbour& narrow = at_start ? before : after;
  const Segment& neighbour = front.segment(narrow.segment);
  if (!(neighbour.length > 0.0)) return false;
  const std::uint32_t far = at_start ? neighbour.from : neighbour.to;
  const std::uint32_t own = at_start ? segment.to : segment.from;
  if (distance(front.points()[far], front.points()[own]) > options.mouth * size) {
    return halve_corner(index, narrow, at_start, size);
  }
  const Corner corner = front.corner(far);
  if (!front.valid(segment.from, segment.to, corner, 0.0)) return false;
  make(index, corner, Rule::Corner);
  return true;
}

/// Step vi where the mouth of the corner is wider than H: a node in the middle of it, two triangles.
bool PaperMesher::State::halve_corner(SegmentIndex index, const PaperFront::Neighbour& narrow, bool at_start,
                                      double size) {
  const Segment segment = front.segment(index);
  const Segment neighbour = front.segment(narrow.segment);
  const std::uint32_t far = at_start ? neighbour.from : neighbour.to;
  const std::uint32_t own = at_start ? segment.to : segment.from;
  const Point3 p = front.points()[far], q = front.points()[own];
  const Foot foot =
      foot_near(input.surface, p + 0.5 * (q - p), geom::midpoint(front.places()[far], front.places()[own]));
  Corner middle{foot.uv, foot.at, PaperFront::none};
  bool any = false;
  for (const SegmentIndex base : {index, narrow.segment}) {
    const Segment& s = front.segment(base);
    if (!s.alive || !front.valid(s.from, s.to, middle, least_distance(size))) continue;
    make(base, middle, Rule::Halved);
    middle = front.corner(static_cast<std::uint32_t>(front.places().size() - 1));
    any = true;
  }
  return any;
}

/// Steps vii to x: the place at H over the middle of a segment, on the surface.
std::optional<Corner> PaperMesher::State::ideal(const Segment& segment, double size) const {
  const Point p = front.places()[segment.from], q = front.places()[segment.to];
  const Vector scale = tree.scale();
  const Vector along{scale.x * (q.x - p.x), scale.y * (q.y - p.y)};
  const Vector up = 0.5 * std::numbers::sqrt3 * geom::left_of(along);
  const Point start = geom::midpoint(p, q) + Vector{up.x / scale.x, up.y / scale.y};
  const Point3 a = front.points()[segment.from], b = front.points()[segment.to];
  const Vector3 base = b - a;
  const Point3 middle = a + 0.5 * base;
  const Vector3 rise = input.surface.at(start) - middle;
  const double square = dot(base, base);
  if (!(square > 0.0)) return std::nullopt;
  const Vector3 normal = rise - (dot(rise, base) / square) * base;
  if (!(geom::length(normal) > 0.0)) return std::nullopt;
  const Vector3 v = geom::normalised(normal);
  constexpr double shrink = 0.9;
  constexpr int most = 60;
  double height = options.height * size;
  Point near = start;
  for (int i = 0; i < most; ++i, height *= shrink) {
    const Foot foot = foot_near(input.surface, middle + height * v, near);
    near = foot.uv;
    if (distance(foot.at, middle) <= height * (1.0 + options.excess)) return Corner{foot.uv, foot.at, PaperFront::none};
  }
  return std::nullopt;
}

/// The node of best alpha whose triangle is valid.
bool PaperMesher::State::to_best(SegmentIndex index, const std::vector<std::uint32_t>& nodes, Rule rule) {
  const Segment segment = front.segment(index);
  std::vector<std::pair<double, std::uint32_t>> ranked;
  for (const std::uint32_t n : nodes) {
    if (n == segment.from || n == segment.to) continue;
    ranked.emplace_back(
        -dobra::mesh::alpha_in_space(front.points()[segment.from], front.points()[segment.to], front.points()[n]), n);
  }
  std::sort(ranked.begin(), ranked.end());
  for (const auto& [alpha, n] : ranked) {
    if (!front.valid(segment.from, segment.to, front.corner(n), 0.0)) continue;
    make(index, front.corner(n), rule);
    return true;
  }
  return false;
}

/// Step xv.
void PaperMesher::State::make(SegmentIndex index, const Corner& corner, Rule rule) {
  const Segment segment = front.segment(index);
  const std::uint32_t c = corner.node != PaperFront::none ? corner.node : front.add_node(corner.uv, corner.at);
  made.push_back({{segment.from, segment.to, c}, segment.level, level, rule});
  regions.push_back(segment.region);
  front.remove_segment(index);
  for (const auto& [from, to] : {std::pair{segment.to, c}, std::pair{c, segment.from}}) {
    const SegmentIndex closed = front.find(from, to);
    if (closed != PaperFront::none) {
      front.remove_segment(closed);
    } else {
      front.add_segment(to, from, segment.region, level + 1);
    }
  }
  progressed = true;
}

/// Step xvi, and what is done when a whole level made nothing.
Result<void> PaperMesher::State::next_level() {
  if (front.alive() == 0) {
    finish_front();
    return {};
  }
  if (!progressed) {
    if (ease == Ease::Closing) {
      const auto rest =
          std::find_if(front.segments().begin(), front.segments().end(), [](const Segment& s) { return s.alive; });
      const Point uv = front.places()[rest->from];
      const Point3 at = front.points()[rest->from];
      return Error{ErrorCode::CannotMesh, "the front cannot be closed here",
                   base::Place{.x = at.x, .y = at.y, .z = at.z, .u = uv.x, .v = uv.y}};
    }
    ease = ease == Ease::None ? Ease::NoDistance : Ease::Closing;
    free_nodes = front.alive();
  }
  progressed = false;
  ++level;
  activate();
  return {};
}

void PaperMesher::State::finish_front() {
  face.chart.points = front.places();
  face.at = front.points();
  for (const Made& m : made) {
    face.chart.triangles.push_back({NodeId(m.triangle[0]), NodeId(m.triangle[1]), NodeId(m.triangle[2])});
  }
  face.chart.regions = regions;
  face.chart.boundary_sets = border.boundary_sets;
  face.chart.constraint_sets = border.constraint_sets;
  face.chart.node_sets = border.node_sets;
  fixed.assign(face.at.size(), 0);
  std::fill(fixed.begin(), fixed.begin() + static_cast<std::ptrdiff_t>(input.at.size()), 1);
  stage = options.passes > 0 ? Stage::Smoothing : Stage::Done;
}

// ---- the mesher

PaperOptions as_printed(PaperOptions options) {
  options.height = options.sphere = options.mouth = 1.0;
  return options;
}

void PaperMesher::Destroy::operator()(State* state) const { delete state; }

Result<PaperMesher> PaperMesher::start(const mesh::ChartInput& input, const PaperOptions& options,
                                       const base::Progress& progress) {
  DOBRA_TRY_VOID(check_options(options));
  DOBRA_TRY(TriangleMesh border, triangulated_border(input, progress));
  const QuadtreeOptions tree_options{.largest = options.largest > 0.0 ? options.largest : longest_side(input),
                                     .turn = options.turn};
  DOBRA_TRY(ChartQuadtree tree, ChartQuadtree::build(input, tree_options, progress));
  std::unique_ptr<State, Destroy> state(new State(input, options, std::move(tree)));
  state->border = std::move(border);
  state->begin();
  return PaperMesher(std::move(state));
}

Result<void> PaperMesher::step(std::size_t count, const base::Progress& progress) {
  State& s = *state_;
  DOBRA_TRY_VOID(progress.check());
  if (s.stage == Stage::Smoothing) {
    smooth_pass(s.input.surface, s.face, s.fixed, s.options.phi, s.tree.scale());
    if (++s.pass == s.options.passes) s.stage = Stage::Done;
    return {};
  }
  const std::size_t until = s.made.size() + count;
  while (s.stage == Stage::Front && s.made.size() < until) {
    const SegmentIndex next = s.shortest_active();
    if (next == PaperFront::none) {
      DOBRA_TRY_VOID(s.next_level());
      DOBRA_TRY_VOID(progress.check());
      continue;
    }
    s.shortest.pop();
    if (!s.use(next)) s.front.segment(next).active = false;
    if (s.made.size() <= s.options.most_triangles) continue;
    return Error{ErrorCode::TooManyElements,
                 fmt::format("the mesh would have more than {} triangles: allow more, or larger ones",
                             s.options.most_triangles)};
  }
  return {};
}

PaperMesher::Next PaperMesher::next() const {
  State& s = *state_;
  Next next{.stage = s.stage, .level = s.stage == Stage::Smoothing ? static_cast<std::uint32_t>(s.pass) : s.level};
  if (s.stage != Stage::Front) return next;
  const SegmentIndex segment = s.shortest_active();
  if (segment == PaperFront::none) return next;
  const Segment& at = s.front.segment(segment);
  next.segment = {at.from, at.to};
  next.size = s.tree.size_at(geom::midpoint(s.front.places()[at.from], s.front.places()[at.to]));
  return next;
}

PaperMesher::View PaperMesher::view() const {
  const State& s = *state_;
  const bool after = s.stage != Stage::Front;
  View view{.places = after ? s.face.chart.points : s.front.places(),
            .points = after ? s.face.at : s.front.points(),
            .triangles = {},
            .front = {}};
  for (const Made& m : s.made) view.triangles.push_back(m.triangle);
  for (const Segment& segment : s.front.segments()) {
    if (segment.alive) view.front.push_back({{segment.from, segment.to}, segment.active});
  }
  return view;
}

const ChartQuadtree& PaperMesher::quadtree() const { return state_->tree; }
const std::vector<Made>& PaperMesher::log() const { return state_->made; }

std::vector<mesh::Finding> PaperMesher::findings() const {
  std::vector<mesh::Finding> findings;
  for (const ChartQuadtree::CellIndex cell : state_->tree.crowded()) {
    const auto& nodes = state_->tree.cells()[cell].nodes;
    const Point uv = state_->input.chart.points[nodes[0]];
    const Point3 at = state_->input.at[nodes[0]];
    findings.push_back(
        {"crowded_cell",
         fmt::format("{} given nodes lie in one cell of the deepest level of the quadtree", nodes.size()),
         base::Place{.x = at.x, .y = at.y, .z = at.z, .u = uv.x, .v = uv.y}});
  }
  return findings;
}

mesh::FaceMesh PaperMesher::mesh() const {
  DOBRA_CHECK(done());
  return state_->face;
}

Result<mesh::FaceMesh> paper_mesh(const mesh::ChartInput& input, const PaperOptions& options,
                                  const base::Progress& progress) {
  DOBRA_TRY(PaperMesher mesher, PaperMesher::start(input, options, progress));
  constexpr std::size_t at_once = 1000;
  while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(at_once, progress));
  return mesher.mesh();
}

Result<PaperSurface> paper_mesh(std::span<const trim::TrimmedSurface> surfaces, const PaperOptions& options,
                                const base::Progress& progress) {
  mesh::DivisionOptions division;
  division.kind = mesh::DivisionKind::Halving;
  division.sizes.largest = options.largest;
  division.sizes.turn = options.turn;
  PaperSurface result;
  DOBRA_TRY(result.division, mesh::divide(surfaces, division, progress));
  result.findings = result.division.findings;
  std::vector<mesh::FaceMesh> faces;
  constexpr std::size_t at_once = 1000;
  for (const mesh::ChartInput& input : result.division.faces) {
    DOBRA_TRY(PaperMesher mesher, PaperMesher::start(input, options, progress));
    while (!mesher.done()) DOBRA_TRY_VOID(mesher.step(at_once, progress));
    faces.push_back(mesher.mesh());
    const auto own = mesher.findings();
    result.findings.insert(result.findings.end(), own.begin(), own.end());
  }
  DOBRA_TRY(result.mesh, mesh::assemble(surfaces, result.division, faces));
  return result;
}

}  // namespace dobra::surf::paper
