#pragma once
// Polygon meshes become solids, and solids meshes. A mesh is taken as it stands: nothing is moved, equal places are
// one, faces that are not exactly plane are cut into triangles, faces without area are left out. What is not the
// boundary of a solid is refused with the faces and the place. Meshes to be written are made by settle.h. Page:
// docs/algorithms/boolean.md.

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/solid/solid.h"

namespace dobra::solid {

/// What becomes of faces that cross, or bound a region twice or from the wrong side.
enum class Crossings : std::uint8_t {
  Refused,
  Resolved  ///< They are cut where they meet, and inside is what is surrounded once or more.
};

struct FromMeshOptions {
  std::string name;                          ///< Of faces that have none of their own.
  std::vector<std::string> face_names = {};  ///< One for each face of the mesh, or empty. Neighbours in one plane with
                                             ///< names that differ stay two faces.
  Crossings crossings = Crossings::Refused;
};

/// Parts of the mesh may touch in faces' corners, in edges and in vertices, and lie in each other's cavities, turned
/// over; edges may end within others if the surface closes there.
/// @error NotFinite, NotClosed (an edge where a face is missing or turned over), InsideOut, SelfIntersection (a face
///        that crosses itself, faces that cross, or a region that is surrounded twice or from the wrong side).
/// @cost  O(n log n + pairs of faces whose boxes overlap)
base::Result<Solid> from_mesh(const mesh::PolygonMesh& mesh, const FromMeshOptions& options = {});

/// Faces with holes: loops of corners, the first anticlockwise seen from outside; the others are its holes, either way.
struct FaceLoops {
  std::vector<geom::Point3> points;
  std::vector<std::vector<std::vector<std::uint32_t>>> faces;
};
/// The same for them; nothing is what bounds nothing.
base::Result<Solid> from_loops(const FaceLoops& mesh, const FromMeshOptions& options = {});

/// Faces that cover each other, one turned against the other: what they have in common bounds nothing and is left out.
struct OppositeFaces {
  std::uint32_t face = 0, against = 0;  ///< Two of them, numbers in the mesh.
  std::size_t pairs = 1;                ///< Of faces that do so and hang together with these two.
  bool inside = false;  ///< The solid is on both sides: a wall within it, as between two boxes side by side. Else a
                        ///< sheet without thickness, outside or on it.
  geom::Point3 at;      ///< Where the two have a corner of what they cover together.
};
/// One line without the place.
std::string message(const OppositeFaces& faces);

/// Faces whose corners lie off their mean planes by more than 1e-9 of the mesh's diagonal. They are cut into triangles
/// in a way that depends neither on the corner they begin with nor on which way they run.
struct WarpedFaces {
  std::size_t count = 0;
  std::uint32_t face = 0;  ///< The one of them with the corner that is farthest off.
  double distance = 0.0;   ///< Of that corner from the mean plane, m.
  geom::Point3 at;         ///< That corner.
  double volume = 0.0;     ///< By how much the volume may differ where all of them are cut otherwise, at most, m3.
};
/// One line without the place.
std::string message(const WarpedFaces& faces);

struct Taken {
  Solid solid;
  std::vector<OppositeFaces> opposite = {};  ///< By number of `face`.
  std::optional<WarpedFaces> warped = {};
  bool resolved = false;  ///< Crossings::Resolved had something to do.
};
/// from_mesh() and from_loops() with what they leave out and cut.
base::Result<Taken> take(const mesh::PolygonMesh& mesh, const FromMeshOptions& options = {});
base::Result<Taken> take(const FaceLoops& mesh, const FromMeshOptions& options = {});

struct ToMesh {
  mesh::PolygonMesh mesh;
  std::vector<std::string> names;  ///< Of each face.
  double displacement = 0.0;       ///< The farthest that rounding to doubles moved a vertex at most, m; 0 if none was.
};

/// What faces become.
enum class FacesAs : std::uint8_t {
  Polygons,  ///< Triangles, where they have holes or a corner that had to be rounded; the others stay as they are.
  Triangles
};

/// Every face as it is, rounded: where faces nearly touch, they may cross by that.
/// @error CannotMesh if a face cannot be cut into triangles.
/// @cost  O(n); O(m^2) at worst for a face of m corners that is cut.
base::Result<ToMesh> to_mesh(const Solid& solid, FacesAs as = FacesAs::Polygons);

}  // namespace dobra::solid
