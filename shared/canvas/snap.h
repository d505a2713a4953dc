#pragma once
// What a cursor is drawn to: the place that a user means who points near a vertex, a crossing, a line. No Qt, no
// drawer. Page: docs/user/canvas.md.

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shared/geom/spatial_index.h"
#include "shared/scene/layer.h"
#include "shared/scene/pick.h"

namespace dobra::canvas {

/// In the order in which they win. Perpendicular: where the way from the last place meets a line at a right angle, or
/// leaves the line on which it starts at one.
enum class SnapKind { Vertex, Intersection, OnLine, Perpendicular, Grid, Angle };

/// "vertex", "intersection", ...: English source of what stands beside the mark, translated.
std::string snap_name(SnapKind kind);

struct Snap {
  SnapKind kind = SnapKind::Vertex;
  geom::Point at;
  std::optional<scene::Pick> on = std::nullopt;  ///< Of the first three kinds and of feet: the line.
  std::size_t segment = 0;                       ///< Of that line, or its vertex.
};

struct SnapWish {
  double reach = 0.0;         ///< m along x; a circle on the page.
  double exaggeration = 1.0;  ///< Of the panel: along y the reach is that much smaller.
  std::set<SnapKind> kinds = {SnapKind::Vertex, SnapKind::Intersection, SnapKind::OnLine, SnapKind::Perpendicular};
  std::optional<geom::Point> from = std::nullopt;  ///< The place before: Perpendicular and Angle need one.
  double grid = 0.0;                               ///< Spacing of the grid, m; 0: none.
  double grid_y = 0.0;                             ///< Along y; 0: as along x.
  geom::Point grid_origin{};                       ///< The grid goes through it.
  double angle_step = 15.0;                        ///< Degrees; true angles, whatever the exaggeration.
  std::set<scene::Pick> without = {};              ///< Lines that are not looked at.
  const std::set<scene::Pick>* only = nullptr;     ///< If given, no others are.
};

/// The visible lines and markers of a panel, ready to be asked.
class SnapIndex {
 public:
  SnapIndex() = default;
  /// @param hidden  keys of layers that are left out.
  /// @cost  O(n log n) for n points.
  SnapIndex(std::shared_ptr<const scene::Picture> picture, std::size_t panel, const std::set<std::string>& hidden = {});

  /// The kind that wins within reach, and of that kind the nearest; nothing if there is none. The foot of a
  /// perpendicular wins over other places of its line within half the reach. @cost O(log n + near segments).
  [[nodiscard]] std::optional<Snap> at(geom::Point cursor, const SnapWish& wish) const;

 private:
  struct Run;
  struct Near;
  [[nodiscard]] const geom::Polyline& line(const Run& run) const;
  [[nodiscard]] scene::Pick pick_of(const Run& run) const;
  [[nodiscard]] std::vector<Near> near(geom::Point cursor, const SnapWish& wish, double reach) const;
  [[nodiscard]] std::optional<Snap> on_lines(geom::Point cursor, const SnapWish& wish) const;
  [[nodiscard]] std::optional<Snap> at_right_angle(geom::Point cursor, const SnapWish& wish) const;

  struct Run {
    std::uint32_t layer;
    std::uint32_t item;
    std::uint32_t first;  ///< Of its segments; of a marker the point.
    std::uint32_t count;  ///< 0: a marker.
  };
  std::shared_ptr<const scene::Picture> picture_;
  std::size_t panel_ = 0;
  std::vector<Run> runs_;
  geom::SpatialIndex index_;
};

}  // namespace dobra::canvas
