#include "quebra/surfaces/trimming.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "quebra/surfaces/trim_doubts.h"
#include "shared/geom/polyline.h"
#include "shared/geom/predicates.h"
#include "shared/geom/spatial_index.h"
#include "shared/surf/closest.h"
#include "shared/surf/measure.h"
#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/common_edges.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using surf::Curve;
using surf::mesh::Finding;
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

CrackLineOptions crack_options(const TrimParams& trim) {
  CrackLineOptions options;
  if (trim.role != TrimRole::Crack) return options;
  options.bands = trim.bands;
  options.rosette = trim.rosette;
  options.sectors = trim.sectors;
  return options;
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
  Drawn drawn{trim.role, trim.name, is_closed(trim), {}, crack_options(trim)};
  const double from = curve.low(), to = curve.high();
  drawn.edges.push_back({.curve = std::move(curve), .from = from, .to = to, .name = trim.name});
  const geom::Box& box = surface_.chart();
  for (const Point p : samples(drawn.edges)) {
    const double wide = 1e-9 * box.width(), high = 1e-9 * box.height();
    const bool in_u = surface_.closed_u() || (p.x >= box.low.x - wide && p.x <= box.high.x + wide);
    const bool in_v = surface_.closed_v() || (p.y >= box.low.y - high && p.y <= box.high.y + high);
    if (in_u && in_v) continue;
    const Point low = units_.out(box.low), top = units_.out(box.high);
    Error error =
        refused(fmt::format("it leaves the chart of surface '{}', which goes from u = {:.6g} to {:.6g} and from "
                            "v = {:.6g} to {:.6g}: draw it within, or end it on a side",
                            name_, low.x, top.x, low.y, top.y),
                p);
    error.place->x = error.place->y = error.place->z = std::nullopt;
    return error;
  }
  if (is_loop(trim.role) && !drawn.closed) {
    return refused(fmt::format("its ends do not meet, so it is no {}: let its last point repeat the first, or give it "
                               "role = \"cut\"",
                               trim.role == TrimRole::Hole ? "hole" : "outline"),
                   drawn.edges.back().end());
  }
  if (trim.role == TrimRole::Crack && trim.tip_size > 0.0 && !drawn.closed) {
    points_.push_back({drawn.edges.front().start(), {}, trim.tip_size});
    points_.push_back({drawn.edges.back().end(), {}, trim.tip_size});
  }
  if (is_loop(trim.role)) rings_.push_back({trim.role, trim.name, samples(drawn.edges), {drawn_.size()}});
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
    const auto common = surf::trim::common_edges(surface_, *tool, {.name = trim.name});
    if (!common) {
      Error error = as_written(common.error());
      if (!error.place) error.place = base::Place{};
      error.place->item = fmt::format("surface '{}', trim '{}' by '{}'", name_, trim.name, trim.tool);
      return error;
    }
    for (const surf::trim::CommonEdge& edge : *common) edges.push_back(edge.first);
  }
  if (edges.empty()) {
    return Error{ErrorCode::BadDomain,
                 fmt::format("surface '{}' and {} do not meet, or only touch", name_,
                             trim.kind == TrimKind::Plane ? "the plane" : fmt::format("'{}'", trim.tool))};
  }
  for (ChartEdge& edge : edges) edge.shared.reset();
  return chain(trim, std::move(edges));
}

/// Edges that follow each other become lines, closed ones where they come back.
Result<void> Trimming::chain(const TrimParams& trim, std::vector<ChartEdge> edges) {
  std::vector<std::vector<Point>> ways;
  const std::size_t before = drawn_.size();
  const double near = 1e-9 * std::max(surface_.chart().width(), surface_.chart().height());
  const auto branches = [&](Point p) {
    const auto ends = [&](const ChartEdge& e) {
      return (distance(e.start(), p) <= near ? 1 : 0) + (distance(e.end(), p) <= near ? 1 : 0);
    };
    return std::transform_reduce(edges.begin(), edges.end(), 0, std::plus<>(), ends) > 2;
  };
  for (std::size_t i = 0; i < edges.size();) {
    Drawn drawn{trim.role, trim.name, false, {edges[i++]}, crack_options(trim)};
    while (i < edges.size() && distance(drawn.edges.back().end(), edges[i].start()) <= near &&
           !branches(edges[i].start()) && distance(drawn.edges.back().end(), drawn.edges.front().start()) > near)
      drawn.edges.push_back(edges[i++]);
    drawn.closed = distance(drawn.edges.back().end(), drawn.edges.front().start()) <= near;
    if (is_loop(trim.role)) ways.push_back(samples(drawn.edges));
    drawn_.push_back(std::move(drawn));
  }
  auto rings = rings_of_cut(surface_, trim, ways);
  if (!rings) return as_written(rings.error());
  for (TrimRing& ring : *rings) {
    for (std::size_t& line : ring.lines) line += before;
    rings_.push_back(std::move(ring));
  }
  return {};
}

namespace {

/// The set of a side of the chart on which an edge lies; empty: it lies on none.
std::string side_of(const surf::Surface& surface, const ChartEdge& edge) {
  const geom::Box& box = surface.chart();
  const auto on = [&](auto&& test) {
    return test(edge.start()) && test(edge.end()) && test(edge.at(0.5 * (edge.from + edge.to)));
  };
  if (!surface.closed_u()) {
    if (on([&](Point p) { return p.x == box.low.x; })) return "_left";
    if (on([&](Point p) { return p.x == box.high.x; })) return "_right";
  }
  if (!surface.closed_v()) {
    if (on([&](Point p) { return p.y == box.low.y; })) return "_bottom";
    if (on([&](Point p) { return p.y == box.high.y; })) return "_top";
  }
  return {};
}

/// A point inside a face: beside the middle of a chord of its first loop, so near that no other line is between.
Point point_inside(const TrimmedSurface& face) {
  std::vector<std::vector<Point>> contours;
  for (const ChartLoop& loop : face.loops) contours.push_back(samples(loop.edges));
  const auto within = [&](Point p) {
    bool in = false;
    for (const auto& contour : contours) in ^= inside(contour, p);
    return in;
  };
  const std::vector<Point>& outer = contours.front();
  for (const double part : {0.3, 0.1, 0.01, 1e-3, 1e-4, 1e-5}) {
    for (std::size_t i = 0; i + 1 < outer.size(); i += std::max<std::size_t>(1, outer.size() / 50)) {
      const geom::Vector chord = outer[i + 1] - outer[i];
      const Point p = outer[i] + (0.5 * chord + part * geom::Vector{-chord.y, chord.x});
      if (within(p)) return p;
    }
  }
  return geom::midpoint(outer[0], outer[1]);
}

/// The face at a place. One on a seam, in a pole or on a side is that of its surroundings, if they are of one face.
std::optional<std::size_t> part_at(const surf::trim::Recognised& recognised, Point at) {
  if (const auto face = recognised.pick(at)) return *face;
  const surf::Surface& surface = recognised.faces().front().surface;
  const geom::Box& box = surface.chart();
  constexpr double beside = 1e-3;  // of the chart
  std::optional<std::size_t> found;
  for (const double u : {-1.0, 0.0, 1.0}) {
    for (const double v : {-1.0, 0.0, 1.0}) {
      Point near = at + geom::Vector{beside * u * box.width(), beside * v * box.height()};
      if (surface.closed_u()) near.x = box.low.x + std::fmod(near.x - box.low.x + box.width(), box.width());
      if (surface.closed_v()) near.y = box.low.y + std::fmod(near.y - box.low.y + box.height(), box.height());
      if (!box.contains(near)) continue;
      const auto face = recognised.pick(near);
      if (!face) continue;
      if (found && *found != *face) return std::nullopt;
      found = *face;
    }
  }
  return found;
}

ChartLine::Kind kind_of(TrimRole role) {
  switch (role) {
    case TrimRole::Crack:
      return ChartLine::Kind::Crack;
    case TrimRole::Internal:
      return ChartLine::Kind::Constraint;
    default:
      return ChartLine::Kind::Interface;
  }
}

}  // namespace

std::vector<geom::Vector> Trimming::periods() const {
  std::vector<geom::Vector> all;
  for (const double u : {0.0, -1.0, 1.0}) {
    for (const double v : {0.0, -1.0, 1.0}) {
      if ((u == 0.0 || surface_.closed_u()) && (v == 0.0 || surface_.closed_v()))
        all.push_back({u * surface_.chart().width(), v * surface_.chart().height()});
    }
  }
  return all;
}

/// Sides are known from the arcs; which of them is inside is seen at a place well outside the box of the ring, where
/// there is one; else at the place that is farthest from the ring, where the chords between its samples are as good as
/// itself.
Result<std::vector<std::uint8_t>> Trimming::inside_of(const TrimRing& ring, const surf::trim::Recognised& recognised,
                                                      const std::vector<Point>& inner) const {
  DOBRA_TRY(std::vector<std::uint8_t> sides, recognised.sides_of(ring.lines));
  const std::vector<geom::Vector> by = periods();
  geom::Box box = geom::box_of(ring.places);
  const geom::Vector beside{0.1 * box.width(), 0.1 * box.height()};
  const Point low = box.low - beside, high = box.high + beside;
  box.add(low), box.add(high);
  const auto outside = [&](Point p) {
    return std::none_of(by.begin(), by.end(), [&](geom::Vector period) { return box.contains(p + period); });
  };
  const auto beyond = std::find_if(inner.begin(), inner.end(), outside);
  bool ones = false;  // is the side 1 inside?
  if (beyond != inner.end()) {
    ones = sides[static_cast<std::size_t>(beyond - inner.begin())] == 0;
  } else {
    const geom::Box& chart = surface_.chart();
    const auto part = [&](Point q) { return Point{q.x / chart.width(), q.y / chart.height()}; };
    geom::Polyline way{{}, true};
    for (const Point p : ring.places) way.points.push_back(part(p));
    const auto away = [&](Point p) {
      double least = std::numeric_limits<double>::infinity();
      for (const geom::Vector period : by) least = std::min(least, geom::distance(way, part(p + period)));
      return least;
    };
    std::size_t best = 0;
    double farthest = -1.0;
    for (std::size_t f = 0; f < inner.size(); ++f) {
      if (const double far = away(inner[f]); far > farthest) farthest = far, best = f;
    }
    const bool in = std::any_of(by.begin(), by.end(),
                                [&](geom::Vector period) { return inside(ring.places, inner[best] + period); });
    ones = (sides[best] != 0) == in;
  }
  for (std::uint8_t& side : sides) side = (side != 0) == ones ? 1 : 0;
  return sides;
}

Error Trimming::as_written(Error error) const {
  if (error.place && error.place->u && error.place->v) {
    const Point told = units_.out({*error.place->u, *error.place->v});
    error.place->u = told.x, error.place->v = told.y;
  }
  return error;
}

Result<void> Trimming::keep(const surf::trim::Recognised& recognised, model::SurfaceParts& parts) const {
  const std::size_t count = recognised.faces().size();
  std::vector<std::uint8_t> stays(count, 1), asked(count, 0);
  const bool outlines =
      std::any_of(drawn_.begin(), drawn_.end(), [](const Drawn& d) { return d.role == TrimRole::Outline; });
  std::vector<Point> inner;
  for (std::size_t f = 0; f < count; ++f) {
    if (recognised.faces()[f].loops.empty())
      return refused("what the lines of this surface bound cannot be told: draw them so that none passes its own end",
                     surface_.chart().centre());
    inner.push_back(point_inside(recognised.faces()[f]));
  }
  std::vector<std::uint8_t> outlined(count, outlines ? 0 : 1);
  for (const TrimRing& ring : rings_) {
    const auto inside = inside_of(ring, recognised, inner);
    if (!inside) return as_written(inside.error());
    for (std::size_t f = 0; f < count; ++f) {
      if ((*inside)[f] == 0) continue;
      if (ring.role == TrimRole::Hole) stays[f] = 0;
      if (ring.role == TrimRole::Outline) outlined[f] = 1;
    }
  }
  for (std::size_t f = 0; f < count; ++f) stays[f] = stays[f] != 0 && outlined[f] != 0 ? 1 : 0;
  const std::vector<std::uint8_t> solid = stays;
  bool some_kept = false;
  for (const Picked& part : parts_) {
    const auto face = part_at(recognised, part.at);
    if (!face)
      return refused(
          "the place of a part lies on a line, or so near to it that its side is not known: give one well inside",
          part.at);
    if (part.fate == PartFate::Keep && stays[*face] == 0)
      return refused("the part to keep lies in a hole, or outside the outlines", part.at);
    if (part.fate == PartFate::Keep) asked[*face] = 1, some_kept = true;
    if (part.fate == PartFate::Drop) stays[*face] = 0;
  }
  for (std::size_t f = 0; f < count; ++f) {
    const bool in = stays[f] != 0 && (!some_kept || asked[f] != 0);
    if (in)
      parts.in.push_back(f);
    else if (solid[f] != 0)
      parts.left_out.push_back(f);
  }
  return {};
}

std::vector<ChartLine> Trimming::drawn_lines() const {
  std::vector<ChartLine> lines;
  for (const Drawn& drawn : drawn_) lines.push_back({drawn.edges, kind_of(drawn.role)});
  return lines;
}

std::vector<model::ChosenPart> Trimming::chosen(std::size_t face) const {
  std::vector<model::ChosenPart> all;
  for (const Picked& part : parts_) all.push_back({face, part.at, part.fate == PartFate::Keep});
  return all;
}

Result<void> Trimming::add_crack_lines(std::vector<Drawn>& lines, std::vector<ChartPoint>& tips,
                                       std::vector<Finding>& findings) const {
  std::vector<std::vector<Point>> bounds;
  for (const Drawn& drawn : drawn_) {
    if (drawn.role != TrimRole::Crack && drawn.role != TrimRole::Internal) bounds.push_back(samples(drawn.edges));
  }
  for (const Drawn& drawn : drawn_) {
    if (drawn.round.bands.empty() && !(drawn.round.rosette > 0.0)) continue;
    const DrawnCrack crack{drawn.name, drawn.closed, drawn.edges, samples(drawn.edges)};
    DOBRA_TRY(CrackLines made, crack_lines(surface_, crack, bounds, drawn.round));
    for (const CrackLines::Doubt& doubt : made.doubts) {
      const Error told = refused(doubt.message, doubt.at);
      findings.push_back({doubt.code, doubt.message, *told.place});
    }
    for (CrackLines::Line& line : made.lines)
      lines.push_back({TrimRole::Internal, std::move(line.name), line.closed, std::move(line.edges)});
    tips.insert(tips.end(), made.tips.begin(), made.tips.end());
  }
  return {};
}

Result<TrimmedSurface> Trimming::face(surf::trim::SharedNumbers& numbers, std::vector<surf::mesh::Finding>& findings,
                                      model::SurfaceParts& parts) const {
  std::vector<surf::trim::TrimLine> lines;
  std::vector<Drawn> all = drawn_;
  std::vector<ChartPoint> points = points_;
  DOBRA_TRY_VOID(add_crack_lines(all, points, findings));
  for (const Drawn& drawn : all) {
    const bool bounds = drawn.role == TrimRole::Hole || drawn.role == TrimRole::Outline || drawn.role == TrimRole::Cut;
    lines.push_back({{drawn.edges, kind_of(drawn.role)}, drawn.closed, bounds});
  }
  auto recognised = surf::trim::recognise(surface_, lines, numbers, {.name_sides = false});
  if (!recognised) return as_written(recognised.error());
  for (const surf::trim::Finding& finding : recognised->findings()) {
    const Error told = as_written({ErrorCode::BadDomain, finding.message, finding.place});
    findings.push_back({finding.code, finding.message, *told.place});
  }
  DOBRA_TRY_VOID(keep(*recognised, parts));
  parts.surface = name_;
  parts.recognised = *recognised;
  const std::vector<std::size_t>& wanted = parts.in;
  if (wanted.empty()) return Error{ErrorCode::BadDomain, "trims and parts leave nothing of it"};
  TrimmedSurface face =
      wanted.size() == 1 ? recognised->faces()[wanted[0]] : recognised->united(wanted, surf::trim::CommonLines::Keep);
  face.name = name_;
  for (ChartLoop& loop : face.loops) {
    for (ChartEdge& edge : loop.edges) {
      if (!edge.name.empty()) continue;
      if (const std::string side = side_of(surface_, edge); !side.empty()) edge.name = name_ + side;
    }
  }
  std::vector<DrawnTrim> drawn;
  for (const TrimRing& ring : rings_) drawn.push_back({ring.role, ring.name, true, ring.places});
  for (const Drawn& trim : drawn_) {
    if (!is_loop(trim.role)) drawn.push_back({trim.role, trim.name, trim.closed, samples(trim.edges)});
  }
  for (const Finding& doubt : trim_doubts(surface_, drawn, recognised->faces(), face, recognised->on_cracks(wanted))) {
    const Error told = as_written({ErrorCode::BadDomain, doubt.message, doubt.place});
    findings.push_back({doubt.code, doubt.message, *told.place});
  }
  for (ChartPoint& point : points) {
    point.at = surf::trim::in_period(surface_, point.at);
    const auto at = recognised->pick(point.at);
    if (at && std::find(wanted.begin(), wanted.end(), *at) == wanted.end())
      return refused(fmt::format("point '{}' lies outside what is left of the surface", point.name), point.at);
    face.points.push_back(point);
  }
  add_regions(face);
  return face;
}

/// Parts with names are regions.
void Trimming::add_regions(TrimmedSurface& face) const {
  std::vector<std::string> names;
  for (const Picked& part : parts_) {
    if (part.fate == PartFate::Drop || part.name.empty()) continue;
    auto known = std::find(names.begin(), names.end(), part.name);
    if (known == names.end()) known = names.insert(names.end(), part.name);
    face.regions.push_back({part.at, static_cast<std::int32_t>(known - names.begin()) + 1, part.name});
  }
}

}  // namespace quebra::surfaces
