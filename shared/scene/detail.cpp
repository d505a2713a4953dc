#include "shared/scene/detail.h"

#include <algorithm>
#include <tuple>

#include "shared/geom/simplify.h"

namespace dobra::scene {
namespace {

using geom::Point;
using geom::Polyline;

bool holds(const geom::Box& window, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [&](Point p) { return window.contains(p); });
}

/// The runs of segments that come near the window.
void add_runs(const Polyline& line, const geom::Box& window, std::vector<Polyline>& runs) {
  Polyline run;
  const auto end_run = [&] {
    if (!run.points.empty()) runs.push_back(std::move(run));
    run = {};
  };
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Segment segment = line.segment(i);
    if (!segment.box().overlaps(window)) {
      end_run();
      continue;
    }
    if (run.points.empty()) run.points.push_back(segment.from);
    run.points.push_back(segment.to);
  }
  end_run();
}

/// The part of a contour on one side of a line that is parallel to an axis; along it, what is beyond is drawn flat.
std::vector<Point> cut_off(const std::vector<Point>& contour, double Point::*axis, double limit, double sign) {
  std::vector<Point> kept;
  kept.reserve(contour.size());
  for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
    const double a = sign * (contour[j].*axis - limit);
    const double b = sign * (contour[i].*axis - limit);
    if ((a > 0.0) != (b > 0.0)) {
      Point cut = geom::interpolate(contour[j], contour[i], a / (a - b));
      cut.*axis = limit;
      kept.push_back(cut);
    }
    if (b <= 0.0) kept.push_back(contour[i]);
  }
  return kept;
}

struct Count {
  template <class Lists>
  static std::size_t of(const Lists& lines) {
    std::size_t count = 0;
    for (const Polyline& line : lines) count += line.points.size();
    return count;
  }
  std::size_t operator()(const Lines& content) const { return of(content.lines); }
  std::size_t operator()(const Markers& content) const { return content.points.size(); }
  std::size_t operator()(const Regions& content) const {
    std::size_t count = 0;
    for (const Region& region : content.regions) count += of(region.contours);
    return count;
  }
  std::size_t operator()(const Mesh& content) const { return content.points.size() + content.triangles.size(); }
  std::size_t operator()(const Labels&) const { return 0; }
  std::size_t operator()(const Image&) const { return 0; }
};

}  // namespace

std::vector<Polyline> seen_lines(const std::vector<Polyline>& lines, const Sight& sight) {
  std::vector<Polyline> seen;
  std::vector<Polyline> runs;
  const auto add = [&](const Polyline& line) {
    if (auto simple = geom::simplify(line, {sight.detail})) seen.push_back(*std::move(simple));
  };  // what has no two distinct points has nothing to draw
  for (const Polyline& line : lines) {
    if (holds(sight.window, line.points)) {
      add(line);
      continue;
    }
    runs.clear();
    add_runs(line, sight.window, runs);
    for (const Polyline& run : runs) add(run);
  }
  return seen;
}

Region seen_region(const Region& region, const Sight& sight) {
  Region seen;
  for (const Polyline& contour : region.contours) {
    Polyline part{contour.points, true};
    if (!holds(sight.window, part.points)) {
      const geom::Box& window = sight.window;
      for (const auto& [axis, limit, sign] : {std::tuple{&Point::x, window.low.x, -1.0},
                                              {&Point::x, window.high.x, 1.0},
                                              {&Point::y, window.low.y, -1.0},
                                              {&Point::y, window.high.y, 1.0}}) {
        if (!part.points.empty()) part.points = cut_off(part.points, axis, limit, sign);
      }
    }
    if (part.points.size() < 3) continue;
    if (auto simple = geom::simplify(part, {sight.detail})) part = *std::move(simple);
    seen.contours.push_back(std::move(part));
  }
  return seen;
}

std::size_t point_count(const Layer& layer) { return std::visit(Count{}, layer.content); }

void share_with(Picture& picture, const Picture& before) {
  for (Panel& panel : picture.panels) {
    const auto same_key = [&](const auto& other) { return other.key == panel.key; };
    const auto known = std::find_if(before.panels.begin(), before.panels.end(), same_key);
    if (known == before.panels.end()) continue;
    for (Layer& layer : panel.layers) {
      const auto other = std::find_if(known->layers.begin(), known->layers.end(),
                                      [&](const Layer& candidate) { return candidate.key == layer.key; });
      if (other != known->layers.end() && other->content == layer.content) layer.content = other->content;
    }
  }
}

}  // namespace dobra::scene
