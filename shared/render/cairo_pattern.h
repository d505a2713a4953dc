#pragma once
// The signs of rocks over coloured areas: lines and dots in one size on every page. Internal to render.

#include <cairo.h>

#include "shared/scene/layer.h"

namespace dobra::render {

/// Draws the signs over the current path, which stays, under the context's fill rule.
void fill_with_pattern(cairo_t* context, scene::Pattern pattern);

}  // namespace dobra::render
