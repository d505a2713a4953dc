#include "quebra/meshing/tip_rosettes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace quebra::meshing {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::fem::fracture::CrackEnd;
using dobra::fem::fracture::Rosette;
using dobra::geom::Point;
using dobra::geom::Vector;
using dobra::mesh::NodeId;
using dobra::mesh::delaunay::MeshInput;

/// Of the room round the tip; with 20 sectors displacement correlation is then within 0.7 % and crack closure within
/// 0.15 % of the integrals on every specimen of the validation book.
constexpr double automatic_radius = 1.0 / 80.0;
/// A crack counts as straight as far as it stays in this slope from its tip: with the automatic radius, an arc then
/// strays by a hundredth of it.
constexpr double straight_slope = 0.1;
/// A named point nearer than this share of the rest of the room is the tip, but for rounding.
constexpr double least_room = 1e-3;
/// A curve may stray this far, as a fraction of the radius, from the straight spoke that takes its place.
constexpr double straightness = 0.02;

std::string rim_name(std::size_t number) { return fmt::format("rosette {}", number + 1); }

bool is_tip(const domain::Domain& domain, std::size_t curve, Point end) {
  // A crack that ends on another curve made a junction there, on that curve.
  for (const domain::Junction& junction : domain.junctions) {
    if (junction.at == end) return false;
  }
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (c == curve) continue;
    if (point(domain.curves[c], 0.0) == end || point(domain.curves[c], length(domain.curves[c])) == end) return false;
  }
  return true;
}

/// The greatest disc round the end s of a curve (0 or its length) with nothing in it but its straight end: no other
/// curve, no other part of its own, no named point, where forces may act; of the ends of a curve that are both tips
/// each has half.
double room_at(const domain::Domain& domain, const sketch::Curve& own, double s, Vector ahead, std::size_t tips,
               const std::string& line_ahead) {
  const Point tip = point(own, s);
  double room = length(own) / static_cast<double>(tips);
  const auto limit = [&](const dobra::geom::Polyline& line, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) room = std::min(room, distance(line.segment(i), tip));
  };
  for (const sketch::Curve& curve : domain.curves) {
    if (curve.name == own.name || curve.name == line_ahead) continue;
    const auto line = trace(curve).line;
    limit(line, 0, line.segment_count());
  }
  const auto line = trace(own).line;
  const std::size_t count = line.segment_count();
  for (std::size_t i = 0; i < count; ++i) {  // from the tip
    const std::size_t at = s == 0.0 ? i : count - 1 - i;
    const Vector back = tip - (s == 0.0 ? line.segment(at).to : line.segment(at).from);
    if (i == 0 || std::abs(cross(back, ahead)) <= straight_slope * dot(back, ahead)) continue;
    s == 0.0 ? limit(line, at, count) : limit(line, 0, at + 1);
    break;
  }
  const double least = least_room * room;
  for (const sketch::NamedPoint& named : domain.points) {
    const double gap = distance(named.at, tip);
    if (!named.name.empty() && gap > least) room = std::min(room, gap);
  }
  return room;
}

std::string tip_name(const TipRosette& tip) { return tip.crack + (tip.end == CrackEnd::Start ? "_start" : "_end"); }

/// Rounded down to three digits, for a limit that is to be kept.
double floored(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::floor(value / digit) * digit;
}

/// No two rosettes overlap.
Result<void> check_distances(const std::vector<TipRosette>& rosettes) {
  double fits = std::numeric_limits<double>::infinity();  // rings of one radius at all tips
  const TipRosette *first = nullptr, *second = nullptr;
  for (std::size_t i = 0; i < rosettes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Rosette &a = rosettes[k].rosette, &b = rosettes[i].rosette;
      const double apart = distance(a.tip, b.tip);
      if (apart >= a.outer_radius() + b.outer_radius()) continue;
      const double rings = a.outer_radius() / distance(a.tip, a.rings.front().front());
      if (0.5 * apart / rings >= fits) continue;
      fits = 0.5 * apart / rings;
      first = &rosettes[k];
      second = &rosettes[i];
    }
  }
  if (first == nullptr) return {};
  const Point at = second->rosette.tip;
  return Error{ErrorCode::BadDomain,
               fmt::format("its rosette of radius {:.4g} m overlaps that of '{}', of radius {:.4g} m: the tips are "
                           "{:.4g} m apart; a tip_radius of up to {:.3g} m keeps them apart, and 0 finds one by itself",
                           second->rosette.outer_radius(), tip_name(*first), first->rosette.outer_radius(),
                           distance(at, first->rosette.tip), floored(fits)),
               Place{.item = "crack tip '" + tip_name(*second) + "'", .x = at.x, .y = at.y}};
}

Result<void> check_room(const domain::Domain& domain, const std::vector<TipRosette>& rosettes) {
  for (std::size_t i = 0; i < rosettes.size(); ++i) {
    const auto& rosette = rosettes[i].rosette;
    const auto trouble = [&](const std::string& what) {
      return Error{ErrorCode::BadDomain,
                   fmt::format("the rosette of radius {:.4g} m {}; make it smaller", rosette.outer_radius(), what),
                   Place{.item = "crack '" + rosettes[i].crack + "'", .x = rosette.tip.x, .y = rosette.tip.y}};
    };
    for (const sketch::Curve& curve : domain.curves) {
      if (curve.name == rosettes[i].crack || curve.name == rosettes[i].ahead) continue;
      const auto line = trace(curve).line;
      for (std::size_t s = 0; s < line.segment_count(); ++s) {
        if (distance(line.segment(s), rosette.tip) < rosette.outer_radius())
          return trouble("reaches '" + curve.name + "'");
      }
    }
  }
  return {};
}

/// Crack, and line of symmetry ahead, run straight from the tip as far as the rosette reaches, and twice as long in
/// all.
Result<void> check_straight(const domain::Domain& domain, const TipRosette& tip) {
  const auto& [at, rings] = tip.rosette;
  const double reach = tip.rosette.outer_radius(), radius = distance(at, rings.front().front());
  for (const sketch::Curve& curve : domain.curves) {
    if (curve.name != tip.crack && curve.name != tip.ahead) continue;
    const bool from_start = curve.name == tip.crack ? tip.end == CrackEnd::Start : point(curve, 0.0) == at;
    const Point spoke = curve.name == tip.crack ? rings.back().front() : rings.back()[rings.back().size() / 2];
    const double all = length(curve);
    if (reach < 0.5 * all && distance(spoke, point(curve, from_start ? reach : all - reach)) <= straightness * radius)
      continue;
    return Error{ErrorCode::BadDomain,
                 fmt::format("the rosette of radius {:.4g} m does not fit: the crack, and a line of symmetry ahead, "
                             "must be straight in it, and twice as long; make it smaller",
                             reach),
                 Place{.item = "crack '" + curve.name + "'", .x = at.x, .y = at.y}};
  }
  return {};
}

Result<TipRosette> half_rosette(const domain::Domain& domain, const std::vector<model::HalfTip>& tips,
                                const model::HalfTip& tip, dobra::fem::fracture::RosetteOptions options) {
  const sketch::Curve& lip = domain.curves[tip.lip];
  const sketch::Curve& line = domain.curves[tip.line];
  if (!(options.radius > 0.0)) {
    const auto with = [&](std::size_t model::HalfTip::*curve) {
      return std::count_if(tips.begin(), tips.end(),
                           [&](const model::HalfTip& other) { return other.*curve == tip.*curve; });
    };
    const double s = point(lip, 0.0) == tip.at ? 0.0 : length(lip);
    options.radius =
        automatic_radius *
        std::min(room_at(domain, lip, s, tip.ahead, static_cast<std::size_t>(with(&model::HalfTip::lip)), line.name),
                 length(line) / static_cast<double>(with(&model::HalfTip::line)));
  }
  DOBRA_TRY(auto rosette, dobra::fem::fracture::make_rosette(tip.at, tip.ahead, options));
  const CrackEnd end = point(lip, 0.0) == tip.at ? CrackEnd::Start : CrackEnd::End;
  return TipRosette{lip.name, end, std::move(rosette), line.name, tip.half};
}

/// A rim as nodes of the input and edges of a set of its own.
struct Rim {
  NodeId behind;                ///< Where the crack ends on it,
  std::optional<NodeId> ahead;  ///< and, of a half, the line of symmetry.
};

Rim add_rim(MeshInput& input, const TipRosette& tip, std::string name) {
  input.sets.push_back({std::move(name), dobra::mesh::delaunay::EdgeKind::Boundary});
  const auto set = static_cast<std::uint32_t>(input.sets.size() - 1);
  const std::size_t first = input.points.size();
  const bool whole = tip.ahead.empty();
  const auto& ring = tip.rosette.rings.back();
  const std::vector<Point> points =
      whole ? std::vector<Point>(ring.begin(), ring.end() - 1) : rim_of(tip.rosette, tip.half);
  input.points.insert(input.points.end(), points.begin(), points.end());
  const std::size_t count = points.size();
  for (std::size_t i = 0; i + (whole ? 0 : 1) < count; ++i)
    input.edges.push_back({{NodeId(first + i), NodeId(first + (i + 1) % count)}, set});
  if (whole) return {NodeId(first), std::nullopt};
  const NodeId last(first + count - 1);
  return tip.half == dobra::fem::fracture::RosetteHalf::Left ? Rim{last, NodeId(first)} : Rim{NodeId(first), last};
}

}  // namespace

Result<std::vector<TipRosette>> tip_rosettes(const domain::Domain& domain, const std::vector<model::HalfTip>& half_tips,
                                             const dobra::fem::fracture::RosetteOptions& options,
                                             std::span<const TipRadius> radii) {
  const auto options_at = [&](Point tip) {
    dobra::fem::fracture::RosetteOptions own = options;
    const auto found =
        std::find_if(radii.begin(), radii.end(), [&](const TipRadius& other) { return other.tip == tip; });
    if (found != radii.end()) own.radius = found->radius;
    return own;
  };
  std::vector<TipRosette> rosettes;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    if (curve.role != sketch::Role::Crack) continue;
    const double all = length(curve);
    std::vector<CrackEnd> ends;
    if (is_tip(domain, c, point(curve, 0.0))) ends.push_back(CrackEnd::Start);
    if (is_tip(domain, c, point(curve, all))) ends.push_back(CrackEnd::End);
    for (const CrackEnd end : ends) {
      const double s = end == CrackEnd::Start ? 0.0 : all;
      const auto ahead = end == CrackEnd::Start ? -direction(curve, s) : direction(curve, s);
      dobra::fem::fracture::RosetteOptions own = options_at(point(curve, s));
      if (!(own.radius > 0.0)) own.radius = automatic_radius * room_at(domain, curve, s, ahead, ends.size(), {});
      DOBRA_TRY(auto rosette, dobra::fem::fracture::make_rosette(point(curve, s), ahead, own));
      rosettes.push_back({curve.name, end, std::move(rosette)});
    }
  }
  for (const model::HalfTip& tip : half_tips) {
    DOBRA_TRY(auto rosette, half_rosette(domain, half_tips, tip, options_at(tip.at)));
    rosettes.push_back(std::move(rosette));
  }
  DOBRA_TRY_VOID(check_distances(rosettes));
  for (const TipRosette& tip : rosettes) DOBRA_TRY_VOID(check_straight(domain, tip));
  DOBRA_TRY_VOID(check_room(domain, rosettes));
  return rosettes;
}

Result<void> cut_out(MeshInput& input, std::vector<TipRosette>& rosettes) {
  for (std::size_t r = 0; r < rosettes.size(); ++r) {
    const Rosette& rosette = rosettes[r].rosette;
    const double reach = rosette.outer_radius();
    // A node just outside the rim would make a sliver of an edge: it goes too.
    const double step = reach / static_cast<double>(rosette.rings.size());
    const auto inside = [&](NodeId node) {
      return distance(input.points[node.index()], rosette.tip) < reach + 0.3 * step;
    };
    const auto cut = [&](const std::string& curve, NodeId rim) {
      const auto set = static_cast<std::uint32_t>(
          std::find_if(input.sets.begin(), input.sets.end(), [&](const auto& s) { return s.name == curve; }) -
          input.sets.begin());
      std::erase_if(input.edges, [&](auto& edge) {
        if (edge.set != set) return false;
        const bool first = inside(edge.nodes[0]);
        const bool second = inside(edge.nodes[1]);
        if (first && second) return true;
        if (first) edge.nodes[0] = rim;
        if (second) edge.nodes[1] = rim;
        return false;
      });
    };
    const Rim rim = add_rim(input, rosettes[r], rim_name(r));
    cut(rosettes[r].crack, rim.behind);
    if (rim.ahead) cut(rosettes[r].ahead, *rim.ahead);
  }
  // A region's seed in a hole moves out of it, beside the crack.
  for (auto& seed : input.regions) {
    for (const TipRosette& r : rosettes) {
      const auto& rim = r.rosette.rings.back();
      const std::size_t quarter = rim.size() / 4;
      const bool left = !r.ahead.empty() && r.half == dobra::fem::fracture::RosetteHalf::Left;
      if (distance(seed.at, r.rosette.tip) <= 1.01 * r.rosette.outer_radius())
        seed.at = r.rosette.tip + 1.02 * (rim[left ? rim.size() - 1 - quarter : quarter] - r.rosette.tip);
    }
  }
  // Points that no edge has any more would be nodes in the holes.
  const auto hole_of = [](const TipRosette& r) { return r.rosette.outer_radius() * (1.0 + 0.3); };
  const auto holding = [&](Point p) {
    return std::find_if(rosettes.begin(), rosettes.end(),
                        [&](const TipRosette& r) { return distance(p, r.rosette.tip) < hole_of(r); });
  };
  const auto in_a_hole = [&](Point p) { return holding(p) != rosettes.end(); };
  std::vector<bool> used(input.points.size(), false);
  for (const auto& edge : input.edges) used[edge.nodes[0].index()] = used[edge.nodes[1].index()] = true;
  for (const auto& [name, nodes] : input.node_sets) {
    for (const NodeId node : nodes) {
      const Point at = input.points[node.index()];
      const auto own = holding(at);
      if (used[node.index()] || own == rosettes.end()) continue;
      if (own->rosette.tip != at)
        return Error{ErrorCode::BadDomain,
                     fmt::format("lies within {:.4g} m of the tip of '{}', where the nodes are those of its rosette; "
                                 "move it, or make the tip's elements smaller (tip_radius)",
                                 hole_of(*own), own->crack),
                     Place{.item = "point '" + name + "'", .x = at.x, .y = at.y}};
      own->names.push_back(name);
    }
  }
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
  std::erase_if(input.node_sets, [](const auto& set) { return set.second.empty(); });
  std::erase_if(input.sizes, [&](const auto& request) { return in_a_hole(request.at); });
  return {};
}

Result<void> fill(dobra::mesh::ElementMesh& mesh, const std::vector<TipRosette>& rosettes) {
  for (std::size_t r = 0; r < rosettes.size(); ++r) {
    const auto rim = mesh.side_sets.extract(rim_name(r));
    const std::int32_t region = mesh.regions[rim.mapped().front().element.index()];
    const auto& [crack, end, rosette, ahead, half, names] = rosettes[r];
    for (const std::string& name : names)
      mesh.node_sets[name].push_back(NodeId(mesh.points.size()));  // fill begins with the tip
    DOBRA_TRY_VOID(ahead.empty() ? fill_rosette(mesh, rosette, crack, end, region)
                                 : fill_half_rosette(mesh, rosette, half, crack, ahead, region));
  }
  return {};
}

}  // namespace quebra::meshing
