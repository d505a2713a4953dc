#pragma once
// Whether the steps of a document can be a tree of parts.

#include "shared/scenario/document.h"

namespace quebra::solids {

/// @error BadValue with file and line of the step: parts that are made of themselves, in however many steps
/// (recursion),
///        or of a part that only a later step makes.
dobra::base::Result<void> check_tree(const dobra::scenario::Document& document);

}  // namespace quebra::solids
