#pragma once
// Is anything of the base nearer to a point than r? A tree of boxes over the base in its own order (neighbours in a chain are
// neighbours in space, so no sorting is needed); boxes prune in double, the decision is taken in Real.

#include <vector>

#include "shared/geom/box.h"
#include "shared/offset/base_curve.h"

namespace dobra::offset {

class Clearance {
 public:
  /// @param base must outlive this.  @cost O(n).
  explicit Clearance(const BaseCurve& base);

  /// True if some point of the base is nearer to q than r.
  [[nodiscard]] bool nearer_than(Vec q, Real r) const;

 private:
  static constexpr std::size_t leaf_size = 4;
  [[nodiscard]] bool nearer_in_leaf(std::size_t leaf, Vec q, Real squared) const;

  const BaseCurve& base_;
  std::size_t leaves_ = 1;          // a power of two
  std::vector<geom::Box> boxes_;    // heap order: children of i are 2i and 2i + 1; root is 1
};

}  // namespace dobra::offset
