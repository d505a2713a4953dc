// Speed of solids, one thread: two spheres of n triangles each that overlap (the second turned, so that nothing
// coincides), read (from_mesh) and combined by union, intersection and difference; a union of m boxes of which each
// overlaps its neighbour; Menger sponges. Counters: ns_face per triangle that went in, exponent of the time in n since
// the size before. Figures belong in docs/algorithms/boolean.md.

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <map>

#include "tests/shared/solid/shapes.h"

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
  const std::vector<Solid> operands = shapes::menger_operands(static_cast<int>(state.range(0)));
  timed(state, "menger", 6.0 * static_cast<double>(operands.size()),
        [&] { benchmark::DoNotOptimize(combine(operands, Operation::Difference).value()); });
}

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
BENCHMARK(menger)->Arg(1)->Arg(2)->Arg(3)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
