#pragma once
// Sheets of paper and their scales. Internal to scene.

#include <string>

namespace dobra::scene {

constexpr double points_per_metre = 72.0 / 0.0254;

/// Of A4Landscape for this width.
double paper_height(double width);

/// "1:25 000" for a world in metres, or "5:1" of what is drawn larger than it is.
/// @param scale  points a world unit.
std::string ratio_text(double scale);

}  // namespace dobra::scene
