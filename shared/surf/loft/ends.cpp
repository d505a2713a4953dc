// 1. For each row of the lattice: how far the fault is along the direction in which the row ends.
// 2. Less the mean of that on the lines before and behind it: then lines stay.
// 3. The surface with both borders moved so, linear between the rows.
#include "shared/surf/loft/ends.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dobra::surf::loft {

using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

/// A surface plus (1 - u) low(v) + u high(v), both linear between rows of v.
struct LedShape : Surface::Shape {
  Surface base;
  std::vector<double> v;
  std::vector<Vector3> low, high;  ///< One for each of v.
  explicit LedShape(Surface of) : base(std::move(of)) {}

  [[nodiscard]] std::size_t piece(double at) const {
    const auto after = std::upper_bound(v.begin() + 1, v.end() - 1, at);
    return static_cast<std::size_t>(after - v.begin()) - 1;
  }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    base.jets(uv, jets);
    for (std::size_t i = 0; i < uv.size(); ++i) {
      const std::size_t k = piece(uv[i].y);
      const double step = v[k + 1] - v[k], t = (uv[i].y - v[k]) / step, u = uv[i].x;
      const auto at = [&](const std::vector<Vector3>& by) { return (1.0 - t) * by[k] + t * by[k + 1]; };
      const auto rate = [&](const std::vector<Vector3>& by) { return (by[k + 1] - by[k]) / step; };
      jets[i].at = jets[i].at + (1.0 - u) * at(low) + u * at(high);
      jets[i].u = jets[i].u + (at(high) - at(low));
      jets[i].v = jets[i].v + (1.0 - u) * rate(low) + u * rate(high);
      jets[i].uv = jets[i].uv + (rate(high) - rate(low));
    }
  }
  [[nodiscard]] Bend bend(const geom::Box& part) const override {
    Bend bend = base.bend(part);
    double most = 0.0;
    for (std::size_t k = 0; k + 1 < v.size(); ++k)
      most =
          std::max(most, (geom::length(high[k + 1] - high[k]) + geom::length(low[k + 1] - low[k])) / (v[k + 1] - v[k]));
    bend.uv += most;
    return bend;
  }
};

/// Where a line meets a triangle, as a length of `way`; the line may pass it beside by a part of its size, as rounding
/// has it at sides that triangles share.
std::optional<double> meets(Point3 from, Vector3 way, Point3 a, Point3 b, Point3 c) {
  constexpr double beside = 1e-9;
  const Vector3 ab = b - a, ac = c - a, across = geom::cross(way, ac);
  const double volume = geom::dot(ab, across);
  if (volume == 0.0) return std::nullopt;
  const Vector3 off = from - a;
  const double s = geom::dot(off, across) / volume;
  const Vector3 turned = geom::cross(off, ab);
  const double t = geom::dot(way, turned) / volume;
  if (s < -beside || t < -beside || s + t > 1.0 + beside) return std::nullopt;
  return geom::dot(ac, turned) / volume;
}

/// By how much the rows of one border are moved; none where it stays.
std::vector<Vector3> moves_of(const Patch& patch, const std::vector<double>& lines_v, const NamedSurface& fault,
                              bool high, double most) {
  std::vector<double> way_to;
  std::vector<Vector3> ways;
  for (const double v : patch.v) {
    const Jet jet = patch.surface.jet({high ? 1.0 : 0.0, v});
    ways.push_back(geom::normalised(jet.u));
    const auto at = meeting_along(fault, jet.at, ways.back(), most);
    if (!at) return {};
    way_to.push_back(*at);
  }
  std::vector<Vector3> moves(patch.v.size());
  std::size_t line = 0, before = 0, behind = 0;
  for (std::size_t j = 0; j < patch.v.size(); ++j) {
    if (patch.v[j] == lines_v[line]) {
      before = j;
      if (line + 1 < lines_v.size()) ++line;
      behind = static_cast<std::size_t>(std::find(patch.v.begin(), patch.v.end(), lines_v[line]) - patch.v.begin());
      continue;
    }
    const double t = (patch.v[j] - patch.v[before]) / (patch.v[behind] - patch.v[before]);
    moves[j] = (way_to[j] - ((1.0 - t) * way_to[before] + t * way_to[behind])) * ways[j];
  }
  return moves;
}

}  // namespace

std::optional<double> meeting_along(const NamedSurface& surface, Point3 from, Vector3 way, double most) {
  std::optional<double> nearest;
  for (const Patch& patch : surface.patches) {
    for (const auto& t : patch.triangles) {
      const auto at = meets(from, way, patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]);
      if (at && std::abs(*at) <= most && (!nearest || std::abs(*at) < std::abs(*nearest))) nearest = at;
    }
  }
  return nearest;
}

void lead_to_faults(NamedSurface& horizon, const std::vector<std::vector<double>>& lines_v,
                    const std::vector<NamedSurface>& faults, double most, std::vector<Finding>& findings) {
  for (std::size_t p = 0; p < horizon.patches.size(); ++p) {
    Patch& patch = horizon.patches[p];
    auto shape = std::make_shared<LedShape>(patch.surface);
    shape->v = patch.v;
    shape->low.resize(patch.v.size());
    shape->high.resize(patch.v.size());
    bool moved = false;
    for (const bool high : {false, true}) {
      const std::string& name = high ? patch.high_fault : patch.low_fault;
      const auto fault =
          std::find_if(faults.begin(), faults.end(), [&](const NamedSurface& f) { return f.name == name; });
      if (name.empty() || fault == faults.end()) continue;
      std::vector<Vector3> moves = moves_of(patch, lines_v[p], *fault, high, most);
      if (moves.empty()) {
        const Point3 end = patch.surface.at({high ? 1.0 : 0.0, 0.5});
        findings.push_back(
            {"off_fault",
             fmt::format("horizon '{}' is not led to fault '{}' between the sections: the surface of the "
                         "fault is not near all of its border",
                         horizon.name, name),
             {.item = fmt::format("horizon '{}'", horizon.name), .x = end.x, .y = end.y, .z = end.z}});
        continue;
      }
      (high ? shape->high : shape->low) = std::move(moves);
      moved = true;
    }
    if (!moved) continue;
    const Breaks breaks{patch.u, patch.v};
    const auto led = Surface::of(shape, patch.surface.chart(), breaks);
    DOBRA_CHECK(led);
    patch.surface = *led;
    for (std::uint32_t i = 0; i < patch.points.size(); ++i) patch.points[i] = patch.surface.at(patch.place(i));
  }
}

}  // namespace dobra::surf::loft
