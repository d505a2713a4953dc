// Pieces of a wire put in order, and their ends joined.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "shared/io/faces/loops.h"

namespace dobra::io::faces {

using geom::Point;
using geom::Vector;

double Bench::stretch(Point a, Point b) const {
  constexpr int chords = 8;
  double sum = 0.0;
  geom::Point3 last = at(a);
  for (int i = 1; i <= chords; ++i) {
    const geom::Point3 next = at(geom::interpolate(a, b, static_cast<double>(i) / chords));
    sum += geom::distance(last, next);
    last = next;
  }
  return sum;
}

double Bench::allowed(const Piece& a, const Piece& b) const {
  return std::max(options.gap_tolerances * std::max(a.tolerance, b.tolerance), options.gap_part * diagonal);
}

Vector Bench::periods(Point a, Point b) const {
  const auto of = [](double by, double period) { return period > 0.0 ? std::round(by / period) * period : 0.0; };
  return {of(a.x - b.x, whole.period_u), of(a.y - b.y, whole.period_v)};
}

namespace {

/// May a piece lie whole periods beside its neighbours?
enum class Periods { None, Any };

/// How the next piece fits behind a place.
struct Fit {
  Vector by;         ///< Whole periods.
  double gap = 0.0;  ///< Length in space, m.
};
Fit fit_of(const Bench& bench, Point end, Point begin, Periods periods = Periods::Any) {
  const Vector by = periods == Periods::Any ? bench.periods(end, begin) : Vector{};
  return {by, bench.stretch(end, begin + by)};
}

void say_shifted(const Bench& bench, const Piece& piece, Vector by) {
  const Point at = piece.begin_at();
  bench.report.say("period_shifted",
                   fmt::format("{} lies a period beside its neighbours in the chart; moved by ({:.6g}, {:.6g})",
                               piece.name, by.x, by.y),
                   at, bench.at(at));
}

/// In the order given, or nothing where an end is far from the next beginning.
std::optional<Chain> in_order(const Bench& bench, const Loop& wire, Periods periods) {
  Chain chain{{wire.front()}};
  std::vector<std::pair<std::size_t, Vector>> moved;
  for (std::size_t i = 1; i < wire.size(); ++i) {
    const Piece& last = chain.pieces.back();
    const Fit fit = fit_of(bench, last.end_at(), wire[i].begin_at(), periods);
    if (fit.gap > bench.allowed(last, wire[i])) return std::nullopt;
    const Vector before = moved.empty() ? Vector{} : moved.back().second;
    if (fit.by != before && !last.still && !wire[i].still) moved.emplace_back(i, fit.by);
    chain.pieces.push_back(shifted(wire[i], fit.by));
  }
  const Fit home = fit_of(bench, chain.pieces.back().end_at(), wire.front().begin_at());
  if (home.gap > bench.allowed(chain.pieces.back(), wire.front())) return std::nullopt;
  chain.round = home.by;
  for (const auto& [i, by] : moved) say_shifted(bench, wire[i], by);
  return chain;
}

/// The piece that begins nearest to an end.
struct Next {
  std::size_t piece = 0;
  Fit fit{{}, std::numeric_limits<double>::infinity()};
  bool turn = false;
  [[nodiscard]] bool any() const { return std::isfinite(fit.gap); }
};
Next next_of(const Bench& bench, const Piece& last, const Loop& left, Periods periods) {
  Next best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (const bool turn : {false, true}) {
      if (turn && periods == Periods::None) continue;  // as the file has them first
      const Fit fit = fit_of(bench, last.end_at(), turn ? left[i].end_at() : left[i].begin_at(), periods);
      const double most = bench.allowed(last, left[i]);
      if (fit.gap > most) continue;
      // What must be turned comes last, what has another vertex or needs a period before that.
      const std::size_t vertex = turn ? left[i].end : left[i].start;
      const double rank = fit.gap + (turn ? 8.0 * most : 0.0) + (vertex != last.end ? 4.0 * most : 0.0) +
                          (fit.by != Vector{} ? 2.0 * most : 0.0);
      if (rank < least) least = rank, best = {i, fit, turn};
    }
  }
  return best;
}

Refusal open_at(const Bench& bench, const Piece& last, const Loop& left, const Piece& first) {
  double least = fit_of(bench, last.end_at(), first.begin_at()).gap;
  for (const Piece& piece : left) least = std::min(least, fit_of(bench, last.end_at(), piece.begin_at()).gap);
  const Point at = last.end_at();
  return {"face_open",
          fmt::format("its loop is open: behind {} the nearest edge begins {:.6g} m away, {:.6g} m are allowed; close "
                      "the wire",
                      last.name, least, bench.allowed(last, first)),
          at, bench.at(at)};
}

struct Sorted {
  std::vector<Chain> chains;
  bool any_turned = false, any_shifted = false;
};

/// Each piece behind the one at whose end it begins, from the first of the wire on.
Outcome<Sorted> sorted(const Bench& bench, Loop wire, Periods periods) {
  Sorted made;
  while (!wire.empty()) {
    Chain chain{{wire.front()}};
    wire.erase(wire.begin());
    while (true) {
      const Piece last = chain.pieces.back(), first = chain.pieces.front();
      const Fit home = fit_of(bench, last.end_at(), first.begin_at());
      const bool closes = home.gap <= bench.allowed(last, first);
      const Next next = next_of(bench, last, wire, periods);
      if (!closes && !next.any()) return open_at(bench, last, wire, first);
      // Home at once; round a period only where nothing follows in its own place.
      const bool meets = next.any() && !next.turn && next.fit.by == Vector{};
      const bool better =
          meets && (home.by != Vector{} || (last.end != first.start && wire[next.piece].start == last.end));
      if (closes && !better) {
        chain.round = home.by;
        break;
      }
      made.any_turned = made.any_turned || next.turn;
      made.any_shifted = made.any_shifted || next.fit.by != Vector{};
      Piece piece = next.turn ? turned(wire[next.piece]) : wire[next.piece];
      chain.pieces.push_back(shifted(std::move(piece), next.fit.by));
      wire.erase(wire.begin() + static_cast<std::ptrdiff_t>(next.piece));
    }
    made.chains.push_back(std::move(chain));
  }
  return made;
}

/// The order in a wire is free by the format, so it is no remark.
void say_order(const Bench& bench, const Sorted& sorted) {
  const Point at = sorted.chains.front().pieces.front().begin_at();
  if (sorted.any_turned)
    bench.report.say("edge_turned", "edges of the loop run against each other; turned to follow each other", at,
                     bench.at(at));
  if (sorted.any_shifted)
    bench.report.say("period_shifted", "edges of the loop lie a period beside each other in the chart; moved", at,
                     bench.at(at));
  if (sorted.chains.size() > 1)
    bench.report.say("loop_split", fmt::format("a wire holds {} loops; taken apart", sorted.chains.size()), at,
                     bench.at(at));
}

}  // namespace

Outcome<std::vector<Chain>> chained(const Bench& bench, Loop wire) {
  if (wire.empty()) return std::vector<Chain>{};
  const Loop backwards(wire.rbegin(), wire.rend());  // the format has lists of either order
  for (const Periods periods : {Periods::None, Periods::Any}) {
    for (const Loop* order : {&std::as_const(wire), &backwards}) {
      if (std::optional<Chain> chain = in_order(bench, *order, periods)) return std::vector<Chain>{*std::move(chain)};
    }
    auto made = sorted(bench, wire, periods);
    if (const Sorted* done = std::get_if<Sorted>(&made)) {
      say_order(bench, *done);
      return done->chains;
    }
    if (periods == Periods::Any) return std::get<Refusal>(made);
  }
  return std::vector<Chain>{};
}

Loop joined(const Bench& bench, Loop loop) {
  const std::size_t count = loop.size();
  std::vector<Point> begins(count), ends(count);
  std::vector<std::optional<std::pair<Point, Point>>> bridges(count);  // behind piece i
  double widest = 0.0;
  std::size_t gaps = 0;
  std::optional<Point> where;
  const geom::Box& chart = bench.surface.chart();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Point a = loop[i].end_at(), b = loop[j].begin_at();
    ends[i] = begins[j] = a;
    if (a == b) continue;
    const double apart = std::max(std::abs(a.x - b.x) / chart.width(), std::abs(a.y - b.y) / chart.height());
    constexpr double beside = 1e-3;  // what is farther apart in the chart and not in space lies along a point
    if (apart > beside && bench.stretch(a, b) < 1e-2 * apart * bench.diagonal) {
      bridges[i] = {a, b};
      begins[j] = b;
      continue;
    }
    // A side that is one point, and a seam, keep their places.
    const bool keeps_a = loop[i].still, keeps_b = loop[j].still;
    ends[i] = begins[j] = keeps_a == keeps_b ? geom::midpoint(a, b) : keeps_a ? a : b;
    const double gap = geom::distance(bench.at(a), bench.at(b));
    if (gap > 1e-9 * bench.diagonal) ++gaps;
    if (gap > widest) widest = gap, where = ends[i];
  }
  Loop made;
  for (std::size_t i = 0; i < count; ++i) {
    const bool moves = loop[i].begin_at() != begins[i] || loop[i].end_at() != ends[i];
    made.push_back(moves ? reaching(loop[i], begins[i], ends[i]) : loop[i]);
    if (!bridges[i]) continue;
    Piece side = straight(bridges[i]->first, bridges[i]->second);
    side.still = true;
    side.start = side.end = loop[i].end;
    side.name = loop[i].name;
    made.push_back(std::move(side));
    bench.report.say("side_added", "the loop has no edge along a side of the chart that is one point; added",
                     bridges[i]->first, bench.at(bridges[i]->first));
  }
  if (gaps > 0)
    bench.report.say("gap_closed",
                     fmt::format("gaps between edges of a loop closed: {}, the widest of {:.6g} m", gaps, widest),
                     where, bench.at(*where));
  return made;
}

void take_out_twice(const Bench& bench, std::vector<Loop>& wires, Loop& lines) {
  struct Where {
    std::size_t wire, piece;
  };
  std::vector<std::vector<bool>> out;
  for (const Loop& wire : wires) out.emplace_back(wire.size(), false);
  const auto piece_at = [&](Where w) -> const Piece& { return wires[w.wire][w.piece]; };
  const auto meet = [&](Where a, Where b) {
    const Piece &p = piece_at(a), &q = piece_at(b);
    if (out[a.wire][a.piece] || out[b.wire][b.piece] || p.edge != q.edge || p.shared != q.shared || p.still) return;
    if (p.drawn != q.drawn) return;
    out[b.wire][b.piece] = true;
    const Point at = p.begin_at();
    if (p.against == q.against) {
      bench.report.say("edge_twice", fmt::format("{} stands twice in the loops; taken once", p.name), at, bench.at(at));
      return;
    }
    out[a.wire][a.piece] = true;
    bench.report.say("edge_twice",
                     fmt::format("{} bounds the face on both of its sides; taken as a line inside", p.name), at,
                     bench.at(at));
    lines.push_back(p.against ? turned(p) : p);
  };
  std::vector<Where> all;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    for (std::size_t k = 0; k < wires[w].size(); ++k) all.push_back({w, k});
  }
  std::sort(all.begin(), all.end(), [&](Where a, Where b) {
    return std::tuple(piece_at(a).edge, a.wire, a.piece) < std::tuple(piece_at(b).edge, b.wire, b.piece);
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size() && piece_at(all[j]).edge == piece_at(all[i]).edge; ++j)
      meet(all[i], all[j]);
  }
  for (std::size_t w = 0; w < wires.size(); ++w) {
    Loop kept;
    for (std::size_t k = 0; k < wires[w].size(); ++k) {
      if (!out[w][k]) kept.push_back(std::move(wires[w][k]));
    }
    wires[w] = std::move(kept);
  }
}

}  // namespace dobra::io::faces
