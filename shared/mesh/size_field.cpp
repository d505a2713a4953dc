#include "shared/mesh/size_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>

namespace dobra::mesh {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

Result<void> validate(std::span<const SizeRequest> requests, const SizeFieldOptions& options) {
  if (!(options.growth > 1.0) || !std::isfinite(options.growth)) {
    return Error{ErrorCode::InvalidOption, "growth must be greater than 1: it is the ratio of neighbouring sizes"};
  }
  if (!(options.max_size >= 0.0)) return Error{ErrorCode::InvalidOption, "max_size must be positive, or 0 for none"};
  for (const SizeRequest& request : requests) {
    if (request.size > 0.0 && std::isfinite(request.size) && geom::is_finite(request.at)) continue;
    base::Place place;
    place.x = request.at.x;
    place.y = request.at.y;
    return Error{ErrorCode::InvalidOption, "a requested mesh size must be greater than 0", place};
  }
  return {};
}

}  // namespace

Result<SizeField> SizeField::build(std::span<const SizedEdge> edges, std::span<const SizeRequest> requests,
                                   const SizeFieldOptions& options) {
  DOBRA_TRY_VOID(validate(requests, options));
  // A size moved by the side of a cell changes by slope * side: a tenth of it is not noticed.
  constexpr double unnoticed = 0.1;
  constexpr double most = 16.0;
  const double coarser = std::clamp(unnoticed / (options.growth - 1.0), 1.0, most);
  QuadtreeOptions tree_options = options.quadtree;
  tree_options.refinement_factor /= coarser;
  DOBRA_TRY(Quadtree tree, Quadtree::build(edges, tree_options));
  for (const SizeRequest& request : requests) {
    tree.refine_at(request.at, request.size, tree_options.refinement_factor);
  }
  if (!requests.empty()) tree.balance();
  double largest = options.max_size;
  if (largest == 0.0) {
    for (const SizedEdge& edge : edges) largest = std::max(largest, edge.segment.length());
  }
  SizeField field(std::move(tree));
  field.number_corners();
  field.sizes_.assign(field.corner_points_.size(), largest);
  const auto ask = [&](Point p, double size) {
    const QuadCellId leaf = field.tree_.leaf_at(p);
    // A size below the finest cell would hold over the whole of it, and call for millions of elements there.
    if (field.tree_.cell(leaf).level == Quadtree::max_level) size = std::max(size, field.tree_.side(leaf));
    for (const std::uint32_t corner : field.corners_[leaf.index()]) {
      field.sizes_[corner] = std::min(field.sizes_[corner], size);
    }
  };
  for (const SizedEdge& edge : edges) {
    const double length = edge.segment.length();
    if (length > 0.0) ask(geom::midpoint(edge.segment.from, edge.segment.to), length);
  }
  for (const SizeRequest& request : requests) ask(request.at, request.size);
  field.spread(options.growth - 1.0);
  return field;
}

void SizeField::number_corners() {
  struct Key {
    std::uint32_t x, y;
    std::uint32_t leaf;
    std::uint32_t corner;
  };
  std::vector<Key> keys;
  for (const QuadCellId leaf : tree_.leaves()) {
    const Quadtree::Cell& cell = tree_.cell(leaf);
    const std::uint32_t width = 1U << (Quadtree::max_level - cell.level);
    for (std::uint32_t k = 0; k < 4; ++k) {
      keys.push_back(
          {cell.x + (k & 1U) * width, cell.y + (k >> 1U) * width, static_cast<std::uint32_t>(leaf.index()), k});
    }
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tie(a.x, a.y, a.leaf, a.corner) < std::tie(b.x, b.y, b.leaf, b.corner);
  });
  corners_.resize(tree_.cell_count());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i].x != keys[i - 1].x || keys[i].y != keys[i - 1].y) {
      corner_points_.push_back(tree_.position(keys[i].x, keys[i].y));
    }
    corners_[keys[i].leaf][keys[i].corner] = static_cast<std::uint32_t>(corner_points_.size() - 1);
  }
}

// Dijkstra over the graph whose arcs are the sides and diagonals of the leaves.
void SizeField::spread(double slope) {
  struct Arc {
    std::uint32_t from, to;
  };
  std::vector<Arc> arcs;
  for (const QuadCellId leaf : tree_.leaves()) {
    for (const std::uint32_t a : corners_[leaf.index()]) {
      for (const std::uint32_t b : corners_[leaf.index()]) {
        if (a != b) arcs.push_back({a, b});
      }
    }
  }
  std::vector<std::uint32_t> first(sizes_.size() + 1, 0);
  for (const Arc& arc : arcs) ++first[arc.from + 1];
  for (std::size_t i = 0; i < sizes_.size(); ++i) first[i + 1] += first[i];
  std::vector<std::uint32_t> to(arcs.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const Arc& arc : arcs) to[next[arc.from]++] = arc.to;

  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t i = 0; i < sizes_.size(); ++i) queue.emplace(sizes_[i], i);
  while (!queue.empty()) {
    const auto [size, corner] = queue.top();
    queue.pop();
    if (size > sizes_[corner]) continue;
    for (std::uint32_t k = first[corner]; k < first[corner + 1]; ++k) {
      const double bound = size + slope * geom::distance(corner_points_[corner], corner_points_[to[k]]);
      if (bound >= sizes_[to[k]]) continue;
      sizes_[to[k]] = bound;
      queue.emplace(bound, to[k]);
    }
  }
}

std::array<double, 4> SizeField::corner_sizes(QuadCellId leaf) const {
  std::array<double, 4> sizes{};
  for (std::size_t k = 0; k < 4; ++k) sizes[k] = sizes_[corners_[leaf.index()][k]];
  return sizes;
}

double SizeField::size_at(Point p) const { return SizeSampler(*this).at(p); }

void SizeSampler::enter(Point p) {
  leaf_ = field_.quadtree().leaf_at(p);
  const geom::Box box = field_.quadtree().box(leaf_);
  low_ = box.low;
  scale_ = 1.0 / field_.quadtree().side(leaf_);
  size_ = field_.corner_sizes(leaf_);
}

double SizeField::estimated_triangles() const {
  double sum = 0.0;
  for (const QuadCellId leaf : tree_.leaves()) {
    const std::array<double, 4> size = corner_sizes(leaf);
    const double mean = 0.25 * (size[0] + size[1] + size[2] + size[3]);
    sum += (tree_.side(leaf) / mean) * (tree_.side(leaf) / mean);
  }
  return sum * 4.0 / std::numbers::sqrt3;
}

}  // namespace dobra::mesh
