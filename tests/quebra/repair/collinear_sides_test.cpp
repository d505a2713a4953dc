// Drawings on a grid of squares that is turned and moved: sides that lie on one line of the grid are collinear up to
// rounding. Areas and lengths follow from counting squares.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "quebra/domain/domain.h"
#include "quebra/repair/crossings.h"
#include "quebra/repair/repair.h"
#include "quebra/repair/stray_lines.h"

namespace quebra::repair {
namespace {

using dobra::geom::Point;
using dobra::geom::Polyline;
using sketch::Role;
using sketch::Sketch;

class TurnedGrid {
 public:
  explicit TurnedGrid(unsigned seed) : random_(seed) {
    const double angle = 6.28 * unit();
    along_ = (0.1 + 10.0 * unit()) * dobra::geom::Vector{std::cos(angle), std::sin(angle)};
    origin_ = {1000.0 * unit(), 1000.0 * unit()};
  }
  int pick(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  [[nodiscard]] Point at(int x, int y) const {
    return {origin_.x + x * along_.x - y * along_.y, origin_.y + x * along_.y + y * along_.x};
  }
  /// Side of a square, m.
  [[nodiscard]] double side() const { return std::hypot(along_.x, along_.y); }

 private:
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  std::mt19937 random_;
  dobra::geom::Vector along_;
  Point origin_;
};

struct Rectangle {
  int x0, y0, x1, y1;
  [[nodiscard]] bool holds(const Rectangle& other) const {
    return x0 <= other.x0 && y0 <= other.y0 && other.x1 <= x1 && other.y1 <= y1;
  }
};

/// Some rectangles of which none holds another: those would be holes.
std::vector<Rectangle> rectangles(TurnedGrid& grid) {
  std::vector<Rectangle> all;
  const std::size_t count = static_cast<std::size_t>(grid.pick(2, 5));
  while (all.size() < count) {
    Rectangle next{grid.pick(0, 6), grid.pick(0, 6), 0, 0};
    next.x1 = next.x0 + grid.pick(1, 6);
    next.y1 = next.y0 + grid.pick(1, 6);
    const auto nested = [&](const Rectangle& other) { return other.holds(next) || next.holds(other); };
    if (std::none_of(all.begin(), all.end(), nested)) all.push_back(next);
  }
  return all;
}

int squares_in(const std::vector<Rectangle>& all) {
  int count = 0;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      const Rectangle square{x, y, x + 1, y + 1};
      count += std::any_of(all.begin(), all.end(), [&](const Rectangle& r) { return r.holds(square); }) ? 1 : 0;
    }
  }
  return count;
}

enum class Drawn { Polygons, Sides };

Sketch drawn(const std::vector<Rectangle>& all, const TurnedGrid& grid, Drawn how) {
  Sketch sketch;
  const auto add = [&](std::vector<Point> points, bool closed) {
    sketch.curves.push_back(
        {"r" + std::to_string(sketch.curves.size()), Role::Boundary, Polyline{std::move(points), closed}, {}});
    sketch.places.emplace_back();
  };
  for (const auto& [x0, y0, x1, y1] : all) {
    const std::vector<Point> corners{grid.at(x0, y0), grid.at(x1, y0), grid.at(x1, y1), grid.at(x0, y1)};
    if (how == Drawn::Polygons) add(corners, true);
    for (std::size_t i = 0; i < 4 && how == Drawn::Sides; ++i) add({corners[i], corners[(i + 1) % 4]}, false);
  }
  return sketch;
}

/// Where four sides end in a point they tell no loop.
bool share_a_corner(const std::vector<Rectangle>& all) {
  std::set<std::array<int, 2>> corners;
  for (const auto& [x0, y0, x1, y1] : all) {
    for (const auto& corner : {std::array{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
      if (!corners.insert(corner).second) return true;
    }
  }
  return false;
}

/// Of the material of the domain; 0 and a failure if there is none.
double area_of(Sketch sketch, unsigned seed) {
  const auto made = domain::make_domain(std::move(sketch));
  EXPECT_TRUE(made.ok()) << "seed " << seed << ": " << (made ? "" : to_string(made.error()));
  double area = 0.0;
  if (made) {
    for (const domain::Face& face : made->faces) area += face.area;
  }
  return area;
}

TEST(CollinearSides, RectanglesThatShareLinesAreUnited) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    TurnedGrid grid(seed);
    const std::vector<Rectangle> all = rectangles(grid);
    const double expected = squares_in(all) * grid.side() * grid.side();
    for (const Drawn how : {Drawn::Polygons, Drawn::Sides}) {
      if (how == Drawn::Sides && share_a_corner(all)) continue;
      Sketch rebuilt = drawn(all, grid, how);
      ASSERT_TRUE(rebuild_crossings(rebuilt, {}, 1e-7).ok()) << "seed " << seed;
      EXPECT_NEAR(area_of(std::move(rebuilt), seed), expected, 1e-9 * expected) << "rebuilt alone, seed " << seed;
      const auto repaired = repair(drawn(all, grid, how));
      ASSERT_TRUE(repaired.ok()) << "seed " << seed << ": " << to_string(repaired.error());
      EXPECT_NEAR(area_of(repaired->sketch, seed), expected, 1e-9 * expected) << "repaired, seed " << seed;
    }
  }
}

/// The sides of a rectangle as open lines that reach past its corners and lie upon each other in part.
struct LooseSides {
  Sketch sketch;
  std::set<std::array<int, 3>> sides;  ///< Of squares, that a line runs along: direction, line of the grid, number.

  void add(bool across, int line, int from, int to, const TurnedGrid& grid) {
    for (int i = from; i < to; ++i) sides.insert({across ? 1 : 0, line, i});
    const std::string name = "l" + std::to_string(sketch.curves.size());
    const auto at = [&](int i) { return across ? grid.at(i, line) : grid.at(line, i); };
    sketch.curves.push_back({name, Role::Boundary, Polyline{{at(from), at(to)}, false}, {}});
    sketch.places.emplace_back();
    sketch.without_role.insert(name);
  }
};

LooseSides loose_sides(int width, int height, TurnedGrid& grid) {
  LooseSides all;
  for (const bool across : {true, false}) {
    const int end = across ? width : height;
    for (const int line : {0, across ? height : width}) {
      const int middle = grid.pick(0, end);
      all.add(across, line, -grid.pick(1, 2), middle + grid.pick(0, 1), grid);
      all.add(across, line, middle - grid.pick(0, 1), end + grid.pick(1, 2), grid);
      if (grid.pick(0, 1) == 1) all.add(across, line, 0, grid.pick(1, end), grid);
    }
  }
  return all;
}

TEST(CollinearSides, LinesUponEachOtherAreCutSoThatEachStretchStaysOnce) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    TurnedGrid grid(seed);
    const int width = grid.pick(2, 6), height = grid.pick(2, 6);
    LooseSides all = loose_sides(width, height, grid);
    const double expected = width * height * grid.side() * grid.side();
    const auto repaired = repair(all.sketch);
    ASSERT_TRUE(repaired.ok()) << "seed " << seed << ": " << to_string(repaired.error());
    EXPECT_NEAR(area_of(repaired->sketch, seed), expected, 1e-9 * expected) << "seed " << seed;
    ASSERT_TRUE(cut_at_crossings(all.sketch, 1e-7).ok());
    double sum = 0.0;
    for (const sketch::Curve& curve : all.sketch.curves) sum += length(curve);
    EXPECT_NEAR(sum, static_cast<double>(all.sides.size()) * grid.side(), 1e-9 * sum) << "seed " << seed;
  }
}

}  // namespace
}  // namespace quebra::repair
