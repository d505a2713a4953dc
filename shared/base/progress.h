#pragma once
// How long work tells how far it is, and learns that it should stop.

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "shared/base/result.h"

namespace dobra::base {

/// Set from any thread (a signal handler included) to ask work to stop.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const { flag_->store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool cancelled() const { return flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

/// Passed by reference through every operation. `report` is called from one thread at a time.
class Progress {
 public:
  using Listener = std::function<void(double fraction, const std::string& what)>;

  /// Nobody listens and nobody cancels.
  Progress() = default;
  Progress(CancelToken token, Listener listener) : token_(std::move(token)), listener_(std::move(listener)) {}

  /// @param fraction 0..1 of the work of this object.
  void report(double fraction, const std::string& what = {}) const {
    if (listener_) listener_(from_ + (to_ - from_) * fraction, what);
  }
  [[nodiscard]] bool cancelled() const { return token_.cancelled(); }
  /// An error with code Cancelled once cancel was asked; call it in every long loop.
  [[nodiscard]] Result<void> check() const {
    if (cancelled()) return Error{ErrorCode::Cancelled, "interrupted"};
    return {};
  }
  /// The part of this progress between two fractions, for a sub-task.
  [[nodiscard]] Progress part(double from, double to) const {
    Progress sub = *this;
    sub.from_ = from_ + (to_ - from_) * from;
    sub.to_ = from_ + (to_ - from_) * to;
    return sub;
  }

 private:
  CancelToken token_;
  Listener listener_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace dobra::base
