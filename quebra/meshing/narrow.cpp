#include "quebra/meshing/narrow.h"

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
// side is halved until its parts are about as long as they are far from them: each asks for that size, or several along
// and across it if more elements than one are wanted there. 4. Points ask for the distance to the nearest other one.

namespace quebra::meshing {
namespace {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Segment;
using dobra::geom::Vector;
using dobra::mesh::delaunay::MeshInput;

struct Side {
  Segment segment;
  std::size_t from = 0, to = 0;    ///< Points of the input.
  std::size_t curve = 0;           ///< None of a point: the number of curves.
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

/// The sides that end at each node, ascending.
class Meetings {
 public:
  explicit Meetings(const std::vector<Side>& sides) {
    std::size_t nodes = 0;
    for (const Side& side : sides) nodes = std::max({nodes, side.from + 1, side.to + 1});
    first_.resize(nodes + 1, 0);
    for (const Side& side : sides) {
      ++first_[side.from + 1];
      if (side.to != side.from) ++first_[side.to + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    sides_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      sides_[next[sides[i].from]++] = i;
      if (sides[i].to != sides[i].from) sides_[next[sides[i].to]++] = i;
    }
  }

  [[nodiscard]] std::size_t nodes() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const std::size_t> at(std::size_t node) const {
    return std::span(sides_).subspan(first_[node], first_[node + 1] - first_[node]);
  }

 private:
  std::vector<std::size_t> first_, sides_;
};

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
    const Meetings meetings(sides_);
    const auto away = [&](std::size_t side, std::size_t node) {
      const Vector along = sides_[side].segment.vector();
      return sides_[side].from == node ? along : -1.0 * along;
    };
    std::vector<std::pair<std::size_t, std::size_t>> corners;  // node, side
    for (std::size_t node = 0; node < meetings.nodes(); ++node) {
      const auto meeting = meetings.at(node);
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

/// Ways along the curves: sides that follow each other at nodes where no third one ends, round corners too. Made when
/// first asked.
class Ways {
 public:
  explicit Ways(const std::vector<Side>& sides) : sides_(sides) {}

  /// Length of the way along the curves from a place on side a to one on side b; infinite if there is none.
  double along(std::size_t a, Point here, std::size_t b, Point there) {
    if (place_.empty()) make();
    if (place_[a].run != place_[b].run) return std::numeric_limits<double>::infinity();
    const double way = std::abs(at(a, here) - at(b, there));
    const double round = round_[place_[a].run];
    return round > 0.0 ? std::min(way, round - way) : way;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Place {
    std::size_t run = none;
    double from = 0.0, to = 0.0;  ///< Way to both ends of the side.
  };

  [[nodiscard]] double at(std::size_t side, Point p) const {
    const Place& place = place_[side];
    return place.from + (place.to - place.from) * nearest_fraction(sides_[side].segment, p);
  }

  void make() {
    place_.resize(sides_.size());
    const Meetings meetings(sides_);
    const auto walk = [&](std::size_t side, std::size_t node) {
      const std::size_t first = node;
      double way = 0.0;
      while (place_[side].run == none) {
        const bool forward = sides_[side].from == node;
        const double end = way + sides_[side].segment.length();
        place_[side] = {round_.size(), forward ? way : end, forward ? end : way};
        way = end;
        node = forward ? sides_[side].to : sides_[side].from;
        const auto meeting = meetings.at(node);
        if (meeting.size() == 2) side = meeting[0] == side ? meeting[1] : meeting[0];
      }
      round_.push_back(node == first ? way : 0.0);
    };
    for (std::size_t node = 0; node < meetings.nodes(); ++node) {
      const auto meeting = meetings.at(node);
      if (meeting.size() == 2) continue;
      for (const std::size_t side : meeting) {
        if (place_[side].run == none) walk(side, node);
      }
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (place_[i].run == none) walk(i, sides_[i].from);
    }
  }

  const std::vector<Side>& sides_;
  std::vector<Place> place_;
  std::vector<double> round_;  ///< One a run: its length if it is closed, or 0.
};

class Finder {
 public:
  Finder(const domain::Domain& domain, const MeshInput& divided, std::span<const std::uint8_t> keeps,
         const NarrowOptions& options)
      : keeps_(keeps), options_(options), chains_(sides_), ways_(sides_) {
    make_sides(domain, divided);
    for (const sketch::Curve& curve : domain.curves)
      bent_.push_back(std::holds_alternative<dobra::geom::Polyline>(curve.shape) ? 0 : 1);
    std::vector<Box> boxes;
    for (const Side& side : sides_) boxes.push_back(side.segment.box());
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  NarrowPlaces run() {
    std::vector<std::size_t> beside;
    const dobra::geom::SpatialIndex only(options_.only);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Segment& side = sides_[i].segment;
      if (!(side.length() > 0.0)) continue;
      if (!options_.only.empty() && !touches(only, side.box())) continue;
      beside.clear();
      const double reach = std::max(reach_of(side.length()), wide_reach_of(side));
      index_.for_each_overlapping(side.box().grown(reach), [&](std::size_t j) {
        if (!adjacent(sides_[i], sides_[j]) && narrow(i, j, side)) beside.push_back(j);
      });
      if (beside.empty()) continue;
      std::sort(beside.begin(), beside.end());
      if (keeps(i)) {
        keep(i, beside);
      } else {
        ask(i, sides_[i].segment, beside);
      }
    }
    ask_points();
    for (const auto& [curve, left] : kept_) places_.kept.push_back(left);
    for (const auto& [curve, left] : slight_) places_.slight.push_back(left);
    return std::move(places_);
  }

 private:
  void make_sides(const domain::Domain& domain, const MeshInput& divided) {
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
    for (const domain::Domain::Loop& loop : domain.loops) {
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

  static bool touches(const dobra::geom::SpatialIndex& index, const Box& box) {
    bool found = false;
    index.for_each_overlapping(box, [&](std::size_t) {
      found = true;
      return dobra::geom::Visit::Stop;
    });
    return found;
  }
  [[nodiscard]] bool bent(std::size_t side) const {
    return sides_[side].curve < bent_.size() && bent_[sides_[side].curve] != 0;
  }

  /// Below this distance something is too near to a part of a side of this length.
  [[nodiscard]] double reach_of(double length) const { return length * found_at() / options_.enough; }
  [[nodiscard]] double found_at() const { return std::min(1.0, options_.across); }
  /// The same where more elements than one are wanted across: as far as elements are larger than the place elsewhere.
  [[nodiscard]] double wide_reach_of(const Segment& part) const {
    if (!(options_.across > 1.0) || !options_.size) return 0.0;
    return std::min(options_.across * part.length(), options_.size(midpoint(part.from, part.to))) / options_.enough;
  }
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

  /// How near side j comes to a part of side i, if that makes a narrow place.
  std::optional<Near> narrow(std::size_t i, std::size_t j, const Segment& part) {
    const Near near = nearest(part, sides_[j].segment);
    if (!(near.distance > 0.0)) return std::nullopt;
    if (near.distance >= reach_of(part.length()) &&
        (near.distance >= wide_reach_of(part) || round_a_corner(i, j, near))) {
      return std::nullopt;
    }
    if (!through_material(sides_[i], near.here, near.there)) return std::nullopt;
    if (!through_material(sides_[j], near.there, near.here)) return std::nullopt;
    // Beside what stays coarse finer sides are of no use.
    if (keeps(j) && !keeps(i) && near.distance < reach_of(sides_[j].segment.length())) return std::nullopt;
    if (chains_.wedge(i, j, near, options_.input_angle.radians())) return std::nullopt;
    return near;
  }

  void ask(std::size_t i, const Segment& part, const std::vector<std::size_t>& beside) {
    const double side = sides_[i].segment.length();
    const double least = std::min(options_.smallest * side, options_.floor);
    const double length = part.length();
    std::vector<std::size_t> near_ones;
    Near best{std::numeric_limits<double>::infinity(), {}, {}};
    std::size_t nearest_side = 0;
    for (const std::size_t j : beside) {
      const auto near = narrow(i, j, part);
      if (!near) continue;
      near_ones.push_back(j);
      if (near->distance >= best.distance) continue;
      best = *near;
      nearest_side = j;
    }
    if (near_ones.empty()) return;
    const bool slight = length < least || std::any_of(near_ones.begin(), near_ones.end(), [&](std::size_t j) {
                          const Segment& other = sides_[j].segment;
                          return distance(other, part.from) < least && distance(other, part.to) < least;
                        });
    if (slight) {
      places_.again.push_back(part.box().grown(best.distance));
      if (best.distance < least) leave(slight_, i, nearest_side, best);
      return;
    }
    // Half of it would be short enough.
    if (length * found_at() <= 2.0 * options_.enough * best.distance && best.distance >= least) {
      places_.sizes.push_back({best.here, best.distance / found_at()});
      if (bent(i) || std::any_of(near_ones.begin(), near_ones.end(), [&](std::size_t j) { return bent(j); })) {
        places_.again.push_back(part.box().grown(best.distance));
      }
      if (options_.across > 1.0) ask_across(i, part, best.distance, near_ones);
      return;
    }
    const Point middle = midpoint(part.from, part.to);
    ask(i, {part.from, middle}, near_ones);
    ask(i, {middle, part.to}, near_ones);
  }

  /// Asks for several elements across a place of this width, beside a part that is about as long.
  void ask_across(std::size_t i, const Segment& part, double width, const std::vector<std::size_t>& beside) {
    const double spacing = 2.0 * options_.enough;  // in sizes: they grow between
    const auto pieces = static_cast<std::size_t>(std::ceil(options_.across * part.length() / (spacing * width)));
    const auto end = [&](std::size_t k) {
      return interpolate(part.from, part.to, static_cast<double>(k) / static_cast<double>(pieces));
    };
    for (std::size_t k = 0; k < pieces; ++k) {
      Near best{std::numeric_limits<double>::infinity(), {}, {}};
      for (const std::size_t j : beside) {
        const Near near = nearest({end(k), end(k + 1)}, sides_[j].segment);
        if (near.distance > 0.0 && near.distance < best.distance && !round_a_corner(i, j, near)) best = near;
      }
      if (!std::isfinite(best.distance)) continue;
      const auto steps = static_cast<std::size_t>(std::ceil(options_.across / spacing));
      for (std::size_t step = 0; step < steps; ++step) {
        const double f = static_cast<double>(step) / static_cast<double>(steps);
        places_.sizes.push_back({interpolate(best.here, best.there, f), best.distance / options_.across});
      }
    }
  }

  /// Whether the way along the curves is not much longer than the straight one: round a bend or a corner there is no
  /// width to count elements across.
  bool round_a_corner(std::size_t i, std::size_t j, const Near& near) {
    constexpr double much = 3.0;  // 2.9 at a corner of 40 degrees, between places as far from it
    return ways_.along(i, near.here, j, near.there) < much * near.distance ||
           chains_.wedge(i, j, near, std::numbers::pi);
  }

  /// Points that no side passes through ask for their distance to the nearest other one.
  void ask_points() {
    if (!options_.points || !options_.size) return;
    std::vector<std::size_t> points;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (sides_[i].from != sides_[i].to) continue;
      points.push_back(i);
      boxes.push_back(sides_[i].segment.box());
    }
    const dobra::geom::SpatialIndex index(boxes);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point p = sides_[points[k]].segment.from;
      const auto other = index.nearest(
          p,
          [&](std::size_t m) {
            return m == k ? std::numeric_limits<double>::infinity() : distance(p, sides_[points[m]].segment.from);
          },
          reach_of(options_.size(p)));
      if (other && other->distance > 0.0) places_.sizes.push_back({p, other->distance / options_.across});
    }
  }

  void keep(std::size_t i, const std::vector<std::size_t>& beside) {
    for (const std::size_t j : beside) {
      const Near near = nearest(sides_[i].segment, sides_[j].segment);
      if (near.distance < reach_of(sides_[i].segment.length())) leave(kept_, i, j, near);
    }
  }

  void leave(std::map<std::size_t, NarrowPlaces::Left>& left, std::size_t i, std::size_t j, const Near& near) {
    const Side& side = sides_[i];
    const NarrowPlaces::Left found{side.curve, sides_[j].curve, near.here, near.distance, side.segment.length()};
    const auto [entry, is_new] = left.try_emplace(side.curve, found);
    if (!is_new && found.width * entry->second.side < entry->second.width * found.side) entry->second = found;
  }

  std::span<const std::uint8_t> keeps_;
  const NarrowOptions& options_;
  std::vector<Side> sides_;
  std::vector<std::uint8_t> bent_;  ///< One a curve.
  dobra::geom::SpatialIndex index_;
  Chains chains_;
  Ways ways_;
  NarrowPlaces places_;
  std::map<std::size_t, NarrowPlaces::Left> kept_, slight_;
};

}  // namespace

NarrowPlaces narrow_places(const domain::Domain& domain, const MeshInput& divided, std::span<const std::uint8_t> keeps,
                           const NarrowOptions& options) {
  if (!(options.across > 0.0)) return {};
  return Finder(domain, divided, keeps, options).run();
}

}  // namespace quebra::meshing
