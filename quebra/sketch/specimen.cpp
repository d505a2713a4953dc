#include "quebra/sketch/specimen.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace quebra::sketch {
namespace {

using dobra::base::Angle;
using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Vector;

/// @param rule  what the limit is, in words.
Error does_not_fit(const char* key, double value, double limit, const char* rule) {
  return {
      ErrorCode::BadValue,
      fmt::format(
          "the specimen's sizes do not fit together: `{}` is {:.6g} m and must lie above 0 m and below {:.6g} m, {}",
          key, value, limit, rule)};
}

class Drawing {
 public:
  void line(std::string name, std::vector<Point> points) {
    sketch_.curves.push_back({std::move(name), Role::Boundary, Polyline{std::move(points), false}, {}});
  }
  /// Corners in order, a name for each side.
  void loop(const std::vector<Point>& corners, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < corners.size(); ++i) line(names[i], {corners[i], corners[(i + 1) % corners.size()]});
  }
  void rectangle(double x0, double y0, double x1, double y1) {
    loop({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {"bottom", "right", "top", "left"});
  }
  void hole(std::string name, Point centre, double radius) {
    sketch_.curves.push_back({std::move(name), Role::Hole, *Arc::circle(centre, radius), {}});
  }
  void crack(std::string name, Point from, Point to) {
    sketch_.curves.push_back({std::move(name), Role::Crack, Polyline{{from, to}, false}, {}});
  }
  void arc(std::string name, Point centre, Point from, Point to, Orientation orientation) {
    sketch_.curves.push_back({std::move(name), Role::Boundary, *Arc::from_ends(centre, from, to, orientation), {}});
  }
  void point(std::string name, Point at) { sketch_.points.push_back({std::move(name), at, 0.0}); }
  Sketch take() { return std::move(sketch_); }

 private:
  Sketch sketch_;
};

Result<Sketch> plate_with_hole(const SpecimenParams& p) {
  const double w = p.width.value_or(10.0), h = p.height.value_or(w), r = p.radius.value_or(0.1 * w);
  if (2.0 * r >= std::min(w, h))
    return does_not_fit("radius", r, 0.5 * std::min(w, h), "half the lesser of width and height");
  Drawing d;
  d.rectangle(-0.5 * w, -0.5 * h, 0.5 * w, 0.5 * h);
  d.hole("hole", {0, 0}, r);
  return d.take();
}

Result<Sketch> quarter_plate(const SpecimenParams& p) {
  const double w = p.width.value_or(5.0), h = p.height.value_or(w), r = p.radius.value_or(0.2 * w);
  if (r >= std::min(w, h)) return does_not_fit("radius", r, std::min(w, h), "the lesser of width and height");
  Drawing d;
  d.line("bottom", {{r, 0}, {w, 0}});
  d.line("right", {{w, 0}, {w, h}});
  d.line("top", {{w, h}, {0, h}});
  d.line("left", {{0, h}, {0, r}});
  d.arc("hole", {0, 0}, {0, r}, {r, 0}, Orientation::Clockwise);
  return d.take();
}

Result<Sketch> l_shape(const SpecimenParams& p) {
  const double w = p.width.value_or(100.0), half = 0.5 * w;
  Drawing d;
  d.loop({{0, 0}, {half, 0}, {half, half}, {w, half}, {w, w}, {0, w}},
         {"bottom", "inner_side", "inner_bottom", "right", "top", "left"});
  d.point("corner", {half, half});
  return d.take();
}

Result<Sketch> cook(const SpecimenParams& p) {
  const double k = p.width.value_or(48.0) / 48.0;
  Drawing d;
  d.loop({{0, 0}, {48 * k, 44 * k}, {48 * k, 60 * k}, {0, 44 * k}}, {"bottom", "right", "top", "left"});
  d.point("middle_right", {48 * k, 52 * k});
  return d.take();
}

Result<Sketch> edge_notches(const SpecimenParams& p, bool both) {
  const double w = p.width.value_or(1.0), h = p.height.value_or(3.0 * w),
               a = p.crack.value_or(both ? 0.25 * w : 0.5 * w);
  if (!(a > 0.0) || a >= (both ? 0.5 * w : w))
    return does_not_fit(
        "crack_length", a, both ? 0.5 * w : w,
        both ? "half the width: two cracks must leave a ligament" : "the width: the crack must leave a ligament");
  Drawing d;
  d.rectangle(0, -0.5 * h, w, 0.5 * h);
  d.crack("crack", {0, 0}, {a, 0});
  if (both) d.crack("crack_2", {w, 0}, {w - a, 0});
  return d.take();
}

/// From -half to half at the angle, round the origin.
void add_centre_crack(Drawing& d, double half, Angle angle) {
  const Vector along = half * Vector{std::cos(angle.radians()), std::sin(angle.radians())};
  d.crack("crack", Point{0, 0} - along, Point{0, 0} + along);
}

Result<Sketch> centre_crack(const SpecimenParams& p) {
  const double w = p.width.value_or(20.0), h = p.height.value_or(w), a = p.crack.value_or(0.05 * w);
  const Angle angle = p.angle.value_or(Angle::from_degrees(0.0));
  const double longest =
      std::min(0.5 * w / std::abs(std::cos(angle.radians())), 0.5 * h / std::abs(std::sin(angle.radians())));
  if (!(a > 0.0) || a >= longest)
    return does_not_fit("crack_length", a, longest, "half a crack that reaches the edge of the plate");
  Drawing d;
  d.rectangle(-0.5 * w, -0.5 * h, 0.5 * w, 0.5 * h);
  add_centre_crack(d, a, angle);
  return d.take();
}

// Load line x = 0; the specimen reaches from -0.25 W to W, and 0.6 W up and down; pins of 0.25 W at y = +-0.275 W.
Result<Sketch> compact_tension(const SpecimenParams& p) {
  const double w = p.width.value_or(50.0), a = p.crack.value_or(0.5 * w);
  if (!(a > 0.0) || a >= w) return does_not_fit("crack_length", a, w, "the width W");
  Drawing d;
  d.rectangle(-0.25 * w, -0.6 * w, w, 0.6 * w);
  d.hole("pin_upper", {0, 0.275 * w}, 0.125 * w);
  d.hole("pin_lower", {0, -0.275 * w}, 0.125 * w);
  d.crack("crack", {-0.25 * w, 0}, {a, 0});
  d.point("load_upper", {0, 0.4 * w});
  d.point("load_lower", {0, -0.4 * w});
  return d.take();
}

Result<Sketch> three_point_bend(const SpecimenParams& p) {
  const double w = p.height.value_or(1.0), length = p.width.value_or(4.5 * w), a = p.crack.value_or(0.5 * w);
  if (!(a > 0.0) || a >= w) return does_not_fit("crack_length", a, w, "the height of the beam");
  if (length <= 4.0 * w)
    return does_not_fit("height", w, 0.25 * length, "a quarter of the width: the span is four times the height");
  Drawing d;
  d.rectangle(-0.5 * length, 0, 0.5 * length, w);
  d.crack("crack", {0, 0}, {0, a});
  d.point("support_left", {-2.0 * w, 0});
  d.point("support_right", {2.0 * w, 0});
  d.point("load", {0, w});
  return d.take();
}

Result<Sketch> pmma_beam(const SpecimenParams& p) {
  const double from_middle = p.position.value_or(5.0), a = p.crack.value_or(1.5);
  if (!(a > 0.0) || a >= 8.0) return does_not_fit("crack_length", a, 8.0, "the height of the beam");
  if (std::abs(from_middle) >= 9.0)
    return does_not_fit("position", std::abs(from_middle), 9.0, "the distance of the supports from the middle");
  const double x = 10.0 - from_middle;
  Drawing d;
  d.rectangle(0, 0, 20, 8);
  for (int i = 0; i < 3; ++i) {
    const double y = 2.75 + 2.0 * i;
    if (std::abs(x - 6.0) <= 0.25 && a >= y - 0.25)
      return does_not_fit("crack_length", a, y - 0.25, "where the notch meets a hole");
    d.hole(fmt::format("hole_{}", i + 1), {6.0, y}, 0.25);
  }
  d.crack("crack", {x, 0}, {x, a});
  d.point("support_left", {1, 0});
  d.point("support_right", {19, 0});
  d.point("load", {10, 8});
  return d.take();
}

Result<Sketch> double_cantilever(const SpecimenParams& p) {
  const double w = p.width.value_or(100.0), h = p.height.value_or(0.2 * w), a = p.crack.value_or(0.4 * w);
  if (!(a > 0.0) || a >= w) return does_not_fit("crack_length", a, w, "the width");
  Drawing d;
  d.rectangle(0, -0.5 * h, w, 0.5 * h);
  d.crack("crack", {0, 0}, {a, 0});
  d.point("load_upper", {0, 0.5 * h});
  d.point("load_lower", {0, -0.5 * h});
  return d.take();
}

Result<Sketch> brazilian_disc(const SpecimenParams& p) {
  const double r = p.radius.value_or(1.0), a = p.crack.value_or(0.5 * r);
  if (a >= r) return does_not_fit("crack_length", a, r, "the radius of the disc");
  Drawing d;
  d.arc("rim_right", {0, 0}, {0, -r}, {0, r}, Orientation::Anticlockwise);
  d.arc("rim_left", {0, 0}, {0, r}, {0, -r}, Orientation::Anticlockwise);
  if (a > 0.0) add_centre_crack(d, a, p.angle.value_or(Angle::from_degrees(0.0)));
  d.point("load_upper", {0, r});
  d.point("load_lower", {0, -r});
  return d.take();
}

/// The sizes that a specimen takes.
std::vector<std::string> sizes_of(SpecimenKind kind) {
  switch (kind) {
    case SpecimenKind::None:
      return {};
    case SpecimenKind::PlateWithHole:
    case SpecimenKind::QuarterPlate:
      return {"width", "height", "radius"};
    case SpecimenKind::LShape:
    case SpecimenKind::Cook:
      return {"width"};
    case SpecimenKind::CompactTension:
      return {"width", "crack_length"};
    case SpecimenKind::SingleEdgeNotch:
    case SpecimenKind::DoubleEdgeNotch:
    case SpecimenKind::ThreePointBend:
    case SpecimenKind::DoubleCantilever:
      return {"width", "height", "crack_length"};
    case SpecimenKind::CentreCrack:
      return {"width", "height", "crack_length", "angle"};
    case SpecimenKind::PmmaBeam:
      return {"crack_length", "position"};
    case SpecimenKind::BrazilianDisc:
      return {"radius", "crack_length", "angle"};
  }
  return {};
}

}  // namespace

std::vector<std::string> specimen_names() {
  return {"none",
          "plate_with_hole",
          "quarter_plate",
          "l_shape",
          "cook",
          "single_edge_notch",
          "double_edge_notch",
          "centre_crack",
          "compact_tension",
          "three_point_bend",
          "pmma_beam",
          "double_cantilever",
          "brazilian_disc"};
}

Result<void> check_sizes(const SpecimenParams& p) {
  const std::vector<std::string> taken = sizes_of(p.kind);
  const std::array<std::pair<const char*, bool>, 6> given{{{"width", p.width.has_value()},
                                                           {"height", p.height.has_value()},
                                                           {"radius", p.radius.has_value()},
                                                           {"crack_length", p.crack.has_value()},
                                                           {"position", p.position.has_value()},
                                                           {"angle", p.angle.has_value()}}};
  for (const auto& [key, is_given] : given) {
    if (!is_given || std::find(taken.begin(), taken.end(), key) != taken.end()) continue;
    const std::string who =
        p.kind == SpecimenKind::None
            ? std::string("no `specimen` is named")
            : fmt::format("'{}' takes {}", specimen_names()[static_cast<std::size_t>(p.kind)], fmt::join(taken, ", "));
    return Error{ErrorCode::BadValue, fmt::format("`{}` is a size that nothing has: {}; remove it", key, who)};
  }
  return {};
}

Result<Sketch> make_specimen(const SpecimenParams& params) {
  DOBRA_TRY_VOID(check_sizes(params));
  switch (params.kind) {
    case SpecimenKind::None:
      break;
    case SpecimenKind::PlateWithHole:
      return plate_with_hole(params);
    case SpecimenKind::QuarterPlate:
      return quarter_plate(params);
    case SpecimenKind::LShape:
      return l_shape(params);
    case SpecimenKind::Cook:
      return cook(params);
    case SpecimenKind::SingleEdgeNotch:
      return edge_notches(params, false);
    case SpecimenKind::DoubleEdgeNotch:
      return edge_notches(params, true);
    case SpecimenKind::CentreCrack:
      return centre_crack(params);
    case SpecimenKind::CompactTension:
      return compact_tension(params);
    case SpecimenKind::ThreePointBend:
      return three_point_bend(params);
    case SpecimenKind::PmmaBeam:
      return pmma_beam(params);
    case SpecimenKind::DoubleCantilever:
      return double_cantilever(params);
    case SpecimenKind::BrazilianDisc:
      return brazilian_disc(params);
  }
  return Error{ErrorCode::BadValue, "no specimen is named"};
}

}  // namespace quebra::sketch
