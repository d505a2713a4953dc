#include "shared/scene/space/cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dobra::scene::space {

namespace {

using geom::Point3;

constexpr Color cut_color{24, 32, 38};
constexpr double cut_width = 2.2;

/// Above the plane is what is taken away. Plain arithmetic: a picture is not exact either.
class Height {
 public:
  explicit Height(const CutPlane& plane) : plane_(plane) {}
  double operator()(const Point3& p) const { return geom::dot(p - plane_.through, plane_.normal); }
  /// Where the way from a to b meets the plane, by parts of it. @pre one is above, the other below
  [[nodiscard]] double meeting(const Point3& a, const Point3& b) const {
    const double from = (*this)(a);
    return from / (from - (*this)(b));
  }

 private:
  CutPlane plane_;
};

template <class T>
T between(const T& a, const T& b, double t) {
  return a + t * (b - a);
}

template <class Ids>
Ids filtered(const Ids& ids, const std::vector<std::size_t>& items) {
  std::vector<std::uint32_t> kept;
  kept.reserve(items.size());
  for (const std::size_t i : items) kept.push_back(id_of(static_cast<const std::vector<std::uint32_t>&>(ids), i));
  return kept;
}

/// What is left of a surface, triangle by triangle, and the line along which it is cut.
class CutSurface {
 public:
  CutSurface(const Surface& surface, const Height& height) : of_(surface), height_(height), left_(surface) {
    for (const Point3& p : of_.points) heights_.push_back(height_(p));
    left_.triangles = std::vector<std::array<std::uint32_t, 3>>{};
    for (std::size_t t = 0; t < of_.triangles.size(); ++t) take(t);
    left_.ids = filtered(of_.ids.get(), from_);
    if (of_.values_at == ValuesAt::Triangles) left_.values = of_triangles(of_.values.get());
    if (!of_.colors.empty()) left_.colors = of_triangles(of_.colors.get());
  }
  [[nodiscard]] Surface surface() const { return left_; }
  [[nodiscard]] const Lines& line() const { return line_; }

 private:
  void take(std::size_t t) {
    const auto& corners = of_.triangles[t];
    bool above = false, below = false;
    for (const std::uint32_t c : corners) above = above || heights_[c] > 0.0, below = below || heights_[c] < 0.0;
    if (above && !below) return;
    if (!above) return add(corners, t);
    std::vector<std::uint32_t> rest;
    std::vector<Point3> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      if (heights_[a] <= 0.0) rest.push_back(a);
      if (heights_[a] == 0.0) ends.push_back(of_.points[a]);
      if (heights_[a] * heights_[b] < 0.0) {
        rest.push_back(point_on(a, b));
        ends.push_back(left_.points.back());
      }
    }
    for (std::size_t k = 1; k + 1 < rest.size(); ++k) add({rest[0], rest[k], rest[k + 1]}, t);
    if (ends.size() < 2) return;
    line_.lines.push_back({ends[0], ends[1]});
    line_.ids.push_back(id_of(of_.ids.get(), t));
  }
  void add(std::array<std::uint32_t, 3> corners, std::size_t t) {
    left_.triangles.push_back(corners);
    from_.push_back(t);
  }
  std::uint32_t point_on(std::uint32_t a, std::uint32_t b) {
    const double t = height_.meeting(of_.points[a], of_.points[b]);
    left_.points.push_back(between(of_.points[a], of_.points[b], t));
    if (!of_.chart.empty()) left_.chart.push_back(between(of_.chart[a], of_.chart[b], t));
    if (of_.values_at == ValuesAt::Points) left_.values.push_back(between(of_.values[a], of_.values[b], t));
    return static_cast<std::uint32_t>(left_.points.size() - 1);
  }
  template <class T>
  [[nodiscard]] std::vector<T> of_triangles(const std::vector<T>& all) const {
    std::vector<T> kept;
    kept.reserve(from_.size());
    for (const std::size_t t : from_) kept.push_back(all[t]);
    return kept;
  }

  const Surface& of_;
  const Height& height_;
  Surface left_;
  Lines line_;
  std::vector<double> heights_;
  std::vector<std::size_t> from_;  ///< The triangle of which each is a part.
};

Lines cut(const Lines& content, const Height& height) {
  Lines left;
  std::vector<std::vector<Point3>> lines;
  for (std::size_t i = 0; i < content.lines.size(); ++i) {
    std::vector<Point3> piece;
    const auto end = [&] {
      if (piece.size() > 1) lines.push_back(piece), left.ids.push_back(id_of(content.ids, i));
      piece.clear();
    };
    const std::vector<Point3>& line = content.lines[i];
    for (std::size_t k = 0; k < line.size(); ++k) {
      const double here = height(line[k]);
      if (k > 0 && here * height(line[k - 1]) < 0.0)
        piece.push_back(between(line[k - 1], line[k], height.meeting(line[k - 1], line[k])));
      if (here <= 0.0)
        piece.push_back(line[k]);
      else
        end();
    }
    end();
  }
  left.lines = std::move(lines);
  return left;
}

Markers cut(const Markers& content, const Height& height) {
  Markers left;
  for (std::size_t i = 0; i < content.points.size(); ++i) {
    if (height(content.points[i]) > 0.0) continue;
    left.points.push_back(content.points[i]);
    left.ids.push_back(id_of(content.ids, i));
  }
  return left;
}

Labels cut(const Labels& content, const Height& height) {
  Labels left = content;
  std::erase_if(left.labels, [&](const Label& label) { return height(label.at) > 0.0; });
  return left;
}

bool reaches_above(const Layer& layer, const Height& height) {
  const geom::Box3 box = extent(layer);
  if (box.empty()) return false;
  for (const double x : {box.low.x, box.high.x}) {
    for (const double y : {box.low.y, box.high.y}) {
      for (const double z : {box.low.z, box.high.z}) {
        if (height({x, y, z}) > 0.0) return true;
      }
    }
  }
  return false;
}

}  // namespace

CutPlane plane_across(CutAxis axis, double part, const geom::Box3& box, bool other_side) {
  const double sign = other_side ? -1.0 : 1.0;
  const Point3 at = between(box.low, box.high, part);
  switch (axis) {
    case CutAxis::Y:
      return {{box.low.x, at.y, box.low.z}, {0.0, sign, 0.0}};
    case CutAxis::Z:
      return {{box.low.x, box.low.y, at.z}, {0.0, 0.0, sign}};
    case CutAxis::X:
      break;
  }
  return {{at.x, box.low.y, box.low.z}, {sign, 0.0, 0.0}};
}

std::vector<Point3> frame_of(const CutPlane& plane, const geom::Box3& box) {
  const Height height(plane);
  const auto corner = [&](int i) {
    return Point3{(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                  (i & 4) != 0 ? box.high.z : box.low.z};
  };
  std::vector<Point3> rim;
  const auto add = [&rim](const Point3& p) {
    if (std::find(rim.begin(), rim.end(), p) == rim.end()) rim.push_back(p);
  };
  int nearest = 0;
  for (int i = 0; i < 8; ++i) {
    if (std::abs(height(corner(i))) < std::abs(height(corner(nearest)))) nearest = i;
    if (height(corner(i)) == 0.0) add(corner(i));
    for (const int side : {1, 2, 4}) {
      if ((i & side) != 0 || height(corner(i)) * height(corner(i | side)) >= 0.0) continue;
      add(between(corner(i), corner(i | side), height.meeting(corner(i), corner(i | side))));
    }
  }
  if (rim.empty()) rim.push_back(corner(nearest));  // the plane passes the box by
  // In their order round the middle.
  geom::Vector3 sum{};
  for (const Point3& p : rim) sum = sum + (p - rim.front());
  const Point3 middle = rim.front() + sum / static_cast<double>(rim.size());
  const geom::Vector3 first = rim.front() - middle;
  const geom::Vector3 second = geom::cross(plane.normal / geom::length(plane.normal), first);
  const auto turn = [&](const Point3& p) { return std::atan2(dot(p - middle, second), dot(p - middle, first)); };
  std::sort(rim.begin(), rim.end(), [&](const Point3& a, const Point3& b) { return turn(a) < turn(b); });
  rim.push_back(rim.front());
  return rim;
}

SpacePicture cut(const SpacePicture& picture, const CutPlane& plane) {
  const Height height(plane);
  SpacePicture left = picture;
  left.extent = extent(picture);
  left.layers.clear();
  for (Layer& layer : unrolled(picture)) {
    if (!reaches_above(layer, height)) {
      left.layers.push_back(std::move(layer));
      continue;
    }
    std::optional<Layer> line;
    if (const auto* surface = std::get_if<Surface>(&layer.content)) {
      const CutSurface cut(*surface, height);
      line = layer;
      line->key += cut_end;
      line->style = {.line = cut_color, .line_width = cut_width};
      line->in_legend = InLegend::No;
      line->content = cut.line();
      layer.content = cut.surface();
    } else if (const auto* lines = std::get_if<Lines>(&layer.content)) {
      layer.content = cut(*lines, height);
    } else if (const auto* markers = std::get_if<Markers>(&layer.content)) {
      layer.content = cut(*markers, height);
    } else if (const auto* labels = std::get_if<Labels>(&layer.content)) {
      layer.content = cut(*labels, height);
    }
    left.layers.push_back(std::move(layer));
    if (line) left.layers.push_back(*std::move(line));
  }
  return left;
}

}  // namespace dobra::scene::space
