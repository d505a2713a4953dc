#pragma once
// What tools and gestures on surfaces begin with.

#include "quebra/model/model.h"
#include "shared/gui/session.h"

namespace quebra::gui {

/// The model as the last run left it, where it has surfaces; else null. It lives as long as the session's outcome.
const model::Model* model_with_surfaces(const dobra::gui::Session& session);

}  // namespace quebra::gui
