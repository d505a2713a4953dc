#pragma once
// Volume, area, centre and inertia of a solid, and where points lie. Integrals over the boundary by the divergence
// theorem, in numbers of 256 bits, rounded once. Source: [eberly2002polyhedral].

#include <array>
#include <memory>
#include <vector>

#include "shared/geom/point3.h"
#include "shared/solid/box_tree.h"
#include "shared/solid/solid.h"

namespace dobra::solid {

struct Measures {
  double volume = 0.0;              ///< m3, the exact number rounded to nearest.
  double area = 0.0;                ///< Of the boundary, m2.
  geom::Point3 centre;              ///< Of the volume; zero for the empty set.
  std::array<double, 6> inertia{};  ///< About the centre for density 1, m5: xx, yy, zz (the moments about the axes),
                                    ///< then xy, yz, zx (the products, minus the integral of xy and so on).
};

/// @cost O(n)
Measures measure(const Solid& solid);

/// The volume alone.  @cost O(n)
double volume(const Solid& solid);
/// Of what each shell bounds; negative for a shell round a cavity.
std::vector<double> shell_volumes(const Solid& solid);

enum class Location : std::uint8_t { Outside, Boundary, Inside };

/// Answers where points lie; exact.
class PointLocator {
 public:
  /// @cost O(n log n)
  explicit PointLocator(const Solid& solid);
  /// @pre finite  @cost O(log n + faces that a line along x meets)
  [[nodiscard]] Location locate(geom::Point3 p) const;

 private:
  Solid solid_;
  std::vector<BoxTree> trees_;
};

}  // namespace dobra::solid
