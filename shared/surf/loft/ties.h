#pragma once
// Where traces of sections cross, lines of one name should be at one height. Where they are not, the mis-tie is listed,
// and shared out: every line is moved up or down to the mean height at the crossing, and between crossings linearly.
// Page: docs/algorithms/loft.md.

#include <optional>
#include <string>
#include <vector>

#include "shared/surf/loft/sections.h"

namespace dobra::surf::loft {

/// Two sections stand over one place.
struct Crossing {
  std::size_t first = 0, second = 0;  ///< Sections.
  double s_first = 0.0, s_second = 0.0;
  geom::Point at;
};

/// Two lines of one name at a crossing.
struct Mistie {
  std::string line;
  LineKind kind = LineKind::Horizon;
  std::size_t first = 0, second = 0;  ///< Sections.
  geom::Point3 at;                    ///< z: the mean of all that meet there.
  double difference = 0.0;            ///< Height in the first less that in the second, m.
};

struct TieOptions {
  std::optional<double> most = std::nullopt;  ///< Refused above, m; nothing: 0.02 of the size of all.
  /// A trace that ends nearer to another than this part of the size, and not on it, is told; a line that ends so near
  /// before a crossing too.
  double near_miss = 0.02;
};

struct Tied {
  std::vector<Section> sections;  ///< With the lines moved, their ends too (reach.h); with a vertex at each crossing.
  std::vector<Crossing> crossings;
  std::vector<Mistie> misties;  ///< All pairs, those of no difference too.
  std::vector<Finding> findings;
};

/// @error BadSection with the place: a mis-tie that is too great, or traces that run along one another.
/// @cost  O(pairs of sections times their vertices)
base::Result<Tied> tie(std::vector<Section> sections, const TieOptions& options = {});

/// Where a line passes over a distance along the trace: its place in the line (vertices count 1) and the height there,
/// by the place. Parts that go straight down give their middle.
struct Passage {
  double place = 0.0;
  double z = 0.0;
};
std::vector<Passage> passages(const geom::Polyline& line, double s, double tolerance);

}  // namespace dobra::surf::loft
