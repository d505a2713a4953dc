#include "shared/scene/names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dobra::scene {
namespace {

constexpr double gap = 0.01;
constexpr std::size_t most_names = 400;

/// Names that push each other: they stand on top of each other, together as near to their ends as can be.
struct Stack {
  std::vector<std::size_t> names;  ///< From top to bottom.
  double top = 0.0;
};

class Placer {
 public:
  Placer(const std::vector<NamePlace>& names, double reach, double low, double high)
      : names_(names), reach_(reach), low_(low), high_(high) {}

  std::vector<std::optional<geom::Box>> run() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < std::min(names_.size(), most_names); ++i) {
      if (names_[i].height <= high_ - low_) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return names_[a].end.y < names_[b].end.y; });
    for (const std::size_t i : order) add({{i}, 0.0});
    std::vector<std::optional<geom::Box>> boxes(names_.size());
    for (const Stack& stack : stacks_) {
      const std::vector<geom::Box> made = boxes_of(stack);
      for (std::size_t k = 0; k < made.size(); ++k) boxes[stack.names[k]] = made[k];
    }
    return boxes;
  }

 private:
  /// Joins the stacks that the new one reaches into until it reaches into none, and thins it out where it is too long.
  void add(Stack stack) {
    settle(stack);
    for (std::size_t i = 0; i < stacks_.size();) {
      if (!overlap(stack, stacks_[i])) {
        ++i;
        continue;
      }
      Stack& other = stacks_[i];
      std::vector<std::size_t> joined;
      std::merge(other.names.begin(), other.names.end(), stack.names.begin(), stack.names.end(),
                 std::back_inserter(joined), [&](std::size_t a, std::size_t b) {
                   return names_[a].end.y != names_[b].end.y ? names_[a].end.y < names_[b].end.y : a < b;
                 });
      stack.names = std::move(joined);
      stacks_.erase(stacks_.begin() + static_cast<std::ptrdiff_t>(i));
      settle(stack);
      if (const auto out = too_far(stack)) {
        stack.names.erase(stack.names.begin() + static_cast<std::ptrdiff_t>(*out));
        const std::vector<std::size_t> rest = std::move(stack.names);
        for (const std::size_t name : rest) add({{name}, 0.0});
        return;
      }
      i = 0;
    }
    stacks_.push_back(std::move(stack));
  }

  /// The top at which the squares of all moves are least, within the limits.
  void settle(Stack& stack) const {
    double sum = 0.0;
    double height = 0.0;
    for (const std::size_t i : stack.names) {
      sum += names_[i].end.y - height - 0.5 * names_[i].height;
      height += names_[i].height + gap;
    }
    stack.top = sum / static_cast<double>(stack.names.size());
    stack.top = std::max(low_, std::min(stack.top, high_ - height + gap));
  }

  /// The place in the stack of the name to drop, if any stands too far off its end, or beyond the limits.
  [[nodiscard]] std::optional<std::size_t> too_far(const Stack& stack) const {
    const std::vector<geom::Box> boxes = boxes_of(stack);
    bool far = boxes.back().high.y > high_ + gap;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      far = far || std::abs(boxes[k].centre().y - names_[stack.names[k]].end.y) > reach_;
    }
    if (!far || stack.names.size() < 2) return std::nullopt;
    std::size_t worst = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < stack.names.size(); ++k) {
      double room = 0.0;  // between the neighbours
      if (k > 0) room += names_[stack.names[k]].end.y - names_[stack.names[k - 1]].end.y;
      if (k + 1 < stack.names.size()) room += names_[stack.names[k + 1]].end.y - names_[stack.names[k]].end.y;
      if (k == 0 || k + 1 == stack.names.size()) room *= 2.0;
      if (room < least || (room == least && stack.names[k] > stack.names[worst])) {
        least = room;
        worst = k;
      }
    }
    return worst;
  }

  [[nodiscard]] std::vector<geom::Box> boxes_of(const Stack& stack) const {
    std::vector<geom::Box> boxes;
    double y = stack.top;
    for (const std::size_t i : stack.names) {
      const NamePlace& name = names_[i];
      const double moved = std::abs(y + 0.5 * name.height - name.end.y);
      const double off = moved > 0.5 * name.height ? leader_length : 0.0;
      const double x = name.side == Anchor::Right ? name.end.x + off : name.end.x - off - name.width;
      boxes.push_back({{x, y}, {x + name.width, y + name.height}});
      y += name.height + gap;
    }
    return boxes;
  }

  [[nodiscard]] bool overlap(const Stack& a, const Stack& b) const {
    for (const geom::Box& box : boxes_of(a)) {
      for (const geom::Box& other : boxes_of(b)) {
        if (box.overlaps(other)) return true;
      }
    }
    return false;
  }

  const std::vector<NamePlace>& names_;
  double reach_;
  double low_;
  double high_;
  std::vector<Stack> stacks_;
};

}  // namespace

std::vector<std::optional<geom::Box>> places_of_names(const std::vector<NamePlace>& names, double reach, double low,
                                                      double high) {
  return Placer(names, reach, low, high).run();
}

}  // namespace dobra::scene
