// Chains as closed loops: those that go round joined by a seam, all turned so that the face lies on the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/io/faces/loops.h"

namespace dobra::io::faces {

using geom::Box;
using geom::Point;
using geom::Vector;

namespace {

Box box_of(const Loop& loop) { return geom::box_of(outline(loop)); }

/// A straight piece, or nothing where both ends are one.
void add_straight(Loop& loop, Point from, Point to, bool still, std::optional<surf::trim::SharedCurveId> shared,
                  bool against) {
  if (from == to) return;
  Piece piece = straight(from, to);
  piece.still = still;
  piece.shared = shared;
  piece.against = against;
  piece.name = still ? "" : "seam";
  loop.push_back(std::move(piece));
}

/// A chain that goes round in u (v): where it lies across, and to which side the face is.
struct Round {
  Chain chain;
  double across = 0.0;
  bool up = false;  ///< The face is where the other parameter is greater.
};

class Seams {
 public:
  Seams(const Bench& bench, bool of_u) : bench_(bench), of_u_(of_u) {}

  /// Loops of the chains that go round in this parameter, which are taken out of the list.
  Outcome<std::vector<Loop>> close(std::vector<Chain>& chains) {
    std::vector<Round> rounds = taken(chains);
    std::vector<Loop> loops;
    while (!rounds.empty()) {
      auto first = std::find_if(rounds.begin(), rounds.end(), [](const Round& r) { return r.up; });
      if (first == rounds.end()) first = rounds.begin();
      Round low = std::move(*first);
      rounds.erase(first);
      const auto partner = partner_of(low, rounds);
      if (partner != rounds.end()) {
        loops.push_back(between(low.chain.pieces, partner->chain.pieces));
        rounds.erase(partner);
        continue;
      }
      const std::optional<double> point = point_beyond(low);
      const Point at = low.chain.pieces.front().begin_at();
      if (!point)
        return Refusal{"face_open",
                       "its loop goes round the surface, and nothing bounds the face on the other side; add an edge "
                       "there",
                       at, bench_.at(at)};
      loops.push_back(to_point(low.chain.pieces, *point));
    }
    return loops;
  }

 private:
  [[nodiscard]] double along(Point p) const { return of_u_ ? p.x : p.y; }
  [[nodiscard]] double across(Point p) const { return of_u_ ? p.y : p.x; }
  [[nodiscard]] Point place(double along, double across) const {
    return of_u_ ? Point{along, across} : Point{across, along};
  }
  [[nodiscard]] double period() const { return of_u_ ? bench_.whole.period_u : bench_.whole.period_v; }

  std::vector<Round> taken(std::vector<Chain>& chains) const {
    std::vector<Round> rounds;
    std::vector<Chain> rest;
    for (Chain& chain : chains) {
      const double by = along(Point{} + chain.round);  // what the end lies beyond the beginning
      if (by == 0.0 || across(Point{} + chain.round) != 0.0) {
        rest.push_back(std::move(chain));
        continue;
      }
      double sum = 0.0;
      const std::vector<Point> places = outline(chain.pieces);
      for (const Point p : places) sum += across(p);
      const bool forwards = by > 0.0;  // the left of it is up in u, down in v
      rounds.push_back({std::move(chain), sum / static_cast<double>(places.size()), of_u_ == forwards});
    }
    chains = std::move(rest);
    std::stable_sort(rounds.begin(), rounds.end(), [](const Round& a, const Round& b) { return a.across < b.across; });
    return rounds;
  }

  /// The nearest one beyond that bounds the same part from the other side.
  [[nodiscard]] std::vector<Round>::iterator partner_of(const Round& low, std::vector<Round>& rounds) const {
    const double around = of_u_ ? bench_.whole.period_v : bench_.whole.period_u;
    auto best = rounds.end();
    double least = 0.0;
    for (auto it = rounds.begin(); it != rounds.end(); ++it) {
      if (it->up == low.up) continue;
      double by = low.up ? it->across - low.across : low.across - it->across;
      if (around > 0.0) by -= std::floor(by / around) * around;
      if (!(by > 0.0)) continue;
      if (best == rounds.end() || by < least) best = it, least = by;
    }
    return best;
  }

  [[nodiscard]] std::optional<double> point_beyond(const Round& low) const {
    std::optional<double> found;
    for (const double at : of_u_ ? bench_.whole.points_v : bench_.whole.points_u) {
      if (low.up ? at <= low.across : at >= low.across) continue;
      if (!found || std::abs(at - low.across) < std::abs(*found - low.across)) found = at;
    }
    return found;
  }

  void say(Point at) const {
    bench_.report.say("seam_added", "the loop goes round the surface without a seam; cut along a new one", at,
                      bench_.at(at));
  }

  [[nodiscard]] Loop between(Loop a, Loop b) const {
    const Point end = a.back().end_at(), begin = a.front().begin_at();
    say(end);
    // The other begins where it is nearest along the way.
    std::size_t nearest = 0;
    double least = endless;
    for (std::size_t i = 0; i < b.size(); ++i) {
      const double by = along(b[i].begin_at()) - along(end);
      const double apart = std::abs(by - std::round(by / period()) * period());
      if (apart < least) least = apart, nearest = i;
    }
    const Vector once = b.back().end_at() - b.front().begin_at();
    Loop rotated;
    for (std::size_t i = 0; i < b.size(); ++i) {
      const bool again = i + nearest >= b.size();
      const double turns = std::round(along(Point{} + once) / period()) * period();
      rotated.push_back(shifted(b[(i + nearest) % b.size()], again ? place(turns, 0.0) - Point{} : Vector{}));
    }
    const auto periods = bench_.periods(end, rotated.front().begin_at());
    rotated = shifted(std::move(rotated), periods);
    if (of_u_ ? bench_.whole.period_v > 0.0 : bench_.whole.period_u > 0.0) rotated = beyond(std::move(rotated), a);
    const surf::trim::SharedCurveId shared = bench_.next_shared++;
    const Point other_begin = rotated.front().begin_at(), other_end = rotated.back().end_at();
    Loop loop = std::move(a);
    add_straight(loop, end, other_begin, false, shared, false);
    loop.insert(loop.end(), rotated.begin(), rotated.end());
    add_straight(loop, other_end, begin, false, shared, true);
    return loop;
  }

  /// On a torus: the other chain on the face's side of the first.
  [[nodiscard]] Loop beyond(Loop b, const Loop& a) const {
    const double around = of_u_ ? bench_.whole.period_v : bench_.whole.period_u;
    const bool forwards = along(a.back().end_at()) > along(a.front().begin_at());
    const double side = of_u_ == forwards ? 1.0 : -1.0;
    double by = side * (across(b.front().begin_at()) - across(a.back().end_at()));
    const double turns = -std::floor(by / around) * around;
    return shifted(std::move(b), place(0.0, side * turns) - Point{});
  }

  [[nodiscard]] Loop to_point(Loop a, double at) const {
    const Point end = a.back().end_at(), begin = a.front().begin_at();
    say(end);
    const surf::trim::SharedCurveId shared = bench_.next_shared++;
    const Point tip = place(along(end), at), back = place(along(begin), at);
    Loop loop = std::move(a);
    add_straight(loop, end, tip, false, shared, false);
    add_straight(loop, tip, back, true, std::nullopt, false);
    add_straight(loop, back, begin, false, shared, true);
    return loop;
  }

  const Bench& bench_;
  bool of_u_;
};

/// A beginning of a period at which no loop is cut.
std::optional<double> free_place(const std::vector<Loop>& loops, bool of_u, double low, double period) {
  constexpr int places = 64;
  std::optional<double> best;
  double widest = 0.0;
  for (int i = 0; i < places; ++i) {
    const double at = low + period * i / places;
    double room = period;
    for (const Loop& loop : loops) {
      const Box box = box_of(loop);
      const double from = of_u ? box.low.x : box.low.y, to = of_u ? box.high.x : box.high.y;
      double behind = at - from;
      behind -= std::floor(behind / period) * period;  // of the loop's beginning
      room = std::min({room, behind - (to - from), period - behind});
    }
    if (room > widest + 1e-9 * period) widest = room, best = at;
  }
  return best;
}

Outcome<Loop> natural_bounds(const Bench& bench, const std::vector<Loop>& holes) {
  Box box = bench.whole.range;
  if (!geom::is_finite(box.low) || !geom::is_finite(box.high))
    return Refusal{"face_endless", "it has no loop, and its surface has no end; give the face a wire"};
  const auto whole_turn = [](double range, double period) { return period > 0.0 && range >= period * (1.0 - 1e-9); };
  const bool round_u = whole_turn(box.width(), bench.whole.period_u);
  const bool round_v = whole_turn(box.height(), bench.whole.period_v);
  if (!holes.empty() && round_u) {
    const std::optional<double> at = free_place(holes, true, box.low.x, bench.whole.period_u);
    if (!at) return Refusal{"face_open", "its loops leave no room for a seam; give the face an outer wire"};
    box = {{*at, box.low.y}, {*at + bench.whole.period_u, box.high.y}};
  }
  if (!holes.empty() && round_v) {
    const std::optional<double> at = free_place(holes, false, box.low.y, bench.whole.period_v);
    if (!at) return Refusal{"face_open", "its loops leave no room for a seam; give the face an outer wire"};
    box = {{box.low.x, *at}, {box.high.x, *at + bench.whole.period_v}};
  }
  const auto is_point = [](const std::vector<double>& points, double at, double range) {
    return std::any_of(points.begin(), points.end(), [&](double p) { return std::abs(p - at) <= 1e-9 * range; });
  };
  std::optional<surf::trim::SharedCurveId> in_u, in_v;
  if (round_u) in_u = bench.next_shared++;
  if (round_v) in_v = bench.next_shared++;
  const Point a = box.low, b{box.high.x, box.low.y}, c = box.high, d{box.low.x, box.high.y};
  Loop loop;
  add_straight(loop, a, b, is_point(bench.whole.points_v, a.y, box.height()), in_v, false);
  add_straight(loop, b, c, is_point(bench.whole.points_u, b.x, box.width()), in_u, false);
  add_straight(loop, c, d, is_point(bench.whole.points_v, c.y, box.height()), in_v, true);
  add_straight(loop, d, a, is_point(bench.whole.points_u, a.x, box.width()), in_u, true);
  for (Piece& piece : loop) {
    if (!piece.shared && !piece.still) piece.name.clear();
  }
  bench.report.say("natural_bounds", "no loop bounds the face; it is taken as far as its surface goes", a, bench.at(a));
  return loop;
}

/// Within the outer loop by whole periods, if that is possible.
Vector periods_into(const Bench& bench, const std::vector<Point>& outer, Point at) {
  const auto turns = [](double period) { return period > 0.0 ? 3 : 0; };
  const int in_u = turns(bench.whole.period_u), in_v = turns(bench.whole.period_v);
  if (inside(outer, at)) return {};
  for (int i = -in_u; i <= in_u; ++i) {
    for (int j = -in_v; j <= in_v; ++j) {
      const Vector by{i * bench.whole.period_u, j * bench.whole.period_v};
      if (inside(outer, at + by)) return by;
    }
  }
  return {};
}

/// A place on the loop that is no end of an edge, where loops may touch.
Point middle_of(const Loop& loop) {
  const Piece& piece = loop.front();
  return piece.at(std::lerp(piece.from, piece.to, 0.4871));
}

void turn_by_nesting(const Bench& bench, std::vector<Loop>& loops) {
  std::vector<std::vector<Point>> outlines;
  for (const Loop& loop : loops) outlines.push_back(outline(loop));
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::size_t depth = 0;
    for (std::size_t j = 0; j < loops.size(); ++j) {
      if (j == i || !inside(outlines[j], middle_of(loops[i]))) continue;
      // Of two that hold each other by rounding, the greater one is outside.
      if (std::abs(area_of(outlines[j])) > std::abs(area_of(outlines[i]))) ++depth;
    }
    const bool outer = depth % 2 == 0;
    if ((area_of(outlines[i]) > 0.0) == outer) continue;
    const Point at = loops[i].front().begin_at();
    bench.report.say("loop_turned",
                     outer ? "the outer loop runs clockwise; turned so that the face is on its left"
                           : "a hole runs anticlockwise; turned so that the face is on its left",
                     at, bench.at(at));
    loops[i] = turned(std::move(loops[i]));
  }
}

/// Covers all of a surface without borders, but for holes.
bool is_closed(const WholeSurface& whole) {
  const auto closes = [](double period, const std::vector<double>& points) {
    return period > 0.0 || points.size() >= 2;
  };
  return closes(whole.period_u, whole.points_u) && closes(whole.period_v, whole.points_v);
}

}  // namespace

Outcome<std::vector<Loop>> loops_of(const Bench& bench, std::vector<Chain> chains, Loop& lines) {
  std::vector<Loop> loops;
  for (const bool of_u : {true, false}) {
    auto closed = Seams(bench, of_u).close(chains);
    if (auto* refusal = std::get_if<Refusal>(&closed)) return *refusal;
    for (Loop& loop : std::get<std::vector<Loop>>(closed)) loops.push_back(joined(bench, std::move(loop)));
  }
  for (Chain& chain : chains) {
    if (chain.round != Vector{}) {
      const Point at = chain.pieces.front().begin_at();
      return Refusal{"face_open", "its loop goes round the surface in both parameters; cut the face", at, bench.at(at)};
    }
    loops.push_back(joined(bench, std::move(chain.pieces)));
  }
  const bool all_holes =
      std::all_of(loops.begin(), loops.end(), [](const Loop& loop) { return area_of(outline(loop)) < 0.0; });
  if (loops.empty() || (all_holes && is_closed(bench.whole))) {
    auto bounds = natural_bounds(bench, loops);
    if (auto* refusal = std::get_if<Refusal>(&bounds)) return *refusal;
    loops.insert(loops.begin(), std::get<Loop>(std::move(bounds)));
  }
  const auto outer = std::max_element(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(area_of(outline(a))) < std::abs(area_of(outline(b)));
  });
  const std::vector<Point> outside = outline(*outer);
  for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
    if (loop != outer) *loop = shifted(std::move(*loop), periods_into(bench, outside, middle_of(*loop)));
  }
  for (Piece& line : lines) line = shifted(line, periods_into(bench, outside, middle_of({line})));
  turn_by_nesting(bench, loops);
  return loops;
}

}  // namespace dobra::io::faces
