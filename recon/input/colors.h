#pragma once
// Colours that entries of the input say themselves: `colour`. Page: docs/user/restore.md.

#include <set>
#include <string>
#include <string_view>

#include "recon/input/section_input.h"
#include "shared/scenario/document.h"

namespace recon::input {

/// Puts them into the section's table of colours, where they go before what that says.
/// @error BadValue: what is no colour, with the entry.
base::Result<void> take_colors(const SectionInput& input, section::Section& section);

/// The horizons (as wholes) of `before` that `after` has no more; none where as many are left, as after a new name.
std::set<std::string> horizons_gone(const dobra::scenario::Document& before, const dobra::scenario::Document& after);

/// Horizons have the usual colours by their places: those behind one that is gone say the colour that they have had.
/// @param section  what the input made while they were there.
dobra::scenario::Document with_colors_kept(dobra::scenario::Document document, const section::Section& section,
                                           const std::set<std::string>& gone);

}  // namespace recon::input
