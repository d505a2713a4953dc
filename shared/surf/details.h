#pragma once
// Where a surface bends so closely that places of a net over its chart miss it: narrow peaks, ridges, steps. The chart
// is halved until 3 x 3 places tell how a part bends (Surface::seen). Page: docs/algorithms/surfaces.md.

#include <array>
#include <vector>

#include "shared/surf/surface.h"

namespace dobra::surf {

struct DetailOptions {
  double look = 1.0 / 32.0;   ///< Of the sides of the chart: parts that need be no smaller are no details.
  double finest = 1e-7;       ///< Of the sides of the chart: smaller parts are left as they are.
  std::size_t most = 50'000;  ///< Parts looked at.
};

struct Details {
  std::vector<geom::Box> parts;   ///< In which 3 x 3 places tell enough, smaller than a look.
  std::vector<geom::Box> unseen;  ///< That are too small, or too many, to be halved.
};

/// @cost a bound and nine jets of the surface for each part looked at; one part where the surface is plain.
Details details_of(const Surface& surface, const geom::Box& part, const DetailOptions& options = {});

/// Both halves, across the way along which the tangents turn most; across the longer side where they turn without
/// bound.
std::array<geom::Box, 2> halves_by_bend(const Surface& surface, const geom::Box& part);

/// Places of `marks` (ascending parameters) with others between, so that each straight part of the chart between two of
/// them is seen, or is shorter than 1e-7 of it, or too many are.
template <class Place>
std::vector<double> seen_along(const Surface& surface, const Place& place, const std::vector<double>& marks) {
  constexpr double finest = 1e-7;
  constexpr std::size_t most = 20'000;
  const geom::Box& chart = surface.chart();
  std::vector<double> seen;
  std::vector<double> after(marks.rbegin(), marks.rend());
  std::size_t looks = 0;
  while (!after.empty()) {
    const double next = after.back();
    if (!seen.empty() && looks < most) {
      geom::Box part;
      part.add(place(seen.back()));
      part.add(place(next));
      const bool fine = part.width() <= finest * chart.width() && part.height() <= finest * chart.height();
      if (!fine && (++looks, !surface.seen(part))) {
        after.push_back(0.5 * (seen.back() + next));
        continue;
      }
    }
    seen.push_back(next);
    after.pop_back();
  }
  return seen;
}

}  // namespace dobra::surf
