// Speed of the Delaunay kernel and of both engines of the mesher, one thread, beside gmsh's frontal mesher on the same
// boundary in the same run where the program `gmsh` is installed, and beside CGAL's Mesh_2 where its headers are. Ten
// million triangles: DOBRA_BENCH_LARGE=1.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/quality.h"
#include "tests/bench/heap.h"
#include "tests/bench/mesh_peers.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace {

using namespace dobra::mesh;

/// Seconds of processor time: on a busy machine fairer to both than the clock on the wall.
double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Random points in a square; items are points.
void delaunay_of_random_points(benchmark::State& state) {
  const auto points = test::random_points(static_cast<std::size_t>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(dobra::mesh::delaunay::delaunay(points));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(delaunay_of_random_points)->RangeMultiplier(10)->Range(1'000, 1'000'000)->Unit(benchmark::kMillisecond);

using bench::Peer;

/// What gmsh reports for its 2D mesh of the outline `input`; 0 seconds without gmsh.
Peer gmsh_frontal(const dobra::mesh::delaunay::MeshInput& input) {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string geo = (folder / "dobra_mesh_bench.geo").string();
  const std::string log = (folder / "dobra_mesh_bench.log").string();
  std::ofstream out(geo);
  out.precision(17);
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    out << "Point(" << i + 1 << ") = {" << input.points[i].x << ", " << input.points[i].y << ", 0};\n";
  }
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    out << "Line(" << i + 1 << ") = {" << input.edges[i].nodes[0].index() + 1 << ", "
        << input.edges[i].nodes[1].index() + 1 << "};\n";
  }
  out << "Transfinite Line {1:" << input.edges.size() << "} = 2;\nLine Loop(1) = {1:" << input.edges.size()
      << "};\nPlane Surface(1) = {1};\nMesh.Algorithm = 6;\n";
  out.close();
  const std::string command = "gmsh -2 -nt 1 -v 4 -o /dev/null -format msh2 " + geo + " > " + log + " 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  Peer peer;
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (const auto at = line.find("Done meshing 2D"); at != std::string::npos) {
      peer.seconds = std::atof(line.c_str() + line.find("CPU ", at) + 4);
    }
    if (const auto at = line.find(" elements"); at != std::string::npos && line.find(" nodes ") != std::string::npos) {
      const auto from = line.find(" nodes ") + 7;
      peer.triangles = std::atof(line.c_str() + from) - static_cast<double>(input.edges.size() + input.points.size());
    }
  }
  return peer;
}

enum class Beside { Nobody, Gmsh, Cgal };

void mesh(benchmark::State& state, const dobra::mesh::delaunay::MeshInput& input, double growth,
          dobra::mesh::front::Engine engine, Beside beside = Beside::Nobody) {
  dobra::mesh::front::MeshOptions options;
  options.engine = engine;
  options.sizes.growth = growth;
  options.points.max_triangles = 20'000'000;
  MeshQuality quality;
  std::size_t peak = 0;
  double fastest = 1e30;
  for (auto _ : state) {
    const std::size_t before = heap::in_use;
    heap::peak = before;
    const double start = processor_time();
    const auto result = triangulate(input, options);
    fastest = std::min(fastest, processor_time() - start);
    if (!result) {
      state.SkipWithError(result.error().message.c_str());
      return;
    }
    state.PauseTiming();
    peak = heap::peak - before;
    quality = quality_of(*result);
    state.ResumeTiming();
  }
  const auto triangles = static_cast<double>(quality.triangles);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(quality.triangles));
  state.counters["triangles"] = triangles;
  state.counters["alpha_mean"] = quality.alpha_mean;
  state.counters["alpha_90"] = quality.alpha_90;
  state.counters["alpha_min"] = quality.alpha_min;
  state.counters["gradation_p95"] = quality.gradation_p95;
  state.counters["bytes_a_triangle"] = static_cast<double>(peak) / triangles;
  const auto compare = [&](const std::string& name, const Peer& peer) {
    if (peer.seconds == 0.0) return;
    state.counters[name + "_triangles"] = peer.triangles;
    state.counters[name + "_per_second"] = peer.triangles / peer.seconds;
    state.counters["times_" + name] = triangles / fastest / (peer.triangles / peer.seconds);
  };
  if (beside == Beside::Gmsh) compare("gmsh", gmsh_frontal(input));
#ifdef DOBRA_CGAL
  if (beside == Beside::Cgal) compare("cgal", bench::cgal_mesh_2(input));
#endif
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const std::int64_t count : {10'000, 40'000, 160'000, 400'000, 1'600'000}) benchmark->Arg(count);
  if (std::getenv("DOBRA_BENCH_LARGE") != nullptr) benchmark->Arg(10'000'000);
  benchmark->Unit(benchmark::kMillisecond);
}
void few_sizes(benchmark::internal::Benchmark* benchmark) {
  for (const std::int64_t count : {10'000, 160'000, 1'600'000}) benchmark->Arg(count);
  benchmark->Unit(benchmark::kMillisecond);
}

/// [0,10]^2 minus r < 1, all sides equal; about `range` triangles, which are the items.
void uniform_plate(benchmark::State& state, dobra::mesh::front::Engine engine) {
  const auto count = state.range(0);
  Beside beside = count == 40'000 ? Beside::Gmsh : Beside::Nobody;
  if (count == 1'600'000 && engine == dobra::mesh::front::Engine::Front) beside = Beside::Cgal;
  mesh(state, test::uniform_plate(static_cast<double>(count)), 1.3, engine, beside);
}
BENCHMARK_CAPTURE(uniform_plate, front, dobra::mesh::front::Engine::Front)->Apply(sizes);
BENCHMARK_CAPTURE(uniform_plate, delaunay, dobra::mesh::front::Engine::Delaunay)->Apply(few_sizes);

/// The same, a thousand times as large in the far corner as on the hole.
void graded_plate(benchmark::State& state, dobra::mesh::front::Engine engine) {
  const auto plate = test::graded_plate(static_cast<double>(state.range(0)));
  mesh(state, plate.input, plate.growth, engine, state.range(0) == 40'000 ? Beside::Gmsh : Beside::Nobody);
}
BENCHMARK_CAPTURE(graded_plate, front, dobra::mesh::front::Engine::Front)->Apply(sizes);
BENCHMARK_CAPTURE(graded_plate, delaunay, dobra::mesh::front::Engine::Delaunay)->Apply(few_sizes);

/// Sizes about 1:600 along the axes from the hole outwards, growing by a third an element: steep.
void steep_plate(benchmark::State& state, dobra::mesh::front::Engine engine) {
  mesh(state, test::quarter_plate(test::graded(1.0, 5.0, 88, 1.075), 1570, 10, {}), 1.3, engine);
}
BENCHMARK_CAPTURE(steep_plate, front, dobra::mesh::front::Engine::Front)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(steep_plate, delaunay, dobra::mesh::front::Engine::Delaunay)->Unit(benchmark::kMillisecond);

void constrained_plate(benchmark::State& state, dobra::mesh::front::Engine engine) {
  mesh(state, test::que_e(), 1.3, engine);
}
BENCHMARK_CAPTURE(constrained_plate, front, dobra::mesh::front::Engine::Front)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(constrained_plate, delaunay, dobra::mesh::front::Engine::Delaunay)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
