#pragma once
// What a recognised chart consists of. Of use inside this folder.

#include <utility>

#include "shared/surf/trim/faces.h"

namespace dobra::surf::trim {

/// The crack that runs along an arc.
struct CrackOnArc {
  std::string name;
  std::size_t line = 0, strand = 0;
  double from = 0.0;     ///< Where on the strand it begins, in the direction of the strand.
  bool against = false;  ///< It runs against the arc.
  std::vector<std::string> others;
};

/// From a face of the subdivision to one beside it, over an arc or over a seam.
struct StepOver {
  std::size_t to = 0;
  std::size_t arc = 0;
  std::optional<std::size_t> seam = {};  ///< The arc on its other side.
};
/// One list a face of the subdivision.
std::vector<std::vector<StepOver>> steps_between(const Recognised::State& s,
                                                 std::span<const std::pair<std::size_t, std::size_t>> seams);

struct Recognised::State {
  Surface surface;
  RecogniseOptions options;
  Arcs arcs;
  Faces faces;
  Parts parts;                   ///< One a face of the subdivision: which of faces(); -1 outside.
  std::vector<ChartEdge> edges;  ///< One an arc, in its direction; called as what bounds there.
  std::vector<std::uint8_t> bounds;
  std::vector<std::size_t> line;
  std::vector<ChartLine::Kind> kind;
  std::vector<std::optional<CrackOnArc>> cracks;           ///< One an arc: it is opened there where it lies inside.
  std::vector<std::pair<std::size_t, std::size_t>> seams;  ///< Arcs on both sides of a seam.
  std::vector<std::vector<StepOver>> steps;                ///< One list a face of the subdivision.
  int count = 0;

  explicit State(Surface of) : surface(std::move(of)) {}
  [[nodiscard]] ChartEdge edge(std::size_t arc, bool forward) const {
    ChartEdge made = edges[arc];
    if (forward) return made;
    std::swap(made.from, made.to);
    made.against = !made.against;
    return made;
  }
  /// As a side of a seam along which a crack runs.
  [[nodiscard]] static ChartEdge opened(ChartEdge edge, bool forward, const CrackOnArc& crack) {
    edge.name = crack.name;
    edge.crack = crack.against == forward ? ChartEdge::Crack::Against : ChartEdge::Crack::Along;
    return edge;
  }
  /// One an arc: the crack on the seam that it is a side of, where a face has both sides.
  [[nodiscard]] std::vector<const CrackOnArc*> cracks_on_seams(const Parts& of, int number) const;
  /// As a line inside: a crack comes before what runs along with it.
  [[nodiscard]] ChartEdge edge_inside(std::size_t arc) const {
    if (!cracks[arc]) return edges[arc];
    ChartEdge made = edge(arc, !cracks[arc]->against);
    made.name = cracks[arc]->name;
    return made;
  }
  [[nodiscard]] TrimmedSurface face(const Parts& of, int number, CommonLines common) const;
  [[nodiscard]] std::vector<ChartLine> lines_inside(const Parts& of, int number, CommonLines common) const;
};

/// Lines in, cut and with the faces that they bound; no numbers for edges between faces.
struct Analysed {
  std::shared_ptr<Recognised::State> state;
  std::vector<Finding> findings;
  std::vector<Meeting> meetings;
};
base::Result<Analysed> analysed(const Surface& surface, std::span<const TrimLine> lines, SharedNumbers& numbers,
                                const RecogniseOptions& options);

}  // namespace dobra::surf::trim
