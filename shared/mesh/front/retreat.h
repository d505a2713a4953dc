#pragma once
// What is done where sides of a front cross: the triangles behind them are taken away. Used by gap_filler.h only.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "shared/mesh/front/advancing_front.h"

namespace dobra::mesh::front {

/// A side that stands, the gap on its left.
struct GapSide {
  using Kernel = delaunay::DelaunayKernel;
  static constexpr std::uint32_t none = Kernel::none;

  Kernel::Vertex from = none;
  Kernel::Vertex to = none;
  Kernel::Half back = none;      ///< What lies on its right, unless there is a partner.
  std::uint32_t partner = none;  ///< The side with a gap on its left that runs the other way.
  std::int32_t region = 0;
  Kernel::Mark mark = 0;
};

/// Takes away the triangles of the front behind some sides.
class Retreat {
 public:
  using Kernel = delaunay::DelaunayKernel;

  Retreat(Kernel& kernel, std::vector<GapSide>& sides) : kernel_(kernel), sides_(sides) {
    for (std::uint32_t s = 0; s < sides.size(); ++s) {
      if (sides[s].partner == none) side_before_[sides[s].back] = s;
    }
  }
  /// @return the number of triangles removed.
  std::size_t run(std::vector<std::uint32_t> wrong, int layers) {
    std::size_t removed = 0;
    for (; layers > 0 && !wrong.empty(); --layers) {
      std::vector<std::uint32_t> uncovered;
      for (const std::uint32_t s : wrong) {
        if (sides_[s].from == none || sides_[s].partner != none) continue;
        const Kernel::Cell c = Kernel::cell_of(sides_[s].back);
        if (kernel_.cell(c).region < 0) continue;
        remove(c, uncovered);
        ++removed;
      }
      wrong = std::move(uncovered);
    }
    drop_covered();
    return removed;
  }

 private:
  static constexpr std::uint32_t none = Kernel::none;

  void drop_covered() {
    std::vector<std::uint32_t> number;
    std::uint32_t count = 0;
    for (const GapSide& side : sides_) number.push_back(side.from == none ? none : count++);
    std::erase_if(sides_, [](const GapSide& side) { return side.from == none; });
    for (GapSide& side : sides_) {
      if (side.partner != none) side.partner = number[side.partner];
    }
  }
  void remove(Kernel::Cell c, std::vector<std::uint32_t>& uncovered) {
    const std::int32_t region = kernel_.cell(c).region;
    kernel_.set_region(c, replaced_region);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Kernel::Half e = Kernel::half(c, i);
      const auto before = side_before_.find(e);
      const std::uint32_t other = before != side_before_.end() ? before->second : none;
      if (other != none) side_before_.erase(before);
      if (other != none && sides_[other].mark == 0) {
        sides_[other].from = none;
        continue;
      }
      const auto added = static_cast<std::uint32_t>(sides_.size());
      sides_.push_back({kernel_.origin(e), kernel_.target(e), none, other, region, kernel_.mark(e)});
      uncovered.push_back(added);
      if (other != none) {
        sides_[added].mark = sides_[other].mark;
        sides_[other].partner = added;
      } else {
        sides_[added].back = kernel_.twin(e);
        side_before_[kernel_.twin(e)] = added;
      }
    }
  }

  Kernel& kernel_;
  std::vector<GapSide>& sides_;
  std::unordered_map<Kernel::Half, std::uint32_t> side_before_;  ///< By the half-edge on their right.
};

}  // namespace dobra::mesh::front
