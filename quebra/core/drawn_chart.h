#pragma once
// Charts as the picture of the plane shows them.

#include <optional>
#include <string>

#include "shared/geom/box.h"
#include "shared/scene/layer.h"
#include "shared/surf/surface.h"

namespace quebra::core {

/// Panels of so many charts stand beside each other; those of further faces are shown when they are asked for.
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

  /// What axes along u and v say at a length that is drawn: u and v as they are written.
  /// @param unit  what 1 of it is in the chart. @param name  of the unit; empty: there is none
  [[nodiscard]] dobra::scene::Reading u_reading(double unit, const std::string& name) const {
    return {title("u", name), low_.x / unit, 1.0 / (u_ * unit)};
  }
  [[nodiscard]] dobra::scene::Reading v_reading(double unit, const std::string& name) const {
    return {title("v", name), low_.y / unit, 1.0 / (v_ * unit)};
  }

 private:
  static std::string title(const char* axis, const std::string& name) {
    return name.empty() ? std::string(axis) : std::string(axis) + " [" + name + "]";
  }
  dobra::geom::Point low_;
  double u_ = 1.0, v_ = 1.0;
};

}  // namespace quebra::core
