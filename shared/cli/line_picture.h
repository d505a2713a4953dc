#pragma once
// A picture of line-work: a layer for each feature, lines and polygons in the colours of their kinds.

#include <filesystem>
#include <optional>

#include "shared/io/line_files.h"
#include "shared/scene/layer.h"

namespace dobra::cli {

scene::Picture line_picture(const io::LineWork& work);

/// Draws with cairo in the format of the ending: .svg, .pdf or .png.
/// @param scale  the n of 1:n: a metre of the section is 1/n m on the page, exactly. By default the page has its usual
///               width.
/// @error BadUsage (ending); CannotDraw: the page would be larger than 20 m, with the scale to give; CannotWrite.
base::Result<void> draw_lines(const io::LineWork& work, const std::filesystem::path& file, std::optional<double> scale);

}  // namespace dobra::cli
