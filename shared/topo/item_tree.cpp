#include "shared/topo/item_tree.h"

#include <algorithm>

#include "shared/base/check.h"

namespace dobra::topo {

using geom::Box;
using geom::Point;

namespace {
constexpr std::uint32_t crowded = 8;  // items a cell keeps before it is split
double extent(const Box& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }
}  // namespace

ItemTree::Strip::Strip(const geom::Segment& s, double margin)
    : box_(s.box().grown(margin)), from_(s.from), along_(s.vector()) {
  const double size = std::max(std::abs(along_.x), std::abs(along_.y));
  if (size > 0.0 && size < 0x1p-200)
    along_ = {std::scalbn(along_.x, -std::ilogb(size)), std::scalbn(along_.y, -std::ilogb(size))};
  // Far above the rounding of the products and their underflow, so that nothing that meets is left out.
  slack_ = 1.5 * margin * (std::abs(along_.x) + std::abs(along_.y)) +
           1e-12 * (std::abs(along_.x * from_.y) + std::abs(along_.y * from_.x)) + 0x1p-1060;
}

void ItemTree::grow(const Box& box) {
  const Point centre = box.centre();
  if (root_ == none) {
    root_cell_ = {centre, std::max({extent(box), 1e-6 * std::abs(centre.x), 1e-6 * std::abs(centre.y), 1e-280})};
    root_ = 0;
    nodes_.emplace_back();
  }
  while (true) {
    const Cell root = root_cell_;
    if (extent(box) <= 2.0 * root.half && std::abs(centre.x - root.centre.x) <= root.half &&
        std::abs(centre.y - root.centre.y) <= root.half) {
      return;
    }
    const int away = root.quarter(centre);  // the old root becomes the quarter on the other side
    root_cell_ = {{root.centre.x + (away % 2 == 1 ? root.half : -root.half),
                   root.centre.y + (away / 2 == 1 ? root.half : -root.half)},
                  2.0 * root.half};
    const auto block = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 4);
    move_root_into(block + static_cast<std::uint32_t>(3 - away));
    nodes_[root_].child = block;
  }
}

void ItemTree::move_root_into(std::uint32_t slot) {
  nodes_[slot] = nodes_[root_];
  for (std::uint32_t i = nodes_[slot].first; i != none; i = items_[i].next) items_[i].node = slot;
  nodes_[root_].first = none;
  nodes_[root_].kept = 0;
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
  Node& node = nodes_[entry.node];
  if (entry.next != none) items_[entry.next].previous = entry.previous;
  if (entry.previous != none) {
    items_[entry.previous].next = entry.next;
  } else {
    node.first = entry.next;
  }
  if (--node.kept == 0 && node.child == none) node.bounds = Box();
}

void ItemTree::split(std::uint32_t node, const Cell& cell) {
  const double smallest = 1e-14 * (std::abs(cell.centre.x) + std::abs(cell.centre.y)) + 1e-290;
  if (cell.half < smallest) return;  // quarters would no longer be told apart
  const auto block = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 4);
  nodes_[node].child = block;
  std::uint32_t next = none;
  for (std::uint32_t item = nodes_[node].first; item != none; item = next) {
    next = items_[item].next;
    const Box box = items_[item].segment.box();
    if (extent(box) > cell.half) continue;
    unplace(item);
    const std::uint32_t child = block + static_cast<std::uint32_t>(cell.quarter(box.centre()));
    nodes_[child].bounds.add(box);
    place(child, item);
  }
}

void ItemTree::insert(std::uint32_t item, const geom::Segment& segment) {
  if (item >= items_.size()) items_.resize(item + 1);
  DOBRA_CHECK(items_[item].node == none);
  const Box box = segment.box();
  grow(box);
  items_[item].segment = segment;
  const Point centre = box.centre();
  const double size = extent(box);
  std::uint32_t at = root_;
  Cell cell = root_cell_;
  nodes_[at].bounds.add(box);
  while (nodes_[at].child != none && size <= cell.half) {
    const int quarter = cell.quarter(centre);
    cell = cell.child(quarter);
    at = nodes_[at].child + static_cast<std::uint32_t>(quarter);
    nodes_[at].bounds.add(box);
  }
  place(at, item);
  if (nodes_[at].child == none && nodes_[at].kept > crowded) split(at, cell);
}

void ItemTree::erase(std::uint32_t item) {
  DOBRA_CHECK(item < items_.size() && items_[item].node != none);
  unplace(item);
  items_[item].node = none;
}

}  // namespace dobra::topo
