#pragma once
// The points of a line in a document. Documents never change; one that differs in a vertex shares the other points
// with the one before it, so that each of many thousand edits can be undone.

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <vector>

#include "shared/geom/point.h"

namespace dobra::scenario {

/// A list of points, in runs that are shared between copies. It does not change.
class Points {
  struct Run {
    std::size_t first = 0;  ///< How many points are before it.
    std::shared_ptr<const std::vector<geom::Point>> points;
  };

 public:
  /// A new run is not longer than this.
  static constexpr std::size_t run_length = 512;

  Points() = default;
  Points(const std::vector<geom::Point>& points);  // NOLINT(google-explicit-constructor): points are points
  Points(std::initializer_list<geom::Point> points) : Points(std::vector<geom::Point>(points)) {}
  /// The same points, of which the runs at both ends that `before` has too are those of `before`. @cost O(size) in
  /// time, O(run_length + what differs + number of runs) in memory.
  Points(const std::vector<geom::Point>& points, const Points& before);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  /// @pre i < size(). @cost O(log runs)
  [[nodiscard]] const geom::Point& operator[](std::size_t i) const;
  [[nodiscard]] const geom::Point& front() const { return runs_.front().points->front(); }
  [[nodiscard]] const geom::Point& back() const { return runs_.back().points->back(); }
  /// All of them in one list.
  [[nodiscard]] std::vector<geom::Point> list() const;

  class const_iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = geom::Point;
    using difference_type = std::ptrdiff_t;
    using pointer = const geom::Point*;
    using reference = const geom::Point&;
    const_iterator() = default;
    reference operator*() const { return (*(*runs_)[run_].points)[at_]; }
    pointer operator->() const { return &**this; }
    const_iterator& operator++() {
      if (++at_ == (*runs_)[run_].points->size()) ++run_, at_ = 0;
      return *this;
    }
    const_iterator operator++(int) {
      const_iterator was = *this;
      ++*this;
      return was;
    }
    friend bool operator==(const const_iterator& a, const const_iterator& b) {
      return a.run_ == b.run_ && a.at_ == b.at_;
    }

   private:
    friend class Points;
    const_iterator(const std::vector<Run>& runs, std::size_t run) : runs_(&runs), run_(run) {}
    const std::vector<Run>* runs_ = nullptr;
    std::size_t run_ = 0;
    std::size_t at_ = 0;
  };
  using iterator = const_iterator;
  [[nodiscard]] const_iterator begin() const { return {runs_, 0}; }
  [[nodiscard]] const_iterator end() const { return {runs_, runs_.size()}; }

  /// Whether they would be written alike: 0 and -0 differ, numbers that are none do not. @cost O(what is not shared)
  /// where runs begin at the same places, else O(size).
  friend bool operator==(const Points& a, const Points& b);

 private:
  void append(std::shared_ptr<const std::vector<geom::Point>> run);
  void append(const std::vector<geom::Point>& points, std::size_t begin, std::size_t end);

  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

}  // namespace dobra::scenario
