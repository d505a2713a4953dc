#pragma once
// A value, or the Error that says why there is none. Functions whose outcome depends on the user's data return it;
// no exception crosses a module border.

#include <utility>
#include <variant>

#include "shared/base/check.h"
#include "shared/base/error.h"

namespace dobra::base {

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& {
    DOBRA_CHECK(ok());
    return *std::get_if<0>(&state_);
  }
  T& value() & {
    DOBRA_CHECK(ok());
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    DOBRA_CHECK(ok());
    return std::move(*std::get_if<0>(&state_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const {
    DOBRA_CHECK(!ok());
    return *std::get_if<1>(&state_);
  }

 private:
  std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit on purpose

  [[nodiscard]] bool ok() const { return !error_; }
  explicit operator bool() const { return ok(); }
  const Error& error() const {
    DOBRA_CHECK(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace dobra::base

#define DOBRA_CONCAT_(a, b) a##b
#define DOBRA_CONCAT(a, b) DOBRA_CONCAT_(a, b)

/// `DOBRA_TRY(auto x, f());` declares x with the value of f(), or returns its error to the caller.
#define DOBRA_TRY(declaration, expression)                                              \
  auto DOBRA_CONCAT(result_, __LINE__) = (expression);                                  \
  if (!DOBRA_CONCAT(result_, __LINE__)) return DOBRA_CONCAT(result_, __LINE__).error(); \
  declaration = std::move(DOBRA_CONCAT(result_, __LINE__)).value()

/// Returns the error of a Result<void> (or of a Result whose value is not wanted) to the caller.
#define DOBRA_TRY_VOID(expression) \
  if (auto result_ = (expression); !result_) return result_.error()
