#pragma once
// Solids as trees of planes: each divides what it is given into what is above and below, and leaves are inside or
// outside. Cells with many faces are halved across their longest side first, so that a convex solid of n faces has
// O(log n) planes above most leaves; then faces' own planes divide. Exact. Page: docs/algorithms/partition.md. Sources:
// [fuchs1980visible], [thibault1987set] (operations on trees).

#include <cstdint>
#include <memory>
#include <vector>

#include "shared/base/result.h"
#include "shared/solid/measure.h"
#include "shared/solid/partition/orthtree.h"
#include "shared/solid/solid.h"

namespace dobra::solid::partition {

struct BspOptions {
  int few = 8;        ///< Faces of a cell that is divided by its faces' planes.
  int tried = 5;      ///< Planes of which the one is taken that cuts fewest faces.
  int halvings = 40;  ///< Across the longest side, one below the other.
};

class Bsp {
 public:
  /// @error CannotMesh: a face that cannot be cut into triangles.  @cost O(n log n) if planes cut few faces
  static base::Result<Bsp> of(const Solid& solid, const BspOptions& options = {});

  /// Exact.  @pre finite  @cost O(depth), where p is on no plane
  [[nodiscard]] Location locate(geom::Point3 p) const;
  /// Of the cells that are inside, within the box of the solid; each is a convex polyhedron whose corners are exact.
  /// @cost O(nodes * corners of cells)
  [[nodiscard]] double inner_volume() const;

  [[nodiscard]] std::size_t plane_count() const { return nodes_.size(); }
  [[nodiscard]] std::size_t depth() const;

  /// Leaves of a are replaced by b where it decides; planes that do not cut a cell are left out.
  /// @cost O(nodes of a * nodes of b) at worst
  friend Bsp combine(const Bsp& a, const Bsp& b, SetOperation operation);

 private:
  /// A node's number, or a leaf.
  using Ref = std::int32_t;
  static constexpr Ref outside = -1;
  static constexpr Ref inside = -2;
  struct Node {
    PlaneId plane;
    Ref above, below;
  };
  struct Builder;
  struct Merger;

  [[nodiscard]] Location locate(Ref at, geom::Point3 p) const;

  std::shared_ptr<const Space> space_;
  std::vector<Node> nodes_;
  Ref root_ = outside;
  Box<3> box_;
};

}  // namespace dobra::solid::partition
