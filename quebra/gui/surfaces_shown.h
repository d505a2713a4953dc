#pragma once
// What tools and gestures on surfaces begin with, and charts that are asked for.

#include <optional>
#include <string>

#include "quebra/model/model.h"
#include "shared/gui/session.h"
#include "shared/gui/window_part.h"

namespace quebra::gui {

/// The model as the last run left it, where it has surfaces; else null. It lives as long as the session's outcome.
const model::Model* model_with_surfaces(const dobra::gui::Session& session);

/// The face that an item of the picture in space is of: a triangle, or an area.
std::optional<std::size_t> face_of(const model::Model& model, const dobra::scene::Pick& pick);

/// The key of the chart in which an item of space is drawn; empty: it is of no single face.
std::string chart_with(const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item);
/// The panel of that chart.
std::optional<dobra::scene::Panel> chart_panel(const dobra::gui::Desk& desk, const std::string& key);

}  // namespace quebra::gui
