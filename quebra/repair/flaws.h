#pragma once
// What looks wrong in a domain that can be meshed all the same: lines that nearly close, and parts of curves that run
// closer to each other than the mesh can follow well (slivers).  Page: docs/algorithms/domain_repair.md.

#include <optional>
#include <vector>

#include "quebra/domain/domain.h"

namespace quebra::repair {

struct FlawOptions {
  /// Gaps of chains of internal lines that would close, as a fraction of the domain's diagonal.
  double near_end = 0.01;
  double sliver = 1e-3;  ///< Parts of curves nearer to each other than this fraction of the sides there are slivers.
  std::optional<sketch::RepairOptions> repaired = std::nullopt;  ///< The drawing went through repair, which left them.
  double side = 0.05;  ///< Sides count as no longer than this fraction of the diagonal, as the mesher's own size is.
};

/// Each with its place and what to do; nothing is changed.  @cost O(n log n)
std::vector<sketch::Finding> flaws_of(const domain::Domain& domain, const FlawOptions& options = {});

}  // namespace quebra::repair
