#include "shared/solid/partition/orthtree.h"

#include <algorithm>
#include <cmath>

namespace dobra::solid::partition {
namespace {

Fill turned_over(Fill fill) { return fill == Fill::Empty ? Fill::Full : fill == Fill::Full ? Fill::Empty : fill; }

}  // namespace

Fill combined(Fill a, Fill b, SetOperation operation) {
  if (operation == SetOperation::Difference) return combined(a, turned_over(b), SetOperation::Intersection);
  const Fill wins = operation == SetOperation::Union ? Fill::Full : Fill::Empty;
  if (a == wins || b == wins) return wins;
  return a == Fill::Partial || b == Fill::Partial ? Fill::Partial : turned_over(wins);
}

template <std::size_t D>
Box<D> Orthtree<D>::box(Node n) const {
  const Record& node = nodes_[n];
  const double part = std::ldexp(1.0, -int{node.level});
  Box<D> box;
  for (std::size_t k = 0; k < D; ++k) {
    box.low[k] = box_.low[k] + size(k) * (part * node.at[k]);
    box.high[k] =
        (node.at[k] + 1U) >> node.level == 0 ? box_.low[k] + size(k) * (part * (node.at[k] + 1.0)) : box_.high[k];
  }
  return box;
}

template <std::size_t D>
std::vector<typename Orthtree<D>::Node> Orthtree<D>::leaves() const {
  std::vector<Node> found;
  collect(0, {}, found);
  return found;
}

template <std::size_t D>
std::size_t Orthtree<D>::count(Fill fill) const {
  return static_cast<std::size_t>(
      std::count_if(nodes_.begin(), nodes_.end(), [&](const Record& node) { return node.fill == fill; }));
}

template <std::size_t D>
typename Orthtree<D>::Node Orthtree<D>::leaf_at(const std::array<double, D>& p) const {
  Node n = 0;
  while (!is_leaf(n)) {
    const Box<D> upper = box(child(n, children - 1));
    std::uint32_t i = 0;
    for (std::size_t k = 0; k < D; ++k) i |= p[k] >= upper.low[k] ? 1U << k : 0U;
    n = child(n, i);
  }
  return n;
}

template <std::size_t D>
typename Orthtree<D>::Node Orthtree<D>::beside(Node n, const std::array<int, D>& way) const {
  std::array<std::uint32_t, D> at = nodes_[n].at;
  const int level = nodes_[n].level;
  for (std::size_t k = 0; k < D; ++k) {
    const std::int64_t next = std::int64_t{at[k]} + way[k];
    if (next < 0 || next >= std::int64_t{1} << level) return none;
    at[k] = static_cast<std::uint32_t>(next);
  }
  // Up to the ancestor that holds both, then down.
  Node m = n;
  const auto holds = [&](Node up) {
    for (std::size_t k = 0; k < D; ++k) {
      if (at[k] >> (level - nodes_[up].level) != nodes_[up].at[k]) return false;
    }
    return true;
  };
  while (!holds(m)) m = nodes_[m].parent;
  while (nodes_[m].level < level && !is_leaf(m)) {
    std::uint32_t i = 0;
    for (std::size_t k = 0; k < D; ++k) i |= (at[k] >> (level - nodes_[m].level - 1) & 1U) << k;
    m = child(m, i);
  }
  return m;
}

/// The leaves below n that touch its side towards `way`: the upper half where that is -1, the lower where it is 1.
template <std::size_t D>
void Orthtree<D>::collect(Node n, const std::array<int, D>& way, std::vector<Node>& found) const {
  if (is_leaf(n)) {
    found.push_back(n);
    return;
  }
  for (std::uint32_t i = 0; i < children; ++i) {
    bool touches = true;
    for (std::size_t k = 0; k < D; ++k) touches = touches && (way[k] == 0 || (way[k] < 0) == ((i >> k & 1U) != 0));
    if (touches) collect(child(n, i), way, found);
  }
}

template <std::size_t D>
std::vector<typename Orthtree<D>::Node> Orthtree<D>::neighbours(Node n) const {
  std::vector<Node> found;
  std::array<int, D> way;
  way.fill(-1);
  while (true) {
    if (std::any_of(way.begin(), way.end(), [](int step) { return step != 0; })) {
      if (const Node m = beside(n, way); m != none) collect(m, way, found);
    }
    std::size_t k = 0;
    while (k < D && way[k] == 1) way[k++] = -1;
    if (k == D) break;
    ++way[k];
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

template <std::size_t D>
Bounds Orthtree<D>::volume() const {
  std::vector<double> full;
  std::vector<double> partial;
  for (const Record& node : nodes_) {
    if (node.level >= full.size()) {
      full.resize(node.level + 1U, 0.0);
      partial.resize(node.level + 1U, 0.0);
    }
    if (node.fill == Fill::Full) full[node.level] += 1.0;
    if (node.fill == Fill::Partial) partial[node.level] += 1.0;
  }
  double whole = 1.0;
  for (std::size_t k = 0; k < D; ++k) whole *= size(k);
  double low = 0.0;
  double open = 0.0;
  for (std::size_t level = full.size(); level-- > 0;) {
    const int power = -static_cast<int>(D * level);
    low += std::ldexp(full[level], power);
    open += std::ldexp(partial[level], power);
  }
  return {whole * low, whole * (low + open)};
}

template <std::size_t D>
void Orthtree<D>::split(Node n) {
  const auto first = static_cast<Node>(nodes_.size());
  const Record up = nodes_[n];
  nodes_[n].fill = Fill::Split;
  nodes_[n].first_child = first;
  for (std::uint32_t i = 0; i < children; ++i) {
    Record down{Fill::Empty, static_cast<std::uint8_t>(up.level + 1), n, none, {}};
    for (std::size_t k = 0; k < D; ++k) down.at[k] = 2 * up.at[k] + (i >> k & 1U);
    nodes_.push_back(down);
  }
}

/// A node whose children are alike is a leaf. Its children are the last of all nodes then.
template <std::size_t D>
void Orthtree<D>::settle(Node n) {
  const Fill first = fill(child(n, 0));
  if (first != Fill::Empty && first != Fill::Full) return;
  for (std::uint32_t i = 1; i < children; ++i) {
    if (fill(child(n, i)) != first) return;
  }
  nodes_.resize(nodes_.size() - children);
  nodes_[n].fill = first;
  nodes_[n].first_child = none;
}

template <std::size_t D>
void Orthtree<D>::copy(Node n, const Orthtree& other, Node from, bool turned) {
  const Fill fill = other.fill(from);
  nodes_[n].fill = turned ? turned_over(fill) : fill;
  if (fill != Fill::Split) return;
  split(n);
  for (std::uint32_t i = 0; i < children; ++i) copy(child(n, i), other, other.child(from, i), turned);
}

template <std::size_t D>
void Orthtree<D>::merge_in(Node n, const Orthtree& a, Node from_a, const Orthtree& b, Node from_b,
                           SetOperation operation) {
  const Fill of_a = a.fill(from_a);
  const Fill of_b = b.fill(from_b);
  if (of_a != Fill::Split && of_b != Fill::Split) {
    nodes_[n].fill = combined(of_a, of_b, operation);
    return;
  }
  // What is homogeneous on one side decides, or leaves the other side as it is.
  const bool difference = operation == SetOperation::Difference;
  const Fill wins = operation == SetOperation::Union ? Fill::Full : Fill::Empty;
  if (of_a == wins || (difference ? of_b == Fill::Full : of_b == wins)) {
    nodes_[n].fill = wins;
    return;
  }
  if (of_a == Fill::Empty || of_a == Fill::Full) return copy(n, b, from_b, difference);
  if (of_b == Fill::Empty || of_b == Fill::Full) return copy(n, a, from_a, false);
  split(n);
  for (std::uint32_t i = 0; i < children; ++i) {
    // A partial leaf is partial in all of its parts.
    merge_in(child(n, i), a, of_a == Fill::Split ? a.child(from_a, i) : from_a, b,
             of_b == Fill::Split ? b.child(from_b, i) : from_b, operation);
  }
  settle(n);
}

template <std::size_t D>
bool Orthtree<D>::alike(Node n, const Orthtree& other, Node m) const {
  if (fill(n) != other.fill(m)) return false;
  for (std::uint32_t i = 0; !is_leaf(n) && i < children; ++i) {
    if (!alike(child(n, i), other, other.child(m, i))) return false;
  }
  return true;
}

template class Orthtree<2>;
template class Orthtree<3>;

}  // namespace dobra::solid::partition
