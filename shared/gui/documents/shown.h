#pragma once
// Which states of the section the window shows: what the input is, what the steps have made, or both.

#include <set>

#include "shared/gui/documents/worker.h"
#include "shared/scene/pick.h"

namespace dobra::gui::documents {

enum class Shown { Input, Result, Both };

/// Both: the input's panels come first, under keys of their own ("input.section"), unless a panel of the result shows
/// the input as it is. Without panels where there is nothing to draw.
scene::Picture picture_of(const Outcome& outcome, Shown shown);

/// The lines and markers of a panel that stand there as in the input: those are edited.
std::set<scene::Pick> lines_of_input(const scene::Panel& panel, const Outcome& outcome);

}  // namespace dobra::gui::documents
