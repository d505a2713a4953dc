// Figures of predicates.md, intersect.md, spatial_index.md and discretise.md.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/geom/bezier.h"
#include "shared/geom/cubic_path.h"
#include "shared/geom/discretise.h"
#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/geom/spatial_index.h"
#include "tests/figures/figures.h"

namespace dobra::figures {
namespace {

using geom::Point;
using geom::Sign;

constexpr int cells = 64;  ///< Of the sign maps, along each side.

/// The sign of a, b, c as rounded arithmetic has it.
Sign naive_orient2d(Point a, Point b, Point c) {
  return geom::sign_of((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Cells of one sign, those that stand side by side in a row as one rectangle. Cell (i, j) is the point (0.5, 0.5)
/// moved by (i, j) units in the last place, against the line through (12, 12) and (24, 24).
scene::Region cells_of(Sign wanted, Sign (*orient)(Point, Point, Point)) {
  constexpr double ulp = 0x1p-53;
  const auto sign = [&](int i, int j) { return orient({0.5 + i * ulp, 0.5 + j * ulp}, {12.0, 12.0}, {24.0, 24.0}); };
  scene::Region region;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if (sign(i, j) != wanted) continue;
      const int first = i;
      while (i + 1 < cells && sign(i + 1, j) == wanted) ++i;
      region.contours.push_back(outline({{first - 0.5, j - 0.5}, {i + 0.5, j + 0.5}}));
    }
  }
  return region;
}

scene::Panel sign_map(const std::string& title, Sign (*orient)(Point, Point, Point)) {
  return panel(title,
               {regions("left of the line", filled({108, 149, 196}), {cells_of(Sign::Positive, orient)}),
                regions("on the line", filled({250, 214, 92}), {cells_of(Sign::Zero, orient)}),
                regions("right of the line", filled({198, 109, 98}), {cells_of(Sign::Negative, orient)})},
               0.0, {"x in units of 2\u207b\u2075\u00b3 from 0.5", "y in units of 2\u207b\u2075\u00b3 from 0.5"});
}

base::Result<scene::Picture> predicates() {
  return scene::Picture{{}, {sign_map("Rounded determinant", naive_orient2d), sign_map("orient2d", geom::orient2d)}};
}

std::string name_of(const geom::Intersection& found) {
  if (found.kind == geom::IntersectionKind::None) return "nothing";
  if (found.kind == geom::IntersectionKind::Overlap) return "overlap";
  if (found.start.proper()) return "crossing";
  const bool ends = found.start.on_first != geom::At::Interior && found.start.on_second != geom::At::Interior;
  return ends ? "common end" : "touch";
}

scene::Panel meeting(const geom::Segment& first, const geom::Segment& second) {
  const geom::Intersection found = geom::intersect(first, second);
  std::vector<geom::Polyline> common;
  std::vector<Point> points;
  if (found.kind != geom::IntersectionKind::None) points.push_back(found.start.point);
  if (found.kind == geom::IntersectionKind::Overlap) {
    points.push_back(found.end.point);
    common.push_back(chain({found.start.point, found.end.point}));
  }
  scene::Panel made = panel(name_of(found),
                            {lines("common piece", stroke({250, 214, 92}, 8.0), common),
                             lines("first segment", stroke(blue, 1.6), {chain({first.from, first.to})}),
                             lines("second segment", stroke(orange, 1.6), {chain({second.from, second.to})}),
                             markers("point returned", dots(red, 6.0), points)},
                            0.0, {"", ""});
  made.extent = geom::Box{{-0.4, -0.4}, {4.4, 4.4}};
  return made;
}

base::Result<scene::Picture> intersect() {
  return scene::Picture{{},
                        {meeting({{0, 1}, {4, 3}}, {{1, 4}, {3, 0}}), meeting({{0, 1}, {4, 3}}, {{2, 2}, {3, 0}}),
                         meeting({{0, 1}, {4, 3}}, {{4, 3}, {2, 4}}), meeting({{0, 1}, {3, 2.5}}, {{1, 1.5}, {4, 3}}),
                         meeting({{0, 1}, {4, 3}}, {{0, 2}, {1.5, 4}})}};
}

/// Boxes of the nodes `level` levels above the items: items come in the order of the tree, eight to a node.
std::vector<geom::Polyline> nodes_at(int level, const std::vector<std::size_t>& order,
                                     const std::vector<geom::Box>& boxes) {
  const std::size_t size = std::size_t{1} << (3 * level);
  std::vector<geom::Polyline> nodes;
  for (std::size_t first = 0; first < order.size(); first += size) {
    geom::Box box;
    for (std::size_t i = first; i < first + size; ++i) box.add(boxes[order[i]]);
    nodes.push_back(outline(box));
  }
  return nodes;
}

std::vector<geom::Box> scattered_boxes(std::size_t count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<geom::Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const Point low{15.0 * unit(random), 10.0 * unit(random)};
    boxes.push_back({low, {low.x + 0.1 + 0.25 * unit(random), low.y + 0.1 + 0.25 * unit(random)}});
  }
  return boxes;
}

base::Result<scene::Picture> spatial_index() {
  const std::vector<geom::Box> boxes = scattered_boxes(512);
  const geom::SpatialIndex index(boxes);
  std::vector<std::size_t> order;
  index.for_each_overlapping(index.box(), [&](std::size_t item) { order.push_back(item); });
  const geom::Box query{{5.6, 3.2}, {8.0, 4.9}};
  std::vector<geom::Polyline> items;
  for (const geom::Box& box : boxes) items.push_back(outline(box));
  std::vector<scene::Region> found;
  for (const std::size_t item : index.overlapping(query)) found.push_back({{outline(boxes[item])}});
  scene::Picture picture{{},
                         {panel("",
                                {regions(fmt::format("{} found", found.size()), filled({240, 178, 92}), found),
                                 lines("512 items", stroke(grey, 0.5), items),
                                 lines("level 1: 64 nodes", stroke(green, 0.8), nodes_at(1, order, boxes)),
                                 lines("level 2: 8 nodes", stroke(blue, 1.6), nodes_at(2, order, boxes)),
                                 lines("query", stroke(red, 1.8, scene::Dash::Dashed), {outline(query)})},
                                0.2)}};
  return picture;
}

/// r = 0.08 exp(angle / 4) over 1.6 turns: it turns evenly, but its length grows.
struct Spiral {
  static constexpr double growth = 0.25;
  static constexpr double whole = 3.2 * std::numbers::pi;
  static double angle(double t) { return whole * t; }
  static double radius(double t) { return 0.08 * std::exp(growth * angle(t)); }
  static Point point(double t) { return {radius(t) * std::cos(angle(t)), radius(t) * std::sin(angle(t))}; }
  static geom::Vector tangent(double t) {
    const geom::Vector out{std::cos(angle(t)), std::sin(angle(t))};
    return whole * radius(t) * (growth * out + geom::left_of(out));
  }
  static double length(double t0, double t1) {
    return std::sqrt(1.0 + growth * growth) / growth * (radius(t1) - radius(t0));
  }
};

base::Result<scene::Panel> discretised(const std::string& limits, const geom::DiscretiseOptions& options) {
  geom::Polyline fine;
  for (int i = 0; i <= 200; ++i) fine.points.push_back(Spiral::point(i / 200.0));
  DOBRA_TRY(const geom::Discretisation found, geom::discretise(Spiral{}, options));
  return panel(fmt::format("{}: {} segments", limits, found.points.size() - 1),
               {lines("curve", stroke(pale, 4.0), {fine}), lines("segments", stroke(blue, 1.0), {found.polyline()}),
                markers("points", dots(red, 3.5), found.points)},
               0.12, {"x [m]", "y [m]"});
}

base::Result<scene::Picture> discretise() {
  using base::Angle;
  scene::Picture picture;
  DOBRA_TRY(scene::Panel coarse, discretised("45\u00b0", {.max_angle = Angle::from_degrees(45.0)}));
  DOBRA_TRY(scene::Panel fine, discretised("20\u00b0", {.max_angle = Angle::from_degrees(20.0)}));
  DOBRA_TRY(scene::Panel both, discretised("45\u00b0 and 0.3 m", {Angle::from_degrees(45.0), 0.3}));
  picture.panels = {std::move(coarse), std::move(fine), std::move(both)};
  return picture;
}

template <geom::Curve C>
base::Result<geom::Polyline> drawn(const C& curve) {
  DOBRA_TRY(const geom::Discretisation found, geom::discretise(curve, {.max_angle = base::Angle::from_degrees(3.0)}));
  return found.polyline();
}

/// Uniform and chord-length knots through the same points; a closed spline; a B-spline and a Bezier of one polygon.
base::Result<scene::Picture> curves() {
  using geom::SplineEnds;
  const std::vector<Point> points{{0, 0}, {1, 1.6}, {1.4, 1.5}, {1.7, 0.2}, {5, 0.4}, {6, 1.4}};
  DOBRA_TRY(const auto uniform,
            geom::cubic_spline(points, geom::uniform_knots(6, SplineEnds::Natural), SplineEnds::Natural));
  DOBRA_TRY(const auto spaced,
            geom::cubic_spline(points, geom::chord_length_knots(points, SplineEnds::Natural), SplineEnds::Natural));
  DOBRA_TRY(geom::Polyline uniform_line, drawn(uniform));
  DOBRA_TRY(geom::Polyline spaced_line, drawn(spaced));
  const std::vector<Point> polygon{{0, 0}, {0.6, 2.2}, {2.6, 2.4}, {3.4, 0.1}, {5.2, 0.3}, {6, 2}};
  DOBRA_TRY(const auto spline, geom::uniform_b_spline(polygon));
  DOBRA_TRY(const auto bezier, geom::Bezier::make(polygon));
  DOBRA_TRY(geom::Polyline spline_line, drawn(spline));
  DOBRA_TRY(geom::Polyline bezier_line, drawn(bezier));
  return scene::Picture{
      {},
      {panel("Natural splines",
             {lines("uniform knots", stroke(orange, 1.4), {uniform_line}),
              lines("chord-length knots", stroke(ink, 1.8), {spaced_line}),
              markers("points, vertices", dots(red, 4.5), points)},
             0.3),
       panel("Control polygon",
             {lines("polygon", stroke(grey, 1.0, scene::Dash::Dashed), {chain(polygon)}),
              lines("uniform B-spline", stroke(blue, 1.8), {spline_line}),
              lines("Bezier, degree 5", stroke(green, 1.4), {bezier_line}), markers({}, dots(red, 4.5), polygon)},
             0.3)}};
}

}  // namespace

std::vector<Figure> geom_figures() {
  return {{"predicates", predicates},
          {"intersect", intersect},
          {"spatial_index", spatial_index},
          {"discretise", discretise},
          {"curves", curves}};
}

}  // namespace dobra::figures
