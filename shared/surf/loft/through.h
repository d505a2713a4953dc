#pragma once
// The surfaces of horizons and faults through equally named lines of sections. Sections that lie side by side give
// lofts; where they cross, patches between four of them (Coons) or three (triangular). Faults part the horizons. What
// cannot be joined is told with its place. Page: docs/algorithms/loft.md.

#include <vector>

#include "shared/surf/loft/patch.h"
#include "shared/surf/loft/ties.h"

namespace dobra::surf::loft {

struct ThroughOptions {
  TieOptions ties;
  std::size_t rows = 8;             ///< Of the lattice, from section to section ...
  std::size_t triangles = 500'000;  ///< ... fewer where a loft would have more triangles than this.
  double at_fault = 0.01;  ///< A horizon that ends nearer to a fault than this part of its section's size ends at it.
  double uneven = 1.5;     ///< Lines side by side of which one is longer than this times another are told.
};

struct Surfaces {
  std::vector<NamedSurface> surfaces;  ///< In the order in which sections name them; without those that have no patch.
  std::vector<Section> sections;       ///< As they are tied.
  std::vector<Mistie> misties;
  std::vector<Finding> findings;
  double size = 0.0;  ///< Of all lines, m.
};

/// @error BadSection: no section; those of tie()
/// @cost  O(points of the lattices)
base::Result<Surfaces> surfaces_through(std::vector<Section> sections, const ThroughOptions& options = {});

/// The order of sections that lie side by side, and which of them run against the first. Their middles lie along one
/// direction: that of their greatest spread.
struct Row {
  std::vector<std::size_t> order;
  std::vector<bool> against;  ///< One for each of `order`.
  bool end_to_end = false;    ///< They lie behind each other rather than side by side.
};
/// @param which  numbers of sections, two at least
Row row_of(const std::vector<Section>& sections, const std::vector<std::size_t>& which);

}  // namespace dobra::surf::loft
