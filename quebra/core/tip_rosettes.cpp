#include "quebra/core/tip_rosettes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quebra::core {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::fem::CrackEnd;
using dobra::geom::Point;
using dobra::mesh::MeshInput;
using dobra::mesh::NodeId;

constexpr double automatic_radius = 1.0 / 40.0;
/// A curve may stray this far, as a fraction of the radius, from the straight spoke that takes its place.
constexpr double straightness = 1e-6;

std::string rim_name(std::size_t number) { return fmt::format("rosette {}", number + 1); }

bool is_tip(const Domain& domain, std::size_t curve, Point end) {
  // A crack that ends on another curve made a junction there, on that curve.
  for (const Junction& junction : domain.junctions) {
    if (junction.at == end) return false;
  }
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (c == curve) continue;
    if (point(domain.curves[c], 0.0) == end || point(domain.curves[c], length(domain.curves[c])) == end) return false;
  }
  return true;
}

Result<void> check_room(const Domain& domain, const std::vector<TipRosette>& rosettes) {
  for (std::size_t i = 0; i < rosettes.size(); ++i) {
    const auto& rosette = rosettes[i].rosette;
    const auto trouble = [&](const std::string& what) {
      return Error{ErrorCode::BadDomain, fmt::format("the rosette of radius {:.4g} {}; make it smaller", rosette.outer_radius(), what),
                   Place{.item = "crack '" + rosettes[i].crack + "'", .x = rosette.tip.x, .y = rosette.tip.y}};
    };
    for (std::size_t k = 0; k < i; ++k) {
      if (distance(rosette.tip, rosettes[k].rosette.tip) < rosette.outer_radius() + rosettes[k].rosette.outer_radius())
        return trouble("overlaps that of '" + rosettes[k].crack + "'");
    }
    for (const Curve& curve : domain.curves) {
      if (curve.name == rosettes[i].crack) continue;
      const auto line = trace(curve).line;
      for (std::size_t s = 0; s < line.segment_count(); ++s) {
        if (distance(line.segment(s), rosette.tip) < rosette.outer_radius()) return trouble("reaches '" + curve.name + "'");
      }
    }
  }
  return {};
}

}  // namespace

Result<std::vector<TipRosette>> tip_rosettes(const Domain& domain, const dobra::fem::RosetteOptions& options) {
  std::vector<TipRosette> rosettes;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const Curve& curve = domain.curves[c];
    if (curve.role != Role::Crack) continue;
    const double all = length(curve);
    std::vector<CrackEnd> ends;
    if (is_tip(domain, c, point(curve, 0.0))) ends.push_back(CrackEnd::Start);
    if (is_tip(domain, c, point(curve, all))) ends.push_back(CrackEnd::End);
    for (const CrackEnd end : ends) {
      dobra::fem::RosetteOptions own = options;
      if (!(own.radius > 0.0)) own.radius = automatic_radius * all / static_cast<double>(ends.size());
      const double s = end == CrackEnd::Start ? 0.0 : all;
      const auto ahead = end == CrackEnd::Start ? -direction(curve, s) : direction(curve, s);
      DOBRA_TRY(auto rosette, dobra::fem::make_rosette(point(curve, s), ahead, own));
      const double reach = rosette.outer_radius();
      const Point rim = rosette.rings.back().front();
      const Point on_curve = point(curve, std::abs(s - std::min(reach, all)));
      if (reach >= 0.5 * all || distance(rim, on_curve) > straightness * own.radius) {
        return Error{ErrorCode::BadDomain,
                     fmt::format("the rosette of radius {:.4g} does not fit: the crack must be straight in it, and twice as long; make it smaller", reach),
                     Place{.item = "crack '" + curve.name + "'", .x = rosette.tip.x, .y = rosette.tip.y}};
      }
      rosettes.push_back({curve.name, end, std::move(rosette)});
    }
  }
  DOBRA_TRY_VOID(check_room(domain, rosettes));
  return rosettes;
}

void cut_out(MeshInput& input, const std::vector<TipRosette>& rosettes) {
  for (std::size_t r = 0; r < rosettes.size(); ++r) {
    const auto& [crack, end, rosette] = rosettes[r];
    const double reach = rosette.outer_radius();
    const auto set = static_cast<std::uint32_t>(
        std::find_if(input.sets.begin(), input.sets.end(), [&](const auto& s) { return s.name == crack; }) - input.sets.begin());
    // A node just outside the rim would make a sliver of an edge: it goes too.
    const double step = reach / static_cast<double>(rosette.rings.size());
    const auto inside = [&](NodeId node) { return distance(input.points[node.index()], rosette.tip) < reach + 0.3 * step; };
    const auto rim = NodeId(input.points.size());
    for (auto point = rosette.rings.back().begin(); point + 1 != rosette.rings.back().end(); ++point) input.points.push_back(*point);
    std::erase_if(input.edges, [&](auto& edge) {
      if (edge.set != set) return false;
      const bool first = inside(edge.nodes[0]);
      const bool second = inside(edge.nodes[1]);
      if (first && second) return true;
      if (first) edge.nodes[0] = rim;
      if (second) edge.nodes[1] = rim;
      return false;
    });
    input.sets.push_back({rim_name(r), dobra::mesh::EdgeKind::Boundary});
    const std::size_t count = rosette.rings.back().size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      input.edges.push_back({{NodeId(rim.index() + i), NodeId(rim.index() + (i + 1) % count)},
                             static_cast<std::uint32_t>(input.sets.size() - 1)});
    }
  }
  // A region's seed in a hole moves out of it, beside the crack.
  for (auto& seed : input.regions) {
    for (const TipRosette& r : rosettes) {
      const auto& rim = r.rosette.rings.back();
      if (distance(seed.at, r.rosette.tip) <= 1.01 * r.rosette.outer_radius())
        seed.at = r.rosette.tip + 1.02 * (rim[rim.size() / 4] - r.rosette.tip);
    }
  }
  // Points that no edge has any more would be nodes in the holes.
  const auto in_a_hole = [&](Point p) {
    return std::any_of(rosettes.begin(), rosettes.end(), [&](const TipRosette& r) {
      return distance(p, r.rosette.tip) < r.rosette.outer_radius() * (1.0 + 0.3);
    });
  };
  std::vector<bool> used(input.points.size(), false);
  for (const auto& edge : input.edges) used[edge.nodes[0].index()] = used[edge.nodes[1].index()] = true;
  std::vector<NodeId> renamed(input.points.size());
  std::vector<Point> kept;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    if (!used[i] && in_a_hole(input.points[i])) continue;
    renamed[i] = NodeId(kept.size());
    kept.push_back(input.points[i]);
  }
  input.points = std::move(kept);
  for (auto& edge : input.edges) edge.nodes = {renamed[edge.nodes[0].index()], renamed[edge.nodes[1].index()]};
  for (auto& [name, nodes] : input.node_sets) {
    for (NodeId& node : nodes) node = renamed[node.index()];
    std::erase_if(nodes, [](NodeId node) { return !node.valid(); });
  }
  std::erase_if(input.sizes, [&](const auto& request) { return in_a_hole(request.at); });
}

Result<void> fill(dobra::mesh::ElementMesh& mesh, const std::vector<TipRosette>& rosettes) {
  for (std::size_t r = 0; r < rosettes.size(); ++r) {
    const auto rim = mesh.side_sets.extract(rim_name(r));
    const std::int32_t region = mesh.regions[rim.mapped().front().element.index()];
    DOBRA_TRY_VOID(dobra::fem::fill_rosette(mesh, rosettes[r].rosette, rosettes[r].crack, rosettes[r].end, region));
  }
  return {};
}

}  // namespace quebra::core
