#include "quebra/surfaces/trimming.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/polyline.h"
#include "shared/geom/predicates.h"
#include "shared/geom/spatial_index.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"
#include "shared/surf/trim/common_edges.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using surf::Curve;
using surf::trim::ChartEdge;
using surf::trim::ChartLine;
using surf::trim::ChartLoop;
using surf::trim::ChartPoint;
using surf::trim::TrimmedSurface;

namespace {

constexpr int samples_a_piece = 64;  // of a curve between its breaks, to see where it runs

std::vector<Point> samples(const ChartEdge& edge) {
  std::vector<double> marks{edge.from};
  std::vector<double> inside;
  for (const double t : edge.curve.breaks()) {
    if (t > std::min(edge.from, edge.to) && t < std::max(edge.from, edge.to)) inside.push_back(t);
  }
  if (edge.to < edge.from) std::reverse(inside.begin(), inside.end());
  marks.insert(marks.end(), inside.begin(), inside.end());
  marks.push_back(edge.to);
  std::vector<Point> points{edge.start()};
  for (std::size_t i = 1; i < marks.size(); ++i) {
    for (int k = 1; k <= samples_a_piece; ++k) {
      const double part = static_cast<double>(k) / samples_a_piece;
      points.push_back(k == samples_a_piece ? edge.at(marks[i])
                                            : edge.at((1.0 - part) * marks[i - 1] + part * marks[i]));
    }
  }
  return points;
}

std::vector<Point> samples(const std::vector<ChartEdge>& edges) {
  std::vector<Point> points;
  for (const ChartEdge& edge : edges) {
    for (const Point p : samples(edge)) {
      if (points.empty() || points.back() != p) points.push_back(p);
    }
  }
  return points;
}

ChartEdge side(const std::string& name, Point from, Point to) {
  auto line = Curve::line({from.x, from.y, 0.0}, {to.x, to.y, 0.0});
  return {.curve = *std::move(line), .name = name};
}

/// The sides of the chart, anticlockwise from the bottom.
ChartLoop whole_chart(const surf::Surface& surface, const std::string& name) {
  const geom::Box& box = surface.chart();
  const Point a = box.low, b{box.high.x, box.low.y}, c = box.high, d{box.low.x, box.high.y};
  ChartLoop loop{{side(name + "_bottom", a, b), side(name + "_right", b, c), side(name + "_top", c, d),
                  side(name + "_left", d, a)}};
  return loop;
}

ChartLoop turned(const std::vector<ChartEdge>& edges) {
  ChartLoop loop;
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge) {
    loop.edges.push_back(*edge);
    std::swap(loop.edges.back().from, loop.edges.back().to);
    loop.edges.back().against = !loop.edges.back().against;
  }
  return loop;
}

bool inside(const std::vector<Point>& contour, Point p) {
  bool in = false;
  for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
    const Point a = contour[i], b = contour[j];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const Point low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
    in ^= geom::orient2d(low, high, p) == geom::Sign::Positive;
  }
  return in;
}

}  // namespace

Trimming::Trimming(surf::Surface surface, std::string name, ChartUnits units)
    : surface_(std::move(surface)), name_(std::move(name)), units_(units) {}

Error Trimming::refused(const std::string& message, Point uv) const {
  const Point3 at = surface_.at(uv);
  const Point told = units_.out(uv);
  return {ErrorCode::BadDomain, message, base::Place{.x = at.x, .y = at.y, .z = at.z, .u = told.x, .v = told.y}};
}

Result<Point> Trimming::place_of(const std::optional<Point>& at, const std::optional<Point3>& place) const {
  if (at.has_value() == place.has_value())
    return Error{ErrorCode::BadValue, "give one place: `at` in the chart, or `place` in space"};
  if (!at) return surf::closest_of_all(surface_, *place).uv;
  const Point uv = units_.in(*at);
  const geom::Box& box = surface_.chart();
  if (uv.x < box.low.x || uv.x > box.high.x || uv.y < box.low.y || uv.y > box.high.y) {
    const Point low = units_.out(box.low), high = units_.out(box.high);
    return Error{
        ErrorCode::BadDomain,
        fmt::format("`at` is outside the chart of surface '{}', which goes from u = {:.6g} to {:.6g} and from v "
                    "= {:.6g} to {:.6g}",
                    name_, low.x, high.x, low.y, high.y),
        base::Place{.u = at->x, .v = at->y}};
  }
  return uv;
}

Result<void> Trimming::add(const PartParams& part) {
  DOBRA_TRY(const Point at, place_of(part.at, part.place));
  parts_.push_back({part.fate, part.name, at});
  return {};
}

Result<void> Trimming::add(const SurfacePointParams& point) {
  DOBRA_TRY(const Point at, place_of(point.at, point.place));
  points_.push_back({at, point.name, point.size > 0.0 ? std::optional(point.size) : std::nullopt});
  return {};
}

Result<void> Trimming::add(const TrimParams& trim, const std::optional<surf::Surface>& tool) {
  if (trim.kind == TrimKind::Surface || trim.kind == TrimKind::Plane) return add_cut(trim, tool);
  DOBRA_TRY(Curve curve, make_trim_curve(trim, units_));
  Drawn drawn{trim.role, trim.name, is_closed(trim), {}};
  const double from = curve.low(), to = curve.high();
  drawn.edges.push_back({.curve = std::move(curve), .from = from, .to = to, .name = trim.name});
  const geom::Box& box = surface_.chart();
  for (const Point p : samples(drawn.edges)) {
    const double wide = 1e-9 * box.width(), high = 1e-9 * box.height();
    if (p.x >= box.low.x - wide && p.x <= box.high.x + wide && p.y >= box.low.y - high && p.y <= box.high.y + high)
      continue;
    const Point low = units_.out(box.low), top = units_.out(box.high);
    Error error =
        refused(fmt::format("it leaves the chart of surface '{}', which goes from u = {:.6g} to {:.6g} and from "
                            "v = {:.6g} to {:.6g}",
                            name_, low.x, top.x, low.y, top.y),
                p);
    error.place->x = error.place->y = error.place->z = std::nullopt;
    return error;
  }
  if ((trim.role == TrimRole::Hole || trim.role == TrimRole::Outline) && !drawn.closed) {
    return refused(fmt::format("its ends do not meet, so it is no {}: let its last point repeat the first, or give it "
                               "role = \"cut\"",
                               trim.role == TrimRole::Hole ? "hole" : "outline"),
                   drawn.edges.back().end());
  }
  if (trim.role == TrimRole::Crack && trim.tip_size > 0.0 && !drawn.closed) {
    points_.push_back({drawn.edges.front().start(), {}, trim.tip_size});
    points_.push_back({drawn.edges.back().end(), {}, trim.tip_size});
  }
  drawn_.push_back(std::move(drawn));
  return {};
}

Result<void> Trimming::add_cut(const TrimParams& trim, const std::optional<surf::Surface>& tool) {
  std::vector<ChartEdge> edges;
  if (trim.kind == TrimKind::Plane) {
    if (!trim.at || !trim.normal) return lacking("a plane needs `at` and `normal`");
    DOBRA_TRY(edges, surf::trim::plane_edges(surface_, *trim.at, {trim.normal->x, trim.normal->y, trim.normal->z},
                                             {.name = trim.name}));
  } else {
    if (!tool) return lacking("`tool` is needed: the surface that cuts");
    DOBRA_TRY(const auto common, surf::trim::common_edges(surface_, *tool, {.name = trim.name}));
    for (const surf::trim::CommonEdge& edge : common) edges.push_back(edge.first);
  }
  if (edges.empty()) {
    return Error{ErrorCode::BadDomain,
                 fmt::format("surface '{}' and {} do not meet, or only touch", name_,
                             trim.kind == TrimKind::Plane ? "the plane" : fmt::format("'{}'", trim.tool))};
  }
  for (ChartEdge& edge : edges) edge.shared.reset();
  chain(trim, std::move(edges));
  return {};
}

/// Edges that follow each other become lines, closed ones where they come back.
void Trimming::chain(const TrimParams& trim, std::vector<ChartEdge> edges) {
  const double near = 1e-9 * std::max(surface_.chart().width(), surface_.chart().height());
  for (std::size_t i = 0; i < edges.size();) {
    Drawn drawn{trim.role, trim.name, false, {edges[i++]}};
    while (i < edges.size() && distance(drawn.edges.back().end(), edges[i].start()) <= near &&
           distance(drawn.edges.back().end(), drawn.edges.front().start()) > near)
      drawn.edges.push_back(edges[i++]);
    drawn.closed = distance(drawn.edges.back().end(), drawn.edges.front().start()) <= near;
    drawn_.push_back(std::move(drawn));
  }
}

Result<std::vector<TrimmedSurface>> Trimming::faces(std::vector<surf::mesh::Finding>&) const {
  struct Part {
    std::vector<Point> contour;
    TrimmedSurface face;
  };
  std::vector<Part> parts;
  for (const Drawn& drawn : drawn_) {
    if (drawn.role != TrimRole::Outline) continue;
    std::vector<Point> contour = samples(drawn.edges);
    const bool anticlockwise = signed_area(geom::Polyline{contour, true}) > 0.0;
    parts.push_back({std::move(contour),
                     {.surface = surface_,
                      .loops = {anticlockwise ? ChartLoop{drawn.edges} : turned(drawn.edges)},
                      .name = name_}});
  }
  if (parts.empty()) {
    const ChartLoop whole = whole_chart(surface_, name_);
    parts.push_back({samples(whole.edges), {.surface = surface_, .loops = {whole}, .name = name_}});
  }
  const auto part_of = [&](Point p) {
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& one) { return inside(one.contour, p); });
    return part == parts.end() ? nullptr : &*part;
  };
  for (const Drawn& drawn : drawn_) {
    if (drawn.role == TrimRole::Outline) continue;
    const std::vector<Point> line = samples(drawn.edges);
    Part* part = part_of(line[line.size() / 2]);
    if (part == nullptr)
      return refused(fmt::format("'{}' lies outside what is left of the surface", drawn.name), line[line.size() / 2]);
    if (drawn.role == TrimRole::Hole) {
      const bool anticlockwise = signed_area(geom::Polyline{line, true}) > 0.0;
      part->face.loops.push_back(anticlockwise ? turned(drawn.edges) : ChartLoop{drawn.edges});
    } else {
      const auto kind = drawn.role == TrimRole::Crack       ? ChartLine::Kind::Crack
                        : drawn.role == TrimRole::Interface ? ChartLine::Kind::Interface
                                                            : ChartLine::Kind::Constraint;
      part->face.lines.push_back({drawn.edges, kind});
    }
  }
  for (const ChartPoint& point : points_) {
    Part* part = part_of(point.at);
    if (part == nullptr && parts.size() == 1) part = &parts[0];  // it may be on a border
    if (part == nullptr)
      return refused(fmt::format("point '{}' lies outside what is left of the surface", point.name), point.at);
    part->face.points.push_back(point);
  }
  std::vector<TrimmedSurface> made;
  for (Part& part : parts) made.push_back(std::move(part.face));
  return made;
}

}  // namespace quebra::surfaces
