#include "shared/surf/loft/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/geom/box.h"
#include "shared/geom/polyline.h"
#include "shared/surf/loft/overturned.h"
#include "shared/surf/loft/strips.h"
#include "shared/surf/measure.h"

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

struct GaussPoint {
  double at, weight;  // on 0 .. 1
};
constexpr std::array<GaussPoint, 2> gauss2{{{0.21132486540518713, 0.5}, {0.78867513459481287, 0.5}}};
constexpr std::array<GaussPoint, 5> gauss5{{{0.046910077030668, 0.11846344252809454},
                                            {0.23076534494715845, 0.23931433524968324},
                                            {0.5, 0.28444444444444444},
                                            {0.76923465505284155, 0.23931433524968324},
                                            {0.95308992296933199, 0.11846344252809454}}};

/// Calls f(jet, weight) at the points of the rule, cell after cell.
template <class F>
void over_cells(const Patch& patch, F&& f) {
  std::vector<Point> places;
  std::vector<double> weights;
  std::vector<Jet> jets;
  for (std::size_t i = 1; i < patch.u.size(); ++i) {
    places.clear(), weights.clear();
    const double u = patch.u[i - 1], du = patch.u[i] - u;
    for (std::size_t j = 1; j < patch.v.size(); ++j) {
      const double v = patch.v[j - 1], dv = patch.v[j] - v;
      for (const GaussPoint a : gauss2) {
        for (const GaussPoint b : gauss5) {
          places.push_back({u + a.at * du, v + b.at * dv});
          weights.push_back(a.weight * b.weight * du * dv);
        }
      }
    }
    jets.resize(places.size());
    patch.surface.jets(places, jets);
    for (std::size_t k = 0; k < jets.size(); ++k) f(jets[k], weights[k]);
  }
}

double plan_rate(const Jet& jet) { return jet.u.x * jet.v.y - jet.u.y * jet.v.x; }

/// Patches may have their charts either way round; what counts is what they cover.
struct PlanIntegral {
  double plan = 0.0, volume = 0.0;
};
PlanIntegral plan_integral(const Patch& patch) {
  PlanIntegral sum;
  // From the first point, so that great coordinates cost no digits.
  const double z0 = patch.points.front().z;
  over_cells(patch, [&](const Jet& jet, double weight) {
    sum.plan += weight * plan_rate(jet);
    sum.volume += weight * plan_rate(jet) * (jet.at.z - z0);
  });
  sum.volume += z0 * sum.plan;
  if (sum.plan < 0.0) sum = {-sum.plan, -sum.volume};
  return sum;
}

Vector3 normal_of(const std::vector<Point3>& p, const std::array<std::uint32_t, 3>& t) {
  return geom::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

Dip dip_of(Vector3 normal) {
  if (normal.z < 0.0) normal = -normal;
  const double level = std::hypot(normal.x, normal.y);
  double azimuth = level > 0.0 ? std::atan2(normal.x, normal.y) : 0.0;
  if (azimuth < 0.0) azimuth += base::Angle::from_degrees(360.0).radians();
  return {base::Angle::from_radians(std::atan2(level, normal.z)), base::Angle::from_radians(azimuth)};
}

/// The border on the map, round the chart.
geom::Polyline border(const Patch& patch) {
  geom::Polyline line{{}, true};
  for (const Point3 p : border_of(patch)) line.points.push_back({p.x, p.y});
  return line;
}

bool one_border(const NamedSurface& a, const NamedSurface& b) {
  if (a.patches.size() != b.patches.size()) return false;
  for (std::size_t k = 0; k < a.patches.size(); ++k) {
    const geom::Polyline first = border(a.patches[k]), second = border(b.patches[k]);
    const double same = 1e-6 * a.patches[k].surface.size();
    const auto on = [&](const geom::Polyline& line, const geom::Polyline& other) {
      const std::size_t step = 1 + line.points.size() / 200;
      for (std::size_t i = 0; i < line.points.size(); i += step) {
        if (geom::distance(other, line.points[i]) > same) return false;
      }
      return true;
    };
    if (!on(first, second) || !on(second, first)) return false;
  }
  return true;
}

/// A triangle on the map, anticlockwise, with the plane of its heights.
struct PlanTriangle {
  std::array<Point, 3> at;
  double z0 = 0.0, zx = 0.0, zy = 0.0;  // z0 + zx (x - x0) + zy (y - y0) with x0, y0 = at[0]
  double sign = 1.0;                    // -1: overturned
  geom::Box box;
  [[nodiscard]] double z(Point p) const { return z0 + zx * (p.x - at[0].x) + zy * (p.y - at[0].y); }
};

/// Nothing where it stands upright.
std::optional<PlanTriangle> plan_triangle(Point3 a, Point3 b, Point3 c) {
  const Vector3 normal = geom::cross(b - a, c - a);
  if (std::abs(normal.z) <= 1e-12 * geom::length(normal)) return std::nullopt;
  PlanTriangle triangle;
  triangle.at = {Point{a.x, a.y}, Point{b.x, b.y}, Point{c.x, c.y}};
  for (const Point p : triangle.at) triangle.box.add(p);
  triangle.z0 = a.z;
  triangle.zx = -normal.x / normal.z;
  triangle.zy = -normal.y / normal.z;
  triangle.sign = normal.z < 0.0 ? -1.0 : 1.0;
  if (normal.z < 0.0) std::swap(triangle.at[1], triangle.at[2]);
  return triangle;
}

std::vector<PlanTriangle> plan_triangles(const NamedSurface& surface, const std::vector<StripTriangle>& strips) {
  std::vector<PlanTriangle> made;
  for (const Patch& patch : surface.patches) {
    const double turned = [&] {
      double plan = 0.0;
      for (const auto& t : patch.triangles) plan += normal_of(patch.points, t).z;
      return plan < 0.0 ? -1.0 : 1.0;
    }();
    for (const auto& t : patch.triangles) {
      auto triangle = plan_triangle(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
      if (!triangle) continue;
      triangle->sign *= turned;
      made.push_back(*triangle);
    }
  }
  for (const StripTriangle& t : strips) {
    if (const auto triangle = plan_triangle(t[0], t[1], t[2])) made.push_back(*triangle);
  }
  return made;
}

/// Whether strips cover nothing on the map, as beside vertical faults.
bool upright(const std::vector<StripTriangle>& strips, double size) {
  double plan = 0.0;
  for (const StripTriangle& t : strips) plan += std::abs(geom::cross(t[1] - t[0], t[2] - t[0]).z);
  return plan <= 1e-9 * size * size;
}

using Corners = std::vector<Point>;

/// What of a convex polygon is to the left of a line.
template <class Value>
Corners kept(const Corners& polygon, Value&& value) {
  Corners made;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double a = value(p), b = value(q);
    if (a >= 0.0) made.push_back(p);
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)) made.push_back(geom::interpolate(p, q, a / (a - b)));
  }
  return made;
}

struct Sum {
  double area = 0.0, volume = 0.0;
};
/// Over a convex polygon.
template <class Value>
Sum integral(const Corners& polygon, Value&& value) {
  Sum sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point a = polygon[0], b = polygon[i - 1], c = polygon[i];
    const double area = 0.5 * geom::cross(b - a, c - a);
    sum.area += area;
    sum.volume += area * (value(a) + value(b) + value(c)) / 3.0;
  }
  return sum;
}

/// Of the pairs of triangles of two lattices.
struct Pairs {
  double plan = 0.0, value = 0.0, below = 0.0;
  double deepest = 0.0;  ///< Of the upper below the lower, m,
  Point3 at;             ///< and where, on the upper.
};

/// Adds what is between two triangles.
void add_pair(const PlanTriangle& upper, const PlanTriangle& lower, Pairs& pairs) {
  Corners common(upper.at.begin(), upper.at.end());
  for (std::size_t k = 0; k < 3 && !common.empty(); ++k) {
    const Point a = lower.at[k], b = lower.at[(k + 1) % 3];
    common = kept(common, [&](Point p) { return geom::cross(b - a, p - a); });
  }
  const auto height = [&](Point p) { return upper.z(p) - lower.z(p); };
  const double sign = upper.sign * lower.sign;
  const Sum all = integral(common, height);
  pairs.plan += sign * all.area;
  pairs.value += sign * all.volume;
  bool below = false;
  for (const Point p : common) {
    const double depth = -height(p);
    below = below || depth > 0.0;
    if (depth > pairs.deepest) pairs.deepest = depth, pairs.at = {p.x, p.y, upper.z(p)};
  }
  if (below) pairs.below -= sign * integral(kept(common, [&](Point p) { return -height(p); }), height).volume;
}

/// Pairs of triangles by a lattice of cells over the lower ones.
base::Result<Pairs> pairs_of(const std::vector<PlanTriangle>& upper, const std::vector<PlanTriangle>& lower,
                             const base::Progress& progress) {
  Pairs pairs;
  geom::Box box;
  for (const PlanTriangle& t : lower) box.add(t.box.low), box.add(t.box.high);
  const auto side = static_cast<std::size_t>(std::clamp(std::sqrt(static_cast<double>(lower.size())), 1.0, 1000.0));
  std::vector<std::vector<std::uint32_t>> cells(side * side);
  const auto cell = [&](double at, double low, double width) {
    const double part = width > 0.0 ? (at - low) / width : 0.0;
    return static_cast<std::size_t>(std::clamp(part * static_cast<double>(side), 0.0, static_cast<double>(side - 1)));
  };
  const auto range = [&](const geom::Box& b, auto&& visit) {
    const std::size_t i0 = cell(b.low.x, box.low.x, box.width()), i1 = cell(b.high.x, box.low.x, box.width());
    const std::size_t j0 = cell(b.low.y, box.low.y, box.height()), j1 = cell(b.high.y, box.low.y, box.height());
    for (std::size_t i = i0; i <= i1; ++i) {
      for (std::size_t j = j0; j <= j1; ++j) visit(i * side + j);
    }
  };
  for (std::size_t k = 0; k < lower.size(); ++k)
    range(lower[k].box, [&](std::size_t c) { cells[c].push_back(static_cast<std::uint32_t>(k)); });
  std::vector<std::uint32_t> near;
  for (const PlanTriangle& t : upper) {
    DOBRA_TRY_VOID(progress.check());
    near.clear();
    range(t.box, [&](std::size_t c) { near.insert(near.end(), cells[c].begin(), cells[c].end()); });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::uint32_t k : near) {
      if (t.box.overlaps(lower[k].box)) add_pair(t, lower[k], pairs);
    }
  }
  return pairs;
}

/// Fills in the volume of horizons that end on an overturned limb, where it can be told; the map says nothing of it.
bool over_itself(const NamedSurface& upper, const NamedSurface& lower, bool unfaulted, Volume& volume) {
  const auto end = overturned_end(upper), lower_end = overturned_end(lower);
  if (!end && !lower_end) return false;
  const NamedSurface& of = end ? upper : lower;
  const Point3 at = end ? *end : *lower_end;
  const std::string item = fmt::format("{} '{}'", kind_name(of.kind), of.name);
  const auto closed = unfaulted ? closed_volume(upper, lower) : std::nullopt;
  if (closed) {
    volume.value = *closed;
    volume.plan = std::min(measures(upper).plan, measures(lower).plan);
    volume.findings.push_back(
        {"overturned_end",
         fmt::format("'{}' ends on an overturned limb here: the volume is that of the body which '{}' and '{}' close "
                     "straight from end to end, and areas on the map have overturned parts taken off; whether the two "
                     "cross is not looked for",
                     of.name, upper.name, lower.name),
         {.item = item, .x = at.x, .y = at.y, .z = at.z}});
    return true;
  }
  volume.findings.push_back(
      {"overturned_end",
       fmt::format("'{}' ends on an overturned limb here: what lies over itself counts for nothing, and the volume "
                   "between '{}' and '{}' is off; draw it on to its upright limb, or end it at the hinge",
                   of.name, upper.name, lower.name),
       {.item = item, .x = at.x, .y = at.y, .z = at.z}});
  return false;
}

}  // namespace

std::vector<Dip> dips(const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<Dip> made;
  for (const auto& t : triangles) made.push_back(dip_of(normal_of(points, t)));
  return made;
}

std::vector<Dip> dips(const Patch& patch) { return dips(patch.points, patch.triangles); }

Measures measures(const NamedSurface& surface) {
  Measures sum;
  double dip = 0.0, height = 0.0;
  for (const Patch& patch : surface.patches) {
    sum.plan += plan_integral(patch).plan;
    over_cells(patch, [&](const Jet& jet, double weight) {
      const Vector3 normal = geom::cross(jet.u, jet.v);
      const double area = weight * geom::length(normal);
      sum.area += area;
      height += area * jet.at.z;
      if (area > 0.0) dip += area * dip_of(normal).dip.radians();
    });
  }
  if (sum.area > 0.0) {
    sum.dip_mean = base::Angle::from_radians(dip / sum.area);
    sum.mean_z = height / sum.area;
  }
  return sum;
}

base::Result<Volume> volume_between(const NamedSurface& upper, const NamedSurface& lower,
                                    const std::vector<NamedSurface>& surfaces, const base::Progress& progress) {
  Strips strips = strips_between(upper, lower, surfaces);
  Volume volume;
  volume.unsure = strips.unsure;
  volume.findings = std::move(strips.findings);
  if (over_itself(upper, lower, strips.upper.empty() && strips.lower.empty(), volume)) return volume;
  const double size = upper.patches.front().surface.size();
  DOBRA_TRY(const Pairs pairs,
            pairs_of(plan_triangles(upper, strips.upper), plan_triangles(lower, strips.lower), progress));
  volume.value = pairs.value;
  volume.plan = pairs.plan;
  constexpr double rounded = 1e-9;
  if (pairs.deepest > rounded * size && pairs.below > rounded * (std::abs(pairs.value) + pairs.below)) {
    volume.below = pairs.below;
    const std::string item = fmt::format("{} '{}'", kind_name(upper.kind), upper.name);
    volume.findings.push_back(
        {"cross",
         fmt::format("'{}' and '{}' cross: between them are {:.6g} m3 where '{}' is the upper one, and {:.6g} m3 where "
                     "it is the lower one, by {:.6g} m at most; the volume is the difference",
                     upper.name, lower.name, pairs.value + pairs.below, upper.name, pairs.below, pairs.deepest),
         {.item = item, .x = pairs.at.x, .y = pairs.at.y, .z = pairs.at.z}});
  }
  if (!upright(strips.upper, size) || !upright(strips.lower, size) || !one_border(upper, lower)) return volume;
  PlanIntegral top, bottom;
  for (const Patch& patch : upper.patches) {
    const PlanIntegral part = plan_integral(patch);
    top.plan += part.plan, top.volume += part.volume;
  }
  for (const Patch& patch : lower.patches) bottom.volume += plan_integral(patch).volume;
  volume.value = top.volume - bottom.volume;
  volume.plan = top.plan;
  volume.exact = true;
  return volume;
}

}  // namespace dobra::surf::loft
