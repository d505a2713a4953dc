#pragma once
// A file brought into a document in the window: what a look at it shows, and the edit of the document.
// Page: docs/user/import.md.

#include "shared/scenario/importing.h"

namespace recon::input {

/// Files of lines become one [[input.lines]], or a table a line where some are left out or called otherwise; a picture
/// becomes a [[input.backdrop]].
dobra::scenario::Importing importing();

}  // namespace recon::input
