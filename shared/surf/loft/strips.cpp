// 1. Borders at faults, by rows over the sections that both have.
// 2. Matched from the nearest; each pair gives a strip: chords from border to border, their inner points on the fault.
// 3. What is left of one horizon is matched with what is left of the other; the rest is told.
#include "shared/surf/loft/strips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "shared/geom/box.h"
#include "shared/surf/loft/ends.h"

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

constexpr std::size_t chords = 16;  // from border to border

double plan_of(Point3 a, Point3 b, Point3 c) { return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)); }

/// -1: its chart is clockwise on the map.
double turn_of(const Patch& patch) {
  double plan = 0.0;
  for (const auto& t : patch.triangles) plan += plan_of(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
  return plan < 0.0 ? -1.0 : 1.0;
}

struct FaultBorder {
  const Patch* patch = nullptr;
  bool high = false;
  bool used = false;
  [[nodiscard]] const std::string& fault() const { return high ? patch->high_fault : patch->low_fault; }
};

/// Sections that two patches share: their numbers in each.
struct Shared {
  std::vector<std::size_t> in_first, in_second;
};
Shared shared_sections(const Patch& a, const Patch& b) {
  Shared shared;
  auto from = b.sections.begin();
  for (std::size_t i = 0; i < a.sections.size(); ++i) {
    const auto found = std::find(from, b.sections.end(), a.sections[i]);
    if (found == b.sections.end()) continue;
    shared.in_first.push_back(i);
    shared.in_second.push_back(static_cast<std::size_t>(found - b.sections.begin()));
    from = found + 1;
  }
  return shared;
}

/// Points of a border by the number of their section, and the part of the way to the next.
struct BorderLine {
  std::vector<double> t;
  std::vector<Point3> points;
  [[nodiscard]] Point3 at(double value) const {
    const auto after = std::upper_bound(t.begin() + 1, t.end() - 1, value);
    const auto k = static_cast<std::size_t>(after - t.begin());
    const double part = std::clamp((value - t[k - 1]) / (t[k] - t[k - 1]), 0.0, 1.0);
    return points[k - 1] + part * (points[k] - points[k - 1]);
  }
};

/// @param which  numbers of sections of the patch, rising
BorderLine border_line(const FaultBorder& border, const std::vector<std::size_t>& which) {
  const Patch& patch = *border.patch;
  std::vector<double> v;
  for (const std::size_t number : which) v.push_back(patch.sections_v[number]);
  BorderLine line;
  const std::size_t row = border.high ? (patch.u.size() - 1) * patch.v.size() : 0;
  std::size_t k = 0;
  for (std::size_t j = 0; j < patch.v.size(); ++j) {
    if (patch.v[j] < v.front() || patch.v[j] > v.back()) continue;
    while (k + 2 < v.size() && patch.v[j] >= v[k + 1]) ++k;
    line.t.push_back(static_cast<double>(k) + (patch.v[j] - v[k]) / (v[k + 1] - v[k]));
    line.points.push_back(patch.points[row + j]);
  }
  return line;
}

BorderLine border_line(const FaultBorder& border, std::size_t first, std::size_t count) {
  std::vector<std::size_t> which(count);
  std::iota(which.begin(), which.end(), first);
  return border_line(border, which);
}

struct BorderPair {
  FaultBorder* first = nullptr;
  FaultBorder* second = nullptr;
  Shared shared;
  BorderLine from, to;
  double apart = 0.0;  // in the mean
};

std::optional<BorderPair> pair_of(FaultBorder& a, FaultBorder& b) {
  const Shared shared = shared_sections(*a.patch, *b.patch);
  if (shared.in_first.size() < 2) return std::nullopt;
  BorderPair pair{&a, &b, shared, border_line(a, shared.in_first), border_line(b, shared.in_second), 0.0};
  for (std::size_t i = 0; i < pair.from.t.size(); ++i)
    pair.apart +=
        geom::distance(pair.from.points[i], pair.to.at(pair.from.t[i])) / static_cast<double>(pair.from.t.size());
  return pair;
}

/// Borders of the one kind with borders of the other, each once, the nearest first.
template <class Fits>
std::vector<BorderPair> matched(std::vector<FaultBorder>& a, std::vector<FaultBorder>& b, Fits&& fits) {
  std::vector<BorderPair> all, made;
  for (FaultBorder& first : a) {
    for (FaultBorder& second : b) {
      if (first.used || second.used || first.fault() != second.fault() || !fits(first, second)) continue;
      if (auto pair = pair_of(first, second)) all.push_back(std::move(*pair));
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const BorderPair& p, const BorderPair& q) { return p.apart < q.apart; });
  for (BorderPair& pair : all) {
    if (pair.first->used || pair.second->used) continue;
    pair.first->used = pair.second->used = true;
    made.push_back(std::move(pair));
  }
  return made;
}

/// The triangles of a fault whose boxes come near the points.
NamedSurface beside(const NamedSurface& fault, const std::vector<Point3>& points, double reach) {
  Point3 low = points.front(), high = low;
  for (const Point3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  NamedSurface near = fault;
  for (Patch& patch : near.patches) {
    std::erase_if(patch.triangles, [&](const auto& t) {
      const auto apart = [&](auto&& of, double from, double to) {
        const double a = of(patch.points[t[0]]), b = of(patch.points[t[1]]), c = of(patch.points[t[2]]);
        return std::min({a, b, c}) > to + reach || std::max({a, b, c}) < from - reach;
      };
      return apart([](Point3 p) { return p.x; }, low.x, high.x) || apart([](Point3 p) { return p.y; }, low.y, high.y) ||
             apart([](Point3 p) { return p.z; }, low.z, high.z);
    });
  }
  return near;
}

/// Seen along the chart of the first border's patch: `from` lies before `to`.
std::vector<StripTriangle> strip_of(const BorderPair& pair, const NamedSurface* fault) {
  std::vector<double> t = pair.from.t;
  t.insert(t.end(), pair.to.t.begin(), pair.to.t.end());
  std::sort(t.begin(), t.end());
  t.erase(std::unique(t.begin(), t.end(), [](double a, double b) { return b - a <= 1e-12; }), t.end());
  std::vector<Point3> from, to, all;
  double reach = 0.0;
  for (const double at : t) {
    from.push_back(pair.from.at(at));
    to.push_back(pair.to.at(at));
    reach = std::max(reach, 0.5 * geom::distance(from.back(), to.back()));
  }
  all = from;
  all.insert(all.end(), to.begin(), to.end());
  std::optional<NamedSurface> near;
  if (fault != nullptr) near = beside(*fault, all, reach);
  std::vector<Point3> grid;  // the way across runs fastest
  for (std::size_t j = 0; j < t.size(); ++j) {
    const std::size_t before = j > 0 ? j - 1 : 0, behind = std::min(j + 1, t.size() - 1);
    const Vector3 way = to[j] - from[j];
    const Vector3 normal = geom::cross(way, (from[behind] - from[before]) + (to[behind] - to[before]));
    for (std::size_t k = 0; k <= chords; ++k) {
      Point3 p = k == chords ? to[j] : from[j] + (static_cast<double>(k) / chords) * way;
      if (k > 0 && k < chords && near && geom::length(normal) > 0.0) {
        const Vector3 off = geom::normalised(normal);
        if (const auto away = meeting_along(*near, p, off, 0.5 * geom::length(way))) p = p + *away * off;
      }
      grid.push_back(p);
    }
  }
  std::vector<StripTriangle> strip;
  for (std::size_t j = 0; j + 1 < t.size(); ++j) {
    for (std::size_t k = 0; k < chords; ++k) {
      const std::size_t a = j * (chords + 1) + k, b = a + 1, d = a + chords + 1, c = d + 1;
      strip.push_back({grid[a], grid[b], grid[c]});
      strip.push_back({grid[a], grid[c], grid[d]});
    }
  }
  return strip;
}

void turn_over(StripTriangle& t) { std::swap(t[1], t[2]); }

class Stripping {
 public:
  Stripping(const NamedSurface& upper, const NamedSurface& lower, const std::vector<NamedSurface>& surfaces)
      : upper_(upper), lower_(lower), surfaces_(surfaces) {}

  Strips run() {
    std::vector<FaultBorder> of_upper = close(upper_, made_.upper), of_lower = close(lower_, made_.lower);
    const auto one_side = [](const FaultBorder& a, const FaultBorder& b) { return a.high == b.high; };
    for (const BorderPair& pair : matched(of_upper, of_lower, one_side)) {
      const bool turned = (turn_of(*pair.first->patch) < 0.0) == pair.first->high;
      for (StripTriangle t : strip_of(pair, fault(pair.first->fault()))) {
        if (turned) turn_over(t);
        if (plan_of(t[0], t[1], t[2]) < 0.0) {
          turn_over(t);
          made_.lower.push_back(t);
        } else {
          made_.upper.push_back(t);
        }
      }
      tell_rest(pair, lower_, upper_);
    }
    tell_alone(upper_, of_upper, lower_);
    tell_alone(lower_, of_lower, upper_);
    tell_unjoined();
    return std::move(made_);
  }

 private:
  [[nodiscard]] const NamedSurface* fault(const std::string& name) const {
    const auto found = std::find_if(surfaces_.begin(), surfaces_.end(),
                                    [&](const NamedSurface& s) { return s.kind == LineKind::Fault && s.name == name; });
    return found == surfaces_.end() ? nullptr : &*found;
  }

  static std::vector<FaultBorder> borders_of(const NamedSurface& horizon) {
    std::vector<FaultBorder> borders;
    for (const Patch& patch : horizon.patches) {
      if (patch.sections_v.empty()) continue;
      if (!patch.low_fault.empty()) borders.push_back({&patch, false, false});
      if (!patch.high_fault.empty()) borders.push_back({&patch, true, false});
    }
    return borders;
  }

  std::vector<FaultBorder> close(const NamedSurface& horizon, std::vector<StripTriangle>& strips) {
    std::vector<FaultBorder> borders = borders_of(horizon);
    const auto across = [](const FaultBorder& a, const FaultBorder& b) { return a.high && !b.high; };
    for (const BorderPair& pair : matched(borders, borders, across)) {
      const bool turned = turn_of(*pair.first->patch) < 0.0;
      for (StripTriangle t : strip_of(pair, fault(pair.first->fault()))) {
        if (turned) turn_over(t);
        strips.push_back(t);
      }
      const NamedSurface& other = &horizon == &upper_ ? lower_ : upper_;
      tell_rest(pair, other, other);
    }
    return borders;
  }

  void tell(const FaultBorder& border, const std::string& message) {
    const BorderLine line = border_line(border, 0, border.patch->sections_v.size());
    const Point3 at = line.points[line.points.size() / 2];
    made_.findings.push_back({"volume_at_fault",
                              message,
                              {.item = fmt::format("fault '{}'", border.fault()), .x = at.x, .y = at.y, .z = at.z}});
  }

  /// Sections where a border has no partner.
  /// @param below_first, below_second  the horizon on the other side of what each border bounds
  void tell_rest(const BorderPair& pair, const NamedSurface& below_first, const NamedSurface& below_second) {
    for (const FaultBorder* border : {pair.first, pair.second}) {
      const std::size_t all = border->patch->sections.size(), shared = pair.shared.in_first.size();
      const auto& which = border == pair.first ? pair.shared.in_first : pair.shared.in_second;
      const std::size_t from = which.front(), to = which.back() + 1;
      if (from == 0 && to == all) continue;
      const bool first = border == pair.first;
      const NamedSurface& other = first ? below_first : below_second;
      double most = 0.0;
      if (from > 0) most += wedge(*border, 0, from + 1, other);
      if (to < all) most += wedge(*border, to - 1, all - to + 1, other);
      made_.unsure += most;
      tell(*border,
           fmt::format("between '{}' and '{}' a piece at fault '{}' is on {} sections and its partner on {} of "
                       "them; beyond these the volume is that over the map, not up to the fault",
                       upper_.name, lower_.name, border->fault(), all, shared) +
               (most > 0.0 ? fmt::format(", and differs by less than {:.6g} m3 from that", most) : ""));
    }
  }

  /// Bounds what lies between the upright below a border and its fault, gone on to the other horizon: as long as the
  /// border, as wide as the fault goes sideways over the heights between, and as high as these. 0 without such.
  [[nodiscard]] double wedge(const FaultBorder& border, std::size_t first, std::size_t count,
                             const NamedSurface& other) const {
    const NamedSurface* along = fault(border.fault());
    if (along == nullptr) return 0.0;
    double sideways = 0.0;  // for a metre of depth
    for (const Patch& patch : along->patches) {
      for (const auto& t : patch.triangles) {
        const Vector3 n = geom::cross(patch.points[t[1]] - patch.points[t[0]], patch.points[t[2]] - patch.points[t[0]]);
        sideways = std::max(sideways, std::abs(n.z) / std::hypot(n.x, n.y));
      }
    }
    if (sideways <= 1e-9) return 0.0;  // upright
    const BorderLine line = border_line(border, first, count);
    geom::Box box;
    double stretch = 0.0, low = INFINITY, high = -INFINITY;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Point3 p = line.points[i];
      box.add(Point{p.x, p.y});
      low = std::min(low, p.z), high = std::max(high, p.z);
      if (i > 0) stretch += std::hypot(p.x - line.points[i - 1].x, p.y - line.points[i - 1].y);
    }
    // How wide is not known before how high is; nothing is wider than the other horizon.
    geom::Box all;
    for (const Patch& patch : other.patches) {
      for (const Point3 p : patch.points) all.add(Point{p.x, p.y});
    }
    double wide = 0.0, of_heights = 0.0;
    for (int round = 0; round < 3; ++round) {
      geom::Box near{{box.low.x - wide, box.low.y - wide}, {box.high.x + wide, box.high.y + wide}};
      double least = low, most = high;
      bool any = false;
      for (const Patch& patch : other.patches) {
        for (const auto& t : patch.triangles) {
          geom::Box of;
          for (const std::uint32_t k : t) of.add(Point{patch.points[k].x, patch.points[k].y});
          if (!of.overlaps(near)) continue;
          any = true;
          for (const std::uint32_t k : t) {
            least = std::min(least, patch.points[k].z);
            most = std::max(most, patch.points[k].z);
          }
        }
      }
      if (!any) return 0.0;
      of_heights = most - least;
      wide = std::min(sideways * of_heights, all.diagonal());
    }
    return stretch * wide * of_heights;
  }

  /// Between sections where a line is in other pieces on the one than on the other no surface is laid.
  void tell_unjoined() {
    for (const NamedSurface* horizon : {&upper_, &lower_}) {
      for (const Unjoined& gap : horizon->unjoined) {
        double plan = gap.plan;
        bool counted = false;
        if (horizon == &lower_) {  // counted with the upper one
          for (const Unjoined& other : upper_.unjoined) {
            if (other.first != gap.first || other.second != gap.second) continue;
            plan = std::max(0.0, plan - other.plan);
            counted = true;
          }
        }
        geom::Box box;
        Point3 middle{};
        double low = INFINITY, high = -INFINITY;
        for (const Point3 p : gap.points) {
          box.add(Point{p.x, p.y});
          low = std::min(low, p.z), high = std::max(high, p.z);
          middle = middle + (1.0 / static_cast<double>(gap.points.size())) * (p - Point3{});
        }
        for (const NamedSurface* of : {&upper_, &lower_}) {
          const auto count = [&](Point3 p) {
            if (p.x < box.low.x || p.x > box.high.x || p.y < box.low.y || p.y > box.high.y) return;
            low = std::min(low, p.z), high = std::max(high, p.z);
          };
          for (const Patch& patch : of->patches) std::for_each(patch.points.begin(), patch.points.end(), count);
          for (const Unjoined& other : of->unjoined) {
            if (other.first != gap.first || other.second != gap.second) continue;
            for (const Point3 p : other.points) low = std::min(low, p.z), high = std::max(high, p.z);
          }
        }
        const double most = plan * (high - low);
        if (most <= 0.0 && !counted) continue;
        made_.unsure += most;
        made_.findings.push_back(
            {"volume_at_fault",
             most > 0.0
                 ? fmt::format("'{}' is in other pieces in section '{}' than in '{}', and nothing joins them; the "
                               "volume between '{}' and '{}' leaves out less than {:.6g} m3 there; draw the faults to "
                               "the same depth in both",
                               horizon->name, gap.first, gap.second, upper_.name, lower_.name, most)
                 : fmt::format(
                       "'{}' is in other pieces in section '{}' than in '{}', and nothing joins them; what the "
                       "volume leaves out there is counted with '{}'; draw the faults to the same depth in both",
                       horizon->name, gap.first, gap.second, upper_.name),
             {.item = fmt::format("horizon '{}'", horizon->name), .x = middle.x, .y = middle.y, .z = middle.z}});
      }
    }
  }

  void tell_alone(const NamedSurface& horizon, std::vector<FaultBorder>& borders, const NamedSurface& other) {
    for (FaultBorder& border : borders) {
      if (border.used) continue;
      double most = 0.0;
      for (FaultBorder& across : of_other(other, border)) {
        if (const auto pair = pair_of(border, across)) most += bound(strip_of(*pair, fault(border.fault())));
      }
      made_.unsure += most;
      if (most > 0.0) {
        tell(border,
             fmt::format("'{}' ends at fault '{}' and is not on its other side, where '{}' is; the volume between "
                         "them is that over the map, and differs by less than {:.6g} m3 from that up to the fault",
                         horizon.name, border.fault(), other.name, most));
      } else {
        const double below = wedge(border, 0, border.patch->sections_v.size(), other);
        made_.unsure += below;
        tell(border,
             fmt::format("'{}' ends at fault '{}' and is not on its other side, and '{}' does not end there; the "
                         "volume between them is that over the map",
                         horizon.name, border.fault(), other.name) +
                 (below > 0.0 ? fmt::format(", and differs by less than {:.6g} m3 from that up to the fault", below)
                              : ""));
      }
    }
  }
  static std::vector<FaultBorder> of_other(const NamedSurface& other, const FaultBorder& like) {
    std::vector<FaultBorder> borders = borders_of(other);
    std::erase_if(borders, [&](const FaultBorder& b) { return b.fault() != like.fault() || b.high != like.high; });
    return borders;
  }

  /// Over the strip's map a height is wrong by less than all heights there differ.
  [[nodiscard]] double bound(const std::vector<StripTriangle>& strip) const {
    geom::Box box;
    double plan = 0.0, low = INFINITY, high = -INFINITY;
    for (const StripTriangle& t : strip) {
      plan += std::abs(plan_of(t[0], t[1], t[2]));
      for (const Point3 p : t) box.add(Point{p.x, p.y});
    }
    const auto count = [&](Point3 a, Point3 b, Point3 c) {
      geom::Box of;
      for (const Point3 p : {a, b, c}) of.add(Point{p.x, p.y});
      if (!of.overlaps(box)) return;
      low = std::min({low, a.z, b.z, c.z}), high = std::max({high, a.z, b.z, c.z});
    };
    for (const auto* triangles : {&strip, &made_.upper, &made_.lower}) {
      for (const StripTriangle& t : *triangles) count(t[0], t[1], t[2]);
    }
    for (const NamedSurface* horizon : {&upper_, &lower_}) {
      for (const Patch& patch : horizon->patches) {
        for (const auto& t : patch.triangles) count(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
      }
    }
    return plan * (high - low);
  }

  const NamedSurface &upper_, &lower_;
  const std::vector<NamedSurface>& surfaces_;
  Strips made_;
};

}  // namespace

Strips strips_between(const NamedSurface& upper, const NamedSurface& lower, const std::vector<NamedSurface>& surfaces) {
  return Stripping(upper, lower, surfaces).run();
}

}  // namespace dobra::surf::loft
