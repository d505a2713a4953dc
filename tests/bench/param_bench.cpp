// Parametrisation and recovery of sheets, one thread: seconds for the weights and equations of Floater and of mean
// value coordinates by the number of vertices, and recovered points a second. Times are of the processor.

#include <cmath>
#include <cstdio>
#include <ctime>

#include "shared/surf/param/parametrise.h"
#include "shared/surf/param/recovered.h"
#include "tests/support/sheets.h"

namespace {

using namespace dobra;
using namespace dobra::surf;
using namespace dobra::surf::param;

double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Work>
double seconds(Work&& work) {
  const double start = processor_time();
  work();
  return processor_time() - start;
}

/// Places of a line that winds through the chart, as drawers and meshers ask for them.
double points_a_second(const Surface& surface, const geom::Box& box) {
  constexpr std::size_t count = 1'000'000, side = 1000;
  std::vector<geom::Point> uv(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i / side, column = row % 2 == 0 ? i % side : side - 1 - i % side;
    uv[i] = {std::lerp(box.low.x, box.high.x, (static_cast<double>(column) + 0.5) / side),
             std::lerp(box.low.y, box.high.y, (static_cast<double>(row) + 0.5) / side)};
  }
  std::vector<Jet> jets(count);
  return static_cast<double>(count) / seconds([&] { surface.jets(uv, jets); });
}

}  // namespace

int main() {
  for (const std::uint32_t n : {31U, 99U, 315U}) {
    const auto mesh = surf::test::shaken_grid(n, n, 0.5, 1, [](double u, double v) {
      return geom::Point3{u, v, 0.2 * std::sin(6.0 * u) * std::cos(5.0 * v)};
    });
    const Sheet sheet = sheet_of(mesh)->sheet;
    for (const Weights kind : {Weights::ShapePreserving, Weights::MeanValue}) {
      Parametrisation made;
      const double took = seconds([&] { made = *parametrise(sheet, {.weights = kind}); });
      std::printf("%-16s %7zu vertices  %.3f s  %zu flipped\n",
                  kind == Weights::MeanValue ? "mean value" : "shape preserving", sheet.points.size(), took,
                  made.flipped.size());
      if (kind == Weights::MeanValue || n < 315) continue;
      const auto chart = std::make_shared<const DiscreteChart>(sheet, made.uv);
      std::printf("barycentric      %.3g points/s\n", points_a_second(*plane_pieces(chart), chart->box()));
      const double fitted = seconds([&] { (void)Recovered(chart); });
      std::printf("recovered        %.3g points/s, fitted in %.3f s\n",
                  points_a_second(*Recovered(chart).surface(), chart->box()), fitted);
    }
  }
  return 0;
}
