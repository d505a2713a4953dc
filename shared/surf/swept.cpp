// Surfaces made of curves: ruled, extruded, turned, and Coons's patch.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shared/surf/surface.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

constexpr Box unit_square{{0.0, 0.0}, {1.0, 1.0}};

/// A curve by the part of its parameter range.
struct Scaled {
  Curve curve;
  [[nodiscard]] Curve::Jet jet(double t) const {
    const double range = curve.high() - curve.low();
    Curve::Jet jet = curve.jet((1.0 - t) * curve.low() + t * curve.high());
    jet.first = range * jet.first;
    jet.second = range * range * jet.second;
    return jet;
  }
  [[nodiscard]] std::vector<double> breaks() const {
    std::vector<double> parts;
    for (const double at : curve.breaks()) parts.push_back((at - curve.low()) / (curve.high() - curve.low()));
    return parts;
  }
  [[nodiscard]] double bend(double from, double to) const {
    const double range = curve.high() - curve.low();
    return range * range *
           curve.bend(std::lerp(curve.low(), curve.high(), from), std::lerp(curve.low(), curve.high(), to));
  }
};

std::vector<double> merged(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end(), [](double p, double q) { return q - p < 1e-14; }), a.end());
  return a;
}

struct RuledShape : Surface::Shape {
  Scaled bottom, top;
  RuledShape(const Curve& low, const Curve& high) : bottom{low}, top{high} {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const Curve::Jet a = bottom.jet(uv[i].x), b = top.jet(uv[i].x);
      const double v = uv[i].y;
      jets[i] = {a.at + v * (b.at - a.at),
                 a.first + v * (b.first - a.first),
                 b.at - a.at,
                 a.second + v * (b.second - a.second),
                 b.first - a.first,
                 {}};
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    const double a = bottom.bend(part.low.x, part.high.x), b = top.bend(part.low.x, part.high.x), u = part.centre().x;
    return {std::max(a, b), geom::length(top.jet(u).first - bottom.jet(u).first) + 0.5 * part.width() * (a + b), 0.0};
  }
};

struct ExtrudedShape : Surface::Shape {
  Curve profile;
  Vector3 by;
  ExtrudedShape(const Curve& curve, Vector3 way) : profile(curve), by(way) {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const Curve::Jet p = profile.jet(uv[i].x);
      jets[i] = {p.at + uv[i].y * by, p.first, by, p.second, {}, {}};
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override { return {profile.bend(part.low.x, part.high.x), 0.0, 0.0}; }
};

struct RevolvedShape : Surface::Shape {
  Curve profile;
  Point3 on_axis;
  Vector3 axis;  ///< Of unit length.
  RevolvedShape(const Curve& curve, Point3 point, Vector3 direction)
      : profile(curve), on_axis(point), axis(direction) {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const double c = std::cos(uv[i].x), s = std::sin(uv[i].x);
      const Curve::Jet p = profile.jet(uv[i].y);
      const auto along = [&](Vector3 a) { return dot(a, axis) * axis; };
      const auto turned = [&](Vector3 a) {
        const Vector3 out = a - along(a);
        return along(a) + c * out + s * cross(axis, a);
      };
      const auto moving = [&](Vector3 a) { return c * cross(axis, a) - s * (a - along(a)); };  // by the angle
      const Vector3 from_axis = p.at - on_axis;
      jets[i] = {on_axis + turned(from_axis),          moving(from_axis), turned(p.first),
                 along(from_axis) - turned(from_axis), moving(p.first),   turned(p.second)};
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    const double bent = profile.bend(part.low.y, part.high.y), half = 0.5 * part.height();
    const Curve::Jet p = profile.jet(part.centre().y);
    const double slope = geom::length(p.first) + half * bent;
    return {geom::length(cross(axis, p.at - on_axis)) + half * slope, slope, bent};
  }
};

struct CoonsShape : Surface::Shape {
  Scaled bottom, top, left, right;
  Point3 p00, p10, p01, p11;
  CoonsShape(const Curve& b, const Curve& t, const Curve& l, const Curve& r)
      : bottom{b},
        top{t},
        left{l},
        right{r},
        p00(bottom.jet(0).at),
        p10(bottom.jet(1).at),
        p01(top.jet(0).at),
        p11(top.jet(1).at) {}
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    const Vector3 twist = (p11 - p10) - (p01 - p00);
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const double u = uv[i].x, v = uv[i].y;
      const Curve::Jet b = bottom.jet(u), t = top.jet(u), l = left.jet(v), r = right.jet(v);
      const Point3 bilinear = p00 + u * (p10 - p00) + v * (p01 - p00) + u * v * twist;
      jets[i] = {l.at + u * (r.at - l.at) + (b.at + v * (t.at - b.at) - bilinear),
                 (r.at - l.at) + b.first + v * (t.first - b.first) - ((p10 - p00) + v * twist),
                 l.first + u * (r.first - l.first) + (t.at - b.at) - ((p01 - p00) + u * twist),
                 b.second + v * (t.second - b.second),
                 (r.first - l.first) + (t.first - b.first) - twist,
                 l.second + u * (r.second - l.second)};
    }
  }
  [[nodiscard]] Bend bend(const Box& part) const override {
    const double b = bottom.bend(part.low.x, part.high.x), t = top.bend(part.low.x, part.high.x);
    const double l = left.bend(part.low.y, part.high.y), r = right.bend(part.low.y, part.high.y);
    const Point m = part.centre();
    const Vector3 twist = (right.jet(m.y).first - left.jet(m.y).first) + (top.jet(m.x).first - bottom.jet(m.x).first) -
                          ((p11 - p10) - (p01 - p00));
    return {std::max(b, t), geom::length(twist) + 0.5 * part.width() * (b + t) + 0.5 * part.height() * (l + r),
            std::max(l, r)};
  }
};

}  // namespace

base::Result<Surface> Surface::ruled(const Curve& bottom, const Curve& top) {
  auto shape = std::make_shared<const RuledShape>(bottom, top);
  Breaks breaks{merged(shape->bottom.breaks(), shape->top.breaks()), {}};
  return make(std::move(shape), unit_square, std::move(breaks));
}

base::Result<Surface> Surface::extruded(const Curve& profile, Vector3 by) { return extruded(profile, by, 0.0, 1.0); }

base::Result<Surface> Surface::extruded(const Curve& profile, Vector3 by, double from, double to) {
  if (!geom::is_finite(by)) return Error{ErrorCode::NotFinite, "the way of the extrusion is not finite"};
  if (by == Vector3{}) return Error{ErrorCode::DegenerateCurve, "the way of the extrusion has no length"};
  return make(std::make_shared<const ExtrudedShape>(profile, by), {{profile.low(), from}, {profile.high(), to}},
              {profile.breaks(), {}});
}

base::Result<Surface> Surface::revolved(const Curve& profile, Point3 on_axis, Vector3 axis, double from, double to) {
  if (!geom::is_finite(on_axis) || !geom::is_finite(axis) || !std::isfinite(from) || !std::isfinite(to))
    return Error{ErrorCode::NotFinite, "the axis or the angle of the revolution is not finite"};
  if (axis == Vector3{}) return Error{ErrorCode::DegenerateCurve, "the axis of the revolution has no direction"};
  if (to - from > 2.0 * std::numbers::pi * (1.0 + 1e-12))
    return Error{ErrorCode::InvalidOption, fmt::format("the revolution goes from {} to {} radians; a full turn is the "
                                                       "most",
                                                       from, to)};
  return make(std::make_shared<const RevolvedShape>(profile, on_axis, geom::normalised(axis)),
              {{from, profile.low()}, {to, profile.high()}}, {{}, profile.breaks()});
}

base::Result<Surface> Surface::coons(const Curve& bottom, const Curve& top, const Curve& left, const Curve& right) {
  const auto shape = std::make_shared<const CoonsShape>(bottom, top, left, right);
  const double size = geom::distance(shape->p00, shape->p11) + geom::distance(shape->p10, shape->p01);
  const struct {
    Point3 a, b;
    const char* where;
  } corners[] = {{shape->p00, shape->left.jet(0).at, "bottom and left begin"},
                 {shape->p10, shape->right.jet(0).at, "bottom ends and right begins"},
                 {shape->p01, shape->left.jet(1).at, "top begins and left ends"},
                 {shape->p11, shape->right.jet(1).at, "top and right end"}};
  for (const auto& [a, b, where] : corners) {
    if (geom::distance(a, b) > 1e-9 * size)
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("the borders of the Coons patch leave a gap of {:.6g} m where {}: at ({:.6g}, {:.6g}, "
                               "{:.6g})",
                               geom::distance(a, b), where, a.x, a.y, a.z)};
  }
  Breaks breaks{merged(shape->bottom.breaks(), shape->top.breaks()),
                merged(shape->left.breaks(), shape->right.breaks())};
  return make(shape, unit_square, std::move(breaks));
}

}  // namespace dobra::surf
