// Long chains of operations on cells of a lattice, against a table of the cells that are full. All coincidences occur,
// also of solids that touch themselves; in the skew lattice no corner can be written in doubles.

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <set>

#include "shared/solid/check/validate.h"
#include "shared/solid/section.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

constexpr int cells_across = 3;  // cells along each axis

/// The cells that a solid fills.
using Table = std::set<int>;
struct Range {
  std::array<int, 3> low, high;
};

Range any_range(std::mt19937_64& random) {
  Range range{};
  for (std::size_t i = 0; i < 3; ++i) {
    range.low[i] = static_cast<int>(random() % cells_across);
    range.high[i] =
        range.low[i] + 1 + static_cast<int>(random() % static_cast<std::uint64_t>(cells_across - range.low[i]));
  }
  return range;
}

Table cells_of(const Range& range) {
  Table cells;
  for (int x = range.low[0]; x < range.high[0]; ++x) {
    for (int y = range.low[1]; y < range.high[1]; ++y) {
      for (int z = range.low[2]; z < range.high[2]; ++z) cells.insert((x * cells_across + y) * cells_across + z);
    }
  }
  return cells;
}

/// Parts that hang together by faces, by which shells that bound them from outside are counted.
std::size_t part_count(const Table& table) {
  Table left = table;
  std::size_t parts = 0;
  while (!left.empty()) {
    ++parts;
    std::vector<int> queue{*left.begin()};
    left.erase(left.begin());
    while (!queue.empty()) {
      const int cell = queue.back();
      queue.pop_back();
      const std::array<int, 3> at{cell / (cells_across * cells_across), cell / cells_across % cells_across,
                                  cell % cells_across};
      for (std::size_t i = 0; i < 3; ++i) {
        for (const int step : {-1, 1}) {
          auto next = at;
          next[i] += step;
          if (next[i] < 0 || next[i] >= cells_across) continue;
          const int number = (next[0] * cells_across + next[1]) * cells_across + next[2];
          if (left.erase(number) > 0) queue.push_back(number);
        }
      }
    }
  }
  return parts;
}

using Maker = std::function<Solid(const Range&)>;
using Centre = std::function<geom::Point3(int x, int y, int z)>;

void run_chain(std::mt19937_64& random, const Maker& make, const Centre& centre, double cell_volume) {
  Solid solid;
  Table table;
  for (int step = 0; step < 12; ++step) {
    SCOPED_TRACE(step);
    const Range range = any_range(random);
    const Table other = cells_of(range);
    const Solid operand = make(range);
    Table next;
    const auto kind = random() % 4;
    const Operation operation = kind == 3   ? Operation::Intersection
                                : kind == 2 ? Operation::Difference
                                            : Operation::Union;
    for (int cell = 0; cell < cells_across * cells_across * cells_across; ++cell) {
      const bool in = table.contains(cell);
      const bool in_other = other.contains(cell);
      const bool keep = operation == Operation::Union        ? in || in_other
                        : operation == Operation::Difference ? in && !in_other
                                                             : in && in_other;
      if (keep) next.insert(cell);
    }
    solid = shapes::combined({solid, operand}, operation).solid;
    table = next;
    ASSERT_THAT(check::violations(solid), testing::IsEmpty());
    ASSERT_NEAR(volume(solid), static_cast<double>(table.size()) * cell_volume,
                1e-15 * cells_across * cells_across * cells_across);
    ASSERT_TRUE(shapes::euler_holds(solid.counts()));
    std::size_t outer = 0;
    for (const double v : shell_volumes(solid)) outer += v > 0.0 ? 1U : 0U;
    ASSERT_EQ(outer, part_count(table));
    const PointLocator locator(solid);
    for (int x = 0; x < cells_across; ++x) {
      for (int y = 0; y < cells_across; ++y) {
        for (int z = 0; z < cells_across; ++z) {
          const Location expected =
              table.contains((x * cells_across + y) * cells_across + z) ? Location::Inside : Location::Outside;
          ASSERT_EQ(locator.locate(centre(x, y, z)), expected);
        }
      }
    }
  }
}

int chains(int usual) {
  const char* wanted = std::getenv("DOBRA_SOLID_CHAINS");
  return wanted != nullptr ? std::atoi(wanted) : usual;
}

TEST(SolidChain, FollowsATableOfCells) {
  for (int seed = 1; seed <= chains(12); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    run_chain(
        random,
        [](const Range& r) {
          const auto at = [](const std::array<int, 3>& p) {
            return geom::Point3{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
          };
          return shapes::box_solid(at(r.low), at(r.high));
        },
        [](int x, int y, int z) {
          return geom::Point3{x + 0.5, y + 0.5, z + 0.5};
        },
        1.0);
    if (HasFailure()) return;
  }
}

TEST(SolidChain, FollowsATableOfSkewCellsWhoseCornersAreNoDoubles) {
  // Cells between the planes n x = 0, 1, 2, 3 of three directions.
  constexpr std::array<std::array<double, 3>, 3> n{{{5, 1, -1}, {-1, 4, 1}, {2, -1, 5}}};
  const double det = n[0][0] * (n[1][1] * n[2][2] - n[1][2] * n[2][1]) -
                     n[0][1] * (n[1][0] * n[2][2] - n[1][2] * n[2][0]) +
                     n[0][2] * (n[1][0] * n[2][1] - n[1][1] * n[2][0]);
  const auto cut = [&](std::size_t i, int level) {
    return CutPlane{n[i][0], n[i][1], n[i][2], -static_cast<double>(level)};
  };
  const Maker make = [&](const Range& r) {
    Solid s = shapes::box_solid({-4, -4, -4}, {4, 4, 4});
    for (std::size_t i = 0; i < 3; ++i) {
      s = halve(s, cut(i, r.low[i]), "").value().above;
      s = halve(s, cut(i, r.high[i]), "").value().below;
    }
    return s;
  };
  const Centre centre = [&](int x, int y, int z) {
    // Cramer's rule, rounded; a centre is far from all planes.
    const std::array<double, 3> b{x + 0.5, y + 0.5, z + 0.5};
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      auto m = n;
      for (std::size_t i = 0; i < 3; ++i) m[i][k] = b[i];
      p[k] = (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
              m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])) /
             det;
    }
    return geom::Point3{p[0], p[1], p[2]};
  };
  for (int seed = 1; seed <= chains(4); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    run_chain(random, make, centre, 1.0 / det);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace dobra::solid
