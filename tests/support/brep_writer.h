#pragma once
// Faces written in OCCT's text format, for tests: curves of charts and surfaces as text beside functions that say the
// same numbers. Shares nothing with the reader.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/geom/point.h"
#include "shared/geom/point3.h"

namespace dobra::support {

using geom::Point;
using geom::Point3;
using geom::Vector3;

/// A surface: what the file says of it and where its points are.
struct Carrier {
  std::string text;
  std::function<Point3(Point)> at;
};
/// A curve in a chart over a range.
struct Path {
  std::string text;
  double from = 0.0, to = 1.0;
  std::function<Point(double)> at;
};

inline Carrier flat() {
  return {"1 0 0 0 0 0 1 1 0 0 0 1 0 \n", [](Point p) { return Point3{p.x, p.y, 0.0}; }};
}
inline Carrier tube(double radius) {
  return {fmt::format("2 0 0 0 0 0 1 1 0 0 0 1 0 {:.17g}\n", radius), [=](Point p) {
            return Point3{radius * std::cos(p.x), radius * std::sin(p.x), p.y};
          }};
}
inline Carrier ball(double radius) {
  return {fmt::format("4 0 0 0 0 0 1 1 0 0 0 1 0 {:.17g}\n", radius), [=](Point p) {
            return Point3{radius * std::cos(p.y) * std::cos(p.x), radius * std::cos(p.y) * std::sin(p.x),
                          radius * std::sin(p.y)};
          }};
}

inline Path line_path(Point a, Point b) {
  const geom::Vector way = b - a;
  const double size = geom::length(way);
  const geom::Vector unit = way / size;
  return {fmt::format("1 {:.17g} {:.17g} {:.17g} {:.17g} \n", a.x, a.y, unit.x, unit.y), 0.0, size,
          [=](double t) { return a + t * unit; }};
}
/// An arc with half axes along u and v, anticlockwise.
inline Path arc_path(Point centre, double along_u, double along_v, double from, double to) {
  // The format has the greater half axis first.
  const bool wide = along_u >= along_v;
  const double turn = wide ? 0.0 : -1.5707963267948966;
  const std::string axes = wide ? "1 0 0 1" : "0 1 -1 0";
  return {fmt::format("3 {:.17g} {:.17g} {} {:.17g} {:.17g} \n", centre.x, centre.y, axes, std::max(along_u, along_v),
                      std::min(along_u, along_v)),
          from + turn, to + turn, [=](double t) {
            const double s = t - turn;
            return Point{centre.x + along_u * std::cos(s), centre.y + along_v * std::sin(s)};
          }};
}

/// Value of a B-spline at t by de Boor's triangle, components by themselves. `point(i)` is control point i.
template <std::size_t N, class PointOf>
std::array<double, N> de_boor_value(std::size_t degree, const std::vector<double>& knots, std::size_t count,
                                    PointOf&& point, double t) {
  std::size_t k = degree;
  while (k + 1 < count && knots[k + 1] <= t) ++k;
  std::array<std::array<double, N>, 8> d{};
  for (std::size_t j = 0; j <= degree; ++j) d[j] = point(k - degree + j);
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const double low = knots[j + k - degree], high = knots[j + 1 + k - r], a = (t - low) / (high - low);
      for (std::size_t c = 0; c < N; ++c) d[j][c] = (1.0 - a) * d[j - 1][c] + a * d[j][c];
    }
  }
  return d[degree];
}

/// Knots of the format: each once, with how often it stands.
inline std::string knots_text(const std::vector<double>& knots) {
  std::string text;
  for (std::size_t i = 0; i < knots.size();) {
    std::size_t j = i;
    while (j < knots.size() && knots[j] == knots[i]) ++j;
    text += fmt::format(" {:.17g} {}", knots[i], j - i);
    i = j;
  }
  return text;
}
inline std::size_t distinct(const std::vector<double>& knots) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < knots.size(); ++i) count += knots[i] != knots[i - 1] ? 1U : 0U;
  return count;
}
/// Degree + 1 times 0 and 1, the inner ones at equal steps.
inline std::vector<double> even_knots(std::size_t degree, std::size_t points) {
  std::vector<double> knots(degree + 1, 0.0);
  const std::size_t spans = points - degree;
  for (std::size_t i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i) / static_cast<double>(spans));
  knots.insert(knots.end(), degree + 1, 1.0);
  return knots;
}

inline Path spline_path(std::size_t degree, const std::vector<double>& knots, const std::vector<Point>& points) {
  std::string text = fmt::format("7 0 0  {} {} {} ", degree, points.size(), distinct(knots));
  std::vector<std::array<double, 2>> values;
  for (const Point& p : points) {
    text += fmt::format(" {:.17g} {:.17g}", p.x, p.y);
    values.push_back({p.x, p.y});
  }
  text += "\n" + knots_text(knots) + "\n";
  return {text, knots[degree], knots[points.size()], [=](double t) {
            const auto v = de_boor_value<2>(
                degree, knots, values.size(), [&](std::size_t i) { return values[i]; }, t);
            return Point{v[0], v[1]};
          }};
}

/// Control points with v running fastest; weights beside them, or none.
struct PatchOf {
  std::size_t degree_u = 3, degree_v = 3;
  std::vector<double> knots_u, knots_v;
  std::size_t count_u = 0, count_v = 0;
  std::vector<Point3> points;
  std::vector<double> weights = {};
};
inline Carrier patch_carrier(const PatchOf& patch) {
  const bool rational = !patch.weights.empty();
  std::string text =
      fmt::format("9 {0} {0} 0 0 {1} {2} {3} {4} {5} {6} ", rational ? 1 : 0, patch.degree_u, patch.degree_v,
                  patch.count_u, patch.count_v, distinct(patch.knots_u), distinct(patch.knots_v));
  std::vector<std::vector<std::array<double, 4>>> rows(patch.count_u);
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    const Point3& p = patch.points[i];
    const double w = rational ? patch.weights[i] : 1.0;
    text += fmt::format("{:.17g} {:.17g} {:.17g} ", p.x, p.y, p.z);
    if (rational) text += fmt::format("{:.17g} ", w);
    rows[i / patch.count_v].push_back({w * p.x, w * p.y, w * p.z, w});
  }
  text += "\n" + knots_text(patch.knots_u) + "\n" + knots_text(patch.knots_v) + "\n";
  return {text, [patch, rows](Point uv) {
            const auto row_at = [&](std::size_t i) {
              return de_boor_value<4>(
                  patch.degree_v, patch.knots_v, patch.count_v, [&](std::size_t j) { return rows[i][j]; }, uv.y);
            };
            const auto v = de_boor_value<4>(patch.degree_u, patch.knots_u, patch.count_u, row_at, uv.x);
            return Point3{v[0] / v[3], v[1] / v[3], v[2] / v[3]};
          }};
}

/// One face with its edges.
struct DraftFace {
  struct Vertex {
    Point3 at;
    double tolerance = 1e-7;
  };
  struct Edge {
    Path path;
    std::optional<Path> other = std::nullopt;  ///< Of the reversed edge: a seam.
    std::size_t a = 0, b = 0;                  ///< Vertices.
    bool still = false;                        ///< One point in space.
    bool chart = true;                         ///< Writes its curve in the chart.
    geom::Vector3 aside{};                     ///< Its curve in space lies so far from the surface.
    double tolerance = 1e-7;
  };
  struct Use {
    std::size_t edge = 0;
    char sign = '+';
  };
  Carrier surface;
  std::vector<Vertex> vertices = {};
  std::vector<Edge> edges = {};
  std::vector<std::vector<Use>> wires = {};
  bool reversed = false;
  std::array<double, 12> placement{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  ///< Rows of the location.

  std::size_t add_vertex(Point at, double tolerance = 1e-7) {
    vertices.push_back({surface.at(at), tolerance});
    return vertices.size() - 1;
  }
  std::size_t add_edge(Edge edge) {
    edges.push_back(std::move(edge));
    return edges.size() - 1;
  }
};

/// A polygon of straight edges as a wire of its own.
inline void add_wire(DraftFace& draft, const std::vector<Point>& corners) {
  const std::size_t first = draft.vertices.size(), count = corners.size();
  for (const Point& p : corners) draft.add_vertex(p);
  draft.wires.emplace_back();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const std::size_t edge =
        draft.add_edge({line_path(corners[i], corners[next]), std::nullopt, first + i, first + next});
    draft.wires.back().push_back({edge, '+'});
  }
}

/// A cubic spline in space by the parameter of a path, with places and slopes at equal steps.
inline std::string space_curve_text(const Carrier& surface, const Path& path, Vector3 aside) {
  constexpr int spans = 32;
  const double step = (path.to - path.from) / spans, h = 1e-4 * step;
  const auto at = [&](double t) { return surface.at(path.at(t)) + aside; };
  std::vector<Point3> points;
  for (int i = 0; i < spans; ++i) {
    const double a = path.from + i * step, b = i + 1 == spans ? path.to : a + step;
    // One-sided, so that a break of the surface at a place of the spline does no harm.
    const auto slope = [&](double t, double by) {
      return (1.0 / (6.0 * by)) * (-11.0 * (at(t) - Point3{}) + 18.0 * (at(t + by) - Point3{}) -
                                   9.0 * (at(t + 2 * by) - Point3{}) + 2.0 * (at(t + 3 * by) - Point3{}));
    };
    if (i == 0) points.push_back(at(a));
    points.push_back(at(a) + (step / 3.0) * slope(a, h));
    points.push_back(at(b) - (step / 3.0) * slope(b, -h));
    points.push_back(at(b));
  }
  std::string text = fmt::format("7 0 0  3 {} {} ", points.size(), spans + 1);
  for (const Point3& p : points) text += fmt::format(" {:.17g} {:.17g} {:.17g}", p.x, p.y, p.z);
  text += "\n";
  for (int i = 0; i <= spans; ++i)
    text += fmt::format(" {:.17g} {}", i == spans ? path.to : path.from + i * step, i == 0 || i == spans ? 4 : 3);
  return text + "\n";
}

/// The whole file.
inline std::string brep_text(const DraftFace& face) {
  std::string charts, curves, shapes;
  std::size_t chart_count = 0, curve_count = 0;
  // Shapes: vertices, edges, wires, the face; numbered from the last to the first.
  const std::size_t total = face.vertices.size() + face.edges.size() + face.wires.size() + 1;
  const auto number = [&](std::size_t index) { return total - index; };
  for (const DraftFace::Vertex& v : face.vertices)
    shapes +=
        fmt::format("Ve\n{:.17g}\n{:.17g} {:.17g} {:.17g}\n0 0\n\n0101101\n*\n", v.tolerance, v.at.x, v.at.y, v.at.z);
  for (const DraftFace::Edge& e : face.edges) {
    shapes += fmt::format("Ed\n {:.17g} 1 1 {}\n", e.tolerance, e.still ? 1 : 0);
    const std::string range = fmt::format(" {:.17g} {:.17g}\n", e.path.from, e.path.to);
    if (!e.still) {
      curves += space_curve_text(face.surface, e.path, e.aside);
      shapes += fmt::format("1  {} 0{}", ++curve_count, range);
    }
    if (e.chart) {
      charts += e.path.text;
      const std::size_t first = ++chart_count;
      if (e.other) {
        charts += e.other->text;
        shapes += fmt::format("3  {} {}CN 1 0{}", first, ++chart_count, range);
      } else {
        shapes += fmt::format("2  {} 1 0{}", first, range);
      }
    }
    shapes += fmt::format("0\n\n0101000\n+{} 0 -{} 0 *\n", number(e.a), number(e.b));
  }
  const std::size_t before_edges = face.vertices.size(), before_wires = before_edges + face.edges.size();
  for (const auto& wire : face.wires) {
    shapes += "Wi\n\n0101100\n";
    for (const DraftFace::Use& use : wire) shapes += fmt::format("{}{} 0 ", use.sign, number(before_edges + use.edge));
    shapes += "*\n";
  }
  shapes += "Fa\n0  1e-07 1 0\n\n0101000\n";
  for (std::size_t i = 0; i < face.wires.size(); ++i) shapes += fmt::format("+{} 0 ", number(before_wires + i));
  shapes += "*\n";
  const auto& p = face.placement;
  std::string text = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 1\n1\n";
  for (std::size_t row = 0; row < 3; ++row)
    text +=
        fmt::format(" {:.17g} {:.17g} {:.17g} {:.17g} \n", p[4 * row], p[4 * row + 1], p[4 * row + 2], p[4 * row + 3]);
  text += fmt::format("Curve2ds {}\n{}Curves {}\n{}Polygon3D 0\nPolygonOnTriangulations 0\nSurfaces 1\n{}", chart_count,
                      charts, curve_count, curves, face.surface.text);
  text += fmt::format("Triangulations 0\n\nTShapes {}\n{}\n{}1 1 \n", total, shapes, face.reversed ? '-' : '+');
  return text;
}

/// Area within a closed way round the chart, signed: rays from a centre, rule of Gauss in both directions, the area
/// element from differences of the surface's points. For any way, if the surface has points on all rays.
inline double area_by_rays(const Carrier& surface, const std::vector<std::pair<Path, bool>>& way, Point centre,
                           int panels = 12) {
  constexpr std::array<double, 5> at{-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831,
                                     0.9061798459386640};
  constexpr std::array<double, 5> weight{0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                         0.2369268850561891};
  Point low = centre, high = centre;
  for (const auto& [path, back] : way) {
    for (int i = 0; i <= 8; ++i) {
      const Point p = path.at(std::lerp(path.from, path.to, i / 8.0));
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double hu = 1e-5 * (high.x - low.x), hv = 1e-5 * (high.y - low.y);
  const auto element = [&](Point p) {
    // Towards the centre, so that nothing is asked beyond the way.
    const double su = p.x > centre.x ? -hu : hu, sv = p.y > centre.y ? -hv : hv;
    const Point3 here = surface.at(p);
    const auto slope = [&](Point by, double h) {
      return (1.0 / (2.0 * h)) * (-3.0 * (here - Point3{}) + 4.0 * (surface.at(p + (by - Point{})) - Point3{}) -
                                  (surface.at(p + 2.0 * (by - Point{})) - Point3{}));
    };
    return geom::length(cross(slope({su, 0.0}, su), slope({0.0, sv}, sv)));
  };
  double sum = 0.0;
  for (const auto& [path, back] : way) {
    const double step = (path.to - path.from) / panels;
    for (int i = 0; i < panels; ++i) {
      for (std::size_t k = 0; k < 5; ++k) {
        const double t = path.from + (i + 0.5 + 0.5 * at[k]) * step, h = 1e-6 * step;
        const Point b = path.at(t);
        const geom::Vector along = (path.at(t + h) - path.at(t - h)) / (2.0 * h);
        const double turn = geom::cross(b - centre, along) * (back ? -1.0 : 1.0);
        if (turn == 0.0) continue;
        double ray = 0.0;
        constexpr int parts = 6;
        for (int j = 0; j < parts; ++j) {
          for (std::size_t l = 0; l < 5; ++l) {
            const double s = (j + 0.5 + 0.5 * at[l]) / parts;
            ray += 0.5 / parts * weight[l] * s * element(geom::interpolate(centre, b, s));
          }
        }
        sum += 0.5 * step * weight[k] * turn * ray;
      }
    }
  }
  return sum;
}

}  // namespace dobra::support
