// Faces as trimmed surfaces, picked and united.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/trim/state.h"
#include "shared/topo/locate.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using topo::EdgeId;
using topo::HalfEdgeId;
using topo::Subdivision;

std::vector<const CrackOnArc*> Recognised::State::cracks_on_seams(const Parts& of, int number) const {
  std::vector<const CrackOnArc*> found(edges.size(), nullptr);
  for (std::size_t f = 0; f < steps.size(); ++f) {
    for (const StepOver& step : steps[f]) {
      if (!step.seam || of[f] != number || of[step.to] != number) continue;
      const auto& crack = cracks[step.arc] ? cracks[step.arc] : cracks[*step.seam];
      if (crack) found[step.arc] = found[*step.seam] = &*crack;
    }
  }
  return found;
}

TrimmedSurface Recognised::State::face(const Parts& of, int number, CommonLines common) const {
  const std::vector<const CrackOnArc*> on_seams = cracks_on_seams(of, number);
  std::vector<std::pair<double, ChartLoop>> loops;
  for (const std::vector<HalfEdgeId>& round : loops_round(faces, of, number)) {
    ChartLoop loop;
    for (const HalfEdgeId h : round) {
      const Chord chord = faces.chords[h.index()];
      if (!chord.first) continue;
      ChartEdge made = edge(chord.arc, chord.forward);
      if (const CrackOnArc* crack = on_seams[chord.arc]) made = opened(std::move(made), chord.forward, *crack);
      loop.edges.push_back(std::move(made));
    }
    loops.emplace_back(turned_area(faces, round), std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    if ((a.first > 0.0) != (b.first > 0.0)) return a.first > 0.0;
    return std::abs(a.first) > std::abs(b.first);
  });
  TrimmedSurface made{surface, {}, lines_inside(of, number, common)};
  for (auto& [area, loop] : loops) made.loops.push_back(std::move(loop));
  return made;
}

std::vector<ChartLine> Recognised::State::lines_inside(const Parts& of, int number, CommonLines common) const {
  std::vector<std::uint8_t> inside(edges.size(), 0);
  const Subdivision& sub = faces.subdivision;
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Subdivision::half_edge(e), twin = Subdivision::twin(h);
    const std::size_t left = sub.face(h).index(), right = sub.face(twin).index();
    if (of[left] != number || of[right] != number) continue;
    if (common == CommonLines::Drop && parts[left] != parts[right]) continue;
    inside[faces.chords[h.index()].arc] = 1;
  }
  std::vector<std::size_t> order;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    if (inside[a] != 0) order.push_back(a);
  }
  const auto line_of = [&](std::size_t a) { return cracks[a] ? cracks[a]->line : line[a]; };
  const auto key = [&](std::size_t a) {
    return cracks[a] ? std::tuple(cracks[a]->line, cracks[a]->strand, cracks[a]->from)
                     : std::tuple(line[a], arcs.arcs[a].strand, arcs.arcs[a].from);
  };
  const auto starts = [&](std::size_t a) {
    return cracks[a] && cracks[a]->against ? arcs.arcs[a].end : arcs.arcs[a].start;
  };
  const auto ends = [&](std::size_t a) {
    return cracks[a] && cracks[a]->against ? arcs.arcs[a].start : arcs.arcs[a].end;
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<ChartLine> lines;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    const bool goes_on = i > 0 && line_of(order[i - 1]) == line_of(a) && kind[order[i - 1]] == kind[a] &&
                         ends(order[i - 1]) == starts(a);
    if (!goes_on) lines.push_back({{}, kind[a]});
    lines.back().edges.push_back(edge_inside(a));
  }
  return lines;
}

Recognised::Recognised(std::shared_ptr<const State> state, std::vector<Finding> findings)
    : state_(std::move(state)), findings_(std::move(findings)) {
  for (int i = 0; i < state_->count; ++i) faces_.push_back(state_->face(state_->parts, i, CommonLines::Keep));
  for (const Arc& arc : state_->arcs.arcs) {
    for (const Along& each : arc.along) {
      const Strand& strand = state_->arcs.strands[each.strand];
      if (!strand.edge.shared) continue;
      for (const double part : {each.from, each.to}) {
        const double t = std::lerp(strand.edge.from, strand.edge.to, part);
        const double hair = 1e-9 * std::abs(strand.whole_to - strand.whole_from);
        if (std::abs(t - strand.whole_from) <= hair || std::abs(t - strand.whole_to) <= hair) continue;
        std::vector<double>& known = cuts_[*strand.edge.shared];
        if (std::none_of(known.begin(), known.end(), [&](double other) { return std::abs(other - t) <= hair; }))
          known.push_back(t);
      }
    }
  }
  for (auto& [number, known] : cuts_) std::sort(known.begin(), known.end());
}

base::Result<std::size_t> Recognised::pick(Point uv) const {
  const State& s = *state_;
  Point p = s.arcs.part(uv);
  if (s.surface.closed_u()) p.x -= std::floor(p.x);
  if (s.surface.closed_v()) p.y -= std::floor(p.y);
  if (!geom::is_finite(uv)) return Error{ErrorCode::NotFinite, "the point that is to pick a face is not finite"};
  const Point inside{std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)};
  if (!(p == inside))
    return Error{ErrorCode::OutsideDomain, "the point lies beside the chart of the surface; pick one inside",
                 place_of(s.surface, s.arcs.uv(inside))};
  const Error on_a_line{
      ErrorCode::OutsideDomain,
      "the point lies on a line, or so near to it that its side is not known; pick one well inside a face",
      place_of(s.surface, uv)};
  const Subdivision& sub = s.faces.subdivision;
  const double near = 0.25 * s.faces.sag + s.options.same;
  for (const EdgeId e : sub.edges()) {
    // The chords of a side are the side itself.
    const Strand& strand = s.arcs.strands[s.arcs.arcs[s.faces.chords[Subdivision::half_edge(e).index()].arc].strand];
    if (geom::distance(sub.segment(e), p) <= (strand.side ? s.options.same : near)) return on_a_line;
  }
  const topo::Location there = locate(sub, p);
  const int part = there.where == topo::Where::Face ? s.parts[there.face.index()] : -1;
  if (part < 0) return on_a_line;
  return static_cast<std::size_t>(part);
}

TrimmedSurface Recognised::united(std::span<const std::size_t> faces, CommonLines common) const {
  Parts of(state_->parts.size(), -1);
  for (std::size_t f = 0; f < of.size(); ++f) {
    const bool picked = std::any_of(faces.begin(), faces.end(),
                                    [&](std::size_t each) { return state_->parts[f] == static_cast<int>(each); });
    if (picked) of[f] = 0;
  }
  return state_->face(of, 0, common);
}

}  // namespace dobra::surf::trim
