#include "shared/surf/mesh/border.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "shared/geom/spatial_index.h"
#include "shared/surf/measure.h"

// 1. Edges of loops, lines and kinks. 2. Cuts at corners, where lines end on others and cross them, at points asked
// for; cuts of a shared curve on all its edges. 3. Which vertices are one.

namespace dobra::surf::mesh {

using base::Error;
using base::ErrorCode;
using base::Place;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector;
using trim::ChartEdge;
using trim::ChartLine;
using trim::TrimmedSurface;

namespace {

Place place_on(const BorderEdge& edge, double s, const TrimmedSurface& surface) {
  const Point uv = edge.space.place(s);
  const Point3 p = edge.space.at(s);
  Place place = surface.place;
  if (place.item.empty()) place.item = surface.name;
  place.x = p.x;
  place.y = p.y;
  place.z = p.z;
  place.u = uv.x;
  place.v = uv.y;
  return place;
}

/// The sides of the whole chart, anticlockwise from the bottom.
std::vector<ChartEdge> whole_chart(const Surface& surface) {
  const auto [low, high] = surface.chart();
  const Point3 a{low.x, low.y, 0}, b{high.x, low.y, 0}, c{high.x, high.y, 0}, d{low.x, high.y, 0};
  std::vector<ChartEdge> edges;
  const auto add = [&](const char* name, Point3 from, Point3 to) {
    auto line = Curve::line(from, to);
    if (line) edges.push_back({.curve = *line, .from = 0.0, .to = 1.0, .name = name});
  };
  add("bottom", a, b);
  add("right", b, c);
  add("top", c, d);
  add("left", d, a);
  return edges;
}

/// A crossing or a contact of two edges.
struct Contact {
  std::size_t a;
  double s;
  std::size_t b;
  double t;
};

/// The place between two parameters of an edge that is next to a place of the chart, by the metric there.
struct ChartFoot {
  double s, distance;
};
ChartFoot foot_on(const EdgeInSpace& edge, Point uv, const Metric& metric, double low, double high) {
  const auto distance = [&](double s) { return metric.length(edge.place(s) - uv); };
  double near = distance(low) <= distance(high) ? low : high;
  double least = distance(near);
  constexpr double golden = 0.381966011250105;
  double a = low, b = high;
  double p = a + golden * (b - a), q = b - golden * (b - a);
  double at_p = distance(p), at_q = distance(q);
  for (int step = 0; step < 60; ++step) {
    if (at_p <= at_q) {
      b = q;
      q = p;
      at_q = at_p;
      p = a + golden * (b - a);
      at_p = distance(p);
    } else {
      a = p;
      p = q;
      at_p = at_q;
      q = b - golden * (b - a);
      at_q = distance(q);
    }
  }
  if (at_p < least) {
    near = edge.next_to(edge.surface().at(uv), p, low, high);
    least = std::min(at_p, distance(near));
  }
  return {near, least};
}

class Maker {
 public:
  Maker(std::span<const TrimmedSurface> surfaces, double closing, double corner)
      : surfaces_(surfaces), closing_(closing), corner_(corner) {}

  Result<Border> run() {
    for (std::size_t f = 0; f < surfaces_.size(); ++f) {
      first_of_face_.push_back(border_.edges.size());
      DOBRA_TRY_VOID(add_face(static_cast<std::uint32_t>(f)));
    }
    first_of_face_.push_back(border_.edges.size());
    for (std::size_t f = 0; f < surfaces_.size(); ++f) cut_face(f);
    DOBRA_TRY_VOID(cut_groups());
    for (BorderEdge& edge : border_.edges) {
      std::sort(edge.cuts.begin(), edge.cuts.end(), [](const Cut& a, const Cut& b) { return a.s < b.s; });
    }
    join();
    return std::move(border_);
  }

 private:
  // ---- edges

  Result<void> add_face(std::uint32_t face) {
    const TrimmedSurface& trimmed = surfaces_[face];
    std::uint32_t loop = 0;
    if (trimmed.loops.empty()) {
      add_whole(face, loop++);
    } else {
      for (const trim::ChartLoop& l : trimmed.loops) DOBRA_TRY_VOID(add_chain(face, l.edges, {}, loop++));
    }
    for (const ChartLine& line : trimmed.lines) DOBRA_TRY_VOID(add_chain(face, line.edges, line.kind, loop++));
    add_kinks(face, loop);
    return {};
  }

  std::size_t add_edge(std::uint32_t face, const ChartEdge& edge, std::optional<ChartLine::Kind> line,
                       std::uint32_t loop) {
    const TrimmedSurface& trimmed = surfaces_[face];
    BorderEdge added{
        .face = face, .space = EdgeInSpace(trimmed.surface, edge), .line = line, .name = edge.name, .loop = loop};
    if (line == ChartLine::Kind::Crack && added.name.empty()) added.name = fmt::format("crack_{}", loop + 1);
    added.tolerance = std::max(edge.tolerance, closing_ * trimmed.surface.size());
    const geom::Box& chart = trimmed.surface.chart();
    const bool ring = geom::distance(added.space.place(0.0), added.space.place(1.0)) <= closing_ * chart.diagonal();
    // Of a chain of short edges not all are one point.
    const bool after_point = !border_.edges.empty() && border_.edges.back().face == face &&
                             border_.edges.back().loop == loop && border_.edges.back().point;
    constexpr double largest = 1e-4;  // of the surface: a tolerance may be that of a wide gap
    const double size = trimmed.surface.size();
    const double one_point = ring || after_point ? 1e-3 * closing_ * size : std::min(added.tolerance, largest * size);
    added.point = added.space.length() <= one_point;
    const std::size_t number = border_.edges.size();
    border_.edges.push_back(std::move(added));
    add_cut(number, 0.0);
    add_cut(number, 1.0);
    return number;
  }

  void add_whole(std::uint32_t face, std::uint32_t loop) {
    const Surface& surface = surfaces_[face].surface;
    const std::size_t first = border_.edges.size();
    for (const ChartEdge& edge : whole_chart(surface)) add_edge(face, edge, {}, loop);
    for (std::size_t i = 0; i < 4; ++i) same_point(end_of(first + i), start_of(first + (i + 1) % 4));
    const auto seam = [&](std::size_t a, std::size_t b) {
      border_.edges[b].space = EdgeInSpace(surface, against(border_.edges[b].space.edge()));
      border_.groups.push_back({a, b});
    };
    if (surface.closed_v() && !surface.collapsed(Side::Bottom)) seam(first, first + 2);
    if (surface.closed_u() && !surface.collapsed(Side::Left)) seam(first + 1, first + 3);
  }
  static ChartEdge against(ChartEdge edge) {
    edge.against = true;
    return edge;
  }

  Result<void> add_chain(std::uint32_t face, const std::vector<ChartEdge>& edges, std::optional<ChartLine::Kind> line,
                         std::uint32_t loop) {
    const std::size_t first = border_.edges.size();
    for (const ChartEdge& edge : edges) {
      const std::size_t number = add_edge(face, edge, line, loop);
      if (edge.shared) share(*edge.shared, number);
    }
    const std::size_t count = border_.edges.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t here = first + i, next = first + (i + 1) % count;
      const bool last = i + 1 == count;
      if (last && line && !meets(here, next)) continue;  // an open line
      DOBRA_TRY_VOID(close(here, next));
    }
    return {};
  }

  void share(trim::SharedCurveId id, std::size_t edge) {
    const auto [at, is_new] = group_of_.try_emplace(id, edge);
    if (is_new) return;
    auto group = std::find_if(border_.groups.begin(), border_.groups.end(),
                              [&, at = at](const SharedGroup& g) { return g.front() == at->second; });
    if (group == border_.groups.end()) {
      border_.groups.push_back({at->second, edge});
    } else {
      group->push_back(edge);
    }
  }

  /// Whether the end of one edge is the start of the next, in the chart or by the tolerance in space.
  [[nodiscard]] bool meets(std::size_t edge, std::size_t next) const {
    const BorderEdge& a = border_.edges[edge];
    const BorderEdge& b = border_.edges[next];
    const double size = a.space.surface().chart().diagonal();
    const double gap = geom::distance(a.space.place(1.0), b.space.place(0.0));
    if (gap <= closing_ * size) return true;
    constexpr double beside = 1e-2;  // of the chart: what is further off is another place, though the same in space
    return gap <= beside * size &&
           geom::distance(a.space.at(1.0), b.space.at(0.0)) <= std::max(a.tolerance, b.tolerance);
  }

  Result<void> close(std::size_t edge, std::size_t next) {
    const BorderEdge& a = border_.edges[edge];
    const TrimmedSurface& trimmed = surfaces_[a.face];
    const Point end = a.space.place(1.0), start = border_.edges[next].space.place(0.0);
    if (!meets(edge, next)) {
      return Error{ErrorCode::CannotMesh,
                   fmt::format("an edge ends at ({:.6g}, {:.6g}) of the chart and the next begins at ({:.6g}, {:.6g}): "
                               "close the loop, or allow a larger gap",
                               end.x, end.y, start.x, start.y),
                   place_on(a, 1.0, trimmed)};
    }
    same_point(end_of(edge), start_of(next));
    constexpr double rounding = 1e-9;
    if (geom::distance(end, start) > rounding * a.space.surface().chart().diagonal()) {
      border_.findings.push_back({"gap_closed",
                                  fmt::format("a gap of {:.3g} m between two edges of a loop was closed",
                                              geom::distance(a.space.at(1.0), border_.edges[next].space.at(0.0))),
                                  place_on(a, 1.0, trimmed)});
    }
    return {};
  }

  // ---- kinks

  void add_kinks(std::uint32_t face, std::uint32_t loop) {
    const Surface& surface = surfaces_[face].surface;
    const geom::Box& chart = surface.chart();
    const Breaks& kinks = surface.kinks();
    for (std::size_t i = 1; i + 1 < kinks.u.size(); ++i) {
      add_kink(face, {kinks.u[i], chart.low.y}, {kinks.u[i], chart.high.y}, loop++);
    }
    for (std::size_t i = 1; i + 1 < kinks.v.size(); ++i) {
      add_kink(face, {chart.low.x, kinks.v[i]}, {chart.high.x, kinks.v[i]}, loop++);
    }
  }

  /// The parts of a line across the chart that lie inside the loops and not along an edge.
  void add_kink(std::uint32_t face, Point from, Point to, std::uint32_t loop) {
    const auto line = Curve::line({from.x, from.y, 0}, {to.x, to.y, 0});
    if (!line) return;
    const std::size_t first = first_of_face_[face], last = border_.edges.size();
    std::vector<double> at{0.0, 1.0};
    const Vector way = to - from;
    for (std::size_t e = first; e < last; ++e) {
      for (const double s : crossings_with(border_.edges[e].space, from, to)) {
        at.push_back(geom::dot(border_.edges[e].space.place(s) - from, way) / geom::dot(way, way));
      }
    }
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      const double middle = 0.5 * (at[i] + at[i + 1]);
      if (at[i + 1] - at[i] <= closing_ || !inside(face, geom::interpolate(from, to, middle))) continue;
      const ChartEdge part{.curve = *line, .from = at[i], .to = at[i + 1], .name = "kink"};
      const EdgeInSpace space(surfaces_[face].surface, part);
      if (runs_along(first, last, space)) continue;
      const std::size_t edge = add_edge(face, part, ChartLine::Kind::Constraint, loop);
      border_.findings.push_back({"kink", "the surface has a kink here: the mesh has sides along it",
                                  place_on(border_.edges[edge], 0.5, surfaces_[face])});
    }
  }

  [[nodiscard]] bool runs_along(std::size_t first, std::size_t last, const EdgeInSpace& space) const {
    const Point uv = space.place(0.5);
    const Metric here = metric(space.surface().jet(uv));
    for (std::size_t e = first; e < last; ++e) {
      const EdgeInSpace& other = border_.edges[e].space;
      for (std::size_t i = 0; i + 1 < other.marks().size(); ++i) {
        const ChartFoot foot = foot_on(other, uv, here, other.marks()[i], other.marks()[i + 1]);
        if (foot.distance <= border_.edges[e].tolerance) return true;
      }
    }
    return false;
  }

  /// Parameters of an edge at which it crosses (or begins or ends on) the straight line between two places.
  static std::vector<double> crossings_with(const EdgeInSpace& edge, Point from, Point to) {
    std::vector<double> found;
    const Vector way = to - from;
    const auto off = [&](double s) { return geom::cross(way, edge.place(s) - from); };
    for (std::size_t i = 0; i + 1 < edge.marks().size(); ++i) {
      double low = edge.marks()[i], high = edge.marks()[i + 1];
      const double at_low = off(low), at_high = off(high);
      if (at_low == 0.0) found.push_back(low);
      if (at_high == 0.0 && i + 2 == edge.marks().size()) found.push_back(high);
      if ((at_low < 0.0) == (at_high < 0.0) || at_low == 0.0 || at_high == 0.0) continue;
      for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (low + high);
        ((off(middle) < 0.0) == (at_low < 0.0) ? low : high) = middle;
      }
      found.push_back(0.5 * (low + high));
    }
    return found;
  }

  /// By the number of chords of the loops to the right of a place.
  [[nodiscard]] bool inside(std::uint32_t face, Point p) const {
    bool in = false;
    for (std::size_t e = first_of_face_[face]; e < border_.edges.size(); ++e) {
      const BorderEdge& edge = border_.edges[e];
      if (edge.line || edge.face != face) continue;
      const auto& marks = edge.space.marks();
      Point a = edge.space.place(marks[0]);
      for (std::size_t i = 1; i < marks.size(); ++i) {
        const Point b = edge.space.place(marks[i]);
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
        a = b;
      }
    }
    return in;
  }

  // ---- cuts

  std::uint32_t add_cut(std::size_t edge, double s) {
    const auto vertex = static_cast<std::uint32_t>(border_.vertex_edge.size());
    border_.vertex_edge.push_back(edge);
    border_.vertex_s.push_back(s);
    border_.exact.emplace_back();
    border_.edges[edge].cuts.push_back({s, vertex});
    return vertex;
  }
  /// The cut at a place, that of a neighbour within the tolerance, or a new one.
  std::uint32_t cut(std::size_t edge, double s) {
    const BorderEdge& e = border_.edges[edge];
    const double here = e.space.travelled(s);
    const Cut* nearest = nullptr;
    double least = e.tolerance;
    for (const Cut& c : e.cuts) {
      const double distance = std::abs(e.space.travelled(c.s) - here);
      if (distance <= least) nearest = &c, least = distance;
    }
    return nearest != nullptr ? nearest->vertex : add_cut(edge, s);
  }
  [[nodiscard]] std::uint32_t start_of(std::size_t edge) const { return border_.edges[edge].cuts[0].vertex; }
  [[nodiscard]] std::uint32_t end_of(std::size_t edge) const { return border_.edges[edge].cuts[1].vertex; }
  void same_point(std::uint32_t a, std::uint32_t b) { same_points_.emplace_back(a, b); }
  void same_node(std::uint32_t a, std::uint32_t b) { same_nodes_.emplace_back(a, b); }

  void cut_face(std::size_t face) {
    const std::size_t first = first_of_face_[face], last = first_of_face_[face + 1];
    for (std::size_t e = first; e < last; ++e) {
      if (border_.edges[e].point) continue;
      const std::vector<double> breaks = border_.edges[e].space.breaks();
      for (const double s : breaks) {
        if (border_.edges[e].space.turn_at(s) > corner_) cut(e, s);
      }
    }
    border_.on_edges.emplace_back(surfaces_[face].points.size());
    index_face(first, last);
    for (std::size_t e = first; e < last; ++e) {
      if (border_.edges[e].point) continue;
      touch_end(e, 0.0, start_of(e));
      if (!border_.edges[e].line) continue;
      touch_end(e, 1.0, end_of(e));
      cross(e);
    }
    for (std::size_t i = 0; i < surfaces_[face].points.size(); ++i) {
      const auto found = contact_at(surfaces_[face].points[i].at, face, [](std::size_t) { return true; });
      if (found) border_.on_edges[face][i] = cut(found->first, found->second);
    }
  }

  struct Chord {
    std::size_t edge;
    double s0, s1;
  };
  void index_face(std::size_t first, std::size_t last) {
    chords_.clear();
    std::vector<geom::Box> boxes;
    for (std::size_t e = first; e < last; ++e) {
      const auto& marks = border_.edges[e].space.marks();
      const double margin = 1e-2;  // of the chord, for the bend of the curve between marks
      for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
        chords_.push_back({e, marks[i], marks[i + 1]});
        geom::Box box;
        for (const double s : {marks[i], 0.5 * (marks[i] + marks[i + 1]), marks[i + 1]}) {
          box.add(border_.edges[e].space.place(s));
        }
        boxes.push_back(box.grown(margin * box.diagonal()));
      }
    }
    index_ = geom::SpatialIndex(boxes);
  }

  /// The edge among those that count that passes a place of the chart within its tolerance, nearest first, and where.
  template <class Counts>
  std::optional<std::pair<std::size_t, double>> contact_at(Point uv, std::size_t face, const Counts& counts) {
    const Surface& surface = surfaces_[face].surface;
    const Metric here = metric(surface.jet(uv));
    const double margin = 1e-2 * surface.chart().diagonal();
    std::optional<std::pair<std::size_t, double>> found;
    double least = std::numeric_limits<double>::infinity();
    geom::Box box;
    box.add(uv);
    for (const std::size_t i : index_.overlapping(box.grown(margin))) {
      const Chord& chord = chords_[i];
      if (border_.edges[chord.edge].point || !counts(chord.edge)) continue;
      const ChartFoot foot = foot_on(border_.edges[chord.edge].space, uv, here, chord.s0, chord.s1);
      if (foot.distance > border_.edges[chord.edge].tolerance || foot.distance >= least) continue;
      least = foot.distance;
      found = {chord.edge, foot.s};
    }
    return found;
  }

  /// Where a line ends on another edge, and where a corner of a loop touches another loop.
  void touch_end(std::size_t edge, double s, std::uint32_t vertex) {
    const BorderEdge& own = border_.edges[edge];
    const auto counts = [&](std::size_t other) {
      return own.line ? other != edge : !border_.edges[other].line && border_.edges[other].loop != own.loop;
    };
    const auto found = contact_at(own.space.place(s), own.face, counts);
    if (found) meet(edge, vertex, found->first, cut(found->first, found->second));
  }

  /// The u, or the v, that all places of an edge have.
  [[nodiscard]] std::array<std::optional<double>, 2> fixed(std::size_t edge) const {
    const EdgeInSpace& space = border_.edges[edge].space;
    const Point first = space.place(space.marks().front());
    bool in_u = true, in_v = true;
    for (const double s : space.marks()) {
      const Point p = space.place(s);
      in_u = in_u && p.x == first.x;
      in_v = in_v && p.y == first.y;
    }
    return {in_u ? std::optional(first.x) : std::nullopt, in_v ? std::optional(first.y) : std::nullopt};
  }
  /// Vertices of two edges are one point: where a line of one u meets one of one v, it is (u, v) to the last digit.
  void meet(std::size_t edge, std::uint32_t vertex, std::size_t other, std::uint32_t other_vertex) {
    same_point(other_vertex, vertex);
    const auto [a_u, a_v] = fixed(edge);
    const auto [b_u, b_v] = fixed(other);
    const std::optional<double> u = a_u ? a_u : b_u, v = a_v ? a_v : b_v;
    if (!u || !v) return;
    constexpr double rounding = 1e-12;  // of the chart
    const double near = rounding * border_.edges[edge].space.surface().chart().diagonal();
    for (const std::uint32_t at : {vertex, other_vertex}) {
      if (geom::distance(border_.place(at), {*u, *v}) <= near) border_.exact[at] = {*u, *v};
    }
  }

  /// Crossings of a line with everything after it, and with the loops.
  void cross(std::size_t edge) {
    const EdgeInSpace& a = border_.edges[edge].space;
    for (std::size_t i = 0; i + 1 < a.marks().size(); ++i) {
      geom::Box box;
      box.add(a.place(a.marks()[i]));
      box.add(a.place(a.marks()[i + 1]));
      for (const std::size_t k : index_.overlapping(box.grown(1e-2 * box.diagonal()))) {
        const Chord& chord = chords_[k];
        if (chord.edge == edge || border_.edges[chord.edge].point) continue;
        if (border_.edges[chord.edge].line && chord.edge < edge) continue;
        const auto at =
            crossing(a, a.marks()[i], a.marks()[i + 1], border_.edges[chord.edge].space, chord.s0, chord.s1);
        if (at) meet(edge, cut(edge, at->first), chord.edge, cut(chord.edge, at->second));
      }
    }
  }

  /// Where two pieces cross, by Newton from the crossing of their chords.
  static std::optional<std::pair<double, double>> crossing(const EdgeInSpace& a, double s0, double s1,
                                                           const EdgeInSpace& b, double t0, double t1) {
    double s = 0.5 * (s0 + s1), t = 0.5 * (t0 + t1);
    const double size = a.surface().chart().diagonal();
    for (int step = 0; step < 30; ++step) {
      constexpr double h = 1e-6;
      const Vector da = (a.place(std::min(1.0, s + h)) - a.place(std::max(0.0, s - h))) /
                        (std::min(1.0, s + h) - std::max(0.0, s - h));
      const Vector db = (b.place(std::min(1.0, t + h)) - b.place(std::max(0.0, t - h))) /
                        (std::min(1.0, t + h) - std::max(0.0, t - h));
      const Vector gap = b.place(t) - a.place(s);
      const double turn = geom::cross(da, db);
      if (!(std::abs(turn) > 1e-6 * geom::length(da) * geom::length(db))) return std::nullopt;
      const double ds = geom::cross(gap, db) / turn, dt = geom::cross(gap, da) / turn;
      const double before_s = s, before_t = t;
      s = std::clamp(s + ds, s0, s1);
      t = std::clamp(t + dt, t0, t1);
      if (std::abs(s - before_s) + std::abs(t - before_t) <= 1e-15) break;
    }
    if (geom::distance(a.place(s), b.place(t)) > 1e-12 * size) return std::nullopt;
    return std::pair{s, t};
  }

  /// All edges of a shared curve are cut where one of them is.
  Result<void> cut_groups() {
    for (const SharedGroup& group : border_.groups) {
      const std::size_t first = group[0];
      for (std::size_t k = 1; k < group.size(); ++k) {
        DOBRA_TRY_VOID(beside(group[k], first));
        carry_cuts(group[k], first);
      }
      for (std::size_t k = 1; k < group.size(); ++k) carry_cuts(first, group[k]);
    }
    return {};
  }
  Result<void> beside(std::size_t edge, std::size_t first) {
    const BorderEdge& a = border_.edges[first];
    const BorderEdge& b = border_.edges[edge];
    const bool along = border_.along(edge, first);
    const double gap = std::max(geom::distance(a.space.at(0.0), b.space.at(along ? 0.0 : 1.0)),
                                geom::distance(a.space.at(1.0), b.space.at(along ? 1.0 : 0.0)));
    const double most = 0.1 * std::max(a.space.length(), b.space.length()) + std::max(a.tolerance, b.tolerance);
    if (gap <= most) return {};
    return Error{ErrorCode::CannotMesh,
                 fmt::format("two edges that are said to be one curve end {:.3g} m from each other: turn one of them, "
                             "or do not share them",
                             gap),
                 place_on(b, 0.0, surfaces_[b.face])};
  }
  void carry_cuts(std::size_t from, std::size_t to) {
    const EdgeInSpace& a = border_.edges[from].space;
    const EdgeInSpace& b = border_.edges[to].space;
    const bool along = border_.along(to, from);
    same_node(start_of(from), along ? start_of(to) : end_of(to));
    same_node(end_of(from), along ? end_of(to) : start_of(to));
    if (border_.edges[from].point || border_.edges[to].point) return;
    const std::vector<Cut> cuts(border_.edges[from].cuts.begin() + 2, border_.edges[from].cuts.end());
    for (const Cut& c : cuts) {
      const double part = a.travelled(c.s) / a.length();
      const double near = b.parameter_at((along ? part : 1.0 - part) * b.length());
      same_node(c.vertex, cut(to, b.next_to(a.at(c.s), near, 0.0, 1.0)));
    }
  }

  // ---- which are one

  void join() {
    const std::size_t count = border_.vertex_edge.size();
    base::DisjointSets points(count), nodes(count);
    for (const auto& [a, b] : same_points_) points.join(a, b);
    join_touching(points);
    for (std::size_t v = 0; v < count; ++v) nodes.join(v, points.root(v));
    for (const auto& [a, b] : same_nodes_) nodes.join(a, b);
    for (const BorderEdge& edge : border_.edges) {
      if (edge.point) nodes.join(edge.cuts.front().vertex, edge.cuts.back().vertex);
    }
    border_.point_of = chosen(points);
    border_.node_of = chosen(nodes);
    for (std::size_t v = 0; v < count; ++v) {
      std::optional<Point>& own = border_.exact[border_.point_of[v]];
      if (!own) own = border_.exact[v];
    }
  }

  /// Places of one face that are the same but for rounding, where loops touch each other or themselves.
  void join_touching(base::DisjointSets& points) const {
    constexpr double rounding = 1e-12;  // of the chart
    struct Place {
      std::uint32_t face;
      Point at;
      std::size_t vertex;
    };
    std::vector<Place> places;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (points.root(v) == v) places.push_back({border_.edges[border_.vertex_edge[v]].face, border_.place(v), v});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::tuple(a.face, a.at.x, a.vertex) < std::tuple(b.face, b.at.x, b.vertex);
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double near = rounding * surfaces_[places[i].face].surface.chart().diagonal();
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        if (places[j].face != places[i].face || places[j].at.x - places[i].at.x > near) break;
        if (geom::distance(places[i].at, places[j].at) <= near) points.join(places[i].vertex, places[j].vertex);
      }
    }
  }

  /// One a vertex: the first vertex of its set that is of a loop, or else the first.
  [[nodiscard]] std::vector<std::size_t> chosen(base::DisjointSets& sets) const {
    const std::size_t none = sets.size();
    std::vector<std::size_t> of_root(sets.size(), none), result(sets.size());
    for (const bool lines : {false, true}) {
      for (std::size_t v = 0; v < sets.size(); ++v) {
        if (border_.edges[border_.vertex_edge[v]].line.has_value() != lines) continue;
        std::size_t& own = of_root[sets.root(v)];
        if (own == none) own = v;
      }
    }
    for (std::size_t v = 0; v < sets.size(); ++v) result[v] = of_root[sets.root(v)];
    return result;
  }

  std::span<const TrimmedSurface> surfaces_;
  double closing_, corner_;
  Border border_;
  std::vector<std::size_t> first_of_face_;
  std::map<trim::SharedCurveId, std::size_t> group_of_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> same_points_, same_nodes_;
  std::vector<Chord> chords_;
  geom::SpatialIndex index_;
};

}  // namespace

Result<Border> border_of(std::span<const TrimmedSurface> surfaces, double closing, double corner) {
  return Maker(surfaces, closing, corner).run();
}

}  // namespace dobra::surf::mesh
