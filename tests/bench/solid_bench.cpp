// Speed of solids, one thread: two spheres of n triangles each that overlap (the second turned, so that nothing
// coincides), read (from_mesh) and combined by union, intersection and difference; a union of m boxes of which each
// overlaps its neighbour; Menger sponges; points that are located in a sphere; plane sections of a sphere and of a
// block of units through many sections; where CGAL is installed, the union of the spheres by its Nef polyhedra beside
// ours (counters nef_ms, ratio). Counters: ns_face per triangle that went in, exponent of the time in n since the size
// before. Figures belong in docs/algorithms/boolean.md.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <map>

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
BENCHMARK(menger)->Arg(1)->Arg(2)->Arg(3)->Arg(4)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
