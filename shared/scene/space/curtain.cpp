// A section on its trace. Lines and triangles are cut where the trace bends, so that each piece lies on one plane.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "shared/geom/segment.h"
#include "shared/scene/fill.h"
#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

namespace {

using geom::Point;
using geom::Point3;

constexpr std::size_t most_cells = 128;  ///< Of an image, a side.

/// Where x of a section is on the map. Before the first point and behind the last it goes straight on.
class Trace {
 public:
  Trace(const std::vector<Point>& points, double first) {
    for (const Point& p : points) {
      if (!points_.empty() && p == points_.back()) continue;
      stations_.push_back(points_.empty() ? first : stations_.back() + geom::distance(points_.back(), p));
      points_.push_back(p);
    }
  }
  [[nodiscard]] bool usable() const { return points_.size() >= 2; }
  [[nodiscard]] Point3 at(Point section) const {
    const std::size_t i = piece_of(section.x);
    const double part = (section.x - stations_[i]) / (stations_[i + 1] - stations_[i]);
    const Point p = points_[i] + part * (points_[i + 1] - points_[i]);
    return {p.x, p.y, section.y};
  }
  [[nodiscard]] std::size_t piece_of(double x) const {
    const auto bend = std::upper_bound(stations_.begin() + 1, stations_.end() - 1, x);
    return static_cast<std::size_t>(bend - stations_.begin()) - 1;
  }
  /// Of the bends alone.
  [[nodiscard]] double bend(std::size_t piece) const { return stations_[piece + 1]; }

 private:
  std::vector<Point> points_;
  std::vector<double> stations_;
};

/// A corner with its value.
struct SectionCorner {
  Point at;
  double value = 0.0;
};

std::vector<SectionCorner> left_of(const std::vector<SectionCorner>& polygon, double x, double side) {
  std::vector<SectionCorner> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SectionCorner& a = polygon[i];
    const SectionCorner& b = polygon[(i + 1) % polygon.size()];
    const double da = side * (x - a.at.x);
    const double db = side * (x - b.at.x);
    if (da >= 0.0) kept.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) {
      const double t = da / (da - db);
      kept.push_back({{x, a.at.y + t * (b.at.y - a.at.y)}, a.value + t * (b.value - a.value)});
    }
  }
  return kept;
}

/// Collects the triangles of one surface.
class Hanging {
 public:
  Hanging(const Trace& trace, ValuesAt values_at) : trace_(trace) { surface_.values_at = values_at; }

  void add(const std::array<SectionCorner, 3>& triangle, double value, std::uint32_t id,
           std::optional<Color> color = {}) {
    const auto [low, high] = std::minmax({triangle[0].at.x, triangle[1].at.x, triangle[2].at.x});
    std::vector<SectionCorner> rest(triangle.begin(), triangle.end());
    const std::size_t last = trace_.piece_of(high);
    for (std::size_t piece = trace_.piece_of(low); piece < last && rest.size() >= 3; ++piece) {
      add_fan(left_of(rest, trace_.bend(piece), 1.0), value, id, color);
      rest = left_of(rest, trace_.bend(piece), -1.0);
    }
    add_fan(rest, value, id, color);
  }
  [[nodiscard]] Surface take() {
    surface_.points = std::move(points_);
    surface_.chart = std::move(chart_);
    surface_.triangles = std::move(triangles_);
    surface_.values = std::move(values_);
    surface_.colors = std::move(colors_);
    surface_.ids = std::move(ids_);
    return std::move(surface_);
  }

 private:
  void add_fan(const std::vector<SectionCorner>& polygon, double value, std::uint32_t id, std::optional<Color> color) {
    if (polygon.size() < 3) return;
    std::vector<std::uint32_t> numbers;
    for (const SectionCorner& corner : polygon) numbers.push_back(number_of(corner));
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      triangles_.push_back({numbers[0], numbers[i], numbers[i + 1]});
      ids_.push_back(id);
      if (surface_.values_at == ValuesAt::Triangles) values_.push_back(value);
      if (color) colors_.push_back(*color);
    }
  }
  /// Points of equal place and value are one, so that edges are shared.
  std::uint32_t number_of(const SectionCorner& corner) {
    const std::array<double, 3> key{corner.at.x, corner.at.y, corner.value};
    const auto [known, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(points_.size()));
    if (is_new) {
      points_.push_back(trace_.at(corner.at));
      chart_.push_back(corner.at);
      if (surface_.values_at == ValuesAt::Points) values_.push_back(corner.value);
    }
    return known->second;
  }

  const Trace& trace_;
  Surface surface_;
  std::vector<Point3> points_;
  std::vector<Point> chart_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<double> values_;
  std::vector<Color> colors_;
  std::vector<std::uint32_t> ids_;
  std::map<std::array<double, 3>, std::uint32_t> known_;
};

std::vector<Point3> hung(const Trace& trace, const geom::Polyline& line) {
  std::vector<Point> points = line.points;
  if (line.closed && !points.empty()) points.push_back(points.front());
  std::vector<Point3> made;
  for (std::size_t i = 0; i < points.size(); ++i) {
    made.push_back(trace.at(points[i]));
    if (i + 1 == points.size()) break;
    const Point a = points[i];
    const Point b = points[i + 1];
    std::vector<std::size_t> bends;
    const auto [from, to] = std::minmax({trace.piece_of(a.x), trace.piece_of(b.x)});
    for (std::size_t piece = from; piece < to; ++piece) bends.push_back(piece);
    if (b.x < a.x) std::reverse(bends.begin(), bends.end());
    for (const std::size_t piece : bends) {
      const double x = trace.bend(piece);
      made.push_back(trace.at({x, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)}));
    }
  }
  return made;
}

/// One layer of a section, as layers in space.
class Hanger {
 public:
  Hanger(const Trace& trace, const Layer& curtain, const scene::Layer& layer) : trace_(trace) {
    made_.key = curtain.key + "/" + layer.key;
    made_.title = layer.title;
    made_.style = layer.style;
    made_.style.pattern = Pattern::None;
    made_.visible = curtain.visible && layer.visible;
    made_.in_legend = curtain.in_legend == InLegend::Yes ? layer.in_legend : InLegend::No;
    made_.in_extent = curtain.in_extent;
    made_.legend = layer.legend;
  }

  std::vector<Layer> operator()(const scene::Lines& content) {
    std::vector<std::vector<Point3>> lines;
    for (const geom::Polyline& line : content.lines) lines.push_back(hung(trace_, line));
    return with(Lines{std::move(lines), content.ids});
  }
  std::vector<Layer> operator()(const scene::Markers& content) {
    Markers markers{{}, content.ids};
    for (const Point& p : content.points) markers.points.push_back(trace_.at(p));
    return with(std::move(markers));
  }
  std::vector<Layer> operator()(const scene::Labels& content) {
    Labels labels;
    for (const scene::Label& label : content.labels)
      labels.labels.push_back({trace_.at(label.at), label.text, Anchor::Centre});
    return with(std::move(labels));
  }
  std::vector<Layer> operator()(const scene::Regions& content) {
    std::vector<Layer> layers;
    std::vector<std::vector<Point3>> outlines;
    std::vector<std::uint32_t> ids;
    Hanging faces(trace_, ValuesAt::None);
    for (std::size_t i = 0; i < content.regions.size(); ++i) {
      const std::uint32_t id = id_of(content.ids, i);
      const std::vector<Point> corners = triangles_of(content.regions[i]);
      for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
        faces.add({{{corners[k]}, {corners[k + 1]}, {corners[k + 2]}}}, 0.0, id);
      for (const geom::Polyline& contour : content.regions[i].contours) {
        outlines.push_back(hung(trace_, {contour.points, true}));
        ids.push_back(id);
      }
    }
    if (made_.style.fill) {
      layers = with(faces.take());
      layers.back().style.line_width = 0.0;
    }
    if (made_.style.line_width > 0.0) {
      for (Layer& outline : with(Lines{std::move(outlines), std::move(ids)})) layers.push_back(std::move(outline));
      if (layers.size() > 1) {
        layers.back().key += outline_end;
        layers.back().in_legend = InLegend::No;
      }
    }
    return layers;
  }
  std::vector<Layer> operator()(const Mesh& content) {
    Hanging faces(trace_, content.values_at);
    for (std::size_t i = 0; i < content.triangles.size(); ++i) {
      std::array<SectionCorner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t point = content.triangles[i][k];
        corners[k].at = content.points[point];
        if (content.values_at == ValuesAt::Points) corners[k].value = content.values[point];
      }
      faces.add(corners, content.values_at == ValuesAt::Triangles ? content.values[i] : 0.0,
                static_cast<std::uint32_t>(i));
    }
    Surface surface = faces.take();
    surface.scale = content.scale;
    return with(std::move(surface));
  }
  std::vector<Layer> operator()(const Image& content) {
    if (!content.pixels || content.pixels->rgba.empty()) return {};
    const Pixels& pixels = *content.pixels;
    const std::size_t columns = std::min(pixels.width, most_cells);
    const std::size_t rows = std::min(pixels.height, most_cells);
    Hanging faces(trace_, ValuesAt::None);
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        const auto [x0, x1] = side(content.box.low.x, content.box.width(), column, columns);
        const auto [y1, y0] = side(content.box.high.y, -content.box.height(), row, rows);
        const std::size_t at =
            (2 * row + 1) * pixels.height / (2 * rows) * pixels.width + (2 * column + 1) * pixels.width / (2 * columns);
        const std::uint8_t* c = pixels.rgba.data() + 4 * at;
        const Color color{c[0], c[1], c[2], static_cast<std::uint8_t>(std::lround(content.opacity * c[3]))};
        faces.add({{{{x0, y0}}, {{x1, y0}}, {{x1, y1}}}}, 0.0, 0, color);
        faces.add({{{{x0, y0}}, {{x1, y1}}, {{x0, y1}}}}, 0.0, 0, color);
      }
    }
    std::vector<Layer> layers = with(faces.take());
    layers.back().style.line_width = 0.0;
    return layers;
  }

 private:
  static std::pair<double, double> side(double begin, double length, std::size_t i, std::size_t count) {
    const auto at = [&](std::size_t k) { return begin + length * static_cast<double>(k) / static_cast<double>(count); };
    return {at(i), at(i + 1)};
  }
  template <class Content>
  std::vector<Layer> with(Content content) const {
    Layer layer = made_;
    layer.content = std::move(content);
    return {std::move(layer)};
  }

  const Trace& trace_;
  Layer made_;
};

}  // namespace

std::vector<Layer> unrolled(const Layer& layer) {
  const auto* curtain = std::get_if<Curtain>(&layer.content);
  if (curtain == nullptr) return {layer};
  const Trace trace(curtain->trace, curtain->first);
  std::vector<Layer> layers;
  if (!trace.usable()) return layers;
  for (const scene::Layer& section : curtain->section.layers) {
    for (Layer& made : std::visit(Hanger(trace, layer, section), section.content)) layers.push_back(std::move(made));
  }
  return layers;
}

}  // namespace dobra::scene::space
