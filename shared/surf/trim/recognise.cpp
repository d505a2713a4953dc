#include "shared/surf/trim/recognise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/state.h"
#include "shared/surf/trim/strands.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using topo::EdgeId;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Subdivision;

SharedCurveId SharedNumbers::of(SharedCurveId whole, double from, double to) {
  const double hair = 1e-9 * (1.0 + std::abs(to) + std::abs(from));
  for (const auto& [id, a, b, number] : parts_) {
    if (id == whole && std::abs(a - from) <= hair && std::abs(b - to) <= hair) return number;
  }
  parts_.emplace_back(whole, from, to, fresh());
  return std::get<3>(parts_.back());
}

namespace {

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Which arcs are one curve in space: those on both sides of a seam.
std::vector<std::pair<std::size_t, std::size_t>> seam_pairs(const Surface& surface, const Arcs& arcs, double same) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto pair_up = [&](bool closed, Side low, Side high, bool along_y) {
    if (!closed) return;
    const auto ends = [&](const Arc& arc) {
      const Point p = arcs.vertices[arc.start], q = arcs.vertices[arc.end];
      return along_y ? std::pair(p.y, q.y) : std::pair(p.x, q.x);
    };
    for (std::size_t i = 0; i < arcs.arcs.size(); ++i) {
      if (arcs.strands[arcs.arcs[i].strand].side != low) continue;
      for (std::size_t k = 0; k < arcs.arcs.size(); ++k) {
        if (arcs.strands[arcs.arcs[k].strand].side != high) continue;
        const auto [a, b] = ends(arcs.arcs[i]);
        const auto [c, d] = ends(arcs.arcs[k]);
        if (std::abs(a - c) <= 2.0 * same && std::abs(b - d) <= 2.0 * same) pairs.emplace_back(i, k);
      }
    }
  };
  pair_up(surface.closed_u(), Side::Left, Side::Right, true);
  pair_up(surface.closed_v(), Side::Bottom, Side::Top, false);
  return pairs;
}

class Recogniser {
 public:
  Recogniser(const Surface& surface, SharedNumbers& numbers, const RecogniseOptions& options)
      : made_(std::make_shared<Recognised::State>(surface)), numbers_(numbers) {
    made_->options = options;
  }

  base::Result<Analysed> run(std::span<const TrimLine> lines) {
    Recognised::State& s = *made_;
    DOBRA_TRY(Strands strands, strands_of(s.surface, lines, s.options));
    s.arcs = std::move(strands.arcs);
    DOBRA_TRY(std::vector<Meeting> meetings, cut(s.surface, s.arcs, {.same = s.options.same}, s.options.cuts));
    DOBRA_TRY(s.faces, faces_of(s.surface, s.arcs, s.options.chord));
    DOBRA_TRY_VOID(every_ring_encloses(lines));
    describe_arcs(lines.size());
    auto pairs = seam_pairs(s.surface, s.arcs, s.options.same);
    find_parts(pairs);
    number_seams(pairs);
    s.steps = steps_between(s, pairs);
    s.seams = std::move(pairs);
    findings_.insert(findings_.begin(), strands.findings.begin(), strands.findings.end());
    return Analysed{made_, std::move(findings_), std::move(meetings)};
  }

 private:
  /// Of a closed line some part has two faces beside it.
  base::Result<void> every_ring_encloses(std::span<const TrimLine> lines) const {
    const Recognised::State& s = *made_;
    const Subdivision& sub = s.faces.subdivision;
    std::vector<std::uint8_t> encloses(lines.size(), 0);
    for (const EdgeId e : sub.edges()) {
      const HalfEdgeId h = Subdivision::half_edge(e);
      if (sub.face(h) == sub.face(Subdivision::twin(h))) continue;
      for (const Along& each : s.arcs.arcs[s.faces.chords[h.index()].arc].along) {
        const std::size_t line = s.arcs.strands[each.strand].line;
        if (line < lines.size()) encloses[line] = 1;
      }
    }
    for (const Strand& strand : s.arcs.strands) {
      if (strand.line >= lines.size() || !lines[strand.line].closed || encloses[strand.line] != 0) continue;
      geom::Box box;
      for (const Strand& other : s.arcs.strands) {
        for (int i = 0; other.line == strand.line && i <= 8; ++i)
          box.add(s.arcs.part(other.edge.at(std::lerp(other.edge.from, other.edge.to, i / 8.0))));
      }
      constexpr double few = 4.0;
      return Error{ErrorCode::DegenerateCurve,
                   box.diagonal() <= few * s.options.same
                       ? "a closed line is smaller than what counts as one point: draw it larger, or leave it out"
                       : "a closed line encloses nothing: it runs back along itself; draw it anew",
                   place_of(s.surface, s.arcs.uv(s.arcs.vertices[strand.start]))};
    }
    return {};
  }
  void describe_arcs(std::size_t lines) {
    Recognised::State& s = *made_;
    for (const Arc& arc : s.arcs.arcs) {
      const Strand& own = s.arcs.strands[arc.strand];
      ChartEdge edge = own.edge;
      edge.crack = ChartEdge::Crack::None;
      edge.from = std::lerp(own.edge.from, own.edge.to, arc.from);
      edge.to = std::lerp(own.edge.from, own.edge.to, arc.to);
      edge = with_ends(edge, s.arcs.chart, s.arcs.uv(s.arcs.vertices[arc.start]), s.arcs.uv(s.arcs.vertices[arc.end]),
                       1e-12);
      const bool only_cracks = std::all_of(arc.along.begin(), arc.along.end(), [&](const Along& each) {
        const Strand& strand = s.arcs.strands[each.strand];
        return strand.side.has_value() || strand.kind == ChartLine::Kind::Crack;
      });
      // A crack gives its name to a border only where nothing else does.
      const auto counts = [&](const Strand& strand) { return only_cracks || strand.kind != ChartLine::Kind::Crack; };
      if (!counts(own)) edge.name.clear();
      bool bounds = false;
      std::size_t line = counts(own) ? own.line : lines;
      ChartLine::Kind kind = ChartLine::Kind::Constraint;
      for (const Along& each : arc.along) {
        const Strand& strand = s.arcs.strands[each.strand];
        bounds = bounds || strand.bounds;
        kind = std::max(kind, strand.kind);
        if (counts(strand)) {
          if (own.side && !strand.side && !strand.edge.name.empty()) edge.name = strand.edge.name;
          if (strand.line < lines) line = std::min(line, strand.line);
          if (edge.name.empty()) edge.name = strand.edge.name;
        }
        if (!strand.edge.shared) continue;
        if (own.edge.shared && &each != &arc.along.front()) {
          if (own.edge.shared != strand.edge.shared)
            tell_two_numbers(*own.edge.shared, *strand.edge.shared, edge.start());
          continue;
        }
        const double a = std::lerp(strand.edge.from, strand.edge.to, each.from),
                     b = std::lerp(strand.edge.from, strand.edge.to, each.to);
        const double hair = 1e-9 * std::abs(strand.whole_to - strand.whole_from);
        const bool all = std::abs(std::min(a, b) - std::min(strand.whole_from, strand.whole_to)) <= hair &&
                         std::abs(std::max(a, b) - std::max(strand.whole_from, strand.whole_to)) <= hair;
        edge.shared = all ? *strand.edge.shared : numbers_.of(*strand.edge.shared, std::min(a, b), std::max(a, b));
        edge.against = strand.edge.against != each.against;
        edge.tolerance = std::max(edge.tolerance, strand.edge.tolerance);
      }
      s.edges.push_back(std::move(edge));
      s.bounds.push_back(bounds ? 1 : 0);
      s.line.push_back(line);
      s.kind.push_back(kind);
      s.cracks.push_back(crack_on(arc));
    }
  }

  /// The first of the cracks that run along an arc.
  [[nodiscard]] std::optional<CrackOnArc> crack_on(const Arc& arc) const {
    const std::vector<Strand>& strands = made_->arcs.strands;
    const Along* first = nullptr;
    for (const Along& each : arc.along) {
      if (strands[each.strand].kind != ChartLine::Kind::Crack) continue;
      if (first == nullptr || strands[each.strand].line < strands[first->strand].line) first = &each;
    }
    if (first == nullptr) return std::nullopt;
    const Strand& own = strands[first->strand];
    CrackOnArc crack{own.edge.name, own.line, first->strand, std::min(first->from, first->to), first->against, {}};
    for (const Along& each : arc.along) {
      const Strand& strand = strands[each.strand];
      const std::string& name = strand.edge.name;
      if (strand.side || name.empty() || name == crack.name) continue;
      if (std::find(crack.others.begin(), crack.others.end(), name) == crack.others.end()) crack.others.push_back(name);
    }
    return crack;
  }

  void tell_two_numbers(SharedCurveId kept, SharedCurveId lost, Point uv) {
    findings_.push_back(
        {"numbers_coincide",
         fmt::format("shared curves {} and {} coincide here: the edge has the number of the first", kept, lost),
         place_of(made_->surface, uv)});
  }

  /// Faces between which no line bounds are one part.
  void find_parts(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
    Recognised::State& s = *made_;
    const Subdivision& sub = s.faces.subdivision;
    std::size_t top = 0;
    for (const FaceId f : sub.faces()) top = std::max<std::size_t>(top, f.index() + 1);
    std::vector<std::size_t> parent(top);
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto join = [&](FaceId a, FaceId b) {
      if (a == Subdivision::unbounded() || b == Subdivision::unbounded()) return;
      parent[root(parent, std::max(a.index(), b.index()))] = root(parent, std::min(a.index(), b.index()));
    };
    std::vector<std::pair<FaceId, FaceId>> beside(s.arcs.arcs.size());  // of an arc: left and right
    for (const EdgeId e : sub.edges()) {
      const HalfEdgeId h = Subdivision::half_edge(e);
      const Chord chord = s.faces.chords[h.index()];
      const HalfEdgeId along = chord.forward ? h : Subdivision::twin(h);
      beside[chord.arc] = {sub.face(along), sub.face(Subdivision::twin(along))};
      if (s.bounds[chord.arc] == 0) join(sub.face(h), sub.face(Subdivision::twin(h)));
    }
    if (s.options.across_seams) {
      for (const auto& [low, high] : pairs) {
        // Not where a line runs along the seam.
        if (drawn(low) || drawn(high)) continue;
        const auto inside = [&](std::size_t arc) {
          return beside[arc].first == Subdivision::unbounded() ? beside[arc].second : beside[arc].first;
        };
        join(inside(low), inside(high));
      }
    }
    s.parts.assign(top, -1);
    std::vector<int> number(top, -1);
    std::vector<std::pair<Point, std::size_t>> order;
    for (const FaceId f : sub.faces()) {
      if (f == Subdivision::unbounded()) continue;
      Point least{2.0, 2.0};
      for (const HalfEdgeId h : sub.half_edges(sub.outer_loop(f))) least = std::min(least, sub.point(sub.origin(h)));
      order.emplace_back(least, f.index());
    }
    std::sort(order.begin(), order.end());
    for (const auto& [least, f] : order) {
      int& known = number[root(parent, f)];
      if (known < 0) known = s.count++;
      s.parts[f] = known;
    }
  }
  [[nodiscard]] bool drawn(std::size_t arc) const {
    return std::any_of(made_->arcs.arcs[arc].along.begin(), made_->arcs.arcs[arc].along.end(), [&](const Along& each) {
      const Strand& strand = made_->arcs.strands[each.strand];
      return !strand.side && strand.bounds;
    });
  }

  void number_seams(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
    Recognised::State& s = *made_;
    for (const auto& [low, high] : pairs) {
      ChartEdge &a = s.edges[low], &b = s.edges[high];
      if (!a.shared && !b.shared) a.shared = numbers_.fresh();
      if (!a.shared) a.shared = b.shared, a.against = b.against;
      b.shared = a.shared;
      b.against = a.against;  // both sides of the chart run the same way
    }
  }

  std::shared_ptr<Recognised::State> made_;
  SharedNumbers& numbers_;
  std::vector<Finding> findings_;
};

/// Lines between two faces.
void number_between(Recognised::State& s, SharedNumbers& numbers) {
  const Subdivision& sub = s.faces.subdivision;
  std::vector<std::uint8_t> between(s.edges.size(), 0);
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Subdivision::half_edge(e);
    const int left = s.parts[sub.face(h).index()], right = s.parts[sub.face(Subdivision::twin(h)).index()];
    if (left >= 0 && right >= 0 && left != right) between[s.faces.chords[h.index()].arc] = 1;
  }
  for (std::size_t a = 0; a < s.edges.size(); ++a) {
    if (between[a] != 0 && !s.edges[a].shared) s.edges[a].shared = numbers.fresh();
  }
}

/// Lines that end on a side of the chart so near to each other that they may be meant to meet.
void tell_openings(const Recognised::State& s, std::size_t lines, std::vector<Finding>& findings) {
  constexpr double near = 1e-5;
  for (std::size_t a = 0; a < s.arcs.arcs.size(); ++a) {
    const Arc& arc = s.arcs.arcs[a];
    if (!s.arcs.strands[arc.strand].side || s.line[a] < lines) continue;
    const Point p = s.arcs.uv(s.arcs.vertices[arc.start]), q = s.arcs.uv(s.arcs.vertices[arc.end]);
    if (geom::distance(s.arcs.vertices[arc.start], s.arcs.vertices[arc.end]) >= near) continue;
    findings.push_back({"ends_apart",
                        fmt::format("a line ends {:.3g} m beside the end of another one or a corner of the chart: what "
                                    "they bound is open there",
                                    geom::distance(s.surface.at(p), s.surface.at(q))),
                        place_of(s.surface, p)});
  }
}

}  // namespace

base::Result<Analysed> analysed(const Surface& surface, std::span<const TrimLine> lines, SharedNumbers& numbers,
                                const RecogniseOptions& options) {
  return Recogniser(surface, numbers, options).run(lines);
}

base::Result<Recognised> recognise(const Surface& surface, std::span<const TrimLine> lines, SharedNumbers& numbers,
                                   const RecogniseOptions& options) {
  DOBRA_TRY(Analysed found, analysed(surface, lines, numbers, options));
  number_between(*found.state, numbers);
  tell_openings(*found.state, lines.size(), found.findings);
  return Recognised(found.state, std::move(found.findings));
}

base::Result<Recognised> recognise(const Surface& surface, std::span<const TrimLine> lines,
                                   const RecogniseOptions& options) {
  SharedNumbers numbers;
  return recognise(surface, lines, numbers, options);
}

}  // namespace dobra::surf::trim
