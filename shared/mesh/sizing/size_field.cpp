#include "shared/mesh/sizing/size_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

namespace dobra::mesh::sizing {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

Result<void> validate(std::span<const delaunay::SizeRequest> requests, const SizeFieldOptions& options) {
  if (!(options.growth > 1.0) || !std::isfinite(options.growth)) {
    return Error{ErrorCode::InvalidOption, "growth must be greater than 1: it is the ratio of neighbouring sizes"};
  }
  if (!(options.max_size >= 0.0)) return Error{ErrorCode::InvalidOption, "max_size must be positive, or 0 for none"};
  for (const delaunay::SizeRequest& request : requests) {
    if (request.size > 0.0 && std::isfinite(request.size) && geom::is_finite(request.at)) continue;
    base::Place place;
    place.x = request.at.x;
    place.y = request.at.y;
    return Error{ErrorCode::InvalidOption, "a requested mesh size must be greater than 0", place};
  }
  return {};
}

/// Cells of a function alone; a formula that asks for more asks for too much.
constexpr std::size_t most_cells_of_function = 500'000;

/// Whether the function must be seen more closely than by the corners of this cell.
bool follows_badly(const Quadtree& tree, QuadCellId id, const SizeFunction& function, double largest) {
  constexpr std::uint32_t first_look = 5;  // a grid of 32 x 32 cells
  constexpr double unnoticed = 0.1;
  const geom::Box box = tree.box(id);
  if (function.concerns && !function.concerns(box)) return false;
  if (tree.cell(id).level < first_look) return true;
  std::array<std::array<double, 3>, 3> size{};
  double least = largest;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Point p{box.low.x + 0.5 * static_cast<double>(i) * box.width(),
                    box.low.y + 0.5 * static_cast<double>(j) * box.height()};
      size[i][j] = std::min(largest, function.at(p));
      least = std::min(least, size[i][j]);
    }
  }
  if (tree.side(id) <= 0.5 * least) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::array<std::size_t, 2> left = i == 1 ? std::array<std::size_t, 2>{0, 2} : std::array{i, i};
      const std::array<std::size_t, 2> low = j == 1 ? std::array<std::size_t, 2>{0, 2} : std::array{j, j};
      const double between =
          0.25 * (size[left[0]][low[0]] + size[left[1]][low[0]] + size[left[0]][low[1]] + size[left[1]][low[1]]);
      if (std::abs(between - size[i][j]) > unnoticed * size[i][j]) return true;
    }
  }
  return false;
}

}  // namespace

// Dijkstra over the graph whose arcs are the sides and diagonals of the leaves.
/// @param grow  of a leaf and two places in its list of corners: by how much a size may grow from the one to the other.
template <class Grow>
void SizeField::spread(double largest, const Grow& grow) {
  const std::vector<QuadCellId> leaves = tree_.leaves();
  std::vector<std::uint32_t> first(sizes_.size() + 2, 0);
  for (const QuadCellId leaf : leaves) {
    for (const std::uint32_t corner : corners_[leaf.index()]) ++first[corner + 2];
  }
  for (std::size_t i = 2; i < first.size(); ++i) first[i] += first[i - 1];
  std::vector<QuadCellId> leaf_of(4 * leaves.size());
  for (const QuadCellId leaf : leaves) {
    for (const std::uint32_t corner : corners_[leaf.index()]) leaf_of[first[corner + 1]++] = leaf;
  }
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t i = 0; i < sizes_.size(); ++i) {
    if (sizes_[i] < largest) queue.emplace(sizes_[i], i);
  }
  while (!queue.empty()) {
    const auto [size, corner] = queue.top();
    queue.pop();
    if (size > sizes_[corner]) continue;
    for (std::uint32_t k = first[corner]; k < first[corner + 1]; ++k) {
      const auto& around = corners_[leaf_of[k].index()];
      const auto growth = grow(leaf_of[k], corner);
      for (std::size_t j = 0; j < 4; ++j) {
        const double bound = size + growth(j);
        if (!(bound < sizes_[around[j]])) continue;  // nor one that is no number
        sizes_[around[j]] = bound;
        queue.emplace(bound, around[j]);
      }
    }
  }
}

void SizeField::spread(double slope, double largest, std::span<const geom::Point3> at) {
  for (double& size : sizes_) size = std::min(size, largest);
  spread(largest, [&](QuadCellId leaf, std::uint32_t corner) {
    return [&, corner, around = corners_[leaf.index()]](std::size_t j) {
      return slope * geom::distance(at[corner], at[around[j]]);
    };
  });
}

SizeField SizeField::on(Quadtree tree) {
  tree.index_leaves();
  SizeField field(std::move(tree));
  field.sizes_.assign(field.number_corners(), std::numeric_limits<double>::infinity());
  return field;
}

std::vector<geom::Point> SizeField::corner_places() const {
  std::vector<geom::Point> places(sizes_.size());
  for (const QuadCellId leaf : tree_.leaves()) {
    const geom::Box box = tree_.box(leaf);
    for (std::size_t k = 0; k < 4; ++k) {
      places[corners_[leaf.index()][k]] = {(k & 1U) != 0 ? box.high.x : box.low.x,
                                           (k >> 1U) != 0 ? box.high.y : box.low.y};
    }
  }
  return places;
}

Result<SizeField> SizeField::build(std::span<const SizedEdge> edges, std::span<const delaunay::SizeRequest> requests,
                                   const SizeFieldOptions& options) {
  DOBRA_TRY_VOID(validate(requests, options));
  // A size moved by the side of a cell changes by slope * side: a tenth of it is not noticed.
  constexpr double unnoticed = 0.1;
  constexpr double most = 16.0;
  const double coarser = std::clamp(unnoticed / (options.growth - 1.0), 1.0, most);
  QuadtreeOptions tree_options = options.quadtree;
  tree_options.refinement_factor /= coarser;
  DOBRA_TRY(Quadtree tree, Quadtree::build(edges, tree_options));
  for (const delaunay::SizeRequest& request : requests) {
    tree.refine_at(request.at, request.size, tree_options.refinement_factor);
  }
  double largest = options.max_size;
  if (largest == 0.0) {
    for (const SizedEdge& edge : edges) largest = std::max(largest, edge.segment.length());
  }
  const SizeFunction& function = options.function;
  if (function.at && !tree.refine_where([&](QuadCellId id) { return follows_badly(tree, id, function, largest); },
                                        tree.cell_count() + most_cells_of_function)) {
    return Error{ErrorCode::TooManyElements,
                 "the sizes asked for everywhere are too small, or change too fast, for a tree of half a million "
                 "cells: use greater ones"};
  }
  if (!requests.empty() || function.at) tree.balance();
  tree.index_leaves();
  SizeField field(std::move(tree));
  field.sizes_.assign(field.number_corners(), largest);
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
  for (const delaunay::SizeRequest& request : requests) ask(request.at, request.size);
  if (function.at) field.ask_function(function);
  field.spread(largest, [&, slope = options.growth - 1.0](QuadCellId leaf, std::uint32_t corner) {
    // The diagonal joins corners 0 and 3, 1 and 2.
    return [corner, along = slope * field.tree_.side(leaf), &around = field.corners_[leaf.index()]](std::size_t j) {
      return around[3 - j] == corner ? std::numbers::sqrt2 * along : along;
    };
  });
  return field;
}

void SizeField::ask_function(const SizeFunction& function) {
  std::vector<std::uint8_t> asked(sizes_.size(), 0);
  for (const QuadCellId leaf : tree_.leaves()) {
    const geom::Box box = tree_.box(leaf);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t corner = corners_[leaf.index()][k];
      if (std::exchange(asked[corner], std::uint8_t{1}) != 0) continue;
      sizes_[corner] =
          std::min(sizes_[corner],
                   function.at({(k & 1U) != 0 ? box.high.x : box.low.x, (k >> 1U) != 0 ? box.high.y : box.low.y}));
    }
  }
}

std::uint32_t SizeField::number_corners() {
  // Leaves share corners: they are found again by hashing their place on the finest grid.
  const std::vector<QuadCellId> leaves = tree_.leaves();
  struct Slot {
    std::uint64_t place = ~std::uint64_t{0};
    std::uint32_t corner = 0;
  };
  std::vector<Slot> slots(std::bit_ceil(4 * leaves.size()));
  const auto shift = static_cast<std::uint32_t>(std::countl_zero(slots.size()) + 1);
  corners_.resize(tree_.cell_count());
  std::uint32_t count = 0;
  for (const QuadCellId leaf : leaves) {
    const Quadtree::Cell& cell = tree_.cell(leaf);
    const std::uint32_t width = 1U << (Quadtree::max_level - cell.level);
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t x = cell.x + (k & 1U) * width;
      const std::uint32_t y = cell.y + (k >> 1U) * width;
      const std::uint64_t place = (static_cast<std::uint64_t>(x) << 32U) | y;
      std::size_t at = (place * 0x9e3779b97f4a7c15ULL) >> shift;
      while (slots[at].place != place && ~slots[at].place != 0) at = (at + 1) & (slots.size() - 1);
      if (slots[at].place != place) {
        slots[at] = {place, count++};
      }
      corners_[leaf.index()][k] = slots[at].corner;
    }
  }
  return count;
}

std::array<double, 4> SizeField::corner_sizes(QuadCellId leaf) const {
  std::array<double, 4> sizes{};
  for (std::size_t k = 0; k < 4; ++k) sizes[k] = sizes_[corners_[leaf.index()][k]];
  return sizes;
}

double SizeField::size_at(Point p) const { return SizeSampler(*this).at(p); }

void SizeSampler::enter(Point p) {
  const Quadtree& tree = field_.quadtree();
  leaf_ = tree.leaf_at(p);
  low_ = tree.position(tree.cell(leaf_).x, tree.cell(leaf_).y);
  scale_ = 1.0 / tree.side(leaf_);
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

double SizeField::estimated_triangles(const std::function<bool(Point)>& inside) const {
  constexpr std::size_t places = 4096;
  const double all = estimated_triangles() * std::numbers::sqrt3 / 4.0;
  double passed = 0.0;
  std::size_t looked = 0;
  std::size_t found = 0;
  for (const QuadCellId leaf : tree_.leaves()) {
    const std::array<double, 4> size = corner_sizes(leaf);
    const double side = tree_.side(leaf);
    const double per_length = side / (0.25 * (size[0] + size[1] + size[2] + size[3]));
    passed += per_length * per_length;
    // As many places in a leaf as its share of the triangles, spread by the golden ratio.
    const geom::Box box = tree_.box(leaf);
    for (; (static_cast<double>(looked) + 0.5) / places * all <= passed && looked < places; ++looked) {
      const auto spread = [&](double factor) { return std::fmod(0.5 + static_cast<double>(looked) * factor, 1.0); };
      if (inside({box.low.x + spread(0.7548776662466927) * side, box.low.y + spread(0.5698402909980532) * side}))
        ++found;
    }
  }
  return looked == 0 ? 0.0 : 4.0 / std::numbers::sqrt3 * all * static_cast<double>(found) / static_cast<double>(looked);
}

}  // namespace dobra::mesh::sizing
