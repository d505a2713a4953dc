#pragma once
// Solids cut by a plane: the section as a planar subdivision, and the two parts as solids. Page:
// docs/algorithms/boolean.md. Source: [mantyla1988solid] for the operation; the way is ours.

#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/solid/boolean.h"
#include "shared/solid/box_tree.h"
#include "shared/solid/solid.h"
#include "shared/topo/subdivision.h"

namespace dobra::solid {

/// a x + b y + c z + d = 0; the upper side is where the left-hand side is positive.
struct CutPlane {
  double a = 0.0, b = 0.0, c = 1.0, d = 0.0;
};

/// Axes of a plane as seen from its upper side: along is horizontal to the right, up is upwards, or to the north in a
/// horizontal plane. The origin is the point of the plane nearest to that of space.
struct SectionFrame {
  geom::Point3 origin;
  geom::Vector3 along, up;
  [[nodiscard]] geom::Point in_plane(geom::Point3 p) const { return {dot(p - origin, along), dot(p - origin, up)}; }
  [[nodiscard]] geom::Point3 in_space(geom::Point p) const { return origin + p.x * along + p.y * up; }
};
/// @error InvalidOption if a, b and c are all zero or something is not finite.
base::Result<SectionFrame> frame_of(const CutPlane& plane);

/// Attribute of a face of the subdivision that is cut out of a solid.
struct SectionArea {
  std::uint32_t solid;  ///< Its index; the first, where solids overlap.
};
/// Attribute of an edge: the names of the solids' faces that were cut there, sorted, each once.
struct SectionLine {
  std::vector<std::string> names;
};

/// Two solids that cover the same of the plane; the section shows the first.
struct SectionOverlap {
  std::uint32_t first, second;  ///< Their indices.
  double area = 0.0;            ///< m2.
  geom::Point at;               ///< A corner of it.
};

struct Section {
  SectionFrame frame;
  std::vector<SectionOverlap> overlaps;  ///< One for each pair, but for slivers of 1e-12 of the diagonal squared.
  topo::Subdivision plane;  ///< Places rounded to doubles; faces without SectionArea are outside all solids.
  /// No solid is cut.
  [[nodiscard]] bool empty() const { return plane.edge_count() == 0; }
};

/// Cuts the same solids by many planes.
class Sections {
 public:
  /// @cost O(n log n)
  explicit Sections(std::span<const Solid> solids);
  /// Where a plane lies in a face, the section is that of the solid just below the plane.
  /// @error InvalidOption as above.  @cost O(log n + k log k) for k faces that are cut
  [[nodiscard]] base::Result<Section> cut(const CutPlane& plane) const;

 private:
  struct Line;
  [[nodiscard]] std::vector<Line> collect(std::uint32_t solid, const CutPlane& plane, const SectionFrame& frame) const;

  std::vector<Solid> solids_;
  std::vector<BoxTree> trees_;
};

struct Halves {
  Solid below, above;
  Contact contact = Contact::Nothing;  ///< Of the plane with the solid; Face too where it only touches a face.
};

/// Both parts as solids, exact: the corners of the cap are implicit. Either may be empty.
/// @param cap  name of the faces that the cut makes.
/// @error InvalidOption as above.  @cost that of combine()
base::Result<Halves> halve(const Solid& solid, const CutPlane& plane, const std::string& cap = "cut");

}  // namespace dobra::solid
