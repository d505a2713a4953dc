#include "quebra/meshing/constraint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "quebra/domain/domain.h"
#include "quebra/domain/selection.h"
#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/offset/offset.h"

// Overview
//   1 the base: the named curves as one chain, followed finely (or as they will be divided);
//   2 each distance: the base, lengthened at open ends so that its offset reaches the boundary beside it, is offset;
//   3 the offset is cut where it meets the boundary, and the parts outside the domain are dropped;
//   4 lengthened parts that end inside the domain are taken back;
//     (round a crack: 2' both sides' offsets are closed by half circles round its tips, and 4 falls away)
//   5 band.h: what is left gives way to other bands, gets nodes at the wanted spacing, and its ends become nodes of the
//     boundary.

namespace quebra::meshing {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::geom::Vector;

// --- 1 the base
// -------------------------------------------------------------------------------------------------------

Result<std::size_t> curve_named(const domain::Domain& domain, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < domain.curves.size(); ++i) {
    if (domain.curves[i].name == name) return i;
    names.push_back(domain.curves[i].name);
  }
  return Error{ErrorCode::BadValue, fmt::format("there is no curve '{}'{}", name, domain::what_there_is(name, names))};
}

/// The curves in the order and direction in which a loop travels them.
Result<std::vector<domain::Domain::Side>> sides_in_order(const domain::Domain& domain,
                                                         const std::vector<std::size_t>& wanted) {
  if (wanted.size() == 1) return std::vector<domain::Domain::Side>{{wanted.front(), false}};
  const auto is_wanted = [&](const domain::Domain::Side& side) {
    return std::find(wanted.begin(), wanted.end(), side.curve) != wanted.end();
  };
  for (const auto& loop : domain.loops) {
    const std::size_t n = loop.sides.size();
    if (static_cast<std::size_t>(std::count_if(loop.sides.begin(), loop.sides.end(), is_wanted)) != wanted.size())
      continue;
    std::size_t start = 0;
    while (start < n && !(is_wanted(loop.sides[start]) && !is_wanted(loop.sides[(start + n - 1) % n]))) ++start;
    std::vector<domain::Domain::Side> sides;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const auto& side = loop.sides[(start + i) % n];
      if (is_wanted(side)) sides.push_back(side);
    }
    if (sides.size() == wanted.size()) return sides;
  }
  return Error{ErrorCode::BadValue, "the base curves do not follow each other round one loop; use a step for each"};
}

Result<Polyline> divided(const sketch::Curve& curve, double size) {
  Polyline line{{}, closed(curve)};
  DOBRA_TRY(const std::vector<double> nodes, divide(curve, {}, {.size = size}));
  line.points = points(curve, nodes);
  if (line.closed) line.points.pop_back();
  return line;
}

Result<Polyline> base_line(const domain::Domain& domain, const ConstraintParams& params) {
  std::vector<std::size_t> wanted;
  for (const std::string& name : params.curves) {
    DOBRA_TRY(const std::size_t curve, curve_named(domain, name));
    wanted.push_back(curve);
  }
  if (wanted.empty()) return Error{ErrorCode::BadValue, "`curves` names no curve"};
  DOBRA_TRY(const auto sides, sides_in_order(domain, wanted));
  Polyline base;
  const double size = domain.box().diagonal() / 20.0;
  for (const auto& side : sides) {
    const sketch::Curve& curve = domain.curves[side.curve];
    Polyline line = trace(curve).line;
    if (params.spacing == Spacing::Base) {
      DOBRA_TRY(line, divided(curve, size));
    }
    if (line.closed) return line;
    if (side.backwards) line = reversed(std::move(line));
    base.points.insert(base.points.end(), line.points.begin(), line.points.end());
  }
  if (base.points.size() > 2 && base.points.front() == base.points.back()) base.closed = true;
  return without_repeated_points(std::move(base));
}

/// Turned so that the wanted side is on the right of travel, where offsets go.
Polyline facing(Polyline base, BandSide side, const domain::Domain& domain) {
  if (side == BandSide::Right) return base;
  if (side == BandSide::Left) return reversed(std::move(base));
  const Segment middle = base.segment(base.segment_count() / 2);
  const double step = 1e-3 * std::min(middle.length(), domain.box().diagonal());
  const Point right = midpoint(middle.from, middle.to) + step * normalised(right_of(middle.vector()));
  return domain::Inside(domain)(right) ? base : reversed(std::move(base));
}

// --- 2 lengthened ends
// ------------------------------------------------------------------------------------------------

Polyline lengthened(Polyline base, double by) {
  if (base.closed) return base;
  auto& points = base.points;
  const Point before = points.front() + by * normalised(points.front() - points[1]);
  const Point after = points.back() + by * normalised(points.back() - points[points.size() - 2]);
  points.insert(points.begin(), before);
  points.push_back(after);
  return base;
}

// --- 3 cutting at the boundary
// ----------------------------------------------------------------------------------------

/// A piece of an offset curve inside the domain.
struct Piece {
  Polyline line;
  std::vector<std::uint32_t> base_edge;  ///< One a segment.
  std::optional<model::Constraint::Foot> start, end;
};

class Cutter {
 public:
  explicit Cutter(const domain::Domain& domain) : domain_(domain), inside_(domain) {
    std::vector<Box> boxes;
    for (std::size_t c = 0; c < domain.curves.size(); ++c) {
      const sketch::Trace along = trace(domain.curves[c]);
      for (std::size_t i = 0; i < along.line.segment_count(); ++i) {
        sides_.push_back({along.line.segment(i), c, along.s[i], along.s[i + 1]});
        boxes.push_back(along.line.segment(i).box());
      }
    }
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  /// The parts of `line` inside the domain, in order.
  [[nodiscard]] std::vector<Piece> cut(const Polyline& line, const std::vector<std::uint32_t>& base_edge) const {
    std::vector<Piece> pieces;
    std::vector<Point> run;
    std::vector<std::uint32_t> edges;
    std::optional<model::Constraint::Foot> start;
    bool met_boundary = false;
    const auto finish = [&](std::optional<model::Constraint::Foot> end) {
      if (run.size() > 1 && inside_(middle_of(run))) pieces.push_back({Polyline{run, false}, edges, start, end});
      run.clear();
      edges.clear();
      start = end;
    };
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const Segment segment = line.segment(i);
      if (run.empty()) run.push_back(segment.from);
      for (const Cut& cut : cuts(segment)) {
        met_boundary = true;
        if (cut.at != run.back()) {
          run.push_back(cut.at);
          edges.push_back(base_edge[i]);
        }
        finish(cut.foot);
        run.push_back(cut.at);
      }
      if (segment.to != run.back()) {
        run.push_back(segment.to);
        edges.push_back(base_edge[i]);
      }
    }
    finish(std::nullopt);
    if (line.closed) close(pieces, met_boundary);
    return pieces;
  }

 private:
  struct Side {
    Segment segment;
    std::size_t curve;
    double s_from, s_to;
  };
  struct Cut {
    Point at;
    model::Constraint::Foot foot;
  };

  static Point middle_of(const std::vector<Point>& run) {
    const std::size_t i = run.size() / 2;
    return midpoint(run[i - 1], run[i]);
  }

  /// Where a segment meets the boundary, in the order of travel.
  [[nodiscard]] std::vector<Cut> cuts(const Segment& segment) const {
    std::vector<Cut> found;
    index_.for_each_overlapping(segment.box(), [&](std::size_t i) {
      const Side& side = sides_[i];
      const auto meeting = dobra::geom::intersect(segment, side.segment);
      const auto add = [&](Point p) {
        const double fraction = nearest_fraction(side.segment, p);
        found.push_back({p, {side.curve, side.s_from + fraction * (side.s_to - side.s_from)}});
      };
      if (meeting.kind != dobra::geom::IntersectionKind::None) add(meeting.start.point);
      if (meeting.kind == dobra::geom::IntersectionKind::Overlap) add(meeting.end.point);
    });
    std::sort(found.begin(), found.end(), [&](const Cut& a, const Cut& b) {
      if (a.at != b.at) return before_along(segment, a.at, b.at);
      return std::pair{a.foot.curve, a.foot.s} < std::pair{b.foot.curve, b.foot.s};
    });
    found.erase(std::unique(found.begin(), found.end(), [](const Cut& a, const Cut& b) { return a.at == b.at; }),
                found.end());
    return found;
  }

  /// A closed curve that was not cut is one closed piece; of one that was, the last part and the first are one.
  static void close(std::vector<Piece>& pieces, bool met_boundary) {
    if (pieces.empty()) return;
    if (!met_boundary) {
      pieces.front().line.closed = true;
      pieces.front().line.points.pop_back();
      return;
    }
    Piece& first = pieces.front();
    Piece& last = pieces.back();
    if (pieces.size() < 2 || first.start || last.end || first.line.points.front() != last.line.points.back()) return;
    last.line.points.insert(last.line.points.end(), first.line.points.begin() + 1, first.line.points.end());
    last.base_edge.insert(last.base_edge.end(), first.base_edge.begin(), first.base_edge.end());
    last.end = first.end;
    pieces.erase(pieces.begin());
  }

  const domain::Domain& domain_;
  domain::Inside inside_;
  std::vector<Side> sides_;
  dobra::geom::SpatialIndex index_;
};

// --- 4 what was lengthened in vain
// ------------------------------------------------------------------------------------

/// Drops the segments at an end inside the domain that come from the lengthening (base edges 0 and `last`).
void take_back(Piece& piece, std::uint32_t last) {
  const auto lengthening = [&](std::uint32_t edge) { return edge == 0 || edge == last; };
  auto& points = piece.line.points;
  auto& edges = piece.base_edge;
  while (!piece.end && !edges.empty() && lengthening(edges.back())) {
    edges.pop_back();
    points.pop_back();
  }
  std::size_t drop = 0;
  while (!piece.start && drop < edges.size() && lengthening(edges[drop])) ++drop;
  edges.erase(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(drop));
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(drop));
}

/// Steps 2 to 4 for one distance.
Result<std::vector<Piece>> pieces_beside(const Polyline& base, double distance, const Cutter& cutter) {
  const Polyline lengthened_base = lengthened(base, 2.0 * distance);
  DOBRA_TRY(const auto curves, dobra::offset::offset(lengthened_base, std::array{distance}));
  const auto last_edge = static_cast<std::uint32_t>(lengthened_base.segment_count() - 1);
  std::vector<Piece> pieces;
  for (const auto& offset_piece : curves.front().pieces) {
    const dobra::offset::Chords drawn = dobra::offset::chords(offset_piece, lengthened_base);
    for (Piece& piece : cutter.cut(drawn.polyline, drawn.base_edge)) {
      if (!base.closed) take_back(piece, last_edge);
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

// --- cracks ---------------------------------------------------------------------------------------------------------

bool on_boundary(const domain::Domain& domain, std::size_t crack, Point end) {
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Role role = domain.curves[c].role;
    if (c == crack || role == sketch::Role::Internal || role == sketch::Role::Crack) continue;
    if (!closed(domain.curves[c]) &&
        (point(domain.curves[c], 0.0) == end || point(domain.curves[c], length(domain.curves[c])) == end))
      return true;
    for (const domain::Junction& junction : domain.junctions) {
      if (junction.curve == c && junction.at == end) return true;
    }
    if (std::holds_alternative<Polyline>(domain.curves[c].shape)) {
      const auto& corners_of = std::get<Polyline>(domain.curves[c].shape).points;
      if (std::find(corners_of.begin(), corners_of.end(), end) != corners_of.end()) return true;
    }
  }
  return false;
}

/// The crack, lengthened by so much at an end on the boundary.
Polyline reaching_out(const domain::Domain& domain, std::size_t crack, double by) {
  Polyline base = trace(domain.curves[crack]).line;
  const std::array opens{on_boundary(domain, crack, base.points.front()),
                         on_boundary(domain, crack, base.points.back())};
  if (opens[0])
    base.points.insert(base.points.begin(), base.points[0] + by * normalised(base.points[0] - base.points[1]));
  const std::size_t n = base.points.size();
  if (opens[1]) base.points.push_back(base.points[n - 1] + by * normalised(base.points[n - 1] - base.points[n - 2]));
  return base;
}

/// The half circle round a tip from the end of one side's offset to the start of the other's, without both.
void add_cap(std::vector<Point>& contour, Point tip, Vector ahead, double distance) {
  constexpr int pieces = 18;
  for (int i = 1; i < pieces; ++i) {
    const double angle = std::numbers::pi * i / pieces;
    contour.push_back(tip + distance * (std::sin(angle) * ahead + std::cos(angle) * right_of(ahead)));
  }
}

/// The curve all round a crack at a distance: both sides' offsets and half circles round the tips. Nothing if an offset
/// does not reach from end to end (a crack that bends more sharply than the distance). An end on the boundary is
/// lengthened so that the contour closes outside.
Result<std::optional<Polyline>> round_crack(const domain::Domain& domain, std::size_t crack, double distance) {
  const sketch::Curve& curve = domain.curves[crack];
  const std::array opens{on_boundary(domain, crack, point(curve, 0.0)),
                         on_boundary(domain, crack, point(curve, length(curve)))};
  const Polyline base = reaching_out(domain, crack, 2.0 * distance);
  std::vector<Point> contour;
  const std::array both{base, reversed(base)};
  for (const Polyline& side : both) {
    DOBRA_TRY(const auto curves, dobra::offset::offset(side, std::array{distance}));
    if (curves.front().pieces.size() != 1) return std::optional<Polyline>{};
    const Polyline drawn = dobra::offset::chords(curves.front().pieces.front(), side).polyline;
    const Point tip = side.points.back();
    const Vector ahead = normalised(tip - side.points[side.points.size() - 2]);
    if (dobra::geom::distance(drawn.points.back(), tip + distance * right_of(ahead)) > 1e-6 * distance)
      return std::optional<Polyline>{};
    contour.insert(contour.end(), drawn.points.begin(), drawn.points.end());
    const bool is_tip = !opens[&side == &both[0] ? 1 : 0];
    if (is_tip) add_cap(contour, tip, ahead, distance);
  }
  return std::optional(without_repeated_points(Polyline{std::move(contour), true}));
}

/// The crack that is meant, if it is one curve and to be gone round.
std::optional<std::size_t> crack_of(const domain::Domain& domain, const ConstraintParams& params) {
  if (params.curves.size() != 1 || params.side != BandSide::Inside) return std::nullopt;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    if (domain.curves[c].name == params.curves[0] && domain.curves[c].role == sketch::Role::Crack) return c;
  }
  return std::nullopt;
}

}  // namespace

Result<model::Model> add_constraints(const model::Model& model, const ConstraintParams& params,
                                     const dobra::scenario::Context&, const dobra::base::Progress& progress) {
  const domain::Domain& domain = model.domain;
  const auto crack = crack_of(domain, params);
  Band band{.curves = params.curves,
            .source = {},
            .tube = crack ? Tube::Round : Tube::Beside,
            .kind = params.spacing,
            .distances = {},
            .spacings = {},
            .lines = {}};
  if (!crack) {
    DOBRA_TRY(band.source, base_line(domain, params));
    band.source = facing(std::move(band.source), params.side, domain);
    const auto curve = curve_named(domain, params.curves.front());
    if (curve && domain.curves[*curve].role != sketch::Role::Boundary &&
        domain.curves[*curve].role != sketch::Role::Hole)
      band.tube = Tube::Right;
  }
  DOBRA_TRY(band.distances,
            dobra::offset::distances({static_cast<std::size_t>(params.count), params.distance, params.factor}));
  const std::vector<double>& distances = band.distances;
  if (crack) band.source = reaching_out(domain, *crack, 2.0 * distances.back());
  const Cutter cutter(domain);
  model::Model result = model;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(k) / static_cast<double>(distances.size()), "offset curves");
    std::vector<Piece> pieces;
    if (crack) {
      DOBRA_TRY(const std::optional<Polyline> contour, round_crack(domain, *crack, distances[k]));
      if (contour) pieces = cutter.cut(*contour, std::vector<std::uint32_t>(contour->segment_count(), 0));
    } else {
      DOBRA_TRY(pieces, pieces_beside(band.source, distances[k], cutter));
    }
    const double before = k == 0 ? 0.0 : distances[k - 1];
    const double after = params.factor * distances[k] + params.distance;
    band.spacings.push_back(params.spacing_factor * 0.5 * (after - before));
    std::erase_if(pieces, [](const Piece& piece) { return piece.line.segment_count() == 0; });
    for (Piece& piece : pieces) band.lines.push_back({std::move(piece.line), k, piece.start, piece.end});
    if (pieces.empty()) {
      result.remarks.push_back(fmt::format(
          "constraint {} of '{}' at distance {:.6g} m {} and is left out", k + 1, params.curves.front(), distances[k],
          crack ? "does not go round the crack in one piece inside the domain" : "lies wholly outside the domain"));
    }
  }
  constexpr double most_nodes = 2e6;
  double nodes = 0.0;
  for (const BandCurve& curve : band.lines) nodes += dobra::geom::length(curve.line) / band.spacings[curve.rank];
  if (!(nodes <= most_nodes)) {
    return Error{ErrorCode::TooManyElements,
                 fmt::format("the offset constraints of '{}' would get some {:.3g} nodes; give a greater distance, a "
                             "factor of 1 or more, or fewer curves",
                             params.curves.front(), nodes)};
  }
  result.bands.push_back(std::make_shared<const Band>(std::move(band)));
  result.constraints = constraints_of(domain, result.bands);
  // The first piece of every curve has its plain name.
  const auto has = [](const std::vector<model::Constraint>& constraints, const std::string& name) {
    return std::any_of(constraints.begin(), constraints.end(),
                       [&](const model::Constraint& constraint) { return constraint.name == name; });
  };
  const std::vector<model::Constraint> alone = constraints_of(domain, std::span(&result.bands.back(), 1));
  for (const auto& each : result.bands) {
    for (std::size_t k = 0; k < each->distances.size(); ++k) {
      const std::string name = fmt::format("{}_{}", each->curves.front(), k + 1);
      if ((has(model.constraints, name) || has(alone, name)) && !has(result.constraints, name)) {
        result.remarks.push_back(
            fmt::format("constraint '{}' lies nearer to another band's source everywhere and is left out", name));
      }
    }
  }
  return result;
}

}  // namespace quebra::meshing
