#pragma once
// Which states of the section the window shows: what the input is, what the steps have made, or both.

#include <set>

#include "shared/gui/documents/worker.h"
#include "shared/scene/pick.h"

namespace dobra::gui::documents {

enum class Shown { Input, Result, Both };

/// Whether input and result have panels of their own, or the input is a ghost in those of the result: its lines, faint,
/// over what the result fills and under its lines.
enum class Beside { Panels, Ghost };

/// Both: the input's panels come first, under keys of their own ("input.section"), unless a panel of the result shows
/// the input as it is. Without panels where there is nothing to draw.
/// With a ghost, both are shown whatever `shown` says of the result.
scene::Picture picture_of(const Outcome& outcome, Shown shown, Beside beside = Beside::Panels);

/// The line of the input that a line of a panel is: that of a ghost is called otherwise.
scene::Pick of_input(scene::Pick pick);

/// The lines and markers of a panel that stand there as in the input: those are edited. Those of a ghost are among
/// them.
std::set<scene::Pick> lines_of_input(const scene::Panel& panel, const Outcome& outcome);

}  // namespace dobra::gui::documents
