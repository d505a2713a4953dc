#include "shared/offset/verifier/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "shared/base/text.h"
#include "shared/offset/types/arcs.h"
#include "shared/offset/verifier/exact.h"
#include "shared/offset/verifier/model.h"

namespace dobra::offset::verifier {

using base::Result;
using geom::Box;
using geom::Point;

namespace {

constexpr long double never = std::numeric_limits<long double>::infinity();

/// How far two ends of an edge are off what it may follow; `edge` is completed for the best.
class Generators {
 public:
  Generators(const Model& model, SeenEdge& edge) : model_(model), edge_(edge) {}

  long double best() {
    const std::uint32_t base_edge = edge_.segment;
    edge_.segment = Model::none;
    if (base_edge >= model_.first_of.size() || model_.first_of[base_edge] == Model::none) return never;
    if (!edge_.arc && !model_.paper) try_parallels(base_edge);
    for (std::size_t i = model_.first_of[base_edge]; i < model_.count() && model_.source[i] == base_edge; ++i) {
      if (model_.paper && !edge_.arc) try_raw(i);
      if (!model_.closed && i + 1 == model_.count()) continue;
      const CornerKind kind = model_.corners[model_.end_index(i)].kind;
      if (kind == CornerKind::Arc && model_.paper && !edge_.arc) try_raw_chords(i);
      if (kind == CornerKind::Arc && edge_.arc == model_.round && !model_.paper) try_arc(i);
      if (kind == CornerKind::Tangent && !edge_.arc) try_tangent(i);
    }
    return least_;
  }

 private:
  /// A segment that was lengthened is two, whose parallels are one.
  void try_parallels(std::uint32_t base_edge) {
    const auto off = [&](std::size_t i, Wide p) {
      const Wide q = p - model_.from(i);
      const long double s = dot(q, model_.along[i]);
      const long double low = model_.closed || i > 0 ? -model_.reach(i) : 0;
      const long double high = model_.span[i] + model_.reach(model_.end_index(i));
      const long double h = dot(q, model_.normal(i));
      return std::abs(h - model_.d) + beyond(std::max({low - s, 0.0L, s - high}));
    };
    long double off_a = never;
    long double off_b = never;
    long double off_both = never;
    std::size_t best = model_.first_of[base_edge];
    for (std::size_t i = best; i < model_.count() && model_.source[i] == base_edge; ++i) {
      off_a = std::min(off_a, off(i, edge_.a));
      off_b = std::min(off_b, off(i, edge_.b));
      const long double both = std::max(off(i, edge_.a), off(i, edge_.b));
      if (both < off_both) best = i;
      off_both = std::min(off_both, both);
    }
    keep(best, std::max(off_a, off_b), [&] {
      edge_.line = true;
      edge_.chord = false;
      edge_.outward = model_.normal(best);
    });
  }
  void try_raw(std::size_t i) {
    const auto [from, to] = model_.raw_edge(i);
    const auto off = [&, from = from, to = to](Wide p) { return size(nearest_on(from, to, p) - p); };
    const bool backwards = dot(to - from, model_.along[i]) < 0;
    keep(i, std::max(off(edge_.a), off(edge_.b)), [&] {
      edge_.line = true;
      edge_.chord = false;
      edge_.outward = backwards ? -model_.normal(i) : model_.normal(i);
    });
  }
  /// One from normal to normal, or, for Join::Round, several.
  void try_raw_chords(std::size_t i) {
    const Wide centre = model_.to(i);
    const Wide first = centre + model_.d * model_.normal(i);
    const Wide last = centre + model_.d * model_.normal(model_.after(i));
    const auto off = [&](Wide p) {
      if (!model_.round) return size(nearest_on(first, last, p) - p);
      if (!in_sector(centre, first, last, p)) return std::min(size(p - first), size(p - last));
      const long double r = size(p - centre);
      return std::max({0.0L, r - model_.d, model_.d * (1 - static_cast<long double>(default_arc_tolerance)) - r});
    };
    const Wide middle = edge_.a + 0.5L * (edge_.b - edge_.a);
    keep(i, std::max({off(edge_.a), off(edge_.b), off(middle)}), [&] {
      edge_.line = false;
      edge_.chord = true;
      edge_.centre = centre;
    });
  }
  void try_tangent(std::size_t i) {
    const std::size_t at = model_.end_index(i);
    const Wide out = model_.corners[at].middle;
    const auto off = [&](Wide p) {
      const Wide q = p - model_.to(i);
      return std::abs(dot(q, out) - model_.d) + beyond(std::max(0.0L, std::abs(cross(out, q)) - model_.reach(at)));
    };
    keep(i, std::max(off(edge_.a), off(edge_.b)), [&] {
      edge_.line = true;
      edge_.chord = false;
      edge_.outward = out;
    });
  }
  void try_arc(std::size_t i) {
    const Wide centre = model_.to(i);
    const Wide first = centre + model_.d * model_.normal(i);
    const Wide last = centre + model_.d * model_.normal(model_.after(i));
    const auto off = [&](Wide p) {
      const long double out = in_sector(centre, first, last, p) ? 0 : std::min(size(p - first), size(p - last));
      return std::abs(size(p - centre) - model_.d) + beyond(out);
    };
    keep(i, std::max(off(edge_.a), off(edge_.b)), [&] {
      edge_.line = false;
      edge_.chord = !edge_.arc;
      edge_.centre = centre;
    });
  }
  /// Being past an end along a parallel brings a place out of distance D by this.
  [[nodiscard]] long double beyond(long double along) const {
    return model_.raw ? 0 : std::hypot(along, model_.d) - model_.d;
  }
  template <class Complete>
  void keep(std::size_t i, long double off, Complete&& complete) {
    if (!(off < least_)) return;
    least_ = off;
    edge_.segment = static_cast<std::uint32_t>(i);
    complete();
    if (!edge_.line) edge_.outward = unit(edge_.middle() - edge_.centre);
  }

  const Model& model_;
  SeenEdge& edge_;
  long double least_ = never;
};

bool well_formed(const OffsetPiece& piece, std::size_t index, const OffsetOptions& options, Verification& found) {
  const auto wrong = [&](std::size_t edge, Point place) {
    found.findings.push_back({FindingKind::Malformed, place, 0, 0, index, edge});
    return false;
  };
  const Point first = piece.points.empty() ? Point{} : piece.points[0];
  if (piece.points.size() < 2 || piece.side != options.side) return wrong(0, first);
  if (piece.edges.size() + (piece.closed ? 0 : 1) != piece.points.size()) return wrong(0, first);
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    if (!geom::is_finite(piece.points[i])) return wrong(i, first);
    if (i + 1 == piece.points.size() && !piece.closed) break;
    // Untreated curves have one edge a base segment, if need be of no length.
    const bool repeated = piece.points[i] == piece.points[i + 1 == piece.points.size() ? 0 : i + 1];
    if (repeated && options.treatment == Treatment::Treated) return wrong(i, piece.points[i]);
  }
  return true;
}

}  // namespace

std::vector<SeenEdge> see(const Model& model, const OffsetCurve& curve, const VerifyOptions& options,
                          Verification& found, const base::Progress& progress) {
  std::vector<SeenEdge> edges;
  for (std::size_t p = 0; p < curve.pieces.size(); ++p) {
    const OffsetPiece& piece = curve.pieces[p];
    for (std::size_t i = 0; i < piece.edges.size() && !progress.cancelled(); ++i) {
      SeenEdge edge;
      edge.a = model.seen(piece.points[i]);
      edge.b = model.seen(piece.points[i + 1 == piece.points.size() ? 0 : i + 1]);
      edge.arc = piece.edges[i].is_arc();
      edge.segment = piece.edges[i].base_edge();
      edge.piece = p;
      edge.edge = i;
      const Box box = box_round(edge.a, edge.b);
      const double greatest =
          std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
      edge.rounding = std::max<long double>(model.rounding, greatest * std::numeric_limits<double>::epsilon());
      const long double allowed = options.vertex_tolerance * model.d + 2 * edge.rounding;
      const long double off = Generators(model, edge).best();
      const auto report = [&](FindingKind kind, long double measured, long double limit) {
        found.findings.push_back(
            {kind, piece.points[i], static_cast<double>(measured), static_cast<double>(limit), p, i});
      };
      if (!(off <= allowed)) {
        edge.segment = Model::none;
        report(FindingKind::OffParallel, off, allowed);
      } else {
        // Anticlockwise arcs, and lines whose right side is outward; what is as short as rounding has no direction.
        const Wide step = edge.b - edge.a;
        const long double back = edge.line ? cross(edge.outward, step) : cross(edge.a - edge.centre, step) / model.d;
        if (-back > 4 * allowed && !model.raw) report(FindingKind::WrongWay, -back, 4 * allowed);
      }
      edges.push_back(edge);
    }
  }
  found.edges = edges.size();
  return edges;
}

namespace {

long double between_segments(Wide a, Wide b, Wide p, Wide q) {
  const auto side = [](Wide s, Wide t, Wide x) { return cross(t - s, x - s); };
  if (side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0) return 0;
  return std::min(std::min(size(nearest_on(a, b, p) - p), size(nearest_on(a, b, q) - q)),
                  std::min(size(nearest_on(p, q, a) - a), size(nearest_on(p, q, b) - b)));
}

/// An arc of at most a right angle.
long double arc_to_segment(Wide centre, long double radius, Wide a, Wide b, Wide p, Wide q) {
  long double least = std::min(size(nearest_on(p, q, a) - a), size(nearest_on(p, q, b) - b));
  const auto radial = [&](Wide x) {
    const long double r = size(x - centre);
    if (r == 0) least = std::min(least, radius);
    if (r > 0 && in_sector(centre, a, b, x)) least = std::min(least, std::abs(r - radius));
  };
  radial(p);
  radial(q);
  const Wide step = q - p;
  const long double t = dot(centre - p, step) / dot(step, step);
  const Wide foot = p + t * step;
  if (t > 0 && t < 1) radial(foot);
  const long double squared = radius * radius - dot(foot - centre, foot - centre);
  if (squared > 0) {
    const long double half = std::sqrt(squared) / size(step);
    for (const long double s : {t - half, t + half}) {
      if (s >= 0 && s <= 1 && in_sector(centre, a, b, p + s * step)) return 0;
    }
  }
  return least;
}

class ClearanceCheck {
 public:
  ClearanceCheck(const Model& model, const VerifyOptions& options, Verification& found)
      : model_(model), found_(found), tolerance_(options.vertex_tolerance * model.d) {}

  void operator()(const SeenEdge& edge) {
    slack_ = tolerance_ + 2 * edge.rounding;
    limit_ = model_.d - slack_;
    long double least = never;
    if (edge.arc || edge.chord) {
      // Short parts, so that the boxes of what is behind them are passed over.
      const long double angle = std::atan2(cross(edge.a - edge.centre, edge.b - edge.centre),
                                           dot(edge.a - edge.centre, edge.b - edge.centre));
      const long double whole = angle < -1 ? angle + 2 * 3.14159265358979323846L : std::max(angle, 0.0L);
      const int parts = 1 + static_cast<int>(whole / 0.1L);
      Wide from = edge.a;
      for (int k = 1; k <= parts; ++k) {
        const long double turn = whole * k / parts;
        const Wide u = edge.a - edge.centre;
        const Wide to = k == parts ? edge.b : edge.centre + std::cos(turn) * u + std::sin(turn) * Wide{-u.y, u.x};
        least = std::min(least, arc(edge.centre, from, to));
        from = to;
      }
    } else {
      least = line(edge.a, edge.b);
    }
    if (least < limit_) report(FindingKind::TooNear, edge, least, limit_);
    in_mitres(edge);
    if (edge.line && !model_.coarse()) in_slits(edge);
  }

 private:
  /// Is part of a parallel where the base leaves no room, as in a slit exactly 2 D wide?
  void in_slits(const SeenEdge& edge) {
    const Wide step = edge.b - edge.a;
    const long double whole = size(step);
    if (dot(edge.outward, model_.normal(edge.segment)) < 0.999999L) return;  // a bevel
    const auto place = [&](std::size_t k) { return model_.places[k]; };
    model_.tree.each([&](const geom::Box& box) { return gap(box, edge.a, edge.b) <= model_.d + slack_; },
                     [&](std::size_t j) {
                       // On the far side, as long as the edge goes along it.
                       const long double off = dot(edge.outward, model_.from(j) - edge.a);
                       if (std::abs(off - model_.d) > slack_ || whole == 0) return false;
                       const long double s = dot(model_.from(j) - edge.a, step) / whole;
                       const long double t = dot(model_.to(j) - edge.a, step) / whole;
                       const long double both = std::min(whole, std::max(s, t)) - std::max(0.0L, std::min(s, t));
                       if (both <= 4 * slack_) return false;
                       const geom::Point a = place(edge.segment);
                       const geom::Point b = place(model_.end_index(edge.segment));
                       if (!parallel(a, b, place(j), place(model_.end_index(j)))) return false;
                       if (beside_line(a, b, place(j), static_cast<double>(model_.d)) == Room::None)
                         report(FindingKind::Touching, edge, both, 4 * slack_);
                       return false;
                     });
  }
  long double line(Wide a, Wide b) {
    long double least = limit_;
    model_.tree.each([&](const geom::Box& box) { return gap(box, a, b) < least; },
                     [&](std::size_t i) {
                       least = std::min(least, between_segments(a, b, model_.from(i), model_.to(i)));
                       return false;
                     });
    return least;
  }
  long double arc(Wide centre, Wide a, Wide b) {
    long double least = limit_;
    const long double bulge = dot(b - a, b - a) / (4 * model_.d);
    model_.tree.each([&](const geom::Box& box) { return gap(box, a, b) - bulge < least; },
                     [&](std::size_t i) {
                       least = std::min(least, arc_to_segment(centre, model_.d, a, b, model_.from(i), model_.to(i)));
                       return false;
                     });
    return least;
  }
  /// A straight edge is clipped by each mitre it comes near to: how deep does it get?
  void in_mitres(const SeenEdge& edge) {
    if (!edge.line) return;
    long double deepest = 0;
    model_.mitre_tree.each([&](const geom::Box& box) { return gap(box, edge.a, edge.b) <= 0; },
                           [&](std::size_t k) {
                             deepest = std::max(deepest, depth(model_.mitres[k], edge.a, edge.b));
                             return false;
                           });
    if (deepest > slack_) report(FindingKind::InMitre, edge, deepest, slack_);
  }
  [[nodiscard]] long double depth(std::size_t corner, Wide a, Wide b) const {
    const Wide p = wide(model_.places[corner]);
    const Wide first = model_.normal(model_.incoming(corner));
    const Wide last = model_.normal(corner);
    long double from = 0;
    long double to = 1;
    const auto keep = [&](Wide out, long double bound) {  // dot(out, x - p) <= bound
      const long double start = dot(out, a - p) - bound;
      const long double step = dot(out, b - a);
      if (step == 0) {
        if (start > 0) to = -1;
        return;
      }
      (step > 0 ? to : from) = step > 0 ? std::min(to, -start / step) : std::max(from, -start / step);
    };
    keep(right_of(first), 0);  // anticlockwise of the first normal
    keep(-right_of(last), 0);  // clockwise of the last
    keep(first, model_.d);
    keep(last, model_.d);
    if (model_.corners[corner].kind == CornerKind::Tangent) keep(model_.corners[corner].middle, model_.d);
    if (!(from < to)) return 0;
    // Depth is concave along the edge: halve the clipped part towards its greatest.
    const auto at = [&](long double t) {
      const long double depth = model_.depth_in_mitre(corner, a + t * (b - a));
      return std::isinf(depth) ? 0 : depth;
    };
    for (int k = 0; k < 40; ++k) {
      const long double third = (to - from) / 3;
      (at(from + third) < at(to - third) ? from : to) = at(from + third) < at(to - third) ? from + third : to - third;
    }
    return at(0.5L * (from + to));
  }
  void report(FindingKind kind, const SeenEdge& edge, long double measured, long double allowed) {
    found_.findings.push_back({kind, model_.user(edge.middle()), static_cast<double>(measured),
                               static_cast<double>(allowed), edge.piece, edge.edge});
  }

  const Model& model_;
  Verification& found_;
  long double tolerance_;
  long double limit_ = 0;  // of the edge at hand
  long double slack_ = 0;
};

}  // namespace

void check_clearance(const Model& model, const std::vector<SeenEdge>& edges, const VerifyOptions& options,
                     Verification& found, const base::Progress& progress) {
  ClearanceCheck check(model, options, found);
  for (const SeenEdge& edge : edges) {
    if (progress.cancelled()) return;
    if (edge.segment != Model::none) check(edge);
  }
}

Result<Verification> verify(const geom::Polyline& base, const OffsetOptions& options, const OffsetCurve& curve,
                            const VerifyOptions& verify_options, const base::Progress& progress) {
  DOBRA_TRY(Model model, Model::make(base, options, curve.distance));
  Verification found;
  for (std::size_t i = 0; i < curve.pieces.size(); ++i) well_formed(curve.pieces[i], i, options, found);
  if (!found.ok()) return found;  // nothing else can be asked of it
  const std::vector<SeenEdge> edges = see(model, curve, verify_options, found, progress);
  found.coarse = model.coarse() && !model.raw;
  if (!model.raw) check_crossings(model, curve, edges, found, progress);
  if (!model.raw && !model.paper) {
    check_clearance(model, edges, verify_options, found, progress);
    if (!model.coarse()) check_missing(model, curve, edges, verify_options, found, progress);
    check_winding(model, edges, found, progress);
  }
  DOBRA_TRY_VOID(progress.check());
  return found;
}

const char* name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::Malformed:
      return "malformed";
    case FindingKind::OffParallel:
      return "off its parallel";
    case FindingKind::WrongWay:
      return "against its base";
    case FindingKind::TooNear:
      return "too near";
    case FindingKind::InMitre:
      return "inside a mitre";
    case FindingKind::Crossing:
      return "crossing";
    case FindingKind::Touching:
      return "touching";
    case FindingKind::OpenEnd:
      return "ends where it should go on";
    case FindingKind::Missing:
      return "missing";
    case FindingKind::Winding:
      return "not between inside and outside";
  }
  return "";
}

std::string to_string(const Finding& f) {
  std::string text = name_of(f.kind);
  if (f.kind != FindingKind::Malformed && f.kind != FindingKind::OpenEnd)
    text += fmt::format(": {:.9g} where {:.9g} is allowed", f.measured, f.allowed);
  text += fmt::format(", at ({}, {})", base::number_text(f.place.x), base::number_text(f.place.y));
  return f.kind == FindingKind::Missing ? text + fmt::format(", base segment {}", f.piece)
                                        : text + fmt::format(", piece {}, edge {}", f.piece, f.edge);
}

}  // namespace dobra::offset::verifier
