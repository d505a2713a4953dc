#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

#include "shared/base/check.h"
#include "shared/base/disjoint_sets.h"
#include "shared/solid/cells.h"

namespace dobra::solid {
namespace {

using geom::Sign;

/// The overlay of one plane; points of the space get numbers of their own here.
class Overlay {
 public:
  Overlay(Soup& soup, std::span<const std::uint32_t> facets, Cells& cells)
      : soup_(soup),
        facets_(facets),
        cells_(cells),
        plane_(soup.facets[facets[0]].plane),
        onto_(soup.space.projection(plane_)) {}

  void run(std::span<const Cut> cuts) {
    collect(cuts);
    split();
    join();
    sort_stars();
    trace();
    nest();
    cover();
    emit();
  }

 private:
  /// A segment; of no length where a point is to be on every edge that it lies on.
  struct Segment {
    PointId a, b;
    PlaneId other;
    std::uint32_t facet;  // whose border it is; none if a cut
  };
  struct Edge {
    PointId a, b;  // a is the less of the two along the plane
    std::uint32_t first_owner, owner_end;
  };

  void collect(std::span<const Cut> cuts) {
    for (const std::uint32_t f : facets_) {
      soup_.visit_edges(soup_.facets[f], [&](std::uint32_t i, std::uint32_t j) {
        add({soup_.corners[i], soup_.corners[j], soup_.across[i], f});
      });
    }
    const std::size_t borders = segments_.size();
    for (const Cut& cut : cuts) add({cut.a, cut.b, cut.other, none});
    // Cuts that many facets of one plane make are one.
    const auto key = [](const Segment& s) { return std::pair(s.a, s.b); };
    const auto begin = segments_.begin() + static_cast<std::ptrdiff_t>(borders);
    std::stable_sort(begin, segments_.end(), [&](const Segment& s, const Segment& t) { return key(s) < key(t); });
    segments_.erase(
        std::unique(begin, segments_.end(), [&](const Segment& s, const Segment& t) { return key(s) == key(t); }),
        segments_.end());
    stops_.resize(segments_.size());
  }

  void add(Segment segment) {
    if (soup_.space.compare(onto_, segment.a, segment.b) == std::strong_ordering::greater) {
      std::swap(segment.a, segment.b);
    }
    segments_.push_back(segment);
  }

  /// The box of a segment: low and high along u and v.
  struct Range {
    std::array<double, 2> low, high;
    std::uint32_t segment;
  };

  /// All pairs of segments whose boxes overlap, each with the segment before it along u first.
  void split() {
    std::vector<Range> ranges;
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      const double v = soup_.space.coordinate(s.a, onto_.v);
      const double w = soup_.space.coordinate(s.b, onto_.v);
      ranges.push_back({{soup_.space.coordinate(s.a, onto_.u), std::min(v, w)},
                        {soup_.space.coordinate(s.b, onto_.u), std::max(v, w)},
                        i});
    }
    std::sort(ranges.begin(), ranges.end(), [](const Range& r, const Range& s) {
      return r.low[0] != s.low[0] ? r.low[0] < s.low[0] : r.segment < s.segment;
    });
    constexpr std::size_t few = 100;
    if (ranges.size() < few || crowding(ranges, 0) <= 2.0 * crowding(ranges, 1)) {
      sweep(ranges, 0, [&](const Range& s, const Range& r) { meet(s.segment, r.segment); });
      return;
    }
    // Many lie beside each other along u and not along v. Points get their numbers in one order whichever way it is.
    std::vector<std::uint32_t> place(ranges.size());
    for (std::uint32_t i = 0; i < ranges.size(); ++i) place[ranges[i].segment] = i;
    const std::vector<Range> along_u = ranges;
    std::sort(ranges.begin(), ranges.end(), [](const Range& r, const Range& s) { return r.low[1] < s.low[1]; });
    std::vector<std::array<std::uint32_t, 2>> pairs;  // the later one first
    sweep(ranges, 1, [&](const Range& s, const Range& r) {
      const auto [earlier, later] = std::minmax(place[s.segment], place[r.segment]);
      pairs.push_back({later, earlier});
    });
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [later, earlier] : pairs) meet(along_u[earlier].segment, along_u[later].segment);
  }

  /// How many boxes lie above a place on the axis, in the mean.
  static double crowding(const std::vector<Range>& ranges, std::size_t axis) {
    double low = ranges[0].low[axis];
    double high = ranges[0].high[axis];
    double sum = 0.0;
    for (const Range& r : ranges) {
      low = std::min(low, r.low[axis]);
      high = std::max(high, r.high[axis]);
      sum += r.high[axis] - r.low[axis];
    }
    return sum / std::max(high - low, std::numeric_limits<double>::min());
  }

  /// Calls visit(s, r) for all pairs whose boxes overlap, s before r. Rounding keeps the order, so that boxes of
  /// rounded ends overlap where the segments do.
  /// @pre sorted by low[axis]
  template <class Visit>
  static void sweep(const std::vector<Range>& ranges, std::size_t axis, Visit&& visit) {
    const std::size_t across = 1 - axis;
    std::vector<Range> open;
    for (const Range& r : ranges) {
      std::size_t kept = 0;
      for (const Range& s : open) {
        if (s.high[axis] < r.low[axis]) continue;
        open[kept++] = s;
        if (s.low[across] <= r.high[across] && r.low[across] <= s.high[across]) visit(s, r);
      }
      open.resize(kept);
      open.push_back(r);
    }
  }

  [[nodiscard]] bool less(PointId p, PointId q) const {
    return soup_.space.compare(onto_, p, q) == std::strong_ordering::less;
  }
  /// p is on the line of the segment.
  void stop_within(std::uint32_t segment, PointId p) {
    const Segment& s = segments_[segment];
    if (p != s.a && p != s.b && less(s.a, p) && less(p, s.b)) stops_[segment].push_back(p);
  }

  void meet(std::uint32_t i, std::uint32_t j) {
    const Segment s = segments_[i];
    const Segment t = segments_[j];
    if (s.a == t.a && s.b == t.b) return;
    const Space& space = soup_.space;
    const Sign a = s.a == s.b ? Sign::Zero : space.orient(onto_, s.a, s.b, t.a);
    const Sign b = s.a == s.b ? Sign::Zero : space.orient(onto_, s.a, s.b, t.b);
    if (s.a != s.b && a == b && a != Sign::Zero) return;
    const Sign c = t.a == t.b ? Sign::Zero : space.orient(onto_, t.a, t.b, s.a);
    const Sign d = t.a == t.b ? Sign::Zero : space.orient(onto_, t.a, t.b, s.b);
    if (s.a != s.b) {
      if (a == Sign::Zero) stop_within(i, t.a);
      if (b == Sign::Zero && t.b != t.a) stop_within(i, t.b);
    }
    if (t.a != t.b) {
      if (c == Sign::Zero) stop_within(j, s.a);
      if (d == Sign::Zero && s.b != s.a) stop_within(j, s.b);
    }
    if (a * b == Sign::Negative && c * d == Sign::Negative) {
      const PointId at = crossing(s, t);
      stops_[i].push_back(at);
      stops_[j].push_back(at);
    }
  }

  PointId crossing(const Segment& s, const Segment& t) {
    Space& space = soup_.space;
    const bool plain = space.is_exact(s.a) && space.is_exact(s.b) && space.is_exact(t.a) && space.is_exact(t.b);
    if (!plain && s.other.valid() && t.other.valid()) return space.meet(plane_, s.other, t.other);
    return space.meet(onto_, s.a, s.b, t.a, t.b);
  }

  /// Cuts segments at their stops; what coincides becomes one edge that knows the facets whose border it is.
  void join() {
    struct Piece {
      PointId a, b;
      std::uint32_t facet;
    };
    std::vector<Piece> pieces;
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      if (s.a == s.b) continue;
      auto& stops = stops_[i];
      std::sort(stops.begin(), stops.end(), [&](PointId p, PointId q) { return p != q && less(p, q); });
      stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
      PointId from = s.a;
      for (const PointId stop : stops) {
        pieces.push_back({from, stop, s.facet});
        from = stop;
      }
      pieces.push_back({from, s.b, s.facet});
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const Piece& p, const Piece& q) { return std::tie(p.a, p.b, p.facet) < std::tie(q.a, q.b, q.facet); });
    for (std::size_t i = 0; i < pieces.size();) {
      Edge edge{pieces[i].a, pieces[i].b, static_cast<std::uint32_t>(owners_.size()), 0};
      for (; i < pieces.size() && pieces[i].a == edge.a && pieces[i].b == edge.b; ++i) {
        if (pieces[i].facet != none) owners_.push_back(pieces[i].facet);
      }
      edge.owner_end = static_cast<std::uint32_t>(owners_.size());
      edges_.push_back(edge);
    }
  }

  // Half-edge 2e runs from a to b, 2e + 1 back.
  [[nodiscard]] PointId origin(std::uint32_t h) const { return h % 2 == 0 ? edges_[h / 2].a : edges_[h / 2].b; }
  [[nodiscard]] PointId target(std::uint32_t h) const { return origin(h ^ 1U); }

  /// The half-edges that leave a vertex, anticlockwise from straight down; then who follows whom.
  void sort_stars() {
    const auto count = static_cast<std::uint32_t>(2 * edges_.size());
    order_.resize(count);
    for (std::uint32_t h = 0; h < count; ++h) order_[h] = h;
    // Half-edges 2e go to a greater vertex, that is to the right or straight up; the others come after them.
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t g, std::uint32_t h) {
      if (g == h) return false;
      if (origin(g) != origin(h)) return origin(g) < origin(h);
      if (g % 2 != h % 2) return g % 2 < h % 2;
      return soup_.space.orient(onto_, origin(g), target(g), target(h)) == Sign::Positive;
    });
    next_.resize(count);
    for (std::uint32_t first = 0; first < count;) {
      std::uint32_t end = first;
      while (end < count && origin(order_[end]) == origin(order_[first])) ++end;
      for (std::uint32_t i = first; i < end; ++i) {
        // Who comes in along order_[i] leaves by the one before it, clockwise, so that the face stays on the left.
        next_[order_[i] ^ 1U] = order_[i > first ? i - 1 : end - 1];
      }
      first = end;
    }
  }

  void trace() {
    const auto count = static_cast<std::uint32_t>(next_.size());
    loop_of_.assign(count, none);
    for (std::uint32_t h = 0; h < count; ++h) {
      if (loop_of_[h] != none) continue;
      const auto loop = static_cast<std::uint32_t>(loop_first_.size());
      loop_first_.push_back(h);
      for (std::uint32_t g = h; loop_of_[g] == none; g = next_[g]) loop_of_[g] = loop;
    }
  }

  /// Which loops surround a connected part of the edges from outside, and in which face each such part lies.
  void nest() {
    base::DisjointSets parts(loop_first_.size());
    for (std::uint32_t h = 0; h < next_.size(); h += 2) parts.join(loop_of_[h], loop_of_[h + 1]);
    // The least vertex of every part, and there the half-edge that is last anticlockwise: outside is on its left.
    std::unordered_map<std::size_t, std::uint32_t> least;
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
      const std::uint32_t h = order_[i];
      if (i + 1 < order_.size() && origin(order_[i + 1]) == origin(h)) continue;  // not the last of its star
      if (h % 2 == 1) continue;                                                   // some neighbour is less
      const auto [at, fresh] = least.try_emplace(parts.root(loop_of_[h]), h);
      if (!fresh && less(origin(h), origin(at->second))) at->second = h;
    }
    std::vector<std::uint32_t> outer;
    for (const auto& [part, half] : least) outer.push_back(half);
    std::sort(outer.begin(), outer.end(),
              [&](std::uint32_t g, std::uint32_t h) { return g != h && less(origin(g), origin(h)); });
    face_of_loop_.assign(loop_first_.size(), none);
    for (const std::uint32_t h : outer) face_of_loop_[loop_of_[h]] = 0;  // for now: a loop from outside
    face_count_ = 1;                                                     // the face without end
    for (std::uint32_t& face : face_of_loop_) {
      if (face == none) face = face_count_++;
    }
    for (const std::uint32_t h : outer) {
      const std::uint32_t below = outer.size() == 1 ? none : edge_below(origin(h), parts, loop_of_[h]);
      face_of_loop_[loop_of_[h]] = below == none ? 0 : face_of_loop_[loop_of_[2 * below]];
    }
  }

  /// The highest edge of another part that passes below p; parts that it belongs to have lesser vertices than p.
  std::uint32_t edge_below(PointId p, base::DisjointSets& parts, std::uint32_t loop) const {
    std::uint32_t best = none;
    const std::size_t own = parts.root(loop);
    const double u = soup_.space.coordinate(p, onto_.u);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const Edge& edge = edges_[e];
      if (soup_.space.coordinate(edge.a, onto_.u) > u || soup_.space.coordinate(edge.b, onto_.u) < u) continue;
      if (parts.root(loop_of_[2 * e]) == own || !less(edge.a, p) || !less(p, edge.b)) continue;
      if (soup_.space.orient(onto_, edge.a, edge.b, p) != Sign::Positive) continue;
      if (best == none || higher(edge, edges_[best])) best = e;
    }
    return best;
  }
  /// Both pass below one point and do not cross.
  [[nodiscard]] bool higher(const Edge& e, const Edge& f) const {
    if (e.a == f.a) return soup_.space.orient(onto_, f.a, f.b, e.b) == Sign::Positive;
    if (less(f.a, e.a)) return soup_.space.orient(onto_, f.a, f.b, e.a) == Sign::Positive;
    return soup_.space.orient(onto_, e.a, e.b, f.a) == Sign::Negative;
  }

  /// From the face without end inwards: whoever passes the border of a facet enters or leaves it.
  void cover() {
    std::vector<std::vector<std::uint32_t>> halves(face_count_);
    for (std::uint32_t h = 0; h < next_.size(); ++h) halves[face_of_loop_[loop_of_[h]]].push_back(h);
    covers_.resize(face_count_);
    std::vector<char> known(face_count_, 0);
    std::vector<std::uint32_t> queue{0};
    known[0] = 1;
    while (!queue.empty()) {
      const std::uint32_t face = queue.back();
      queue.pop_back();
      for (const std::uint32_t h : halves[face]) {
        const std::uint32_t beyond = face_of_loop_[loop_of_[h ^ 1U]];
        if (known[beyond] != 0) continue;
        known[beyond] = 1;
        covers_[beyond] = covers_[face];
        for (std::uint32_t i = edges_[h / 2].first_owner; i < edges_[h / 2].owner_end; ++i) {
          toggle(covers_[beyond], owners_[i]);
        }
        queue.push_back(beyond);
      }
    }
    for (const char face : known) DOBRA_CHECK(face != 0);
  }
  static void toggle(std::vector<std::uint32_t>& set, std::uint32_t facet) {
    const auto at = std::lower_bound(set.begin(), set.end(), facet);
    if (at != set.end() && *at == facet) {
      set.erase(at);
    } else {
      set.insert(at, facet);
    }
  }

  void emit() {
    const int axis = 3 - onto_.u - onto_.v;
    const Sign up = soup_.space.normal_sign(plane_, axis);
    std::vector<std::vector<std::uint32_t>> loops(face_count_);
    for (std::uint32_t loop = 0; loop < loop_first_.size(); ++loop) loops[face_of_loop_[loop]].push_back(loop);
    for (std::uint32_t face = 1; face < face_count_; ++face) {
      if (covers_[face].empty()) continue;
      const CellId id(cells_.cells.size());
      Cell cell{facets_[0], static_cast<std::uint32_t>(cells_.halves.size()), 0,
                static_cast<std::uint32_t>(cells_.covers.size()), 0};
      for (const std::uint32_t f : covers_[face]) {
        cells_.covers.push_back({f, soup_.space.normal_sign(soup_.facets[f].plane, axis) != up});
      }
      for (const std::uint32_t loop : loops[face]) {
        const auto first = static_cast<std::uint32_t>(cells_.halves.size());
        const std::uint32_t start = loop_first_[loop];
        std::uint32_t h = start;
        do {
          cells_.halves.push_back({origin(h), static_cast<std::uint32_t>(cells_.halves.size() + 1), id});
          h = next_[h];
        } while (h != start);
        cells_.halves.back().next = first;
      }
      cell.half_end = static_cast<std::uint32_t>(cells_.halves.size());
      cell.cover_end = static_cast<std::uint32_t>(cells_.covers.size());
      cells_.cells.push_back(cell);
    }
  }

  Soup& soup_;
  std::span<const std::uint32_t> facets_;
  Cells& cells_;
  PlaneId plane_;
  Projection onto_;
  std::vector<Segment> segments_;
  std::vector<std::vector<PointId>> stops_;
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> owners_;
  std::vector<std::uint32_t> order_, next_, loop_of_, loop_first_, face_of_loop_;
  std::uint32_t face_count_ = 0;
  std::vector<std::vector<std::uint32_t>> covers_;
};

void add_whole(const Soup& soup, std::uint32_t f, Cells& cells) {
  const Facet& facet = soup.facets[f];
  const CellId id(cells.cells.size());
  const auto first = static_cast<std::uint32_t>(cells.halves.size());
  const auto cover = static_cast<std::uint32_t>(cells.covers.size());
  cells.covers.push_back({f, false});
  soup.visit_edges(facet, [&](std::uint32_t i, std::uint32_t j) {
    cells.halves.push_back({soup.corners[i], first + (j - facet.first_corner), id});
  });
  cells.cells.push_back({f, first, static_cast<std::uint32_t>(cells.halves.size()), cover, cover + 1});
}

}  // namespace

void overlay(Soup& soup, std::span<const std::uint32_t> facets, std::span<const Cut> cuts, Cells& cells) {
  Overlay(soup, facets, cells).run(cuts);
}

Cells arrange(Soup& soup, const Contacts& contacts) {
  const auto count = static_cast<std::uint32_t>(soup.facets.size());
  base::DisjointSets groups(count);
  std::vector<char> touched(count, 0);
  for (const auto& [f, g] : contacts.coplanar) {
    groups.join(f, g);
    touched[f] = touched[g] = 1;
  }
  for (const Cut& cut : contacts.cuts) touched[cut.facet] = 1;
  std::vector<std::vector<std::uint32_t>> members(count);
  std::vector<std::vector<Cut>> cuts(count);
  for (std::uint32_t f = 0; f < count; ++f) {
    if (touched[f] != 0) members[groups.root(f)].push_back(f);
  }
  for (const Cut& cut : contacts.cuts) cuts[groups.root(cut.facet)].push_back(cut);
  Cells cells;
  for (std::uint32_t f = 0; f < count; ++f) {
    if (touched[f] == 0) {
      add_whole(soup, f, cells);
    } else if (!members[f].empty()) {
      overlay(soup, members[f], cuts[f], cells);
    }
  }
  return cells;
}

}  // namespace dobra::solid
