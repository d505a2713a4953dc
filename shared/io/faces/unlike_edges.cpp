#include "shared/io/faces/unlike_edges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "shared/io/faces/piece.h"

namespace dobra::io::faces {

namespace {

using surf::trim::ChartEdge;
using surf::trim::TrimmedSurface;

/// Places of an edge in space, the way of the curve that faces share.
std::vector<geom::Point3> in_space(const TrimmedSurface& face, const ChartEdge& edge) {
  constexpr int samples = 16;
  std::vector<geom::Point3> places;
  for (int i = 0; i <= samples; ++i)
    places.push_back(face.surface.at(edge.at(std::lerp(edge.from, edge.to, static_cast<double>(i) / samples))));
  if (edge.against) std::reverse(places.begin(), places.end());
  return places;
}

}  // namespace

void part_unlike_edges(std::vector<TrimmedSurface>& faces, const std::vector<base::Place>& places,
                       std::vector<surf::mesh::Finding>& findings) {
  std::map<surf::trim::SharedCurveId, std::pair<const ChartEdge*, const TrimmedSurface*>> first;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (surf::trim::ChartLoop& loop : faces[f].loops) {
      for (ChartEdge& edge : loop.edges) {
        if (!edge.shared) continue;
        const auto [known, is_new] = first.try_emplace(*edge.shared, &edge, &faces[f]);
        if (is_new) continue;
        const auto& [other, its_face] = known->second;
        const std::vector<geom::Point3> own = in_space(faces[f], edge), theirs = in_space(*its_face, *other);
        double length = 0.0, their_length = 0.0;
        for (std::size_t i = 1; i < own.size(); ++i) {
          length += geom::distance(own[i - 1], own[i]);
          their_length += geom::distance(theirs[i - 1], theirs[i]);
        }
        const double gap =
            std::max(geom::distance(own.front(), theirs.front()), geom::distance(own.back(), theirs.back()));
        constexpr double part = 0.099;
        if (gap <= part * std::max(length, their_length) + std::max(edge.tolerance, other->tolerance)) continue;
        edge.shared = std::nullopt;
        Report(findings, places[f])
            .say("edge_apart",
                 fmt::format("{} ends {:.4g} m from where another face has it; the two are not joined there", edge.name,
                             gap),
                 edge.start(), own.front());
      }
    }
  }
}

}  // namespace dobra::io::faces
