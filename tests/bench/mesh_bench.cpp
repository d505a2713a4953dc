// Speed of the Delaunay kernel and of the mesher. Run in the `bench` preset; one thread.

#include <benchmark/benchmark.h>

#include "shared/mesh/delaunay.h"
#include "shared/mesh/quality.h"
#include "shared/mesh/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace {

using namespace dobra::mesh;

/// Random points in a square; items are points.
void delaunay_of_random_points(benchmark::State& state) {
  const auto points = test::random_points(static_cast<std::size_t>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(delaunay(points));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(delaunay_of_random_points)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

void mesh(benchmark::State& state, const MeshInput& input) {
  MeshQuality quality;
  for (auto _ : state) {
    const auto result = triangulate(input);
    if (!result) {
      state.SkipWithError(result.error().message.c_str());
      return;
    }
    state.PauseTiming();
    quality = quality_of(*result);
    state.ResumeTiming();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(quality.triangles));
  state.counters["triangles"] = static_cast<double>(quality.triangles);
  state.counters["alpha_mean"] = quality.alpha_mean;
  state.counters["alpha_90"] = quality.alpha_90;
  state.counters["alpha_min"] = quality.alpha_min;
  state.counters["gradation_p95"] = quality.gradation_p95;
}

/// Quarter plate with uniform sizes, n segments a side; items are triangles.
void uniform_plate(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  mesh(state, test::quarter_plate(test::graded(1.0, 5.0, n * 4 / 5, 1.0), n * 314 / 1000, n, {}));
}
BENCHMARK(uniform_plate)->Arg(50)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);

/// Sizes about 1:600 along the axes from the hole outwards; items are triangles.
void graded_plate(benchmark::State& state) {
  mesh(state, test::quarter_plate(test::graded(1.0, 5.0, 88, 1.075), 1570, 10, {}));
}
BENCHMARK(graded_plate)->Unit(benchmark::kMillisecond);

void constrained_plate(benchmark::State& state) { mesh(state, test::que_e()); }
BENCHMARK(constrained_plate)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
