#include "shared/surf/mesh/division.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "shared/surf/mesh/border_sizes.h"

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using dobra::mesh::delaunay::EdgeKind;
using geom::Point;
using geom::Point3;
using trim::ChartEdge;
using trim::ChartLine;
using trim::TrimmedSurface;

SideEnds::SideEnds(Point3 p, Point3 q) : low{p.x, p.y, p.z}, high{q.x, q.y, q.z} {
  if (high < low) std::swap(low, high);
}

namespace {

Result<void> check_sizes(const SizeOptions& sizes) {
  const auto refuse = [](std::string what) { return Error{ErrorCode::InvalidOption, std::move(what)}; };
  if (!(sizes.largest >= 0.0)) {
    return refuse(fmt::format("the largest size must not be negative and is {}", sizes.largest));
  }
  if (!(sizes.turn > 0.0)) {
    return refuse(fmt::format("the greatest turn of the normal must be positive and is {}", sizes.turn));
  }
  if (!(sizes.chord >= 0.0)) {
    return refuse(fmt::format("the distance from the surface must not be negative and is {}", sizes.chord));
  }
  if (!(sizes.growth > 1.0)) return refuse(fmt::format("the growth must be above 1 and is {}", sizes.growth));
  if (!(sizes.narrow >= 0.0)) {
    return refuse(fmt::format("the elements across narrow places must not be negative and are {}", sizes.narrow));
  }
  if (!(sizes.least >= 0.0)) {
    return refuse(fmt::format("the least size must not be negative and is {}", sizes.least));
  }
  return {};
}

/// L of each face: what is asked for, or a twentieth of the diagonal of the box of its border.
std::vector<double> largest_sizes(const Border& border, std::size_t faces, double asked) {
  std::vector<double> largest(faces, asked);
  if (asked > 0.0) return largest;
  struct Extent {
    Point3 low, high;
    bool any = false;
  };
  std::vector<Extent> extents(faces);
  for (const BorderEdge& edge : border.edges) {
    Extent& box = extents[edge.face];
    for (const double s : edge.space.marks()) {
      const Point3 p = edge.space.at(s);
      if (!box.any) box = {p, p, true};
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  }
  constexpr double part = 0.05;
  for (std::size_t f = 0; f < faces; ++f) largest[f] = part * geom::distance(extents[f].low, extents[f].high);
  return largest;
}

/// The places of a piece in its chart, and its nodes in space by the piece that is divided for it.
struct Divided {
  std::vector<double> s;            ///< From the start of the piece, ends among them.
  std::vector<std::uint32_t> node;  ///< One each.
};

class Divider {
 public:
  Divider(std::span<const TrimmedSurface> surfaces, const DivisionOptions& options, Border border)
      : surfaces_(surfaces), options_(options), border_(std::move(border)), pieces_(pieces_of(border_)) {}

  Result<Division> run(const base::Progress& progress) {
    const std::vector<double> largest = largest_sizes(border_, surfaces_.size(), options_.sizes.largest);
    DOBRA_TRY_VOID(count_cuts());
    parameters_.resize(pieces_.size());
    if (options_.kind == DivisionKind::Even) {
      DOBRA_TRY_VOID(divide_evenly(largest));
    } else {
      DOBRA_TRY_VOID(halve(largest, progress));
    }
    divide_again_where_too_few();
    number();
    for (std::size_t f = 0; f < surfaces_.size(); ++f) {
      DOBRA_TRY_VOID(progress.check());
      emit(f);
    }
    division_.nodes = static_cast<std::uint32_t>(at_.size());
    division_.findings.insert(division_.findings.begin(), border_.findings.begin(), border_.findings.end());
    return std::move(division_);
  }

 private:
  [[nodiscard]] const BorderEdge& edge_of(std::size_t piece) const { return border_.edges[pieces_[piece].edge]; }
  [[nodiscard]] bool is_first(std::size_t piece) const { return pieces_[piece].first == piece; }
  [[nodiscard]] bool closed(std::size_t piece) const {
    return border_.node_of[pieces_[piece].from] == border_.node_of[pieces_[piece].to];
  }

  Result<void> count_cuts() {
    for (const SharedGroup& group : border_.groups) {
      for (const std::size_t e : group) {
        if (border_.edges[e].cuts.size() == border_.edges[group[0]].cuts.size()) continue;
        return Error{ErrorCode::CannotMesh,
                     "two edges that are said to be one curve do not run beside each other: do not share them",
                     place_on(border_.edges[e], 0.5)};
      }
    }
    return {};
  }

  // ---- parameters of the pieces that are divided

  Result<void> divide_evenly(const std::vector<double>& largest) {
    profiles_ = sizes_along(border_, pieces_, surfaces_, options_.sizes, largest);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!is_first(p)) continue;
      if (pieces_[p].point) {
        parameters_[p] = {pieces_[p].s0, pieces_[p].s1};
        continue;
      }
      DOBRA_TRY_VOID(not_too_many(p, sides_wanted(profiles_[p])));
      parameters_[p] = even_parameters(edge_of(p).space, profiles_[p], closed(p) ? 3 : 1);
      clear_tip(edge_of(p), profiles_[p], parameters_[p]);
    }
    return {};
  }
  [[nodiscard]] Result<void> not_too_many(std::size_t p, double sides) const {
    if (sides <= static_cast<double>(options_.most_sides)) return {};
    return Error{ErrorCode::TooManyElements,
                 fmt::format("the sizes cut an edge into more than {} sides; raise them", options_.most_sides),
                 place_on(edge_of(p), pieces_[p].s0)};
  }
  [[nodiscard]] base::Place place_on(const BorderEdge& edge, double s) const {
    const Point uv = edge.space.place(s);
    const Point3 at = edge.space.at(s);
    return {.item = surfaces_[edge.face].name, .x = at.x, .y = at.y, .z = at.z, .u = uv.x, .v = uv.y};
  }

  Result<void> halve(std::vector<double> largest, const base::Progress& progress) {
    std::vector<double> length(pieces_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      double& own = length[pieces_[p].first];
      own = std::min(own, largest[edge_of(p).face]);
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!is_first(p)) continue;
      DOBRA_TRY_VOID(progress.check());
      const auto [s0, s1] = std::pair{pieces_[p].s0, pieces_[p].s1};
      if (pieces_[p].point) {
        parameters_[p] = {s0, s1};
        continue;
      }
      DOBRA_TRY_VOID(not_too_many(p, edge_of(p).space.length(s0, s1) / length[p]));
      const geom::DiscretiseOptions limits{.max_angle = base::Angle::from_degrees(options_.sizes.turn),
                                           .max_length = length[p]};
      DOBRA_TRY(std::vector<double> t, geom::discretise(edge_of(p).space.functions(s0, s1), limits));
      while (closed(p) && t.size() < 4) t = bisected(t);
      for (const double at : t) parameters_[p].push_back(at == 0.0 ? s0 : at == 1.0 ? s1 : std::lerp(s0, s1, at));
    }
    return {};
  }
  static std::vector<double> bisected(const std::vector<double>& t) {
    std::vector<double> twice{t.front()};
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      twice.push_back(0.5 * (t[i] + t[i + 1]));
      twice.push_back(t[i + 1]);
    }
    return twice;
  }

  /// A loop has three sides at least, those that are one point in space left out.
  void divide_again_where_too_few() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> loops;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!edge_of(p).line && !pieces_[p].point) loops[{edge_of(p).face, edge_of(p).loop}].push_back(p);
    }
    for (const auto& [loop, members] : loops) {
      std::size_t sides = 0;
      for (const std::size_t p : members) sides += parameters_[pieces_[p].first].size() - 1;
      if (sides >= 3) continue;
      for (const std::size_t p : members) {
        std::vector<double>& s = parameters_[pieces_[p].first];
        if (s.size() == 2) s = bisected(s);
      }
    }
  }

  // ---- nodes

  std::uint32_t node_at_vertex(std::size_t vertex) {
    const std::size_t first = border_.node_of[vertex];
    const auto [found, is_new] = node_of_vertex_.try_emplace(first, static_cast<std::uint32_t>(at_.size()));
    if (is_new) at_.push_back(border_.at(first));
    return found->second;
  }

  /// Nodes along every piece that is divided, in the order of the edges.
  void number() {
    divided_.resize(pieces_.size());
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!is_first(p)) continue;
      const EdgeInSpace& space = edge_of(p).space;
      Divided& own = divided_[p];
      own.s = parameters_[p];
      for (std::size_t i = 0; i < own.s.size(); ++i) {
        const bool first = i == 0, last = i + 1 == own.s.size();
        if (first || last) {
          own.node.push_back(node_at_vertex(first ? pieces_[p].from : pieces_[p].to));
        } else {
          own.node.push_back(static_cast<std::uint32_t>(at_.size()));
          at_.push_back(space.at(own.s[i]));
        }
      }
      if (pieces_[p].point) continue;
      for (std::size_t i = 0; i + 1 < own.s.size(); ++i) {
        const double middle = 0.5 * (space.travelled(own.s[i]) + space.travelled(own.s[i + 1]));
        division_.middles.emplace(SideEnds(at_[own.node[i]], at_[own.node[i + 1]]),
                                  space.at(space.parameter_at(middle)));
      }
    }
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (!is_first(p)) follow(p);
    }
  }

  /// The places of the nodes of another piece on this one: by the part of the way, then next to the node.
  void follow(std::size_t p) {
    const Piece& piece = pieces_[p];
    const EdgeInSpace& space = edge_of(p).space;
    const EdgeInSpace& first = edge_of(piece.first).space;
    const Divided& of = divided_[piece.first];
    Divided& own = divided_[p];
    const std::size_t count = of.s.size();
    const double start = first.travelled(of.s.front()), length = first.travelled(of.s.back()) - start;
    const double own_start = space.travelled(piece.s0), own_length = space.travelled(piece.s1) - own_start;
    double worst = 0.0, worst_s = piece.s0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = piece.along ? k : count - 1 - k;
      own.node.push_back(of.node[i]);
      if (k == 0 || k + 1 == count) {
        own.s.push_back(k == 0 ? piece.s0 : piece.s1);
      } else {
        const double part = length > 0.0 ? (first.travelled(of.s[i]) - start) / length : 0.5;
        const double near = space.parameter_at(own_start + (piece.along ? part : 1.0 - part) * own_length);
        const double s = space.next_to(at_[of.node[i]], near, own.s.back(), piece.s1);
        own.s.push_back(s > own.s.back() && s < piece.s1 ? s : near);
      }
      const double gap = geom::distance(space.at(own.s.back()), at_[own.node.back()]);
      if (gap > worst) worst = gap, worst_s = own.s.back();
    }
    if (worst <= std::max(edge_of(p).tolerance, edge_of(piece.first).tolerance)) return;
    division_.findings.push_back(
        {"gap_closed",
         fmt::format("two faces are {:.3g} m apart along the edge that they share; its nodes are on the first", worst),
         place_on(edge_of(p), worst_s)});
  }

  // ---- faces

  void emit(std::size_t face) {
    const TrimmedSurface& trimmed = surfaces_[face];
    ChartInput input{.surface = trimmed.surface, .chart = {}, .at = {}, .node = {}};
    point_of_vertex_.clear();
    std::map<std::pair<std::string, EdgeKind>, std::uint32_t> sets;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const BorderEdge& edge = edge_of(p);
      if (edge.face != face) continue;
      const EdgeKind kind = !edge.line                                 ? EdgeKind::Boundary
                            : *edge.line == ChartLine::Kind::Interface ? EdgeKind::Interface
                                                                       : EdgeKind::Constraint;
      const ChartEdge::Crack on_seam = edge.line ? ChartEdge::Crack::None : edge.space.edge().crack;
      const std::string set_name = on_seam == ChartEdge::Crack::None ? edge.name : std::string{};
      const auto [set, is_new] =
          sets.try_emplace({set_name, kind}, static_cast<std::uint32_t>(input.chart.sets.size()));
      if (is_new) input.chart.sets.push_back({set_name, kind});
      const bool opens = edge.line == ChartLine::Kind::Crack || on_seam != ChartEdge::Crack::None;
      if (opens && named_cracks_.insert(edge.name).second) division_.cracks.push_back(edge.name);
      for (std::size_t i = 1; on_seam != ChartEdge::Crack::None && i < divided_[p].node.size(); ++i) {
        std::array<std::uint32_t, 2> side{divided_[p].node[i - 1], divided_[p].node[i]};
        if (on_seam == ChartEdge::Crack::Against) std::swap(side[0], side[1]);
        division_.cracks_on_seams[edge.name].push_back(side);
      }
      emit_piece(p, set->second, input);
    }
    for (std::size_t i = 0; i < trimmed.points.size(); ++i) emit_point(face, i, input);
    for (const trim::ChartRegion& region : trimmed.regions) input.chart.regions.push_back({region.at, region.region});
    division_.faces.push_back(std::move(input));
  }

  std::size_t add_point(ChartInput& input, Point uv, std::uint32_t node) {
    input.chart.points.push_back(uv);
    input.at.push_back(at_[node]);
    input.node.push_back(node);
    return input.chart.points.size() - 1;
  }
  std::size_t point_at_vertex(ChartInput& input, std::size_t vertex) {
    const std::size_t first = border_.point_of[vertex];
    const auto found = point_of_vertex_.find(first);
    if (found != point_of_vertex_.end()) return found->second;
    return point_of_vertex_[first] = add_point(input, border_.place(first), node_at_vertex(vertex));
  }

  void emit_piece(std::size_t p, std::uint32_t set, ChartInput& input) {
    const Divided& own = divided_[p];
    std::size_t before = point_at_vertex(input, pieces_[p].from);
    for (std::size_t i = 1; i < own.s.size(); ++i) {
      const bool last = i + 1 == own.s.size();
      const std::size_t here = last ? point_at_vertex(input, pieces_[p].to)
                                    : add_point(input, edge_of(p).space.place(own.s[i]), own.node[i]);
      if (here == before) continue;  // one point of the chart too
      input.chart.edges.push_back({{NodeId(before), NodeId(here)}, set});
      before = here;
    }
  }

  void emit_point(std::size_t face, std::size_t i, ChartInput& input) {
    const trim::ChartPoint& point = surfaces_[face].points[i];
    const auto on_edge = border_.on_edges[face][i];
    std::size_t here = 0;
    if (on_edge) {
      here = point_at_vertex(input, *on_edge);
    } else {
      const auto node = static_cast<std::uint32_t>(at_.size());
      at_.push_back(surfaces_[face].surface.at(point.at));
      here = add_point(input, point.at, node);
    }
    if (!point.name.empty()) input.chart.node_sets[point.name].push_back(NodeId(here));
    if (point.size) input.chart.sizes.push_back({point.at, *point.size});
  }

  std::span<const TrimmedSurface> surfaces_;
  const DivisionOptions& options_;
  Border border_;
  std::vector<Piece> pieces_;
  std::vector<Profile> profiles_;
  std::vector<std::vector<double>> parameters_;
  std::vector<Divided> divided_;
  std::vector<Point3> at_;
  std::map<std::size_t, std::uint32_t> node_of_vertex_;
  std::map<std::size_t, std::size_t> point_of_vertex_;  ///< Of the face at work.
  std::set<std::string> named_cracks_;
  Division division_;
};

}  // namespace

Result<Division> divide(std::span<const TrimmedSurface> surfaces, const DivisionOptions& options,
                        const base::Progress& progress) {
  DOBRA_TRY_VOID(check_sizes(options.sizes));
  constexpr double part_of_turn = 0.25;
  const double corner = part_of_turn * options.sizes.turn * std::numbers::pi / 180.0;
  DOBRA_TRY(Border border, border_of(surfaces, options.closing, corner));
  return Divider(surfaces, options, std::move(border)).run(progress);
}

}  // namespace dobra::surf::mesh
