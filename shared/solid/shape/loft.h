#pragma once
// Solids between plane sections: every region of a section is joined to the region that stands for it in the next.
// Sections agree if their lines, with names and sides, hang together in the same way; the order of lines and their
// numbers of points do not matter. Each line becomes one band of triangles between two sections, so that parts on its
// two sides meet in the same triangles. The surface of one line through many sections is surf/loft/loft.h. Page:
// docs/algorithms/section_loft.md. Source: [fuchs1977surface] (bands
// between contours); how sections are matched is ours.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/solid/cap.h"
#include "shared/solid/placement.h"
#include "shared/solid/shape/profile.h"

namespace dobra::solid::shape {

/// A line of a section. Lines meet in their ends alone, and these are equal there. A line that is cut into pieces where
/// nothing else ends counts as one; a line with an end where nothing else ends bounds nothing and is left out.
struct LoftLine {
  geom::Polyline line;      ///< In the section's frame; closed where it is an island.
  std::string name;         ///< Of the faces that come of it.
  std::string left, right;  ///< The regions on its sides as one looks along it; empty for outside.
};

struct LoftSection {
  SectionFrame frame;  ///< All sections are looked at from the same side.
  std::vector<LoftLine> lines;
};

/// The section of solids by a plane as a section to loft between.
/// @param names  of the solids.  @pre one for each
LoftSection loft_section(const Cap& cap, std::span<const std::string> names);

/// What becomes of one connected region.
struct LoftPart {
  std::string name;  ///< Of the region; several parts may have one.
  Shape shape;       ///< Triangles named by the lines, and the ends; solid_of() makes it a solid.
};

struct LoftOptions {
  std::string start = "start";  ///< Name of the faces in the first section.
  std::string end = "end";      ///< In the last.
};

/// The parts in the order in which the first section's lines name their regions.
/// @error DegenerateCurve: a line without length or with a point twice in a row; NotFinite. InvalidOption with the
///        place: less than two sections; a line whose sides disagree with its neighbour's; sections that cross, are
///        looked at from opposite sides, or are turned against each other by a right angle or more; sections with
///        different units or orders of them.
/// @cost  O(n log n + m k) for m lines in k places that look alike
base::Result<std::vector<LoftPart>> loft_sections(std::span<const LoftSection> sections,
                                                  const LoftOptions& options = {});

/// A profile and where its plane z = 0 stands.
struct PlacedProfile {
  Profile profile;
  Matrix place = identity;
};

/// A solid over two profiles or more, each in front of the one before. First corners are joined to first corners,
/// anticlockwise; if numbers of corners are equal each to its own, else by lengths along the contours. Faces are called
/// start, end, side_1 ... (side where numbers differ), hole_1 ...
/// @error those of extrude(); InvalidOption: less than two profiles, numbers of holes that differ, profiles whose
///        planes cross within the solid, or that are turned by half a turn, with the place.
base::Result<Shape> loft(std::span<const PlacedProfile> profiles, SideNames names = SideNames::Each);

}  // namespace dobra::solid::shape
