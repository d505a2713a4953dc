#include "shared/geom/spatial_index.h"

#include <cmath>
#include <tuple>

#include "shared/base/check.h"

namespace dobra::geom {
namespace {

constexpr std::size_t fan_out = 8;  // children of a node; 8 nodes of 40 bytes are five cache lines

std::size_t ceiling_of_quotient(std::size_t a, std::size_t b) { return (a + b - 1) / b; }

}  // namespace

SpatialIndex::SpatialIndex(std::span<const Box> boxes) : item_count_(boxes.size()) {
  DOBRA_CHECK(boxes.size() < std::numeric_limits<std::uint32_t>::max() / 2);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) nodes_.push_back({boxes[i], static_cast<std::uint32_t>(i), 0});
  }
  // Tiles: vertical slices of about sqrt(n / fan_out) leaf groups each, every slice sorted upwards.
  // Centres are compared doubled; equal ones by number, so that the order is total.
  const auto by_x = [](const Node& a, const Node& b) {
    return std::tuple{a.box.low.x + a.box.high.x, a.first} < std::tuple{b.box.low.x + b.box.high.x, b.first};
  };
  const auto by_y = [](const Node& a, const Node& b) {
    return std::tuple{a.box.low.y + a.box.high.y, a.first} < std::tuple{b.box.low.y + b.box.high.y, b.first};
  };
  const std::size_t leaves = nodes_.size();
  const std::size_t groups = ceiling_of_quotient(leaves, fan_out);
  const auto slices = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(groups))));
  const std::size_t slice_size = slices == 0 ? 1 : fan_out * ceiling_of_quotient(groups, slices);
  std::sort(nodes_.begin(), nodes_.end(), by_x);
  for (std::size_t begin = 0; begin < leaves; begin += slice_size) {
    const std::size_t end = std::min(begin + slice_size, leaves);
    std::sort(nodes_.begin() + static_cast<std::ptrdiff_t>(begin), nodes_.begin() + static_cast<std::ptrdiff_t>(end),
              by_y);
  }
  // Every level above packs the one below in its order, until one node is left.
  std::size_t level = 0;
  while (nodes_.size() - level > 1) {
    const std::size_t level_end = nodes_.size();
    for (std::size_t first = level; first < level_end; first += fan_out) {
      const std::size_t last = std::min(first + fan_out, level_end);
      Node parent{{}, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last - first)};
      for (std::size_t child = first; child < last; ++child) parent.box.add(nodes_[child].box);
      nodes_.push_back(parent);
    }
    level = level_end;
  }
}

std::vector<std::size_t> SpatialIndex::overlapping(const Box& query) const {
  std::vector<std::size_t> items;
  for_each_overlapping(query, [&](std::size_t item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<std::pair<std::size_t, std::size_t>> SpatialIndex::overlapping_pairs() const {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (nodes_.empty()) return pairs;
  // Pairs of nodes still to be opened; a node with itself stands for the pairs inside it.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{root(), root()}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    const Node& left = nodes_[a];
    const Node& right = nodes_[b];
    if (!left.box.overlaps(right.box)) continue;
    if (left.count == 0 && right.count == 0) {
      if (a != b) pairs.emplace_back(std::minmax<std::size_t>(left.first, right.first));
      continue;
    }
    if (a == b) {
      for (std::uint32_t i = 0; i < left.count; ++i) {
        for (std::uint32_t j = i; j < left.count; ++j) open.emplace_back(left.first + i, left.first + j);
      }
      continue;
    }
    // Nodes of higher levels have higher numbers: open the higher one.
    const auto [whole, split] = right.count == 0 || (left.count > 0 && a > b) ? std::pair{b, a} : std::pair{a, b};
    for (std::uint32_t i = 0; i < nodes_[split].count; ++i) open.emplace_back(whole, nodes_[split].first + i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

double SpatialIndex::bound(const Box& box, Point p) {
  const double x = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double y = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
  return (1.0 - rounding) * std::hypot(x, y);
}

}  // namespace dobra::geom
