#pragma once
// What no method can take for granted of a section, asked before one is restored or balanced: an error with the place,
// and where going on has a meaning, the option that says so.

#include "recon/section/section.h"
#include "shared/base/result.h"

namespace recon::section {

/// What a step does about horizons that cross each other.
enum class Crossings { Refuse, Allow };
/// Help of the choice in a step's parameters.
inline constexpr const char* crossings_help =
    "refuse: an error with the place; allow: every point goes by the grid all the same, and the units by their faces.";

/// Both of what follows; the section gets its faces, if it has none.
base::Result<void> check_section(Section& section, Crossings crossings);

/// @error BadSection where horizons pass to the other side of each other: the first place and up to ten pairs.
base::Result<void> refuse_crossings(const Section& section, const SectionFaces& faces);

/// @error BadSection: a pin or loose line that lies beside all horizons, with its place.
base::Result<void> refuse_lines_outside(const Section& section);

}  // namespace recon::section
