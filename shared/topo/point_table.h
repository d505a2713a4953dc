#pragma once
// Which vertex stands at exactly a given place: an open hash table of vertex numbers, whose points stay where they are.

#include <bit>
#include <cstdint>
#include <vector>

#include "shared/geom/point.h"

namespace dobra::topo {

class PointTable {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// The number whose point is p, or none. `point(i)` gives the point of number i.
  template <class PointOf>
  [[nodiscard]] std::uint32_t find(geom::Point p, const PointOf& point) const {
    if (slots_.empty()) return none;
    for (std::size_t i = home(p);; i = (i + 1) & mask_) {
      if (slots_[i] == none || point(slots_[i]) == p) return slots_[i];
    }
  }
  /// @pre no number with that point is in the table.
  template <class PointOf>
  void insert(std::uint32_t number, const PointOf& point) {
    if (2 * (count_ + 1) > slots_.size()) rehash(point);
    put(number, point);
    ++count_;
  }
  /// @pre there is one.
  template <class PointOf>
  void erase(geom::Point p, const PointOf& point) {
    std::size_t hole = home(p);
    while (point(slots_[hole]) != p) hole = (hole + 1) & mask_;
    // What follows moves up if its home is not after the hole, so that no search stops too early.
    for (std::size_t i = (hole + 1) & mask_; slots_[i] != none; i = (i + 1) & mask_) {
      if (((i - home(point(slots_[i]))) & mask_) < ((i - hole) & mask_)) continue;
      slots_[hole] = slots_[i];
      hole = i;
    }
    slots_[hole] = none;
    --count_;
  }

 private:
  [[nodiscard]] std::size_t home(geom::Point p) const {
    std::uint64_t h = std::bit_cast<std::uint64_t>(p.x) * 0x9e3779b97f4a7c15ULL;
    h ^= std::rotl(std::bit_cast<std::uint64_t>(p.y) * 0xc2b2ae3d27d4eb4fULL, 31);
    h ^= h >> 29;
    h *= 0xbf58476d1ce4e5b9ULL;
    return static_cast<std::size_t>(h >> 32) & mask_;
  }
  template <class PointOf>
  void put(std::uint32_t number, const PointOf& point) {
    std::size_t i = home(point(number));
    while (slots_[i] != none) i = (i + 1) & mask_;
    slots_[i] = number;
  }
  template <class PointOf>
  void rehash(const PointOf& point) {
    const std::vector<std::uint32_t> old(slots_.empty() ? 16 : 2 * slots_.size(), none);
    std::vector<std::uint32_t> numbers = std::move(slots_);
    slots_ = old;
    mask_ = slots_.size() - 1;
    for (const std::uint32_t number : numbers) {
      if (number != none) put(number, point);
    }
  }

  std::vector<std::uint32_t> slots_;  // a power of two, at most half of them taken
  std::size_t mask_ = 0;
  std::size_t count_ = 0;
};

}  // namespace dobra::topo
