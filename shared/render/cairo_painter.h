#pragma once
// Draws a laid-out picture on any cairo context. Internal to render: cairo.h is what callers use.

#include <cairo.h>

#include <filesystem>
#include <string>

#include "shared/base/result.h"
#include "shared/scene/layout.h"

namespace dobra::render {

enum class TextAs { Glyphs, NotDrawn };  ///< NotDrawn: the caller writes the text itself (SVG).

/// One page unit is one unit of the context. Errors stay in the context's status.
void paint(cairo_t* context, const scene::Picture& picture, const scene::Layout& layout, TextAs text);

/// Selects the font of a text; hinting is off, so that text has one size on every device.
void select_font(cairo_t* context, const scene::Font& font);

/// The error of a picture that could not be drawn.
base::Error cannot_draw(const std::filesystem::path& path, const std::string& why);

/// An image surface as a PNG file. @error CannotWrite, CannotDraw.
base::Result<void> write_png_surface(cairo_surface_t* surface, const std::filesystem::path& path);

}  // namespace dobra::render
