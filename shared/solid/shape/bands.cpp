#include "shared/solid/shape/bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// 1. Corners are joined to corners. Between them both lines are walked together, and each vertex of either is joined to
// the place as far along the other.
// 2. Cells between two rulings. Of a patch over the corners A, B, C, D that is bilinear, the volume is the mean of
// those of both ways to cut it by a diagonal. Four triangles round M = (A + B + C + D) / 4 have it too: M is within the
// tetrahedron A B C D, and parts it into four equal ones, two of them on each side of the fan.

namespace dobra::solid::shape {
namespace {

using geom::Point3;
using geom::Vector3;

constexpr double one_place = 1e-6;   // of the whole: places that are one
constexpr double one_plane = 1e-12;  // of the size: what diagonals are apart in a plane cell

/// Adds a ruling for each vertex between two joints, and for the second one.
void add_rulings(const std::vector<double>& a, const std::vector<double>& b, Joint low, Joint high,
                 std::vector<Ruling>& rulings) {
  constexpr double least = std::numeric_limits<double>::min();  // vertices that rounding has made one
  const double from = a[low.from], run = std::max(a[high.from] - from, least);
  const double to = b[low.to], other_run = std::max(b[high.to] - to, least);
  const auto part = [&](std::size_t i) { return (a[i] - from) / run; };
  const auto other_part = [&](std::size_t j) { return (b[j] - to) / other_run; };
  const double reach = one_place * (a.back() - a.front()) / run;
  std::size_t i = low.from;
  std::size_t j = low.to;
  while (i < high.from || j < high.to) {
    const bool both = i < high.from && j < high.to;
    const double next = i == high.from ? INFINITY : part(i + 1);
    const double other_next = j == high.to ? INFINITY : other_part(j + 1);
    if (both && std::abs(next - other_next) <= reach) {
      rulings.push_back({a[++i], b[++j]});
    } else if (next < other_next) {
      ++i;
      rulings.push_back({a[i], next - other_part(j) <= reach ? b[j] : to + next * other_run});
    } else {
      ++j;
      rulings.push_back({other_next - part(i) <= reach ? a[i] : from + other_next * run, b[j]});
    }
  }
}

/// A corner, its place in the box of its line, from 0 to 1, and whether the line turns to the left.
struct Corner {
  std::size_t vertex = 0;
  geom::Point place;
  bool left = false;
};

std::vector<Corner> corners_of(const geom::Polyline& line) {
  constexpr double least = 0.25 * std::numbers::pi;
  const geom::Box box = line.box();
  const auto part = [](double value, double low, double size) { return size > 0.0 ? (value - low) / size : 0.0; };
  std::vector<Corner> corners;
  const std::size_t count = line.points.size();
  for (std::size_t i = 1; i + (line.closed ? 0 : 1) < count; ++i) {
    const geom::Point p = line.points[i];
    const geom::Vector in = p - line.points[i - 1];
    const geom::Vector out = line.points[(i + 1) % count] - p;
    const double turn = std::atan2(geom::cross(in, out), geom::dot(in, out));
    if (std::abs(turn) < least) continue;
    corners.push_back({i, {part(p.x, box.low.x, box.width()), part(p.y, box.low.y, box.height())}, turn > 0.0});
  }
  return corners;
}

std::size_t last_vertex(const geom::Polyline& line) { return line.points.size() - (line.closed ? 0 : 1); }

/// The break that a place is one with, or the place as a new one.
double taken_in(std::vector<double>& breaks, double place) {
  const double reach = one_place * (breaks.back() - breaks.front());
  const auto after = std::lower_bound(breaks.begin(), breaks.end(), place);
  if (after == breaks.end()) return breaks.back();
  const double behind = after == breaks.begin() ? *after : *(after - 1);
  if (const double nearest = place - behind < *after - place ? behind : *after; std::abs(nearest - place) <= reach)
    return nearest;
  return *breaks.insert(after, place);
}

/// Where a cell or a walk begins and ends along both chains.
struct Stretch {
  std::size_t from_a = 0, to_a = 0, from_b = 0, to_b = 0;
};

/// Each step goes on along the chain whose next point comes earlier; where both come together the shorter diagonal is
/// taken.
void walk(const std::vector<Point3>& points, const Chain& a, const Chain& b, const Stretch& stretch,
          std::vector<BandTriangle>& triangles) {
  std::size_t i = stretch.from_a;
  std::size_t j = stretch.from_b;
  const auto apart = [&](std::size_t k, std::size_t l) { return distance(points[a.points[k]], points[b.points[l]]); };
  const auto part = [](const Chain& chain, std::size_t from, std::size_t to, std::size_t at) {
    return (chain.at[at] - chain.at[from]) / (chain.at[to] - chain.at[from]);
  };
  const auto goes_on_along_a = [&] {
    if (i == stretch.to_a || j == stretch.to_b) return j == stretch.to_b;
    const double next = part(a, stretch.from_a, stretch.to_a, i + 1);
    const double other = part(b, stretch.from_b, stretch.to_b, j + 1);
    return next == other ? apart(i + 1, j) <= apart(i, j + 1) : next < other;
  };
  while (i < stretch.to_a || j < stretch.to_b) {
    const auto segment = static_cast<std::uint32_t>(i == 0 || i < stretch.to_a ? i : i - 1);
    if (goes_on_along_a()) {
      triangles.push_back({{a.points[i], a.points[i + 1], b.points[j]}, segment});
      ++i;
    } else {
      triangles.push_back({{a.points[i], b.points[j + 1], b.points[j]}, segment});
      ++j;
    }
  }
}

/// Whether the diagonals of the four corners meet.
bool is_plane(const std::array<Point3, 4>& corners) {
  const Vector3 first = corners[2] - corners[0];
  const Vector3 second = corners[3] - corners[1];
  const Vector3 across = cross(first, second);
  const double size = std::max(length(first), length(second));
  return std::abs(dot(across, corners[1] - corners[0])) <= one_plane * size * length(across);
}

/// The four triangles round the middle of a cell; more where its sides have points between its corners.
void fan(std::vector<Point3>& points, const Chain& a, const Chain& b, const Stretch& cell,
         const std::array<Point3, 4>& corners, std::vector<BandTriangle>& triangles) {
  const auto middle = static_cast<std::uint32_t>(points.size());
  points.push_back(midpoint(midpoint(corners[0], corners[2]), midpoint(corners[1], corners[3])));
  std::vector<std::uint32_t> ring;
  for (std::size_t i = cell.from_a; i <= cell.to_a; ++i) ring.push_back(a.points[i]);
  for (std::size_t j = cell.to_b + 1; j > cell.from_b; --j) ring.push_back(b.points[j - 1]);
  for (std::size_t k = 0; k < ring.size(); ++k)
    triangles.push_back({{ring[k], ring[(k + 1) % ring.size()], middle}, static_cast<std::uint32_t>(cell.from_a)});
}

std::size_t number_of(const Chain& chain, double place) {
  return static_cast<std::size_t>(std::lower_bound(chain.at.begin(), chain.at.end(), place) - chain.at.begin());
}

}  // namespace

std::vector<Joint> joints_of(const geom::Polyline& a, const geom::Polyline& b) {
  const std::vector<Corner> from = corners_of(a);
  const std::vector<Corner> to = corners_of(b);
  // The best of the corners from i and j on, last ones first.
  enum class Step : char { Join, PassFrom, PassTo };
  std::vector<Step> steps(from.size() * to.size());
  std::vector<double> below(to.size() + 1, 0.0);
  std::vector<double> row(to.size() + 1, 0.0);
  for (std::size_t i = from.size(); i-- > 0;) {
    for (std::size_t j = to.size(); j-- > 0;) {
      const double gain = 1.0 - 2.0 * geom::distance(from[i].place, to[j].place);
      const double joined = from[i].left == to[j].left && gain > 0.0 ? below[j + 1] + gain : -1.0;
      Step& step = steps[i * to.size() + j];
      step = joined >= std::max(below[j], row[j + 1]) ? Step::Join
             : below[j] >= row[j + 1]                 ? Step::PassFrom
                                                      : Step::PassTo;
      row[j] = std::max({joined, below[j], row[j + 1]});
    }
    std::swap(row, below);
  }
  std::vector<Joint> joints{{0, 0}};
  for (std::size_t i = 0, j = 0; i < from.size() && j < to.size();) {
    const Step step = steps[i * to.size() + j];
    if (step == Step::Join) joints.push_back({from[i].vertex, to[j].vertex});
    if (step != Step::PassTo) ++i;
    if (step != Step::PassFrom) ++j;
  }
  joints.push_back({last_vertex(a), last_vertex(b)});
  return joints;
}

RuledLines ruled(const std::vector<std::vector<double>>& lines, const std::vector<std::vector<Joint>>& joints) {
  RuledLines made{lines, {}};
  for (std::size_t k = 1; k < lines.size(); ++k) {
    auto& rulings = made.rulings.emplace_back();
    rulings.push_back({lines[k - 1].front(), lines[k].front()});
    for (std::size_t n = 1; n < joints[k - 1].size(); ++n)
      add_rulings(lines[k - 1], lines[k], joints[k - 1][n - 1], joints[k - 1][n], rulings);
    for (Ruling& ruling : rulings) {
      ruling.from = taken_in(made.breaks[k - 1], ruling.from);
      ruling.to = taken_in(made.breaks[k], ruling.to);
    }
  }
  return made;
}

std::vector<BandTriangle> band(std::vector<Point3>& points, const Chain& a, const Chain& b,
                               const std::vector<Ruling>& rulings) {
  std::vector<BandTriangle> triangles;
  Stretch cell;
  for (const Ruling& ruling : rulings) {
    cell = {cell.to_a, number_of(a, ruling.from), cell.to_b, number_of(b, ruling.to)};
    const std::array corners{points[a.points[cell.from_a]], points[a.points[cell.to_a]], points[b.points[cell.to_b]],
                             points[b.points[cell.from_b]]};
    if (cell.from_a == cell.to_a || cell.from_b == cell.to_b || is_plane(corners))
      walk(points, a, b, cell, triangles);
    else
      fan(points, a, b, cell, corners, triangles);
  }
  return triangles;
}

std::vector<BandTriangle> band(const std::vector<Point3>& points, const Chain& a, const Chain& b) {
  std::vector<BandTriangle> triangles;
  walk(points, a, b, {0, a.points.size() - 1, 0, b.points.size() - 1}, triangles);
  return triangles;
}

}  // namespace dobra::solid::shape
