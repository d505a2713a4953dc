#pragma once
// The mesher of plane domains: sizes from the quadtree, a constrained Delaunay triangulation that holds every given
// edge, interior nodes from one of two engines (fill_engine.h), flips and smoothing; at once, or step by step.
// Page: docs/algorithms/triangulate.md. Sources: [miranda1999mesh] (quadtree, front), [rebay1993] (points),
// [miranda2009surface] (smoothing, measure of quality).

#include <memory>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/mesh/front/fill_engine.h"
#include "shared/mesh/front/smooth.h"
#include "shared/mesh/sizing/size_field.h"

namespace dobra::mesh::front {

struct MeshOptions {
  Engine engine = Engine::Front;        ///< What places the interior nodes.
  sizing::SizeFieldOptions sizes = {};  ///< Growth 1.3; no element larger than the longest given edge.
  FrontalOptions points = {};           ///< Where points may be put; limit on the number of triangles.
  SmoothOptions smoothing = {.enough = 0.925, .rescue = 0.9};  ///< Of each round.
  int rounds = 3;  ///< Rounds of flips and smoothing after the points are placed; 0 for none.
};

/// A mesher at work, to be watched or stopped anywhere: start, step until done, take the mesh.
class Mesher {
 public:
  enum class Stage : std::uint8_t { Filling, Improving, Done };
  /// What there is at the moment, to be drawn.
  struct View {
    TriangleMesh triangles;            ///< Without sets. Engine::Front: those made so far; else a mesh of the domain.
    std::vector<geom::Segment> front;  ///< The sides from which the engine goes on.
  };

  /// Triangulates the input and finds the sizes.  @error as triangulate, before any point is placed.
  static base::Result<Mesher> start(const delaunay::MeshInput& input, const MeshOptions& options = {},
                                    const base::Progress& progress = {});
  /// About `count` nodes or triangles more; flips and smoothing are the last step.
  /// @error TooManyElements, Cancelled: no further step.  @pre not done
  base::Result<void> step(std::size_t count, const base::Progress& progress = {});
  [[nodiscard]] Stage stage() const;
  [[nodiscard]] bool done() const { return stage() == Stage::Done; }
  [[nodiscard]] const sizing::SizeField& sizes() const;
  [[nodiscard]] View view() const;
  /// What triangulate returns.  @pre done
  [[nodiscard]] TriangleMesh mesh() const;

 private:
  struct State;
  explicit Mesher(std::unique_ptr<State> state);
  struct Destroy {
    void operator()(State* state) const;
  };
  std::unique_ptr<State, Destroy> state_;
};

/// Meshes the inside of the boundary edges of `input`.
/// @return mesh with every boundary and constraint edge as given (cut only at input points that lie exactly on it), in
///         named sets; triangles anticlockwise; nodes: the input points in their order (equal ones once), then the
///         rest.
/// @error  of build_domain (planar_domain.h): NotFinite, InvalidOption, CannotMesh, SelfIntersection, OutsideDomain;
///         TooManyElements with advice; Cancelled. With the place where there is one.
/// @cost   O(n log n) in the number n of triangles.
base::Result<TriangleMesh> triangulate(const delaunay::MeshInput& input, const MeshOptions& options = {},
                                       const base::Progress& progress = {});

/// The size field that `triangulate` would use: to draw it, or to ask sizes for something else.
/// @error as triangulate, before any point is placed.
base::Result<sizing::SizeField> size_field_of(const delaunay::MeshInput& input,
                                              const sizing::SizeFieldOptions& options = {});

}  // namespace dobra::mesh::front
