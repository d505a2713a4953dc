// Up to which distance the parts of a base cannot meet each other's parallels.

#include <algorithm>
#include <bit>
#include <cmath>

#include "shared/offset/general/clearance.h"
#include "shared/offset/kernel/chain_tree.h"

namespace dobra::offset::general {

namespace {

constexpr std::size_t run = 4;  // segments

double box_gap(const FloatBox& a, const FloatBox& b) {
  const double x = std::max({a.low_x - b.high_x, b.low_x - a.high_x, 0.0F});
  const double y = std::max({a.low_y - b.high_y, b.low_y - a.high_y, 0.0F});
  return x * x + y * y;
}

/// Where the directions of segments lie within a quarter turn, nothing to their right at any distance meets anything to
/// their left: what joins two places of the base runs within an eighth turn of the middle direction, the sum of two
/// normals within an eighth of the one across it.
bool within_quarter(std::uint64_t directions) {
  // Some 48 bits in a row are clear; each direction has a bit to spare on both sides.
  std::uint64_t clear = ~directions;
  for (const int shift : {1, 2, 4, 8, 16}) clear &= std::rotr(clear, shift);  // then 32 in a row
  return (clear & std::rotr(clear, 16)) != 0;
}

}  // namespace

/// True if from an end of the base a straight way leads out that keeps D from it: all places on it that are nearer than
/// D have the end itself as their nearest base point. The way starts into a disc of radius D that touches the end and
/// holds none of the base.
bool Clearance::has_escape_ray(bool from_last, double d) const {
  const std::size_t own = from_last ? base_.segment_count() - 1 : 0;
  const Flat end = flat(from_last ? base_.end(own) : base_.start(own));
  const Flat ahead = flat(from_last ? base_.headings[own] : -base_.headings[own]);
  const double reach =
      1.01 * d + 1e-12 * base_.size;  // well beyond D, so that rounding tells nothing near the end either
  constexpr int tries =
      13;  // directions up to 78 degrees from straight on, the straightest first: the end's own segment lies behind
  for (int k = 0; k < tries; ++k) {
    const double turn = (k % 2 == 0 ? 1 : -1) * 0.2269 * ((k + 1) / 2);
    const Flat way = std::cos(turn) * ahead + std::sin(turn) * left_of(ahead);
    const Flat first = end + reach * way;
    const auto may_block = [&](const FloatBox& box) {
      const Flat half{0.5 * (double{box.high_x} - box.low_x), 0.5 * (double{box.high_y} - box.low_y)};
      const Flat middle = Flat{box.low_x, box.low_y} + half - first;
      const double along = std::abs(way.x) * half.x + std::abs(way.y) * half.y;
      const double across = std::abs(way.y) * half.x + std::abs(way.x) * half.y;
      return dot(middle, way) + along > -1.001 * reach && std::abs(cross(middle, way)) - across < 1.001 * reach;
    };
    const auto blocks = [&](std::size_t i) {
      if (i == own) return false;
      const Flat a = flat(base_.start(i)) - first;
      const Flat b = flat(base_.end(i)) - first;
      const double limit = reach * reach;
      const auto near = [&](Flat p) {
        return dot(p, way) < 0 ? dot(p, p) < limit : cross(p, way) * cross(p, way) < limit;
      };
      if (near(a) || near(b) || squared_distance(i, first) < limit) return true;
      const double at_a = cross(way, a);
      const double at_b = cross(way, b);
      return (at_a < 0) != (at_b < 0) && dot(a + (at_a / (at_a - at_b)) * (b - a), way) >= 0;
    };
    if (!tree_.any_held(may_block, [&](std::size_t leaf) { return any_of_leaf(leaf, blocks); })) return true;
  }
  return false;
}

double Clearance::find_escape_rays(std::span<const double> distances) const {
  double found = 0;
  for (const double d : distances) {
    if (d > found && has_escape_ray(false, d) && has_escape_ray(true, d)) found = d;
  }
  return found;
}

/// Zero if they cross.
double Clearance::squared_gap_of(std::size_t i, std::size_t j) const {
  const Flat a = flat(base_.start(i));
  const Flat b = flat(base_.end(i));
  const Flat c = flat(base_.start(j));
  const Flat d = flat(base_.end(j));
  if (cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0) return 0;
  return std::min({squared_distance(i, c), squared_distance(i, d), squared_distance(j, a), squared_distance(j, b)});
}

void Clearance::find_gaps(double least, double greatest) {
  double reach = 1;  // of the outline, from the base
  for (std::size_t at = 0; at < corners_.size(); ++at) {
    if (corners_[at] == CornerKind::Mitre) reach = std::max(reach, std::hypot(1.0, base_.half_tans[at]));
    if (corners_[at] == CornerKind::Tangent) reach = std::max(reach, 1.5);
  }
  const double floor = 2 * reach * least;
  const double ceiling = 2 * reach * greatest * (1 + 1e-3);  // so that it counts at the greatest too
  gaps_.assign(blocks_.size(), {});
  if (blocks_.size() < 2) return;
  std::vector<std::uint64_t> directions;
  directions.reserve(base_.segment_count());
  for (const geom::Vector u : base_.headings) directions.push_back(ChainTree::directions_of(flat(u), flat(u)));
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto [far, near] = gaps_about(b, floor, ceiling);
    const double scale = (1 - 1e-6) / (2 * reach);
    const double slack = 1e-12 * base_.size;
    const std::size_t n = base_.segment_count();
    const std::size_t first = b * Block::size;
    const std::size_t last = std::min(n, first + Block::size);
    gaps_[b].alone = scale * (far - slack);
    // Near ones are parted by their directions, those of the segments next to them included.
    const auto parted = [&](std::size_t from, std::size_t to, std::size_t around) {
      const bool whole = from > around && to + around < n;
      const std::size_t start = from > around ? from - around - 1 : 0;
      if (!whole && base_.closed) return false;
      std::uint64_t all = 0;
      for (std::size_t i = start; i < std::min(n, to + around + 1); ++i) all |= directions[i];
      return within_quarter(all);
    };
    bool runs_parted = near >= floor;
    for (std::size_t k = first; k < last && runs_parted; k += run) {
      runs_parted = parted(k, std::min(last, k + run), run);
    }
    if (runs_parted) gaps_[b].harmless = scale * (near - slack);
    if (far >= floor && far > near && parted(first, last, Block::size)) gaps_[b].harmless = scale * (far - slack);
  }
}

/// Distances from a block to all but its neighbours, and from its runs to all but theirs; no matter which above
/// `ceiling` or below `floor`.
std::pair<double, double> Clearance::gaps_about(std::size_t block, double floor, double ceiling) const {
  const std::size_t n = base_.segment_count();
  const std::size_t first = block * Block::size;
  const std::size_t last = std::min(n, first + Block::size);
  const FloatBox& own = blocks_[block].points;
  const auto box = [&](std::size_t i) {
    FloatBox made(flat(base_.start(i)), flat(base_.start(i)), 0);
    made.add(FloatBox(flat(base_.end(i)), flat(base_.end(i)), 0));
    return made;
  };
  const auto apart = [&](std::size_t i, std::size_t j, std::size_t size) {  // not neighbours
    const std::size_t count = (n + size - 1) / size;
    const std::size_t steps = i / size > j / size ? i / size - j / size : j / size - i / size;
    return steps > 1 && !(base_.closed && steps + 1 >= count);
  };
  double far = ceiling * ceiling;
  double near = far;
  const auto note = [&](bool beyond, double squared) {
    near = std::min(near, squared);
    if (beyond) far = std::min(far, squared);
  };
  const auto measure_one = [&](std::size_t i, std::size_t j) { note(apart(i, j, Block::size), squared_gap_of(i, j)); };
  // Likely the nearest ones: the ends of the next runs but one, and blocks.
  for (std::size_t i = first; i < last; i += run) {
    if (i + 2 * run < n) measure_one(i + run - 1, i + 2 * run);
    if (i > run) measure_one(i, i - run - 1);
  }
  if (last + Block::size < n) measure_one(last - 1, last + Block::size);
  if (first > Block::size) measure_one(first, first - Block::size - 1);
  static_assert(run == leaf_size && Block::size == run * BoxTree::width);
  const auto look = [&](std::size_t leaf) {
    const std::size_t other = leaf * run;
    const bool beyond = apart(first, other, Block::size);
    const double& least = beyond ? far : near;
    const FloatBox of_other = tree_.box(leaf);
    const std::size_t end = std::min(n, other + run);
    for (std::size_t own_run = first; own_run < last; own_run += run) {
      if (!apart(own_run, other, run)) continue;
      if (box_gap(tree_.box(own_run / run), of_other) >= least) continue;
      FloatBox others[run];
      for (std::size_t j = other; j < end; ++j) others[j - other] = box(j);
      for (std::size_t i = own_run; i < std::min(last, own_run + run); ++i) {
        const FloatBox of_i = box(i);
        for (std::size_t j = other; j < end; ++j) {
          if (box_gap(of_i, others[j - other]) < least) note(beyond, squared_gap_of(i, j));
        }
      }
    }
    return far < floor * floor;
  };
  for (std::size_t leaf = first / run; leaf * run < last; ++leaf) look(leaf);
  tree_.any_held_from(
      first / run, [&](const FloatBox& other) { return box_gap(own, other) < far; }, look);
  return {std::sqrt(far), std::sqrt(near)};
}

}  // namespace dobra::offset::general
