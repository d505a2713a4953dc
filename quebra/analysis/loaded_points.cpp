#include "quebra/analysis/loaded_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "quebra/domain/domain.h"
#include "quebra/domain/junctions.h"
#include "quebra/domain/selection.h"

namespace quebra::analysis {
namespace {

namespace fem = dobra::fem;
namespace mesh = dobra::mesh;
using dobra::geom::Point;
using dobra::geom::Vector;

/// Of the room round a point.
constexpr double share_of_room = 1.0 / 20.0;
/// Forces that can add less than this to eta are not minded.
constexpr double felt = 1e-3;

/// Length of the material along a line from p, to one side or the other; infinite if it leaves the domain at once.
double across(const domain::Domain& domain, Point p, Vector direction) {
  constexpr double beyond = 1e-9;  // a side, so that no line slips through between two
  const double size = domain.box().diagonal();
  const domain::Inside inside(domain);
  double best = std::numeric_limits<double>::infinity();
  for (const Vector d : {direction, -direction}) {
    double hit = size;
    for (const sketch::Curve& curve : domain.curves) {
      if (curve.role != sketch::Role::Boundary && curve.role != sketch::Role::Hole) continue;
      const auto line = trace(curve).line;
      for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const auto [from, to] = line.segment(i);
        const Vector side = to - from;
        const double slope = cross(d, side);
        if (slope == 0.0) continue;
        const double t = cross(from - p, side) / slope, f = cross(from - p, d) / slope;
        if (f >= -beyond && f <= 1.0 + beyond && t > 1e-4 * size) hit = std::min(hit, t);
      }
    }
    if (inside(p + 0.5 * hit * d)) best = std::min(best, hit);
  }
  return best;
}

/// The nodes of a place that is a point, or of one that is a curve.
std::vector<mesh::NodeId> nodes_at(const mesh::ElementMesh& own, const std::string& where, bool curve) {
  if (own.side_sets.contains(where) != curve) return {};
  const auto nodes = fem::find_nodes(own, where);
  return nodes ? *nodes : std::vector<mesh::NodeId>{};
}

/// The force on a point without what acts along the normals of the curve of this name there.
Vector without_normals(const domain::Domain& domain, const std::string& where, const LoadedPoint& loaded) {
  Vector force = loaded.force;
  for (const std::size_t c : curves_meant(domain, where)) {
    for (const double s : places_on(domain, c, loaded.at)) {
      const Vector along = direction(domain.curves[c], s);
      force = dot(force, along) * along;
    }
  }
  return force;
}

}  // namespace

double radius_round(const domain::Domain& domain, Point at) {
  double room = domain.box().diagonal();
  // Of a loop through the point only what lies across counts: a corner beside it is nothing.
  std::set<std::size_t> own_loop;
  for (const domain::Domain::Loop& loop : domain.loops) {
    if (std::none_of(loop.sides.begin(), loop.sides.end(),
                     [&](const domain::Domain::Side& side) { return !places_on(domain, side.curve, at).empty(); }))
      continue;
    for (const domain::Domain::Side& side : loop.sides) own_loop.insert(side.curve);
  }
  std::vector<Vector> ways;  // along the boundary away from the point
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    if (curve.role == sketch::Role::Internal) continue;
    const double all = length(curve);
    const auto places = places_on(domain, c, at);
    if (places.empty()) {
      if (own_loop.contains(c)) continue;
      room = std::min(room, distance(trace(curve).line, at));
      continue;
    }
    if (curve.role == sketch::Role::Crack) {
      for (const double end : {0.0, all}) {
        if (const double gap = distance(point(curve, end), at); gap > 0.0) room = std::min(room, gap);
      }
      continue;
    }
    for (const double s : places) {
      const double step = 1e-6 * all;
      if (s > 0.0) ways.push_back(normalised(point(curve, s - std::min(step, s)) - at));
      if (s < all) ways.push_back(normalised(point(curve, s + std::min(step, all - s)) - at));
    }
  }
  if (ways.size() == 2) {
    const Vector sum = ways[0] + ways[1];
    room = std::min(room, across(domain, at, length(sum) > 0.1 ? normalised(sum) : left_of(ways[0])));
  }
  return share_of_room * room;
}

std::vector<LoadedPoint> loaded_points(const domain::Domain& domain, const mesh::ElementMesh& own,
                                       const ProblemParams& params, const fem::Problem& problem,
                                       const fem::CaseResult& result, double radius) {
  // 1. Points that are loaded or held, with what acts on them.
  std::map<mesh::NodeId, LoadedPoint> found;
  const auto add = [&](const std::string& where, const auto& force_on) {
    const auto nodes = nodes_at(own, where, false);
    const double share = 1.0 / static_cast<double>(nodes.size());  // as fem::find_shares
    for (const mesh::NodeId node : nodes) {
      LoadedPoint& point =
          found.try_emplace(node, LoadedPoint{.name = where, .at = own.point(node), .force = {}}).first->second;
      point.force = point.force + share * force_on(node);
    }
  };
  const auto held = [](mesh::NodeId) { return Vector{}; };
  for (const auto& row : params.supports) add(row.where, held);
  for (const auto& row : params.ties) {
    for (const std::string& point : row.points) add(point, held);
  }
  for (const auto& row : params.springs) {
    add(row.where, [&](mesh::NodeId node) {
      const Vector u = result.displacements[node.index()];
      return Vector{-row.x * u.x, -row.y * u.y};
    });
  }
  for (const auto& row : params.loads) {
    if (row.kind == LoadKind::Force && row.load_case == result.name)
      add(row.where, [&](mesh::NodeId) { return Vector{row.x, row.y}; });
  }
  for (auto& [node, point] : found) point.force = point.force + result.reactions[node.index()];
  // 2. Along a direction that a curve through the point holds, the reaction is a part of what is spread along the
  // curve.
  const auto spread = [&](const std::string& where, const auto& left) {
    for (const mesh::NodeId node : nodes_at(own, where, true)) {
      const auto point = found.find(node);
      if (point != found.end()) point->second.force = left(point->second);
    }
  };
  const auto spread_along = [&](const std::string& where, bool x, bool y) {
    spread(where, [x, y](const LoadedPoint& point) {
      return Vector{x ? 0.0 : point.force.x, y ? 0.0 : point.force.y};
    });
  };
  for (const auto& row : params.supports) {
    if (row.normal)
      spread(row.where, [&](const LoadedPoint& point) { return without_normals(domain, row.where, point); });
    const bool both = !row.x_formula.empty() || !row.y_formula.empty();
    spread_along(row.where, row.x || both, row.y || both);
  }
  for (const auto& row : params.ties) spread_along(row.where, row.axis == TieAxis::X, row.axis == TieAxis::Y);
  // 3. Those that the energy feels.
  std::map<mesh::NodeId, double> stiffness;  // E t
  for (std::size_t e = 0; e < own.element_count(); ++e) {
    const fem::Material& material = problem.materials.at(own.regions[e]);
    for (const mesh::NodeId node : own.nodes_of(mesh::ElementId(e))) {
      if (found.contains(node)) stiffness[node] = material.young * material.thickness;
    }
  }
  std::vector<LoadedPoint> points;
  for (auto& [node, point] : found) {
    if (!(length(point.force) > felt * std::sqrt(stiffness[node] * 2.0 * result.energy))) continue;
    point.radius = radius > 0.0 ? radius : radius_round(domain, point.at);
    // The tip of a half crack is a place on the boundary, which the domain knows nothing of.
    for (const mesh::CrackTip& tip : own.tips) {
      const double gap = distance(own.point(tip.node), point.at);
      if (radius <= 0.0 && gap > 0.0) point.radius = std::min(point.radius, share_of_room * gap);
    }
    points.push_back(std::move(point));
  }
  return points;
}

std::string names_of(const std::vector<LoadedPoint>& points) {
  std::string text;
  std::set<std::string> named;  // a point on a crack has two nodes
  for (const LoadedPoint& own : points) {
    if (named.insert(own.name).second) text += (text.empty() ? "'" : ", '") + own.name + "'";
  }
  return text;
}

}  // namespace quebra::analysis
