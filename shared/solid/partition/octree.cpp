#include "shared/solid/partition/octree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/solid/measure.h"
#include "shared/solid/mesh_solid.h"

namespace dobra::solid::partition {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Vector3;

Point3 middle_of(const Box<3>& box) {
  return {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]), 0.5 * (box.low[2] + box.high[2])};
}

/// Triangles of a boundary, and whether they may pass through a box.
class Surface {
 public:
  static Result<Surface> of(const Solid& solid) {
    DOBRA_TRY(const ToMesh faces, to_mesh(solid, FacesAs::Triangles));
    Surface surface;
    surface.off_ = faces.displacement;
    for (const auto& face : faces.mesh.faces)
      surface.triangles_.push_back(
          {faces.mesh.points[face[0]], faces.mesh.points[face[1]], faces.mesh.points[face[2]]});
    for (const Point3 p : faces.mesh.points)
      surface.largest_ = std::max({surface.largest_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return surface;
  }

  [[nodiscard]] std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> numbers(triangles_.size());
    for (std::uint32_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    return numbers;
  }
  [[nodiscard]] const std::array<Point3, 3>& triangle(std::uint32_t t) const { return triangles_[t]; }
  [[nodiscard]] double off() const { return off_; }

  /// False only if the triangle surely has no point inside the open box: some axis separates them.
  [[nodiscard]] bool may_pass(std::uint32_t t, const Box<3>& box) const {
    const auto& [p, q, r] = triangles_[t];
    const std::array<std::array<double, 3>, 3> v{{{p.x, p.y, p.z}, {q.x, q.y, q.z}, {r.x, r.y, r.z}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({v[0][k], v[1][k], v[2][k]});
      if (high + off_ <= box.low[k] || low - off_ >= box.high[k]) return false;
    }
    const Point3 c = middle_of(box);
    const std::array<Vector3, 3> at{p - c, q - c, r - c};
    const std::array<Vector3, 3> edges{q - p, r - q, p - r};
    if (apart(cross(edges[0], edges[1]), at, box)) return false;
    for (const Vector3 e : edges) {
      if (apart({0, -e.z, e.y}, at, box) || apart({e.z, 0, -e.x}, at, box) || apart({-e.y, e.x, 0}, at, box))
        return false;
    }
    return true;
  }

 private:
  /// Whether box and triangle lie apart along an axis, by more than rounding can hide.
  [[nodiscard]] bool apart(Vector3 axis, const std::array<Vector3, 3>& at, const Box<3>& box) const {
    const std::array<double, 3> along{dot(axis, at[0]), dot(axis, at[1]), dot(axis, at[2])};
    const auto [low, high] = std::minmax({along[0], along[1], along[2]});
    const double weight = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
    if (weight == 0.0) return false;  // an edge along a coordinate axis
    const double reach =
        0.5 * (std::abs(axis.x) * (box.high[0] - box.low[0]) + std::abs(axis.y) * (box.high[1] - box.low[1]) +
               std::abs(axis.z) * (box.high[2] - box.low[2]));
    constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
    const double hidden = weight * (off_ + rounding * largest_);
    return low >= reach + hidden || high <= -reach - hidden;
  }

  std::vector<std::array<Point3, 3>> triangles_;
  double off_ = 0.0;      // how far corners were rounded
  double largest_ = 0.0;  // of all coordinates
};

Fill fill_at(const PointLocator& locator, Point3 p) {
  return locator.locate(p) == Location::Outside ? Fill::Empty : Fill::Full;
}

/// Goes down with the triangles that are near.
class Builder {
 public:
  Builder(const Surface& surface, const PointLocator& locator) : surface_(surface), locator_(locator) {
    near_.push_back({{}, surface.all()});
  }

  Fill operator()(const Box<3>& box) {
    while (near_.size() > 1 && !holds(near_.back().box, box)) near_.pop_back();
    std::vector<std::uint32_t> inside;
    for (const std::uint32_t t : near_.back().triangles) {
      if (surface_.may_pass(t, box)) inside.push_back(t);
    }
    if (inside.empty()) return fill_at(locator_, middle_of(box));
    near_.push_back({box, std::move(inside)});
    return Fill::Partial;
  }

 private:
  struct Near {
    Box<3> box;
    std::vector<std::uint32_t> triangles;
  };
  static bool holds(const Box<3>& outer, const Box<3>& inner) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (inner.low[k] < outer.low[k] || inner.high[k] > outer.high[k]) return false;
    }
    return !(outer == inner);
  }

  const Surface& surface_;
  const PointLocator& locator_;
  std::vector<Near> near_;  // of the boxes on the way down
};

Result<void> check_grid(const VoxelGrid& grid, const VoxelOptions& options) {
  const Vector3 s = grid.size;
  if (!is_finite(grid.origin) || !is_finite(s) || !(s.x > 0.0) || !(s.y > 0.0) || !(s.z > 0.0))
    return Error{ErrorCode::InvalidOption, "voxels need a finite origin, and sizes above 0"};
  double count = 1.0;
  for (const std::uint32_t n : grid.counts) count *= n;
  if (count == 0.0) return Error{ErrorCode::InvalidOption, "voxels need a count of 1 or more along each axis"};
  if (count > static_cast<double>(options.most)) {
    return Error{ErrorCode::TooManyElements,
                 fmt::format("{:.0f} voxels are too many (at most {}): make them larger", count, options.most)};
  }
  return {};
}

}  // namespace

Box<3> cube_round(std::span<const Solid> solids) {
  Box3 all;
  for (const Solid& solid : solids) {
    for (const PointId p : solid.boundary().soup.corners) all.include(solid.space(), p);
  }
  double edge = 0.0;
  for (std::size_t k = 0; k < 3; ++k) edge = std::max(edge, all.high[k] - all.low[k]);
  Box<3> cube;
  for (std::size_t k = 0; k < 3; ++k) {
    cube.low[k] = all.low[k];
    cube.high[k] = std::max(all.low[k] + edge, all.high[k]);
  }
  return cube;
}

Result<Octree> octree_of(const Solid& solid, const Box<3>& box, int depth) {
  if (depth < 0 || depth > 12)
    return Error{ErrorCode::InvalidOption, fmt::format("the depth of an octree is 0 to 12, not {}", depth)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(box.high[k] > box.low[k]) || !std::isfinite(box.high[k] - box.low[k]))
      return Error{ErrorCode::InvalidOption, "the box of an octree has no volume"};
  }
  if (solid.empty()) return Octree(box);
  DOBRA_TRY(const Surface surface, Surface::of(solid));
  const PointLocator locator(solid);
  return Octree::from_top(box, depth, Builder(surface, locator));
}

Clash clash(const Octree& a, const Octree& b) {
  const Octree common = combine(a, b, SetOperation::Intersection);
  if (common.count(Fill::Full) > 0) return Clash::Sure;
  return common.count(Fill::Partial) > 0 ? Clash::Maybe : Clash::None;
}

Box<3> VoxelGrid::box(std::size_t voxel) const {
  const std::array<std::size_t, 3> at{voxel % counts[0], voxel / counts[0] % counts[1],
                                      voxel / (std::size_t{counts[0]} * counts[1])};
  const std::array<double, 3> from{origin.x, origin.y, origin.z};
  const std::array<double, 3> edge{size.x, size.y, size.z};
  Box<3> box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = from[k] + static_cast<double>(at[k]) * edge[k];
    box.high[k] = from[k] + static_cast<double>(at[k] + 1) * edge[k];
  }
  return box;
}

Point3 VoxelGrid::middle(std::size_t voxel) const { return middle_of(box(voxel)); }

Result<std::vector<Fill>> voxels_of(const Solid& solid, const VoxelGrid& grid, const VoxelOptions& options) {
  DOBRA_TRY_VOID(check_grid(grid, options));
  std::vector<Fill> fills(grid.count(), Fill::Empty);
  if (solid.empty()) return fills;
  DOBRA_TRY(const Surface surface, Surface::of(solid));
  const std::array<double, 3> from{grid.origin.x, grid.origin.y, grid.origin.z};
  const std::array<double, 3> edge{grid.size.x, grid.size.y, grid.size.z};
  for (const std::uint32_t t : surface.all()) {
    const auto& [p, q, r] = surface.triangle(t);
    const std::array<std::array<double, 3>, 3> v{{{p.x, p.y, p.z}, {q.x, q.y, q.z}, {r.x, r.y, r.z}}};
    std::array<std::size_t, 3> first{};
    std::array<std::size_t, 3> end{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({v[0][k], v[1][k], v[2][k]});
      // One more on both sides, for what rounding hides; may_pass() decides.
      const double n = grid.counts[k];
      first[k] =
          static_cast<std::size_t>(std::clamp(std::floor((low - surface.off() - from[k]) / edge[k]) - 1.0, 0.0, n));
      end[k] =
          static_cast<std::size_t>(std::clamp(std::floor((high + surface.off() - from[k]) / edge[k]) + 2.0, 0.0, n));
    }
    for (std::size_t z = first[2]; z < end[2]; ++z) {
      for (std::size_t y = first[1]; y < end[1]; ++y) {
        for (std::size_t x = first[0]; x < end[0]; ++x) {
          const std::size_t voxel = (z * grid.counts[1] + y) * grid.counts[0] + x;
          if (fills[voxel] == Fill::Empty && surface.may_pass(t, grid.box(voxel))) fills[voxel] = Fill::Partial;
        }
      }
    }
  }
  const PointLocator locator(solid);
  for (std::size_t voxel = 0; voxel < fills.size(); ++voxel) {
    if (fills[voxel] == Fill::Empty) fills[voxel] = fill_at(locator, grid.middle(voxel));
  }
  return fills;
}

Bounds volume(const VoxelGrid& grid, std::span<const Fill> fills) {
  const double one = grid.size.x * grid.size.y * grid.size.z;
  const auto count = [&](Fill fill) { return static_cast<double>(std::count(fills.begin(), fills.end(), fill)); };
  return {one * count(Fill::Full), one * (count(Fill::Full) + count(Fill::Partial))};
}

Result<std::vector<std::uint32_t>> block_model(std::span<const Solid> solids, const VoxelGrid& grid,
                                               const VoxelOptions& options) {
  DOBRA_TRY_VOID(check_grid(grid, options));
  std::vector<PointLocator> locators;
  std::vector<Box3> boxes;
  for (const Solid& solid : solids) {
    locators.emplace_back(solid);
    Box3& box = boxes.emplace_back();
    for (const PointId p : solid.boundary().soup.corners) box.include(solid.space(), p);
  }
  std::vector<std::uint32_t> model(grid.count(), no_solid);
  for (std::size_t voxel = 0; voxel < model.size(); ++voxel) {
    const Point3 p = grid.middle(voxel);
    const Box3 at{{p.x, p.y, p.z}, {p.x, p.y, p.z}};
    for (std::uint32_t i = 0; i < solids.size() && model[voxel] == no_solid; ++i) {
      if (boxes[i].overlaps(at) && locators[i].locate(p) != Location::Outside) model[voxel] = i;
    }
  }
  return model;
}

std::function<double(Point3)> sizes_by(const Octree& tree) {
  const double whole = tree.box().high[0] - tree.box().low[0];
  return [&tree, whole](Point3 p) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(at[k] >= tree.box().low[k] && at[k] <= tree.box().high[k])) return whole;
    }
    return std::ldexp(whole, -tree.level(tree.leaf_at(at)));
  };
}

std::function<double(geom::Point)> sizes_by(const Octree& tree, const SectionFrame& frame) {
  return [in_space = sizes_by(tree), frame](geom::Point p) { return in_space(frame.in_space(p)); };
}

}  // namespace dobra::solid::partition
