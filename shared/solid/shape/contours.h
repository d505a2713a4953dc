#pragma once
// What sweeps have in common: contours that run the right way, with the names of their sides, and the collector of
// points and faces. Page: docs/algorithms/sweeps.md.

#include <algorithm>
#include <string>
#include <vector>

#include "shared/solid/shape/profile.h"

namespace dobra::solid::shape {

using Ring = std::vector<std::uint32_t>;
using Rings = std::vector<Ring>;  ///< One a contour.

inline base::Place at_point(geom::Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }
inline geom::Point3 flat(geom::Point p) { return {p.x, p.y, 0.0}; }

/// A contour, anticlockwise, or clockwise for a hole, with the name of the side that leaves each corner.
struct Contour {
  std::vector<geom::Point> points;
  std::vector<std::string> names;
};

/// Where sides of one contour may meet but for neighbours in their corner.
enum class Touching { No, InPoints };

/// Errors have their place in the plane of the contour: x and y.  @error DegenerateCurve, NotFinite, SelfIntersection
/// @cost O(n log n + pairs near each other)
base::Result<void> check_contour(const geom::Polyline& line, const char* what, Touching touching = Touching::No);
/// @pre it passed check_contour()
Contour turned_contour(const geom::Polyline& line, bool hole, SideNames names, const std::string& stem);
/// The outline, then the holes.  @error those of check_contour(); SelfIntersection: holes that meet each other or the
/// outline but in corners, or lie outside of it or within each other.
base::Result<std::vector<Contour>> contours_of(const Profile& profile, SideNames names);

/// The error with its place in the plane of a contour put where that is in space.
template <class Place>
base::Error put_in_space(base::Error error, Place&& place) {
  if (error.place && error.place->x && error.place->y)
    error.place = at_point(place(geom::Point{*error.place->x, *error.place->y}));
  return error;
}

/// Collects the points and faces of a shape; `mirrored` turns all faces over.
class Maker {
 public:
  explicit Maker(bool mirrored = false) : mirrored_(mirrored) {}

  std::uint32_t point(geom::Point3 p) {
    shape_.mesh.points.push_back(p);
    return static_cast<std::uint32_t>(shape_.mesh.points.size() - 1);
  }
  void face(std::vector<Ring> loops, std::string name) {
    if (mirrored_) {
      for (Ring& loop : loops) std::reverse(loop.begin(), loop.end());
    }
    shape_.mesh.faces.push_back(std::move(loops));
    shape_.names.push_back(std::move(name));
  }
  [[nodiscard]] const std::vector<geom::Point3>& points() const { return shape_.mesh.points; }
  Shape take() { return std::move(shape_); }

 private:
  Shape shape_;
  bool mirrored_;
};

template <class Place>
Rings rings_at(Maker& maker, const std::vector<Contour>& contours, Place&& place) {
  Rings rings;
  for (const Contour& contour : contours) {
    Ring& ring = rings.emplace_back();
    for (const geom::Point p : contour.points) ring.push_back(maker.point(place(p)));
  }
  return rings;
}

/// @error InvalidOption: corners of a contour fall together where its ring stands, as coordinates are rounded there.
base::Result<void> check_apart(const Maker& maker, const Rings& rings);

inline Rings reversed(Rings rings) {
  for (Ring& ring : rings) std::reverse(ring.begin(), ring.end());
  return rings;
}

}  // namespace dobra::solid::shape
