// Surfaces as files have them, read again by a checker of its own: one node at a place, none without a triangle, sides
// of two triangles but at the borders, no triangle without a height, Euler's number, and the area.

#include <array>
#include <map>
#include <random>
#include <set>

#include "shared/surf/loft/joined.h"
#include "shared/surf/loft/measures.h"
#include "tests/shared/surf/loft/placed.h"

namespace dobra::test {
namespace {

struct Counts {
  std::size_t near_nodes = 0, unused = 0, overfull = 0, against = 0, thin = 0;
  int euler = 0;
  std::size_t parts = 0, loops = 0;
  double area = 0.0, map = 0.0;
};

/// Counts alone; nothing of the code under test.
Counts counted(const loft::JoinedMesh& mesh) {
  using geom::Point3;
  Counts counts;
  const std::vector<Point3>& p = mesh.points;
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (const Point3 q : p) {
    const std::array at{q.x, q.y, q.z};
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], at[k]), high[k] = std::max(high[k], at[k]);
  }
  const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  const auto apart = [&](std::size_t a, std::size_t b) {
    return std::hypot(p[a].x - p[b].x, p[a].y - p[b].y, p[a].z - p[b].z);
  };
  std::vector<std::size_t> by_x(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) by_x[i] = i;
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return p[a].x < p[b].x; });
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    for (std::size_t j = i + 1; j < by_x.size() && p[by_x[j]].x - p[by_x[i]].x < 1e-6 * size; ++j) {
      if (apart(by_x[i], by_x[j]) < 1e-6 * size) ++counts.near_nodes;
    }
  }
  std::vector<std::size_t> whole(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) whole[i] = i;
  const auto root = [&](std::size_t i) {
    while (whole[i] != i) i = whole[i];
    return i;
  };
  std::vector<bool> used(p.size(), false);
  std::map<std::pair<std::size_t, std::size_t>, std::pair<int, int>> sides;  // forwards, backwards
  for (const auto& t : mesh.triangles) {
    const double a = apart(t[0], t[1]), b = apart(t[1], t[2]), c = apart(t[2], t[0]);
    const Point3 &o = p[t[0]], &q = p[t[1]], &r = p[t[2]];
    const double x = (q.y - o.y) * (r.z - o.z) - (q.z - o.z) * (r.y - o.y);
    const double y = (q.z - o.z) * (r.x - o.x) - (q.x - o.x) * (r.z - o.z);
    const double z = (q.x - o.x) * (r.y - o.y) - (q.y - o.y) * (r.x - o.x);
    const double twice = std::sqrt(x * x + y * y + z * z);
    counts.area += 0.5 * twice;
    counts.map += 0.5 * z;
    if (!(twice / std::max({a, b, c}) >= 1e-9 * size)) ++counts.thin;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = t[k], to = t[(k + 1) % 3];
      used[from] = true;
      auto& side = sides[std::minmax(from, to)];
      ++(from < to ? side.first : side.second);
      whole[root(from)] = root(to);
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> border;
  for (const auto& [side, count] : sides) {
    const int all = count.first + count.second;
    if (all > 2) ++counts.overfull;
    if (all == 2 && count.first != 1) ++counts.against;
    if (all == 1) border[side.first].push_back(side.second), border[side.second].push_back(side.first);
  }
  std::set<std::size_t> parts;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!used[i]) ++counts.unused;
    if (used[i]) parts.insert(root(i));
  }
  counts.parts = parts.size();
  counts.euler = static_cast<int>(p.size()) - static_cast<int>(sides.size()) + static_cast<int>(mesh.triangles.size());
  std::set<std::size_t> seen;
  for (const auto& [node, around] : border) {
    if (seen.contains(node)) continue;
    ++counts.loops;
    std::vector<std::size_t> open{node};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (!seen.insert(at).second) continue;
      for (const std::size_t next : border.at(at)) open.push_back(next);
    }
  }
  return counts;
}

/// One sheet a part, each a disk.
void expect_disks(const loft::Surfaces& made, const std::string& name, std::size_t parts, const std::string& what) {
  SCOPED_TRACE(what + ", " + name);
  const auto surface = std::find_if(made.surfaces.begin(), made.surfaces.end(),
                                    [&](const loft::NamedSurface& s) { return s.name == name; });
  ASSERT_NE(surface, made.surfaces.end());
  const Counts counts = counted(loft::joined(*surface, made.size));
  EXPECT_EQ(counts.near_nodes, 0U);
  EXPECT_EQ(counts.unused, 0U);
  EXPECT_EQ(counts.overfull, 0U);
  EXPECT_EQ(counts.against, 0U);
  EXPECT_EQ(counts.thin, 0U);
  EXPECT_EQ(counts.parts, parts);
  EXPECT_EQ(counts.loops, parts);
  EXPECT_EQ(counts.euler, static_cast<int>(parts));
}

Counts counts_of(const loft::Surfaces& made, std::size_t surface = 0) {
  return counted(loft::joined(made.surfaces.at(surface), made.size));
}

double rounded(double value, int decimals) {
  const double by = std::pow(10.0, decimals);
  return std::round(value * by) / by;
}

/// A section whose line has vertices at the places given, m along the trace.
loft::Section section_at(std::string name, std::vector<Point> corners, const Height& height,
                         const std::vector<double>& places, int decimals = -1) {
  loft::Section made = section(std::move(name), std::move(corners));
  geom::Polyline line;
  for (double s : places) {
    if (decimals >= 0) s = rounded(s, decimals);
    const Point p = made.trace.on_map(s);
    const double z = height(p.x, p.y);
    line.points.push_back({s, decimals >= 0 ? rounded(z, decimals) : z});
  }
  add(made, "top", std::move(line));
  return made;
}

const Height plane = [](double x, double y) { return -500.0 + 0.2 * x - 0.1 * y; };
const double plane_area = std::sqrt(1.0 + 0.2 * 0.2 + 0.1 * 0.1);
const Height fold = [](double x, double y) { return 60.0 * std::sin(x / 150.0) + 0.05 * y; };

TEST(LoftJoined, VerticesThatAreOneButForRoundingAreOneNode) {
  for (const double off : {1e-13, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 5e-6}) {
    for (int count = 2; count <= 5; ++count) {
      std::vector<loft::Section> sections;
      for (int k = 0; k < count; ++k) {
        const double y = 300.0 * k;
        std::vector<double> places{0.0};
        for (int i = 1; i < 20; ++i) places.push_back(50.0 * i + 1000.0 * off * (k % 3 - 1));
        places.push_back(1000.0);
        sections.push_back(section_at("S" + std::to_string(k), {{0.0, y}, {1000.0, y}}, plane, places));
      }
      const auto made = through(sections);
      expect_disks(made, "top", 1, "off by " + std::to_string(off));
      const double area = 1000.0 * 300.0 * (count - 1) * plane_area;
      EXPECT_NEAR(counts_of(made).area, area, 1e-9 * area);
      EXPECT_EQ(made.surfaces[0].patches[0].u.size(), 21U) << off << " " << count;
      // Own vertices stay where they are.
      for (const loft::Section& own : sections) {
        const auto cut = loft::cut_along(made.surfaces, own.trace, made.size);
        ASSERT_EQ(cut.lines.size(), 1U);
        EXPECT_LE(away(own.lines[0].line, cut.lines[0].line), 1e-9 * made.size);
        EXPECT_LE(away(cut.lines[0].line, own.lines[0].line), 1e-9 * made.size);
      }
    }
  }
}

TEST(LoftJoined, SlantedSectionsInCentimetresGiveNoTwins) {
  for (const int decimals : {0, 1, 2, 3, 6}) {
    for (int count = 3; count <= 5; ++count) {
      std::vector<loft::Section> sections;
      for (int k = 0; k < count; ++k) {
        const double y = 300.0 * k, rise = 130.0 + 20.0 * k;
        const double slant = std::hypot(1000.0, rise);
        std::vector<double> places;
        for (int i = 0; i <= 25; ++i) places.push_back(slant * i / 25.0);
        sections.push_back(section_at("S" + std::to_string(k), {{0.0, y}, {1000.0, y + rise}}, fold, places, decimals));
      }
      expect_disks(through(sections), "top", 1, std::to_string(decimals) + " decimals");
    }
  }
}

TEST(LoftJoined, LinesInCentimetresWithVerticesAtOnePlaceLeaveNoPointUnused) {
  std::vector<loft::Section> sections;
  for (int k = 0; k < 4; ++k) {
    const double y = 250.0 * k, to = k == 2 ? 703.33 : 1000.0;
    std::vector<double> places;
    for (int i = 0; i <= 30; ++i) places.push_back(to * i / 30.0);
    sections.push_back(section_at("S" + std::to_string(k), {{0.0, y}, {1000.0, y}}, plane, places, 2));
  }
  const auto made = through(sections);
  expect_disks(made, "top", 1, "a shorter one");
}

TEST(LoftJoined, RandomFansAreDisks) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int k = 0; k < 60; ++k) {
    std::vector<loft::Section> sections;
    double left = 0.0, right = 0.0;
    std::vector<Point> lefts, rights;
    for (int i = 0; i < 3 + k % 3; ++i) {
      const double low = 400.0 * any(random), high = 1000.0 - 400.0 * any(random);
      const auto at = [&](double x) { return Point{x, std::lerp(left, right, x / 1000.0)}; };
      lefts.push_back(at(low)), rights.push_back(at(high));
      sections.push_back(section("S" + std::to_string(i), {at(low), at(high)}));
      add(sections.back(), "top", sampled(sections.back(), plane, 10 + i));
      left += 20.0 + 500.0 * any(random), right += 20.0 + 500.0 * any(random);
    }
    const auto made = through(sections);
    expect_disks(made, "top", 1, "fan " + std::to_string(k));
    double twice = 0.0;  // of the ring of the ends
    std::vector<Point> ring = rights;
    ring.insert(ring.end(), lefts.rbegin(), lefts.rend());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      twice += a.x * b.y - b.x * a.y;
    }
    EXPECT_NEAR(counts_of(made).area, 0.5 * std::abs(twice) * plane_area, 1e-8 * std::abs(twice));
    if (HasFailure()) return;
  }
}

/// Lines west-east at the y of `ys` and south-north at the x of `xs`, with vertices of their own.
std::vector<loft::Section> grid(const std::vector<double>& xs, const std::vector<double>& ys, const Height& height,
                                int decimals = -1) {
  std::vector<loft::Section> sections;
  const auto places = [](double length, int n) {
    std::vector<double> made;
    for (int i = 0; i <= n; ++i) made.push_back(length * i / n);
    return made;
  };
  int n = 11;
  for (const double y : ys) {
    sections.push_back(section_at("E" + std::to_string(sections.size()), {{xs.front(), y}, {xs.back(), y}}, height,
                                  places(xs.back() - xs.front(), n), decimals));
    n += 3;
  }
  for (const double x : xs) {
    sections.push_back(section_at("N" + std::to_string(sections.size()), {{x, ys.front()}, {x, ys.back()}}, height,
                                  places(ys.back() - ys.front(), n), decimals));
    n += 2;
  }
  return sections;
}

TEST(LoftJoined, CellsBetweenCrossingSectionsAreOneSheet) {
  const std::vector<double> three{0.0, 410.0, 1000.0}, four{0.0, 300.0, 550.0, 900.0}, two{0.0, 800.0};
  for (const int decimals : {-1, 2, 3}) {
    for (const auto& [xs, ys] : {std::pair{two, two}, {three, three}, {four, three}, {two, four}}) {
      SCOPED_TRACE(std::to_string(xs.size()) + " by " + std::to_string(ys.size()));
      const auto made = through(grid(xs, ys, plane, decimals));
      ASSERT_EQ(made.surfaces.size(), 1U);
      EXPECT_EQ(made.surfaces[0].patches.size(), (xs.size() - 1) * (ys.size() - 1));
      expect_disks(made, "top", 1, std::to_string(decimals) + " decimals");
      const Counts counts = counts_of(made);
      EXPECT_NEAR(counts.map, xs.back() * ys.back(), 1e-9 * xs.back() * ys.back());
      if (decimals < 0) {
        EXPECT_NEAR(counts.area, xs.back() * ys.back() * plane_area, 1e-9 * xs.back() * ys.back());
      }
      expect_disks(through(grid(xs, ys, fold, decimals)), "top", 1, "fold");
    }
  }
}

/// A section that ends on another one: the cell on its other side has a corner of others on its side.
TEST(LoftJoined, ASectionThatEndsOnAnotherPartsTheCellBesideIt) {
  for (const int decimals : {-1, 2}) {
    std::vector<loft::Section> sections = grid({0.0, 1000.0}, {0.0, 400.0, 900.0}, fold, decimals);
    std::vector<double> places;
    for (int i = 0; i <= 9; ++i) places.push_back(400.0 * i / 9.0);
    sections.push_back(section_at("T", {{370.0, 0.0}, {370.0, 400.0}}, fold, places, decimals));
    const auto made = through(sections);
    ASSERT_EQ(made.surfaces.size(), 1U);
    EXPECT_EQ(made.surfaces[0].patches.size(), 3U);
    expect_disks(made, "top", 1, "T");
    EXPECT_NEAR(counts_of(made).map, 9e5, 1e-3);
  }
}

/// Two cells of an L, and a ring of eight round an open one.
TEST(LoftJoined, CornersAndHolesKeepTheirBorders) {
  std::vector<loft::Section> corner;
  const auto places = [](double length, int n) {
    std::vector<double> made;
    for (int i = 0; i <= n; ++i) made.push_back(length * i / n);
    return made;
  };
  corner.push_back(section_at("A", {{0.0, 0.0}, {1000.0, 0.0}}, fold, places(1000.0, 13)));
  corner.push_back(section_at("B", {{0.0, 400.0}, {1000.0, 400.0}}, fold, places(1000.0, 17)));
  corner.push_back(section_at("C", {{0.0, 0.0}, {0.0, 900.0}}, fold, places(900.0, 15)));
  corner.push_back(section_at("D", {{450.0, 0.0}, {450.0, 900.0}}, fold, places(900.0, 12)));
  corner.push_back(section_at("E", {{1000.0, 0.0}, {1000.0, 400.0}}, fold, places(400.0, 7)));
  corner.push_back(section_at("F", {{0.0, 900.0}, {450.0, 900.0}}, fold, places(450.0, 8)));
  const auto made = through(corner);
  ASSERT_EQ(made.surfaces.size(), 1U);
  EXPECT_EQ(made.surfaces[0].patches.size(), 3U);
  expect_disks(made, "top", 1, "L");
  EXPECT_NEAR(counts_of(made).map, 400.0 * 1000.0 + 500.0 * 450.0, 1e-3);
}

TEST(LoftJoined, ThreeSectionsOfAFanOfTrianglesAreOneSheet) {
  for (const int decimals : {-1, 2, 3}) {
    // A square with one of its diagonals.
    std::vector<loft::Section> sections = grid({0.0, 1000.0}, {0.0, 1000.0}, plane, decimals);
    const double slant = std::hypot(1000.0, 1000.0);
    std::vector<double> places;
    for (int i = 0; i <= 16; ++i) places.push_back(slant * i / 16.0);
    sections.push_back(section_at("D", {{0.0, 0.0}, {1000.0, 1000.0}}, plane, places, decimals));
    const auto made = through(sections);
    ASSERT_EQ(made.surfaces.size(), 1U);
    EXPECT_EQ(made.surfaces[0].patches.size(), 2U);
    expect_disks(made, "top", 1, std::to_string(decimals) + " decimals");
    EXPECT_NEAR(counts_of(made).map, 1e6, decimals < 0 ? 1e-3 : 20.0);
  }
}

TEST(LoftJoined, TrianglesRoundACrossingAreOneSheet) {
  for (const int decimals : {-1, 2, 3}) {
    for (const Height& height : {plane, fold}) {
      // A square with both of its diagonals.
      std::vector<loft::Section> sections = grid({0.0, 1000.0}, {0.0, 1000.0}, height, decimals);
      const double slant = std::hypot(1000.0, 1000.0);
      for (const bool down : {false, true}) {
        std::vector<double> places;
        const int n = down ? 22 : 16;
        for (int i = 0; i <= n; ++i) places.push_back(slant * i / n);
        const Point from{0.0, down ? 1000.0 : 0.0}, to{1000.0, down ? 0.0 : 1000.0};
        sections.push_back(section_at(down ? "D" : "U", {from, to}, height, places, decimals));
      }
      const auto made = through(sections);
      ASSERT_EQ(made.surfaces.size(), 1U);
      EXPECT_EQ(made.surfaces[0].patches.size(), 4U);
      expect_disks(made, "top", 1, std::to_string(decimals) + " decimals");
      EXPECT_NEAR(counts_of(made).map, 1e6, decimals < 0 ? 1e-3 : 20.0);
    }
  }
}

/// Places on the earth in metres, and sections that are written to centimetres.
TEST(LoftJoined, RandomGridsFarFromTheOriginAreOneSheet) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  const double east = 512'345.25, north = 7'654'321.5;
  for (int k = 0; k < 40; ++k) {
    // Lines from west to east and from south to north over all of them, each slanted a little.
    std::vector<loft::Section> sections;
    const int across = 2 + k % 3, up = 2 + k % 2;
    const Height height = [&](double x, double y) { return fold(x - east, y - north); };
    const auto run = [&](Point from, Point to, const std::string& name) {
      std::vector<double> places{0.0};
      const double length = geom::distance(from, to);
      const int n = 8 + static_cast<int>(20.0 * any(random));
      for (int i = 1; i <= n; ++i) places.push_back(length * (i + (i < n ? 0.4 * any(random) : 0.0)) / n);
      sections.push_back(section_at(name, {from, to}, height, places, 2));
    };
    const auto slant = [&] { return 120.0 * (any(random) - 0.5); };
    for (int i = 0; i < across; ++i) {
      const double y = north + 1000.0 * i / (across - 1);
      run({east - 100.0, y + slant()}, {east + 1100.0, y + slant()}, "E" + std::to_string(i));
    }
    for (int i = 0; i < up; ++i) {
      const double x = east + 1000.0 * i / (up - 1);
      run({x + slant(), north - 100.0}, {x + slant(), north + 1100.0}, "N" + std::to_string(i));
    }
    const auto made = through(sections);
    ASSERT_EQ(made.surfaces.size(), 1U);
    EXPECT_EQ(made.surfaces[0].patches.size(), static_cast<std::size_t>((across - 1) * (up - 1)));
    expect_disks(made, "top", 1, "grid " + std::to_string(k));
    if (HasFailure()) return;
  }
}

TEST(LoftJoined, RandomRowsInCentimetresAreDisks) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int k = 0; k < 60; ++k) {
    std::vector<loft::Section> sections;
    const int n = 15 + k % 7;
    for (int j = 0; j < 3 + k % 3; ++j) {
      const double y = 250.0 * j, low = 100.0 * any(random), high = 1000.0 - 100.0 * any(random);
      const Point from{low, y + 60.0 * any(random)}, to{high, y + 60.0 * any(random)};
      // Vertices at the same places of all, as of lines that were drawn on one grid.
      std::vector<double> places{0.0};
      const double length = geom::distance(from, to);
      for (int i = 0; i <= n; ++i) {
        const double s = (1000.0 * i / n - low) * length / (high - low);
        if (s > 1.0 && s < length - 1.0) places.push_back(s);
      }
      places.push_back(length);
      sections.push_back(section_at("S" + std::to_string(j), {from, to}, fold, places, 1 + k % 3));
    }
    expect_disks(through(sections), "top", 1, "row " + std::to_string(k));
    if (HasFailure()) return;
  }
}

/// A fold that lies over: joined by lengths.
TEST(LoftJoined, OverturnedFoldsAndSteepStepsAreDisks) {
  for (const int decimals : {6, 2}) {
    std::vector<loft::Section> sections;
    for (int k = 0; k < 4; ++k) {
      const double y = 300.0 * k;
      sections.push_back(section("S" + std::to_string(k), {{0.0, y}, {1000.0, y + 10.0 * k}}));
      geom::Polyline line;
      for (int i = 0; i <= 60; ++i) {
        const double t = i / 60.0;
        line.points.push_back({rounded(1000.0 * t + (150.0 + 5.0 * k) * std::sin(6.0 * t * 3.0), decimals),
                               rounded(200.0 * std::cos(6.0 * t * 3.0), decimals)});
      }
      add(sections.back(), "top", std::move(line));
      const double at = 400.0 + 20.0 * k;
      add(sections.back(), "step",
          {{{0.0, 500.0}, {at, 500.0}, {at + 1e-4, 480.0}, {at + 2e-4, 470.0}, {1000.0, 470.0}}, false});
    }
    const auto made = through(sections);
    expect_disks(made, "top", 1, "overturned");
    expect_disks(made, "step", 1, "step");
  }
}

/// Two sections in one line bound a cell together with two others: its corner between them is no corner.
TEST(LoftJoined, ACellWithAStraightCornerHasNoTriangleWithoutAHeight) {
  const auto places = [](double length, int n) {
    std::vector<double> made;
    for (int i = 0; i <= n; ++i) made.push_back(length * i / n);
    return made;
  };
  for (const bool turned : {false, true}) {
    std::vector<loft::Section> sections;
    const auto put = [&](const char* name, Point from, Point to, int n) {
      sections.push_back(section_at(name, {from, to}, plane, places(geom::distance(from, to), n)));
    };
    put("A", {0.0, 0.0}, {500.0, 0.0}, turned ? 12 : 9);
    put("B", {500.0, 0.0}, {1000.0, 0.0}, turned ? 7 : 11);
    put("C", {1000.0, 0.0}, {600.0, 800.0}, 10);
    put("D", {600.0, 800.0}, {0.0, 0.0}, 8);
    const auto made = through(sections);
    ASSERT_EQ(made.surfaces.size(), 1U);
    expect_disks(made, "top", 1, "straight corner");
    EXPECT_NEAR(counts_of(made).area, 400'000.0 * plane_area, 1e-6 * 400'000.0);
  }
}

/// A bed in pieces between two faults on three sections.
std::vector<loft::Section> faulted(int count, int decimals = -1) {
  std::vector<loft::Section> sections;
  const auto r = [&](double value) { return decimals < 0 ? value : rounded(value, decimals); };
  for (int k = 0; k < count; ++k) {
    const double y = 300.0 * k, at = 300.0 + 33.3 * k;
    sections.push_back(section("S" + std::to_string(k), {{0.0, y}, {1000.0, y + 30.0 * k}}));
    loft::Section& on = sections.back();
    add(on, "F", {{{r(at - 50.0), 100.0}, {r(at + 50.0), -100.0}}, false}, loft::LineKind::Fault);
    add(on, "G", {{{r(at + 350.0), -100.0}, {r(at + 450.0), 100.0}}, false}, loft::LineKind::Fault);
    add(on, "top", {{{0.0, 0.0}, {r(at / 3.0), 5.0}, {r(at), 0.0}}, false});
    add(on, "top", {{{r(at + 10.0), -20.0}, {r(at + 200.0), -25.0}, {r(at + 390.0), -20.0}}, false});
    add(on, "top", {{{r(at + 400.0), 0.0}, {r(at + 500.0), 3.0}, {1000.0, 0.0}}, false});
  }
  return sections;
}

TEST(LoftJoined, PiecesBetweenFaultsKeepTheirBorders) {
  for (const int decimals : {-1, 2}) {
    for (int count = 2; count <= 5; ++count) {
      const auto made = through(faulted(count, decimals));
      expect_disks(made, "top", 3, "between faults");
      expect_disks(made, "F", 1, "between faults");
    }
  }
}

TEST(LoftPieces, APieceThatOneSectionLacksIsPassedOver) {
  auto sections = faulted(4);
  const auto whole = through(sections);
  for (const std::size_t which : {std::size_t{1}, std::size_t{2}}) {
    for (const std::size_t piece : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
      auto lacking = sections;
      lacking[which].lines.erase(lacking[which].lines.begin() + static_cast<std::ptrdiff_t>(piece));
      const auto made = through(lacking);
      expect_disks(made, "top", 3, "one lacking");
      EXPECT_EQ(finding(made.findings, "piece_alone"), nullptr);
      const loft::Finding* told = finding(made.findings, "missing");
      ASSERT_NE(told, nullptr);
      EXPECT_NE(told->message.find("is not in 'S" + std::to_string(which) + "'; its surface passes without"),
                std::string::npos)
          << told->message;
      EXPECT_TRUE(told->place.x && told->place.y);
    }
  }
  // Where nothing but that piece is drawn elsewhere.
  for (std::size_t k = 0; k < sections.size(); ++k)
    sections[k].lines = {sections[k].lines[0], sections[k].lines[1], sections[k].lines[k == 1 ? 2 : 3]};
  const auto made = through(sections);
  const auto top = std::find_if(made.surfaces.begin(), made.surfaces.end(),
                                [](const loft::NamedSurface& s) { return s.name == "top"; });
  ASSERT_NE(top, made.surfaces.end());
  ASSERT_EQ(top->patches.size(), 1U);
  EXPECT_EQ(top->patches[0].sections, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(whole.surfaces.size(), 3U);
}

/// A bed 200 m thick, 450 m of it repeated by a thrust: what is alike along strike is right with a piece less too.
TEST(LoftPieces, TheVolumeBesideAPieceThatIsPassedOverIsThatOfTheBlocks) {
  for (const std::size_t lacking : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
    std::vector<loft::Section> sections;
    for (const double y : {0.0, 300.0, 500.0, 800.0}) {
      sections.push_back(section("S" + std::to_string(sections.size()), {{0.0, y}, {2000.0, y}}));
      std::vector<std::pair<std::string, geom::Polyline>> lines{{"A", {{{0.0, 0.0}, {1350.0, 0.0}}, false}},
                                                                {"A", {{{900.0, 300.0}, {2000.0, 300.0}}, false}},
                                                                {"B", {{{0.0, -200.0}, {1650.0, -200.0}}, false}},
                                                                {"B", {{{1200.0, 100.0}, {2000.0, 100.0}}, false}}};
      if (y == 300.0 && lacking < lines.size()) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(lacking));
      add(sections.back(), "F", {{{0.0, 900.0}, {1800.0, -300.0}}, false}, loft::LineKind::Fault);
      for (auto& [name, line] : lines) add(sections.back(), name, std::move(line));
    }
    const auto made = through(sections);
    ASSERT_EQ(made.surfaces.size(), 3U) << lacking;
    const auto of = [&](const char* name) {
      return *std::find_if(made.surfaces.begin(), made.surfaces.end(),
                           [&](const loft::NamedSurface& surface) { return surface.name == name; });
    };
    EXPECT_EQ(of("A").patches.size(), 2U) << lacking;
    EXPECT_TRUE(of("A").unjoined.empty() && of("B").unjoined.empty()) << lacking;
    const auto volume = loft::volume_between(of("A"), of("B"), made.surfaces);
    ASSERT_TRUE(volume.ok()) << lacking;
    EXPECT_NEAR(volume->value, 200.0 * 2450.0 * 800.0, 1e-9 * 200.0 * 2450.0 * 800.0) << lacking;
    EXPECT_EQ(volume->unsure, 0.0) << lacking;
    EXPECT_TRUE(volume->findings.empty()) << lacking;
  }
}

TEST(LoftPieces, AnotherPieceInItsPlaceEndsIt) {
  auto sections = faulted(3);
  // The middle one has no faults, and the bed in one.
  sections[1].lines = {{"top", loft::LineKind::Horizon, {{{0.0, 0.0}, {1000.0, 0.0}}, false}}};
  const auto made = through(sections);
  const auto top = std::find_if(made.surfaces.begin(), made.surfaces.end(),
                                [](const loft::NamedSurface& s) { return s.name == "top"; });
  EXPECT_EQ(top, made.surfaces.end());
  EXPECT_NE(finding(made.findings, "piece_alone"), nullptr);
}

TEST(LoftBends, AVertexAtABendButForRoundingDoesNotTurnBack) {
  const double slant = std::hypot(500.0, 120.0);
  for (const double off : {0.0, 1e-13, -1e-13, 1e-10, -1e-10, 1e-8, -1e-8, 1e-6, -1e-6, 4e-4, -4e-4}) {
    SCOPED_TRACE(off);
    std::vector<loft::Section> sections;
    for (int k = 0; k < 3; ++k) {
      const double y = 300.0 * k;
      std::vector<double> places;
      for (int i = 0; i <= 5; ++i) places.push_back(slant * i / 5.0);
      places.back() += off;
      // Of unequal reach, so that turning back would be told.
      for (int i = 1; i <= 5; ++i) places.push_back(slant + (500.0 - 40.0 * k) * i / 5.0);
      sections.push_back(
          section_at("S" + std::to_string(k), {{0.0, y}, {500.0, y + 120.0}, {1000.0, y + 120.0}}, plane, places));
    }
    const auto made = through(sections);
    for (const loft::Finding& f : made.findings) {
      EXPECT_EQ(f.message.find("turns back"), std::string::npos) << f.message;
    }
    expect_disks(made, "top", 1, "bent");
    EXPECT_NEAR(counts_of(made).map, 1000.0 * 600.0 - 0.5 * 300.0 * (40.0 + 40.0 + 80.0), 1e-3);
    for (const loft::Section& own : sections) {
      const auto cut = loft::cut_along(made.surfaces, own.trace, made.size);
      ASSERT_EQ(cut.lines.size(), 1U);
      EXPECT_LE(away(own.lines[0].line, cut.lines[0].line), 1e-9 * made.size + 0.2 * std::abs(off));
    }
  }
}

TEST(LoftBends, ALineInCentimetresHasOneVertexAtABend) {
  std::vector<loft::Section> sections;
  for (int k = 0; k < 3; ++k) {
    const double y = 300.0 * k;
    std::vector<double> places;
    for (int i = 0; i <= 10; ++i) places.push_back(std::hypot(500.0, 120.0) * i / 5.0);
    sections.push_back(
        section_at("S" + std::to_string(k), {{0.0, y}, {500.0, y + 120.0}, {1000.0, y}}, fold, places, 2));
  }
  const auto made = through(sections);
  ASSERT_EQ(made.surfaces.size(), 1U);
  EXPECT_EQ(made.surfaces[0].patches[0].u.size(), 11U);
  expect_disks(made, "top", 1, "bent");
}

TEST(LoftBends, ALineThatTurnsBackIsStillTold) {
  std::vector<loft::Section> sections;
  for (int k = 0; k < 3; ++k) {
    const double y = 300.0 * k;
    sections.push_back(section("S" + std::to_string(k), {{0.0, y}, {1000.0, y}}));
    const double more = 100.0 * k;
    add(sections.back(), "top", {{{0.0, 0.0}, {600.0, 50.0}, {500.0, -20.0}, {900.0 + more, -40.0}}, false});
  }
  const auto made = through(sections);
  const loft::Finding* told = finding(made.findings, "uneven");
  ASSERT_NE(told, nullptr);
  EXPECT_NE(told->message.find("turns back along the sections"), std::string::npos) << told->message;
}

}  // namespace
}  // namespace dobra::test
