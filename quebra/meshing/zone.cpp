#include "quebra/meshing/zone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "quebra/domain/domain.h"
#include "quebra/domain/selection.h"

namespace quebra::meshing {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Result;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;

constexpr double most_elements = 1e7;

Result<void> add(model::Model& model, std::string name, Polyline line, const ZoneParams& params) {
  const double length = line.points.size() > 1 ? dobra::geom::length(line) : 0.0;
  const double elements =
      2.3 * (2.0 * params.width * length + 3.2 * params.width * params.width) / (params.size * params.size);
  if (elements > most_elements) {
    return Error{
        ErrorCode::BadValue,
        fmt::format("the zone round '{}' would hold about {:.2g} elements; use a greater size or a smaller width", name,
                    elements)};
  }
  model.zones.push_back({std::move(name), std::move(line), params.size, params.width});
  return {};
}

}  // namespace

Result<model::Model> add_zone(const model::Model& model, const ZoneParams& params, const dobra::scenario::Context&,
                              const dobra::base::Progress&) {
  model::Model result = model;
  if (params.curves.empty() && params.points.empty())
    return Error{ErrorCode::BadValue, "the zone has no place: give `curves` or `points`"};
  for (const std::string& name : params.curves) {
    std::vector<std::string> names;
    const sketch::Curve* found = nullptr;
    for (const sketch::Curve& curve : model.domain.curves) {
      names.push_back(curve.name);
      if (curve.name == name) found = &curve;
    }
    if (found == nullptr)
      return Error{ErrorCode::BadValue,
                   fmt::format("there is no curve '{}'{}", name, domain::what_there_is(name, names))};
    DOBRA_TRY_VOID(add(result, name, trace(*found).line, params));
  }
  if (!params.points.empty())
    DOBRA_TRY_VOID(add(result, fmt::format("zone {}", result.zones.size() + 1), {params.points, false}, params));
  return result;
}

// A lattice with half the size's spacing, of which the points within the width of the line stay.
std::vector<Point> points_of(const model::Zone& zone, const domain::Domain& domain) {
  const double step = 0.5 * zone.size;
  const auto box = domain.box();
  std::set<std::pair<std::int64_t, std::int64_t>> cells;
  const auto cover = [&](const Segment& segment) {
    const auto range = [&](double a, double b, double low, double high) {
      const double from = std::max(std::min(a, b) - zone.width, low);
      const double to = std::min(std::max(a, b) + zone.width, high);
      return std::pair{static_cast<std::int64_t>(std::floor((from - low) / step)),
                       static_cast<std::int64_t>(std::ceil((to - low) / step))};
    };
    const auto [x0, x1] = range(segment.from.x, segment.to.x, box.low.x, box.high.x);
    const auto [y0, y1] = range(segment.from.y, segment.to.y, box.low.y, box.high.y);
    for (std::int64_t i = x0; i <= x1; ++i) {
      for (std::int64_t j = y0; j <= y1; ++j) {
        const Point p{box.low.x + static_cast<double>(i) * step, box.low.y + static_cast<double>(j) * step};
        if (distance(segment, p) <= zone.width) cells.emplace(i, j);
      }
    }
  };
  if (zone.line.points.size() == 1) cover({zone.line.points[0], zone.line.points[0]});
  for (std::size_t i = 0; i < zone.line.segment_count(); ++i) {
    // Short pieces, so that the lattice is not searched over the box of a long diagonal.
    const Segment whole = zone.line.segment(i);
    const int pieces = std::max(1, static_cast<int>(std::ceil(whole.length() / (4.0 * zone.width))));
    for (int k = 0; k < pieces; ++k) {
      cover({interpolate(whole.from, whole.to, static_cast<double>(k) / pieces),
             interpolate(whole.from, whole.to, static_cast<double>(k + 1) / pieces)});
    }
  }
  std::vector<Point> points;
  for (const auto& [i, j] : cells) {
    points.push_back({std::min(box.low.x + static_cast<double>(i) * step, box.high.x),
                      std::min(box.low.y + static_cast<double>(j) * step, box.high.y)});
  }
  return points;
}

}  // namespace quebra::meshing
