#include "shared/offset/kernel/box_tree.h"

namespace dobra::offset {
inline namespace kernel {

BoxTree::BoxTree(const std::vector<FloatBox>& boxes) {
  std::size_t count = 0;
  for (std::size_t items = boxes.size(); count == 0 || items > 1; items = (items + width - 1) / width) {
    levels_.push_back({count, items});
    count += (items + width - 1) / width;
  }
  nodes_.resize(count);
  const auto set = [&](const Level& level, std::size_t item, const FloatBox& box) {
    Node& n = nodes_[level.first + item / width];
    n.low_x[item % width] = box.low_x;
    n.low_y[item % width] = box.low_y;
    n.high_x[item % width] = box.high_x;
    n.high_y[item % width] = box.high_y;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    set(levels_[0], i, boxes[i]);
    if (boxes[i].empty()) continue;
    greatest_ = std::max({greatest_, -boxes[i].low_x, -boxes[i].low_y, boxes[i].high_x, boxes[i].high_y});
  }
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    for (std::size_t i = 0; i < levels_[l].items; ++i) {
      FloatBox box;
      for (std::size_t k = 0; k < children({l - 1, i}); ++k) box.add(child(levels_[l - 1].first + i, k));
      set(levels_[l], i, box);
    }
  }
}

}  // namespace kernel
}  // namespace dobra::offset
