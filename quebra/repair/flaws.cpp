#include "quebra/repair/flaws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "quebra/domain/domain.h"
#include "quebra/domain/open_outline.h"
#include "quebra/sketch/ends.h"
#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

namespace quebra::repair {
namespace {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;

// --- gaps
// --------------------------------------------------------------------------------------------------------------------

/// Chains of internal lines that would close if their nearest free ends met.
class NearlyClosed {
 public:
  NearlyClosed(const domain::Domain& domain, double limit, const std::optional<sketch::RepairOptions>& repaired)
      : domain_(domain), limit_(limit), repaired_(repaired), chain_(domain.curves.size()) {
    std::iota(chain_.begin(), chain_.end(), std::size_t{0});
  }

  std::vector<sketch::Finding> run() {
    const std::vector<sketch::End> ends = free_ends();
    std::vector<std::uint8_t> used(ends.size(), 0);
    std::vector<sketch::NearEnds> pairs;
    std::vector<std::size_t> closing;
    for (const sketch::NearEnds& pair : near_ends(ends, limit_)) {
      if (used[pair.a] != 0 || used[pair.b] != 0) continue;
      used[pair.a] = used[pair.b] = 1;
      pairs.push_back(pair);
      const std::size_t a = root(ends[pair.a].curve), b = root(ends[pair.b].curve);
      if (a == b) closing.push_back(a);
      chain_[std::max(a, b)] = std::min(a, b);
    }
    std::map<std::size_t, double> lengths;
    for (std::size_t c = 0; c < chain_.size(); ++c) lengths[root(c)] += length(domain_.curves[c]);
    std::set<std::size_t> closed_chains;
    for (const std::size_t c : closing) closed_chains.insert(root(c));
    std::vector<sketch::Finding> findings;
    for (const sketch::NearEnds& pair : pairs) {
      const std::size_t chain = root(ends[pair.a].curve);
      // A line no longer than its gap closes nothing.
      if (closed_chains.contains(chain) && pair.gap < 0.1 * lengths[chain])
        findings.push_back(finding(ends[pair.a], ends[pair.b], pair.gap));
    }
    return findings;
  }

 private:
  std::size_t root(std::size_t c) {
    while (chain_[c] != c) c = chain_[c] = chain_[chain_[c]];
    return c;
  }

  /// Of internal lines, those that no other curve passes; lines that do meet are of one chain.
  std::vector<sketch::End> free_ends() {
    std::vector<sketch::End> ends = open_ends(domain_.curves);
    std::map<Point, std::set<std::size_t>> passing;
    for (const sketch::End& end : ends) passing[end.at].insert(end.curve);
    for (const domain::Junction& junction : domain_.junctions) passing[junction.at].insert(junction.curve);
    const auto internal = [&](std::size_t curve) { return domain_.curves[curve].role == sketch::Role::Internal; };
    for (const auto& [at, curves] : passing) {
      for (const std::size_t c : curves) {
        if (!internal(c) || !internal(*curves.begin())) continue;
        const std::size_t a = root(c), b = root(*curves.begin());
        chain_[std::max(a, b)] = std::min(a, b);
      }
    }
    std::erase_if(ends, [&](const sketch::End& end) { return !internal(end.curve) || passing.at(end.at).size() > 1; });
    return ends;
  }

  [[nodiscard]] sketch::Finding finding(const sketch::End& a, const sketch::End& b, double gap) const {
    const std::string& one = domain_.curves[a.curve].name;
    const std::string names = a.curve == b.curve ? one : one + ", " + domain_.curves[b.curve].name;
    const double size = domain_.box().diagonal();
    const std::string what =
        gap_text(domain_.curves, a, b) + ", so that this chain is taken for an internal line and bounds nothing";
    if (!repaired_)
      return {sketch::Wrong::Gap, a.at, names,
              fmt::format("left as it is: {}; {}", what, domain::gap_advice(gap, size, repaired_))};
    const double closes = gap_limit(*repaired_, size);
    const std::string why = gap > closes ? domain::gap_advice(gap, size, repaired_)
                                         : fmt::format(
                                               "--repair closes gaps up to {:.3g} m, but none between lines that the "
                                               "file calls internal: close it by hand",
                                               closes);
    return {sketch::Wrong::Gap, a.at, names, fmt::format("not repaired: {}; {}", what, why)};
  }

  const domain::Domain& domain_;
  double limit_;
  const std::optional<sketch::RepairOptions>& repaired_;
  std::vector<std::size_t> chain_;  ///< Union of curves, by the least.
};

// --- slivers
// ---------------------------------------------------------------------------------------------------------------

struct Piece {
  Segment segment;
  std::size_t curve = 0, number = 0;
  double s_from = 0.0, s_to = 0.0;
};

/// The least distance of two pieces and where it is, on the first.
struct Clearance {
  double distance = 0.0;
  Point at;
};

class Slivers {
 public:
  Slivers(const domain::Domain& domain, const FlawOptions& options, double size)
      : domain_(domain), options_(options), size_(size) {
    for (const domain::Junction& junction : domain.junctions) junctions_[junction.at].insert(junction.curve);
  }

  std::vector<sketch::Finding> run() {
    std::vector<Box> boxes;
    const std::vector<std::uint8_t> lone = domain_.lone_circles(options_.sliver * options_.side * size_);
    for (std::size_t c = 0; c < domain_.curves.size(); ++c) {
      if (lone[c] != 0) {  // nothing is near
        counts_.push_back(0);
        continue;
      }
      const sketch::Trace along = trace(domain_.curves[c]);
      counts_.push_back(along.line.segment_count());
      for (std::size_t i = 0; i < counts_.back(); ++i) {
        const Segment segment = along.line.segment(i);
        pieces_.push_back({segment, c, i, along.s[i], along.s[i + 1]});
        // Between a bent curve and its chord lies a quarter of the turn times the chord, at most.
        const double bulge = straight(c) ? 0.0 : 0.25 * sketch::trace_turn.radians() * segment.length();
        boxes.push_back(segment.box().grown(options_.sliver * extent(segment) + bulge));
      }
    }
    for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) judge(pieces_[i], pieces_[j]);
    std::vector<sketch::Finding> findings;
    for (const auto& [curves, worst] : worst_) findings.push_back(worst.finding);
    return findings;
  }

 private:
  struct Worst {
    double ratio = 0.0;
    sketch::Finding finding;
  };

  [[nodiscard]] bool straight(std::size_t curve) const {
    return std::holds_alternative<Polyline>(domain_.curves[curve].shape);
  }
  [[nodiscard]] double extent(const Segment& segment) const {
    return std::min(segment.length(), options_.side * size_);
  }

  /// The point where two pieces meet by intention: a common end, or a junction.
  [[nodiscard]] std::optional<Point> meeting(const Piece& a, const Piece& b) const {
    for (const Point p : {a.segment.from, a.segment.to}) {
      if (p == b.segment.from || p == b.segment.to || joined(p, b)) return p;
    }
    for (const Point p : {b.segment.from, b.segment.to}) {
      if (joined(p, a)) return p;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool joined(Point p, const Piece& piece) const {
    const auto found = junctions_.find(p);
    const double bulge = straight(piece.curve) ? 0.0 : 0.25 * sketch::trace_turn.radians() * piece.segment.length();
    return found != junctions_.end() && found->second.contains(piece.curve) &&
           distance(piece.segment, p) <= domain::DomainOptions{}.join_tolerance * size_ + bulge;
  }

  void judge(const Piece& a, const Piece& b) {
    const bool bent = !straight(a.curve) || !straight(b.curve);
    const double local = std::min(extent(a.segment), extent(b.segment));
    if (const auto p = meeting(a, b)) {
      // Two straight sides that leave one point in nearly the same direction: a wedge.
      if (bent) return;
      const auto far_end = [&](const Segment& s) { return distance(s.from, *p) > distance(s.to, *p) ? s.from : s.to; };
      const Point one = far_end(a.segment), two = far_end(b.segment);
      if (dot(one - *p, two - *p) <= 0.0) return;
      const bool first_shorter = distance(one, *p) <= distance(two, *p);
      const double gap = first_shorter ? distance(b.segment, one) : distance(a.segment, two);
      const double reach = std::min(distance(one, *p), distance(two, *p));
      if (gap < options_.sliver * reach) note(a, b, {gap, first_shorter ? one : two}, reach, true);
      return;
    }
    if (intersect(a.segment, b.segment).kind != dobra::geom::IntersectionKind::None) return;
    const Clearance least = bent ? between_curves(a, b) : between(a.segment, b.segment);
    if (least.distance > 0.0 && least.distance < options_.sliver * local) note(a, b, least, local, false);
  }

  static Clearance between(const Segment& a, const Segment& b) {
    Clearance best{distance(b, a.from), a.from};
    const auto take = [&](double gap, Point at) {
      if (gap < best.distance) best = {gap, at};
    };
    take(distance(b, a.to), a.to);
    take(distance(a, b.from), b.from);
    take(distance(a, b.to), b.to);
    return best;
  }

  /// From the chords to the true curves: the nearest point of one and of the other by turns.
  [[nodiscard]] Clearance between_curves(const Piece& a, const Piece& b) const {
    Point p = between(a.segment, b.segment).at;
    double gap = 0.0;
    for (int turn = 0; turn < 20; ++turn) {
      const Point q = nearest(b, p);
      p = nearest(a, q);
      const double now = distance(p, q);
      if (turn > 0 && now >= gap * (1.0 - 1e-6)) return {std::min(now, gap), p};
      gap = now;
    }
    return {gap, p};
  }
  [[nodiscard]] Point nearest(const Piece& piece, Point p) const {
    const sketch::Curve& curve = domain_.curves[piece.curve];
    double s = piece.s_from + nearest_fraction(piece.segment, p) * (piece.s_to - piece.s_from);
    if (straight(piece.curve))
      return interpolate(piece.segment.from, piece.segment.to, nearest_fraction(piece.segment, p));
    for (int step = 0; step < 8; ++step) {
      const double ahead = dot(p - point(curve, s), direction(curve, s));
      s = std::clamp(s + ahead, piece.s_from, piece.s_to);
      if (std::abs(ahead) <= 1e-15 * size_) break;
    }
    return point(curve, s);
  }

  /// Of two curves only the narrowest place is told.
  void note(const Piece& a, const Piece& b, Clearance least, double local, bool wedge) {
    const double ratio = least.distance / local;
    const auto [entry, is_new] = worst_.try_emplace(std::minmax(a.curve, b.curve));
    if (!is_new && ratio >= entry->second.ratio) return;
    entry->second.ratio = ratio;
    const bool same = a.curve == b.curve;
    const std::size_t apart = std::max(a.number, b.number) - std::min(a.number, b.number);
    const bool short_side =
        same && !wedge && (apart == 2 || (closed(domain_.curves[a.curve]) && apart + 2 == counts_[a.curve]));
    const std::string& one = domain_.curves[a.curve].name;
    const std::string what =
        wedge        ? fmt::format("two sides of {:.3g} m that leave one point are no more than {:.3g} m apart", local,
                                   least.distance)
        : short_side ? fmt::format("two points are {:.3g} m apart between sides of {:.3g} m", least.distance, local)
                     : fmt::format("two sides of {:.3g} m come within {:.3g} m of each other", local, least.distance);
    const double merges = sketch::RepairOptions{}.same_point * size_;
    entry->second.finding = {
        short_side ? sketch::Wrong::NearlyRepeatedPoint : sketch::Wrong::Sliver, least.at,
        same ? one : one + ", " + domain_.curves[b.curve].name,
        options_.repaired
            ? fmt::format("not repaired: {}, and elements must be as small there; move them apart or let them touch: "
                          "--repair makes one only of what is nearer than {:.3g} m",
                          what, merges)
            : fmt::format("left as it is: {}, and elements must be as small there; move them apart or let them touch; "
                          "--repair (repair = \"yes\") makes one of what is nearer than {:.3g} m",
                          what, merges)};
  }

  const domain::Domain& domain_;
  const FlawOptions& options_;
  double size_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> counts_;
  std::map<Point, std::set<std::size_t>> junctions_;
  std::map<std::pair<std::size_t, std::size_t>, Worst> worst_;
};

// --- loops outside others
// ------------------------------------------------------------------------------------------------

/// What lies outside every other loop bounds material of its own, and is easily taken for a hole.
std::vector<sketch::Finding> loops_apart(const domain::Domain& domain) {
  struct Outer {
    const domain::Domain::Loop* loop;
    double area;
  };
  std::vector<Outer> outer;
  for (const domain::Domain::Loop& loop : domain.loops) {
    if (loop.depth == 0) outer.push_back({&loop, std::abs(signed_area(contour(domain, loop)))});
  }
  if (outer.size() < 2) return {};
  const auto name_of = [&](const Outer& own) { return domain.curves[own.loop->sides.front().curve].name; };
  std::stable_sort(outer.begin(), outer.end(), [](const Outer& a, const Outer& b) { return a.area > b.area; });
  constexpr std::size_t most = 5;
  std::string names;
  double area = 0.0;
  for (std::size_t i = 1; i < outer.size(); ++i) {
    area += outer[i].area;
    if (i <= most) names += (i == 1 ? "" : ", ") + name_of(outer[i]);
  }
  if (outer.size() > most + 1) names += fmt::format(" and {} more", outer.size() - most - 1);
  const bool one = outer.size() == 2;
  return {{sketch::Wrong::Apart, point(domain.curves[outer[1].loop->sides.front().curve], 0.0), names,
           fmt::format("left as {}: outside '{}', {} no hole{} but material of {} own, {:.3g} m2 beside {:.3g} m2; "
                       "move {} inside or remove {} if that is not meant",
                       one ? "it is" : "they are", name_of(outer[0]), one ? "it is" : "they are", one ? "" : "s",
                       one ? "its" : "their", area, outer[0].area, one ? "it" : "them", one ? "it" : "them")}};
}

}  // namespace

std::vector<sketch::Finding> flaws_of(const domain::Domain& domain, const FlawOptions& options) {
  const double size = domain.box().diagonal();
  std::vector<sketch::Finding> findings = NearlyClosed(domain, options.near_end * size, options.repaired).run();
  std::vector<sketch::Finding> slivers = Slivers(domain, options, size).run();
  findings.insert(findings.end(), std::make_move_iterator(slivers.begin()), std::make_move_iterator(slivers.end()));
  std::vector<sketch::Finding> apart = loops_apart(domain);
  findings.insert(findings.end(), std::make_move_iterator(apart.begin()), std::make_move_iterator(apart.end()));
  return findings;
}

}  // namespace quebra::repair
