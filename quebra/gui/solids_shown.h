#pragma once
// Solids in the window: the section that the plane in the picture makes, and what is clicked. Page:
// docs/user/space_view.md.

#include <functional>
#include <optional>

#include "shared/gui/window_part.h"

namespace quebra::gui {

/// The section of the last part by the plane of the picture. What is asked of one model again is prepared once.
std::function<std::optional<dobra::gui::SectionMade>(const dobra::gui::Desk&, const dobra::scene::space::CutPlane&)>
make_solid_section();

/// Says what the face is called that was clicked in the section.
void tell_face(const dobra::gui::Desk& desk, const dobra::gui::stage::ItemAt& item);

}  // namespace quebra::gui
