#pragma once
// Pictures in space as files. SVG, PDF and PNG of cairo come from the display list, with its limit on what hides what
// (shared/scene/space/display.h); a PNG of VTK has a depth buffer, and the speed for a million triangles.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/scene/ground.h"
#include "shared/scene/space/layout.h"

namespace dobra::render {

struct SpaceFileOptions {
  std::optional<scene::PageSize> page = std::nullopt;         ///< By default suggested_page().
  std::optional<scene::space::Camera> camera = std::nullopt;  ///< By default the picture's.
  scene::Ground ground{};
  double pixels_per_point = 2.0;  ///< Of PNG; 2 is 144 dots an inch.
};

/// As the extension of the path says, one of picture_endings, with cairo. The whole file or none.
/// @error  UnknownFormat; CannotWrite naming the file; CannotDraw if cairo fails or the picture would be too large.
/// @cost   O(n log n), n triangles
base::Result<void> write_picture(const scene::space::SpacePicture& picture, const std::filesystem::path& path,
                                 const SpaceFileOptions& options = {});

/// One picture from several sides, side by side in so many columns, each with its title, without legends; with cairo.
struct NamedView {
  std::string title;
  scene::space::Camera camera;
};
/// @param options  its page is that of one view, its camera is not used.
/// @error as write_picture. @pre columns > 0, there is a view
base::Result<void> write_views(const scene::space::SpacePicture& picture, const std::vector<NamedView>& views,
                               std::size_t columns, const std::filesystem::path& path,
                               const SpaceFileOptions& options = {});

/// As the window draws it. @error as write_png_vtk of a planar picture
base::Result<void> write_png_vtk(const scene::space::SpacePicture& picture, const std::filesystem::path& path,
                                 const SpaceFileOptions& options = {});

}  // namespace dobra::render
