#pragma once
// The order in which sides of a front have their turn. Page: docs/algorithms/advancing_front.md.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dobra::mesh::front {

/// First come first served within a class of sizes, classes in ascending order. Four classes an octave.
class SizeQueue {
 public:
  struct Entry {
    std::uint32_t side;
    std::uint32_t stamp;
  };
  void push(double size, Entry entry) {
    // Equal sizes are the same but for rounding: no class may begin at one that users like, as a power of two.
    const auto bits = std::bit_cast<std::uint64_t>(size * (1.0 + 1e-9));
    const auto key = static_cast<std::size_t>(bits >> 50U);
    if (classes_.empty()) first_key_ = key;
    if (key < first_key_) {
      classes_.insert(classes_.begin(), first_key_ - key, {});
      current_ += first_key_ - key;
      first_key_ = key;
    }
    const std::size_t index = key - first_key_;
    if (index >= classes_.size()) classes_.resize(index + 1);
    classes_[index].entries.push_back(entry);
    current_ = std::min(current_, index);
  }
  bool pop(Entry& entry) {
    for (; current_ < classes_.size(); ++current_) {
      Class& c = classes_[current_];
      if (c.head < c.entries.size()) {
        entry = c.entries[c.head++];
        if (c.head > 65536 && 2 * c.head > c.entries.size()) {
          c.entries.erase(c.entries.begin(), c.entries.begin() + static_cast<std::ptrdiff_t>(c.head));
          c.head = 0;
        }
        return true;
      }
      c.entries.clear();
      c.head = 0;
    }
    return false;
  }

 private:
  struct Class {
    std::vector<Entry> entries;
    std::size_t head = 0;
  };
  std::vector<Class> classes_;
  std::size_t first_key_ = 0;
  std::size_t current_ = 0;
};

}  // namespace dobra::mesh::front
