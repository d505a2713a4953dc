#pragma once
// A solid as a value: the boundary of a regular set of space, made of plane faces with holes. Half-edges are the
// corners of loops; every one has its mate across the edge. Places are exact (space.h), so that operations on results
// stay exact. Page: docs/algorithms/boolean.md. Source: [mantyla1988solid].
//
// Where parts of the solid touch in an edge or a vertex, that edge or vertex is there once for each part: the boundary
// is a manifold that touches itself.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shared/base/id.h"
#include "shared/geom/point3.h"
#include "shared/solid/soup.h"

namespace dobra::solid {

struct FaceTag {
  static constexpr const char* prefix = "f";
};
struct HalfEdgeTag {
  static constexpr const char* prefix = "h";
};
struct VertexTag {
  static constexpr const char* prefix = "v";
};
struct ShellTag {
  static constexpr const char* prefix = "s";
};
using FaceId = base::Id<FaceTag>;
using HalfEdgeId = base::Id<HalfEdgeTag>;  ///< A corner of a loop, and the side of the edge that leaves it.
using VertexId = base::Id<VertexTag>;
using ShellId = base::Id<ShellTag>;

/// Numbers of a solid; vertices - edges + faces = 2 (shells - handles) + rings.
struct Counts {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t rings = 0;   ///< Loops of faces beyond the first.
  std::size_t shells = 0;  ///< Connected parts of the boundary; those of cavities count.
  long handles = 0;        ///< Of all shells together.
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// How a boundary hangs together; what a Solid is made of.
struct Boundary {
  Soup soup;                            ///< One operand; a facet is a face, its upper side is outside.
  std::vector<std::uint32_t> mates;     ///< Of each corner, the corner where the other side of its edge begins.
  std::vector<std::uint32_t> vertices;  ///< Of each corner; two vertices may be at one place.
  std::vector<std::uint32_t> shells;    ///< Of each facet.
  std::uint32_t vertex_count = 0;
  std::uint32_t shell_count = 0;
  std::vector<std::string> names;  ///< What Facet::name stands for.
};

class Solid {
 public:
  /// The empty set.
  Solid();
  explicit Solid(Boundary boundary);

  [[nodiscard]] bool empty() const { return face_count() == 0; }
  [[nodiscard]] std::size_t face_count() const { return boundary_->soup.facets.size(); }
  [[nodiscard]] std::size_t vertex_count() const { return boundary_->vertex_count; }
  [[nodiscard]] std::size_t edge_count() const { return boundary_->mates.size() / 2; }
  [[nodiscard]] std::size_t shell_count() const { return boundary_->shell_count; }
  /// Neighbours in one plane are one face unless their names differ; edges in one line are one.
  [[nodiscard]] Counts counts() const;

  // ---- traversal; loops run anticlockwise seen from outside, those round holes clockwise ------------------------
  /// The first half-edge of each loop of the face.
  [[nodiscard]] std::vector<HalfEdgeId> loops(FaceId f) const;
  [[nodiscard]] HalfEdgeId next(HalfEdgeId h) const { return HalfEdgeId(links_->next[h.index()]); }
  [[nodiscard]] HalfEdgeId mate(HalfEdgeId h) const { return HalfEdgeId(boundary_->mates[h.index()]); }
  [[nodiscard]] VertexId origin(HalfEdgeId h) const { return VertexId(boundary_->vertices[h.index()]); }
  [[nodiscard]] FaceId face(HalfEdgeId h) const { return FaceId(links_->face[h.index()]); }
  [[nodiscard]] ShellId shell(FaceId f) const { return ShellId(boundary_->shells[f.index()]); }
  /// The nearest doubles of the place where the half-edge begins.
  [[nodiscard]] geom::Point3 point(HalfEdgeId h) const { return space().rounded(boundary_->soup.corners[h.index()]); }
  /// The name of what the face comes from.
  [[nodiscard]] const std::string& name(FaceId f) const {
    return boundary_->names[boundary_->soup.facets[f.index()].name];
  }

  [[nodiscard]] const Boundary& boundary() const { return *boundary_; }
  [[nodiscard]] const Space& space() const { return boundary_->soup.space; }

 private:
  std::shared_ptr<const Boundary> boundary_;
  /// Of each half-edge; read off the loops.
  struct Links {
    std::vector<std::uint32_t> next, face;
  };
  std::shared_ptr<const Links> links_;
};

}  // namespace dobra::solid
