#include "shared/solid/shape/section_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "shared/geom/predicates.h"

namespace dobra::solid::shape {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Sign;

struct PointLess {
  bool operator()(Point a, Point b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

std::string called(const std::string& region) { return region.empty() ? "outside" : fmt::format("'{}'", region); }

/// Whether the direction from `at` to a comes before the one to b, anticlockwise from that of the x axis; exact.
bool turns_before(Point at, Point a, Point b) {
  const auto half = [&](Point p) { return p.y > at.y || (p.y == at.y && p.x > at.x) ? 0 : 1; };
  if (half(a) != half(b)) return half(a) < half(b);
  return geom::orient2d(at, a, b) == Sign::Positive;
}

class MapMaker {
 public:
  MapMaker(const LoftSection& section, std::size_t number) : number_(number) {
    map_.frame = section.frame;
    map_.lines = section.lines;
  }

  Result<SectionMap> run() {
    for (const LoftLine& line : map_.lines) DOBRA_TRY_VOID(check(line));
    do {
      // Taking a line out may leave another one without a neighbour, or two that are one.
      while (take_out_ends() || join_pieces()) {
      }
      turn_islands();
      DOBRA_TRY_VOID(link());
    } while (take_out_bridges());
    DOBRA_TRY_VOID(find_regions());
    return std::move(map_);
  }

 private:
  [[nodiscard]] Error error(Point at, const std::string& what, ErrorCode code = ErrorCode::InvalidOption) const {
    return section_error(number_, map_.frame, at, what, code);
  }

  [[nodiscard]] Result<void> check(const LoftLine& line) const {
    const auto& points = line.line.points;
    const std::size_t least = line.line.closed ? 3 : 2;
    if (points.size() < least) {
      return error(points.empty() ? Point{} : points[0],
                   fmt::format("line '{}' has {} points and needs {} or more", line.name, points.size(), least),
                   ErrorCode::DegenerateCurve);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
        return error({}, fmt::format("line '{}' has no finite number at point {}", line.name, i + 1),
                     ErrorCode::NotFinite);
      const bool last = i + 1 == points.size();
      if (last && !line.line.closed) break;
      if (points[i] == points[last ? 0 : i + 1]) {
        return error(points[i], fmt::format("line '{}' has a point twice in a row; leave one out", line.name),
                     ErrorCode::DegenerateCurve);
      }
    }
    return {};
  }

  using Ends = std::map<Point, std::vector<Dart>, PointLess>;  // darts that leave

  [[nodiscard]] Ends ends() const {
    Ends ends;
    for (Dart d = 0; d < 2 * map_.lines.size(); ++d) {
      if (!map_.lines[d / 2].line.closed) ends[map_.origin(d)].push_back(d);
    }
    return ends;
  }

  void remove(const std::vector<char>& gone) {
    std::vector<LoftLine> kept;
    for (std::size_t i = 0; i < gone.size(); ++i) {
      if (gone[i] == 0) kept.push_back(std::move(map_.lines[i]));
    }
    map_.lines = std::move(kept);
  }

  /// Lines with an end where nothing else ends. @return whether there were any
  bool take_out_ends() {
    std::vector<char> gone(map_.lines.size(), 0);
    bool any = false;
    for (const auto& [at, darts] : ends()) {
      if (darts.size() != 1) continue;
      gone[darts[0] / 2] = 1;
      any = true;
    }
    if (any) remove(gone);
    return any;
  }

  /// Lines with one loop on both sides. @return whether there were any
  bool take_out_bridges() {
    std::vector<Dart> loop_of(map_.next.size(), none);
    for (Dart d = 0; d < loop_of.size(); ++d) {
      if (loop_of[d] != none) continue;
      for (const Dart e : map_.loop(d)) loop_of[e] = d;
    }
    std::vector<char> gone(map_.lines.size(), 0);
    for (std::size_t i = 0; i < gone.size(); ++i) gone[i] = loop_of[2 * i] == loop_of[2 * i + 1] ? 1 : 0;
    const bool any = std::find(gone.begin(), gone.end(), 1) != gone.end();
    if (any) remove(gone);
    return any;
  }

  /// Two lines of one name and with the same sides that meet where nothing else ends. @return whether there were any
  bool join_pieces() {
    bool any = false;
    std::vector<char> gone(map_.lines.size(), 0);
    std::vector<char> touched(map_.lines.size(), 0);
    for (const auto& [at, darts] : ends()) {
      if (darts.size() != 2) continue;
      const Dart in = twin(darts[0]);
      const Dart out = darts[1];
      if (touched[in / 2] != 0 || touched[out / 2] != 0) continue;
      if (in / 2 == out / 2) {
        LoftLine& line = map_.lines[in / 2];
        line.line.points.pop_back();
        line.line.closed = true;
        touched[in / 2] = 1;
        any = true;
        continue;
      }
      if (map_.lines[in / 2].name != map_.lines[out / 2].name || map_.left(in) != map_.left(out) ||
          map_.left(twin(in)) != map_.left(twin(out)))
        continue;
      touched[in / 2] = touched[out / 2] = 1;
      LoftLine first = along(in);
      const LoftLine second = along(out);
      first.line.points.insert(first.line.points.end(), second.line.points.begin() + 1, second.line.points.end());
      map_.lines[in / 2] = std::move(first);
      gone[out / 2] = 1;
      any = true;
    }
    remove(gone);
    return any;
  }

  /// The line as one looks along the dart.
  [[nodiscard]] LoftLine along(Dart d) const {
    LoftLine line = map_.lines[d / 2];
    if ((d & 1U) != 0) {
      line.line = geom::reversed(std::move(line.line));
      std::swap(line.left, line.right);
    }
    return line;
  }

  void turn_islands() {
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      if (map_.lines[i].line.closed && geom::signed_area(map_.lines[i].line) < 0.0)
        map_.lines[i] = along(static_cast<Dart>(2 * i + 1));
    }
  }

  /// The second point as one looks along the dart.
  [[nodiscard]] Point ahead(Dart d) const {
    const auto& points = map_.lines[d / 2].line.points;
    return (d & 1U) == 0 ? points[1] : points[points.size() - 2];
  }

  Result<void> link() {
    map_.next.resize(2 * map_.lines.size());
    map_.component_count = 0;
    std::iota(map_.next.begin(), map_.next.end(), 0U);  // as it is for islands
    std::vector<std::uint32_t> root(map_.lines.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    for (auto& [at, darts] : ends()) {
      std::vector<Dart> round = darts;
      std::sort(round.begin(), round.end(),
                [&, p = at](Dart a, Dart b) { return turns_before(p, ahead(a), ahead(b)); });
      for (std::size_t i = 0; i < round.size(); ++i) {
        const Dart before = round[i];
        const Dart after = round[(i + 1) % round.size()];
        if (i + 1 < round.size() && !turns_before(at, ahead(before), ahead(after))) {
          return error(at, fmt::format("lines '{}' and '{}' leave one point in the same direction",
                                       map_.lines[before / 2].name, map_.lines[after / 2].name));
        }
        // What comes in against `after` turns left as far as it can: into `before`.
        map_.next[twin(after)] = before;
        if (map_.left(twin(after)) != map_.left(before)) {
          return error(at, fmt::format("between the lines '{}' and '{}' lies {} by the one and {} by the other",
                                       map_.lines[after / 2].name, map_.lines[before / 2].name,
                                       called(map_.left(twin(after))), called(map_.left(before))));
        }
        root[find(before / 2)] = find(after / 2);
      }
    }
    map_.component.assign(map_.lines.size(), none);
    for (std::uint32_t i = 0; i < map_.lines.size(); ++i) {
      std::uint32_t& of = map_.component[find(i)];
      if (of == none) of = map_.component_count++;
      map_.component[i] = of;
    }
    return {};
  }

  [[nodiscard]] geom::Polyline contour(Dart first) const {
    geom::Polyline contour{{}, true};
    for (const Dart d : map_.loop(first)) {
      const LoftLine line = along(d);
      contour.points.insert(contour.points.end(), line.line.points.begin(),
                            line.line.points.end() - (line.line.closed ? 0 : 1));
    }
    return contour;
  }

  struct Loop {
    Dart first;
    geom::Polyline contour;
    double area;
  };

  Result<void> find_regions() {
    std::vector<Loop> outer;
    std::vector<Loop> inner;
    std::vector<char> seen(map_.next.size(), 0);
    map_.region_of.assign(map_.next.size(), none);
    for (Dart d = 0; d < map_.next.size(); ++d) {
      if (seen[d] != 0) continue;
      for (const Dart e : map_.loop(d)) seen[e] = 1;
      Loop loop{d, contour(d), 0.0};
      loop.area = geom::signed_area(loop.contour);
      (loop.area > 0.0 ? outer : inner).push_back(std::move(loop));
    }
    for (const Loop& loop : outer) {
      if (map_.left(loop.first).empty()) continue;
      take(loop, static_cast<std::uint32_t>(map_.regions.size()));
      map_.regions.push_back({map_.left(loop.first), {loop.first}});
    }
    for (const Loop& loop : inner) {
      const Loop* least = nullptr;
      for (const Loop& around : outer) {
        if (map_.component[around.first / 2] == map_.component[loop.first / 2]) continue;
        if (least != nullptr && around.area >= least->area) continue;
        const geom::Side side = geom::locate(around.contour, loop.contour.points[0]);
        if (side == geom::Side::Boundary)
          return error(loop.contour.points[0],
                       fmt::format("line '{}' touches another one without ending there: cut that one at this point",
                                   map_.lines[loop.first / 2].name));
        if (side == geom::Side::Inside) least = &around;
      }
      const std::string& name = map_.left(loop.first);
      const std::string& lies_in = least == nullptr ? std::string() : map_.left(least->first);
      if (name != lies_in) {
        return error(loop.contour.points[0],
                     fmt::format("line '{}' has {} on one side and lies in {}", map_.lines[loop.first / 2].name,
                                 called(name), called(lies_in)));
      }
      if (name.empty()) continue;
      const std::uint32_t region = map_.region_of[least->first];
      take(loop, region);
      map_.regions[region].loops.push_back(loop.first);
    }
    if (!map_.regions.empty()) return {};
    return Error{ErrorCode::InvalidOption, fmt::format("section {} bounds no region", number_ + 1)};
  }

  void take(const Loop& loop, std::uint32_t region) {
    for (const Dart d : map_.loop(loop.first)) map_.region_of[d] = region;
  }

  std::size_t number_;
  SectionMap map_;
};

constexpr Dart unset = none;

/// One way to lay a part of a map onto another.
struct Attempt {
  std::vector<std::pair<Dart, Dart>> pairs;
  bool fits = false;
  Dart differs_from = unset, differs_at = unset;  ///< Where it does not fit.
  double cost = 0.0;
};

class Laying {
 public:
  Laying(const SectionMap& from, const SectionMap& to, std::size_t number)
      : from_(from), to_(to), number_(number), onto_(from.next.size(), unset), back_(to.next.size(), unset) {}

  Result<std::vector<Dart>> run() {
    if (from_.lines.size() != to_.lines.size()) DOBRA_TRY_VOID(compare_counts());
    std::vector<char> done(from_.component_count, 0);
    for (Dart d = 0; d < from_.next.size(); ++d) {
      if (std::exchange(done[from_.component[d / 2]], 1) == 0) DOBRA_TRY_VOID(lay(rarest(from_.component[d / 2])));
    }
    for (Dart e = 0; e < back_.size(); ++e) {
      if (back_[e] == unset) return missing(to_, e, number_, number_ - 1);
    }
    return check_regions();
  }

 private:
  [[nodiscard]] static std::string told(const SectionMap& map, Dart d) {
    return fmt::format("line '{}' between {} and {}", map.lines[d / 2].name, called(map.left(d)),
                       called(map.left(twin(d))));
  }
  /// A line of section `in` that section `without` does not have.
  [[nodiscard]] static Error missing(const SectionMap& map, Dart d, std::size_t in, std::size_t without) {
    return section_error(in, map.frame, map.origin(d),
                         fmt::format("{} is not in section {}, or lies elsewhere there: sections that are joined have "
                                     "the same units in the same order",
                                     told(map, d), without + 1));
  }

  [[nodiscard]] Result<void> compare_counts() const {
    const auto find = [](const SectionMap& a, const SectionMap& b) {
      for (Dart d = 0; d < a.next.size(); d += 2) {
        const auto same = [&](const SectionMap& m) {
          std::size_t count = 0;
          for (Dart e = 0; e < m.next.size(); ++e) count += a.alike(d, m, e) ? 1 : 0;
          return count;
        };
        if (same(a) > same(b)) return d;
      }
      return unset;
    };
    if (const Dart d = find(from_, to_); d != unset) return missing(from_, d, number_ - 1, number_);
    if (const Dart e = find(to_, from_); e != unset) return missing(to_, e, number_, number_ - 1);
    return {};
  }

  /// A dart of the component that looks like as few others as can be.
  [[nodiscard]] Dart rarest(std::uint32_t component) const {
    Dart best = unset;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    std::map<std::string, std::size_t> counts;
    const auto key = [&](Dart d) {
      return fmt::format("{}\n{}\n{}", from_.lines[d / 2].name, from_.left(d), from_.left(twin(d)));
    };
    for (Dart d = 0; d < from_.next.size(); ++d) ++counts[key(d)];
    for (Dart d = 0; d < from_.next.size(); ++d) {
      if (from_.component[d / 2] != component || counts[key(d)] >= least) continue;
      least = counts[key(d)];
      best = d;
    }
    return best;
  }

  [[nodiscard]] static Point mean(const SectionMap& map, const std::vector<std::pair<Dart, Dart>>& pairs, bool second) {
    Point sum{0, 0};
    for (const auto& [d, e] : pairs) {
      const Point p = map.origin(second ? e : d);
      sum.x += p.x;
      sum.y += p.y;
    }
    const auto n = static_cast<double>(pairs.size());
    return {sum.x / n, sum.y / n};
  }

  [[nodiscard]] Attempt attempt(Dart first, Dart onto) const {
    Attempt a;
    std::map<Dart, Dart> forth{{first, onto}};
    std::map<Dart, Dart> back{{onto, first}};
    a.pairs = {{first, onto}};
    for (std::size_t i = 0; i < a.pairs.size(); ++i) {
      const auto [d, e] = a.pairs[i];
      for (const auto& [p, q] : {std::pair(from_.next[d], to_.next[e]), std::pair(twin(d), twin(e))}) {
        const auto known = forth.find(p);
        const auto taken = back.find(q);
        if (known != forth.end() && taken != back.end() && known->second == q && taken->second == p) continue;
        if (known != forth.end() || taken != back.end() || back_[q] != unset || !from_.alike(p, to_, q)) {
          a.differs_from = p;
          a.differs_at = q;
          return a;
        }
        forth.emplace(p, q);
        back.emplace(q, p);
        a.pairs.emplace_back(p, q);
      }
    }
    a.fits = true;
    const Point here = mean(from_, a.pairs, false);
    const Point there = mean(to_, a.pairs, true);
    for (const auto& [d, e] : a.pairs) {
      const Point p = from_.origin(d);
      const Point q = to_.origin(e);
      a.cost += std::hypot(p.x - here.x - q.x + there.x, p.y - here.y - q.y + there.y);
    }
    // Of parts that are alike the one that lies nearest.
    a.cost += std::hypot(here.x - there.x, here.y - there.y) * static_cast<double>(a.pairs.size());
    return a;
  }

  Result<void> lay(Dart first) {
    std::optional<Attempt> best;
    for (Dart e = 0; e < to_.next.size(); ++e) {
      if (back_[e] != unset || !from_.alike(first, to_, e)) continue;
      Attempt next = attempt(first, e);
      const bool better = !best || (next.fits != best->fits ? next.fits
                                    : next.fits             ? next.cost < best->cost
                                                            : next.pairs.size() > best->pairs.size());
      if (better) best = std::move(next);
    }
    if (!best) return missing(from_, first, number_ - 1, number_);
    if (!best->fits) {
      return section_error(
          number_, to_.frame, to_.origin(best->differs_at),
          fmt::format("{} stands where section {} has {}: sections that are joined have the same units in "
                      "the same order",
                      told(to_, best->differs_at), number_, told(from_, best->differs_from)));
    }
    for (const auto& [d, e] : best->pairs) {
      onto_[d] = e;
      back_[e] = d;
    }
    return {};
  }

  /// Islands lie in the same region.
  Result<std::vector<Dart>> check_regions() {
    for (Dart d = 0; d < onto_.size(); ++d) {
      const std::uint32_t here = from_.region_of[d];
      const std::uint32_t there = to_.region_of[onto_[d]];
      if (here == none && there == none) continue;
      if (here == none || there == none || to_.region_of[onto_[from_.regions[here].loops[0]]] != there)
        return missing(from_, d, number_ - 1, number_);
    }
    return std::move(onto_);
  }

  const SectionMap& from_;
  const SectionMap& to_;
  std::size_t number_;
  std::vector<Dart> onto_;
  std::vector<Dart> back_;
};

}  // namespace

Error section_error(std::size_t section, const SectionFrame& frame, Point at, const std::string& what, ErrorCode code) {
  const geom::Point3 p = frame.in_space(at);
  return {code, fmt::format("section {}: {}", section + 1, what), base::Place{.x = p.x, .y = p.y, .z = p.z}};
}

Result<SectionMap> section_map(const LoftSection& section, std::size_t number) {
  return MapMaker(section, number).run();
}

Result<std::vector<Dart>> laid_onto(const SectionMap& from, const SectionMap& to, std::size_t number) {
  return Laying(from, to, number).run();
}

}  // namespace dobra::solid::shape
