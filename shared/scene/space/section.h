#pragma once
// The plane of a section as a person takes hold of it: its rim and an arrow along its normal in the picture. The arrow
// moves the plane along the normal, the rim turns it about its middle. Page: docs/user/space_view.md.

#include <optional>
#include <vector>

#include "shared/scene/space/cut.h"

namespace dobra::scene::space {

/// A plane by parts of the box of the picture, so that a picture of another size is cut alike.
struct Section {
  geom::Vector3 normal{1.0, 0.0, 0.0};  ///< Unit vector.
  double part = 0.5;                    ///< How far along the normal: 0 where the box begins, 1 where it ends.
  bool other_side = false;              ///< false: what lies on the side that the normal points to is taken away.
  friend bool operator==(const Section&, const Section&) = default;
};

/// A section square to an axis.
Section section_across(CutAxis axis, double part = 0.5, bool other_side = false);
/// The axis that a section is square to, whichever way its normal points; nothing: it is turned.
std::optional<CutAxis> axis_of(const Section& section);

/// @pre the box is not empty (alike below)
CutPlane plane_of(const Section& section, const geom::Box3& box);

/// Places along a normal, lengths from the origin: where the box begins and ends.
struct Reach {
  double from = 0.0;
  double to = 0.0;
};
Reach reach_along(const geom::Vector3& normal, const geom::Box3& box);
double place_of(const Section& section, const geom::Box3& box);
/// The section at that place, no farther than the box goes.
Section placed(Section section, const geom::Box3& box, double place);

/// What is taken hold of. World.
struct Handle {
  std::vector<geom::Point3> rim{};  ///< A closed line: the plane in the box, with some room where that is thin.
  geom::Point3 middle{};            ///< The arrow begins here
  geom::Point3 tip{};               ///< and ends on the side that is taken away.
  double exaggeration = 1.0;
};
Handle handle_of(const Section& section, const geom::Box3& box, double exaggeration);

enum class Grip { Arrow, Rim };
/// @param tolerance  page
std::optional<Grip> grip_at(const Handle& handle, const Sheet& sheet, geom::Point page, double tolerance);

/// From where a handle was taken hold of to where the hand is.
class SectionDrag {
 public:
  SectionDrag(const Section& begin, const geom::Box3& box, const Handle& handle, Grip grip, const Sheet& sheet,
              geom::Point page);
  [[nodiscard]] const Section& begin() const { return begin_; }
  [[nodiscard]] Grip grip() const { return grip_; }
  /// Of the arrow: so far that its place under the hand stays there; where it points at the viewer, upwards on the page
  /// is towards the viewer. Of the rim: its place follows the hand on a sphere about the middle. Normals within
  /// `square_within` of an axis become that of the axis.
  Section to(const Sheet& sheet, geom::Point page);

  static constexpr double square_within = 2.0;  ///< Degrees.

 private:
  [[nodiscard]] Section moved(const Sheet& sheet, geom::Point page) const;
  [[nodiscard]] Section turned(const Sheet& sheet, geom::Point page);

  Section begin_;
  geom::Box3 box_;
  Handle handle_;
  Grip grip_;
  geom::Point pressed_;
  geom::Vector off_{};       ///< From the hand to the place of the rim that it holds, page;
  geom::Vector3 arm_{};      ///< from the middle to that place, exaggerated;
  geom::Vector3 arm_now_{};  ///< the same where it is by now.
};

}  // namespace dobra::scene::space
