#pragma once
// Names for what a line or polygon of a section falls into.

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

namespace recon::moving {

/// "A (1)", "A (2)", ...: names for further pieces that nothing in the section has.
class PieceNames {
 public:
  template <class Item>
  explicit PieceNames(const std::vector<Item>& items) {
    for (const Item& item : items) taken_.insert(item.name);
  }
  std::string next(const std::string& whole) {
    for (int number = 1;; ++number) {
      std::string name = fmt::format("{} ({})", whole, number);
      if (taken_.insert(name).second) return name;
    }
  }

 private:
  std::set<std::string> taken_;
};

}  // namespace recon::moving
