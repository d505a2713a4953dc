#include "shared/canvas/selecting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/base/text.h"
#include "shared/canvas/entry.h"

namespace dobra::canvas {

using base::translated;

Selection all_lines(const Workspace& work) {
  Selection all;
  if (work.empty()) return all;
  for (const auto& [pick, line] : work.lines()) {
    if (work.is_editable(pick)) all[pick];
  }
  return all;
}

Selection other_lines(const Workspace& work) {
  Selection others = all_lines(work);
  for (const auto& [pick, vertices] : work.selection) others.erase(pick);
  return others;
}

std::string selection_text(const Workspace& work) {
  std::size_t lines = 0;
  std::size_t vertices = 0;
  double length = 0.0;
  std::string name;
  for (const auto& [pick, chosen] : work.selection) {
    const geom::Polyline* line = work.empty() ? nullptr : work.line(pick);
    if (line == nullptr) continue;
    ++lines;
    vertices += line->points.size();
    length += geom::length(*line);
    name = work.name(pick);
  }
  if (lines == 0) return {};
  const std::string who = lines == 1 && !name.empty() ? name : fmt::format(fmt::runtime(translated("{} lines")), lines);
  // The name is the user's own, with its points.
  std::string told = with_decimal_mark(fmt::format(fmt::runtime(translated("{}: {:.6g} {}, {} vertices")), '\0',
                                                   length / work.unit.size, work.unit.name, vertices));
  return told.replace(told.find('\0'), 1, who);
}

std::string direction_text(const Workspace& work, const Snap& on) {
  const geom::Polyline* line = on.on && !work.empty() ? work.line(*on.on) : nullptr;
  if (line == nullptr || on.segment >= line->segment_count()) return {};
  const geom::Segment segment = line->segment(on.segment);
  const geom::Vector way = segment.to - segment.from;
  if (way.x == 0.0 && way.y == 0.0) return {};
  const bool dips = work.direction == Direction::Dip;
  const double sense = way.x < 0.0 || (way.x == 0.0 && way.y < 0.0) ? -1.0 : 1.0;
  const double angle = dips ? std::atan2(std::abs(way.y), std::abs(way.x)) : std::atan2(sense * way.y, sense * way.x);
  const std::string words = dips ? translated("dip {:.1f}°") : translated("angle {:.1f}°");
  const std::string told = with_decimal_mark(fmt::format(fmt::runtime(words), angle * 180.0 / std::numbers::pi));
  const std::string name = work.name(*on.on);
  return name.empty() ? told : fmt::format("{} ({})", told, name);
}

geom::Box selection_box(const Workspace& work) {
  geom::Box of_lines;
  geom::Box of_vertices;
  for (const auto& [pick, chosen] : work.selection) {
    const geom::Polyline* line = work.empty() ? nullptr : work.line(pick);
    if (line == nullptr) continue;
    of_lines.add(line->box());
    for (const std::size_t i : chosen) {
      if (i < line->points.size()) of_vertices.add(line->points[i]);
    }
  }
  return of_vertices.empty() ? of_lines : of_vertices;
}

std::vector<NamedLine> selected_lines(const Workspace& work) {
  std::vector<NamedLine> lines;
  for (const auto& [pick, chosen] : work.selection) {
    const geom::Polyline* line = work.empty() ? nullptr : work.line(pick);
    if (line != nullptr) lines.push_back({work.name(pick), *line});
  }
  return lines;
}

}  // namespace dobra::canvas
