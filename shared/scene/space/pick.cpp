#include "shared/scene/space/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace dobra::scene::space {

namespace {

using geom::Point3;
using geom::Vector3;

constexpr std::uint32_t leaf_size = 8;
/// Of a triangle's weights: a ray does not slip between two triangles through rounding.
constexpr double weight_slack = 1e-12;
/// Lines this part of the picture's size behind a surface lie on it.
constexpr double on_surface = 0.01;

double part(const Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
double part(const Vector3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// How far along a ray a box begins; nothing if the ray misses it.
std::optional<double> entry(const Ray& ray, const geom::Box3& box) {
  double begin = 0.0;
  double end = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = part(ray.from, axis);
    const double speed = part(ray.along, axis);
    double a = part(box.low, axis) - from;
    double b = part(box.high, axis) - from;
    if (speed == 0.0) {
      if (a > 0.0 || b < 0.0) return std::nullopt;
      continue;
    }
    a /= speed;
    b /= speed;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  if (begin > end * (1.0 + 1e-12)) return std::nullopt;
  return begin;
}

/// The point of a drawn line that is nearest to a page point.
struct Near {
  double distance = std::numeric_limits<double>::infinity();
  Point3 place{};
};

Near nearest_on_line(const Sheet& sheet, Point3 a, Point3 b, geom::Point page) {
  double wa = (sheet.frame.matrix * column(a))[3];
  double wb = (sheet.frame.matrix * column(b))[3];
  if (wa <= 2.0 * least_w && wb <= 2.0 * least_w) return {};
  const auto cut = [](Point3& p, double& w, Point3 other, double w_other) {
    const double t = (w_other - 2.0 * least_w) / (w_other - w);
    p = other + t * (p - other);
    w = 2.0 * least_w;
  };
  if (wa < 2.0 * least_w) cut(a, wa, b, wb);
  if (wb < 2.0 * least_w) cut(b, wb, a, wa);
  const auto pa = project(sheet, a);
  const auto pb = project(sheet, b);
  if (!pa || !pb) return {};
  const geom::Vector along = pb->at - pa->at;
  const double square = geom::dot(along, along);
  const double t = square > 0.0 ? std::clamp(geom::dot(page - pa->at, along) / square, 0.0, 1.0) : 0.0;
  const double s = t * wa / ((1.0 - t) * wb + t * wa);
  return {geom::distance(page, pa->at + t * along), a + s * (b - a)};
}

}  // namespace

TriangleTree::TriangleTree(const Surface& surface) : points_(surface.points), triangles_(surface.triangles) {
  std::vector<Point3> centres(triangles_.size());
  order_.reserve(triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const auto& t = triangles_[i];
    const Point3 a = points_[t[0]];
    centres[i] = a + (1.0 / 3.0) * ((points_[t[1]] - a) + (points_[t[2]] - a));
    if (geom::is_finite(centres[i])) order_.push_back(i);
  }
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), centres);
}

std::uint32_t TriangleTree::build(std::uint32_t begin, std::uint32_t end, const std::vector<Point3>& centres) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, 0});
  geom::Box3 box;
  geom::Box3 middle;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t point : triangles_[order_[i]]) box.add(points_[point]);
    middle.add(centres[order_[i]]);
  }
  nodes_[number].box = box;
  if (end - begin <= leaf_size) return number;
  const Vector3 size = middle.high - middle.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + half, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return std::pair(part(centres[a], axis), a) < std::pair(part(centres[b], axis), b);
                   });
  const std::uint32_t left = build(begin, half, centres);
  const std::uint32_t right = build(half, end, centres);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

/// Moeller and Trumbore's solution of from + t along = a + u (b - a) + v (c - a).
void TriangleTree::meet(const Ray& ray, std::uint32_t triangle, std::optional<Hit>& best) const {
  const auto& corners = triangles_[triangle];
  const Point3 a = points_[corners[0]];
  const Vector3 ab = points_[corners[1]] - a;
  const Vector3 ac = points_[corners[2]] - a;
  const Vector3 across = geom::cross(ray.along, ac);
  const double volume = geom::dot(ab, across);
  if (volume == 0.0) return;
  const Vector3 off = ray.from - a;
  const double u = geom::dot(off, across) / volume;
  const Vector3 other = geom::cross(off, ab);
  const double v = geom::dot(ray.along, other) / volume;
  const double t = geom::dot(ac, other) / volume;
  if (!(u >= -weight_slack && v >= -weight_slack && u + v <= 1.0 + weight_slack && t >= 0.0)) return;
  if (best && (t > best->along || (t == best->along && triangle > best->triangle))) return;
  best = Hit{triangle, t, {1.0 - u - v, u, v}};
}

std::optional<TriangleTree::Hit> TriangleTree::first_hit(const Ray& ray) const {
  std::optional<Hit> best;
  if (nodes_.empty()) return best;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const Node& node = nodes_[open.back()];
    open.pop_back();
    const std::optional<double> begin = entry(ray, node.box);
    if (!begin || (best && *begin > best->along * (1.0 + 1e-12))) continue;
    if (node.left == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i) meet(ray, order_[i], best);
      continue;
    }
    const auto left = entry(ray, nodes_[node.left].box);
    const auto right = entry(ray, nodes_[node.right].box);
    const bool right_first = right && left && *right < *left;
    open.push_back(right_first ? node.left : node.right);
    open.push_back(right_first ? node.right : node.left);
  }
  return best;
}

Picker::Picker(const SpacePicture& picture) : layers_(unrolled(picture)), extent_(reach(picture)) {
  for (const Layer& layer : layers_) {
    const auto* surface = std::get_if<Surface>(&layer.content);
    trees_.push_back(surface != nullptr ? std::make_shared<const TriangleTree>(*surface) : nullptr);
  }
}

void Picker::set_visible(std::string_view key, bool visible) {
  for (Layer& layer : layers_) {
    if (known_key(layer.key) == key) layer.visible = visible;
  }
}

std::optional<SpacePick> Picker::surface_at(const Ray& ray, double& along) const {
  std::optional<SpacePick> found;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (!layers_[i].visible || trees_[i] == nullptr) continue;
    const auto hit = trees_[i]->first_hit(ray);
    if (!hit || (found && hit->along > along)) continue;  // of equals the later layer
    const auto& surface = std::get<Surface>(layers_[i].content);
    along = hit->along;
    found = SpacePick{{layers_[i].key, id_of(surface.ids.get(), hit->triangle)}, hit->triangle, {}, {}};
    found->place = ray.from + hit->along * ray.along;
    if (surface.chart.empty()) continue;
    geom::Vector chart{0.0, 0.0};
    for (std::size_t k = 0; k < 3; ++k)
      chart = chart + hit->weights[k] * (surface.chart[surface.triangles[hit->triangle][k]] - geom::Point{});
    found->chart = geom::Point{} + chart;
  }
  return found;
}

std::optional<SpacePick> Picker::pick(const Sheet& sheet, geom::Point page, double tolerance) const {
  const Ray ray = ray_at(sheet, page, extent_);
  double along = 0.0;
  const std::optional<SpacePick> surface = surface_at(ray, along);
  const double farthest = surface ? along + on_surface * extent_.diagonal() : std::numeric_limits<double>::infinity();
  std::optional<SpacePick> best;
  double best_distance = tolerance;
  bool best_is_marker = false;
  const auto offer = [&](const Near& near, const Layer& layer, std::uint32_t id, std::size_t item, bool marker) {
    if (near.distance > tolerance || (best_is_marker && !marker)) return;
    if (best_is_marker == marker && best && near.distance > best_distance) return;
    if (geom::dot(near.place - ray.from, ray.along) > farthest) return;  // hidden
    best = SpacePick{{std::string(known_key(layer.key)), id}, item, near.place, {}};
    best_distance = near.distance;
    best_is_marker = marker;
  };
  for (const Layer& layer : layers_) {
    if (!layer.visible) continue;
    if (const auto* markers = std::get_if<Markers>(&layer.content)) {
      for (std::size_t i = 0; i < markers->points.size(); ++i) {
        const auto seen = project(sheet, markers->points[i]);
        if (seen) offer({geom::distance(seen->at, page), markers->points[i]}, layer, id_of(markers->ids, i), i, true);
      }
    } else if (const auto* lines = std::get_if<Lines>(&layer.content)) {
      for (std::size_t i = 0; i < lines->lines.size(); ++i) {
        const std::vector<Point3>& line = lines->lines[i];
        for (std::size_t k = 0; k + 1 < line.size(); ++k)
          offer(nearest_on_line(sheet, line[k], line[k + 1], page), layer, id_of(lines->ids, i), i, false);
      }
    }
  }
  return best ? best : surface;
}

std::vector<Layer> highlight(const SpacePicture& picture, const scene::Pick& pick) {
  const Color color{0xd0, 0x10, 0x10};
  std::vector<Layer> marked;
  const auto add = [&](auto content, const char* key) {
    Layer layer;
    layer.key = key;
    layer.style.line = color;
    layer.style.line_width = 2.5;
    layer.style.marker_size = 11.0;
    layer.in_legend = InLegend::No;
    layer.content = std::move(content);
    marked.push_back(std::move(layer));
  };
  for (const Layer& layer : unrolled(picture)) {
    if (known_key(layer.key) != pick.layer) continue;
    std::vector<std::vector<Point3>> lines;
    if (const auto* surface = std::get_if<Surface>(&layer.content)) {
      std::vector<std::array<std::uint32_t, 3>> chosen;
      for (std::size_t i = 0; i < surface->triangles.size(); ++i) {
        if (id_of(surface->ids.get(), i) == pick.id) chosen.push_back(surface->triangles[i]);
      }
      for (const auto& [from, to] : rim_of(std::move(chosen)))
        lines.push_back({surface->points[from], surface->points[to]});
    } else if (const auto* content = std::get_if<Lines>(&layer.content)) {
      for (std::size_t i = 0; i < content->lines.size(); ++i) {
        if (id_of(content->ids, i) == pick.id) lines.push_back(content->lines[i]);
      }
    } else if (const auto* markers = std::get_if<Markers>(&layer.content)) {
      Markers here;
      for (std::size_t i = 0; i < markers->points.size(); ++i) {
        if (id_of(markers->ids, i) == pick.id) here.points.push_back(markers->points[i]);
      }
      if (!here.points.empty()) add(std::move(here), "space.marked.points");
    }
    if (!lines.empty()) add(Lines{std::move(lines), {}}, "space.marked");
  }
  return marked;
}

}  // namespace dobra::scene::space
