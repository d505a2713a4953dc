#include "shared/operations/offset_layers.h"

#include <fmt/format.h>

#include "shared/base/text.h"
#include "shared/scene/color_map.h"

namespace dobra::operations {
namespace {

using base::translated;

constexpr std::size_t legend_entries = 12;  ///< More distances than these show only some of them in the legend.

/// Whether entry `i` of `count` is among those that a legend of limited length shows; the first and the last are.
bool in_legend(std::size_t i, std::size_t count) {
  if (count <= legend_entries) return true;
  const std::size_t step = (count - 1 + legend_entries - 2) / (legend_entries - 1);
  return i == count - 1 || (i % step == 0 && i + step / 2 < count - 1);
}

scene::Layer lines_layer(std::string key, std::string title, const scene::Style& style,
                         std::vector<geom::Polyline> lines) {
  return {.key = std::move(key), .title = std::move(title), .style = style, .content = scene::Lines{std::move(lines)}};
}

}  // namespace

std::vector<scene::Layer> offset_layers(const std::vector<OffsetFamily>& families, const OffsetNaming& naming,
                                        Nothing nothing) {
  std::vector<scene::Layer> layers;
  const std::size_t count = families.empty() ? 0 : families.front().curves.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<geom::Polyline> lines;
    for (const OffsetFamily& family : families) {
      const auto& drawn_lines = family.curves[k].lines;
      lines.insert(lines.end(), drawn_lines.begin(), drawn_lines.end());
    }
    if (lines.empty() && nothing == Nothing::LeftOut) continue;
    // Viridis without its light yellow end, which is hard to see on white.
    const double fraction = count > 1 ? 0.85 * static_cast<double>(k) / static_cast<double>(count - 1) : 0.4;
    const std::string title = fmt::format("D = {:.6g}{}{}{}", families.front().curves[k].distance / naming.unit,
                                          naming.unit_name.empty() ? "" : " ", naming.unit_name,
                                          lines.empty() ? fmt::format(" ({})", translated("nothing remains")) : "");
    layers.push_back(lines_layer(fmt::format("{}_{}", naming.prefix, k + 1), title,
                                 {.line = scene::color_at(scene::ColorMapName::Viridis, fraction), .line_width = 1.0},
                                 std::move(lines)));
    if (!in_legend(k, count)) layers.back().in_legend = scene::InLegend::No;
  }
  return layers;
}

scene::Layer base_layer(const std::vector<OffsetFamily>& families, const OffsetNaming& naming) {
  std::vector<geom::Polyline> bases;
  for (const OffsetFamily& family : families) bases.insert(bases.end(), family.bases.begin(), family.bases.end());
  return lines_layer(naming.prefix == "offset" ? "base" : naming.prefix + "_base",
                     families.size() == 1 ? families.front().name : translated("base curves"),
                     {.line = {20, 20, 24}, .line_width = 2.5}, std::move(bases));
}

std::vector<scene::Layer> stage_layers(const OffsetStage& stage, const OffsetNaming& naming) {
  std::vector<scene::Layer> layers;
  const auto add = [&](const char* key, std::string title, const scene::Style& style,
                       std::vector<geom::Polyline> lines) {
    layers.push_back(lines_layer(fmt::format("{}_{}", naming.prefix, key), std::move(title), style, std::move(lines)));
  };
  if (!stage.raw_edge.points.empty()) {
    add("segment", translated("Base segment of the step"), {.line = {20, 20, 24}, .line_width = 2.5},
        {stage.base_segment});
    add("raw_edge", translated("Raw edge of the step"), {.line = {240, 178, 92}, .line_width = 4.0}, {stage.raw_edge});
  }
  if (!stage.deleted.empty())
    add("deleted", translated("Deleted in the step"),
        {.line = {198, 40, 40}, .line_width = 1.3, .dash = scene::Dash::Dashed}, stage.deleted);
  add("so_far", translated("Curve so far"), {.line = {13, 71, 161}, .line_width = 1.4}, stage.so_far);
  return layers;
}

}  // namespace dobra::operations
