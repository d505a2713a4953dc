#include "shared/surf/trim/mend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shared/surf/measure.h"
#include "shared/surf/trim/rings.h"
#include "shared/surf/trim/state.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Vector3;
using topo::EdgeId;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Subdivision;

namespace {

/// Sets of faces that lie on the same side or on the other one of all loops.
class Sides {
 public:
  explicit Sides(std::size_t count) : parent_(count), other_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// The set of a face, and whether it lies on the other side than the one that names the set.
  std::pair<std::size_t, bool> find(std::size_t i) {
    bool other = false;
    while (parent_[i] != i) {
      other = other != (other_[i] != 0);
      i = parent_[i];
    }
    return {i, other};
  }
  /// False if the contrary is known.
  bool relate(std::size_t a, std::size_t b, bool opposite) {
    const auto [p, p_other] = find(a);
    const auto [q, q_other] = find(b);
    const bool differ = (p_other != q_other) != opposite;
    if (p == q) return !differ;
    parent_[std::max(p, q)] = std::min(p, q);
    other_[std::max(p, q)] = differ ? 1 : 0;
    return true;
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<std::uint8_t> other_;
};

class Mender {
 public:
  Mender(const TrimmedSurface& face, Analysed found)
      : face_(face), found_(std::move(found)), s_(*found_.state), sides_(s_.parts.size()) {}

  base::Result<Mended> run() {
    find_neighbours();
    find_sewn();
    if (!face_.loops.empty() && !relate_faces()) return crossing(0);
    Parts inside(s_.parts.size(), -1);
    find_turns();
    for (const FaceId f : s_.faces.subdivision.faces()) {
      if (f != Subdivision::unbounded() && (face_.loops.empty() || is_inside(f.index()))) inside[f.index()] = 0;
    }
    DOBRA_TRY_VOID(check_turns(inside));
    Mended made{s_.face(inside, 0, CommonLines::Keep), std::move(found_.findings)};
    if (made.face.loops.empty())
      return Error{
          ErrorCode::DegenerateCurve, "the loops of the face enclose nothing; draw them anew",
          place_of(s_.surface, face_.loops.empty() ? s_.surface.chart().centre() : face_.loops[0].edges.at(0).start())};
    made.face.points = face_.points, made.face.regions = face_.regions;
    made.face.reversed = face_.reversed, made.face.name = face_.name, made.face.place = face_.place;
    return made;
  }

 private:
  [[nodiscard]] std::size_t loops_along(std::size_t arc) const {
    const auto& along = s_.arcs.arcs[arc].along;
    return static_cast<std::size_t>(std::count_if(along.begin(), along.end(), [&](const Along& each) {
      return s_.arcs.strands[each.strand].line < face_.loops.size();
    }));
  }
  void find_neighbours() {
    const Subdivision& sub = s_.faces.subdivision;
    left_.assign(s_.arcs.arcs.size(), 0);
    right_ = left_;
    for (const EdgeId e : sub.edges()) {
      const HalfEdgeId h = Subdivision::half_edge(e);
      const Chord chord = s_.faces.chords[h.index()];
      const HalfEdgeId along = chord.forward ? h : Subdivision::twin(h);
      left_[chord.arc] = sub.face(along).index();
      right_[chord.arc] = sub.face(Subdivision::twin(along)).index();
    }
  }
  /// Loops that run along both sides of a seam bound nothing there.
  void find_sewn() {
    sewn_.assign(left_.size(), 0);
    for (const auto& [low, high] : found_.state->seams) {
      if (loops_along(low) % 2 == 1 && loops_along(high) % 2 == 1) sewn_[low] = sewn_[high] = 1;
    }
  }
  bool relate_faces() {
    const Surface& surface = s_.surface;
    for (std::size_t a = 0; a < left_.size(); ++a) {
      const bool divides = loops_along(a) % 2 == 1 && sewn_[a] == 0;
      const std::optional<Side> side = s_.arcs.strands[s_.arcs.arcs[a].strand].side;
      if (side && !divides) {
        const bool seam = *side == Side::Left || *side == Side::Right ? surface.closed_u() : surface.closed_v();
        if (seam || surface.collapsed(*side)) continue;
      }
      if (!sides_.relate(left_[a], right_[a], divides)) return false;
    }
    const std::size_t outside = Subdivision::unbounded().index();
    for (const auto& [low, high] : found_.state->seams) {
      if (sewn_[low] == 0 && (loops_along(low) % 2 == 1 || loops_along(high) % 2 == 1)) continue;
      const auto inner = [&](std::size_t a) { return left_[a] == outside ? right_[a] : left_[a]; };
      if (!sides_.relate(inner(low), inner(high), false)) return false;
    }
    return true;
  }
  /// Where nothing tells what lies outside: by the turn of loops, the longer part.
  void find_turns() {
    for (std::size_t a = 0; a < left_.size(); ++a) {
      if (loops_along(a) % 2 == 0 || sewn_[a] != 0) continue;
      const double length =
          geom::distance(s_.arcs.vertices[s_.arcs.arcs[a].start], s_.arcs.vertices[s_.arcs.arcs[a].end]) + 1e-3;
      for (const Along& each : s_.arcs.arcs[a].along) {
        if (s_.arcs.strands[each.strand].line >= face_.loops.size()) continue;
        const auto [set, other] = sides_.find(each.against ? right_[a] : left_[a]);
        votes_[set] += other ? -length : length;
        break;
      }
    }
  }
  bool is_inside(std::size_t f) {
    const auto [set, other] = sides_.find(f);
    const auto [outer, outer_other] = sides_.find(Subdivision::unbounded().index());
    if (set == outer) return other != outer_other;
    const auto found = votes_.find(set);
    return found == votes_.end() || (found->second > 0.0) != other;  // no loop but along seams: all is meant
  }
  /// Each loop has what is meant on its left all along, or (to be turned) on its right.
  base::Result<void> check_turns(const Parts& inside) {
    std::vector<std::array<int, 2>> seen(face_.loops.size());
    for (std::size_t a = 0; a < left_.size(); ++a) {
      if (loops_along(a) % 2 == 0 || sewn_[a] != 0) continue;
      for (const Along& each : s_.arcs.arcs[a].along) {
        const std::size_t line = s_.arcs.strands[each.strand].line;
        if (line < face_.loops.size()) ++seen[line][inside[each.against ? right_[a] : left_[a]] == 0 ? 0 : 1];
      }
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i][0] > 0 && seen[i][1] > 0) return crossing(i);
      if (seen[i][1] == 0) continue;
      found_.findings.push_back({"loop_turned",
                                 fmt::format("loop {} was turned: what is meant lies on its left", i + 1),
                                 place_of(s_.surface, face_.loops[i].edges.at(0).start())});
    }
    return {};
  }
  [[nodiscard]] Error crossing(std::size_t loop) const {
    Point uv = s_.arcs.uv(s_.arcs.vertices[s_.arcs.strands[0].start]);
    for (const Meeting& each : found_.meetings) {
      const bool loops = each.line_a < face_.loops.size() && each.line_b < face_.loops.size();
      if (!loops || (each.line_a != loop && each.line_b != loop)) continue;
      uv = each.uv;
      break;
    }
    return {ErrorCode::SelfIntersection,
            "the loops of the face cross themselves or each other here; draw them so that they do not",
            place_of(s_.surface, uv)};
  }

  const TrimmedSurface& face_;
  Analysed found_;
  Recognised::State& s_;
  Sides sides_;
  std::vector<std::size_t> left_, right_;  ///< Of an arc: the faces beside it.
  std::vector<std::uint8_t> sewn_;         ///< Of an arc.
  std::map<std::size_t, double> votes_;
};

}  // namespace

base::Result<Mended> mended(const TrimmedSurface& face, SharedNumbers& numbers, const RecogniseOptions& options) {
  std::vector<TrimLine> lines;
  for (const ChartLoop& loop : face.loops) lines.push_back({{loop.edges}, true});
  for (const ChartLine& line : face.lines) lines.push_back({line, false, false});
  RecogniseOptions nameless = options;
  nameless.name_sides = false;
  DOBRA_TRY(Analysed found, analysed(face.surface, lines, numbers, nameless));
  if (face.loops.empty())
    found.findings.push_back({"no_loops", "the face has no loops: the whole chart is taken",
                              place_of(face.surface, face.surface.chart().centre())});
  return Mender(face, std::move(found)).run();
}

namespace {

/// Along the way between two places whose normals look opposite ways: where they part, if they are nought there.
std::optional<Point> fold_between(const Surface& surface, Point a, Point b) {
  Vector3 at_a = cross(surface.jet(a).u, surface.jet(a).v), at_b = cross(surface.jet(b).u, surface.jet(b).v);
  const double usual = std::max(geom::length(at_a), geom::length(at_b));
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const Point m = geom::midpoint(a, b);
    const Vector3 at_m = cross(surface.jet(m).u, surface.jet(m).v);
    if (dot(at_a, at_m) < 0.0) {
      b = m, at_b = at_m;
    } else if (dot(at_m, at_b) < 0.0) {
      a = m, at_a = at_m;
    } else {
      return std::nullopt;  // they turn by less on the way
    }
  }
  const bool nought = std::min(geom::length(at_a), geom::length(at_b)) < 1e-3 * usual;
  // Else a corner, unless one side lies on the other one.
  constexpr double flat = 1e-9;
  const bool doubled = dot(at_a, at_b) < (flat - 1.0) * geom::length(at_a) * geom::length(at_b);
  return nought || doubled ? std::optional(a) : std::nullopt;
}

}  // namespace

std::optional<Error> find_fold(const TrimmedSurface& face) {
  const Surface& surface = face.surface;
  const geom::Box& chart = surface.chart();
  constexpr std::size_t count = 65;
  const auto lines_of = [](double low, double high, const std::vector<double>& breaks) {
    std::vector<double> at(breaks);
    for (std::size_t i = 0; i < count; ++i) at.push_back(std::lerp(low, high, static_cast<double>(i) / (count - 1)));
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
  };
  const std::vector<double> us = lines_of(chart.low.x, chart.high.x, surface.breaks().u);
  const std::vector<double> vs = lines_of(chart.low.y, chart.high.y, surface.breaks().v);
  const std::vector<Ring> rings = rings_of(face);
  const auto told = [&](Point uv, bool folds) {
    const base::Place place = place_of(surface, uv);
    const char* const what = folds ? "the surface folds back here; change its borders or trim that part away"
                                   : "the surface has no normal here; change its borders or trim that part away";
    return Error{ErrorCode::DegenerateCurve, what, place};
  };
  std::vector<std::optional<Vector3>> below(us.size()), row(us.size());
  for (std::size_t j = 0; j < vs.size(); ++j, std::swap(below, row)) {
    // A hair inside at both ends, where the loops may lie on the line itself.
    const double v =
        std::clamp(vs[j], std::lerp(chart.low.y, chart.high.y, 1e-9), std::lerp(chart.high.y, chart.low.y, 1e-9));
    const std::vector<double> at = rings.empty() ? std::vector{chart.low.x, chart.high.x} : meets(rings, v);
    for (std::size_t i = 0; i < us.size(); ++i) {
      const double u =
          std::clamp(us[i], std::lerp(chart.low.x, chart.high.x, 1e-9), std::lerp(chart.high.x, chart.low.x, 1e-9));
      row[i].reset();
      if (std::count_if(at.begin(), at.end(), [u](double x) { return x < u; }) % 2 == 0) continue;
      const Point uv{us[i], vs[j]};
      if (surface.in_pole(uv)) continue;
      const Jet jet = surface.jet(uv);
      if (!normal(jet)) return told(uv, false);
      row[i] = cross(jet.u, jet.v);
      if (i > 0 && row[i - 1] && dot(*row[i - 1], *row[i]) < 0.0) {
        if (const auto fold = fold_between(surface, {us[i - 1], vs[j]}, uv)) return told(*fold, true);
      }
      if (j > 0 && below[i] && dot(*below[i], *row[i]) < 0.0) {
        if (const auto fold = fold_between(surface, {us[i], vs[j - 1]}, uv)) return told(*fold, true);
      }
    }
  }
  return std::nullopt;
}

}  // namespace dobra::surf::trim
