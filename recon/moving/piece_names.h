#pragma once
// Names and ids for what a line or polygon of a section falls into.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace recon::moving {

/// "A (1)", "A (2)", ...: names for further pieces, and ids, that nothing in the section has.
class PieceNames {
 public:
  template <class Item>
  explicit PieceNames(const std::vector<Item>& items) {
    for (const Item& item : items) {
      taken_.insert(item.name);
      next_id_ = std::max(next_id_, item.id.index() + 1);
    }
  }
  std::string next(const std::string& whole) {
    for (int number = 1;; ++number) {
      std::string name = fmt::format("{} ({})", whole, number);
      if (taken_.insert(name).second) return name;
    }
  }
  [[nodiscard]] std::size_t next_id() { return next_id_++; }

 private:
  std::set<std::string> taken_;
  std::size_t next_id_ = 0;
};

}  // namespace recon::moving
