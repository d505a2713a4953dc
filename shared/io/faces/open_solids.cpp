#include "shared/io/faces/open_solids.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "shared/io/faces/face.h"
#include "shared/io/faces/piece.h"

namespace dobra::io::faces {

namespace {

struct Alone {
  const brep::LoopEdge* edge;
  const brep::TrimmedFace* face;
};

std::optional<geom::Point3> first_end(const brep::Model& model, const brep::LoopEdge& edge) {
  for (const brep::Use& part : model.shapes[edge.edge].parts) {
    if (const auto* vertex = std::get_if<brep::Vertex>(&model.shapes[part.shape].is))
      return (edge.placement * part.placement).of(vertex->at);
  }
  return std::nullopt;
}

}  // namespace

void tell_open_solids(const brep::Model& model, std::span<const brep::TrimmedFace> faces,
                      std::vector<surf::mesh::Finding>& findings) {
  std::map<std::size_t, std::vector<const brep::TrimmedFace*>> solids;
  for (const brep::TrimmedFace& face : faces) {
    if (face.solid) solids[*face.solid].push_back(&face);
  }
  for (const auto& [solid, own] : solids) {
    SharedEdges numbers;
    std::map<surf::trim::SharedCurveId, std::pair<int, Alone>> uses;
    for (const brep::TrimmedFace* face : own) {
      for (const auto& loop : face->loops) {
        for (const brep::LoopEdge& edge : loop) {
          const auto* shape = std::get_if<brep::Edge>(&model.shapes[edge.edge].is);
          if (shape == nullptr || shape->degenerated) continue;
          if (edge.orientation != brep::Orientation::Forward && edge.orientation != brep::Orientation::Reversed)
            continue;
          ++uses.try_emplace(numbers.id_of(edge.edge, edge.placement), 0, Alone{&edge, face}).first->second.first;
        }
      }
    }
    std::size_t alone = 0;
    std::optional<Alone> first;
    for (const auto& [number, use] : uses) {
      if (use.first != 1) continue;
      ++alone;
      if (!first) first = use.second;
    }
    if (!first) continue;
    Report(findings, first->face->place)
        .say(
            "solid_open",
            fmt::format("its solid, of {} faces, is open: edges that one face has alone: {}; the first of them is here",
                        own.size(), alone),
            std::nullopt, first_end(model, *first->edge));
  }
}

}  // namespace dobra::io::faces
