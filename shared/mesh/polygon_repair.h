#pragma once
// What is wrong with a polygon mesh, with places, and what can be mended without asking: equal points, repeated faces,
// faces turned the wrong way, holes. Everything that was done is told. Page: docs/algorithms/polygon_mesh.md. Source:
// [foley1990graphics] 11.1 for the checks; the repairs are ours.

#include <string>
#include <vector>

#include "shared/mesh/polygon_mesh.h"

namespace dobra::mesh {

/// A face of more than three corners that is not plane.
struct WarpedFace {
  std::uint32_t face = 0;
  double distance = 0.0;  ///< Of its farthest corner from the mean plane, m.
};

/// Whether polygons are closed, edges have two faces and points two edges; whether faces are plane; how many parts.
struct PolygonReport {
  std::vector<PolygonFinding> findings;  ///< Those of check().
  std::vector<geom::Point3> places;      ///< Of each finding: the middle of the points that it names.
  std::size_t parts = 0;                 ///< Faces that hang together over edges.
  std::vector<WarpedFace> warped;
};

/// @param flat  a face is plane if no corner is farther from its mean plane than this fraction of the mesh's diagonal.
/// @cost  O(n log n)
PolygonReport report(const PolygonMesh& mesh, Closedness closedness, double flat = 1e-9);

struct PolygonRepairOptions {
  double merge = 0.0;         ///< Points that are so near to each other are one, m; 0: equal places.
  bool fill = true;           ///< Missing faces are put in.
  bool turn = true;           ///< Faces are turned like their neighbours, and parts outwards, or inwards in cavities.
  std::size_t longest = 100;  ///< Corners of a hole that is filled at most.
};

struct PolygonRepair {
  enum class Kind : std::uint8_t {
    MergedPoints,
    DroppedPoints,   ///< Points of no face.
    DroppedFaces,    ///< Less than three corners once equal ones were merged, or bad ones.
    DroppedRepeats,  ///< Faces with the corners of another one.
    TurnedFaces,
    FilledHole
  };
  Kind kind;
  std::vector<std::uint32_t> items;  ///< Points or faces of the mesh as it was given; of a hole its corners.
  geom::Point3 place;                ///< The middle of what is meant.
  std::string message;
};

struct RepairedPolygons {
  PolygonMesh mesh;
  std::vector<PolygonRepair> repairs;  ///< In the order done; none if nothing was wrong.
  std::vector<std::uint32_t> faces;    ///< Of each face the one as given that it comes from; of filled holes `none`.
  static constexpr std::uint32_t none = 0xffffffffU;
};

/// What remains wrong, check() tells. @cost O(n log n + parts that lie in each other's boxes * n)
RepairedPolygons repaired(const PolygonMesh& mesh, const PolygonRepairOptions& options = {});

}  // namespace dobra::mesh
