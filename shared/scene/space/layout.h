#pragma once
// A picture in space on a page: one plot with a title, legend, colour bars, tables and notes as the plane has them
// (../layout.h), three labelled edges of the box of the picture, the directions of the axes in a corner, and labels
// that neither overlap nor are cut off.

#include <optional>

#include "shared/scene/layout.h"
#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

/// How a picture is looked at.
struct Look {
  Camera camera{};
  std::optional<View> view = std::nullopt;  ///< What of the plane of the page is shown; by default all.
};

struct SpaceLayout {
  Layout page{};  ///< One panel; the marks round and over the picture, without the picture.
  Sheet sheet{};  ///< Where points of space come to stand.
  View view{};    ///< What the plot shows.
};

/// @param page   as in scene::layout
/// @param shown  extent(picture), which takes a walk over all points.
/// @cost  O(layers + labels)
SpaceLayout layout(const SpacePicture& picture, const geom::Box3& shown, const Look& look, const PageSize& page,
                   const TextMeasure& measure, const LayoutOptions& options = {});

/// The page that a file of the picture takes if nobody asks for another.
PageSize suggested_page(const SpacePicture& picture, const geom::Box3& shown, const Look& look,
                        const TextMeasure& measure);

}  // namespace dobra::scene::space
