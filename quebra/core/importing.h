#pragma once
// A file brought into a document in the window: what a look at it shows, and the edit of the document.
// Page: docs/user/import.md.

#include "shared/scenario/importing.h"

namespace quebra::core {

/// A file becomes the document's `file`; where it has one already, or names clash, the curves become points of the
/// document.
dobra::scenario::Importing importing();

}  // namespace quebra::core
