#pragma once
// Sections in space and surfaces through them in pictures. Page: docs/user/space.md.

#include "recon/model/model.h"
#include "recon/space/cut.h"
#include "shared/scene/space/picture.h"

namespace recon::core {

/// In the plane: a panel for each section of the document, from the first.
void draw_placed(const model::Model& model, dobra::scene::Picture& picture);

/// In space: the sections as curtains on their traces, the surfaces, and the sections cut from them.
void draw_placed_in_space(const model::Model& model, dobra::scene::space::SpacePicture& picture);

}  // namespace recon::core
