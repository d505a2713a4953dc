#pragma once
// Typed indices: an index into one kind of array cannot be used for another.

#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>

namespace dobra::base {

/// An index of kind `Tag`; ordered, printable, comparable only with its own kind.
/// The default-constructed value is "none".
template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  constexpr explicit Id(std::size_t index) : index_(static_cast<std::uint32_t>(index)) {}

  /// True unless this is "none".
  [[nodiscard]] constexpr bool valid() const { return index_ != none; }
  /// The position in the array of this kind; meaningless for "none".
  [[nodiscard]] constexpr std::size_t index() const { return index_; }

  friend constexpr auto operator<=>(Id, Id) = default;
  friend std::ostream& operator<<(std::ostream& out, Id id) {
    return id.valid() ? out << Tag::prefix << id.index_ : out << Tag::prefix << "none";
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t index_ = none;
};

}  // namespace dobra::base

template <class Tag>
struct std::hash<dobra::base::Id<Tag>> {
  std::size_t operator()(dobra::base::Id<Tag> id) const noexcept { return id.index(); }
};
