// What a mesh leaves out of its surfaces.
#include "quebra/surfaces/mesh_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shared/surf/details.h"
#include "shared/surf/measure.h"
#include "shared/surf/mesh/division.h"

namespace quebra::surfaces {

using namespace dobra;
using geom::Box;
using geom::Point;
using geom::Vector3;

namespace {

/// The triangles of a face by the cells of a net over its chart.
class TrianglesInChart {
 public:
  TrianglesInChart(const surf::mesh::SurfaceMesh& mesh, std::size_t face) : mesh_(mesh) {
    std::vector<std::size_t> own;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.faces[t] != face) continue;
      own.push_back(t);
      box_.add(geom::box_of(mesh.places[t]));
    }
    side_ = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(own.size()))), std::size_t{1},
                       std::size_t{512});
    cells_.resize(side_ * side_);
    for (const std::size_t t : own) {
      const Box part = geom::box_of(mesh.places[t]);
      for (std::size_t i = column(part.low.x); i <= column(part.high.x); ++i) {
        for (std::size_t j = row(part.low.y); j <= row(part.high.y); ++j) cells_[i * side_ + j].push_back(t);
      }
    }
  }
  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] std::optional<std::size_t> at(Point uv) const {
    if (!box_.contains(uv)) return std::nullopt;
    for (const std::size_t t : cells_[column(uv.x) * side_ + row(uv.y)]) {
      const auto& [a, b, c] = mesh_.places[t];
      const double p = cross(b - a, uv - a), q = cross(c - b, uv - b), r = cross(a - c, uv - c);
      if ((p >= 0.0 && q >= 0.0 && r >= 0.0) || (p <= 0.0 && q <= 0.0 && r <= 0.0)) return t;
    }
    return std::nullopt;
  }
  /// The unit normal of a triangle, to the side of Su x Sv; nothing where it has no area.
  [[nodiscard]] std::optional<Vector3> normal(std::size_t t) const {
    const auto& corners = mesh_.triangles[t];
    const geom::Point3 a = mesh_.point(corners[0]);
    const Vector3 area = cross(mesh_.point(corners[1]) - a, mesh_.point(corners[2]) - a);
    const double length = geom::length(area);
    if (!(length > 0.0)) return std::nullopt;
    const auto& [p, q, r] = mesh_.places[t];
    return (cross(q - p, r - p) < 0.0 ? -1.0 : 1.0) / length * area;
  }

 private:
  [[nodiscard]] std::size_t cell(double at, double low, double size) const {
    if (!(size > 0.0)) return 0;
    const double part = std::clamp((at - low) / size, 0.0, 1.0) * static_cast<double>(side_);
    return std::min(static_cast<std::size_t>(part), side_ - 1);
  }
  [[nodiscard]] std::size_t column(double u) const { return cell(u, box_.low.x, box_.width()); }
  [[nodiscard]] std::size_t row(double v) const { return cell(v, box_.low.y, box_.height()); }

  const surf::mesh::SurfaceMesh& mesh_;
  Box box_;
  std::size_t side_ = 1;
  std::vector<std::vector<std::size_t>> cells_;
};

struct TurnedAway {
  double angle = 0.0;
  Point at;
};

/// Where the surface turns most from the triangles over it, at 3 x 3 places of each detail.
TurnedAway most_turned(const surf::Surface& surface, const TrianglesInChart& triangles, std::span<const Box> details) {
  TurnedAway most;
  for (const Box& part : details) {
    for (int i = 0; i < 9; ++i) {
      const Point uv{std::lerp(part.low.x, part.high.x, 0.5 * (i / 3)),
                     std::lerp(part.low.y, part.high.y, 0.5 * (i % 3))};
      const auto t = triangles.at(uv);
      if (!t) continue;
      const auto own = surf::normal(surface, uv), flat = triangles.normal(*t);
      if (!own || !flat) continue;
      const double angle = std::atan2(geom::length(cross(*own, *flat)), dot(*own, *flat));
      if (angle > most.angle) most = {angle, uv};
    }
  }
  return most;
}

/// Strips between kinks along lines that a mesh may take for one line (DivisionOptions::closing), as places along their
/// middles: on a kink itself there is no one normal.
std::vector<Box> strips_of(const surf::Surface& surface) {
  std::vector<Box> parts;
  constexpr int places = 64;
  const Box& chart = surface.chart();
  const double near = 10.0 * surf::mesh::DivisionOptions{}.closing * chart.diagonal();
  const auto middles = [near](const std::vector<double>& kinks) {
    std::vector<double> at;
    for (std::size_t i = 1; i < kinks.size(); ++i) {
      if (kinks[i] - kinks[i - 1] < near) at.push_back(0.5 * (kinks[i] + kinks[i - 1]));
    }
    return at;
  };
  const auto along = [](double low, double high, int i) { return std::lerp(low, high, (i + 0.5) / places); };
  for (int i = 0; i < places; ++i) {
    for (const double u : middles(surface.kinks().u)) {
      const Point p{u, along(chart.low.y, chart.high.y, i)};
      parts.push_back({p, p});
    }
    for (const double v : middles(surface.kinks().v)) {
      const Point p{along(chart.low.x, chart.high.x, i), v};
      parts.push_back({p, p});
    }
  }
  return parts;
}

}  // namespace

void doubt_details(model::SurfaceMeshed& meshed, std::span<const surf::trim::TrimmedSurface> surfaces,
                   const surf::mesh::SizeOptions& sizes) {
  constexpr double least_turn = 10.0, most_turn = 45.0;
  const double turn = std::clamp(sizes.turn, least_turn, most_turn) * std::numbers::pi / 180.0;
  for (std::size_t f = 0; f < surfaces.size(); ++f) {
    const surf::Surface& surface = surfaces[f].surface;
    const std::vector<Box> strips = strips_of(surface);
    const bool seen = surface.seen(surface.chart());
    if (seen && strips.empty()) continue;
    const TrianglesInChart triangles(meshed.mesh, f);
    const auto tell = [&](Point uv, std::string message) {
      const geom::Point3 p = surface.at(uv);
      meshed.findings.push_back({"feature_left_out",
                                 std::move(message),
                                 {.item = surfaces[f].name, .x = p.x, .y = p.y, .z = p.z, .u = uv.x, .v = uv.y}});
    };
    const TurnedAway between = most_turned(surface, triangles, strips);
    if (between.angle > 2.0 * turn)
      tell(between.at,
           "two kinks of the surface are so near to each other here that the mesh takes them for one: what rises "
           "between them is left out");
    if (seen) continue;
    const surf::Details details = surf::details_of(surface, surface.chart());
    if (details.parts.empty()) continue;
    const TurnedAway most = most_turned(surface, triangles, details.parts);
    if (most.angle <= 2.0 * turn) continue;
    tell(most.at, fmt::format("the surface turns by {:.0f} degrees from the mesh here, over a place narrower than the "
                              "sizes: what rises there is left out; use a smaller size",
                              most.angle * 180.0 / std::numbers::pi));
  }
}

}  // namespace quebra::surfaces
