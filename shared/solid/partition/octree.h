#pragma once
// Octrees and voxels of solids: what of a box is inside, as far as cells of a size can tell. Volumes have bounds that
// hold; a cell is full or empty only if the boundary surely does not pass through it, which its middle then decides
// exactly. Page: docs/algorithms/partition.md. Sources: [samet1984quadtree], [akenine2001box] (triangles against
// boxes).

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/solid/partition/orthtree.h"
#include "shared/solid/section.h"
#include "shared/solid/solid.h"

namespace dobra::solid::partition {

/// The least cube that holds all corners, from their low corner.  @pre a solid is not empty
Box<3> cube_round(std::span<const Solid> solids);

/// @param depth  at which cells stay partial; 0 to 12.
/// @error InvalidOption: the depth, or a box without volume; CannotMesh: a face that cannot be cut into triangles.
/// @cost  O(cells on the boundary * faces near each + (full and empty cells) log n)
base::Result<Octree> octree_of(const Solid& solid, const Box<3>& box, int depth);

/// Whether solids have volume in common, as far as cells tell.
enum class Clash : std::uint8_t {
  None,   ///< They surely do not.
  Maybe,  ///< Only cells that both boundaries pass are common.
  Sure    ///< A full cell of one meets the other.
};
/// @pre equal boxes  @cost O(nodes of both)
Clash clash(const Octree& a, const Octree& b);

/// Cells of one size in rows along x, then y, then z.
struct VoxelGrid {
  geom::Point3 origin;  ///< The low corner.
  geom::Vector3 size{1.0, 1.0, 1.0};
  std::array<std::uint32_t, 3> counts{1, 1, 1};

  [[nodiscard]] std::size_t count() const { return std::size_t{counts[0]} * counts[1] * counts[2]; }
  [[nodiscard]] Box<3> box(std::size_t voxel) const;
  [[nodiscard]] geom::Point3 middle(std::size_t voxel) const;
};

struct VoxelOptions {
  std::size_t most = 50'000'000;  ///< Voxels.
};

/// Empty, Full or Partial for each voxel.
/// @error InvalidOption: sizes or counts that are not above 0, not finite; TooManyElements; CannotMesh.
/// @cost  O(voxels log n + voxels on the boundary * faces near each)
base::Result<std::vector<Fill>> voxels_of(const Solid& solid, const VoxelGrid& grid, const VoxelOptions& options = {});
/// Of the full ones, and with the partial ones.
Bounds volume(const VoxelGrid& grid, std::span<const Fill> fills);

/// No solid.
constexpr std::uint32_t no_solid = 0xffffffffU;
/// Of each voxel the first solid that its middle lies in or on: a block model.
/// @error as voxels_of()  @cost O(voxels * solids whose boxes hold them * log n)
base::Result<std::vector<std::uint32_t>> block_model(std::span<const Solid> solids, const VoxelGrid& grid,
                                                     const VoxelOptions& options = {});

/// Sizes for a mesher: the edge of the leaf at a place, which is least at the boundary; outside of the box that of the
/// box. Refers to the tree.
std::function<double(geom::Point3)> sizes_by(const Octree& tree);
/// The same in the plane of a section.
std::function<double(geom::Point)> sizes_by(const Octree& tree, const SectionFrame& frame);

}  // namespace dobra::solid::partition
