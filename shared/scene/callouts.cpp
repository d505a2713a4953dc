// Labels that find their own place: the nearest room round their point, at the end of a leader.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shared/scene/furniture.h"

namespace dobra::scene {
namespace {

constexpr std::array rings{14.0, 24.0, 38.0, 56.0, 80.0, 110.0, 150.0, 200.0};  // lengths of leaders, points
/// Directions in sixteenths of a turn, the best first: to the upper right.
constexpr std::array directions{1, 7, 15, 9, 2, 6, 14, 10, 0, 8, 3, 5, 13, 11, 4, 12};
constexpr double clear = 2.0;  // room round a text

/// What no text may hide, in page coordinates.
struct Obstacles {
  std::vector<geom::Segment> lines;
  std::vector<geom::Box> markers;
};

/// Of the layers that the legend names, as far as they are in `window`.
Obstacles obstacles_of(const Panel& panel, const PanelLayout& place, const geom::Box& window) {
  Obstacles found;
  for (const Layer& layer : panel.layers) {
    if (!layer.visible || layer.in_legend == InLegend::No) continue;
    if (const auto* content = std::get_if<Lines>(&layer.content)) {
      for (const geom::Polyline& line : content->lines) {
        for (std::size_t i = 0; i < line.segment_count(); ++i) {
          const geom::Segment world = line.segment(i);
          const geom::Segment segment{place.transform.to_page(world.from), place.transform.to_page(world.to)};
          if (segment.box().overlaps(window)) found.lines.push_back(segment);
        }
      }
    }
    if (const auto* content = std::get_if<Markers>(&layer.content)) {
      for (const geom::Point& point : content->points) {
        const geom::Box box =
            geom::box_of(std::array{place.transform.to_page(point)}).grown(0.5 * layer.style.marker_size);
        if (box.overlaps(window)) found.markers.push_back(box);
      }
    }
  }
  return found;
}

/// A place of the text, and where its leader ends.
struct Candidate {
  geom::Box box;
  geom::Point end;
};

Candidate candidate(geom::Point at, const TextSize& size, double reach, int sixteenth) {
  const double angle = 2.0 * std::numbers::pi * sixteenth / 16.0;
  const geom::Vector d{std::cos(angle), -std::sin(angle)};
  const geom::Vector half{0.5 * size.width + 1.0, 0.5 * size.height() + 1.0};
  const double to_edge = std::min(std::abs(d.x) > 1e-9 ? half.x / std::abs(d.x) : 1e9,
                                  std::abs(d.y) > 1e-9 ? half.y / std::abs(d.y) : 1e9);
  const geom::Point middle = at + (reach + to_edge) * d;
  return {{middle + -half, middle + half}, at + reach * d};
}

bool cross_each_other(const geom::Segment& a, const geom::Segment& b) {
  const auto side = [](const geom::Segment& s, geom::Point p) { return geom::cross(s.vector(), p - s.from) > 0.0; };
  return side(a, b.from) != side(a, b.to) && side(b, a.from) != side(b, a.to);
}

/// How many lines the candidate would hide or cross with its leader, but for those at the point itself; nothing if it
/// leaves the plot or meets another label.
std::optional<std::size_t> hidden(const Candidate& own, geom::Point at, const geom::Box& plot,
                                  const Obstacles& obstacles, const std::vector<geom::Box>& taken) {
  const geom::Box& box = own.box;
  if (!(box.low.x >= plot.low.x && box.high.x <= plot.high.x && box.low.y >= plot.low.y && box.high.y <= plot.high.y))
    return std::nullopt;
  const geom::Box all = box.grown(clear);
  const geom::Segment leader{geom::interpolate(at, own.end, std::min(1.0, 4.0 / distance(at, own.end))), own.end};
  double from = 0.0;
  double to = 1.0;
  for (const geom::Box& other : taken) {
    if (other.overlaps(all) || part_inside({at, own.end}, other, from, to)) return std::nullopt;
  }
  for (const geom::Box& marker : obstacles.markers) {
    if (marker.overlaps(all)) return std::nullopt;
  }
  return static_cast<std::size_t>(std::count_if(obstacles.lines.begin(), obstacles.lines.end(), [&](const auto& line) {
    double begin = 0.0;
    double end = 1.0;
    return part_inside(line, all, begin, end) || cross_each_other(line, leader);
  }));
}

std::optional<Candidate> best_place(geom::Point at, const TextSize& size, const geom::Box& plot,
                                    const Obstacles& obstacles, const std::vector<geom::Box>& taken) {
  std::optional<Candidate> best;
  std::size_t least = 0;
  for (const double reach : rings) {
    for (const int direction : directions) {
      const Candidate own = candidate(at, size, reach, direction);
      const auto lines = hidden(own, at, plot, obstacles, taken);
      if (!lines || (best && *lines >= least)) continue;
      best = own;
      least = *lines;
      if (least == 0) return best;
    }
  }
  return best;
}

}  // namespace

void add_callouts(const Panel& panel, const PanelLayout& place, const TextMeasure& measure,
                  std::vector<geom::Box> taken, std::vector<Mark>& marks) {
  for (const Layer& layer : panel.layers) {
    const auto* content = std::get_if<Labels>(&layer.content);
    if (!layer.visible || content == nullptr) continue;
    for (const Label& label : content->labels) {
      const geom::Point at = place.transform.to_page(label.at);
      if (label.anchor != Anchor::Callout || !place.plot.contains(at)) continue;
      TextMark mark = text_mark(text_of(label), at, {layer.style.text_size, Weight::Regular}, measure);
      mark.color = layer.style.line;
      const geom::Box window = geom::box_of(std::array{at}).grown(rings.back() + mark.size.width + mark.size.height());
      const auto found = best_place(at, mark.size, place.plot.grown(-2.0), obstacles_of(panel, place, window), taken);
      if (!found) continue;
      mark.at = found->box.centre();
      taken.push_back(found->box.grown(clear));
      marks.push_back(LineMark{at, found->end, layer.style.line, 0.75, Dash::Solid});
      marks.push_back(BoxMark{found->box, Color{255, 255, 255, 230}, layer.style.line, 0.5});
      marks.push_back(std::move(mark));
    }
  }
}

}  // namespace dobra::scene
