#pragma once
// The lines of a section carried along strike, as surfaces, and where a plane cuts them. Which side of the plane a
// point is on is decided exactly, so cut lines hang together whatever is rounded. Page:
// docs/algorithms/section_block.md.

#include <cstdint>
#include <optional>
#include <vector>

#include "shared/geom/point3.h"
#include "shared/solid/section.h"

namespace recon {
namespace geom = dobra::geom;
}

namespace recon::block {

/// What of the section a sheet or rail comes from: an index into the list of that name.
enum class Origin : std::uint8_t { Horizon, Line, Unit, Border, Marker, BlockName };

struct Sheet {
  Origin origin = Origin::Horizon;
  std::size_t index = 0;
  bool closed = false;
  /// The line in its places along strike, two or more, with as many points each.
  std::vector<std::vector<geom::Point3>> stations;
};

/// The way of a point.
struct Rail {
  Origin origin = Origin::Marker;
  std::size_t index = 0;
  geom::Point3 from, to;
};

/// Which side of a plane points are on. Exact; a point of the plane counts as above it.
class PlaneSide {
 public:
  explicit PlaneSide(const dobra::solid::CutPlane& plane) : plane_(plane) {}
  [[nodiscard]] bool above(geom::Point3 p) const;
  /// Where the plane meets the way between two points that are on different sides; an end that lies in it is that
  /// place.
  [[nodiscard]] geom::Point3 meet(geom::Point3 a, geom::Point3 b) const;

 private:
  [[nodiscard]] double rough(geom::Point3 p) const {
    return plane_.a * p.x + plane_.b * p.y + plane_.c * p.z + plane_.d;
  }
  [[nodiscard]] int sign(geom::Point3 p) const;
  dobra::solid::CutPlane plane_;
};

/// A line in which a sheet is cut, in order along it. Of a closed sheet it is a loop: where it leaves the block, it
/// goes along the block's end.
struct SheetCut {
  std::vector<geom::Point3> points;
  bool closed = false;
};
/// A plane that lies in the sheet cuts nothing.  @cost O(n)
std::vector<SheetCut> cut_sheet(const Sheet& sheet, const PlaneSide& plane);
std::optional<geom::Point3> cut_rail(const Rail& rail, const PlaneSide& plane);

}  // namespace recon::block
