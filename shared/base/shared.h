#pragma once
// Lists that are copied by reference: a copy costs a counter, and becomes a list of its own when it is changed.

#include <initializer_list>
#include <memory>
#include <utility>

namespace dobra::base {

/// A container such as std::vector, shared by its copies until one of them is changed. Reading is that of the
/// container; whoever changes it says so: `edit()`. Copies may be read and dropped on different threads.
template <class Container>
class Shared {
 public:
  using value_type = typename Container::value_type;
  using size_type = typename Container::size_type;
  using const_iterator = typename Container::const_iterator;
  using iterator = const_iterator;

  Shared() = default;
  Shared(Container items)  // NOLINT(google-explicit-constructor): a list is taken as it is
      : items_(std::make_shared<Container>(std::move(items))) {}
  Shared(std::initializer_list<value_type> items) : items_(std::make_shared<Container>(items)) {}

  [[nodiscard]] const Container& get() const {
    static const Container none;
    return items_ ? *items_ : none;
  }
  operator const Container&() const { return get(); }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] const_iterator begin() const { return get().begin(); }
  [[nodiscard]] const_iterator end() const { return get().end(); }
  [[nodiscard]] size_type size() const { return get().size(); }
  [[nodiscard]] bool empty() const { return get().empty(); }
  [[nodiscard]] const value_type& operator[](size_type i) const { return get()[i]; }
  [[nodiscard]] const value_type& front() const { return get().front(); }
  [[nodiscard]] const value_type& back() const { return get().back(); }
  [[nodiscard]] const value_type* data() const { return get().data(); }

  /// The container to change; a copy of its own where others hold it too. @cost O(size) then.
  [[nodiscard]] Container& edit() {
    if (!items_)
      items_ = std::make_shared<Container>();
    else if (items_.use_count() > 1)
      items_ = std::make_shared<Container>(*items_);
    return *items_;
  }
  void push_back(value_type item) { edit().push_back(std::move(item)); }

  /// Whether both are the same list in memory (not merely equal).
  [[nodiscard]] bool is(const Shared& other) const { return items_ == other.items_; }
  friend bool operator==(const Shared& a, const Shared& b) { return a.is(b) || a.get() == b.get(); }

 private:
  std::shared_ptr<Container> items_;
};

}  // namespace dobra::base
