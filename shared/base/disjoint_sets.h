#pragma once
// Disjoint sets of 0, 1, 2 ..., such as the elements of a mesh by the parts that hang together.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace dobra::base {

/// A forest whose paths are halved as they are walked. The root of a set is its lowest member.
class DisjointSets {
 public:
  /// One set each.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }
  std::size_t set_count() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) count += root(i) == i ? 1U : 0U;
    return count;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace dobra::base
