#pragma once
// The part of the plane that a move moves: some of the blocks of a section, or both walls of a fault that ends in rock;
// and lines and areas cut where they pass from it to the rest. Page: docs/algorithms/move.md

#include <memory>
#include <optional>
#include <vector>

#include "recon/kinematics/block_map.h"
#include "recon/section/arrangement.h"
#include "shared/geom/spatial_index.h"

namespace recon::moving {

enum class Fate { Stays, Moves };

/// Part of a line, with the ends of the line or vertices where it is cut.
struct LinePart {
  geom::Polyline line;
  Fate fate = Fate::Stays;
  double trimmed = 0.0;  ///< So much reached into the rest, m; it was cut off.
};

class MovingPart {
 public:
  /// @param contours  of the blocks: anticlockwise, holes clockwise; blocks may be neighbours.
  /// @param size      of the section, m: what lies within 1e-9 of it from the boundary lies on that.
  /// @error those of topo::region and Arrangement.
  static base::Result<MovingPart> of_blocks(const std::vector<geom::Polyline>& contours, double size);
  /// The hanging wall of a path that need not part anything; in front of a tip both walls are one.
  static MovingPart of_walls(kinematics::FaultPath path, double size);

  /// What lies on the boundary stays.  @cost O(log n)
  [[nodiscard]] Fate fate_of(geom::Point p) const;

  /// A line in its parts, in order. One of one fate comes back as it is; a closed one that is cut, in open parts.
  /// Parts shorter than 1e-9 of the size go with their neighbour.
  /// @param overshoot  m; ends that are no longer and reach across the boundary are cut off what moves, and left on
  ///                   what stays.
  [[nodiscard]] std::vector<LinePart> split(const geom::Polyline& line, double overshoot = 0.0) const;

  /// An area in its parts: closed, anticlockwise. One of one fate comes back as it is.  @error those of Arrangement.
  [[nodiscard]] base::Result<std::vector<LinePart>> split_area(const geom::Polyline& contour) const;

  /// Through a map that moves this: both walls of a path, or what moves.
  [[nodiscard]] geom::Point image(geom::Point p, const kinematics::BlockMap& map) const;
  [[nodiscard]] geom::Polyline image(const LinePart& part, const kinematics::BlockMap& map) const;
  /// A line with all its parts.
  [[nodiscard]] geom::Polyline image(const geom::Polyline& line, const kinematics::BlockMap& map) const;

  /// Of blocks: contours anticlockwise, holes clockwise.
  [[nodiscard]] const std::vector<geom::Polyline>& contours() const { return contours_; }

 private:
  [[nodiscard]] bool on_boundary(geom::Point p) const;
  [[nodiscard]] bool crosses(const geom::Polyline& line) const;
  [[nodiscard]] base::Result<std::vector<Fate>> fates_of_faces(const section::Arrangement& arrangement) const;
  void index_sides(const std::vector<geom::Polyline>& lines);

  std::optional<kinematics::FaultPath> walls_;
  std::vector<geom::Polyline> contours_;
  std::vector<geom::Segment> sides_;  ///< Of all contours, or of the path.
  geom::SpatialIndex index_;
  std::shared_ptr<const section::Arrangement> faces_;
  std::vector<Fate> fates_;  ///< By face.
  double near_ = 0.0;        ///< m
};

}  // namespace recon::moving
