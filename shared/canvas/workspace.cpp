#include "shared/canvas/workspace.h"

#include <algorithm>
#include <utility>

namespace dobra::canvas {

namespace {

template <class Visitor>
void for_each_line(const scene::Panel& panel, const std::set<std::string>& hidden, Visitor&& visit) {
  for (const scene::Layer& layer : panel.layers) {
    const auto* lines = std::get_if<scene::Lines>(&layer.content);
    if (!layer.visible || lines == nullptr || hidden.contains(layer.key)) continue;
    for (std::uint32_t i = 0; i < lines->lines.size(); ++i)
      visit(scene::Pick{layer.key, lines->ids.empty() ? i : lines->ids[i]}, lines->lines[i]);
  }
}

}  // namespace

void Workspace::show(std::shared_ptr<const scene::Picture> picture, std::size_t panel, std::set<std::string> hidden) {
  hidden_ = std::move(hidden);
  picture_ = std::move(picture);
  panel_ = panel;
  snaps_.reset();
  markers_.clear();
  for (const scene::Layer& layer : this->panel().layers) {
    const auto* markers = std::get_if<scene::Markers>(&layer.content);
    if (!layer.visible || markers == nullptr || hidden_.contains(layer.key)) continue;
    for (std::uint32_t i = 0; i < markers->points.size(); ++i) {
      markers_.emplace_back(scene::Pick{layer.key, markers->ids.empty() ? i : markers->ids[i]},
                            geom::Polyline{{markers->points[i]}, false});
    }
  }
  for (auto& [pick, vertices] : std::exchange(selection, {})) {
    const geom::Polyline* there = line(pick);
    if (there == nullptr) continue;
    std::erase_if(vertices, [&](std::size_t i) { return i >= there->points.size(); });
    selection.emplace(pick, vertices);
  }
}

const SnapIndex& Workspace::snaps() const {
  if (!snaps_) snaps_.emplace(picture_, panel_, hidden_);
  return *snaps_;
}

const geom::Polyline* Workspace::line(const scene::Pick& pick) const {
  const geom::Polyline* found = nullptr;
  for_each_line(panel(), hidden_, [&](const scene::Pick& other, const geom::Polyline& line) {
    if (other == pick) found = &line;
  });
  for (const auto& [other, marker] : markers_) {
    if (found == nullptr && other == pick) found = &marker;
  }
  return found;
}

std::string Workspace::title(const scene::Pick& pick) const {
  const auto found = std::find_if(panel().layers.begin(), panel().layers.end(),
                                  [&](const scene::Layer& layer) { return layer.key == pick.layer; });
  return found == panel().layers.end() ? std::string() : found->title;
}

std::string Workspace::name(const scene::Pick& pick) const {
  std::string own = names_ ? names_(pick) : std::string();
  return own.empty() ? title(pick) : own;
}

std::vector<std::pair<scene::Pick, const geom::Polyline*>> Workspace::lines() const {
  std::vector<std::pair<scene::Pick, const geom::Polyline*>> all;
  for_each_line(panel(), hidden_,
                [&](scene::Pick pick, const geom::Polyline& line) { all.emplace_back(std::move(pick), &line); });
  return all;
}

std::vector<geom::Polyline> Workspace::others(const scene::Pick& pick) const {
  std::vector<geom::Polyline> all;
  for_each_line(panel(), hidden_, [&](const scene::Pick& other, const geom::Polyline& line) {
    if (other != pick) all.push_back(line);
  });
  return all;
}

std::vector<std::pair<scene::Pick, std::size_t>> Workspace::vertices_at(geom::Point at) const {
  std::vector<std::pair<scene::Pick, std::size_t>> found;
  for_each_line(panel(), hidden_, [&](const scene::Pick& pick, const geom::Polyline& line) {
    for (std::size_t i = 0; i < line.points.size() && is_editable(pick); ++i) {
      if (line.points[i] == at) found.emplace_back(pick, i);
    }
  });
  for (const auto& [pick, marker] : markers_) {
    if (marker.points.front() == at && is_editable(pick)) found.emplace_back(pick, 0);
  }
  return found;
}

}  // namespace dobra::canvas
