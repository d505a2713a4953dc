#include "recon/balance/shortening.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "recon/balance/percent.h"
#include "shared/base/parallel.h"
#include "shared/geom/segment_tree.h"

namespace recon::balance {

namespace {

/// A horizon, ready to be looked at from others.
struct Trace {
  const geom::Polyline* line = nullptr;
  std::vector<double> arc;
  geom::SegmentTree tree;
};

Trace trace_of(const geom::Polyline& line) {
  std::vector<geom::Segment> segments;
  for (std::size_t i = 0; i < line.segment_count(); ++i) segments.push_back(line.segment(i));
  return {&line, geom::arc_lengths(line), geom::SegmentTree(std::move(segments))};
}

/// Arc length of the place of a line that is nearest to p.
double beside(const Trace& trace, geom::Point p) {
  const auto nearest = trace.tree.nearest(p, [](std::size_t) { return true; });
  const double part = geom::nearest_fraction(trace.tree.segment(nearest->index), p);
  return (1.0 - part) * trace.arc[nearest->index] + part * trace.arc[nearest->index + 1];
}

/// A line across two beds by a place on each, arc lengths, m.
struct Across {
  double on_one = 0.0;
  double on_other = 0.0;
};

geom::Point point_of(const Trace& trace, double arc) { return geom::point_at(*trace.line, trace.arc, arc); }

/// How far a line across leaves the normal of a bed, 0 .. pi / 2: of the bed as far as the line is long.
double slant(const Trace& trace, double arc, geom::Vector across) {
  const double half = 0.5 * geom::length(across);
  if (half == 0.0) return 0.0;
  const geom::Vector along =
      point_of(trace, std::min(arc + half, trace.arc.back())) - point_of(trace, std::max(arc - half, 0.0));
  return std::atan2(std::abs(geom::dot(across, along)), std::abs(geom::cross(across, along)));
}

/// Do two ends lie on one border of the section: upright, or square to the regional?
bool is_border(geom::Vector across, geom::Vector regional) {
  constexpr double nearly = 0.05;
  const double length = geom::length(across);
  return std::abs(across.x) <= nearly * length ||
         std::abs(geom::dot(across, regional)) <= nearly * length * geom::length(regional);
}

/// The material line that bounds what two beds share at one end: through both ends where they lie on one border; else
/// through the end of one and beside it on the other, if that is square to both beds.
Across bound(const Trace& one, double end_of_one, const Trace& other, double end_of_other) {
  const auto total_slant = [&](Across at) {
    const geom::Vector across = point_of(other, at.on_other) - point_of(one, at.on_one);
    return slant(one, at.on_one, across) + slant(other, at.on_other, across);
  };
  constexpr double clearly = 0.75;  // of beds that are not parallel no line is square to both
  Across best{end_of_one, end_of_other};
  const Trace& longer = one.arc.back() > other.arc.back() ? one : other;
  if (is_border(point_of(other, end_of_other) - point_of(one, end_of_one),
                longer.line->points.back() - longer.line->points.front()))
    return best;
  double least = clearly * total_slant(best);
  for (const Across at : {Across{beside(one, point_of(other, end_of_other)), end_of_other},
                          Across{end_of_one, beside(other, point_of(one, end_of_one))}}) {
    const double here = total_slant(at);
    if (here >= least) continue;
    least = here;
    best = at;
  }
  return best;
}

/// Arc lengths, m.
struct Shared {
  double from = 0.0;
  double to = 0.0;
  [[nodiscard]] double length() const { return to - from; }
};

/// Beds one after the other have their ends beside each other, and no more.
bool lie_beside(const Trace& one, const Trace& other) {
  const double rounding = 1e-9 * std::min(one.arc.back(), other.arc.back());
  return beside(one, other.line->points.back()) - beside(one, other.line->points.front()) > rounding &&
         beside(other, one.line->points.back()) - beside(other, one.line->points.front()) > rounding;
}

BedLength length_of(const Trace& trace, Shared part) {
  return {part.length(), point_of(trace, part.to) - point_of(trace, part.from)};
}

using Traces = std::vector<Trace>;

/// Over all that the pieces of both beds share.
std::array<BedLength, 2> shared_lengths(const Traces& one, const Traces& other) {
  std::array<BedLength, 2> sums;
  for (const Trace& a : one) {
    for (const Trace& b : other) {
      if (!lie_beside(a, b)) continue;
      const Across first = bound(a, 0.0, b, 0.0);
      const Across last = bound(a, a.arc.back(), b, b.arc.back());
      sums[0] += length_of(a, {first.on_one, last.on_one});
      sums[1] += length_of(b, {first.on_other, last.on_other});
    }
  }
  return sums;
}

}  // namespace

BedLength bed_length(const geom::Polyline& line) {
  return {geom::length(line), line.points.back() - line.points.front()};
}

BedLength& BedLength::operator+=(const BedLength& piece) {
  length += piece.length;
  straight = straight + piece.straight;
  return *this;
}

Consistency consistency_of(const std::vector<section::Horizon>& horizons) {
  Consistency result;
  std::vector<std::string> names;
  std::vector<std::vector<std::size_t>> beds;
  for (std::size_t i = 0; i < horizons.size(); ++i) {
    const std::string& name = whole_name(horizons[i]);
    const bool growth = horizons[i].role == section::BedRole::Growth;
    std::vector<std::string>& known = growth ? result.not_judged : names;
    const auto found = std::find(known.begin(), known.end(), name);
    const auto bed = static_cast<std::size_t>(found - known.begin());
    if (found == known.end()) known.push_back(name);
    if (growth) continue;
    if (bed == beds.size()) beds.emplace_back();
    beds[bed].push_back(i);
  }
  const auto traces = base::parallel_map<Traces>(beds.size(), [&](std::size_t bed) {
    Traces made;
    for (const std::size_t i : beds[bed]) made.push_back(trace_of(horizons[i].line));
    return made;
  });
  for (std::size_t i = 0; i < beds.size(); ++i) {
    for (std::size_t k = i + 1; k < beds.size(); ++k) {
      const std::array<BedLength, 2> part = shared_lengths(traces[i], traces[k]);
      if (!(part[0].length > 0.0)) continue;
      ++result.compared;
      ShorteningPair pair{names[i], names[k], part[0].shortening(), part[1].shortening()};
      if (pair.shortening_one < pair.shortening_other) {
        std::swap(pair.one, pair.other);
        std::swap(pair.shortening_one, pair.shortening_other);
      }
      pair.shared = std::max(part[0].length, part[1].length);
      pair.percent = 100.0 * (pair.shortening_one - pair.shortening_other) / pair.shared;
      if (result.worst.one.empty() || pair.percent > result.worst.percent) result.worst = std::move(pair);
    }
  }
  return result;
}

BalanceVerdict verdict_of(const Consistency& consistency, double greatest, double tolerance) {
  if (!(greatest <= tolerance)) return BalanceVerdict::NotBalanced;
  return consistency.compared > 0 ? BalanceVerdict::Balanced : BalanceVerdict::NotJudged;
}

const char* verdict_name(BalanceVerdict verdict) {
  constexpr std::array names{"balanced", "not balanced", "not judged"};
  return names[static_cast<std::size_t>(verdict)];
}

const char* verdict_words(BalanceVerdict verdict) {
  return verdict == BalanceVerdict::NotJudged ? "nothing to judge" : verdict_name(verdict);
}

std::string consistency_text(const Consistency& consistency) {
  const ShorteningPair& worst = consistency.worst;
  std::string text =
      worst.one.empty()
          ? "no two beds lie beside each other, so that their shortening is not compared"
          : fmt::format(
                "shortening differs by {} % between beds (over the {:.6g} m that they share '{}' is shorter by "
                "{:.6g} m, '{}' by {:.6g} m)",
                percent_text(worst.percent), worst.shared, worst.one, worst.shortening_one, worst.other,
                worst.shortening_other);
  for (std::size_t i = 0; i < consistency.not_judged.size(); ++i)
    text += fmt::format("{}'{}'", i == 0 ? "; not judged, as growth: " : ", ", consistency.not_judged[i]);
  return text;
}

}  // namespace recon::balance
