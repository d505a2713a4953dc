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

const std::vector<geom::Polyline>& items_of(const scene::Lines& lines) { return lines.lines; }
const std::vector<geom::Point>& items_of(const scene::Markers& markers) { return markers.points; }

/// The items that have the same identity and place in two layers.
template <class Content>
void add_same(const scene::Layer& layer, const scene::Layer& input, std::set<scene::Pick>& same) {
  const auto* here = std::get_if<Content>(&layer.content);
  const auto* there = std::get_if<Content>(&input.content);
  if (here == nullptr || there == nullptr) return;
  const auto id_of = [](const Content& content, std::size_t i) {
    return content.ids.empty() ? static_cast<std::uint32_t>(i) : content.ids[i];
  };
  std::map<std::uint32_t, std::size_t> known;
  for (std::size_t i = 0; i < items_of(*there).size(); ++i) known[id_of(*there, i)] = i;
  for (std::size_t i = 0; i < items_of(*here).size(); ++i) {
    const auto found = known.find(id_of(*here, i));
    if (found != known.end() && items_of(*here)[i] == items_of(*there)[found->second])
      same.insert({layer.key, id_of(*here, i)});
  }
}

const std::string ghost = "ghost.";

scene::Color faint(scene::Color color) {
  const auto paler = [](std::uint8_t part) { return static_cast<std::uint8_t>(255 - (255 - part) * 2 / 5); };
  return {paler(color.red), paler(color.green), paler(color.blue), color.alpha};
}

/// The lines of the input that a panel has elsewhere, or not at all.
std::vector<scene::Layer> ghosts_in(const scene::Panel& panel, const scene::Panel& input) {
  std::map<scene::Pick, const geom::Polyline*> there;
  for_each_line(panel, [&](const scene::Pick& pick, const geom::Polyline& line) { there[pick] = &line; });
  std::vector<scene::Layer> ghosts;
  for (const scene::Layer& layer : input.layers) {
    const auto* lines = std::get_if<scene::Lines>(&layer.content);
    if (lines == nullptr) continue;
    scene::Lines other;
    for (std::uint32_t i = 0; i < lines->lines.size(); ++i) {
      const std::uint32_t id = lines->ids.empty() ? i : lines->ids[i];
      const auto known = there.find({layer.key, id});
      if (known != there.end() && *known->second == lines->lines[i]) continue;
      other.lines.push_back(lines->lines[i]);
      other.ids.push_back(id);
    }
    if (other.lines.empty()) continue;
    scene::Layer made = layer;
    made.key = ghost + layer.key;
    made.style.line = faint(layer.style.line);
    made.style.dash = scene::Dash::Solid;
    made.in_legend = scene::InLegend::No;
    made.content = std::move(other);
    ghosts.push_back(std::move(made));
  }
  return ghosts;
}

/// Whether a length in one is the same in the other.
bool same_plane(const scene::Panel& a, const scene::Panel& b) {
  return a.axes.scale == scene::AxisScale::Linear && b.axes.scale == scene::AxisScale::Linear &&
         a.axes.x_title == b.axes.x_title && a.axes.y_title == b.axes.y_title;
}

void haunt(scene::Panel& panel, const scene::Panel& input) {
  if (!same_plane(panel, input)) return;
  std::vector<scene::Layer> ghosts = ghosts_in(panel, input);
  if (panel.extent) {
    for (const scene::Layer& layer : ghosts) panel.extent->add(scene::extent(layer));
  }
  const auto fills = [](const scene::Layer& layer) {
    return !std::holds_alternative<scene::Lines>(layer.content) &&
           !std::holds_alternative<scene::Markers>(layer.content) &&
           !std::holds_alternative<scene::Labels>(layer.content);
  };
  const auto last = std::find_if(panel.layers.rbegin(), panel.layers.rend(), fills);
  panel.layers.insert(last.base(), std::make_move_iterator(ghosts.begin()), std::make_move_iterator(ghosts.end()));
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
  // A result may have a million items that the input has none of: only layers of its keys are looked at.
  std::map<std::string, std::vector<const scene::Layer*>> of_key;
  for (const scene::Panel& input : outcome.input->panels) {
    for (const scene::Layer& layer : input.layers) of_key[layer.key].push_back(&layer);
  }
  std::set<scene::Pick> same;
  for (const scene::Layer& layer : panel.layers) {
    const std::string key = of_input({layer.key, 0}).layer;
    const auto known = of_key.find(key);
    if (known == of_key.end()) continue;
    for (const scene::Layer* other : known->second) {
      add_same<scene::Lines>(layer, *other, same);
      if (key == layer.key) add_same<scene::Markers>(layer, *other, same);
    }
  }
  return same;
}

scene::Pick of_input(scene::Pick pick) {
  if (pick.layer.starts_with(ghost)) pick.layer.erase(0, ghost.size());
  return pick;
}

scene::Picture picture_of(const Outcome& outcome, Shown shown, Beside beside) {
  if (!outcome.picture) return {};
  const bool two = outcome.input && outcome.input != outcome.picture && !outcome.input->panels.empty();
  if (two && beside == Beside::Ghost && shown != Shown::Input) {
    scene::Picture made = *outcome.picture;
    // The panel of the input gives its place to the ghost, where another is left on the same plane.
    const scene::Panel& input = outcome.input->panels.front();
    const auto is_input = [&](const scene::Panel& panel) { return shows_input(panel, outcome); };
    const bool others = std::any_of(made.panels.begin(), made.panels.end(),
                                    [&](const auto& panel) { return !is_input(panel) && same_plane(panel, input); });
    if (others) std::erase_if(made.panels, is_input);
    for (scene::Panel& panel : made.panels) haunt(panel, input);
    return made;
  }
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
