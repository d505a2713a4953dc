#include "shared/gui/documents/shown.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace dobra::gui::documents {

namespace {

template <class Visitor>
void for_each_line(const scene::Panel& panel, Visitor&& visit) {
  for (const scene::Layer& layer : panel.layers) {
    const auto* lines = std::get_if<scene::Lines>(&layer.content);
    for (std::uint32_t i = 0; lines != nullptr && i < lines->lines.size(); ++i)
      visit(scene::Pick{layer.key, lines->ids.empty() ? i : lines->ids[i]}, lines->lines[i]);
  }
}

template <class Visitor>
void for_each_marker(const scene::Panel& panel, Visitor&& visit) {
  for (const scene::Layer& layer : panel.layers) {
    const auto* markers = std::get_if<scene::Markers>(&layer.content);
    for (std::uint32_t i = 0; markers != nullptr && i < markers->points.size(); ++i)
      visit(scene::Pick{layer.key, markers->ids.empty() ? i : markers->ids[i]}, markers->points[i]);
  }
}

bool shows_input(const scene::Panel& panel, const Outcome& outcome) {
  const std::set<scene::Pick> same = lines_of_input(panel, outcome);
  bool all = true;
  for (const scene::Panel& of_input : outcome.input->panels)
    for_each_line(of_input, [&](const scene::Pick& pick, const geom::Polyline&) { all = all && same.contains(pick); });
  return all;
}

/// What a legend tells of the panels before is not told again.
void tell_once(std::vector<scene::Panel>& panels) {
  std::set<std::string> told;
  for (scene::Panel& panel : panels) {
    for (scene::Layer& layer : panel.layers) {
      if (told.contains(scene::legend_name(layer))) layer.in_legend = scene::InLegend::No;
    }
    for (const scene::Layer& layer : panel.layers) {
      if (layer.in_legend == scene::InLegend::Yes) told.insert(scene::legend_name(layer));
    }
  }
}

}  // namespace

std::set<scene::Pick> lines_of_input(const scene::Panel& panel, const Outcome& outcome) {
  std::map<scene::Pick, const geom::Polyline*> shown;
  for_each_line(panel, [&](const scene::Pick& pick, const geom::Polyline& line) { shown[pick] = &line; });
  std::set<scene::Pick> same;
  for (const scene::Panel& of_input : outcome.input->panels) {
    for_each_line(of_input, [&](const scene::Pick& pick, const geom::Polyline& line) {
      const auto found = shown.find(pick);
      if (found != shown.end() && *found->second == line) same.insert(pick);
    });
  }
  std::map<scene::Pick, geom::Point> marked;
  for_each_marker(panel, [&](const scene::Pick& pick, geom::Point at) { marked[pick] = at; });
  for (const scene::Panel& of_input : outcome.input->panels) {
    for_each_marker(of_input, [&](const scene::Pick& pick, geom::Point at) {
      const auto found = marked.find(pick);
      if (found != marked.end() && found->second == at) same.insert(pick);
    });
  }
  return same;
}

scene::Picture picture_of(const Outcome& outcome, Shown shown) {
  if (!outcome.picture) return {};
  if (!outcome.input || outcome.input == outcome.picture || shown == Shown::Result) return *outcome.picture;
  if (shown == Shown::Input) return *outcome.input;
  scene::Picture both = *outcome.picture;
  if (std::any_of(both.panels.begin(), both.panels.end(), [&](const auto& p) { return shows_input(p, outcome); }))
    return both;
  std::vector<scene::Panel> panels = outcome.input->panels;
  for (scene::Panel& panel : panels) panel.key = "input." + panel.key;
  std::move(both.panels.begin(), both.panels.end(), std::back_inserter(panels));
  both.panels = std::move(panels);
  both.arrangement = scene::Arrangement::Grid;
  tell_once(both.panels);
  return both;
}

}  // namespace dobra::gui::documents
