// The mesher of surfaces, one thread: speed, growth of the time with the number of triangles, bytes a triangle and
// quality on a bicubic patch through 40 x 40 points (stand-in 7f) from 1e4 to 1e6 triangles; then the fifteen
// stand-ins. One can be named: surface_bench 7f. Times are of the processor.
//
// `surface_bench sizes` prints instead which part of the edges is 0.7 to 1.4 times as long as the size wanted there: on
// each stand-in by its own sizes, and by twice and four times as much.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "shared/surf/mesh/chart_mesher.h"
#include "tests/bench/heap.h"
#include "tests/support/in_size.h"
#include "tests/support/surface_stand_ins.h"

namespace {

using namespace dobra::surf;
using namespace dobra::surf::mesh;

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Run {
  std::size_t triangles = 0;
  double divide = 0.0, mesh = 0.0;  ///< s.
  double bytes = 0.0;               ///< At most in use while it is meshed, a triangle.
  SurfaceQuality quality;
};

Run run(const dobra::surf::test::StandIn& each) {
  SizeOptions sizes;
  sizes.largest = each.largest;
  sizes.turn = each.turn;
  Run run;
  const double start = processor_time();
  const auto division = divide({&each.face, 1}, {.sizes = sizes});
  run.divide = processor_time() - start;
  if (!division) {
    std::printf("%s: %s\n", each.name.c_str(), division.error().message.c_str());
    return run;
  }
  const std::size_t before = heap::in_use;
  heap::peak = before;
  const double begun = processor_time();
  const auto face = mesh_chart(division->faces[0], {.sizes = sizes});
  run.mesh = processor_time() - begun;
  if (!face) {
    std::printf("%s: %s\n", each.name.c_str(), face.error().message.c_str());
    return run;
  }
  run.triangles = face->chart.triangles.size();
  run.bytes = static_cast<double>(heap::peak - before) / static_cast<double>(run.triangles);
  const auto mesh = assemble({&each.face, 1}, *division, {&*face, 1});
  if (mesh) run.quality = quality_of(*mesh);
  return run;
}

void print(const std::string& name, const Run& r) {
  std::printf(
      "%-4s %8zu triangles  mean %.4f  alpha90 %6.2f %%  least %.3f  %7.0f triangles/s  %4.0f bytes  divided in %.3f "
      "s\n",
      name.c_str(), r.triangles, r.quality.alpha_mean, 100.0 * r.quality.alpha_90, r.quality.alpha_min,
      static_cast<double>(r.triangles) / r.mesh, r.bytes, r.divide);
}

/// Beside it the triangles; 0 where there is no mesh.
std::pair<double, std::size_t> in_size(const dobra::surf::test::StandIn& each, double times) {
  SizeOptions sizes;
  sizes.largest = times * each.largest;
  sizes.turn = std::min(45.0, times * each.turn);
  const auto division = divide({&each.face, 1}, {.sizes = sizes});
  if (!division) return {};
  auto mesher = ChartMesher::start(division->faces[0], {.sizes = sizes});
  if (!mesher) return {};
  while (!mesher->done()) {
    if (!mesher->step(100'000)) return {};
  }
  const FaceMesh face = mesher->mesh();
  return {dobra::support::part_in_size(*mesher, face), face.chart.triangles.size()};
}

int print_sizes(const std::vector<dobra::surf::test::StandIn>& all) {
  for (const auto& each : all) {
    std::printf("%-4s", each.name.c_str());
    for (const double times : {1.0, 2.0, 4.0}) {
      const auto [part, triangles] = in_size(each, times);
      std::printf("  %.0f L: %6.2f %% of %zu triangles", times, 100.0 * part, triangles);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string only = count > 1 ? arguments[1] : "";
  const auto all = dobra::surf::test::stand_ins();
  if (only == "sizes") return print_sizes(all);
  for (const auto& each : all) {
    if (each.name != "7f" || (!only.empty() && only != each.name)) continue;
    Run first, last;
    for (const double triangles : {1e4, 3e4, 1e5, 3e5, 1e6}) {
      auto sized = each;
      sized.turn = 45.0;
      sized.largest = std::sqrt(144.457679 * 4.0 / std::sqrt(3.0) / triangles);
      const Run r = run(sized);
      print("7f", r);
      if (first.triangles == 0) first = r;
      last = r;
    }
    std::printf("time grows with n^%.3f\n\n",
                std::log(last.mesh / first.mesh) /
                    std::log(static_cast<double>(last.triangles) / static_cast<double>(first.triangles)));
  }
  for (const auto& each : all) {
    if (only.empty() || only == each.name) print(each.name, run(each));
  }
  return 0;
}
