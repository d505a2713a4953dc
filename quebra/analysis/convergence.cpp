#include "quebra/analysis/convergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quebra/analysis/analysis.h"
#include "shared/base/text.h"

namespace quebra::analysis {
namespace {

namespace geom = dobra::geom;
namespace scene = dobra::scene;
using dobra::base::translated;

constexpr scene::Color ink{38, 50, 56};
constexpr scene::Color curve_blue{13, 71, 161};
constexpr scene::Color grid_grey{176, 190, 197};

/// Lines at 1, 2, 5, 10, 20 ... within the box.
scene::Layer grid_layer(const geom::Box& box) {
  scene::Lines lines;
  const auto each = [](double low, double high, const auto& add) {
    for (double decade = std::floor(low); decade <= high; ++decade) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double at = decade + std::log10(digit);
        if (at > low && at < high) add(at);
      }
    }
  };
  each(box.low.x, box.high.x, [&](double x) { lines.lines.push_back({{{x, box.low.y}, {x, box.high.y}}, false}); });
  each(box.low.y, box.high.y, [&](double y) { lines.lines.push_back({{{box.low.x, y}, {box.high.x, y}}, false}); });
  return {"grid", translated("Grid"), {.line = grid_grey, .line_width = 0.5}, std::move(lines),
          true,   scene::InLegend::No};
}

}  // namespace

scene::Picture convergence_picture(const model::Model& model) {
  geom::Polyline curve;
  for (const auto& analysis : model.analyses) {
    if (analysis->eta > 0.0)
      curve.points.push_back(
          {std::log10(static_cast<double>(analysis->solution.statistics.unknowns)), std::log10(100.0 * analysis->eta)});
  }
  const Analysis& last = *model.analyses.back();
  const auto& types = last.meshed->mesh.types;
  const double order =
      std::any_of(types.begin(), types.end(), [](auto type) { return dobra::mesh::is_quadratic(type); }) ? 2.0 : 1.0;
  geom::Box box = geom::box_of(curve.points);
  box = geom::Box{{box.low.x - 0.2, box.low.y - 0.2}, {box.high.x + 0.2, box.high.y + 0.2}};
  // Through the last cycle, as far as the box goes to the left and above.
  const geom::Point end = curve.points.back();
  const double reach = std::min(end.x - box.low.x, (box.high.y - end.y) / (0.5 * order));
  const geom::Polyline best{{{end.x - reach, end.y + 0.5 * order * reach}, end}, false};

  scene::Panel panel{.key = "convergence",
                     .title = translated("Error of each cycle"),
                     .axes = {translated("unknowns"), "eta [%]", scene::AxisScale::Log10},
                     .layers = {}};
  panel.layers.push_back(grid_layer(box));
  const std::string rate = order > 1.0 ? "N^-1" : "N^-1/2";
  panel.layers.push_back({"rate",
                          fmt::format("{} {}", translated("best rate"), rate),
                          {.line = ink, .line_width = 1.0, .dash = scene::Dash::Dashed},
                          scene::Lines{{best}}});
  panel.layers.push_back(
      {"curve", translated("estimated error"), {.line = curve_blue, .line_width = 1.6}, scene::Lines{{curve}}});
  panel.layers.push_back({"cycles",
                          translated("analyses"),
                          {.line = curve_blue, .marker_size = 6.0},
                          scene::Markers{curve.points, {}},
                          true,
                          scene::InLegend::No});
  panel.extent = box;
  scene::Picture picture;
  picture.panels.push_back(std::move(panel));
  return picture;
}

}  // namespace quebra::analysis
