#include "shared/solid/windings.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

#include "shared/base/check.h"
#include "shared/solid/line_along_x.h"

namespace dobra::solid {
namespace {

using geom::Sign;

/// The normals of the cells round one edge, turned so that normal x edge points into the cell; in the plane across the
/// axis along which the edge is longest, so that their order round the edge is one of plane vectors.
class Fan {
 public:
  Fan(const Soup& soup, const Cells& cells, const std::vector<std::uint32_t>& halves) {
    const CellHalf& half = cells.halves[halves[0]];
    const PointId p = half.origin;
    const PointId q = cells.target(halves[0]);
    const PointId a = std::min(p, q);
    const PointId b = std::max(p, q);
    double longest = -1.0;
    Sign along = Sign::Zero;
    for (int axis = 0; axis < 3; ++axis) {
      const auto order = soup.space.compare(axis, b, a);
      const double length = std::abs(soup.space.coordinate(b, axis) - soup.space.coordinate(a, axis));
      if (order == std::strong_ordering::equal || length <= longest) continue;
      longest = length;
      axis_ = axis;
      along = order == std::strong_ordering::greater ? Sign::Positive : Sign::Negative;
    }
    DOBRA_CHECK(along != Sign::Zero);
    auto u = static_cast<std::size_t>((axis_ + 1) % 3);
    auto v = static_cast<std::size_t>((axis_ + 2) % 3);
    if (along == Sign::Negative) std::swap(u, v);
    for (const std::uint32_t h : halves) {
      const PlaneId plane = soup.facets[cells.cells[cells.halves[h].cell.index()].facet].plane;
      const Dyadic3& n = soup.space.normal(plane);
      const bool keep = upper_side_follows(cells, h);
      arms_.push_back({h, keep ? n[u] : -n[u], keep ? n[v] : -n[v], keep ? Sign::Positive : Sign::Negative, plane});
    }
    std::sort(arms_.begin(), arms_.end(), [](const Arm& s, const Arm& t) {
      const bool lower_s = s.lower();
      const bool lower_t = t.lower();
      if (lower_s != lower_t) return lower_t;
      const Sign turn = s.turn(t);
      return turn != Sign::Zero ? turn == Sign::Positive : s.half < t.half;
    });
  }

  struct Arm {
    std::uint32_t half;
    Dyadic u, v;
    Sign upright;  // whether the normal is the plane's
    PlaneId plane;

    [[nodiscard]] bool lower() const { return v.sign() == Sign::Negative || (v.zero() && u.sign() == Sign::Negative); }
    [[nodiscard]] Sign turn(const Arm& other) const { return (u * other.v - v * other.u).sign(); }
    /// On which side of the arm the direction (0, 1, e) + (e^2, 0, 0) is, for e infinitely small.
    [[nodiscard]] Sign side_of_seed(const Space& space) const {
      for (const int axis : {1, 2, 0}) {
        const Sign sign = space.normal_sign(plane, axis);
        if (sign != Sign::Zero) return sign * upright;
      }
      return Sign::Zero;
    }
  };
  [[nodiscard]] const std::vector<Arm>& arms() const { return arms_; }

 private:
  int axis_ = 0;
  std::vector<Arm> arms_;
};

std::vector<std::uint32_t> halves_at(const Fans& fans, std::uint32_t first) {
  std::vector<std::uint32_t> halves;
  std::uint32_t h = first;
  do {
    halves.push_back(h);
    h = fans.turned[h];
  } while (h != first);
  return halves;
}

/// The half after which the seed's direction comes, anticlockwise.
std::uint32_t half_before_seed(const Soup& soup, const Fan& fan) {
  const auto& arms = fan.arms();
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Fan::Arm& from = arms[i];
    const Fan::Arm& to = arms[(i + 1) % arms.size()];
    if (arms.size() == 1) return from.half;
    const bool left_of_from = from.side_of_seed(soup.space) == Sign::Positive;
    const bool right_of_to = to.side_of_seed(soup.space) == Sign::Negative;
    Sign turn = from.turn(to);
    // The way round from the last to the first is the whole turn if all point one way, which cells do not.
    const bool opposite = turn == Sign::Zero;
    if (opposite ? left_of_from : turn == Sign::Positive ? left_of_from && right_of_to : left_of_from || right_of_to) {
      return from.half;
    }
  }
  DOBRA_CHECK(false);  // the directions go all the way round
  return none;
}

/// Numbers for vectors of windings, and what they become on the way through a cell.
class Kinds {
 public:
  explicit Kinds(std::vector<Windings>& kinds) : kinds_(kinds) {}
  std::uint32_t number(const Windings& windings) {
    const auto [at, fresh] = numbers_.try_emplace(windings, static_cast<std::uint32_t>(kinds_.size()));
    if (fresh) kinds_.push_back(windings);
    return at->second;
  }
  /// From above the cell to below it, or back.
  std::uint32_t through(std::uint32_t from, const Soup& soup, std::span<const Cover> covers, bool downwards) {
    const bool one = covers.size() == 1;
    const std::uint64_t key = one ? (std::uint64_t{from} << 32U) |
                                        (std::uint64_t{soup.facets[covers[0].facet].operand} << 1U) |
                                        (covers[0].turned != downwards ? 1U : 0U)
                                  : 0;
    if (one) {
      const auto known = steps_.find(key);
      if (known != steps_.end()) return known->second;
    }
    Windings windings = kinds_[from];
    for (const Cover& cover : covers) {
      add_step(windings, soup.facets[cover.facet].operand, cover.turned != downwards ? 1 : -1);
    }
    const std::uint32_t to = number(windings);
    if (one) steps_.emplace(key, to);
    return to;
  }

 private:
  std::vector<Windings>& kinds_;
  std::map<Windings, std::uint32_t> numbers_;
  std::unordered_map<std::uint64_t, std::uint32_t> steps_;
};

}  // namespace

Fans fans(const Soup& soup, const Cells& cells) {
  struct Entry {
    PointId a, b;
    std::uint32_t half;
  };
  // By a, then by b, then by half: there are few at each point.
  const auto lesser = [&](std::uint32_t h) { return std::min(cells.halves[h].origin, cells.target(h)); };
  std::vector<std::uint32_t> start(soup.space.point_count() + 1, 0);
  for (std::uint32_t h = 0; h < cells.halves.size(); ++h) ++start[lesser(h).index() + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> at(start.begin(), start.end() - 1);
  std::vector<Entry> entries(cells.halves.size());
  for (std::uint32_t h = 0; h < cells.halves.size(); ++h) {
    const PointId a = lesser(h);
    entries[at[a.index()]++] = {a, std::max(cells.halves[h].origin, cells.target(h)), h};
  }
  for (std::size_t p = 0; p + 1 < start.size(); ++p) {
    std::sort(entries.begin() + start[p], entries.begin() + start[p + 1],
              [](const Entry& s, const Entry& t) { return std::tie(s.b, s.half) < std::tie(t.b, t.half); });
  }
  Fans fans;
  fans.turned.resize(cells.halves.size());
  std::vector<std::uint32_t> group;
  for (std::size_t i = 0; i < entries.size();) {
    const Entry& edge = entries[i];
    group.clear();
    for (; i < entries.size() && entries[i].a == edge.a && entries[i].b == edge.b; ++i)
      group.push_back(entries[i].half);
    if (group.size() > 2) {
      const Fan fan(soup, cells, group);
      for (std::size_t k = 0; k < group.size(); ++k) group[k] = fan.arms()[k].half;
    }
    for (std::size_t k = 0; k < group.size(); ++k) fans.turned[group[k]] = group[(k + 1) % group.size()];
    fans.first.push_back(group[0]);
  }
  return fans;
}

std::optional<std::uint32_t> open_half(const Soup& soup, const Cells& cells, const Fans& fans) {
  for (const std::uint32_t first : fans.first) {
    Windings sum;
    std::uint32_t h = first;
    do {
      const bool rising = upper_side_follows(cells, h);
      for (const Cover& cover : cells.covers_of(cells.cells[cells.halves[h].cell.index()])) {
        add_step(sum, soup.facets[cover.facet].operand, cover.turned != rising ? 1 : -1);
      }
      h = fans.turned[h];
    } while (h != first);
    if (!sum.empty()) return first;
  }
  return std::nullopt;
}

Sides sides(const Soup& soup, const Cells& cells, const Fans& fans, const std::vector<BoxTree>& trees) {
  Sides sides;
  Kinds kinds(sides.kinds);
  sides.above.assign(cells.cells.size(), none);
  sides.below.assign(cells.cells.size(), none);
  const auto set = [&](CellId cell, bool upper, std::uint32_t kind) {
    std::uint32_t& above = sides.above[cell.index()];
    std::uint32_t& below = sides.below[cell.index()];
    if (above != none) {
      DOBRA_CHECK((upper ? above : below) == kind);  // every way through the arrangement says the same
      return false;
    }
    const std::uint32_t other = kinds.through(kind, soup, cells.covers_of(cells.cells[cell.index()]), upper);
    above = upper ? kind : other;
    below = upper ? other : kind;
    return true;
  };
  std::vector<std::uint32_t> queue;
  for (std::uint32_t start = 0; start < cells.cells.size(); ++start) {
    if (sides.above[start] != none) continue;
    const std::uint32_t first = cells.cells[start].first_half;
    const Fan fan(soup, cells, halves_at(fans, first));
    const std::uint32_t before = half_before_seed(soup, fan);
    const Homogeneous middle = soup.space.middle(cells.halves[first].origin, cells.target(first));
    const std::uint32_t kind = kinds.number(LineAlongX(soup, middle).windings(trees));
    const CellId cell = cells.halves[before].cell;
    set(cell, upper_side_follows(cells, before), kind);
    queue.push_back(static_cast<std::uint32_t>(cell.index()));
    while (!queue.empty()) {
      const std::uint32_t at = queue.back();
      queue.pop_back();
      for (std::uint32_t h = cells.cells[at].first_half; h < cells.cells[at].half_end; ++h) {
        const std::uint32_t g = fans.turned[h];
        const CellId next = cells.halves[g].cell;
        const std::uint32_t between = upper_side_follows(cells, h) ? sides.above[at] : sides.below[at];
        if (set(next, !upper_side_follows(cells, g), between)) {
          queue.push_back(static_cast<std::uint32_t>(next.index()));
        }
      }
    }
  }
  return sides;
}

}  // namespace dobra::solid
