#include "recon/core/ruled_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon::core {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

geom::Point at(const std::vector<double>& u, const std::vector<geom::Point>& points, double where) {
  const auto next = std::upper_bound(u.begin() + 1, u.end() - 1, where);
  const std::size_t i = static_cast<std::size_t>(next - u.begin()) - 1;
  return geom::interpolate(points[i], points[i + 1], (where - u[i]) / (u[i + 1] - u[i]));
}

std::vector<geom::Point> at_all(const std::vector<double>& u, const std::vector<geom::Point>& points,
                                const std::vector<double>& places) {
  std::vector<geom::Point> result;
  result.reserve(places.size());
  for (const double place : places) result.push_back(at(u, points, place));
  return result;
}

/// Distance of p beyond the left-hand side of the line from a to b, m: positive on the right-hand side of travel.
double right_of_line(geom::Point a, geom::Point b, geom::Point p) {
  const geom::Vector along = b - a;
  const double length = geom::length(along);
  return length > 0.0 ? geom::cross(p - a, along) / length : 0.0;
}

SegmentTree tree_of(const std::vector<geom::Point>& points) {
  std::vector<geom::Segment> segments;
  segments.reserve(points.size() - 3);
  for (std::size_t i = 1; i + 2 < points.size(); ++i) segments.push_back({points[i], points[i + 1]});
  return SegmentTree(std::move(segments));
}

/// Is the quadrangle turned round at one of its corners? Its Jacobian is bilinear, so elsewhere it is not either.
bool is_folded(geom::Point a, geom::Point b, geom::Point c, geom::Point d) {
  const auto turned = [](geom::Point p, geom::Point q, geom::Point r) { return geom::cross(q - p, r - q) > 0.0; };
  return turned(a, b, c) || turned(b, c, d) || turned(c, d, a) || turned(d, a, b);
}

}  // namespace

RuledMap::RuledMap(const std::vector<RuledLine>& lines, const MapOptions& options) {
  DOBRA_CHECK(lines.size() >= 2);
  geom::Box from_box;
  geom::Box to_box;
  for (const RuledLine& line : lines) {
    from_box.add(geom::box_of(line.from));
    to_box.add(geom::box_of(line.to));
  }
  tolerances_ = tolerances_for(from_box, to_box, options);
  const double by = from_box.diagonal() + to_box.diagonal();
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    const RuledLine& top = lines[k];
    const RuledLine& bottom = lines[k + 1];
    Band band;
    std::merge(top.u.begin(), top.u.end(), bottom.u.begin(), bottom.u.end(), std::back_inserter(band.u));
    // Places nearer than rounding are one: a ruling between them would bound a strip without width.
    const double least = 1e-13 * (band.u.back() - band.u.front());
    const auto same = [&](double a, double b) { return b - a <= least; };
    band.u.erase(std::unique(band.u.begin(), band.u.end(), same), band.u.end());
    band.from = {at_all(top.u, top.from, band.u), at_all(bottom.u, bottom.from, band.u), {}, {}};
    band.to = {at_all(top.u, top.to, band.u), at_all(bottom.u, bottom.to, band.u), {}, {}};
    extend(band.from, by);
    extend(band.to, by);
    for (std::size_t i = 0; i + 1 < band.from.top.size(); ++i) {
      const auto fold_of = [&](const Side& s) {
        return is_folded(s.top[i], s.top[i + 1], s.bottom[i + 1], s.bottom[i])
                   ? std::optional(geom::midpoint(s.top[i], s.bottom[i + 1]))
                   : std::nullopt;
      };
      if (!folded_) folded_ = fold_of(band.from);
      if (!folded_target_) folded_target_ = fold_of(band.to);
    }
    bands_.push_back(std::move(band));
  }
}

void RuledMap::extend(Side& side, double by) {
  const auto end_direction = [&](std::size_t inner, std::size_t end) {
    const geom::Vector top = geom::normalised(side.top[end] - side.top[inner]);
    const geom::Vector bottom = geom::normalised(side.bottom[end] - side.bottom[inner]);
    const geom::Vector sum = top + bottom;
    return by * (geom::length(sum) > 0.1 ? geom::normalised(sum) : top);
  };
  const std::size_t last = side.top.size() - 1;
  const geom::Vector left = end_direction(1, 0);
  const geom::Vector right = end_direction(last - 1, last);
  for (std::vector<geom::Point>* points : {&side.top, &side.bottom}) {
    points->insert(points->begin(), points->front() + left);
    points->push_back(points->back() + right);
  }
  side.top_tree = tree_of(side.top);
  side.bottom_tree = tree_of(side.bottom);
}

RuledMap RuledMap::swapped() const {
  RuledMap back = *this;
  for (Band& band : back.bands_) std::swap(band.from, band.to);
  std::swap(back.folded_, back.folded_target_);
  return back;
}

geom::Point RuledMap::point_at(const Side& side, std::size_t strip, Place place) {
  const geom::Point left = geom::interpolate(side.top[strip], side.bottom[strip], place.down);
  const geom::Point right = geom::interpolate(side.top[strip + 1], side.bottom[strip + 1], place.down);
  return geom::interpolate(left, right, place.across);
}

/// With e = T1 - T0, g = B0 - T0, h = (B1 - B0) - e and d = p - T0: p is on the line across at `down` = v where
/// (d - v g) x (e + v h) = 0, a quadratic in v.
RuledMap::Place RuledMap::place_in(const Side& side, std::size_t strip, geom::Point p) {
  const geom::Vector e = side.top[strip + 1] - side.top[strip];
  const geom::Vector g = side.bottom[strip] - side.top[strip];
  const geom::Vector h = (side.bottom[strip + 1] - side.bottom[strip]) - e;
  const geom::Vector d = p - side.top[strip];
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
  Place best;
  double least = infinity;
  for (const double v : {q != 0.0 ? c / q : infinity, a != 0.0 ? q / a : infinity}) {
    if (!std::isfinite(v)) continue;
    const double u = across_at(v);
    const double outside = std::max({0.0, -u, u - 1.0, -v, v - 1.0});
    if (outside >= least) continue;
    least = outside;
    best = {u, v};
  }
  // One step of Newton takes away what the square root has lost.
  const geom::Vector off = p - point_at(side, strip, best);
  const geom::Vector across = e + best.down * h;
  const geom::Vector down = g + best.across * h;
  const double area = geom::cross(across, down);
  if (area != 0.0 && least < infinity) {
    best.across += geom::cross(off, down) / area;
    best.down += geom::cross(across, off) / area;
  }
  return best;
}

std::size_t RuledMap::strip_of(std::size_t band, double u) const {
  const std::vector<double>& places = bands_[band].u;
  return static_cast<std::size_t>(std::upper_bound(places.begin(), places.end(), u) - places.begin());
}

std::array<double, 4> RuledMap::beyond_on(bool target, Cell cell, geom::Point p) const {
  const Side& s = side(target, cell.second);
  const std::size_t i = cell.first;
  const bool first = i == 0;
  const bool last = i + 2 == s.top.size();
  // Rulings run down; the top runs to the right: outside is right of the left ruling, left of the right one.
  return {first ? -infinity : right_of_line(s.top[i], s.bottom[i], p),
          last ? -infinity : -right_of_line(s.top[i + 1], s.bottom[i + 1], p),
          cell.second == 0 ? -infinity : -right_of_line(s.top[i], s.top[i + 1], p),
          cell.second + 1 == bands_.size() ? -infinity : right_of_line(s.bottom[i], s.bottom[i + 1], p)};
}

/// From cell to cell towards p; true once no side has p beyond it.
bool RuledMap::walk(bool target, geom::Point p, Cell& cell) const {
  for (int step = 0; step < 64; ++step) {
    const std::array<double, 4> out = beyond_on(target, cell, p);
    const auto worst = static_cast<std::size_t>(std::max_element(out.begin(), out.end()) - out.begin());
    if (out[worst] <= tolerances_.side) return true;
    if (worst < 2) {
      cell.first = worst == 0 ? cell.first - 1 : cell.first + 1;
      continue;
    }
    const Band& band = bands_[cell.second];
    const double middle = cell.first == 0               ? -infinity
                          : cell.first >= band.u.size() ? infinity
                                                        : 0.5 * (band.u[cell.first - 1] + band.u[cell.first]);
    cell.second = worst == 2 ? cell.second - 1 : cell.second + 1;
    cell.first = static_cast<std::uint32_t>(strip_of(cell.second, middle));
  }
  return false;
}

/// Of the cells that hold p within the tolerance, the first: so that the way there does not matter.
void RuledMap::to_first(bool target, geom::Point p, Cell& cell) const {
  const auto holds = [&](Cell other) {
    const std::array<double, 4> out = beyond_on(target, other, p);
    return *std::max_element(out.begin(), out.end()) <= tolerances_.side;
  };
  while (cell.second > 0) {
    const Band& band = bands_[cell.second];
    if (cell.first == 0 || cell.first >= band.u.size()) break;
    const double middle = 0.5 * (band.u[cell.first - 1] + band.u[cell.first]);
    Cell above{static_cast<std::uint32_t>(strip_of(cell.second - 1, middle)), cell.second - 1};
    if (beyond_on(target, cell, p)[2] < -tolerances_.side || !walk(target, p, above) || above.second >= cell.second)
      break;
    cell = above;
  }
  while (cell.first > 0 && holds({cell.first - 1, cell.second})) --cell.first;
}

Spot RuledMap::locate_on(bool target, geom::Point p, Cell hint) const {
  // Inside a stack that is not folded over, any walk ends in the one cell that holds p.
  const bool unique = !folded_ && !folded_target_;
  Cell cell = hint;
  if (unique && hint.second < bands_.size() && hint.first + 1 < side(target, hint.second).top.size() &&
      walk(target, p, cell)) {
    to_first(target, p, cell);
    const Place place = place_in(side(target, cell.second), cell.first, p);
    if (place.down >= 0.0 && place.down <= 1.0 && place.across >= 0.0 && place.across <= 1.0)
      return {cell, 0.0, Foot::InColumn};
  }
  SegmentTree::Nearest best;
  const auto consider = [&](const SegmentTree& tree, std::size_t band) {
    const auto nearest = tree.nearest_within(p, best.squared);
    if (nearest && nearest->squared < best.squared) {
      best = *nearest;
      cell = {static_cast<std::uint32_t>(nearest->index + 1), static_cast<std::uint32_t>(band)};
    }
  };
  consider(side(target, 0).top_tree, 0);
  for (std::size_t k = 0; k < bands_.size(); ++k) consider(side(target, k).bottom_tree, k);
  const Cell nearest = cell;
  if (walk(target, p, cell)) {
    to_first(target, p, cell);
    return {cell, best.distance(), Foot::InColumn};
  }
  return {nearest, best.distance(), Foot::NoColumn};
}

Spot RuledMap::locate(geom::Point p, Cell hint) const { return locate_on(false, p, hint); }

std::array<double, 4> RuledMap::beyond(Cell cell, geom::Point p) const { return beyond_on(false, cell, p); }

Carried RuledMap::carry(Cell cell, geom::Point p) const {
  const Band& band = bands_[cell.second];
  const Place place = place_in(band.from, cell.first, p);
  return {{ColumnId(cell.first), place.across, static_cast<double>(cell.second) + place.down},
          point_at(band.to, cell.first, place)};
}

geom::Point RuledMap::back(geom::Point image, Cell& hint) const {
  hint = locate_on(true, image, hint).cell;
  const Band& band = bands_[hint.second];
  return point_at(band.from, hint.first, place_in(band.to, hint.first, image));
}

bool RuledMap::is_outer(Cell cell) const {
  return cell.first == 0 || cell.first + 2 == bands_[cell.second].from.top.size();
}

}  // namespace recon::core
