#include "shared/surf/paper/chart_quadtree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/surf/measure.h"

namespace dobra::surf::paper {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Box;
using geom::Point;
using geom::Vector3;

namespace {

std::uint32_t cells_along(double length, double largest) {
  constexpr double slack = 1e-9;
  return static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / largest * (1.0 - slack))));
}

}  // namespace

Result<ChartQuadtree> ChartQuadtree::build(const mesh::ChartInput& input, const QuadtreeOptions& options,
                                           const base::Progress& progress) {
  if (!(options.largest > 0.0) || !(options.turn > 0.0)) {
    return Error{ErrorCode::InvalidOption, "the largest size and the greatest turn of the normal must be positive"};
  }
  ChartQuadtree tree(input, options);
  tree.box_ = geom::box_of(input.chart.points);
  if (!(tree.box_.width() > 0.0) || !(tree.box_.height() > 0.0)) {
    return Error{ErrorCode::CannotMesh, "the loops enclose nothing"};
  }
  const Point middle = tree.box_.centre();
  const double along_u = length(input.surface, {tree.box_.low.x, middle.y}, {tree.box_.high.x, middle.y});
  const double along_v = length(input.surface, {middle.x, tree.box_.low.y}, {middle.x, tree.box_.high.y});
  const auto scale = [](double real, double chart) { return real > 0.0 ? real / chart : 1.0; };
  tree.scale_ = {scale(along_u, tree.box_.width()), scale(along_v, tree.box_.height())};
  if (along_u / options.largest * along_v / options.largest > static_cast<double>(options.most_cells)) {
    return Error{ErrorCode::TooManyElements,
                 fmt::format("a largest size of {:.3g} m needs more than {} cells; raise it", options.largest,
                             options.most_cells)};
  }
  tree.count_ = {cells_along(along_u, options.largest), cells_along(along_v, options.largest)};
  tree.make_first_cells();
  for (;;) {
    DOBRA_TRY(bool changed, tree.refine(progress));
    if (options.nodes && tree.refine_interior()) changed = true;
    if (!changed) break;
  }
  for (CellIndex c = 0; c < tree.cells_.size(); ++c) {
    if (tree.is_leaf(c) && tree.cells_[c].nodes.size() > 1 && options.nodes) tree.crowded_.push_back(c);
  }
  tree.lattice_.clear();
  tree.input_ = nullptr;
  return tree;
}

void ChartQuadtree::make_first_cells() {
  const std::uint32_t side = span(0);
  for (std::uint32_t j = 0; j < count_[1]; ++j) {
    for (std::uint32_t i = 0; i < count_[0]; ++i) cells_.push_back({.x = i * side, .y = j * side});
  }
  for (CellIndex c = 0; c < cells_.size(); ++c) measure(c);
  for (std::uint32_t n = 0; n < input_->chart.points.size(); ++n) {
    cells_[leaf_at(input_->chart.points[n])].nodes.push_back(n);
  }
}

Point ChartQuadtree::position(std::uint32_t x, std::uint32_t y) const {
  const auto whole = [&](std::uint32_t count) { return static_cast<double>(count) * span(0); };
  return {std::lerp(box_.low.x, box_.high.x, x / whole(count_[0])),
          std::lerp(box_.low.y, box_.high.y, y / whole(count_[1]))};
}

Box ChartQuadtree::box(CellIndex cell) const {
  const Cell& c = cells_[cell];
  return {position(c.x, c.y), position(c.x + span(c.level), c.y + span(c.level))};
}

std::vector<ChartQuadtree::CellIndex> ChartQuadtree::leaves() const {
  std::vector<CellIndex> found;
  for (CellIndex c = 0; c < cells_.size(); ++c) {
    if (is_leaf(c)) found.push_back(c);
  }
  return found;
}

const ChartQuadtree::Lattice& ChartQuadtree::lattice(std::uint32_t x, std::uint32_t y) {
  const auto [found, is_new] = lattice_.try_emplace((std::uint64_t{x} << 32U) | y);
  if (is_new) {
    const Point uv = position(x, y);
    const Jet jet = input_->surface.jet(uv);
    found->second.at = jet.at;
    const auto own = normal(jet);
    const auto limit = own ? own : normal(input_->surface, uv);
    if (limit) found->second.normal = *limit;
  }
  return found->second;
}

void ChartQuadtree::measure(CellIndex cell) {
  const Cell c = cells_[cell];
  const std::uint32_t side = span(c.level), half = side / 2;
  const auto at = [&](std::uint32_t dx, std::uint32_t dy) { return lattice(c.x + dx, c.y + dy).at; };
  const geom::Point3 centre = at(half, half);
  const double along = distance(at(0, half), centre) + distance(centre, at(side, half));
  const double across = distance(at(half, 0), centre) + distance(centre, at(half, side));
  cells_[cell].size = static_cast<float>(0.5 * (along + across));
  cells_[cell].longest = static_cast<float>(std::max(along, across));
}

void ChartQuadtree::split(CellIndex cell) {
  const auto first = static_cast<CellIndex>(cells_.size());
  const Cell parent = cells_[cell];
  const std::uint32_t half = span(parent.level + 1);
  for (std::uint32_t k = 0; k < 4; ++k) {
    cells_.push_back({.x = parent.x + (k % 2) * half, .y = parent.y + (k / 2) * half, .level = parent.level + 1});
  }
  for (std::uint32_t k = 0; k < 4; ++k) measure(first + k);
  cells_[cell].first_child = first;
  cells_[cell].nodes.clear();
  for (const std::uint32_t n : parent.nodes) cells_[leaf_at(input_->chart.points[n])].nodes.push_back(n);
}

ChartQuadtree::CellIndex ChartQuadtree::leaf_at_lattice(std::uint32_t x, std::uint32_t y) const {
  const std::uint32_t side = span(0);
  CellIndex cell = std::min(y / side, count_[1] - 1) * count_[0] + std::min(x / side, count_[0] - 1);
  while (!is_leaf(cell)) {
    const Cell& c = cells_[cell];
    const std::uint32_t half = span(c.level + 1);
    cell = c.first_child + (x >= c.x + half ? 1U : 0U) + (y >= c.y + half ? 2U : 0U);
  }
  return cell;
}

ChartQuadtree::CellIndex ChartQuadtree::leaf_at(Point uv) const {
  // What lies on a line between cells but for rounding is on it.
  const auto on_lattice = [&](double value, double low, double width, std::uint32_t count) {
    const double whole = static_cast<double>(count) * span(0);
    constexpr double rounding = 1e-9;
    const double at = std::floor((value - low) / width * whole + rounding * whole);
    return static_cast<std::uint32_t>(std::clamp(at, 0.0, whole - 1.0));
  };
  return leaf_at_lattice(on_lattice(uv.x, box_.low.x, box_.width(), count_[0]),
                         on_lattice(uv.y, box_.low.y, box_.height(), count_[1]));
}

void ChartQuadtree::for_leaves(const Box& wanted, const std::function<void(CellIndex)>& visit) const {
  const auto first = [&](double value, double low, double width, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(std::floor((value - low) / width * count), 0.0, count - 1.0));
  };
  std::array<CellIndex, 64> few{};
  std::vector<CellIndex> more;
  std::size_t open = 0;
  const auto push = [&](CellIndex c) {
    if (open < few.size()) {
      few[open++] = c;
    } else {
      more.push_back(c);
    }
  };
  const std::uint32_t i1 = first(wanted.high.x, box_.low.x, box_.width(), count_[0]);
  const std::uint32_t j1 = first(wanted.high.y, box_.low.y, box_.height(), count_[1]);
  for (std::uint32_t j = first(wanted.low.y, box_.low.y, box_.height(), count_[1]); j <= j1; ++j) {
    for (std::uint32_t i = first(wanted.low.x, box_.low.x, box_.width(), count_[0]); i <= i1; ++i) {
      push(j * count_[0] + i);
      while (open > 0 || !more.empty()) {
        CellIndex c = 0;
        if (!more.empty()) {
          c = more.back();
          more.pop_back();
        } else {
          c = few[--open];
        }
        if (is_leaf(c)) {
          visit(c);
          continue;
        }
        for (CellIndex k = 4; k-- > 0;) {
          if (box(cells_[c].first_child + k).overlaps(wanted)) push(cells_[c].first_child + k);
        }
      }
    }
  }
}

bool ChartQuadtree::has_kink(const Box& cell) const {
  const Breaks& kinks = input_->surface.kinks();
  const auto inside = [](const std::vector<double>& at, double low, double high) {
    return std::any_of(at.begin(), at.end(), [&](double k) { return k > low && k < high; });
  };
  return inside(kinks.u, cell.low.x, cell.high.x) || inside(kinks.v, cell.low.y, cell.high.y);
}

/// Rule b. A kink is no bend: the sides of triangles run along it.
bool ChartQuadtree::bends(CellIndex cell) {
  const Cell c = cells_[cell];
  const std::uint32_t side = span(c.level);
  const Breaks& kinks = input_->surface.kinks();
  const bool kinked = kinks.u.size() > 2 || kinks.v.size() > 2;
  if (kinked && has_kink(box(cell))) return false;
  const Vector3 centre = lattice(c.x + side / 2, c.y + side / 2).normal;
  if (centre == Vector3{}) return false;
  const double least = std::cos(options_.turn * std::numbers::pi / 180.0);
  for (std::uint32_t k = 0; k < 4; ++k) {
    Vector3 corner = lattice(c.x + (k % 2) * side, c.y + (k / 2) * side).normal;
    if (kinked) {
      constexpr double beside = 1e-6;  // of the way to the centre
      const Point at = position(c.x + (k % 2) * side, c.y + (k / 2) * side);
      const auto inner = normal(input_->surface.jet(geom::interpolate(at, box(cell).centre(), beside)));
      corner = inner ? *inner : Vector3{};
    }
    if (corner != Vector3{} && dot(centre, corner) < least) return true;
  }
  return false;
}

bool ChartQuadtree::finer_neighbour(CellIndex cell) const {
  const Cell& c = cells_[cell];
  const std::uint32_t side = span(c.level);
  const std::uint32_t right = count_[0] * span(0), top = count_[1] * span(0);
  // The finest leaf along a side is found at its quarter places if it is finer by more than one level.
  const auto too_fine = [&](std::uint32_t x, std::uint32_t y) {
    return cells_[leaf_at_lattice(x, y)].level > c.level + 1;
  };
  const std::uint32_t quarter = std::max(1U, side / 4);
  for (std::uint32_t at = 0; at < side; at += quarter) {
    if (c.x > 0 && too_fine(c.x - 1, c.y + at)) return true;
    if (c.x + side < right && too_fine(c.x + side, c.y + at)) return true;
    if (c.y > 0 && too_fine(c.x + at, c.y - 1)) return true;
    if (c.y + side < top && too_fine(c.x + at, c.y + side)) return true;
  }
  return false;
}

bool ChartQuadtree::wants_split(CellIndex cell) {
  const Cell& c = cells_[cell];
  if (c.level >= options_.most_levels) return false;
  if (options_.nodes && c.nodes.size() > 1) return true;
  if (c.longest > options_.largest * (1.0 + 1e-6)) return true;
  for (const auto& request : input_->chart.sizes) {
    if (c.longest > request.size && leaf_at(request.at) == cell) return true;
  }
  return bends(cell) || finer_neighbour(cell);
}

Result<bool> ChartQuadtree::refine(const base::Progress& progress) {
  bool changed = false;
  for (;;) {
    bool again = false;
    for (CellIndex c = 0; c < cells_.size(); ++c) {  // children come later in the same run
      if (!is_leaf(c) || !wants_split(c)) continue;
      split(c);
      again = changed = true;
      if (cells_.size() <= options_.most_cells) continue;
      return Error{ErrorCode::TooManyElements,
                   fmt::format("sizes by a turn of {} degrees need more than {} cells; raise it", options_.turn,
                               options_.most_cells)};
    }
    DOBRA_TRY_VOID(progress.check());
    if (!again) return changed;
  }
}

/// Rule c.
bool ChartQuadtree::refine_interior() {
  std::uint32_t coarsest = options_.most_levels;
  for (const Cell& c : cells_) {
    if (!c.nodes.empty()) coarsest = std::min(coarsest, c.level);
  }
  bool changed = false;
  for (CellIndex c = 0; c < cells_.size(); ++c) {
    if (!is_leaf(c) || cells_[c].level >= coarsest) continue;
    split(c);
    changed = true;
  }
  return changed;
}

}  // namespace dobra::surf::paper
