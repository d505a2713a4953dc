#include "shared/scene/pick.h"

#include <limits>

namespace dobra::scene {
namespace {

using Found = std::optional<std::uint32_t>;

/// Picks in one layer. Distances are taken with y stretched as on the page.
class Picker {
 public:
  Picker(const Layer& layer, geom::Point at, double tolerance, double stretch)
      : layer_(layer), at_(at), stretched_at_(stretched(at, stretch)), tolerance_(tolerance), stretch_(stretch) {}

  Found operator()(const Lines& content) const {
    Nearest nearest(tolerance_);
    for (std::size_t i = 0; i < content.lines.size(); ++i) nearest.offer(distance_to(content.lines[i]), i);
    return identity(nearest, content.ids);
  }

  Found operator()(const Markers& content) const {
    Nearest nearest(tolerance_);
    for (std::size_t i = 0; i < content.points.size(); ++i) {
      nearest.offer(geom::distance(stretched(content.points[i], stretch_), stretched_at_), i);
    }
    return identity(nearest, content.ids);
  }

  Found operator()(const Regions& content) const {
    Nearest nearest(tolerance_);
    for (std::size_t i = 0; i < content.regions.size(); ++i) {
      const Region& region = content.regions[i];
      if (layer_.style.fill && contains(region)) {
        nearest.offer(0.0, i);
        continue;
      }
      for (const geom::Polyline& contour : region.contours) nearest.offer(distance_to(contour), i);
    }
    return identity(nearest, content.ids);
  }

  Found operator()(const Mesh& content) const {
    for (std::size_t i = content.triangles.size(); i-- > 0;) {
      const auto& [a, b, c] = content.triangles[i];
      if (!inside(content.points[a], content.points[b], content.points[c])) continue;
      return content.ids.empty() ? static_cast<std::uint32_t>(i) : content.ids[i];
    }
    return std::nullopt;
  }

  Found operator()(const Labels&) const { return std::nullopt; }
  Found operator()(const Image&) const { return std::nullopt; }  // what is drawn on it is meant

 private:
  /// Of equal distances the last wins: it is drawn on top.
  class Nearest {
   public:
    explicit Nearest(double limit) : least_(limit) {}
    void offer(double distance, std::size_t index) {
      if (distance <= least_) {
        least_ = distance;
        index_ = index;
      }
    }
    [[nodiscard]] bool found() const { return index_ != none; }
    [[nodiscard]] std::size_t index() const { return index_; }

   private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    double least_;
    std::size_t index_ = none;
  };

  static geom::Point stretched(geom::Point p, double stretch) { return {p.x, p.y * stretch}; }

  [[nodiscard]] double distance_to(const geom::Polyline& line) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Segment segment = line.segment(i);
      const geom::Segment on_page{stretched(segment.from, stretch_), stretched(segment.to, stretch_)};
      least = std::min(least, geom::distance(on_page, stretched_at_));
    }
    return least;
  }

  [[nodiscard]] bool contains(const Region& region) const {
    bool odd = false;
    for (const geom::Polyline& contour : region.contours) {
      const std::vector<geom::Point>& p = contour.points;
      for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
        if ((p[i].y > at_.y) == (p[j].y > at_.y)) continue;
        // Plain arithmetic: a cursor is not exact either.
        if (at_.x < p[i].x + (at_.y - p[i].y) / (p[j].y - p[i].y) * (p[j].x - p[i].x)) odd = !odd;
      }
    }
    return odd;
  }

  [[nodiscard]] bool inside(geom::Point a, geom::Point b, geom::Point c) const {
    const double u = geom::cross(b - a, at_ - a);
    const double v = geom::cross(c - b, at_ - b);
    const double w = geom::cross(a - c, at_ - c);
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
  }

  static Found identity(const Nearest& nearest, const std::vector<std::uint32_t>& ids) {
    if (!nearest.found()) return std::nullopt;
    const std::size_t i = nearest.index();
    return ids.empty() ? static_cast<std::uint32_t>(i) : ids[i];
  }

  const Layer& layer_;
  geom::Point at_;
  geom::Point stretched_at_;
  double tolerance_;
  double stretch_;
};

}  // namespace

std::optional<Pick> pick(const Panel& panel, geom::Point at, double tolerance) {
  for (std::size_t i = panel.layers.size(); i-- > 0;) {
    const Layer& layer = panel.layers[i];
    if (!layer.visible) continue;
    const Picker picker(layer, at, tolerance, panel.vertical_exaggeration);
    if (const Found id = std::visit(picker, layer.content)) return Pick{layer.key, *id};
  }
  return std::nullopt;
}

namespace {

const Color marked{0xd0, 0x10, 0x10};

std::uint32_t id_of(const std::vector<std::uint32_t>& ids, std::size_t item) {
  return item < ids.size() ? ids[item] : static_cast<std::uint32_t>(item);
}

/// The lines and points of an item.
struct Finder {
  std::uint32_t id;
  std::vector<geom::Polyline> lines;
  std::vector<geom::Point> points;

  void operator()(const Lines& content) {
    for (std::size_t i = 0; i < content.lines.size(); ++i) {
      if (id_of(content.ids, i) == id) lines.push_back(content.lines[i]);
    }
  }
  void operator()(const Markers& content) {
    for (std::size_t i = 0; i < content.points.size(); ++i) {
      if (id_of(content.ids, i) == id) points.push_back(content.points[i]);
    }
  }
  void operator()(const Regions& content) {
    for (std::size_t i = 0; i < content.regions.size(); ++i) {
      if (id_of(content.ids, i) != id) continue;
      for (const geom::Polyline& contour : content.regions[i].contours) lines.push_back({contour.points, true});
    }
  }
  void operator()(const Mesh& content) {
    const auto add = [&](std::size_t i) {
      geom::Polyline triangle{{}, true};
      for (const std::uint32_t point : content.triangles[i]) triangle.points.push_back(content.points[point]);
      lines.push_back(std::move(triangle));
    };
    if (content.ids.empty() && id < content.triangles.size()) return add(id);
    for (std::size_t i = 0; i < content.ids.size(); ++i) {
      if (content.ids[i] == id) add(i);
    }
  }
  void operator()(const Labels&) {}
  void operator()(const Image&) {}
};

}  // namespace

std::vector<Layer> highlight(const Panel& panel, const Pick& pick) {
  std::vector<Layer> layers;
  const auto add = [&](const char* key, auto content) {
    Layer layer;
    layer.key = key;
    layer.style.line = marked;
    layer.style.line_width = 2.5;
    layer.style.marker_size = 11.0;
    layer.in_legend = InLegend::No;
    layer.content = std::move(content);
    layers.push_back(std::move(layer));
  };
  for (const Layer& layer : panel.layers) {
    if (layer.key != pick.layer || !layer.visible) continue;
    Finder finder{pick.id, {}, {}};
    std::visit(finder, layer.content);
    if (!finder.lines.empty()) add("marked.lines", Lines{std::move(finder.lines), {}});
    if (!finder.points.empty()) add("marked.points", Markers{std::move(finder.points), {}});
  }
  return layers;
}

std::vector<std::array<std::uint32_t, 2>> rim_of(std::vector<std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 2>> rim;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if ((end - i) % 2 == 1) rim.push_back(edges[i]);
    i = end;
  }
  return rim;
}

}  // namespace dobra::scene
