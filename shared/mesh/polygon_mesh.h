#pragma once
// Polygon meshes in space as a file gives them, before anybody trusts them: corners of faces by index, the table of
// their edges, and a check that names every fault with its indices. Page: docs/algorithms/polygon_mesh.md.
// Source: [foley1990graphics] 11.1 (explicit edges and their consistency), [newell1972] as told there (normals).

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/geom/point3.h"

namespace dobra::mesh {

/// Faces are cycles of corners, anticlockwise seen from outside; the first corner is not repeated.
struct PolygonMesh {
  std::vector<geom::Point3> points;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// An explicit edge: its ends, the smaller index first, and the faces that it says it bounds, ascending.
struct PolygonEdge {
  std::uint32_t a = 0, b = 0;
  std::vector<std::uint32_t> faces;
  friend bool operator==(const PolygonEdge&, const PolygonEdge&) = default;
};

enum class PolygonFault : std::uint8_t {
  BadCorner,         ///< A corner that does not exist, or is not finite.
  TooFewCorners,     ///< A face of less than three corners.
  ZeroLengthEdge,    ///< Two corners that follow each other lie at one place.
  RepeatedEdge,      ///< A face passes an edge twice.
  OpenBoundary,      ///< A loop of edges of one face each, where the mesh is to be closed: a face is missing.
  TooManyFaces,      ///< An edge of more than two faces.
  ReversedFace,      ///< Turned against its neighbours.
  NotOrientable,     ///< No choice of turns makes the neighbours agree.
  UnusedPoint,       ///< A point that no face names.
  EdgeNotReciprocal  ///< An edge names a face that does not pass it, or the reverse, or is listed twice.
};

struct PolygonFinding {
  PolygonFault fault;
  std::vector<std::uint32_t> faces;   ///< Indices into PolygonMesh::faces, ascending.
  std::vector<std::uint32_t> points;  ///< The ends of the edge, the loop, or the points meant.
  std::string message;                ///< All of it in a line, with 0-based indices.
};

/// Whether edges of one face are faults.
enum class Closedness : std::uint8_t { Solid, Sheet };

/// The edges of all faces, sorted by their ends. @pre corners exist  @cost O(n log n)
std::vector<PolygonEdge> edges_of(const PolygonMesh& mesh);

/// All faults, in the order of PolygonFault, then of indices; empty if the mesh is good. Of faces that
/// hang together but are turned against each other those are named that TurnedAlike (face_turns.h) does not let stay.
/// Faces with bad corners are left out of the later checks.
/// @cost O(n log n)
std::vector<PolygonFinding> check(const PolygonMesh& mesh, Closedness closedness);
/// The same with the file's own edges against the faces.
std::vector<PolygonFinding> check(const PolygonMesh& mesh, std::span<const PolygonEdge> edges, Closedness closedness);

/// Newell's vector of a closed polygon: normal to its mean plane, as long as its area there, m2. Does not depend on
/// which corner is reflex. @pre points.size() >= 3
geom::Point3 newell_area(std::span<const geom::Point3> points);

/// Signed distances of the corners from the plane through their mean with Newell's normal, m; none if the area is zero.
std::vector<double> distances_from_mean_plane(std::span<const geom::Point3> points);

}  // namespace dobra::mesh
