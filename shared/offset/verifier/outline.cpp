// Checks c and d: nothing of the raw outline is missing, open pieces end where they may, and the outline's winding
// number parts inside and outside at every edge.

#include <algorithm>
#include <array>
#include <limits>

#include "shared/offset/verifier/model.h"

namespace dobra::offset::verifier {

namespace {

enum class Sight {
  Free,
  Doubtful,  ///< Something else is just as near, within the ambiguity.
  Hidden,
};

/// What stands between a point of a raw parallel and the curve.
class View {
 public:
  View(const Model& model, long double ambiguity) : model_(model), ambiguity_(ambiguity) {}

  /// @param foot     point of the base that p is parallel to, and `out` the way from it to p's parallel, unit.
  /// @param corners  mitres that p may lie on; for a point beyond a corner the corner, twice.
  [[nodiscard]] Sight of(Wide p, Wide foot, Wide out, const std::array<std::size_t, 2>& corners) const {
    Sight sight = Sight::Free;
    const long double far = model_.d + ambiguity_;
    model_.tree.each([&](const geom::Box& box) { return gap(box, p) < far; },
                     [&](std::size_t i) {
                       const Wide q = model_.nearest(i, p);
                       const long double r = size(q - p);
                       if (r < model_.d - ambiguity_) sight = Sight::Hidden;
                       if (sight == Sight::Free && r < far && !harmless(i, p, q, foot, out, corners))
                         sight = Sight::Doubtful;
                       return sight == Sight::Hidden;
                     });
    if (sight == Sight::Hidden) return sight;
    model_.mitre_tree.each([&](const geom::Box& box) { return gap(box, p) <= ambiguity_; },
                           [&](std::size_t k) {
                             const std::size_t at = model_.mitres[k];
                             if (at == corners[0] || at == corners[1]) return false;
                             const long double depth = model_.depth_in_mitre(at, p);
                             if (depth > ambiguity_) sight = Sight::Hidden;
                             if (sight == Sight::Free && depth > -ambiguity_) sight = Sight::Doubtful;
                             return sight == Sight::Hidden;
                           });
    return sight;
  }

 private:
  /// Of segment i, which is nearly as near to p as p's own foot: the curve does not leave p for it.
  [[nodiscard]] bool harmless(std::size_t i, Wide p, Wide q, Wide foot, Wide out,
                              const std::array<std::size_t, 2>& corners) const {
    if (corners[0] == corners[1] && (i == corners[0] || model_.end_index(i) == corners[0])) return true;
    if (size(q - foot) > 1e-4L * model_.d) return false;
    const bool same_side = dot(model_.normal(i), out) > 0.9999L && dot(model_.normal(i), p - model_.from(i)) > 0;
    return same_side || (corners[0] != corners[1] && (size(q - p) > model_.d + 8 * model_.rounding || i == corners[0]));
  }

  const Model& model_;
  long double ambiguity_;
};

class MissingCheck {
 public:
  MissingCheck(const Model& model, const std::vector<SeenEdge>& edges, const VerifyOptions& options,
               Verification& found)
      : model_(model),
        edges_(edges),
        samples_(options.samples),
        ambiguity_(options.ambiguity * model.d + 8 * model.rounding),
        view_(model, ambiguity_),
        base_(walk_of(model)),
        found_(found) {
    std::vector<geom::Box> boxes;
    for (const SeenEdge& edge : edges) {
      // Chords stand for their arcs.
      SeenEdge whole = edge;
      whole.arc = edge.arc || edge.chord;
      boxes.push_back(edge.segment == Model::none ? geom::Box{}
                                                  : box_of(whole).grown(static_cast<double>(off_by(edge))));
    }
    tree_ = BoxTree(boxes);
  }

  void parallel(std::size_t i) {
    const std::size_t end = model_.end_index(i);
    const long double low = model_.corners[i].kind == CornerKind::End ? 0 : -model_.reach(i);
    const long double high = model_.span[i] + (model_.corners[end].kind == CornerKind::End ? 0 : model_.reach(end));
    for (int k = 0; k < samples_; ++k) {
      const long double t = (k + 0.5L) / samples_;
      const long double s = low + (high - low) * t * t * (3 - 2 * t);  // denser towards the ends
      const Wide foot = model_.from(i) + std::clamp(s, 0.0L, model_.span[i]) * model_.along[i];
      ask(model_.from(i) + s * model_.along[i] + model_.d * model_.normal(i), foot, model_.normal(i), i, {i, end});
    }
  }
  void corner(std::size_t i) {
    const std::size_t at = model_.end_index(i);
    const Wide p = model_.to(i);
    const Corner& corner = model_.corners[at];
    if (corner.kind == CornerKind::Tangent) {
      for (const long double t : {-0.8L, 0.0L, 0.8L})
        ask(p + model_.d * corner.middle + t * model_.reach(at) * right_of(corner.middle), p, corner.middle, i,
            {at, at});
    }
    if (corner.kind != CornerKind::Arc) return;
    const long double turn = 2 * std::atan(corner.half_tan);
    for (const long double t : {0.1L, 0.5L, 0.9L}) {
      const Wide out = std::cos(t * turn) * model_.normal(i) + std::sin(t * turn) * model_.along[i];
      ask(p + model_.d * out, p, out, i, {at, at});
    }
  }

 private:
  /// By how much rounding moves an edge, if one of its ends is a far mitre's.
  [[nodiscard]] long double off_by(const SeenEdge& edge) const { return edge.rounding - model_.rounding; }
  static std::vector<Element> walk_of(const Model& model) {
    std::vector<Element> walk;
    for (std::size_t i = 0; i < model.count() && model.simple; ++i)
      walk.push_back({model.from(i), model.to(i), {}, false});
    return walk;
  }
  /// A mitre may poke through a thin part of a simple contour: its tip is on the wrong side, and not asked for.
  [[nodiscard]] bool pokes_through(Wide p) const {
    return model_.simple && base_.round(p) != (model_.anticlockwise ? 0 : -1);
  }
  void ask(Wide p, Wide foot, Wide out, std::size_t segment, const std::array<std::size_t, 2>& corners) {
    if (view_.of(p, foot, out, corners) != Sight::Free || pokes_through(p)) return;
    ++found_.samples;
    const long double allowed = 100 * ambiguity_ + 0x1p-60L * size(p);  // far mitres
    bool there = false;
    tree_.each([&](const geom::Box& box) { return gap(box, p) <= allowed; },
               [&](std::size_t k) {
                 there = there || distance(edges_[k], p, model_.d) <= allowed + off_by(edges_[k]);
                 return there;
               });
    if (there) return;
    long double least = 1e300L;
    for (const SeenEdge& edge : edges_) {
      if (edge.segment != Model::none) least = std::min(least, distance(edge, p, model_.d) - off_by(edge));
    }
    const bool none = least > 1e299L;
    found_.findings.push_back({FindingKind::Missing, model_.user(p),
                               none ? std::numeric_limits<double>::infinity() : static_cast<double>(least),
                               static_cast<double>(allowed), model_.source[segment], 0});
  }

  const Model& model_;
  const std::vector<SeenEdge>& edges_;
  int samples_;
  long double ambiguity_;
  View view_;
  Winding base_;
  Verification& found_;
  BoxTree tree_;
};

/// True if an open piece may end at p: where it meets the cap or the other side of the base.
bool may_end(const Model& model, Wide p, long double rounding) {
  const long double slack = 1e-9L * model.d + 8 * rounding;
  bool may = false;
  model.tree.each([&](const geom::Box& box) { return gap(box, p) <= model.d + slack; },
                  [&](std::size_t i) {
                    const Wide q = model.nearest(i, p);
                    if (size(q - p) > model.d + slack) return false;
                    const long double near_end = std::min(size(q - model.from(i)), size(q - model.to(i)));
                    if (!model.closed && i == 0 && size(q - model.from(0)) <= slack) may = true;
                    if (!model.closed && i + 1 == model.count() && size(q - model.to(i)) <= slack) may = true;
                    if (dot(model.normal(i), p - model.from(i)) < 0 && near_end > slack) may = true;  // on the left
                    for (const std::size_t at : {i, model.end_index(i)}) {
                      const Corner& corner = model.corners[at];
                      const Wide w = p - wide(model.places[at]);
                      if (corner.kind == CornerKind::End || size(q - wide(model.places[at])) > slack) continue;
                      const Wide right = corner.kind == CornerKind::Straight ? model.normal(at) : corner.middle;
                      if (dot(right, w) < 0 || corner.half_tan > 1e3L)
                        may = true;  // the left begins at the tip of a U-turn
                    }
                    return may;
                  });
  return may;
}

/// Of a closed base that does not meet itself no piece has ends, but nothing here relies on that.
void check_ends(const Model& model, const OffsetCurve& curve, Verification& found) {
  for (std::size_t k = 0; k < curve.pieces.size(); ++k) {
    const OffsetPiece& piece = curve.pieces[k];
    if (piece.closed) continue;
    for (const std::size_t i : {std::size_t{0}, piece.points.size() - 1}) {
      const double greatest = std::max(std::abs(piece.points[i].x), std::abs(piece.points[i].y));
      const long double rounding =
          std::max<long double>(model.rounding, greatest * std::numeric_limits<double>::epsilon());
      if (may_end(model, model.seen(piece.points[i]), rounding)) continue;
      found.findings.push_back({FindingKind::OpenEnd, piece.points[i], 0, 0, k, i == 0 ? 0 : piece.edges.size() - 1});
    }
  }
}

}  // namespace

void check_missing(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges,
                   const VerifyOptions& options, Verification& found, const base::Progress& progress) {
  check_ends(model, curve, found);
  if (curve.dropped > 0) return;
  MissingCheck check(model, edges, options, found);
  for (std::size_t i = 0; i < model.count() && !progress.cancelled(); ++i) {
    check.parallel(i);
    if (model.closed || i + 1 < model.count()) check.corner(i);
  }
}

void check_winding(const Model& model, const std::vector<SeenEdge>& edges, Verification& found,
                   const base::Progress& progress) {
  std::vector<Winding> walks;
  for (auto& walk : model.outline()) walks.emplace_back(std::move(walk));
  for (const SeenEdge& edge : edges) {
    if (progress.cancelled()) return;
    const long double aside = 1e-9L * model.d + 64 * edge.rounding;
    const View view(model, 4 * aside);
    if (edge.segment == Model::none || size(edge.b - edge.a) < 16 * aside || aside > 0.01L * model.d) continue;
    const Wide middle = edge.middle();
    const std::size_t end = model.end_index(edge.segment);
    const bool near_corner = edge.line && dot(edge.outward, model.normal(edge.segment)) < 0.999999L;
    const Wide foot = edge.line && !near_corner ? model.nearest(edge.segment, middle) : model.to(edge.segment);
    const bool beyond_corner = !edge.line || near_corner;
    if (view.of(middle, foot, edge.outward, {beyond_corner ? end : edge.segment, end}) == Sight::Doubtful) continue;
    const auto winds = [&](Wide p) {
      int sum = 0;
      for (const Winding& walk : walks) sum += walk.round(p);
      return sum;
    };
    const int behind = winds(middle - aside * edge.outward);
    const int beyond = winds(middle + aside * edge.outward);
    const auto report = [&](int measured, int allowed) {
      found.findings.push_back({FindingKind::Winding, model.user(middle), static_cast<double>(measured),
                                static_cast<double>(allowed), edge.piece, edge.edge});
    };
    if (behind <= 0) report(behind, 1);
    if (beyond > 0) report(beyond, 0);
  }
}

}  // namespace dobra::offset::verifier
