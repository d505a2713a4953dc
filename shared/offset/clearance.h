#pragma once
// Is anything of the base nearer to a point than r? A tree of boxes over the base in its own order (neighbours in a chain are
// neighbours in space, so no sorting is needed); boxes prune in double, the decision is taken in Real.

#include <vector>

#include "shared/geom/box.h"
#include "shared/offset/outline.h"

namespace dobra::offset {

class Clearance {
 public:
  /// @param base must outlive this.  @cost O(n).
  Clearance(const BaseCurve& base, const OffsetOptions& options);

  /// True if some point of the base is nearer to q than r.
  [[nodiscard]] bool nearer_than(Vec q, Real r) const;

  /// True if q lies in a mitre of the outline, nearer than r to all its outer lines' own side.
  [[nodiscard]] bool in_mitre(Vec q, const Outline& outline, Real r) const;

 private:
  static constexpr std::size_t leaf_size = 4;
  [[nodiscard]] bool nearer_in_leaf(std::size_t leaf, Vec q, Real r) const;
  [[nodiscard]] bool nearer(std::size_t segment, Vec q, Real squared) const;
  [[nodiscard]] bool in_mitre_at(std::uint32_t step, Vec q, const Outline& outline, Real r) const;
  /// Leaves whose box comes within `reach` of q, until visit returns true.
  template <class Visit>
  bool any_leaf(Vec q, double reach, Visit&& visit) const;

  const BaseCurve& base_;
  double mitre_reach_ = 0;          // of the longest mitre from its corner, in D; 0 if none
  std::size_t leaves_ = 1;          // a power of two
  std::vector<geom::Box> boxes_;    // heap order: children of i are 2i and 2i + 1; root is 1
};

}  // namespace dobra::offset
