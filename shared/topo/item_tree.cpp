#include "shared/topo/item_tree.h"

#include <algorithm>
#include <cmath>

#include "shared/base/check.h"

namespace dobra::topo {

using geom::Box;
using geom::Point;

namespace {
constexpr std::uint32_t crowded = 8;  // items a cell keeps before it is split
double extent(const Box& box) { return std::max(box.width(), box.height()); }
}  // namespace

bool ItemTree::near_line(const geom::Segment& segment, const Box& cell) {
  const geom::Vector along = segment.vector();
  const geom::Vector to = cell.centre() - segment.from;
  const double reach = 0.5 * (std::abs(along.x) * cell.height() + std::abs(along.y) * cell.width());
  // Only a filter: the slack is far above the rounding of the products, so that nothing that meets is left out.
  const double slack = 1e-12 * (std::abs(along.x * to.y) + std::abs(along.y * to.x) + reach +
                                std::abs(along.x * segment.from.y) + std::abs(along.y * segment.from.x));
  return std::abs(geom::cross(along, to)) <= reach + slack;
}

void ItemTree::grow(const Box& box) {
  const Point centre = box.centre();
  if (root_ == none) {
    Node node;
    node.centre = centre;
    node.half = std::max({extent(box), 1e-6 * std::abs(centre.x), 1e-6 * std::abs(centre.y), 1e-280});
    root_ = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
  }
  while (true) {
    const Node root = nodes_[root_];
    if (extent(box) <= 2.0 * root.half && std::abs(centre.x - root.centre.x) <= root.half &&
        std::abs(centre.y - root.centre.y) <= root.half) {
      return;
    }
    const bool right = centre.x >= root.centre.x;
    const bool up = centre.y >= root.centre.y;
    Node node;
    node.half = 2.0 * root.half;
    node.centre = {root.centre.x + (right ? root.half : -root.half), root.centre.y + (up ? root.half : -root.half)};
    node.child[(right ? 0 : 1) + (up ? 0 : 2)] = root_;  // the old root is the quarter on the other side
    node.total = root.total;
    node.split = true;
    nodes_[root_].parent = static_cast<std::uint32_t>(nodes_.size());
    root_ = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(node);
  }
}

std::uint32_t ItemTree::descend(std::uint32_t at, const Box& box) {
  const Point centre = box.centre();
  while (nodes_[at].split && extent(box) <= nodes_[at].half) {
    const Node node = nodes_[at];
    const bool right = centre.x >= node.centre.x;
    const bool up = centre.y >= node.centre.y;
    const int quarter = (right ? 1 : 0) + (up ? 2 : 0);
    if (node.child[quarter] == none) {
      Node child;
      child.half = 0.5 * node.half;
      child.centre = {node.centre.x + (right ? child.half : -child.half), node.centre.y + (up ? child.half : -child.half)};
      child.parent = at;
      nodes_[at].child[quarter] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back(child);
    }
    at = nodes_[at].child[quarter];
  }
  return at;
}

void ItemTree::place(std::uint32_t node, std::uint32_t item) {
  items_[item].node = node;
  items_[item].previous = none;
  items_[item].next = nodes_[node].first;
  if (nodes_[node].first != none) items_[nodes_[node].first].previous = item;
  nodes_[node].first = item;
  ++nodes_[node].kept;
}

void ItemTree::unplace(std::uint32_t item) {
  const Item& entry = items_[item];
  if (entry.next != none) items_[entry.next].previous = entry.previous;
  if (entry.previous != none) {
    items_[entry.previous].next = entry.next;
  } else {
    nodes_[entry.node].first = entry.next;
  }
  --nodes_[entry.node].kept;
}

void ItemTree::split(std::uint32_t node) {
  const Point centre = nodes_[node].centre;
  const double smallest = 1e-14 * (std::abs(centre.x) + std::abs(centre.y)) + 1e-290;
  if (nodes_[node].half < smallest) return;  // quarters would no longer be told apart
  nodes_[node].split = true;
  std::uint32_t next = none;
  for (std::uint32_t item = nodes_[node].first; item != none; item = next) {
    next = items_[item].next;
    if (extent(items_[item].box) > nodes_[node].half) continue;
    unplace(item);
    const std::uint32_t child = descend(node, items_[item].box);
    place(child, item);
    ++nodes_[child].total;
  }
}

void ItemTree::insert(std::uint32_t item, const Box& box) {
  if (item >= items_.size()) items_.resize(item + 1);
  DOBRA_CHECK(items_[item].node == none);
  grow(box);
  items_[item].box = box;
  const std::uint32_t node = descend(root_, box);
  place(node, item);
  for (std::uint32_t at = node; at != none; at = nodes_[at].parent) ++nodes_[at].total;
  if (!nodes_[node].split && nodes_[node].kept > crowded) split(node);
}

void ItemTree::erase(std::uint32_t item) {
  DOBRA_CHECK(item < items_.size() && items_[item].node != none);
  unplace(item);
  for (std::uint32_t at = items_[item].node; at != none; at = nodes_[at].parent) --nodes_[at].total;
  items_[item].node = none;
}

}  // namespace dobra::topo
