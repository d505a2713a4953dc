#include "quebra/core/narrow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "shared/geom/spatial_index.h"

// 1. Sides of the curves, told which side of them is material; points of no side. 2. For each side those that come
// nearer than its length, through the material, and not because they meet at a small angle. 3. Where there are any, the
// side is halved until its parts are about as long as they are far from them: each asks for that size.

namespace quebra::core {
namespace {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Segment;
using dobra::geom::Vector;
using dobra::mesh::MeshInput;

struct Side {
  Segment segment;
  std::size_t from = 0, to = 0;  ///< Points of the input.
  std::size_t curve = 0;         ///< None of a point: the number of curves.
  bool left = true, right = true;  ///< Where the material is.
};

struct Near {
  double distance = 0.0;
  Point here, there;
};

/// The nearest points of two segments that do not cross.
Near nearest(const Segment& a, const Segment& b) {
  Near best{std::numeric_limits<double>::infinity(), a.from, b.from};
  const auto take = [&](Point here, Point there) {
    const double d = distance(here, there);
    if (d < best.distance) best = {d, here, there};
  };
  for (const Point p : {a.from, a.to}) take(p, interpolate(b.from, b.to, nearest_fraction(b, p)));
  for (const Point q : {b.from, b.to}) take(interpolate(a.from, a.to, nearest_fraction(a, q)), q);
  return best;
}

/// Sides that follow each other with small turns, and the corners that such chains end in. Made when first asked.
class Chains {
 public:
  explicit Chains(const std::vector<Side>& sides) : sides_(sides) {}

  /// Whether two sides belong to chains that leave a common corner at a small angle, and are no nearer to each other
  /// than that makes them.
  bool wedge(std::size_t a, std::size_t b, const Near& near, double input_angle) {
    if (chain_.empty()) make();
    // Curves that bend towards each other come nearer than their tangents; half as near counts as the angle's doing.
    constexpr double bent = 0.5;
    const auto& first = ends_[root(a)];
    const auto& second = ends_[root(b)];
    for (const End& one : first) {
      for (const End& two : second) {
        if (one.node != two.node || &one == &two) continue;
        const double angle = std::abs(std::atan2(cross(one.away, two.away), dot(one.away, two.away)));
        if (angle < input_angle && near.distance >= bent * std::sin(angle) * distance(one.at, near.here)) return true;
      }
    }
    return false;
  }

 private:
  struct End {
    std::size_t node = 0;
    Point at;
    Vector away;
  };

  std::size_t root(std::size_t i) {
    while (chain_[i] != i) i = chain_[i] = chain_[chain_[i]];
    return i;
  }

  void make() {
    const double greatest_turn = std::cos(35.0 * std::numbers::pi / 180.0);
    chain_.resize(sides_.size());
    std::iota(chain_.begin(), chain_.end(), std::size_t{0});
    std::map<std::size_t, std::vector<std::size_t>> at_node;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      at_node[sides_[i].from].push_back(i);
      if (sides_[i].to != sides_[i].from) at_node[sides_[i].to].push_back(i);
    }
    const auto away = [&](std::size_t side, std::size_t node) {
      const Vector along = sides_[side].segment.vector();
      return sides_[side].from == node ? along : -1.0 * along;
    };
    std::vector<std::pair<std::size_t, std::size_t>> corners;  // node, side
    for (const auto& [node, meeting] : at_node) {
      if (meeting.size() == 2) {
        const Vector u = away(meeting[0], node), v = away(meeting[1], node);
        if (-dot(u, v) >= greatest_turn * length(u) * length(v)) {
          const std::size_t a = root(meeting[0]), b = root(meeting[1]);
          chain_[std::max(a, b)] = std::min(a, b);
          continue;
        }
      }
      for (const std::size_t side : meeting) corners.emplace_back(node, side);
    }
    ends_.resize(sides_.size());
    for (const auto& [node, side] : corners) {
      const Segment& s = sides_[side].segment;
      ends_[root(side)].push_back({node, sides_[side].from == node ? s.from : s.to, away(side, node)});
    }
  }

  const std::vector<Side>& sides_;
  std::vector<std::size_t> chain_;      ///< Union of sides, by the least.
  std::vector<std::vector<End>> ends_;  ///< One a root.
};

class Finder {
 public:
  Finder(const Domain& domain, const MeshInput& divided, std::span<const std::uint8_t> keeps,
         const NarrowOptions& options)
      : keeps_(keeps), options_(options), chains_(sides_) {
    make_sides(domain, divided);
    std::vector<Box> boxes;
    for (const Side& side : sides_) boxes.push_back(side.segment.box());
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  NarrowPlaces run() {
    std::vector<std::size_t> beside;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const double reach = reach_of(sides_[i].segment.length());
      if (!(reach > 0.0)) continue;
      beside.clear();
      index_.for_each_overlapping(sides_[i].segment.box().grown(reach), [&](std::size_t j) {
        if (!adjacent(sides_[i], sides_[j]) && narrow(i, j, sides_[i].segment, reach)) beside.push_back(j);
      });
      if (beside.empty()) continue;
      std::sort(beside.begin(), beside.end());
      if (keeps(i)) {
        keep(i, beside);
      } else {
        ask(i, sides_[i].segment, beside);
      }
    }
    for (const auto& [curve, kept] : kept_) places_.kept.push_back(kept);
    return std::move(places_);
  }

 private:
  void make_sides(const Domain& domain, const MeshInput& divided) {
    const std::size_t curves = domain.curves.size();
    std::vector<double> twice_area(curves, 0.0);  // what each adds to that of its loop
    std::vector<std::uint8_t> on_edge(divided.points.size(), 0);
    for (const auto& edge : divided.edges) {
      const std::size_t a = edge.nodes[0].index(), b = edge.nodes[1].index();
      on_edge[a] = on_edge[b] = 1;
      if (edge.set >= curves) continue;
      const Point p = divided.points[a], q = divided.points[b], origin = divided.points.front();
      twice_area[edge.set] += cross(p - origin, q - origin);
      sides_.push_back({{p, q}, a, b, edge.set});
    }
    std::vector<std::array<bool, 2>> material(curves, {true, true});
    for (const Domain::Loop& loop : domain.loops) {
      double sum = 0.0;
      for (const auto& [curve, backwards] : loop.sides) sum += backwards ? -twice_area[curve] : twice_area[curve];
      for (const auto& [curve, backwards] : loop.sides) {
        const bool left = ((sum > 0.0) == (loop.depth % 2 == 0)) != backwards;
        material[curve] = {left, !left};
      }
    }
    for (Side& side : sides_) {
      side.left = material[side.curve][0];
      side.right = material[side.curve][1];
    }
    for (std::size_t p = 0; p < on_edge.size(); ++p) {
      if (on_edge[p] == 0) sides_.push_back({{divided.points[p], divided.points[p]}, p, p, curves});
    }
  }

  /// Below this distance something is too near to a part of a side of this length.
  [[nodiscard]] double reach_of(double length) const { return length * options_.across / options_.enough; }
  static bool adjacent(const Side& a, const Side& b) {
    return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
  }
  [[nodiscard]] bool keeps(std::size_t side) const {
    return sides_[side].curve < keeps_.size() && keeps_[sides_[side].curve] != 0;
  }

  /// Whether the way from p, on the side, to q begins in the material.
  static bool through_material(const Side& side, Point p, Point q) {
    if (side.left && side.right) return true;
    const double turn = cross(side.segment.vector(), q - p);
    return side.left ? turn > 0.0 : turn < 0.0;
  }

  /// How near side j comes to a part of side i, if that is nearer than `reach` and makes a narrow place.
  std::optional<Near> narrow(std::size_t i, std::size_t j, const Segment& part, double reach) {
    const Near near = nearest(part, sides_[j].segment);
    if (!(near.distance > 0.0) || near.distance >= reach) return std::nullopt;
    if (!through_material(sides_[i], near.here, near.there)) return std::nullopt;
    if (!through_material(sides_[j], near.there, near.here)) return std::nullopt;
    // Beside what stays coarse finer sides are of no use.
    if (keeps(j) && !keeps(i) && near.distance < reach_of(sides_[j].segment.length())) return std::nullopt;
    if (chains_.wedge(i, j, near, options_.input_angle.radians())) return std::nullopt;
    return near;
  }

  void ask(std::size_t i, const Segment& part, const std::vector<std::size_t>& beside) {
    const double least = options_.smallest * sides_[i].segment.length();
    const double length = part.length();
    const double reach = reach_of(length);
    std::vector<std::size_t> near_ones;
    Near best{std::numeric_limits<double>::infinity(), {}, {}};
    for (const std::size_t j : beside) {
      const auto near = narrow(i, j, part, reach);
      if (!near) continue;
      const Segment& other = sides_[j].segment;
      if (distance(other, part.from) < least && distance(other, part.to) < least) return;
      near_ones.push_back(j);
      if (near->distance < best.distance) best = *near;
    }
    if (near_ones.empty() || length < least) return;
    const double size = best.distance / options_.across;
    // Half of it would be short enough.
    if (length <= 2.0 * options_.enough * size && best.distance >= least) {
      places_.sizes.push_back({best.here, size});
      return;
    }
    const Point middle = midpoint(part.from, part.to);
    ask(i, {part.from, middle}, near_ones);
    ask(i, {middle, part.to}, near_ones);
  }

  void keep(std::size_t i, const std::vector<std::size_t>& beside) {
    const Side& side = sides_[i];
    for (const std::size_t j : beside) {
      const Near near = nearest(side.segment, sides_[j].segment);
      const NarrowPlaces::Kept found{side.curve, sides_[j].curve, near.here, near.distance, side.segment.length()};
      const auto [entry, is_new] = kept_.try_emplace(side.curve, found);
      if (!is_new && found.width * entry->second.side < entry->second.width * found.side) entry->second = found;
    }
  }

  std::span<const std::uint8_t> keeps_;
  const NarrowOptions& options_;
  std::vector<Side> sides_;
  dobra::geom::SpatialIndex index_;
  Chains chains_;
  NarrowPlaces places_;
  std::map<std::size_t, NarrowPlaces::Kept> kept_;
};

}  // namespace

NarrowPlaces narrow_places(const Domain& domain, const MeshInput& divided, std::span<const std::uint8_t> keeps,
                           const NarrowOptions& options) {
  if (!(options.across > 0.0)) return {};
  return Finder(domain, divided, keeps, options).run();
}

}  // namespace quebra::core
