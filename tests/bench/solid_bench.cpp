// Speed of solids, one thread: two spheres of n triangles each that overlap (the second turned, so that nothing
// coincides), read (from_mesh) and combined by union, intersection and difference; a union of m boxes of which each
// overlaps its neighbour; unions of pairs of balls, tori, gears, hills and knots (`pairs`); Menger sponges; points that
// are located in a sphere; plane sections of a sphere and of a block of units through many sections; where CGAL is
// installed, the union of the spheres by its Nef polyhedra beside ours (counters nef_ms, ratio). Counters: ns_face per
// triangle that went in, exponent of the time in n since the size before. Figures belong in docs/algorithms/boolean.md.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "shared/solid/cap.h"
#include "shared/solid/section.h"
#include "shared/solid/shape/loft.h"
#include "tests/shared/solid/shapes.h"
#ifdef DOBRA_CGAL
#include "tests/bench/solid_peers.h"
#endif

namespace {

using namespace dobra;
using namespace dobra::solid;

mesh::PolygonMesh ball(std::size_t triangles, double shift) {
  const auto rows =
      static_cast<std::uint32_t>(std::lround(0.5 * (1.0 + std::sqrt(1.0 + static_cast<double>(triangles)))));
  const mesh::PolygonMesh round = shapes::sphere({0, 0, 0}, 1.0, rows, 2 * rows);
  return shapes::moved(shapes::rotated(round, {1, 2, 3}, shift), {shift, 0.3 * shift, 0.1 * shift});
}

/// Time of the process, so that a busy machine does not count.
double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
void timed(benchmark::State& state, const std::string& family, double size, Work&& work) {
  static std::map<std::string, std::map<double, double>> best;
  for (auto _ : state) {
    const double begin = process_seconds();
    work();
    const double spent = process_seconds() - begin;
    state.SetIterationTime(spent);
    const auto at = best[family].try_emplace(size, spent).first;
    at->second = std::min(at->second, spent);
  }
  const auto own = best[family].find(size);
  state.counters["ns_face"] = 1e9 * own->second / size;
  if (own != best[family].begin()) {
    const auto before = std::prev(own);
    state.counters["exponent"] = std::log(own->second / before->second) / std::log(size / before->first);
  }
}

void read(benchmark::State& state) {
  const mesh::PolygonMesh mesh = ball(static_cast<std::size_t>(state.range(0)), 0.0);
  timed(state, "read", static_cast<double>(mesh.faces.size()),
        [&] { benchmark::DoNotOptimize(from_mesh(mesh).value()); });
}

void spheres(benchmark::State& state, Operation operation, const std::string& family) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<Solid> operands{shapes::solid(ball(n, 0.0)), shapes::solid(ball(n, 0.7))};
  const double size = static_cast<double>(operands[0].face_count() + operands[1].face_count());
  timed(state, family, size, [&] { benchmark::DoNotOptimize(combine(operands, operation).value()); });
}

void boxes(benchmark::State& state) {
  std::vector<Solid> operands;
  for (long i = 0; i < state.range(0); ++i) {
    const auto x = static_cast<double>(i);
    operands.push_back(shapes::box_solid({x, 0, 0}, {x + 1.5, 1.0 + 0.001 * x, 1.0}));
  }
  timed(state, "boxes", 6.0 * static_cast<double>(operands.size()),
        [&] { benchmark::DoNotOptimize(combine(operands, Operation::Union).value()); });
}

void menger(benchmark::State& state) {
  const int depth = static_cast<int>(state.range(0));
  const std::vector<Solid> operands = shapes::menger_operands(depth, depth < 4 ? 27.0 : 81.0);
  timed(state, "menger", 6.0 * static_cast<double>(operands.size()),
        [&] { benchmark::DoNotOptimize(combine(operands, Operation::Difference).value()); });
}

constexpr int located = 1000;

/// A thousand points; ns_face is per point.
void locate(benchmark::State& state) {
  const PointLocator locator(shapes::solid(ball(static_cast<std::size_t>(state.range(0)), 0.0)));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> real(-1.1, 1.1);
  std::vector<geom::Point3> points;
  for (int i = 0; i < located; ++i) points.push_back({real(random), real(random), real(random)});
  const double size = static_cast<double>(state.range(0));
  timed(state, "locate", size, [&] {
    for (const geom::Point3 p : points) benchmark::DoNotOptimize(locator.locate(p));
  });
}

void cut_sphere(benchmark::State& state) {
  const std::vector<Solid> solids{shapes::solid(ball(static_cast<std::size_t>(state.range(0)), 0.0))};
  const Sections sections(solids);
  timed(state, "cut_sphere", static_cast<double>(state.range(0)), [&] {
    benchmark::DoNotOptimize(sections.cut({1.0, 0.3, 0.2, 0.1}).value());
  });
}

/// Units that lie on each other, folded differently in each section, 20 points a horizon.
std::vector<Solid> block_of(int units, int sections) {
  const auto height = [&](int horizon, double x, int section) {
    return 10.0 * horizon + 3.0 * std::sin(0.02 * x + 0.1 * section) + 0.001 * horizon * std::cos(0.05 * x);
  };
  std::vector<shape::LoftSection> all;
  for (int s = 0; s < sections; ++s) {
    shape::LoftSection section{{{0.0, 100.0 * s, 0.0}, {1, 0, 0}, {0, 0, 1}}, {}};
    const auto unit = [&](int i) { return i < 0 || i >= units ? std::string() : fmt::format("unit {}", i); };
    for (int h = 0; h <= units; ++h) {
      geom::Polyline line;
      for (int i = 0; i <= 20; ++i) line.points.push_back({50.0 * i, height(h, 50.0 * i, s)});
      section.lines.push_back({std::move(line), fmt::format("horizon {}", h), unit(h), unit(h - 1)});
      if (h == units) continue;
      for (const double x : {0.0, 1000.0}) {
        section.lines.push_back({{{{x, height(h, x, s)}, {x, height(h + 1, x, s)}}, false},
                                 x == 0.0 ? "west" : "east",
                                 x == 0.0 ? std::string() : unit(h),
                                 x == 0.0 ? unit(h) : std::string()});
      }
    }
    all.push_back(std::move(section));
  }
  std::vector<Solid> solids;
  const auto parts = shape::loft_sections(all).value();
  for (const shape::LoftPart& part : parts) solids.push_back(shape::solid_of(part.shape).value());
  return solids;
}

/// A plane that is dragged over a block: at a slant to the sections, and along them.
void cut_block(benchmark::State& state) {
  const std::vector<Solid> solids = block_of(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const Sections sections(solids);
  double faces = 0.0;
  for (const Solid& solid : solids) faces += static_cast<double>(solid.face_count());
  state.counters["faces"] = faces;
  double shift = 0.0;
  for (auto _ : state) {
    shift += 1.0;
    const auto cut = sections.cut({state.range(2) == 0 ? 0.5 : 0.0, 1.0, 0.0, -1000.0 - shift}).value();
    state.counters["lines"] = static_cast<double>(cut.plane.edge_count());
    const Cap cap = cap_of(cut);
    state.counters["regions"] = static_cast<double>(cap.regions.size());
  }
}

// --- pairs of meshes as one finds them ------------------------------------------------------------------------------

/// A closed surface over two angles; at(u, v) for both from 0 to 1, v turning left seen against u from outside.
template <class At>
mesh::PolygonMesh ring(std::uint32_t along, std::uint32_t around, At&& at) {
  mesh::PolygonMesh mesh;
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j)
      mesh.points.push_back(at(static_cast<double>(i) / along, static_cast<double>(j) / around));
  }
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const std::uint32_t here = i * around;
      const std::uint32_t next = (i + 1) % along * around;
      const std::uint32_t k = (j + 1) % around;
      mesh.faces.push_back({here + j, next + j, next + k});
      mesh.faces.push_back({here + j, next + k, here + k});
    }
  }
  return mesh;
}

constexpr double turn = 2.0 * std::numbers::pi;

mesh::PolygonMesh torus(double triangles) {
  const auto around = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 6.0)));
  return ring(3 * around, around, [](double u, double v) {
    const double r = 0.75 + 0.25 * std::cos(turn * v);
    return geom::Point3{r * std::cos(turn * u), r * std::sin(turn * u), 0.25 * std::sin(turn * v)};
  });
}

/// A wheel with a bore and teeth that run aslant.
mesh::PolygonMesh gear(double triangles) {
  constexpr std::uint32_t teeth = 24;
  const auto around = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 24.0)));
  return ring(12 * around, around, [](double u, double v) {
    // Round a square: outwards, up, inwards, down.
    const double side = std::max(std::abs(std::cos(turn * v)), std::abs(std::sin(turn * v)));
    const double out = std::cos(turn * v) / side;
    const double up = std::sin(turn * v) / side;
    const double tooth = 0.12 * std::clamp(2.0 * std::cos(turn * teeth * u + up), -1.0, 1.0);
    const double r = 0.6 + 0.25 * out + std::max(0.0, out) * tooth;
    return geom::Point3{r * std::cos(turn * u), r * std::sin(turn * u), 0.3 * up};
  });
}

/// A tube along a trefoil.
mesh::PolygonMesh knot(double triangles) {
  const auto around = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 24.0)));
  const auto path = [](double u) {
    const double r = 0.65 + 0.28 * std::cos(3.0 * turn * u);
    return geom::Point3{r * std::cos(2.0 * turn * u), r * std::sin(2.0 * turn * u), 0.28 * std::sin(3.0 * turn * u)};
  };
  return ring(12 * around, around, [&](double u, double v) {
    const geom::Vector3 ahead = normalised(path(u + 1e-5) - path(u - 1e-5));
    const geom::Vector3 across = normalised(cross(ahead, geom::Vector3{0, 0, 1}));
    const geom::Vector3 up = cross(across, ahead);
    return path(u) + 0.1 * (std::cos(turn * v) * across + std::sin(turn * v) * up);
  });
}

mesh::PolygonMesh hills(double triangles) {
  const auto cells = static_cast<std::uint32_t>(std::lround(std::sqrt(triangles / 2.0)));
  return shapes::terrain(cells, cells, -0.8, [&](std::uint32_t i, std::uint32_t j) {
    const double x = 2.0 * i / cells - 1.0;
    const double y = 2.0 * j / cells - 1.0;
    return geom::Point3{x, y, 0.2 * std::sin(5.0 * x + 1.0) * std::cos(4.0 * y) + 0.03 * std::sin(31.0 * x + 17.0 * y)};
  });
}

mesh::PolygonMesh ball_of(double triangles) { return ball(static_cast<std::size_t>(triangles), 0.0); }

/// What pairs of meshes cost, in ms: to read, and to unite.
struct PairTimes {
  std::vector<double> read, unite;
  [[nodiscard]] static double mean(const std::vector<double>& times) {
    return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  }
  [[nodiscard]] static double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return 0.5 * (times[(times.size() - 1) / 2] + times[times.size() / 2]);
  }
};

template <class Work>
double median_ms(int rounds, Work&& work) {
  std::vector<double> times;
  for (int i = 0; i < rounds; ++i) {
    const double begin = process_seconds();
    work();
    times.push_back(1e3 * (process_seconds() - begin));
  }
  return PairTimes::median(times);
}

/// Unions of every two kinds of meshes, two sizes each, 20 000 to 200 000 triangles a pair, both turned so that nothing
/// coincides; of each the median of five. Set beside the published times of the fastest peer on such pairs.
void pairs(benchmark::State& state) {
  constexpr std::array kinds{ball_of, torus, gear, hills, knot};
  constexpr int count = static_cast<int>(kinds.size() * (kinds.size() + 1));
  PairTimes times;
  double least = 1e9;
  double most = 0.0;
  int pair = 0;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) {
      for (int round = 0; round < 2; ++round, ++pair) {
        // Sizes are spread by equal factors, in an order in which neighbours are far apart; the share of the first goes
        // from a quarter to three.
        const double size = 2e4 * std::pow(10.0, (7 * pair % count) / (count - 1.0));
        const double share = 0.25 + 0.5 * (11 * pair % count) / (count - 1.0);
        const double angle = 0.3 + 0.17 * pair;
        const mesh::PolygonMesh first = shapes::rotated(kinds[a](share * size), {3, 1, 2}, angle);
        const mesh::PolygonMesh second = shapes::moved(
            shapes::rotated(kinds[b]((1.0 - share) * size), {1, 2, -1}, 1.9 * angle), {0.31, 0.23, 0.17 * (1 + round)});
        const auto triangles = static_cast<double>(first.faces.size() + second.faces.size());
        least = std::min(least, triangles);
        most = std::max(most, triangles);
        std::vector<Solid> operands;
        times.read.push_back(median_ms(1, [&] { operands = {shapes::solid(first), shapes::solid(second)}; }));
        std::optional<Combined> both;
        times.unite.push_back(median_ms(5, [&] { both = combine(operands, Operation::Union).value(); }));
        const double whole = measure(both->solid).volume;
        const double va = measure(operands[0]).volume;
        const double vb = measure(operands[1]).volume;
        if (both->contact != Contact::Volume || !(whole > std::max(va, vb)) || !(whole < va + vb))
          state.SkipWithError(fmt::format("pair {} does not overlap", pair).c_str());
      }
    }
  }
  for (auto _ : state) state.SetIterationTime(1e-3 * PairTimes::median(times.unite));
  state.counters["pairs"] = static_cast<double>(times.unite.size());
  state.counters["triangles_least"] = least;
  state.counters["triangles_most"] = most;
  state.counters["median_ms"] = PairTimes::median(times.unite);
  state.counters["mean_ms"] = PairTimes::mean(times.unite);
  state.counters["most_ms"] = *std::max_element(times.unite.begin(), times.unite.end());
  state.counters["read_median_ms"] = PairTimes::median(times.read);
  state.counters["read_mean_ms"] = PairTimes::mean(times.read);
}

#ifdef DOBRA_CGAL
void nef(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const mesh::PolygonMesh a = ball(n, 0.0);
  const mesh::PolygonMesh b = ball(n, 0.7);
  const std::vector<Solid> operands{shapes::solid(a), shapes::solid(b)};
  for (auto _ : state) {
    const double begin = process_seconds();
    const Solid ours = combine(operands, Operation::Union).value().solid;
    const double spent = process_seconds() - begin;
    state.SetIterationTime(spent);
    const bench::NefUnion theirs = bench::cgal_nef_union(a, b);
    if (theirs.vertices != ours.counts().vertices) state.SkipWithError("the two unions differ");
    state.counters["nef_ms"] = 1e3 * theirs.seconds;
    state.counters["ratio"] = theirs.seconds / spent;
  }
}
BENCHMARK(nef)->Arg(1000)->Arg(10000)->Arg(100000)->UseManualTime()->Unit(benchmark::kMillisecond);
#endif

BENCHMARK(locate)->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(cut_sphere)->Arg(10000)->Arg(100000)->Arg(1000000)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(cut_block)->Args({200, 100, 0})->Args({200, 100, 1})->Unit(benchmark::kMillisecond);
BENCHMARK(read)->Arg(1000)->Arg(10000)->Arg(100000)->Arg(1000000)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, unite, Operation::Union, "unite")
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, common, Operation::Intersection, "common")
    ->Arg(100000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spheres, subtract, Operation::Difference, "subtract")
    ->Arg(100000)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(boxes)->Arg(10)->Arg(100)->Arg(1000)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(pairs)->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(menger)->Arg(1)->Arg(2)->Arg(3)->Arg(4)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
