// Sides of closed lines, and what lines have in common with cracks.
#include <algorithm>
#include <optional>

#include "shared/surf/trim/state.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using topo::EdgeId;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Subdivision;

std::vector<std::vector<StepOver>> steps_between(const Recognised::State& s,
                                                 std::span<const std::pair<std::size_t, std::size_t>> seams) {
  std::vector<std::vector<StepOver>> steps(s.parts.size());
  std::vector<std::optional<std::size_t>> at_side(s.arcs.arcs.size());  // the face beside an arc of a side
  const auto add = [&](std::size_t a, std::size_t b, std::size_t arc, std::optional<std::size_t> seam) {
    steps[a].push_back({b, arc, seam});
    steps[b].push_back({a, arc, seam});
  };
  const Subdivision& sub = s.faces.subdivision;
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Subdivision::half_edge(e);
    const std::size_t arc = s.faces.chords[h.index()].arc;
    const FaceId left = sub.face(h), right = sub.face(Subdivision::twin(h));
    if (left == Subdivision::unbounded() || right == Subdivision::unbounded()) {
      at_side[arc] = (left == Subdivision::unbounded() ? right : left).index();
    } else {
      add(left.index(), right.index(), arc, std::nullopt);
    }
  }
  for (const auto& [low, high] : seams) {
    if (at_side[low] && at_side[high]) add(*at_side[low], *at_side[high], low, high);
  }
  return steps;
}

base::Result<std::vector<std::uint8_t>> Recognised::sides_of(std::span<const std::size_t> lines) const {
  const State& s = *state_;
  std::vector<std::uint8_t> odd(s.arcs.arcs.size(), 0);  // arcs that the lines run along an odd number of times
  for (std::size_t arc = 0; arc < odd.size(); ++arc) {
    for (const Along& each : s.arcs.arcs[arc].along) {
      if (std::find(lines.begin(), lines.end(), s.arcs.strands[each.strand].line) != lines.end()) odd[arc] ^= 1U;
    }
  }
  std::vector<std::optional<bool>> side(s.parts.size());
  for (std::size_t first = 0; first < side.size(); ++first) {
    if (s.parts[first] < 0 || side[first]) continue;
    side[first] = false;
    std::vector<std::size_t> todo{first};
    while (!todo.empty()) {
      const std::size_t face = todo.back();
      todo.pop_back();
      for (const StepOver& step : s.steps[face]) {
        const bool across = odd[step.arc] != (step.seam ? odd[*step.seam] : 0);
        const bool there = *side[face] != across;
        if (!side[step.to]) {
          side[step.to] = there;
          todo.push_back(step.to);
        } else if (*side[step.to] != there) {
          return Error{ErrorCode::CannotMesh,
                       "a line has no inside here: the way round it comes to its other side; let it close",
                       place_of(s.surface, s.edges[step.arc].start())};
        }
      }
    }
  }
  std::vector<std::uint8_t> of(faces_.size(), 0);
  for (std::size_t f = 0; f < side.size(); ++f) {
    if (s.parts[f] >= 0) of[static_cast<std::size_t>(s.parts[f])] = *side[f] ? 1 : 0;
  }
  return of;
}

std::vector<OnCrack> Recognised::on_cracks(std::span<const std::size_t> faces) const {
  const State& s = *state_;
  const Subdivision& sub = s.faces.subdivision;
  const auto meant = [&](FaceId face) {
    const int part = s.parts[face.index()];
    return std::any_of(faces.begin(), faces.end(), [&](std::size_t each) { return static_cast<int>(each) == part; });
  };
  std::vector<OnCrack> found;
  std::vector<std::uint8_t> seen(s.edges.size(), 0), meant_beside(s.edges.size(), 0);
  for (const EdgeId e : sub.edges()) {
    const HalfEdgeId h = Subdivision::half_edge(e);
    const std::size_t arc = s.faces.chords[h.index()].arc;
    if (meant(sub.face(h)) || meant(sub.face(Subdivision::twin(h)))) meant_beside[arc] = 1;
    if (seen[arc] != 0 || !s.cracks[arc] || s.cracks[arc]->others.empty()) continue;
    if (!meant(sub.face(h)) || !meant(sub.face(Subdivision::twin(h)))) continue;
    seen[arc] = 1;
    const ChartEdge& edge = s.edges[arc];
    found.push_back({s.cracks[arc]->name, s.cracks[arc]->others, edge.at(0.5 * (edge.from + edge.to))});
  }
  // A line along a seam may have been drawn on either side of it.
  for (const auto& [low, high] : s.seams) {
    const auto& crack = s.cracks[low] ? s.cracks[low] : s.cracks[high];
    if (!crack || meant_beside[low] == 0 || meant_beside[high] == 0) continue;
    std::vector<std::string> others;
    for (const std::size_t arc : {low, high}) {
      for (const Along& each : s.arcs.arcs[arc].along) {
        const Strand& strand = s.arcs.strands[each.strand];
        const std::string& name = strand.edge.name;
        if (strand.side || name.empty() || name == crack->name) continue;
        if (std::find(others.begin(), others.end(), name) == others.end()) others.push_back(name);
      }
    }
    const ChartEdge& edge = s.edges[low];
    if (!others.empty()) found.push_back({crack->name, std::move(others), edge.at(0.5 * (edge.from + edge.to))});
  }
  return found;
}

}  // namespace dobra::surf::trim
