// Restoration: whole sections, single maps, a pin that is moved, growth with the number of points, Monte Carlo. A peer
// in the same run: the least work that a map can be (an affine transformation of as many points), so that ratios do not
// depend on the machine. "Time" is by the clock, "CPU" what all threads took: on a busy machine half of that is what
// two free cores would need.

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "recon/core/grid_step.h"
#include "recon/core/monte_carlo_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/jigsaw/blockwise.h"
#include "recon/moving/move_section.h"
#include "recon/section/section_faces.h"
#include "shared/geom/transform.h"

namespace recon::core {
namespace {

/// A fold train of `horizons` beds, `points` each, over 10 km.
section::Section fold_train(std::size_t horizons, std::size_t points) {
  section::Section section;
  for (std::size_t h = 0; h < horizons; ++h) {
    geom::Polyline line;
    const double depth = 1000.0 * static_cast<double>(h) / static_cast<double>(horizons);
    for (std::size_t i = 0; i < points; ++i) {
      const double x = 10000.0 * static_cast<double>(i) / static_cast<double>(points - 1);
      line.points.push_back({x, 150.0 * (1.0 - 0.3 * depth / 1000.0) * std::sin(x / 600.0) - depth});
    }
    section.horizons.push_back({section::HorizonId(h), "h" + std::to_string(h), std::move(line), {}});
  }
  return section;
}

unfold::GridParams grid_of(int curves) {
  unfold::GridParams params;
  params.count = curves;
  return params;
}

unfold::RestoreParams by(unfold::RestoreMethod method) {
  unfold::RestoreParams params;
  params.method = method;
  return params;
}

unfold::TargetParams pinned(double x) {
  unfold::TargetParams params;
  params.pin = x;
  return params;
}

/// As reading leaves it: with its units.
model::Model start(std::size_t horizons, std::size_t points) {
  model::Model model;
  model.section = fold_train(horizons, points);
  model.section.faces = std::make_shared<const section::SectionFaces>(faces_of(model.section).value());
  return model;
}

/// The planar subdivision of a section and its units, made once when it is read.
void find_units(benchmark::State& state) {
  const section::Section section =
      fold_train(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(faces_of(section));
}
BENCHMARK(find_units)
    ->Args({10, 1000})
    ->Args({100, 1000})
    ->Args({100, 10000})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void restore_whole_section(benchmark::State& state) {
  const model::Model model = start(static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)));
  for (auto _ : state) {
    const model::Model with_grid = run_grid(model, grid_of(20), {}, {}).value();
    const model::Model with_target = run_target(with_grid, pinned(5000.0), {}, {}).value();
    benchmark::DoNotOptimize(run_restore(with_target, by(unfold::RestoreMethod::Constant), {}, {}).value());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1));
}
BENCHMARK(restore_whole_section)
    ->Args({100, 1000})
    ->Args({100, 10000})
    ->Args({100, 30000})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void restore_with_grid_there(benchmark::State& state) {
  const auto horizons = static_cast<std::size_t>(state.range(0));
  const auto points = static_cast<std::size_t>(state.range(1));
  const model::Model model = start(horizons, points);
  const model::Model ready = run_target(run_grid(model, grid_of(20), {}, {}).value(), pinned(5000.0), {}, {}).value();
  const auto method = static_cast<unfold::RestoreMethod>(state.range(2));
  state.SetLabel(method_name(method));
  for (auto _ : state) benchmark::DoNotOptimize(run_restore(ready, by(method), {}, {}).value());
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1));
}
BENCHMARK(restore_with_grid_there)
    ->ArgsProduct({{100}, {10000}, {0, 1, 2, 3, 4, 5}})
    ->ArgsProduct({{50}, {4001}, {0, 1, 2, 3, 4, 5}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Ten blocks of 20 folded beds between nine normal faults, 50 points a bed in each block: 10 000 points.
section::Section ten_blocks() {
  constexpr int blocks = 10, beds = 20, points = 50;
  section::Section section;
  const auto wall = [](int block, double z) { return 1000.0 * block - 0.5 * z; };
  for (int bed = 0; bed < beds; ++bed) {
    for (int block = 0; block < blocks; ++block) {
      const double z = -50.0 * bed, from = block == 0 ? 0.0 : wall(block, z);
      const double to = block + 1 == blocks ? 11000.0 : wall(block + 1, z);
      geom::Polyline line;
      for (int i = 0; i < points; ++i) {
        const double part = static_cast<double>(i) / (points - 1);
        line.points.push_back({from + (to - from) * part + 40.0 * block,
                               z - 80.0 * block + 20.0 * (1.0 - std::cos(6.283185307179586 * part))});
      }
      section.horizons.push_back({section::HorizonId(section.horizons.size()),
                                  "h" + std::to_string(bed) + " (" + std::to_string(block + 1) + ")",
                                  line,
                                  {},
                                  "h" + std::to_string(bed)});
    }
  }
  for (int k = 1; k < blocks; ++k) {
    const geom::Vector slid{40.0 * k, -80.0 * k};
    section.lines.push_back(
        {section::LineId(static_cast<std::size_t>(k - 1)),
         section::LineKind::Fault,
         "F" + std::to_string(k),
         {{geom::Point{wall(k, -1400), -1400} + slid, geom::Point{wall(k, 400), 400} + slid}, false},
         {}});
  }
  return section;
}

void whole_jigsaw(benchmark::State& state) {
  const section::Section section = ten_blocks();
  const unfold::RestoreParams params = by(static_cast<unfold::RestoreMethod>(state.range(0)));
  state.SetLabel(method_name(params.method));
  jigsaw::BlockwiseParams how;
  how.jigsaw = true;
  for (auto _ : state) benchmark::DoNotOptimize(restore_blockwise(section, how, params, {}).value());
  state.SetItemsProcessed(state.iterations() * 10000);
}
BENCHMARK(whole_jigsaw)
    ->Arg(0)
    ->Arg(3)
    ->Arg(4)
    ->Arg(5)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

std::vector<geom::Point> all_points(const section::Section& section) {
  std::vector<geom::Point> points;
  for (const section::Horizon& horizon : section.horizons)
    points.insert(points.end(), horizon.line.points.begin(), horizon.line.points.end());
  return points;
}

void map_points(benchmark::State& state) {
  const model::Model model = start(100, 10000);
  const model::Model ready = run_target(run_grid(model, grid_of(1), {}, {}).value(), pinned(5000.0), {}, {}).value();
  unfold::MethodParams params;
  params.method = static_cast<unfold::RestoreMethod>(state.range(0));
  state.SetLabel(method_name(params.method));
  const maps::SectionMap map = make_method_map(ready.section, *ready.source, *ready.target, params).value().map;
  const std::vector<geom::Point> points = all_points(model.section);
  std::vector<geom::Point> images(points.size());
  for (auto _ : state) {
    benchmark::DoNotOptimize(map.forward(points, images));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(map_points)->DenseRange(0, 5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void affine_peer(benchmark::State& state) {
  const std::vector<geom::Point> points = all_points(fold_train(100, 10000));
  std::vector<geom::Point> images(points.size());
  const geom::Transform turn = geom::Transform::rotation(dobra::base::Angle::from_degrees(20.0));
  for (auto _ : state) {
    for (std::size_t i = 0; i < points.size(); ++i) images[i] = turn(points[i]);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(affine_peer)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// A drag of the pin: target and restoration of 10 x 1000 points.
void move_the_pin(benchmark::State& state) {
  const model::Model with_grid = run_grid(start(10, 1000), grid_of(20), {}, {}).value();
  const auto method = static_cast<unfold::RestoreMethod>(state.range(0));
  state.SetLabel(method_name(method));
  double x = 3000.0;
  for (auto _ : state) {
    x += 1.0;
    const model::Model with_target = run_target(with_grid, pinned(x), {}, {}).value();
    benchmark::DoNotOptimize(run_restore(with_target, by(method), {}, {}).value());
  }
}
BENCHMARK(move_the_pin)->DenseRange(0, 5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// Processor seconds of one restoration with the grid there, the least of three.
double seconds_of(std::size_t points, unfold::RestoreMethod method) {
  const model::Model ready =
      run_target(run_grid(start(20, points), grid_of(1), {}, {}).value(), pinned(5000.0), {}, {}).value();
  double least = 1e300;
  for (int i = 0; i < 3; ++i) {
    const std::clock_t begin = std::clock();
    benchmark::DoNotOptimize(run_restore(ready, by(method), {}, {}).value());
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

/// time = n^exponent between 20 x 2500 and 20 x 50 000 points.
void growth(benchmark::State& state) {
  const auto method = static_cast<unfold::RestoreMethod>(state.range(0));
  state.SetLabel(method_name(method));
  for (auto _ : state) {
    const double small = seconds_of(2500, method);
    const double large = seconds_of(50000, method);
    state.counters["ns_point_small"] = small / 50000.0 * 1e9;
    state.counters["ns_point_large"] = large / 1000000.0 * 1e9;
    state.counters["exponent"] = std::log(large / small) / std::log(20.0);
  }
}
BENCHMARK(growth)->DenseRange(0, 5)->Iterations(1)->Unit(benchmark::kSecond)->MeasureProcessCPUTime()->UseRealTime();

void monte_carlo_draws(benchmark::State& state) {
  const model::Model with_target =
      run_target(run_grid(start(10, 500), grid_of(1), {}, {}).value(), pinned(5000.0), {}, {}).value();
  const model::Model ready = run_restore(with_target, by(unfold::RestoreMethod::Flexural), {}, {}).value();
  unfold::MonteCarloParams params;
  params.draws = static_cast<int>(state.range(0));
  params.pick_error = 5.0;
  params.pin_error = 50.0;
  for (auto _ : state) benchmark::DoNotOptimize(run_monte_carlo(ready, params, {}, {}).value());
}
BENCHMARK(monte_carlo_draws)->Arg(500)->Arg(10000)->Unit(benchmark::kSecond)->MeasureProcessCPUTime()->UseRealTime();

/// Ten blocks between nine listric faults that dip to +x, 20 horizons that the first one cuts, `points` in all.
section::Section faulted(std::size_t points) {
  section::Section section;
  constexpr std::size_t horizons = 20;
  for (std::size_t h = 0; h < horizons; ++h) {
    geom::Polyline line;
    for (std::size_t i = 0; i < points / horizons; ++i) {
      const double x = 22000.0 * static_cast<double>(i) / static_cast<double>(points / horizons - 1);
      line.points.push_back({x, 20.0 * std::sin(x / 700.0) - 100.0 - 60.0 * static_cast<double>(h)});
    }
    section.horizons.push_back({section::HorizonId(h), "h" + std::to_string(h), std::move(line), {}});
  }
  for (std::size_t f = 0; f < 9; ++f) {
    geom::Polyline fault;
    for (int i = 0; i <= 30; ++i) {
      const double along = 2.0 * i / 30.0;
      fault.points.push_back({2000.0 * static_cast<double>(f + 1) + 1000.0 * along,
                              100.0 - 1700.0 * (1.0 - std::exp(-1.5 * along)) / (1.0 - std::exp(-3.0))});
    }
    section.lines.push_back({section::LineId(f), section::LineKind::Fault, "f" + std::to_string(f), fault, {}});
  }
  section.border = geom::Polyline{{{0, -1600}, {22000, -1600}, {22000, 0}, {0, 0}}, true};
  return section;
}

void move_blocks(benchmark::State& state) {
  const section::Section section = faulted(static_cast<std::size_t>(state.range(0)));
  moving::MoveParams params;
  params.fault = "f0";
  params.method = static_cast<moving::MoveMethod>(state.range(1));
  params.slip = -150.0;
  state.SetLabel(method_name(*params.method));
  for (auto _ : state) benchmark::DoNotOptimize(moving::move_block(section, params, {}).value());
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(move_blocks)
    ->ArgsProduct({{10000, 1000000}, {0, 1, 2, 6}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// 1 M points along beds through the map of a method: a fault of three segments, or of a flat and a ramp.
void map_points_of_a_move(benchmark::State& state) {
  kinematics::FaultPath path{{{{-9000, 0}, {0, 0}, {1400, 500}, {9000, 500}}, false}};
  moving::MoveParams params;
  params.method = static_cast<moving::MoveMethod>(state.range(0));
  params.direction = moving::Direction::Forward;
  params.apical = dobra::base::Angle::from_degrees(60.0);
  if (has_tip(*params.method)) path.line.points.pop_back();
  const kinematics::BlockMap map = make_motion(path, params, {kinematics::Measure::Slip, 300.0}, 0.0).value().map;
  std::vector<geom::Point> points(1000000), images(1000000);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = {-8000.0 + 16.0 * static_cast<double>(i % 1000), 520.0 + static_cast<double>(i / 1000)};
  state.SetLabel(method_name(*params.method));
  for (auto _ : state) {
    benchmark::DoNotOptimize(map.forward(points, images));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(map_points_of_a_move)
    ->DenseRange(0, 6)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace recon::core

BENCHMARK_MAIN();
