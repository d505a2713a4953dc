#pragma once
// A picture of line-work: a layer for each unit and horizon, whose pieces are features that say so (property piece_of,
// unit or formation) or are called so (K2p_1, K2p_2), each in its colour; and one for each other line.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/formats/line_files.h"
#include "shared/scene/unit_colors.h"

namespace dobra::cli {

scene::Picture line_picture(const io::formats::LineWork& work);

/// What the features are called, unit by unit and line by line: for remarks on a table of colours.
std::vector<std::string> drawn_names(const io::formats::LineWork& work);

struct LineDrawing {
  std::string title{};
  /// The n of 1:n: a metre of the section is 1/n m on the page, exactly. By default the sheet has its format and a
  /// round scale.
  std::optional<double> scale = std::nullopt;
  std::optional<scene::ColorTable> colors = std::nullopt;
  /// What stands over the left and the right end; by default the compass points of lines in space.
  std::optional<std::pair<std::string, std::string>> ends = std::nullopt;
};

/// Draws with cairo in the format of the ending: .svg, .pdf or .png.
/// @error BadUsage (ending); CannotDraw: the page would be larger than 20 m, with the scale to give; CannotWrite.
base::Result<void> draw_lines(const io::formats::LineWork& work, const std::filesystem::path& file,
                              const LineDrawing& drawing);

}  // namespace dobra::cli
