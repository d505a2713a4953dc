#pragma once
// What was looked at before: back and forward, as in a browser.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "shared/scene/view.h"

namespace dobra::gui::view {

/// By the key of the panel; a panel that is not there shows all of itself.
using Looks = std::map<std::string, scene::View>;

/// Pans and turns of the wheel that follow each other within a second are one way; a jump is one by itself.
enum class Move { Glide, Jump };

class History {
 public:
  /// The view is about to move from `now`. @param milliseconds  of any clock that does not go back.
  void before(const Looks& now, Move move, std::int64_t milliseconds);

  /// What was seen before, `now` being where forward leads from there; nothing if that is the first.
  std::optional<Looks> back(const Looks& now);
  std::optional<Looks> forward(const Looks& now);
  [[nodiscard]] bool can_go_back() const { return !past_.empty(); }
  [[nodiscard]] bool can_go_forward() const { return !future_.empty(); }
  /// Another document.
  void clear();

 private:
  std::vector<Looks> past_;
  std::vector<Looks> future_;
  std::optional<std::int64_t> glided_;  ///< When the way that is under way has moved last.
};

}  // namespace dobra::gui::view
