#include "shared/surf/trim/area.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <vector>

#include "shared/surf/details.h"

namespace dobra::surf::trim {

using geom::Box;
using geom::Point;

namespace {

/// Places on -1 .. 1 with the weights of Kronrod's rule, and of Gauss's with every other of them.
struct KronrodRule {
  std::vector<double> at, weight, gauss;
  template <unsigned Count>
  static KronrodRule of() {
    using Kronrod = boost::math::quadrature::gauss_kronrod<double, Count>;
    using Gauss = boost::math::quadrature::gauss<double, Count / 2>;
    constexpr std::size_t middle = Count / 2;
    KronrodRule made{std::vector<double>(Count), std::vector<double>(Count), std::vector<double>(Count)};
    for (std::size_t i = 0; i <= middle; ++i) {
      made.at[middle + i] = Kronrod::abscissa()[i], made.at[middle - i] = -made.at[middle + i];
      made.weight[middle + i] = made.weight[middle - i] = Kronrod::weights()[i];
      // Gauss's places are the middle and every second from it, or those between.
      if (i % 2 == 1 - middle % 2) made.gauss[middle + i] = made.gauss[middle - i] = Gauss::weights()[i / 2];
    }
    return made;
  }
  /// Three places are Gauss's own; the middle alone is the rule to compare with.
  static KronrodRule of_three() {
    const double out = std::sqrt(0.6);
    return {{-out, 0.0, out}, {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}, {0.0, 2.0, 0.0}};
  }
  [[nodiscard]] std::size_t size() const { return at.size(); }
};
/// The one with most places of which so many pairs of pieces need no more than `most` in both ways.
const KronrodRule& kronrod_rule(double pairs, double most) {
  static const KronrodRule fine = KronrodRule::of<15>(), middling = KronrodRule::of<7>(),
                           coarse = KronrodRule::of_three();
  if (pairs * 15.0 * 15.0 <= most) return fine;
  return pairs * 7.0 * 7.0 <= most ? middling : coarse;
}

/// The area element summed along u from the left of the chart.
class Strip {
 public:
  /// @param most  places that it looks at; beyond them it halves no more, and tells the error.
  Strip(const Surface& surface, const KronrodRule& rule, double tolerance, std::size_t most)
      : surface_(surface), rule_(rule), tolerance_(tolerance), most_(most), uv_(rule.size()), jets_(rule.size()) {}

  [[nodiscard]] const KronrodRule& rule() const { return rule_; }
  /// Places that were looked at.
  [[nodiscard]] std::size_t seen() const { return seen_; }

  [[nodiscard]] Measured to(Point uv) const {
    const std::vector<double>& breaks = surface_.breaks().u;
    Measured sum;
    double last = breaks.front();
    if (uv.x < last) {
      sum = part(uv.x, last, uv.y, 0);
      return {-sum.value, sum.error};
    }
    for (std::size_t i = 1; i < breaks.size() && last < uv.x; ++i) {
      const double end = i + 1 == breaks.size() ? uv.x : std::min(breaks[i], uv.x);
      const Measured more = part(last, end, uv.y, 0);
      sum = {sum.value + more.value, sum.error + more.error};
      last = end;
    }
    return sum;
  }

 private:
  /// @param unseen  halvings of parts that were not seen, beside `depth` for the tolerance
  [[nodiscard]] Measured part(double from, double to, double v, int depth, int unseen = 0) const {
    const double half = 0.5 * (to - from), middle = from + half;
    for (std::size_t i = 0; i < rule_.size(); ++i) uv_[i] = {middle + half * rule_.at[i], v};
    surface_.jets(uv_, jets_);
    double kronrod = 0.0, gauss = 0.0;
    for (std::size_t i = 0; i < rule_.size(); ++i) {
      const double element = geom::length(cross(jets_[i].u, jets_[i].v));
      kronrod += rule_.weight[i] * element;
      gauss += rule_.gauss[i] * element;
    }
    seen_ += rule_.size();
    const Measured alone{half * kronrod, std::abs(half * (kronrod - gauss))};
    constexpr int deepest = 14, deepest_unseen = 24;
    if (depth == 0 && unseen < deepest_unseen && !surface_.seen({{std::min(from, to), v}, {std::max(from, to), v}})) {
      if (seen_ >= most_) return {alone.value, std::abs(alone.value)};
      const Measured a = part(from, middle, v, 0, unseen + 1), b = part(middle, to, v, 0, unseen + 1);
      return {a.value + b.value, a.error + b.error};
    }
    if (!(alone.error > tolerance_ * std::abs(alone.value) + 1e-300) || depth == deepest || seen_ >= most_)
      return alone;
    const Measured a = part(from, middle, v, depth + 1), b = part(middle, to, v, depth + 1);
    return {a.value + b.value, a.error + b.error};
  }

  const Surface& surface_;
  const KronrodRule& rule_;
  double tolerance_;
  std::size_t most_;
  mutable std::size_t seen_ = 0;
  mutable std::vector<Point> uv_;
  mutable std::vector<Jet> jets_;
};

/// A part of an edge, followed forwards or backwards.
struct LoopPart {
  const ChartEdge* edge = nullptr;
  double from = 0.0, to = 0.0;
  Measured area;
  double along = 0.0;  ///< The error that halving lowers: the rest is in the strips, whose ends they are.
  int depth = 0;
  bool operator<(const LoopPart& other) const { return along < other.along; }
};

void measure_part(const Strip& strip, LoopPart& piece) {
  const double half = 0.5 * (piece.to - piece.from), middle = piece.from + half;
  double kronrod = 0.0, gauss = 0.0, inner = 0.0;
  const KronrodRule& rule = strip.rule();
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const Curve::Jet jet = piece.edge->curve.jet(middle + half * rule.at[i]);
    const double slope = jet.first.y;
    if (slope == 0.0) continue;
    const Measured to_here = strip.to({jet.at.x, jet.at.y});
    kronrod += rule.weight[i] * slope * to_here.value;
    gauss += rule.gauss[i] * slope * to_here.value;
    inner += rule.weight[i] * std::abs(slope) * to_here.error;
  }
  piece.along = std::abs(half * (kronrod - gauss));
  piece.area = {half * kronrod, piece.along + std::abs(half) * inner};
}

/// Where along v narrow peaks of the surface begin and end, ascending; of each octave of their heights not more than so
/// many: those of a ridge are alike.
std::vector<double> levels_of_details(const TrimmedSurface& face) {
  constexpr std::size_t most = 24;
  Box box;
  for (const ChartLoop& loop : face.loops) {
    for (const ChartEdge& edge : loop.edges) {
      for (int i = 0; i <= 8; ++i) box.add(edge.at(std::lerp(edge.from, edge.to, i / 8.0)));
    }
  }
  if (box.empty()) return {};
  const DetailOptions options;
  std::map<int, std::set<double>> by_height;
  for (const Box& part : details_of(face.surface, box, options).parts) {
    if (part.height() < options.look * face.surface.chart().height())
      by_height[std::ilogb(part.height())].insert({part.low.y, part.high.y});
  }
  std::set<double> kept;
  for (const auto& [octave, levels] : by_height) {
    const std::size_t step = (levels.size() + most - 1) / most;
    std::size_t i = 0;
    for (const double level : levels) {
      if (i++ % step == 0) kept.insert(level);
    }
    kept.insert(*levels.rbegin());
  }
  return {kept.begin(), kept.end()};
}

/// Parameters at which the edge has a break, or passes one of the surface or a level of v; ends included, in the edge's
/// direction.
std::vector<double> part_cuts_of(const Surface& surface, const ChartEdge& edge, const std::vector<double>& levels) {
  const double low = std::min(edge.from, edge.to), high = std::max(edge.from, edge.to);
  std::vector<double> cuts{low};
  for (const double at : edge.curve.breaks()) {
    if (at > low && at < high) cuts.push_back(at);
  }
  cuts.push_back(high);
  std::vector<double> more;
  constexpr int places = 16;
  const auto passes = [&](double a, double b, double at, bool of_u) {
    const auto beside = [&](double t) { return (of_u ? edge.at(t).x : edge.at(t).y) - at; };
    if (beside(a) * beside(b) >= 0.0) return;
    const bool rises = beside(b) > 0.0;
    for (int i = 0; i < 60; ++i) {
      const double m = 0.5 * (a + b);
      ((beside(m) > 0.0) == rises ? b : a) = m;
    }
    more.push_back(0.5 * (a + b));
  };
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    for (int k = 0; k < places; ++k) {
      const double a = std::lerp(cuts[i - 1], cuts[i], static_cast<double>(k) / places);
      const double b = std::lerp(cuts[i - 1], cuts[i], (k + 1.0) / places);
      for (const double u : surface.breaks().u) passes(a, b, u, true);
      for (const double v : surface.breaks().v) passes(a, b, v, false);
      for (const double v : levels) passes(a, b, v, false);
    }
  }
  cuts.insert(cuts.end(), more.begin(), more.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  if (edge.from > edge.to) std::reverse(cuts.begin(), cuts.end());
  return cuts;
}

/// Of the box of the loops, roughly.
double area_of_loop_box(const TrimmedSurface& face) {
  Box box;
  for (const ChartLoop& loop : face.loops) {
    for (const ChartEdge& edge : loop.edges) {
      for (int i = 0; i <= 8; ++i) box.add(edge.at(std::lerp(edge.from, edge.to, i / 8.0)));
    }
  }
  double sum = 0.0;
  constexpr int places = 5;
  for (int i = 0; i < places * places; ++i) {
    const Jet jet = face.surface.jet({std::lerp(box.low.x, box.high.x, (i / places + 0.5) / places),
                                      std::lerp(box.low.y, box.high.y, (i % places + 0.5) / places)});
    sum += geom::length(cross(jet.u, jet.v));
  }
  return box.empty() ? 0.0 : sum / (places * places) * box.width() * box.height();
}

/// @param spent  whether more places were wanted than are looked at
Measured area_within(const TrimmedSurface& face, double tolerance, bool& spent) {
  constexpr std::size_t most_in_strips = 3'000'000, most_places = 6'000'000;
  std::vector<LoopPart> parts;
  const std::vector<double> levels = levels_of_details(face);
  for (const ChartLoop& loop : face.loops) {
    for (const ChartEdge& edge : loop.edges) {
      const std::vector<double> cuts = part_cuts_of(face.surface, edge, levels);
      for (std::size_t i = 1; i < cuts.size(); ++i) parts.push_back({&edge, cuts[i - 1], cuts[i], {}, 0.0, 0});
    }
  }
  // A grid of many pieces has small ones: few places do on each.
  const double pairs = static_cast<double>(parts.size()) * static_cast<double>(face.surface.breaks().u.size());
  const Strip strip(face.surface, kronrod_rule(0.5 * pairs, 0.5 * most_in_strips), 0.1 * tolerance, most_in_strips);
  std::priority_queue<LoopPart> pieces;
  Measured sum;
  double along = 0.0;
  const auto add = [&](LoopPart piece) {
    measure_part(strip, piece);
    along += piece.along;
    sum.value += piece.area.value;
    sum.error += piece.area.error;
    pieces.push(piece);
  };
  for (const LoopPart& part : parts) add(part);
  constexpr double thin = 1e-3;
  constexpr std::size_t most = 20'000;
  constexpr int deepest = 40;
  const double least = thin * area_of_loop_box(face);
  while (!pieces.empty() && pieces.size() < most && strip.seen() < most_places &&
         along > tolerance * std::max(std::abs(sum.value), least)) {
    const LoopPart worst = pieces.top();
    pieces.pop();
    if (worst.depth == deepest) continue;  // its error stays in the sum
    sum.value -= worst.area.value;
    sum.error -= worst.area.error;
    along -= worst.along;
    const double middle = 0.5 * (worst.from + worst.to);
    add({worst.edge, worst.from, middle, {}, 0.0, worst.depth + 1});
    add({worst.edge, middle, worst.to, {}, 0.0, worst.depth + 1});
  }
  spent = strip.seen() >= most_in_strips;
  return sum;
}

/// Whether the loops are the border of the chart, anticlockwise, and nothing else.
bool is_whole_chart(const TrimmedSurface& face) {
  if (face.loops.size() != 1) return false;
  const Box& chart = face.surface.chart();
  constexpr double beside = 1e-12, full = 1.0 - 1e-9;
  constexpr int places = 8;
  const double u = beside * chart.width(), v = beside * chart.height();
  double twice = 0.0;
  for (const ChartEdge& edge : face.loops[0].edges) {
    Point before = edge.at(edge.from);
    for (int i = 1; i <= places; ++i) {
      const Point here = edge.at(std::lerp(edge.from, edge.to, static_cast<double>(i) / places));
      const bool on_side = std::abs(here.x - chart.low.x) <= u || std::abs(here.x - chart.high.x) <= u ||
                           std::abs(here.y - chart.low.y) <= v || std::abs(here.y - chart.high.y) <= v;
      if (!on_side) return false;
      twice += cross(before - chart.low, here - chart.low);
      before = here;
    }
  }
  return 0.5 * twice >= full * chart.width() * chart.height();
}

}  // namespace

Measured area(const TrimmedSurface& face, double tolerance) {
  const bool plain = face.surface.seen(face.surface.chart());
  // Of a graph that bends closely cells are better than strips.
  if (!plain && is_whole_chart(face)) return surf::area(face.surface, tolerance);
  // What is left when the places are spent is of one rule alone: less is asked everywhere rather.
  constexpr double coarser = 100.0, coarsest = 1e-3, enough = 1e-5;
  bool spent = false;
  Measured best = area_within(face, tolerance, spent);
  for (double asked = coarser * tolerance;
       !plain && spent && asked <= coarsest && !(best.error <= std::max(enough, asked) * std::abs(best.value));
       asked *= coarser) {
    const Measured next = area_within(face, asked, spent);
    if (next.error < best.error || !std::isfinite(best.error)) best = next;
  }
  return best;
}

}  // namespace dobra::surf::trim
