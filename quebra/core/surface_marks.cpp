#include "quebra/core/surface_marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "quebra/core/layers.h"
#include "shared/base/text.h"
#include "shared/mesh/delaunay/delaunay.h"

namespace quebra::core {

using namespace dobra;
using base::translated;
using geom::Point;
using geom::Point3;

namespace {

constexpr double rounding = 1e-3;  ///< Of the way between two lines: which triangles they may cross.
constexpr scene::Color control_color{216, 92, 0};

/// The pieces of one line of constant u or v in triangles, joined where they meet on the side of a triangle.
class Contour {
 public:
  using Side = std::array<std::uint32_t, 2>;
  struct End {
    Side side;
    Point3 at;
    Point chart;
  };
  void add(const End& a, const End& b) {
    const std::size_t piece = pieces_.size();
    pieces_.push_back({a, b});
    at_[a.side].push_back(piece), at_[b.side].push_back(piece);
  }
  [[nodiscard]] std::vector<Isocurve> lines(std::size_t face, std::uint32_t item) {
    std::vector<Isocurve> all;
    std::vector<std::uint8_t> used(pieces_.size(), 0);
    const auto run = [&](std::size_t piece, std::size_t from) {
      Isocurve line{face, item, {}, {}};
      const auto put = [&](const End& end) { line.line.push_back(end.at), line.chart.push_back(end.chart); };
      put(pieces_[piece][from]);
      while (piece < pieces_.size()) {
        used[piece] = 1;
        const End& end = pieces_[piece][1 - from];
        put(end);
        piece = pieces_.size();
        for (const std::size_t other : at_[end.side]) {
          if (used[other] != 0) continue;
          piece = other, from = pieces_[other][0].side == end.side ? 0 : 1;
        }
      }
      all.push_back(std::move(line));
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {  // ends first: what is left then goes round
      for (const std::size_t end : {0U, 1U}) {
        if (used[i] == 0 && at_[pieces_[i][end].side].size() == 1) run(i, end);
      }
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (used[i] == 0) run(i, 0);
    }
    return all;
  }

 private:
  std::vector<std::array<End, 2>> pieces_;
  std::map<Side, std::vector<std::size_t>> at_;
};

double coordinate(Point uv, bool along_u) { return along_u ? uv.x : uv.y; }

struct Range {
  double low, width;
};
Range range_of(const surf::Surface& surface, bool along_u) {
  const geom::Box& box = surface.chart();
  return along_u ? Range{box.low.x, box.width()} : Range{box.low.y, box.height()};
}

/// From the least to the greatest u or v of a triangle.
std::pair<double, double> span(const std::array<Point, 3>& places, bool along_u) {
  const double a = coordinate(places[0], along_u), b = coordinate(places[1], along_u),
               c = coordinate(places[2], along_u);
  return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Where a line of the chart crosses triangle `t`, if it does. A corner on the line counts as above it.
void cross(const surf::mesh::SurfaceMesh& mesh, std::size_t t, bool along_u, double value, Contour& contour) {
  std::vector<Contour::End> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const Point a = mesh.places[t][k], b = mesh.places[t][l];
    const double from = coordinate(a, along_u) - value, to = coordinate(b, along_u) - value;
    if ((from >= 0.0) == (to >= 0.0)) continue;
    const auto node = [&](std::size_t corner) { return static_cast<std::uint32_t>(mesh.triangles[t][corner].index()); };
    const double part = from / (from - to);
    const Point3 p = mesh.point(mesh.triangles[t][k]), q = mesh.point(mesh.triangles[t][l]);
    ends.push_back({{std::min(node(k), node(l)), std::max(node(k), node(l))}, p + part * (q - p), a + part * (b - a)});
  }
  if (ends.size() == 2) contour.add(ends[0], ends[1]);
}

constexpr int samples_an_area_edge = 32;

std::vector<Point> drawn(const surf::trim::ChartLoop& loop, const DrawnChart& chart) {
  std::vector<Point> points;
  for (const surf::trim::ChartEdge& edge : loop.edges) {
    for (int i = 0; i < samples_an_area_edge; ++i) {
      const double part = static_cast<double>(i) / samples_an_area_edge;
      points.push_back(chart.at(edge.at(edge.from + part * (edge.to - edge.from))));
    }
  }
  return points;
}

bool encloses(const std::vector<std::vector<Point>>& contours, Point p) {
  bool in = false;
  for (const std::vector<Point>& contour : contours) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      const Point a = contour[i], b = contour[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
  }
  return in;
}

/// Its points on the surface, with the corners of a grid inside, and triangles between them.
std::optional<mesh::TriangleMesh> triangulated(const std::vector<std::vector<Point>>& contours) {
  constexpr int cells = 24;
  mesh::delaunay::MeshInput input;
  geom::Box box;
  for (const std::vector<Point>& contour : contours) {
    mesh::delaunay::add_chain(input, contour, mesh::delaunay::Closure::Closed, {"loop"});
    for (const Point p : contour) box.add(p);
  }
  for (int i = 1; i < cells; ++i) {
    for (int j = 1; j < cells; ++j) {
      const Point p{box.low.x + box.width() * i / cells, box.low.y + box.height() * j / cells};
      if (encloses(contours, p)) input.points.push_back(p);
    }
  }
  auto made = mesh::delaunay::constrained_delaunay(input, mesh::delaunay::Outside::Remove);
  if (!made) return std::nullopt;
  return std::move(made->mesh);
}

}  // namespace

std::vector<Isocurve> isocurves(const surf::mesh::SurfaceMesh& mesh,
                                const std::vector<surf::trim::TrimmedSurface>& faces, int each_way) {
  const auto lines = static_cast<std::size_t>(each_way);
  std::vector<Contour> contours(2 * lines * faces.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const surf::Surface& surface = faces[mesh.faces[t]].surface;
    for (const bool along_u : {true, false}) {
      const Range chart = range_of(surface, along_u);
      const double step = chart.width / (each_way + 1);
      const bool closed = along_u ? surface.closed_u() : surface.closed_v();
      const std::size_t first = lines * (2 * mesh.faces[t] + (along_u ? 0 : 1));
      for (const double turn : {0.0, -chart.width, chart.width}) {
        if (turn != 0.0 && !closed) continue;
        const auto [low, high] = span(mesh.places[t], along_u);
        const double begin = std::clamp(std::ceil((low - chart.low - turn) / step - rounding), 1.0, each_way + 1.0);
        const double end = std::clamp(std::floor((high - chart.low - turn) / step + rounding), 0.0, 1.0 * each_way);
        for (double k = begin; k <= end; k += 1.0)
          cross(mesh, t, along_u, chart.low + turn + step * k, contours[first + static_cast<std::size_t>(k) - 1]);
      }
    }
  }
  std::vector<Isocurve> all;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (Isocurve& line : contours[i].lines(i / (2 * lines), static_cast<std::uint32_t>(i)))
      all.push_back(std::move(line));
  }
  return all;
}

std::vector<std::vector<Point3>> normals(const surf::mesh::SurfaceMesh& mesh, std::size_t most) {
  const std::size_t count = mesh.triangles.size();
  if (count == 0) return {};
  double sides = 0.0;
  for (const auto& corners : mesh.triangles) sides += distance(mesh.point(corners[0]), mesh.point(corners[1]));
  const std::size_t shown = std::min(count, most);
  std::vector<std::vector<Point3>> lines;
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& corners = mesh.triangles[i * count / shown];
    const Point3 a = mesh.point(corners[0]), b = mesh.point(corners[1]), c = mesh.point(corners[2]);
    const geom::Vector3 normal = geom::cross(b - a, c - a);
    const double size = length(normal);
    if (!(size > 0.0)) continue;
    const Point3 middle = a + (1.0 / 3.0) * ((b - a) + (c - a));
    lines.push_back({middle, middle + (sides / static_cast<double>(count) / size) * normal});
  }
  return lines;
}

scene::Region region_of(const std::vector<surf::trim::ChartLoop>& loops, const DrawnChart& chart) {
  scene::Region region;
  for (const surf::trim::ChartLoop& loop : loops) region.contours.push_back({drawn(loop, chart), true});
  return region;
}

scene::space::Surface area_of(const surf::Surface& surface, const std::vector<surf::trim::ChartLoop>& loops,
                              std::uint32_t item) {
  const DrawnChart chart(surface);
  std::vector<std::vector<Point>> contours;
  for (const surf::trim::ChartLoop& loop : loops) contours.push_back(drawn(loop, chart));
  scene::space::Surface area;
  const std::optional<mesh::TriangleMesh> flat = contours.empty() ? std::nullopt : triangulated(contours);
  if (!flat) return area;
  for (const Point p : flat->points) {
    area.chart.push_back(chart.chart(p));
    area.points.push_back(surface.at(area.chart.back()));
  }
  for (const auto& corners : flat->triangles) {
    area.triangles.push_back({static_cast<std::uint32_t>(corners[0].index()),
                              static_cast<std::uint32_t>(corners[1].index()),
                              static_cast<std::uint32_t>(corners[2].index())});
    area.ids.push_back(item);
  }
  return area;
}

scene::space::Surface area_of_parts(const surf::Surface& surface, const model::SurfaceParts* parts,
                                    std::uint32_t item) {
  constexpr std::uint32_t cells = 96;
  const geom::Box& box = surface.chart();
  const auto place = [&](double i, double j) {
    return Point{std::lerp(box.low.x, box.high.x, i / cells), std::lerp(box.low.y, box.high.y, j / cells)};
  };
  std::vector<Point> chart;
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t i = 0; i <= cells; ++i) {
    for (std::uint32_t j = 0; j <= cells; ++j) {
      chart.push_back(place(i, j));
      points.push_back(surface.at(chart.back()));
    }
  }
  for (std::uint32_t i = 0; i < cells; ++i) {
    for (std::uint32_t j = 0; j < cells; ++j) {
      if (parts != nullptr) {
        const auto part = parts->recognised->pick(place(i + 0.5, j + 0.5));
        if (!part || std::find(parts->in.begin(), parts->in.end(), *part) == parts->in.end()) continue;
      }
      const std::uint32_t a = i * (cells + 1) + j, b = a + cells + 1;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
  }
  scene::space::Surface area;
  area.ids = std::vector<std::uint32_t>(triangles.size(), item);
  area.points = std::move(points), area.chart = std::move(chart), area.triangles = std::move(triangles);
  return area;
}

void add_controls(const model::SurfaceSet& set, std::vector<scene::space::Layer>& layers) {
  if (set.controls.empty()) return;
  std::vector<std::vector<Point3>> lines;
  for (const std::vector<std::size_t>& numbers : set.control_lines) {
    lines.emplace_back();
    for (const std::size_t i : numbers) lines.back().push_back(set.controls[i].at);
  }
  scene::space::Lines net;
  net.lines = std::move(lines);
  scene::space::Markers points;
  for (const model::ControlPoint& control : set.controls) points.points.push_back(control.at);
  layers.push_back({"control_lines",
                    translated("Control polygons"),
                    {.line = control_color, .line_width = 0.8, .dash = scene::Dash::Dashed},
                    std::move(net),
                    false,
                    scene::InLegend::Yes,
                    {}});
  layers.push_back({controls_layer,
                    translated("Control points"),
                    {.line = control_color, .marker_size = 7.0},
                    std::move(points),
                    false,
                    scene::InLegend::Yes,
                    {}});
}

}  // namespace quebra::core
