#pragma once
// Values of any type on the entities of one kind; costs nothing until the first one is set.

#include <any>
#include <cstddef>
#include <utility>
#include <vector>

namespace dobra::topo {

class AttributeColumn {
 public:
  /// @param count entities of this kind, this one included.
  [[nodiscard]] std::any& at(std::size_t index, std::size_t count) {
    if (values_.size() < count) values_.resize(count);
    return values_[index];
  }
  [[nodiscard]] const std::any& at(std::size_t index) const {
    static const std::any empty;
    return index < values_.size() ? values_[index] : empty;
  }
  void copy(std::size_t from, std::size_t to, std::size_t count) {
    if (!at(from).has_value()) return;
    std::any value = values_[from];
    at(to, count) = std::move(value);
  }
  void reset(std::size_t index) {
    if (index < values_.size()) values_[index].reset();
  }
  /// True if any was ever set.
  [[nodiscard]] bool used() const { return !values_.empty(); }

 private:
  std::vector<std::any> values_;
};

}  // namespace dobra::topo
