#pragma once
// Seeded faces of many kinds that are hard to import and to mesh, as files in OCCT's text format, each with its area.

#include <cstdint>
#include <numbers>
#include <random>

#include "tests/support/brep_writer.h"

namespace dobra::support {

/// An edge in space that bounds the face: no seam, and not one point.
struct HardEdge {
  std::size_t a = 0, b = 0;  ///< Vertices; edges that meet in space share them.
  std::vector<Point3> points;
};

struct HardFace {
  std::string kind;
  std::string text;   ///< The file.
  bool sound = true;  ///< A mesher should succeed; else what is wrong stands in `wrong`.
  std::string wrong = {};
  double area = 0.0;    ///< By rays or a closed form.
  double unsure = 0.0;  ///< Part of the area by which what is meant may differ: gaps, tolerances.
  std::vector<HardEdge> outline = {};
  double tolerance = 0.0;  ///< The greatest of its edges, m.
  int handles = 0;         ///< Of the whole surface: 1 for a torus.
};

inline constexpr std::uint32_t hard_face_kinds = 30;

/// Whether the area is computed, which takes longer than the rest.
enum class WithArea { No, Yes };

namespace detail {

class HardFaceMaker {
 public:
  HardFaceMaker(std::uint32_t seed, WithArea with_area) : seed_(seed), with_area_(with_area), random_(seed) {}

  HardFace make() {
    using Make = void (HardFaceMaker::*)();
    static constexpr Make makers[hard_face_kinds] = {&HardFaceMaker::gaps,
                                                     &HardFaceMaker::thin_strip,
                                                     &HardFaceMaker::pole,
                                                     &HardFaceMaker::cap_without_seam,
                                                     &HardFaceMaker::whole_torus,
                                                     &HardFaceMaker::apex,
                                                     &HardFaceMaker::kinked,
                                                     &HardFaceMaker::light_weights,
                                                     &HardFaceMaker::stretched_chart,
                                                     &HardFaceMaker::loops_turned,
                                                     &HardFaceMaker::out_of_order,
                                                     &HardFaceMaker::a_period_off,
                                                     &HardFaceMaker::tiny_edges,
                                                     &HardFaceMaker::near_holes,
                                                     &HardFaceMaker::drum,
                                                     &HardFaceMaker::long_thin,
                                                     &HardFaceMaker::beyond_knots,
                                                     &HardFaceMaker::no_chart_curves,
                                                     &HardFaceMaker::mirrored,
                                                     &HardFaceMaker::ring,
                                                     &HardFaceMaker::open_loop,
                                                     &HardFaceMaker::bow_tie,
                                                     &HardFaceMaker::hole_across,
                                                     &HardFaceMaker::endless_plane,
                                                     &HardFaceMaker::far_from_space,
                                                     &HardFaceMaker::no_area,
                                                     &HardFaceMaker::far_outside,
                                                     &HardFaceMaker::folded_offset,
                                                     &HardFaceMaker::missing_edge,
                                                     &HardFaceMaker::wave};
    (this->*makers[seed_ % hard_face_kinds])();
    face_.text = brep_text(draft_);
    add_outline();
    return face_;
  }

 private:
  static constexpr double pi = std::numbers::pi;
  using Way = std::vector<std::pair<Path, bool>>;

  double real(double from = 0.0, double to = 1.0) {
    return from + (to - from) * std::uniform_real_distribution<double>(0.0, 1.0)(random_);
  }
  int whole(int from, int to) { return from + static_cast<int>(random_() % static_cast<std::uint32_t>(to - from + 1)); }
  double power(double from, double to) { return std::pow(10.0, real(from, to)); }

  void add_outline() {
    constexpr int samples = 64;
    const auto& m = draft_.placement;
    const auto placed = [&](Point3 p) {
      const auto row = [&](std::size_t i) { return m[i] * p.x + m[i + 1] * p.y + m[i + 2] * p.z + m[i + 3]; };
      return Point3{row(0), row(4), row(8)};
    };
    const double scale = std::sqrt(m[0] * m[0] + m[4] * m[4] + m[8] * m[8]);
    for (const auto& wire : draft_.wires) {
      for (const DraftFace::Use& use : wire) {
        const DraftFace::Edge& edge = draft_.edges[use.edge];
        if (edge.still || edge.other) continue;
        HardEdge made{edge.a, edge.b, {}};
        for (int i = 0; i <= samples; ++i) {
          const double t = std::lerp(edge.path.from, edge.path.to, static_cast<double>(i) / samples);
          made.points.push_back(placed(draft_.surface.at(edge.path.at(t)) + edge.aside));
        }
        face_.outline.push_back(std::move(made));
        face_.tolerance = std::max(face_.tolerance, scale * edge.tolerance);
      }
    }
  }

  // Surfaces, and a part of their charts for a face.

  static std::string axes(Point3 at) {
    return fmt::format("{:.17g} {:.17g} {:.17g} 0 0 1 1 0 0 0 1 0", at.x, at.y, at.z);
  }
  static Carrier plane() {
    return {"1 0 0 0 0 0 1 1 0 0 0 1 0 \n", [](Point p) { return Point3{p.x, p.y, 0.0}; }};
  }
  static Carrier cylinder(double radius) {
    return {fmt::format("2 {} {:.17g}\n", axes({}), radius), [=](Point p) {
              return Point3{radius * std::cos(p.x), radius * std::sin(p.x), p.y};
            }};
  }
  static Carrier cone(double radius, double angle) {
    return {fmt::format("3 {} {:.17g} {:.17g}\n", axes({}), radius, angle), [=](Point p) {
              const double r = radius + p.y * std::sin(angle);
              return Point3{r * std::cos(p.x), r * std::sin(p.x), p.y * std::cos(angle)};
            }};
  }
  static Carrier sphere(double radius) {
    return {fmt::format("4 {} {:.17g}\n", axes({}), radius), [=](Point p) {
              return Point3{radius * std::cos(p.y) * std::cos(p.x), radius * std::cos(p.y) * std::sin(p.x),
                            radius * std::sin(p.y)};
            }};
  }
  static Carrier torus(double major, double minor) {
    return {fmt::format("5 {} {:.17g} {:.17g}\n", axes({}), major, minor), [=](Point p) {
              const double r = major + minor * std::cos(p.y);
              return Point3{r * std::cos(p.x), r * std::sin(p.x), minor * std::sin(p.y)};
            }};
  }
  /// A wavy patch on the unit square, `width` by `height`.
  PatchOf wavy(std::size_t degree, std::size_t count, double width, double height, double wave) {
    PatchOf patch{degree, degree, even_knots(degree, count), even_knots(degree, count), count, count, {}, {}};
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        const double u = static_cast<double>(i) / static_cast<double>(count - 1);
        const double v = static_cast<double>(j) / static_cast<double>(count - 1);
        patch.points.push_back({width * u, height * v, wave * real(-1.0, 1.0)});
      }
    }
    return patch;
  }
  /// Any surface, with a rectangle of its chart about 1 m wide.
  std::pair<Carrier, std::array<double, 4>> any_surface() {
    switch (whole(0, 5)) {
      case 0:
        return {plane(), {-0.5, 0.5, -0.5, 0.5}};
      case 1:
        return {cylinder(0.7), {0.3, 1.8, -0.5, 0.5}};
      case 2:
        return {cone(0.5, 0.4), {0.3, 1.9, 0.0, 0.9}};
      case 3:
        return {sphere(0.8), {0.5, 1.9, -0.6, 0.8}};
      case 4:
        return {torus(1.0, 0.4), {0.2, 1.2, 0.4, 2.4}};
      default:
        return {patch_carrier(wavy(3, 6, 1.0, 1.0, 0.15)), {0.05, 0.95, 0.05, 0.95}};
    }
  }

  // Loops.

  /// Corners joined by straight lines, each beginning `gap` beside the end of the one before.
  Way add_polygon(const std::vector<Point>& corners, double gap = 0.0, double tolerance = 1e-7) {
    const std::size_t first = draft_.vertices.size(), count = corners.size();
    for (const Point& p : corners) draft_.add_vertex(p, tolerance);
    Way way;
    draft_.wires.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      const geom::Vector off{gap * real(-0.7, 0.7), gap * real(-0.7, 0.7)};
      const Path path = line_path(corners[i] + off, corners[(i + 1) % count]);
      way.emplace_back(line_path(corners[i], corners[(i + 1) % count]), false);
      const std::size_t edge =
          draft_.add_edge({path, std::nullopt, first + i, first + (i + 1) % count, false, true, {}, tolerance});
      draft_.wires.back().push_back({edge, '+'});
    }
    return way;
  }
  /// A closed ellipse with one vertex, clockwise for a hole.
  Way add_ellipse(Point centre, double a, double b, bool hole) {
    const Path path = arc_path(centre, a, b, 0.0, 2.0 * pi);
    const std::size_t vertex = draft_.add_vertex(path.at(path.from));
    const std::size_t edge = draft_.add_edge({path, std::nullopt, vertex, vertex});
    draft_.wires.push_back({{edge, hole ? '-' : '+'}});
    return {{path, hole}};
  }
  std::vector<Point> corners_in(const std::array<double, 4>& box, int count) {
    std::vector<Point> corners;
    const Point centre{0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])};
    const double turn = real(0.0, 2.0 * pi);
    for (int i = 0; i < count; ++i) {
      const double angle = turn + (i + real(-0.3, 0.3)) * 2.0 * pi / count, part = real(0.55, 1.0);
      corners.push_back({centre.x + part * 0.5 * (box[1] - box[0]) * std::cos(angle),
                         centre.y + part * 0.5 * (box[3] - box[2]) * std::sin(angle)});
    }
    return corners;
  }
  static Point middle_of(const Way& way) {
    Point sum{};
    constexpr int places = 8;
    for (const auto& [path, back] : way) {
      for (int i = 0; i < places; ++i)
        sum = sum + (path.at(std::lerp(path.from, path.to, (i + 0.5) / places)) - Point{});
    }
    const double count_of = places * static_cast<double>(way.size());
    return {sum.x / count_of, sum.y / count_of};
  }
  void count(const Way& way) {
    if (with_area_ == WithArea::Yes) face_.area += area_by_rays(draft_.surface, way, middle_of(way));
  }
  void place_anywhere() {
    const double c = std::cos(0.7 + seed_), s = std::sin(0.7 + seed_);
    draft_.placement = {c, -s, 0, real(-3, 3), s, c, 0, real(-3, 3), 0, 0, 1, real(-3, 3)};
  }
  void sound(std::string kind) {
    face_.kind = std::move(kind);
    place_anywhere();
  }
  void broken(std::string kind, std::string wrong) {
    sound(std::move(kind));
    face_.sound = false;
    face_.wrong = std::move(wrong);
  }

  // Sound ones.

  void gaps() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    const double gap = power(-7.0, -3.3);
    count(add_polygon(corners_in(box, whole(3, 7)), gap, 3.0 * gap));
    face_.unsure = 10.0 * gap;
    sound("gaps");
  }

  /// Between two curves over u that nearly touch in places.
  void thin_strip() {
    draft_.surface = patch_carrier(wavy(3, 7, 1.0, 1.0, 0.1));
    const double width = power(-2.5, -1.5), least = 0.1 * width;
    std::vector<Point> low, high;
    constexpr int points = 9;
    for (int i = 0; i < points; ++i) {
      const double u = 0.1 + 0.8 * i / (points - 1.0), v = 0.5 + real(-0.1, 0.1);
      low.push_back({u, v});
      high.push_back({u, v + (i % 4 == 2 ? least : width)});
    }
    const Path below = spline_path(3, even_knots(3, points), low), above = spline_path(3, even_knots(3, points), high);
    count(add_between(below, above));
    face_.unsure = 1e-4;
    sound("thin strip");
  }
  /// Two paths over the same u with straight sides.
  Way add_between(const Path& below, const Path& above) {
    const Point a = below.at(below.from), b = below.at(below.to), c = above.at(above.to), d = above.at(above.from);
    std::array<std::size_t, 4> v{};
    std::size_t k = 0;
    for (const Point& p : {a, b, c, d}) v[k++] = draft_.add_vertex(p);
    const std::size_t bottom = draft_.add_edge({below, std::nullopt, v[0], v[1]});
    const std::size_t right = draft_.add_edge({line_path(b, c), std::nullopt, v[1], v[2]});
    const std::size_t top = draft_.add_edge({above, std::nullopt, v[3], v[2]});
    const std::size_t left = draft_.add_edge({line_path(d, a), std::nullopt, v[3], v[0]});
    draft_.wires.push_back({{bottom, '+'}, {right, '+'}, {top, '-'}, {left, '+'}});
    return {{below, false}, {line_path(b, c), false}, {above, true}, {line_path(d, a), false}};
  }

  /// A cap of a sphere with seam and degenerate edge.
  void pole() {
    const double radius = real(0.5, 2.0), from = real(-0.8, 1.2);
    draft_.surface = sphere(radius);
    add_turned(from, 0.5 * pi, false, true);
    face_.area = 2.0 * pi * radius * radius * (1.0 - std::sin(from));
    sound("pole");
  }
  /// The whole turn between two values of v; an end may be one point.
  void add_turned(double from, double to, bool low_point, bool high_point) {
    const Point a{0.0, from}, b{2.0 * pi, from}, c{2.0 * pi, to}, d{0.0, to};
    const std::size_t low = draft_.add_vertex(a), high = draft_.add_vertex(d);
    const std::size_t bottom = draft_.add_edge({line_path(a, b), std::nullopt, low, low, low_point});
    const std::size_t seam = draft_.add_edge({line_path(b, c), line_path(a, d), low, high});
    const std::size_t top = draft_.add_edge({line_path(d, c), std::nullopt, high, high, high_point});
    draft_.wires.push_back({{bottom, '+'}, {seam, '+'}, {top, '-'}, {seam, '-'}});
  }

  void cap_without_seam() {
    const double radius = real(0.5, 2.0), from = real(-0.8, 1.2);
    draft_.surface = sphere(radius);
    const Path round = line_path({0.0, from}, {2.0 * pi, from});
    const std::size_t vertex = draft_.add_vertex({0.0, from});
    draft_.wires.push_back({{draft_.add_edge({round, std::nullopt, vertex, vertex}), '+'}});
    face_.area = 2.0 * pi * radius * radius * (1.0 - std::sin(from));
    sound("cap without seam");
  }

  void whole_torus() {
    const double minor = real(0.2, 0.6), major = 1.0;
    draft_.surface = torus(major, minor);
    const double turn = 2.0 * pi;
    const Point a{0.0, 0.0}, b{turn, 0.0}, c{turn, turn}, d{0.0, turn};
    const std::size_t v = draft_.add_vertex(a);
    const std::size_t along = draft_.add_edge({line_path(a, b), line_path(d, c), v, v});
    const std::size_t across = draft_.add_edge({line_path(b, c), line_path(a, d), v, v});
    draft_.wires.push_back({{along, '+'}, {across, '+'}, {along, '-'}, {across, '-'}});
    face_.area = 4.0 * pi * pi * major * minor;
    face_.handles = 1;
    sound("whole torus");
  }

  void apex() {
    const double radius = real(0.3, 1.0), angle = real(0.2, 1.2), top = -radius / std::sin(angle), low = real(0.1, 1.0);
    draft_.surface = cone(radius, angle);
    add_turned(top, low, true, false);
    face_.area = pi * (low - top) * (low - top) * std::sin(angle);
    sound("apex");
  }

  /// Knots as often as the degree: the normal jumps along lines of the chart.
  void kinked() {
    PatchOf patch = wavy(2, 7, 1.0, 1.0, 0.15);
    patch.knots_u = patch.knots_v = {0, 0, 0, 0.37, 0.37, 0.6, 0.6, 1, 1, 1};
    draft_.surface = patch_carrier(patch);
    count(add_polygon(corners_in({0.05, 0.95, 0.05, 0.95}, whole(3, 7))));
    face_.unsure = 5e-3;
    sound("kinked");
  }

  void light_weights() {
    PatchOf patch = wavy(3, 6, 1.0, 1.0, 0.1);
    for (std::size_t i = 0; i < patch.points.size(); ++i) patch.weights.push_back(i % 7 == 3 ? 1e-3 : real(0.5, 2.0));
    draft_.surface = patch_carrier(patch);
    count(add_polygon(corners_in({0.05, 0.95, 0.05, 0.95}, whole(3, 7))));
    face_.unsure = 1e-4;
    sound("light weights");
  }

  /// A chart 1000 times longer than wide, or one whose lines meet at small angles.
  void stretched_chart() {
    PatchOf patch = wavy(3, 6, 1.0, 1.0, 0.1);
    const bool skewed = whole(0, 1) == 1;
    const double across = skewed ? 1.0 : 1000.0;
    if (skewed) {
      for (Point3& p : patch.points) p.x += 8.0 * p.y;
    }
    for (double& knot : patch.knots_u) knot *= across;
    draft_.surface = patch_carrier(patch);
    count(add_polygon(corners_in({0.05 * across, 0.95 * across, 0.05, 0.95}, whole(3, 7))));
    sound(skewed ? "skewed chart" : "stretched chart");
  }

  void loops_turned() {
    draft_.surface = plane();
    count(add_polygon({{0, 0}, {2, 0}, {2, 1.5}, {0, 1.5}}));
    count(add_ellipse({1.0, 0.8}, real(0.2, 0.6), real(0.2, 0.5), true));
    for (auto& wire : draft_.wires) {
      if (&wire == &draft_.wires[0] || whole(0, 1) == 1) {
        std::reverse(wire.begin(), wire.end());
        for (DraftFace::Use& use : wire) use.sign = use.sign == '+' ? '-' : '+';
      }
    }
    sound("loops turned");
  }

  void out_of_order() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    count(add_polygon(corners_in(box, whole(5, 9))));
    std::shuffle(draft_.wires[0].begin(), draft_.wires[0].end(), random_);
    sound("out of order");
  }

  void a_period_off() {
    const double radius = real(0.5, 1.0);
    draft_.surface = cylinder(radius);
    const Point a{0.5, 0.0}, b{2.5, 0.0}, c{2.5, 1.0}, d{0.5, 1.0};
    const geom::Vector turn{2.0 * pi, 0.0};
    const Path below = line_path(a, b), above = line_path(c + turn, d + turn);
    std::array<std::size_t, 4> v{};
    std::size_t k = 0;
    for (const Point& p : {a, b, c, d}) v[k++] = draft_.add_vertex(p);
    const std::size_t edges[]{draft_.add_edge({below, std::nullopt, v[0], v[1]}),
                              draft_.add_edge({line_path(b, c), std::nullopt, v[1], v[2]}),
                              draft_.add_edge({above, std::nullopt, v[2], v[3]}),
                              draft_.add_edge({line_path(d - turn, a - turn), std::nullopt, v[3], v[0]})};
    draft_.wires.push_back({{edges[0], '+'}, {edges[1], '+'}, {edges[2], '+'}, {edges[3], '+'}});
    face_.area = 2.0 * radius;
    sound("a period off");
  }

  void tiny_edges() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    std::vector<Point> corners = corners_in(box, whole(4, 6));
    const double size = power(-9.0, -7.5);
    corners.insert(corners.begin() + 2, corners[1] + geom::Vector{size, 0.3 * size});
    count(add_polygon(corners));
    face_.unsure = 1e-6;
    sound("tiny edges");
  }

  void near_holes() {
    const bool flat = whole(0, 1) == 0;
    draft_.surface = flat ? plane() : patch_carrier(wavy(3, 6, 1.0, 1.0, 0.1));
    count(add_polygon({{0.02, 0.02}, {0.98, 0.02}, {0.98, 0.98}, {0.02, 0.98}}));
    const double gap = power(-3.5, -2.0), a = real(0.1, 0.2), b = real(0.1, 0.2);
    count(add_ellipse({0.5 - 0.5 * gap - a, 0.5}, a, real(0.1, 0.2), true));
    count(add_ellipse({0.5 + 0.5 * gap + b, 0.5}, b, real(0.1, 0.2), true));
    sound("near holes");
  }

  /// A whole turn of a cylinder with a hole.
  void drum() {
    const double radius = real(0.4, 1.0);
    draft_.surface = cylinder(radius);
    add_turned(0.0, 1.0, false, false);
    const double a = real(0.2, 0.8), b = real(0.1, 0.3);
    add_ellipse({real(1.5, 4.5), 0.5}, a, b, true);
    face_.area = radius * (2.0 * pi - pi * a * b);
    sound("drum");
  }

  void long_thin() {
    const double height = power(-2.5, -1.5);
    // It waves along itself; across, no more than its width lets it.
    PatchOf patch = wavy(3, 7, 1.0, height, 0.2 * height);
    for (std::size_t i = 0; i < patch.count_u; ++i) {
      const double wave = real(-0.02, 0.02);
      for (std::size_t j = 0; j < patch.count_v; ++j) patch.points[i * patch.count_v + j].z += wave;
    }
    draft_.surface = patch_carrier(patch);
    count(add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    face_.unsure = 5e-4;
    sound("long and thin");
  }

  /// Curves that leave the range of the knots a little.
  void beyond_knots() {
    draft_.surface = patch_carrier(wavy(3, 6, 1.0, 1.0, 0.1));
    const double by = power(-8.0, -5.0);
    count(add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    draft_.edges[0].path = line_path({0.0, -by}, {1.0, -by});
    draft_.edges[1].path = line_path({1.0 + by, 0.0}, {1.0 + by, 1.0});
    for (DraftFace::Edge& edge : draft_.edges) edge.tolerance = 10.0 * by;
    for (DraftFace::Vertex& vertex : draft_.vertices) vertex.tolerance = 10.0 * by;
    face_.unsure = 10.0 * by;
    sound("beyond knots");
  }

  /// Edges with curves in space alone: on a plane all of them.
  void no_chart_curves() {
    draft_.surface = plane();
    count(add_polygon(corners_in({-1, 1, -1, 1}, whole(5, 9))));
    count(add_ellipse({0.0, 0.0}, 0.15, 0.1, true));
    for (DraftFace::Edge& edge : draft_.edges) edge.chart = false;
    sound("no chart curves");
  }

  void mirrored() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    count(add_polygon(corners_in(box, whole(3, 7))));
    sound("mirrored and scaled");
    const double by = power(-1.0, 1.0);
    for (std::size_t i = 0; i < 12; ++i) {
      if (i % 4 != 3) draft_.placement[i] *= by;
    }
    for (std::size_t row = 0; row < 3; ++row) draft_.placement[4 * row] *= -1.0;
    face_.area *= by * by;
  }

  /// Two circles round a cylinder, without a seam.
  void ring() {
    const double radius = real(0.4, 1.0);
    draft_.surface = cylinder(radius);
    for (const bool up : {false, true}) {
      const double v = up ? 0.8 : 0.0, from = up ? 1.0 : 0.0;
      const Path round = line_path({from, v}, {from + 2.0 * pi, v});
      const std::size_t vertex = draft_.add_vertex({from, v});
      draft_.wires.push_back({{draft_.add_edge({round, std::nullopt, vertex, vertex}), up ? '-' : '+'}});
    }
    face_.area = 2.0 * pi * radius * 0.8;
    sound("ring without seam");
  }

  /// A whole wavy patch with a hole whose border waves.
  void wave() {
    draft_.surface = patch_carrier(wavy(3, 8, 1.0, 1.0, 0.12));
    count(add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    std::vector<Point> points;
    const int count_of = 16;
    for (int i = 0; i < count_of; ++i) {
      const double angle = -2.0 * pi * i / count_of, r = 0.3 * (1.0 + 0.25 * (i % 2 == 0 ? 1.0 : -1.0));
      points.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle)});
    }
    points.push_back(points.front());
    const Path round = spline_path(3, even_knots(3, points.size()), points);
    const std::size_t vertex = draft_.add_vertex(points.front());
    draft_.wires.push_back({{draft_.add_edge({round, std::nullopt, vertex, vertex}), '+'}});
    constexpr int panels = 28;  // two for each piece of the spline
    if (with_area_ == WithArea::Yes) face_.area += area_by_rays(draft_.surface, {{round, false}}, {0.5, 0.5}, panels);
    face_.unsure = 1e-4;
    sound("wave");
  }

  // Broken ones.

  void open_loop() {
    draft_.surface = plane();
    add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    draft_.edges[1].path = line_path({1.0, 0.2}, {1.0, 1.0});
    broken("open loop", "a gap of a fifth of a side");
  }
  void bow_tie() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    add_polygon({{box[0], box[2]}, {box[1], box[3]}, {box[1], box[2]}, {box[0], box[3]}});
    broken("bow tie", "the loop crosses itself");
  }
  void hole_across() {
    draft_.surface = plane();
    add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    add_ellipse({real(0.9, 1.1), 0.5}, 0.3, 0.2, true);
    broken("hole across", "a hole crosses the outer loop");
  }
  void endless_plane() {
    draft_.surface = plane();
    broken("endless plane", "no loop on a surface without an end");
  }
  void far_from_space() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    add_polygon(corners_in(box, 4));
    draft_.edges[2].aside = {0.1, 0.05, 0.1};
    broken("far from space", "a curve of an edge in space is a tenth of the face from that in the chart");
  }
  void no_area() {
    draft_.surface = plane();
    add_polygon({{0, 0}, {1, 0.3}, {2, 0.6}});
    broken("no area", "all edges lie on a line");
  }
  void far_outside() {
    draft_.surface = patch_carrier(wavy(3, 6, 1.0, 1.0, 0.1));
    add_polygon({{0.5, 0.1}, {1.4, 0.1}, {1.4, 0.9}, {0.5, 0.9}});
    broken("far outside", "the loop goes far beyond the knots");
  }
  void folded_offset() {
    const Carrier base = cylinder(0.5);
    draft_.surface = {"11 " + fmt::format("{:.17g} ", -0.7) + "\n" + base.text, [](Point p) {
                        return Point3{-0.2 * std::cos(p.x), -0.2 * std::sin(p.x), p.y};
                      }};
    add_polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    broken("folded offset", "the offset is greater than the radius of curvature");
  }
  void missing_edge() {
    const auto [surface, box] = any_surface();
    draft_.surface = surface;
    add_polygon(corners_in(box, 5));
    draft_.wires[0].erase(draft_.wires[0].begin() + whole(0, 4));
    broken("missing edge", "an edge of the loop is missing");
  }

  std::uint32_t seed_;
  WithArea with_area_;
  std::mt19937 random_;
  DraftFace draft_;
  HardFace face_;
};

}  // namespace detail

/// The same for the same seed; kinds follow each other.
inline HardFace hard_face(std::uint32_t seed, WithArea with_area = WithArea::Yes) {
  return detail::HardFaceMaker(seed, with_area).make();
}

}  // namespace dobra::support
