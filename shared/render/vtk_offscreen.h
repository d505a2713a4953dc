#pragma once
// Pictures drawn by VTK without a window and without an X server, through a surfaceless EGL context.

#include <filesystem>
#include <optional>

#include "shared/base/result.h"
#include "shared/scene/layout.h"

namespace dobra::render {

/// The picture as the window draws it, as a PNG file that is written whole or not at all.
/// @param page              by default suggested_page() of the picture's usual width.
/// @param pixels_per_point  2 is 144 dots an inch.
/// @error  CannotDraw if EGL or OpenGL 3.2 is not there, or the picture is larger than OpenGL can draw; CannotWrite.
base::Result<void> write_png_vtk(const scene::Picture& picture, const std::filesystem::path& path,
                                 const std::optional<scene::PageSize>& page = std::nullopt,
                                 double pixels_per_point = 2.0);

}  // namespace dobra::render
