#pragma once
// The mesher of one face of a surface: sizes from a quadtree in its chart, rows of triangles from the given sides
// inwards, gaps, flips, smoothing. It is the mesher of the plane (mesh/front/triangulate.h) in another space: what must
// be decided is decided exactly in the chart, what is measured is measured in space. At once, or step by step. Page:
// docs/algorithms/surface_front.md. Sources: [miranda2009surface], [miranda1999mesh], [rebay1993].

#include <cstddef>
#include <memory>

#include "shared/base/progress.h"
#include "shared/mesh/front/smooth.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/mesh/tidy.h"
#include "shared/surf/mesh/unfold.h"

namespace dobra::surf::mesh {

struct ChartMeshOptions {
  SizeOptions sizes = {};
  dobra::mesh::front::FrontalOptions points = {};  ///< Where nodes may be put; limit on the number of triangles.
  dobra::mesh::front::SmoothOptions smoothing = {
      .passes = 2, .enough = 2.0, .equilateral = true, .least_step = 0.01, .rescue = 0.9};  ///< Of each round.
  int rounds = 3;            ///< Of flips and smoothing, after it; two at most before.
  std::size_t few = 20'000;  ///< Meshes of fewer triangles have one round more: more of their nodes are near a border.
  /// Where a mesh folds in space or has flat triangles, mesh_chart begins again with sizes inside that are smaller by
  /// this, so often, and takes the best.
  int attempts = 2;
  int unfolding = 5;  ///< So often where it folds: then there is no mesh at all.
  int alike = 2;      ///< But no more once so many followed each other that folded in one and the same place.
  /// But not where more triangles than this fold: then the surface does so itself, at any size.
  std::size_t hopeless = 200;
  double smaller = 0.93;
  double less_sideways = 0.8;  ///< And SizeOptions::sideways by this. Graphs never fold themselves.
  bool keep_folds = false;     ///< The best mesh is returned though it folds in space: the caller judges it.
  /// Meshes of more triangles have one round before `tidy` and one after it, their nodes rest within twice
  /// `smoothing.least_step`, and mesh_chart does not begin again for flat triangles.
  std::size_t large = 100'000;
  TidyOptions tidy = {};  ///< Between two of them.
  int unfold = 4;         ///< Rounds of `unfold` before it, and as many at the end.
};

/// A mesher at work, to be watched or stopped anywhere: start, step until done, take the mesh.
class ChartMesher {
 public:
  using Stage = dobra::mesh::front::Mesher::Stage;

  /// @error as mesh_chart, before any node is placed.
  static base::Result<ChartMesher> start(const ChartInput& input, const ChartMeshOptions& options = {},
                                         const base::Progress& progress = {});
  /// About `count` nodes or triangles more; flips and smoothing are the last step.
  /// @error TooManyElements, Cancelled: no further step.  @pre not done
  base::Result<void> step(std::size_t count, const base::Progress& progress = {});
  [[nodiscard]] Stage stage() const;
  [[nodiscard]] bool done() const { return stage() == Stage::Done; }
  /// The triangles made so far, as a mesh of the chart without sets.
  [[nodiscard]] dobra::mesh::front::Mesher::View view() const;
  /// Size wanted at a place of the chart, m in space.
  [[nodiscard]] double size_at(geom::Point uv) const;
  /// @pre done
  [[nodiscard]] FaceMesh mesh() const;

 private:
  struct State;
  explicit ChartMesher(std::unique_ptr<State> state);
  struct Destroy {
    void operator()(State* state) const;
  };
  std::unique_ptr<State, Destroy> state_;
};

/// Meshes the inside of the boundary edges of a face.
/// @return every given edge is there as given (cut only at given points that lie exactly on it in the chart), in named
///         sets. No triangle is turned in the chart.
/// @error  of build_domain (planar_domain.h): NotFinite, InvalidOption, CannotMesh, SelfIntersection, OutsideDomain,
/// with
///         the place in the chart; InvalidOption: sizes; DegenerateCurve: no normal inside, with the place;
///         TooManyElements with advice; CannotMesh: it folds in space, with the place; Cancelled.
/// @cost   O(n log n) in the number n of triangles; about three jets of the surface a node.
base::Result<FaceMesh> mesh_chart(const ChartInput& input, const ChartMeshOptions& options = {},
                                  const base::Progress& progress = {});

}  // namespace dobra::surf::mesh
