#include "shared/gui/view/history.h"

#include <utility>

namespace dobra::gui::view {

namespace {

constexpr std::int64_t one_way = 1000;  ///< Milliseconds between moves that belong together.
constexpr std::size_t most_remembered = 200;

}  // namespace

void History::before(const Looks& now, Move move, std::int64_t milliseconds) {
  const bool goes_on = move == Move::Glide && glided_ && milliseconds - *glided_ < one_way;
  glided_ = move == Move::Glide ? std::optional(milliseconds) : std::nullopt;
  if (goes_on) return;
  future_.clear();
  if (!past_.empty() && past_.back() == now) return;
  past_.push_back(now);
  if (past_.size() > most_remembered) past_.erase(past_.begin());
}

std::optional<Looks> History::back(const Looks& now) {
  glided_.reset();
  while (!past_.empty()) {
    Looks then = std::move(past_.back());
    past_.pop_back();
    if (then == now) continue;
    future_.push_back(now);
    return then;
  }
  return std::nullopt;
}

std::optional<Looks> History::forward(const Looks& now) {
  glided_.reset();
  if (future_.empty()) return std::nullopt;
  past_.push_back(now);
  Looks then = std::move(future_.back());
  future_.pop_back();
  return then;
}

void History::clear() {
  past_.clear();
  future_.clear();
  glided_.reset();
}

}  // namespace dobra::gui::view
