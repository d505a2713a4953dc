#pragma once
// Charts as the picture of the plane shows them.

#include <optional>
#include <string>

#include "shared/geom/box.h"
#include "shared/surf/surface.h"

namespace quebra::core {

/// Panels of so many charts stand beside each other; those of further faces are not shown.
inline constexpr std::size_t most_charts = 4;
/// Of the panel that shows the chart of a face: "chart_1" of face 0.
std::string chart_key(std::size_t face);
/// The other way; nothing: it is no panel of a chart.
std::optional<std::size_t> face_of_chart(const std::string& panel);

/// A chart stretched so that its middle lines are as long as in space: places of all charts can be drawn to one scale.
class DrawnChart {
 public:
  /// @cost two quadratures
  explicit DrawnChart(const dobra::surf::Surface& surface);
  [[nodiscard]] dobra::geom::Point at(dobra::geom::Point uv) const {
    return {u_ * (uv.x - low_.x), v_ * (uv.y - low_.y)};
  }
  /// The place in the chart of what is drawn at a point, m.
  [[nodiscard]] dobra::geom::Point chart(dobra::geom::Point drawn) const {
    return {low_.x + drawn.x / u_, low_.y + drawn.y / v_};
  }

 private:
  dobra::geom::Point low_;
  double u_ = 1.0, v_ = 1.0;
};

}  // namespace quebra::core
