#pragma once
// Lower envelope of straight pieces over an axis, made by merging.

#include <cstdint>
#include <vector>

namespace dobra::offset {

/// A straight piece of a graph over [x0, x1].
struct Span {
  double x0, y0, x1, y1;
  std::uint32_t site;  ///< What it is a part of.

  [[nodiscard]] double at(double x) const {
    if (x <= x0) return y0;
    return x >= x1 ? y1 : y0 + (y1 - y0) * ((x - x0) / (x1 - x0));
  }
};

/// Graphs in order of place; each may have gaps. Kept as the envelopes of 1, 2, 4, ... of them, so that a graph takes part in
/// few merges, and only where it overlaps its neighbours.
class LowerEnvelope {
 public:
  /// @param touching  of two spans that are nowhere further apart the first stays.
  explicit LowerEnvelope(double touching) : touching_(touching) {}
  /// @param graph  spans in order of x, disjoint.
  void add(const std::vector<Span>& graph);
  /// Spans in order of x, disjoint.
  std::vector<Span> finish();

 private:
  void merge_last_two();

  struct Level {
    std::size_t first;  ///< Index of its first span.
    int order;
  };
  double touching_;
  std::vector<Span> spans_;  // of all levels, one after another
  std::vector<Level> levels_;
  std::vector<Span> merged_;
};

}  // namespace dobra::offset
