#pragma once
// What a picture is drawn on. Pictures are made for white paper; on a dark ground their lines and words keep their hue
// and change their lightness where they would not be seen. Fills, meshes with values and images stay as they are.

#include <vector>

#include "shared/scene/layer.h"
#include "shared/scene/marks.h"

namespace dobra::scene {

struct Ground {
  Color paper{255, 255, 255};
  friend bool operator==(const Ground&, const Ground&) = default;
};

/// Whether words on it are light.
bool is_dark(const Ground& ground);

/// That of WCAG 2, 1 .. 21; opacity is ignored.
double contrast(const Color& a, const Color& b);

constexpr double readable_contrast = 4.5;  ///< Of words, and of lines on a dark ground.

/// A colour of lines or markers as it is drawn on a ground: itself on a light one, and where its contrast is enough.
Color line_on(const Color& color, const Ground& ground);

/// The same of words, which are readable on the ground and on its colour laid over a white fill.
Color words_on(const Color& color, const Ground& ground);

/// The style of a layer: its lines and words.
Style style_on(const Layer& layer, const Ground& ground);

/// Marks of a layout: lines, words, and the light behind words.
Mark on_ground(Mark mark, const Ground& ground);

}  // namespace dobra::scene
