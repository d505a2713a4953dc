#pragma once
// The lines on a patch along which a linear function is zero. Page: docs/algorithms/loft.md.

#include <vector>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// normal . p - offset.
struct Linear {
  geom::Vector3 normal;
  double offset = 0.0;
  [[nodiscard]] double at(geom::Point3 p) const { return geom::dot(normal, p - geom::Point3{}) - offset; }
};

/// On which border of the chart a line ends.
enum class PatchEnd : std::uint8_t { Inside, Low, High };

struct LevelLine {
  std::vector<geom::Point3> points;  ///< A closed one repeats its first point.
  PatchEnd first = PatchEnd::Inside, last = PatchEnd::Inside;
};

struct LevelSet {
  std::vector<LevelLine> lines;
  std::size_t flat = 0;  ///< Triangles on which it is zero all over.
  geom::Point3 flat_at;  ///< A corner of the first.
};

/// Vertices at which it is less than `zero` from 0 count as 0, and lie on the lines as they are; others are found on
/// the surface between the ends of a side. @cost O(triangles)
LevelSet level_set(const Patch& patch, const Linear& function, double zero);

}  // namespace dobra::surf::loft
