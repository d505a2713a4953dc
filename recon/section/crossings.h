#pragma once
// Where digitised lines cross themselves, decided exactly, and small loops cut out on request.

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::section {

/// Segments `first` < `second` of a line meet at `place`; neighbours only where one folds back onto the other.
struct SelfCrossing {
  std::size_t first = 0;
  std::size_t second = 0;
  geom::Point place;
};

/// All of them, of an open or closed line, by (first, second). O(n log n + pairs of near segments).
std::vector<SelfCrossing> self_crossings(const geom::Polyline& line);

struct LoopOptions {
  double longest_loop = 0.02;  ///< A loop longer than this part of its line is no slip of the pen: it is not cut.
};

struct WithoutLoops {
  geom::Polyline line;
  std::vector<geom::Point> places;  ///< Where loops were cut.
};

/// The line without its loops: at each crossing it takes the short way.
/// @error BadSection with the place of a loop that is too long.
base::Result<WithoutLoops> without_loops(geom::Polyline line, const LoopOptions& options = {});

}  // namespace recon::section
