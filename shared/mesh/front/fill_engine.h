#pragma once
// What fills a domain with triangles of the sizes wanted, in steps: two engines behind one interface.
//   Front     rows of triangles from the marked sides inwards, gaps between them filled by points
//             (advancing_front.h, front_gaps.h): fast, and as good as can be where sizes grow slowly.
//   Delaunay  points one by one in a constrained Delaunay triangulation, placed where a front would put them
//             (frontal_points.h): several times slower; what the front falls back upon.
// Both obey the size field and keep every marked side. Page: docs/algorithms/triangulate.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "shared/base/progress.h"
#include "shared/geom/segment.h"
#include "shared/mesh/delaunay/delaunay_kernel.h"
#include "shared/mesh/sizing/size_field.h"

namespace dobra::mesh::front {

enum class Engine : std::uint8_t { Front, Delaunay };

struct FrontalOptions {
  double accept = 1.2;          ///< A triangle is small enough if its circumradius is below accept * h / sqrt(3).
  double least_spacing = 0.75;  ///< A point nearer than this * h to another is not inserted.
  double least_wall = 0.6;      ///< Nor one nearer than this * min(h, length) to a marked side of that length.
  std::size_t max_triangles = 20'000'000;  ///< More end in TooManyElements.
};

/// Works on the cells with region >= 0 of a kernel, which nobody else may change until it is done; then they are the
/// constrained Delaunay triangulation of the domain with the new nodes.
class FillEngine {
 public:
  FillEngine() = default;
  virtual ~FillEngine() = default;
  FillEngine(const FillEngine&) = delete;
  FillEngine& operator=(const FillEngine&) = delete;

  /// About `count` nodes or triangles more.
  /// @error TooManyElements with advice; Cancelled; SelfIntersection from parts of an engine. The kernel is then
  /// spoilt.
  /// @pre   not done, no error so far
  virtual base::Result<void> step(std::size_t count, const base::Progress& progress) = 0;
  [[nodiscard]] virtual bool done() const = 0;
  /// The sides from which it goes on: to be drawn.
  [[nodiscard]] virtual std::vector<geom::Segment> front() const = 0;
};

/// @pre the references outlive the engine.
std::unique_ptr<FillEngine> make_engine(Engine engine, delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                        const FrontalOptions& options);

/// Makes room for the triangles of the sizes wanted into which the cells with region >= 0 will be divided: arrays that
/// double whenever they are full take up to three times as much as they hold.
/// @return about how many cells there will be.  @cost O(cells)
std::size_t make_room(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field, const FrontalOptions& options);

/// @error TooManyElements with advice if `triangles` are more than the options allow.
base::Result<void> check_limit(std::size_t triangles, const FrontalOptions& options);

}  // namespace dobra::mesh::front
