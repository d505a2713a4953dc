#pragma once
// Pictures as files, drawn with cairo: to scale, without a display, the same bytes every time.
// SVG keeps its text as text; PDF embeds the font (DejaVu Sans); PNG is opaque on white.

#include <array>
#include <filesystem>
#include <optional>

#include "shared/base/result.h"
#include "shared/scene/layout.h"

namespace dobra::render {

/// Without a page, the picture takes suggested_page() of its usual_width(). A PDF on A4Landscape has pages of that
/// format, the tables on further ones where they are too long for the first.
/// Each writes the whole file or none.
/// @error  CannotWrite naming the file; CannotDraw if cairo fails or the picture would be too large for it.
/// @cost   O(points + triangles).
base::Result<void> write_svg(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page = std::nullopt);
base::Result<void> write_pdf(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page = std::nullopt);
/// @param pixels_per_point  2 is 144 dots an inch.
base::Result<void> write_png(const scene::Picture& picture, const std::filesystem::path& path,
                             const std::optional<scene::PageSize>& page = std::nullopt, double pixels_per_point = 2.0);

/// Of the files that write_picture makes.
inline constexpr std::array<const char*, 3> picture_endings = {".svg", ".pdf", ".png"};

/// As the extension of the path says: one of picture_endings.
/// @error  UnknownFormat for any other.
base::Result<void> write_picture(const scene::Picture& picture, const std::filesystem::path& path,
                                 const std::optional<scene::PageSize>& page = std::nullopt);

/// How large cairo draws text. Sizes do not depend on the kind of file.
scene::TextMeasure cairo_text_measure();

}  // namespace dobra::render
