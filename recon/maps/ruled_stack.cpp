#include "recon/maps/ruled_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/base/parallel.h"

namespace recon::maps {

namespace {

/// Strips in a block: few enough to look through, enough that the boxes take little room.
constexpr std::size_t block_size = 24;

/// Distance of p from the line from a to b, m: positive on the right-hand side of travel; 0 for no line.
double right_of_line(geom::Point a, geom::Point b, geom::Point p) {
  const geom::Vector along = b - a;
  const double squared = geom::length_squared(along);
  return squared > 0.0 ? geom::cross(p - a, along) / std::sqrt(squared) : 0.0;
}

/// Does p lie farther to the right of the line than the tolerance?
bool is_right_of(geom::Point a, geom::Point b, geom::Point p, double tolerance) {
  const geom::Vector along = b - a;
  const double cross = geom::cross(p - a, along);
  return cross > 0.0 && cross * cross > tolerance * tolerance * geom::length_squared(along);
}

/// Is the quadrangle turned round at one of its corners, by more than rounding? Its Jacobian is bilinear, so elsewhere
/// it is not either.
bool is_folded(geom::Point a, geom::Point b, geom::Point c, geom::Point d, double tolerance) {
  const auto turned = [&](geom::Vector v, geom::Vector w) {
    const double cross = geom::cross(v, w);
    return cross > 0.0 && cross > tolerance * (std::abs(v.x) + std::abs(v.y) + std::abs(w.x) + std::abs(w.y));
  };
  return turned(b - a, c - b) || turned(c - b, d - c) || turned(d - c, a - d) || turned(a - d, b - a);
}

/// The rulings of a band: at the corners of both lines, those at one place in one.
std::vector<Rulings::Corners> rulings_between(const std::vector<double>& upper, const std::vector<double>& lower,
                                              double least) {
  const auto last_upper = static_cast<std::uint32_t>(upper.size() - 1);
  const auto last_lower = static_cast<std::uint32_t>(lower.size() - 1);
  std::vector<Rulings::Corners> rulings;
  rulings.reserve(upper.size() + lower.size());
  Rulings::Corners at;
  for (double next = upper.front();; next = std::min(at.upper < last_upper ? upper[at.upper + 1] : infinity,
                                                     at.lower < last_lower ? lower[at.lower + 1] : infinity)) {
    while (at.upper < last_upper && upper[at.upper + 1] <= next + least) ++at.upper;
    while (at.lower < last_lower && lower[at.lower + 1] <= next + least) ++at.lower;
    const double top = upper[at.upper];
    const double bottom = lower[at.lower];
    at.part = bottom > top + least   ? (bottom - top) / (upper[at.upper + 1] - top)
              : top > bottom + least ? -(top - bottom) / (lower[at.lower + 1] - bottom)
                                     : 0.0;
    rulings.push_back(at);
    if (at.upper == last_upper && at.lower == last_lower) break;
  }
  return rulings;
}

geom::SegmentTree tree_of(const std::vector<geom::Point>& points) {
  std::vector<geom::Segment> segments;
  segments.reserve(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) segments.push_back({points[i], points[i + 1]});
  return geom::SegmentTree(std::move(segments));
}

}  // namespace

Rulings::Rulings(std::vector<std::vector<double>> places) : u(std::move(places)) {
  least = 1e-13 * (u.front().back() - u.front().front());
  bands.resize(u.size() - 1);
  dobra::base::parallel_for(bands.size(), [&](std::size_t k) { bands[k] = rulings_between(u[k], u[k + 1], least); });
  // Blocks end at the same places in all bands, so that they form a grid; about as many strips in each.
  std::size_t strips = 0;
  for (const std::vector<Corners>& band : bands) strips += band.size() - 1;
  const std::size_t count = std::max<std::size_t>(1, strips / (bands.size() * block_size));
  std::vector<double> sample;
  for (const std::vector<double>& line : u) {
    for (std::size_t i = 0; i < line.size(); i += block_size / 2) sample.push_back(line[i]);
  }
  std::sort(sample.begin(), sample.end());
  blocks.assign(bands.size(), {});
  dobra::base::parallel_for(bands.size(), [&](std::size_t k) {
    std::uint32_t ruling = 0;
    const auto last = static_cast<std::uint32_t>(bands[k].size() - 1);
    for (std::size_t b = 0; b < count; ++b) {
      const double cut = sample[b * sample.size() / count];
      while (b > 0 && ruling < last && place(k, ruling) < cut) ++ruling;
      blocks[k].push_back(ruling);
    }
    blocks[k].push_back(last);
  });
}

[[gnu::always_inline]] inline RuledStack::Ruling RuledStack::ruling(const Band& band, std::uint32_t i) const {
  const Rulings::Corners at = band.rulings[i];
  const geom::Point* top = band.top + at.upper;
  const geom::Point* bottom = band.bottom + at.lower;
  Ruling ends{*top, *bottom};
  if (at.part > 0.0) {
    ends.top = geom::interpolate(top[0], top[1], at.part);
  } else if (at.part < 0.0) {
    ends.bottom = geom::interpolate(bottom[0], bottom[1], -at.part);
  }
  return ends;
}

RuledStack::RuledStack(std::shared_ptr<const Rulings> rulings, std::vector<std::vector<geom::Point>> points, double by,
                       double tolerance)
    : rulings_(std::move(rulings)), points_(std::move(points)), tolerance_(tolerance) {
  // One direction for all bands, so that the strips beyond the ends leave no gap between bands.
  for (const std::vector<geom::Point>& line : points_) {
    left_ = left_ + geom::normalised(line.front() - line[1]);
    right_ = right_ + geom::normalised(line.back() - line[line.size() - 2]);
  }
  const auto reaching = [&](geom::Vector sum, geom::Vector otherwise) {
    return by * geom::normalised(geom::length(sum) > 0.1 ? sum : otherwise);
  };
  left_ = reaching(left_, points_.front().front() - points_.front()[1]);
  right_ = reaching(right_, points_.front().back() - points_.front()[points_.front().size() - 2]);
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    bands_.push_back({rulings_->bands[k].data(), static_cast<std::uint32_t>(rulings_->bands[k].size()),
                      points_[k].data(), points_[k + 1].data()});
  }
  build_blocks();
  top_ = tree_of(points_.front());
  bottom_ = tree_of(points_.back());
}

void RuledStack::build_blocks() {
  const std::size_t bands = rulings_->bands.size();
  const std::size_t count = rulings_->block_count();
  std::vector<geom::Box> boxes(bands * count);
  std::vector<geom::Box> folds(bands * count);  // of the folded strips of a block
  std::vector<std::optional<geom::Point>> first(bands);
  dobra::base::parallel_for(bands, [&](std::size_t k) {
    const std::vector<std::uint32_t>& starts = rulings_->blocks[k];
    Ruling left = ruling(bands_[k], 0);
    for (std::size_t b = 0; b < count; ++b) {
      geom::Box box;
      for (std::uint32_t i = starts[b]; i < starts[b + 1]; ++i) {
        const Ruling right = ruling(bands_[k], i + 1);
        for (const geom::Point p : {left.top, left.bottom, right.top, right.bottom}) box.add(p);
        if (is_folded(left.top, right.top, right.bottom, left.bottom, tolerance_)) {
          for (const geom::Point p : {left.top, left.bottom, right.top, right.bottom}) folds[k * count + b].add(p);
          if (!first[k]) first[k] = geom::midpoint(left.top, right.bottom);
        }
        left = right;
      }
      boxes[k * count + b] = box;
    }
  });
  for (const auto& place : first) {
    if (!folded_) folded_ = place;
  }
  boxes_ = geom::BoxPyramid(bands, count, std::move(boxes));
  doubtful_.assign(bands * count, 0);
  for (const geom::Box& fold : folds) {
    if (fold.empty()) continue;
    boxes_.visit(fold.grown(4.0 * tolerance_),
                 [&](std::size_t band, std::size_t block) { doubtful_[band * count + block] = 1; });
  }
}

RuledStack::Strip RuledStack::strip(Cell cell) const {
  const Band& band = bands_[cell.second];
  const auto moved = [](Ruling at, geom::Vector by) { return Ruling{at.top + by, at.bottom + by}; };
  if (cell.first == 0) {
    const Ruling end = ruling(band, 0);
    return {moved(end, left_), end};
  }
  const Ruling left = ruling(band, cell.first - 1);
  return {left, cell.first == band.count ? moved(left, right_) : ruling(band, cell.first)};
}

std::uint32_t RuledStack::strip_of(std::size_t band, double u) const {
  std::uint32_t low = 0;
  std::uint32_t high = ruling_count(band);  // the first ruling behind u is in [low, high]
  while (low < high) {
    const std::uint32_t middle = (low + high) / 2;
    if (rulings_->place(band, middle) > u) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

double RuledStack::middle_of(Cell cell) const {
  if (cell.first == 0) return -infinity;
  if (cell.first == ruling_count(cell.second)) return infinity;
  return 0.5 * (rulings_->place(cell.second, cell.first - 1) + rulings_->place(cell.second, cell.first));
}

namespace {

/// Is p beyond a ruling of a strip, on the side to which `outwards` points along the band? Rulings run down. Where the
/// two lines meet, a ruling has no direction, and the line of the band stands for it.
bool is_beyond(geom::Point top, geom::Point bottom, geom::Vector outwards, double turn, geom::Point p,
               double tolerance) {
  if (geom::length_squared(bottom - top) > tolerance * tolerance)
    return turn > 0.0 ? is_right_of(top, bottom, p, tolerance) : is_right_of(bottom, top, p, tolerance);
  const double out = geom::dot(p - top, outwards);
  return out > 0.0 && out * out > tolerance * tolerance * geom::length_squared(outwards);
}

double metres_beyond(geom::Point top, geom::Point bottom, geom::Vector outwards, double turn, geom::Point p,
                     double tolerance) {
  if (geom::length_squared(bottom - top) > tolerance * tolerance) return turn * right_of_line(top, bottom, p);
  const double length = geom::length(outwards);
  return length > 0.0 ? geom::dot(p - top, outwards) / length : 0.0;
}

}  // namespace

// Rulings run down and lines to the right, so that outside is right of the left ruling and left of the right one.

bool RuledStack::beyond_upper(const Strip& at, geom::Point p) const {
  return is_right_of(at.right.top, at.left.top, p, tolerance_);
}

bool RuledStack::beyond_lower(const Strip& at, geom::Point p) const {
  return is_right_of(at.left.bottom, at.right.bottom, p, tolerance_);
}

bool RuledStack::holds(const Strip& at, geom::Point p) const {
  const geom::Vector along = at.right.top - at.left.top;
  return !is_beyond(at.left.top, at.left.bottom, -along, 1.0, p, tolerance_) &&
         !is_beyond(at.right.top, at.right.bottom, along, -1.0, p, tolerance_) && !beyond_upper(at, p) &&
         !beyond_lower(at, p);
}

double RuledStack::beyond(Cell cell, const Strip& at, std::size_t side, geom::Point p) const {
  const geom::Vector along = at.right.top - at.left.top;
  switch (side) {
    case 0:
      return cell.first == 0 ? -infinity : metres_beyond(at.left.top, at.left.bottom, -along, 1.0, p, tolerance_);
    case 1:
      return cell.first == ruling_count(cell.second)
                 ? -infinity
                 : metres_beyond(at.right.top, at.right.bottom, along, -1.0, p, tolerance_);
    case 2:
      return cell.second == 0 ? -infinity : -right_of_line(at.left.top, at.right.top, p);
    default:
      return cell.second + 1 == bands_.size() ? -infinity : right_of_line(at.left.bottom, at.right.bottom, p);
  }
}

/// A few strips along the band towards p; Never: not there yet.  @pre `at` is the strip of `cell`.
RuledStack::End RuledStack::step_along(geom::Point p, Cell& cell, Strip& at) const {
  constexpr int most_steps = 8;
  const Band& band = bands_[cell.second];
  const auto beyond_left = [&] {
    return is_beyond(at.left.top, at.left.bottom, at.left.top - at.right.top, 1.0, p, tolerance_);
  };
  const auto beyond_right = [&] {
    return is_beyond(at.right.top, at.right.bottom, at.right.top - at.left.top, -1.0, p, tolerance_);
  };
  // A ruling that has just been passed is not looked at again; where it has no length each strip judges for itself.
  const auto arrived = [&](const Ruling& passed) {
    return geom::length_squared(passed.bottom - passed.top) > tolerance_ * tolerance_ ? End::Inside : End::Beside;
  };
  if (cell.first > 0 && beyond_left()) {
    for (int step = 0; step < most_steps; ++step) {
      at.right = at.left;
      if (--cell.first == 0) {
        at = strip(cell);
        return End::Beside;
      }
      at.left = ruling(band, cell.first - 1);
      if (!beyond_left()) return arrived(at.right);
    }
    return End::Never;
  }
  if (cell.first == band.count) return End::Beside;
  if (!beyond_right()) return cell.first > 0 ? End::Inside : End::Beside;
  for (int step = 0; step < most_steps; ++step) {
    at.left = at.right;
    if (++cell.first == band.count) {
      at = strip(cell);
      return End::Beside;
    }
    at.right = ruling(band, cell.first);
    if (!beyond_right()) return arrived(at.left);
  }
  return End::Never;
}

/// Along the band to the strip between whose rulings p lies; far ahead by the place that p should have.
/// @pre `at` is the strip of `cell`.
RuledStack::End RuledStack::along_band(geom::Point p, Cell& cell, Strip& at) const {
  constexpr int most_leaps = 12;
  for (int leap = 0; leap <= most_leaps; ++leap) {
    const End end = step_along(p, cell, at);
    if (end != End::Never) return end;
    const double before = beyond(cell, at, 0, p);
    const double width = -before - beyond(cell, at, 1, p);
    if (!(width > 0.0)) continue;
    const double from = rulings_->place(cell.second, cell.first - 1);
    const double to = rulings_->place(cell.second, cell.first);
    const std::uint32_t last = ruling_count(cell.second) - 1;
    cell.first = std::clamp<std::uint32_t>(strip_of(cell.second, from - before / width * (to - from)), 1, last);
    at = strip(cell);
  }
  return End::Never;
}

/// From strip to strip towards p, until no side has p beyond it. Above the first line and below the last one the
/// rulings go on.
RuledStack::End RuledStack::walk(geom::Point p, Cell& cell, Strip& at) const {
  const std::size_t bands = bands_.size();
  for (std::size_t turn = 0; turn < 16 + 2 * bands; ++turn) {
    const End end = along_band(p, cell, at);
    if (end == End::Never) return end;
    const bool up = beyond_upper(at, p);
    const bool down = beyond_lower(at, p);
    if (up && cell.second > 0) {
      const double middle = middle_of(cell);
      cell.first = strip_of(--cell.second, middle);
      at = strip(cell);
    } else if (down && cell.second + 1 < bands) {
      const double middle = middle_of(cell);
      cell.first = strip_of(++cell.second, middle);
      at = strip(cell);
    } else {
      return up || down ? End::Beside : end;
    }
  }
  return End::Never;
}

/// Of the strips that hold p within the tolerance, the first: so that the way there does not matter.
void RuledStack::to_first(geom::Point p, Cell& cell, Strip& at) const {
  while (cell.second > 0 && !is_right_of(at.left.top, at.right.top, p, tolerance_)) {
    Cell above{strip_of(cell.second - 1, middle_of(cell)), cell.second - 1};
    Strip there = strip(above);
    if (along_band(p, above, there) == End::Never || is_outer(above) || !holds(there, p)) break;
    cell = above;
    at = there;
  }
  // Only where p is as near to the left ruling as the tolerance (and some rounding) the strip before can hold it.
  while (cell.first > 1 && !is_right_of(at.left.bottom, at.left.top, p, 4.0 * tolerance_)) {
    const Strip before{ruling(bands_[cell.second], cell.first - 2), at.left};
    if (!holds(before, p)) break;
    --cell.first;
    at = before;
  }
}

bool RuledStack::doubtful(Cell cell) const {
  if (!folded_) return false;
  const std::vector<std::uint32_t>& starts = rulings_->blocks[cell.second];
  const auto after = std::lower_bound(starts.begin() + 1, starts.end() - 1, cell.first);
  return doubtful_[cell.second * rulings_->block_count() + static_cast<std::size_t>(after - starts.begin() - 1)] != 0;
}

std::optional<Cell> RuledStack::first_holder(geom::Point p, Strip& at) const {
  std::optional<Cell> first;
  const auto before = [](Cell a, Cell b) { return a.second < b.second || (a.second == b.second && a.first < b.first); };
  boxes_.visit(geom::Box{p, p}.grown(tolerance_), [&](std::size_t band, std::size_t block) {
    const std::vector<std::uint32_t>& starts = rulings_->blocks[band];
    Cell cell{starts[block] + 1, static_cast<std::uint32_t>(band)};
    if (cell.first > starts[block + 1]) return;
    Strip there = strip(cell);
    while (!first || before(cell, *first)) {
      if (holds(there, p)) {
        first = cell;
        at = there;
      }
      if (cell.first == starts[block + 1]) return;
      there = {there.right, ruling(bands_[band], cell.first + 1)};
      ++cell.first;
    }
  });
  return first;
}

Spot RuledStack::outside(geom::Point p, Strip& at) const {
  const auto any = [](std::size_t) { return true; };
  const auto bands = static_cast<std::uint32_t>(bands_.size());
  const auto nearest_top = *top_.nearest(p, any);
  const auto nearest_bottom = *bottom_.nearest(p, any);
  double squared = nearest_top.squared;
  Cell cell{strip_of(0, rulings_->u.front()[nearest_top.index]), 0};
  if (nearest_bottom.squared < squared) {
    squared = nearest_bottom.squared;
    cell = {strip_of(bands - 1, rulings_->u.back()[nearest_bottom.index]), bands - 1};
  }
  for (std::uint32_t k = 1; k < bands; ++k) {
    for (const auto& [end, strip] :
         {std::pair(points_[k].front(), 1U), std::pair(points_[k].back(), ruling_count(k) - 1)}) {
      const double to_end = geom::length_squared(p - end);
      if (to_end >= squared) continue;
      squared = to_end;
      cell = {strip, k};
    }
  }
  const Cell nearest = cell;
  at = strip(cell);
  if (walk(p, cell, at) != End::Never) return {cell, std::sqrt(squared), Foot::InColumn};
  at = strip(nearest);
  return {nearest, std::sqrt(squared), Foot::NoColumn};
}

Spot RuledStack::locate(geom::Point p, Held& near) const {
  auto& [cell, at] = near;
  const End end = knows(cell) ? walk(p, cell, at) : End::Never;
  const bool inside = end == End::Inside || (end == End::Beside && !is_outer(cell) && holds(at, p));
  if (inside && !doubtful(cell)) {
    to_first(p, cell, at);
    return {cell, 0.0, Foot::InColumn};
  }
  if (const auto first = first_holder(p, at)) {
    cell = *first;
    return {cell, 0.0, Foot::InColumn};
  }
  const Spot spot = outside(p, at);
  cell = spot.cell;
  return spot;
}

/// With e = T1 - T0, g = B0 - T0, h = (B1 - B0) - e and d = p - T0: p is on the line across at `down` = v where
/// (d - v g) x (e + v h) = 0, a quadratic in v.
StripPlace RuledStack::place_in(const Strip& at, geom::Point p) {
  const geom::Vector e = at.right.top - at.left.top;
  const geom::Vector g = at.left.bottom - at.left.top;
  const geom::Vector h = (at.right.bottom - at.left.bottom) - e;
  const geom::Vector d = p - at.left.top;
  const double a = -geom::cross(g, h);
  const double b = geom::cross(d, h) - geom::cross(g, e);
  const double c = geom::cross(d, e);
  const auto across_at = [&](double v) {
    const geom::Vector line = e + v * h;
    const double squared = geom::length_squared(line);
    return squared > 0.0 ? geom::dot(d - v * g, line) / squared : 0.5;
  };
  // The roots in a form that does not cancel; of the two, the one nearer to the quadrangle.
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
  const double q = -0.5 * (b + (b < 0.0 ? -root : root));
  StripPlace best;
  double least = infinity;
  const auto consider = [&](double v) {
    const double u = across_at(v);
    const double beside = std::max({0.0, -u, u - 1.0, -v, v - 1.0});
    if (!std::isfinite(u) || !(beside < least)) return;
    least = beside;
    best = {u, v};
  };
  if (q != 0.0) consider(c / q);
  if (least > 0.0 && a != 0.0) consider(q / a);
  if (least == infinity) return {across_at(0.0), 0.0};  // a strip without height
  // One step of Newton takes away what the square root has lost.
  const geom::Vector off = (d - best.down * g) - best.across * (e + best.down * h);
  const geom::Vector across = e + best.down * h;
  const geom::Vector down = g + best.across * h;
  const double area = geom::cross(across, down);
  if (area != 0.0) {
    const double per_area = 1.0 / area;
    best.across += geom::cross(off, down) * per_area;
    best.down += geom::cross(across, off) * per_area;
  }
  return best;
}

double RuledStack::jacobian(const Strip& at, StripPlace place) {
  const geom::Vector top = at.right.top - at.left.top;
  const geom::Vector left = at.left.bottom - at.left.top;
  const geom::Vector change = (at.right.bottom - at.left.bottom) - top;
  const geom::Vector across = top + place.down * change;
  const geom::Vector down = left + place.across * change;
  const double area = geom::cross(across, down);
  const auto size = [&](geom::Vector v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(change.x) + std::abs(change.y);
  };
  return std::abs(area) > 1e-12 * size(top) * size(left) ? area : 0.0;
}

}  // namespace recon::maps
