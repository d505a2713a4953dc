#pragma once
// Faces that hang together but are turned against each other: which of them are to be turned. One rule for all who ask,
// the check of polygons and the sheets of a file. Page: docs/algorithms/polygon_mesh.md.

#include <cstdint>
#include <span>

#include "shared/mesh/polygon_mesh.h"

namespace dobra::mesh {

/// Faces that are turned alike, weighed.
class TurnedAlike {
 public:
  /// @param origin  of the volume: one place for all faces of a piece
  explicit TurnedAlike(geom::Point3 origin) : origin_(origin) {}
  /// @pre corners exist
  void add(const std::vector<geom::Point3>& points, std::span<const std::uint32_t> face);

  /// The others are to be turned the way of these. The many count, in triangles that the faces can be cut into; of as
  /// many the greater area; of the same area the way that makes a closed piece bound a volume above nought. Where all
  /// that is equal these stay.
  [[nodiscard]] bool stays_before(const TurnedAlike& others, bool closed) const;

 private:
  geom::Point3 origin_;
  std::size_t triangles_ = 0;
  double area_ = 0.0;
  double volume_ = 0.0;  ///< Six times that between the faces and the origin.
};

}  // namespace dobra::mesh
