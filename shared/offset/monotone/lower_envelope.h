#pragma once
// Lower envelope of straight pieces over an axis, made by merging.

#include <cstdint>
#include <vector>

namespace dobra::offset::monotone {

/// A straight piece of a graph over [x0, x1], on the line through (x, y).
struct Span {
  double x0, x1;
  double x, y, slope;
  std::uint32_t site;  ///< What it is a part of.

  [[nodiscard]] double at(double place) const { return y + slope * (place - x); }
};

/// Graphs in order of place; each may have gaps. Kept as the envelopes of 1, 2, 4, ... of them, so that a graph takes
/// part in few merges, and only where it overlaps its neighbours.
class LowerEnvelope {
 public:
  /// @param touching  of two spans that are nowhere further apart the first stays.
  explicit LowerEnvelope(double touching) : touching_(touching) {}
  /// A graph is started, its spans are added in order of x, disjoint, and it is ended.
  void start_graph() { levels_.push_back({spans_.size(), 0}); }
  void add(const Span& span) { spans_.push_back(span); }
  void end_graph() {
    while (levels_.size() > 1 && levels_[levels_.size() - 2].order == levels_.back().order) merge_last_two();
  }
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

}  // namespace dobra::offset::monotone
