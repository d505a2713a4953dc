#include "quebra/sketch/snap.h"

#include <algorithm>
#include <map>

#include "shared/geom/spatial_index.h"

namespace quebra::sketch {
namespace {

using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;

struct Item {
  std::size_t line, number;
};

class Snapper {
 public:
  Snapper(std::span<Polyline* const> lines, double tolerance) : lines_(lines), tolerance_(tolerance) {}

  std::vector<Snap> run() {
    move_vertices();
    pass_vertices();
    return std::move(snaps_);
  }

 private:
  void move_vertices() {
    std::vector<Box> boxes;
    std::vector<Item> items;
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      for (std::size_t i = 0; i < lines_[l]->points.size(); ++i) {
        items.push_back({l, i});
        boxes.push_back(Segment{lines_[l]->points[i], lines_[l]->points[i]}.box().grown(0.5 * tolerance_));
      }
    }
    for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) {
      if (items[i].line == items[j].line) continue;
      const Point to = lines_[items[i].line]->points[items[i].number];
      Point& from = lines_[items[j].line]->points[items[j].number];
      const double gap = distance(from, to);
      if (gap == 0.0 || gap > tolerance_) continue;
      snaps_.push_back({items[i].line, items[j].line, to, gap});
      from = to;
    }
  }

  void pass_vertices() {
    std::vector<Box> boxes;
    std::vector<Item> items;
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      for (std::size_t i = 0; i < lines_[l]->segment_count(); ++i) {
        items.push_back({l, i});
        boxes.push_back(lines_[l]->segment(i).box().grown(tolerance_));
      }
    }
    const dobra::geom::SpatialIndex sides(boxes);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::pair<double, Point>>> added;  // by line and side
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      for (const Point p : lines_[l]->points) {
        sides.for_each_overlapping(Segment{p, p}.box(), [&](std::size_t k) {
          const Item& side = items[k];
          const Segment segment = lines_[side.line]->segment(side.number);
          if (side.line == l || segment.from == p || segment.to == p) return;
          const double gap = distance(segment, p);
          const double fraction = nearest_fraction(segment, p);
          if (gap > tolerance_ || fraction <= 0.0 || fraction >= 1.0) return;
          snaps_.push_back({l, side.line, p, gap});
          added[{side.line, side.number}].emplace_back(fraction, p);
        });
      }
    }
    for (auto entry = added.rbegin(); entry != added.rend(); ++entry) {
      auto& [key, points] = *entry;
      std::sort(points.begin(), points.end());
      auto& own = lines_[key.first]->points;
      std::vector<Point> between;
      for (const auto& [fraction, p] : points) between.push_back(p);
      own.insert(own.begin() + static_cast<std::ptrdiff_t>(key.second) + 1, between.begin(), between.end());
    }
    for (Polyline* const line : lines_) *line = without_repeated_points(std::move(*line));
  }

  std::span<Polyline* const> lines_;
  double tolerance_;
  std::vector<Snap> snaps_;
};

}  // namespace

std::vector<Snap> snap_together(std::span<Polyline* const> lines, double tolerance) {
  return Snapper(lines, tolerance).run();
}

}  // namespace quebra::sketch
