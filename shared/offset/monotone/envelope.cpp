#include "shared/offset/monotone/envelope.h"

#include <algorithm>
#include <limits>

#include "shared/geom/predicates.h"
#include "shared/offset/monotone/mitre_envelope.h"

namespace dobra::offset::monotone {

using geom::Point;
using geom::Vector;

namespace {

/// The middle of all directions if all are well forward along the chord of the base; else it takes more to tell.
std::optional<Vector> plain_direction(const BaseCurve& base) {
  const Vector chord = base.points.back() - base.points.front();
  const double length = geom::length(chord);
  if (!(length > 0)) return std::nullopt;
  const Vector forward = chord / length;
  Vector right = base.headings[0];
  Vector left = base.headings[0];
  double least = 1.0;
  for (const Vector u : base.headings) {
    least = std::min(least, geom::dot(u, forward));
    if (geom::cross(right, u) < 0) right = u;
    if (geom::cross(left, u) > 0) left = u;
  }
  if (!(least > 1e-3)) return std::nullopt;  // far above rounding
  const Vector sum = right + left;
  return sum / geom::length(sum);
}

}  // namespace

std::optional<Vector> monotone_direction(const BaseCurve& base) {
  if (base.closed || base.segment_count() >= mitred) return std::nullopt;
  if (const auto plain = plain_direction(base)) return plain;
  // The segments with the rightmost and the leftmost direction so far; they span less than half a turn.
  std::size_t right = 0;
  std::size_t left = 0;
  const auto cross = [&](std::size_t i, std::size_t j) {
    return geom::cross_sign(base.start(i), base.end(i), base.start(j), base.end(j));
  };
  for (std::size_t i = 1; i < base.segment_count(); ++i) {
    const bool beyond_right = cross(right, i) == geom::Sign::Negative;
    const bool beyond_left = cross(left, i) == geom::Sign::Positive;
    if (!beyond_right && !beyond_left) {
      // Within, or exactly opposite to both.
      if (geom::dot(base.headings[i], base.headings[right] + base.headings[left]) <= 0) return std::nullopt;
      continue;
    }
    if (beyond_right && beyond_left) return std::nullopt;
    if (beyond_right) right = i;
    if (beyond_left) left = i;
    const geom::Sign width = cross(right, left);
    if (width == geom::Sign::Negative || (width == geom::Sign::Zero && right != left)) return std::nullopt;
  }
  const Vector sum = base.headings[right] + base.headings[left];
  const double size = geom::length(sum);
  if (!(size > 1e-6)) return std::nullopt;  // hardly less than half a turn: rounding could tell otherwise
  return sum / size;
}

namespace {

/// In the user's coordinates and numbers, without repeated points.
class Finisher {
 public:
  Finisher(const BaseCurve& base, Join join) : base_(base), keeps_arcs_(join == Join::Round) {}

  /// @param points  one more than edges.
  [[nodiscard]] OffsetPiece piece(std::vector<Point> points, std::vector<OffsetEdge> edges, bool repeats) const {
    OffsetPiece made;
    made.side = base_.mirrored ? Side::LeftOfTravel : Side::RightOfTravel;
    if (!keeps_arcs_ || base_.renumbered) number(edges);
    if (base_.origin != Point{} || base_.mirrored) {
      for (Point& p : points) p = base_.user(p);
      repeats = true;
    }
    if (repeats) compact(points, edges);
    if (points.size() < 2) return {};
    made.points = std::move(points);
    made.edges = std::move(edges);
    return made;
  }

 private:
  void number(std::vector<OffsetEdge>& edges) const {
    if (base_.renumbered) {
      for (OffsetEdge& edge : edges) {
        const std::size_t own = edge.base_edge() & ~mitred;
        const std::size_t segment = base_.source[own];
        // Where an end was lengthened the base does not turn but by rounding.
        const bool turns = own + 1 >= base_.segment_count() || base_.source[own + 1] != segment;
        edge = edge.is_arc() && keeps_arcs_ && turns ? OffsetEdge::arc(segment) : OffsetEdge::line(segment);
      }
    } else {
      for (OffsetEdge& edge : edges) edge = OffsetEdge::line(edge.base_edge() & ~mitred);
    }
  }
  static void compact(std::vector<Point>& points, std::vector<OffsetEdge>& edges) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (points[k] == points[k + 1]) continue;  // an edge of no length
      points[kept] = points[k];
      edges[kept++] = edges[k];
    }
    points[kept] = points.back();
    points.resize(kept + 1);
    edges.resize(kept);
  }

  const BaseCurve& base_;
  bool keeps_arcs_;  // chord bevels are the chords of what is left of their arcs
};

/// A mitre is below the arc about its corner. What is left of such an arc touches something, and is there by rounding
/// only: the edge that it touches takes its place.
/// @param curve  with one point more than edges.
void drop_covered_arcs(Stacked& curve, const BaseCurve& base, const JoinRule& joins) {
  auto& points = curve.points;
  auto& edges = curve.edges;
  const auto covered = [&](OffsetEdge edge) {
    const std::size_t segment = edge.base_edge();
    return edge.is_arc() && segment + 1 < base.segment_count() &&
           joins.of(base.half_tans[segment + 1]) != CornerKind::Arc;
  };
  std::size_t kept = static_cast<std::size_t>(std::find_if(edges.begin(), edges.end(), covered) - edges.begin());
  if (kept == edges.size()) return;
  for (std::size_t k = kept; k < edges.size(); ++k) {
    if (!covered(edges[k])) {
      points[kept] = points[k];
      edges[kept++] = edges[k];
      continue;
    }
    const auto aside = [&](std::size_t neighbour) {  // how far it leads away from the neighbour
      if (neighbour >= edges.size()) return std::numeric_limits<double>::infinity();
      const Vector along = points[neighbour + 1] - points[neighbour];
      return std::abs(geom::cross(along, points[k + 1] - points[k])) / geom::length(along);
    };
    if (aside(k + 1) < aside(k - 1)) points[k + 1] = points[k];
  }
  points[kept] = points.back();
  points.resize(kept + 1);
  edges.resize(kept);
}

/// What stands between the arcs about the ends of the base: one curve as a rule.
std::vector<OffsetPiece> between_caps(Stacked& curve, const BaseCurve& base, const Finisher& finisher) {
  const auto is_cap = [&](OffsetEdge edge) {
    return edge == OffsetEdge::arc(start_cap) || edge == OffsetEdge::arc(base.segment_count() - 1);
  };
  std::vector<OffsetPiece> pieces;
  if (std::count_if(curve.edges.begin(), curve.edges.end(), is_cap) == 1) {  // the last
    curve.points.pop_back();
    curve.edges.pop_back();
    pieces.push_back(finisher.piece(std::move(curve.points), std::move(curve.edges), curve.repeats));
  } else {
    for (auto first = curve.edges.begin(); first != curve.edges.end(); ++first) {
      if (is_cap(*first)) continue;
      const auto last = std::find_if(first, curve.edges.end(), is_cap);
      const auto start = curve.points.begin() + (first - curve.edges.begin());
      pieces.push_back(finisher.piece({start, start + (last - first) + 1}, {first, last}, curve.repeats));
      first = last - 1;
    }
  }
  std::erase_if(pieces, [](const OffsetPiece& piece) { return piece.points.empty(); });
  return pieces;
}

}  // namespace

std::vector<OffsetPiece> monotone_offset(const BaseCurve& base, Vector forward, double distance,
                                         const OffsetOptions& options, StadiaLeft& left) {
  const JoinRule joins(options);
  const Finisher finisher(base, options.join);
  Stacked curve = stack_stadia(base, forward, distance, joins, left);
  if (!joins.only_arcs() && add_cut_mitres(curve, base, forward, distance, joins, left)) {
    drop_covered_arcs(curve, base, joins);
    return between_caps(curve, base, finisher);
  }
  curve.points.push_back(curve.tip);
  if (!joins.only_arcs()) drop_covered_arcs(curve, base, joins);
  OffsetPiece piece = finisher.piece(std::move(curve.points), std::move(curve.edges), curve.repeats);
  std::vector<OffsetPiece> pieces;
  if (!piece.points.empty()) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace dobra::offset::monotone
