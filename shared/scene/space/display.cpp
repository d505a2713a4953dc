// 1. Triangles and lines go to homogeneous coordinates, where what is behind the eye is cut off and bands of colour are
//    cut, both of which are linear there.
// 2. They are divided by w, brought to the page, and cut to the plot.
// 3. All is sorted by depth; an edge goes with the later one of its triangles.
#include "shared/scene/space/display.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "shared/scene/color_map.h"
#include "shared/scene/fill.h"
#include "shared/scene/space/shade.h"

namespace dobra::scene::space {

namespace {

using geom::Point;
using geom::Point3;

/// A corner before the division, with the value that is drawn there.
struct Corner {
  Column4 at{};
  double value = 0.0;
};

/// The part of a polygon where `height` is not below 0; Sutherland-Hodgman.
template <class Height>
std::vector<Corner> part_above(const std::vector<Corner>& polygon, const Height& height) {
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double ha = height(a);
    const double hb = height(b);
    if (ha >= 0.0) kept.push_back(a);
    if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0)) {
      const double t = ha / (ha - hb);
      Corner cut;
      for (std::size_t k = 0; k < 4; ++k) cut.at[k] = a.at[k] + t * (b.at[k] - a.at[k]);
      cut.value = a.value + t * (b.value - a.value);
      kept.push_back(cut);
    }
  }
  return kept;
}

std::vector<Point> part_in(std::vector<Point> polygon, const geom::Box& box) {
  const auto cut = [&](auto off) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point a = polygon[i];
      const Point b = polygon[(i + 1) % polygon.size()];
      const double oa = off(a);
      const double ob = off(b);
      if (oa >= 0.0) kept.push_back(a);
      if ((oa > 0.0 && ob < 0.0) || (oa < 0.0 && ob > 0.0)) kept.push_back(geom::interpolate(a, b, oa / (oa - ob)));
    }
    polygon = std::move(kept);
  };
  if (box.contains(geom::box_of(polygon).low) && box.contains(geom::box_of(polygon).high)) return polygon;
  cut([&](Point p) { return p.x - box.low.x; });
  cut([&](Point p) { return box.high.x - p.x; });
  cut([&](Point p) { return p.y - box.low.y; });
  cut([&](Point p) { return box.high.y - p.y; });
  return polygon;
}

Projected on_page(const Sheet& sheet, const Column4& c) {
  return {sheet.page.to_page({c[0] / c[3], c[1] / c[3]}), c[2] / c[3]};
}

/// What is drawn at one depth.
struct Item {
  double depth = 0.0;
  std::size_t first = 0, count = 0;  ///< Its marks,
  bool over = false;                 ///< and whether they come after others of that depth.
};

class Display {
 public:
  Display(const SpacePicture& picture, const Sheet& sheet, const DisplayOptions& options)
      : light_(picture.light), sheet_(sheet), options_(options) {}

  void add(const Layer& layer) {
    layer_ = &layer;
    if (layer.visible) std::visit([this](const auto& content) { add(content); }, layer.content);
  }

  std::vector<Mark> take() {
    // Lines that lie on triangles are drawn over them.
    const double lift = triangles_ > 0 ? 1.5 * depth_span_ / static_cast<double>(triangles_) : 0.0;
    for (Item& item : items_) item.depth -= item.over ? lift : 0.0;
    std::vector<std::size_t> order(items_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(-items_[a].depth, items_[a].over) < std::pair(-items_[b].depth, items_[b].over);
    });
    std::vector<std::size_t> rank(items_.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    std::vector<std::vector<std::size_t>> edges_of(items_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const auto& [one, other] = edges_[i].triangles;
      edges_of[other == none || rank[one] > rank[other] ? one : other].push_back(i);
    }
    std::vector<Mark> sorted;
    sorted.reserve(marks_.size() + edges_.size());
    for (const std::size_t item : order) {
      for (std::size_t k = 0; k < items_[item].count; ++k) sorted.push_back(std::move(marks_[items_[item].first + k]));
      for (const std::size_t edge : edges_of[item]) sorted.push_back(edges_[edge].mark);
    }
    return sorted;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  void add(const Labels&) {}
  void add(const Curtain&) {}  // unrolled before

  void add(const Lines& content) {
    const Style& style = layer_->style;
    if (style.line_width <= 0.0) return;
    for (const std::vector<Point3>& line : content.lines) {
      const std::vector<double> dashes = dash_lengths(style.dash, style.line_width);
      double along = 0.0;  // the dashes go on round corners
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const std::optional<SeenLine> seen = seen_line(sheet_, line[i], line[i + 1]);
        if (seen) along = add_line(*seen, dashes, along);
      }
    }
  }

  /// @return where the next one begins in the pattern.
  double add_line(const SeenLine& seen, const std::vector<double>& dashes, double along) {
    const double length = geom::distance(seen.from.at, seen.to.at);
    if (dashes.empty()) {
      add_pieces(seen, 0.0, length, length);
      return 0.0;
    }
    const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0);
    for (double begin = -std::fmod(along, period); begin < length; begin += period) {
      double at = begin;
      for (std::size_t i = 0; i < dashes.size(); ++i) {
        if (i % 2 == 0 && at + dashes[i] > 0.0 && at < length)
          add_pieces(seen, std::max(at, 0.0), std::min(at + dashes[i], length), length);
        at += dashes[i];
      }
    }
    return std::fmod(along + length, period);
  }

  /// From one length on the page to another.
  void add_pieces(const SeenLine& seen, double from, double to, double length) {
    const auto count = static_cast<std::size_t>(std::ceil(std::max((to - from) / options_.piece, 1.0)));
    const auto at = [&](double l) {
      return geom::interpolate(seen.from.at, seen.to.at, length > 0.0 ? l / length : 0.0);
    };
    constexpr double overlap = 0.1;  // points: no gap shows between pieces
    for (std::size_t i = 0; i < count; ++i) {
      const double step = (to - from) / static_cast<double>(count);
      const double begin = from + step * static_cast<double>(i);
      const double end = std::min(begin + step + (i + 1 < count ? overlap : 0.0), to);
      const double middle = length > 0.0 ? (begin + 0.5 * step) / length : 0.0;
      items_.push_back({seen.from.depth + middle * (seen.to.depth - seen.from.depth), marks_.size(), 1, true});
      marks_.emplace_back(LineMark{at(begin), at(end), layer_->style.line, layer_->style.line_width, Dash::Solid});
    }
  }

  void add(const Markers& content) {
    for (const Point3& point : content.points) {
      const std::optional<Projected> seen = project(sheet_, point);
      if (!seen || !sheet_.plot.contains(seen->at)) continue;
      items_.push_back({seen->depth, marks_.size(), 1, true});
      marks_.emplace_back(DiscMark{seen->at, layer_->style.marker_size, layer_->style.line});
    }
  }

  void add(const Surface& content) {
    std::vector<std::size_t> item_of(content.triangles.size(), none);
    for (std::size_t i = 0; i < content.triangles.size(); ++i) {
      item_of[i] = items_.size();
      if (!add_triangle(content, i)) item_of[i] = none;
    }
    add_edges(content, item_of);
  }

  /// @return whether any of it is seen.
  bool add_triangle(const Surface& content, std::size_t number) {
    std::array<Point3, 3> corners;
    std::vector<Corner> polygon(3);
    const bool banded = content.values_at == ValuesAt::Points;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t point = content.triangles[number][k];
      corners[k] = content.points[point];
      polygon[k].at = sheet_.frame.matrix * column(corners[k]);
      if (banded) polygon[k].value = fraction_of(content.scale, content.values[point]) * options_.levels;
    }
    polygon = part_above(polygon, [](const Corner& c) { return c.at[3] - least_w; });
    if (polygon.size() < 3) return false;
    Item item{0.0, marks_.size(), 0, false};
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -nearest;
    for (const Corner& corner : polygon) {
      const double depth = corner.at[2] / corner.at[3];
      item.depth += depth / static_cast<double>(polygon.size());
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
    const geom::Vector3 normal = normal_to_viewer(sheet_.frame, corners);
    if (banded) {
      add_bands(polygon, content, normal);
    } else {
      add_polygon(polygon, shaded(space::color_of(content, number, layer_->style), normal, light_));
    }
    item.count = marks_.size() - item.first;
    if (item.count == 0) return false;
    items_.push_back(item);
    depth_span_ += farthest - nearest;
    ++triangles_;
    return true;
  }

  void add_bands(const std::vector<Corner>& polygon, const Surface& content, geom::Vector3 normal) {
    const auto by_value = [](const Corner& a, const Corner& b) { return a.value < b.value; };
    const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(), by_value);
    const auto color = [&](int band) {
      const Color own = color_at(content.scale.map, (band + 0.5) / options_.levels);
      return shaded({own.red, own.green, own.blue, opacity()}, normal, light_);
    };
    const bool known =
        std::all_of(polygon.begin(), polygon.end(), [](const Corner& c) { return std::isfinite(c.value); });
    if (!known) return add_polygon(polygon, shaded(color_at(content.scale.map, std::nan("")), normal, light_));
    const auto band_of = [&](double value) {
      return std::clamp(static_cast<int>(std::floor(value)), 0, options_.levels - 1);
    };
    const int first = band_of(low->value);
    const int last = band_of(high->value);
    std::vector<Corner> rest = polygon;
    for (int band = first; band < last && rest.size() >= 3; ++band) {
      add_polygon(part_above(rest, [&](const Corner& c) { return band + 1 - c.value; }), color(band));
      rest = part_above(rest, [&](const Corner& c) { return c.value - (band + 1); });
    }
    add_polygon(rest, color(last));
  }

  [[nodiscard]] std::uint8_t opacity() const { return layer_->style.fill ? layer_->style.fill->alpha : 255; }

  void add_polygon(const std::vector<Corner>& polygon, const Color& color) {
    if (polygon.size() < 3) return;
    std::vector<Point> page;
    for (const Corner& corner : polygon) page.push_back(on_page(sheet_, corner.at).at);
    page = part_in(std::move(page), sheet_.plot);
    const double seam = color.alpha == 255 ? options_.seam : 0.0;
    for (std::size_t i = 1; i + 1 < page.size(); ++i)
      marks_.emplace_back(TriangleMark{{page[0], page[i], page[i + 1]}, color, seam});
  }

  struct Edge {
    LineMark mark;
    std::pair<std::size_t, std::size_t> triangles{none, none};  ///< Their items.
  };

  void add_edges(const Surface& content, const std::vector<std::size_t>& item_of) {
    if (layer_->style.line_width <= 0.0) return;
    double sum = 0.0;
    std::size_t count = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> known;
    const std::size_t before = edges_.size();
    for (std::size_t i = 0; i < content.triangles.size(); ++i) {
      if (item_of[i] == none) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::pair<std::uint32_t, std::uint32_t> ends =
            std::minmax(content.triangles[i][k], content.triangles[i][(k + 1) % 3]);
        const auto [edge, is_new] = known.try_emplace(ends, edges_.size());
        if (!is_new) {
          if (edge->second != none) edges_[edge->second].triangles.second = item_of[i];
          continue;
        }
        const std::optional<SeenLine> seen = seen_line(sheet_, content.points[ends.first], content.points[ends.second]);
        if (!seen) {
          edge->second = none;
          continue;
        }
        sum += geom::distance(seen->from.at, seen->to.at);
        ++count;
        edges_.push_back({{seen->from.at, seen->to.at, layer_->style.line, 0.0, Dash::Solid}, {item_of[i], none}});
      }
    }
    const double width = count > 0 ? edge_width(sum / static_cast<double>(count), layer_->style, 1.0) : 0.0;
    for (std::size_t i = before; i < edges_.size(); ++i) edges_[i].mark.width = width;
    if (width <= 0.0) edges_.resize(before);
  }

  const Light& light_;
  const Sheet& sheet_;
  const DisplayOptions& options_;
  const Layer* layer_ = nullptr;
  std::vector<Item> items_;
  std::vector<Mark> marks_;
  std::vector<Edge> edges_;
  double depth_span_ = 0.0;  ///< Of all triangles, added up.
  std::size_t triangles_ = 0;
};

}  // namespace

std::optional<SeenLine> seen_line(const Sheet& sheet, Point3 from, Point3 to) {
  Column4 a = sheet.frame.matrix * column(from);
  Column4 b = sheet.frame.matrix * column(to);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return std::nullopt;
  }
  const auto cut = [](Column4& behind, const Column4& before) {
    const double t = (before[3] - least_w) / (before[3] - behind[3]);
    for (std::size_t i = 0; i < 4; ++i) behind[i] = before[i] + t * (behind[i] - before[i]);
  };
  if (a[3] < least_w && b[3] < least_w) return std::nullopt;
  if (a[3] < least_w) cut(a, b);
  if (b[3] < least_w) cut(b, a);
  const Projected first = on_page(sheet, a);
  const Projected last = on_page(sheet, b);
  double begin = 0.0;
  double end = 1.0;
  if (!part_inside({first.at, last.at}, sheet.plot, begin, end)) return std::nullopt;
  const auto at = [&](double part) {
    return Projected{geom::interpolate(first.at, last.at, part), first.depth + part * (last.depth - first.depth)};
  };
  return SeenLine{begin > 0.0 ? at(begin) : first, end < 1.0 ? at(end) : last};
}

std::vector<Mark> marks_of(const SpacePicture& picture, const Sheet& sheet, const DisplayOptions& options) {
  Display display(picture, sheet, options);
  const std::vector<Layer> layers = unrolled(picture);
  for (const Layer& layer : layers) display.add(layer);
  return display.take();
}

}  // namespace dobra::scene::space
