#pragma once
// Where a panel looks and how near, and the map between the world and the page that follows. Page coordinates are
// points (1/72 inch) on paper, device-independent pixels on a screen: x to the right, y DOWN from the upper left
// corner.

#include "shared/geom/box.h"

namespace dobra::scene {

/// What stands in the middle of a plot, and the length in world units of one page unit along x.
struct View {
  geom::Point centre;
  double world_per_point = 1.0;
  friend bool operator==(const View&, const View&) = default;
};

/// World to page and back, for one plot.
struct Transform {
  geom::Point world_centre;
  geom::Point page_centre;
  double points_per_x = 1.0;  ///< Points a world unit along x.
  double points_per_y = 1.0;  ///< Points a world unit along y: points_per_x times the vertical exaggeration.

  [[nodiscard]] geom::Point to_page(geom::Point world) const {
    return {page_centre.x + (world.x - world_centre.x) * points_per_x,
            page_centre.y - (world.y - world_centre.y) * points_per_y};
  }
  [[nodiscard]] geom::Point to_world(geom::Point page) const {
    return {world_centre.x + (page.x - page_centre.x) / points_per_x,
            world_centre.y - (page.y - page_centre.y) / points_per_y};
  }
  /// The world box that a page box shows.
  [[nodiscard]] geom::Box to_world(const geom::Box& page) const {
    geom::Box box;
    box.add(to_world(page.low));
    box.add(to_world(page.high));
    return box;
  }
};

/// The transform of a view on a plot (page box).
Transform transform_of(const View& view, const geom::Box& plot, double vertical_exaggeration = 1.0);

/// `extent` with room round it, and never without width or height: what a fitted view shows.
geom::Box comfortable(const geom::Box& extent);

/// The view that shows all of `box` in a plot of the given size, points. @pre box is not empty, sizes > 0.
View fit(const geom::Box& box, double width, double height, double vertical_exaggeration = 1.0);

/// `factor` times nearer (farther below 1), the world point under the cursor staying where it is.  @pre factor > 0.
View zoom_at(const View& view, geom::Point cursor_world, double factor);

/// The view after the content was dragged by `by` points on the page (y down).
View pan(const View& view, geom::Vector by, double vertical_exaggeration = 1.0);

}  // namespace dobra::scene
