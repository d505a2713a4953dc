#pragma once
// Draws a laid-out picture on any cairo context. Internal to render: cairo.h is what callers use.

#include <cairo.h>

#include <filesystem>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scene/layout.h"

namespace dobra::render {

enum class TextAs { Glyphs, NotDrawn };  ///< NotDrawn: the caller writes the text itself (SVG).

/// One page unit is one unit of the context. Errors stay in the context's status.
void paint(cairo_t* context, const scene::Picture& picture, const scene::Layout& layout, TextAs text,
           const scene::Color& paper = {255, 255, 255});

/// What a file shows: the layers of a picture and the marks of its first page, then the marks of further pages.
struct Drawn {
  const scene::Picture& picture;
  std::vector<scene::Layout> pages;
  scene::Color paper{255, 255, 255};
};
/// @error as those of cairo.h. SVG and PNG have the first page.
base::Result<void> write_svg(const Drawn& drawn, const std::filesystem::path& path);
base::Result<void> write_pdf(const Drawn& drawn, const std::filesystem::path& path);
base::Result<void> write_png(const Drawn& drawn, const std::filesystem::path& path, double pixels_per_point);

/// UnknownFormat, with the endings that there are.
base::Error not_a_picture(const std::filesystem::path& path);

/// Selects the font of a text; hinting is off, so that text has one size on every device.
void select_font(cairo_t* context, const scene::Font& font);

/// The error of a picture that could not be drawn.
base::Error cannot_draw(const std::filesystem::path& path, const std::string& why);

/// An image surface as a PNG file. @error CannotWrite, CannotDraw.
base::Result<void> write_png_surface(cairo_surface_t* surface, const std::filesystem::path& path);

}  // namespace dobra::render
