#pragma once
// Beds as weighted points, and how far from a straight line they lie when they are taken back.
// Page: docs/algorithms/inversion.md

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recon/section/section.h"
#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace recon::inversion {

/// A horizon with all its pieces. Each point weighs as much of the length as is nearest to it, so that what counts is
/// the shape and not how densely it was digitised; the weights of a bed sum up to the number of its points.
struct BedShape {
  std::string name;
  std::vector<geom::Point> points;
  std::vector<double> weights;
};

/// @param names  of whole horizons; empty: all of the section.
/// @error BadSection: no such horizon, or none at all; a bed of less than three points.
base::Result<std::vector<BedShape>> bed_shapes(const section::Section& section, const std::vector<std::string>& names);

/// Every k-th point, so that a bed has `most` points at the most; each takes the weight of those that it stands for.
std::vector<BedShape> thinned(const std::vector<BedShape>& beds, std::size_t most);

using Restore = std::function<geom::Point(geom::Point)>;

/// The straight line of a restored bed.
struct BedLine {
  geom::Point at;       ///< Its centre.
  geom::Vector normal;  ///< Unit.
};

/// Of restored points: through their centre, along `bedding`, or where that is not said so that the sum of the weighted
/// squared distances is least.
BedLine straight_line(const BedShape& bed, const std::vector<geom::Point>& restored,
                      std::optional<base::Angle> bedding);

/// Distances of the restored points from the line of their bed, m, each times the root of its weight; bed by bed.
void deviations(const std::vector<BedShape>& beds, const Restore& restore, std::optional<base::Angle> bedding,
                std::vector<double>& out);

/// The sum of the squares, added up in order.
double sum_of_squares(const std::vector<double>& values);

}  // namespace recon::inversion
