#pragma once
// Stacks of level beds that planes cut and whose blocks are moved, for tests of jigsaws.

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "recon/jigsaw/blockwise.h"

namespace recon::jigsaw {

using section::LineKind;
using section::Section;
using Motion = std::function<geom::Point(geom::Point)>;

/// A plane x = at + lean * depth through a stack of level beds, in the restored state.
struct Plane {
  double at = 0.0;
  double lean = 0.0;  ///< 1 / tan of the dip, > 0: dips to +x.
  [[nodiscard]] double x(double z) const { return at - lean * z; }
};

inline constexpr double left_end = -5000.0;
inline constexpr double right_end = 5000.0;
inline const std::vector<double> levels{0.0, -300.0, -600.0, -900.0};

inline Motion by(double dx, double dz) {
  return [=](geom::Point p) { return geom::Point{p.x + dx, p.y + dz}; };
}

/// Level beds from -5000 to 5000 cut by the planes, each block moved. The fault runs where the wall is of the block
/// behind it (`of_next`) or before it.
inline Section stack(const std::vector<Plane>& planes, const std::vector<Motion>& motions, bool of_next,
                     int points = 2) {
  Section section;
  const auto edge = [&](std::size_t block, bool right, double z) {
    if (right) return block < planes.size() ? planes[block].x(z) : right_end;
    return block > 0 ? planes[block - 1].x(z) : left_end;
  };
  for (std::size_t bed = 0; bed < levels.size(); ++bed) {
    for (std::size_t block = 0; block < motions.size(); ++block) {
      const double z = levels[bed];
      const double from = edge(block, false, z), to = edge(block, true, z);
      geom::Polyline line;
      for (int i = 0; i < points; ++i)
        line.points.push_back(motions[block]({from + (to - from) * i / (points - 1), z}));
      const std::string whole(1, static_cast<char>('A' + bed));
      section.horizons.push_back({section::HorizonId(section.horizons.size()),
                                  whole + " (" + std::to_string(block + 1) + ")",
                                  line,
                                  {},
                                  whole});
    }
  }
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const Motion& wall = motions[of_next ? k + 1 : k];
    section.lines.push_back({section::LineId(k),
                             LineKind::Fault,
                             "F" + std::to_string(k + 1),
                             {{wall({planes[k].x(-1500), -1500}), wall({planes[k].x(900), 900})}, false},
                             {}});
  }
  return section;
}

/// Down a plane by s metres of slip, relative to a motion.
inline geom::Vector along(const Plane& plane, double s) {
  return (s / std::hypot(1.0, plane.lean)) * geom::Vector{plane.lean, -1.0};
}

inline const Plane east{0.0, 1.0 / std::numbers::sqrt3};
inline const Plane west{1800.0, -1.0 / std::numbers::sqrt3};

/// A graben: both blocks beside it stay.
inline Section graben() {
  return stack({east, west}, {by(0, 0), by(along(east, 250).x, along(east, 250).y), by(2 * along(east, 250).x, 0)},
               false);
}

inline Section imbricate(double slip = 300.0) {
  const std::vector<Plane> planes{
      {0.0, -std::numbers::sqrt3}, {1500.0, -std::numbers::sqrt3}, {3000.0, -std::numbers::sqrt3}};
  std::vector<Motion> motions;
  for (int k = 3; k >= 0; --k) {
    const geom::Vector up = along(planes[0], -k * slip);
    motions.push_back(by(up.x, up.y));
  }
  return stack(planes, motions, true);
}

inline Blockwise restored(const Section& section, BlockwiseParams how, unfold::RestoreParams params = {}) {
  auto made = restore_blockwise(section, how, params, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return made ? std::move(*made) : Blockwise();
}

inline BlockwiseParams jigsaw_by(Fit fit) {
  BlockwiseParams how;
  how.jigsaw = true;
  how.fit = fit;
  return how;
}

}  // namespace recon::jigsaw
