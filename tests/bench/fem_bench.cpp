// Assembly and solution of a T6 plate at 1e4 to 1e6 unknowns, and the same plate by CalculiX in the same run; a whole
// adaptive run.

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "quebra/analysis/deck.h"
#include "quebra/core/operations.h"
#include "shared/fem/error/estimate.h"
#include "shared/fem/solve.h"
#include "shared/io/file.h"
#include "shared/scenario/runner.h"
#include "tests/support/fem_meshes.h"

namespace {

using namespace dobra;

mesh::ElementMesh plate(std::int64_t cells) {
  return fem::test::mapped_grid(mesh::ElementType::T6, static_cast<int>(cells), static_cast<int>(cells),
                                fem::test::unit_square);
}

fem::Problem pulled() {
  fem::Problem problem{.materials = {{0, {.young = 1000.0, .poisson = 0.3, .state = fem::PlaneState::Strain}}},
                       .supports = {{.where = "left", .x = 0.0, .y = 0.0}}};
  problem.cases[0].sides = {{"right", fem::uniform({1.0, 0.0})}};
  return problem;
}

/// Everything from the mesh to displacements and reactions; the growth exponent is the last line of the output.
void assemble_and_solve(benchmark::State& state) {
  const mesh::ElementMesh mesh = plate(state.range(0));
  fem::SolverStatistics statistics;
  for (auto _ : state) statistics = fem::solve(mesh, pulled())->statistics;
  state.SetComplexityN(static_cast<std::int64_t>(statistics.unknowns));
  state.counters["unknowns"] = static_cast<double>(statistics.unknowns);
  state.counters["factor_entries"] = statistics.factor_entries;
  state.counters["estimated_MB"] = statistics.memory_estimate / 1e6;
}
BENCHMARK(assemble_and_solve)->Arg(35)->Arg(100)->Arg(350)->Unit(benchmark::kSecond)->Iterations(1)->Complexity();

void recover_and_estimate(benchmark::State& state) {
  const mesh::ElementMesh mesh = plate(state.range(0));
  const fem::Problem problem = pulled();
  const auto solution = fem::solve(mesh, problem).value();
  const auto& u = solution.cases[0].displacements;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        fem::error::estimate_error(mesh, problem.materials, u, fem::error::recover_stress(mesh, problem.materials, u)));
}
BENCHMARK(recover_and_estimate)->Arg(35)->Arg(100)->Unit(benchmark::kSecond);

/// 81 k unknowns; the counter tells how many times longer CalculiX takes for its whole run.
void against_calculix(benchmark::State& state) {
  const mesh::ElementMesh mesh = plate(100);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "dobra_fem_bench";
  std::filesystem::create_directories(folder);
  if (!io::write_file(folder / "deck.inp", quebra::analysis::deck_text(mesh, pulled()).value())) return;
  const auto seconds = [](auto&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  double ours = 0.0, theirs = 0.0;
  bool ran = true;
  for (auto _ : state) {
    ours += seconds([&] { benchmark::DoNotOptimize(fem::solve(mesh, pulled())); });
    theirs +=
        seconds([&] { ran = std::system(("cd " + folder.string() + " && ccx -i deck > ccx.log 2>&1").c_str()) == 0; });
  }
  std::filesystem::remove_all(folder);
  if (!ran) state.SkipWithError("ccx did not run");
  state.counters["calculix_over_dobra"] = theirs / ours;
}
BENCHMARK(against_calculix)->Unit(benchmark::kSecond)->Iterations(3);

/// Kirsch's plate from the scenario's text to the error asked for: every cycle meshed, solved, judged.
void adapt_kirsch(benchmark::State& state) {
  const std::string text = R"(dobra = 1
program = "quebra"
[input]
specimen = "quarter_plate"
width = 4.0
radius = 1.0
[[step]]
operation = "problem"
[[step.material]]
young = 1000.0
[[step.support]]
where = "bottom"
normal = 0.0
[[step.support]]
where = "left"
normal = 0.0
[[step.load]]
where = "right"
kind = "kirsch"
value = 1.0
[[step.load]]
where = "top"
kind = "kirsch"
value = 1.0
[[step]]
operation = "adapt"
target = )" + std::to_string(static_cast<double>(state.range(0)) / 100.0) +
                           "\norder = \"" + std::to_string(state.range(1)) + "\"\nmax_cycles = 20\n";
  const auto document = scenario::parse_document(text, "kirsch.toml").value();
  double unknowns = 0.0, eta = 0.0, cycles = 0.0;
  for (auto _ : state) {
    scenario::Runner runner(quebra::core::program());
    const scenario::Run run = runner.run(document);
    for (const auto& quantity : quebra::core::program().quantities_of(run.states.back())) {
      if (quantity.name == "unknowns") unknowns = quantity.value;
      if (quantity.name == "eta") eta = quantity.value;
      if (quantity.name == "cycles") cycles = quantity.value;
    }
  }
  state.counters["unknowns"] = unknowns;
  state.counters["eta_percent"] = eta;
  state.counters["cycles"] = cycles;
}
BENCHMARK(adapt_kirsch)
    ->ArgNames({"eta_1e-4", "order"})
    ->Args({100, 2})
    ->Args({100, 1})
    ->Args({1, 2})
    ->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
