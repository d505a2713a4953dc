#include "recon/maps/section_map.h"

#include <algorithm>
#include <type_traits>

#include "shared/base/parallel.h"

namespace recon::maps {

namespace {

/// Points that one task maps, each starting from the cell of the one before.
constexpr std::size_t chunk = 4096;

template <class Hint, class One>
base::Result<void> in_chunks(std::span<const geom::Point> points, std::span<geom::Point> images,
                             const base::Progress& progress, const One& one) {
  DOBRA_CHECK(points.size() == images.size());
  const std::size_t chunks = (points.size() + chunk - 1) / chunk;
  base::parallel_for(chunks, [&](std::size_t c) {
    if (progress.cancelled()) return;
    Hint hint{};
    const std::size_t end = std::min(points.size(), (c + 1) * chunk);
    for (std::size_t i = c * chunk; i < end; ++i) images[i] = one(points[i], hint);
  });
  DOBRA_TRY_VOID(progress.check());
  progress.report(1.0);
  return {};
}

}  // namespace

MappedPoint SectionMap::forward(geom::Point p) const {
  return std::visit(
      [&](const auto& map) {
        const Spot spot = map.locate(p, Cell{});
        return MappedPoint{map.carry(map.enter(spot.cell), p).image, spot.foot};
      },
      map_);
}

geom::Point SectionMap::inverse(geom::Point p) const {
  return std::visit(
      [&](const auto& map) {
        auto hint = map.hint_back({});
        return map.back(p, hint);
      },
      map_);
}

base::Result<void> SectionMap::forward(std::span<const geom::Point> points, std::span<geom::Point> images,
                                       const base::Progress& progress) const {
  return std::visit(
      [&](const auto& map) {
        using Hint = typename std::decay_t<decltype(map)>::Hint;
        return in_chunks<Hint>(points, images, progress, [&](geom::Point p, Hint& hint) { return map.map(p, hint); });
      },
      map_);
}

base::Result<void> SectionMap::inverse(std::span<const geom::Point> points, std::span<geom::Point> images,
                                       const base::Progress& progress) const {
  return std::visit(
      [&](const auto& map) {
        using Hint = typename std::decay_t<decltype(map)>::Hint;
        return in_chunks<Hint>(points, images, progress, [&](geom::Point p, Hint& hint) { return map.back(p, hint); });
      },
      map_);
}

MappedLine SectionMap::forward(const geom::Polyline& line) const {
  DOBRA_CHECK(!line.points.empty());
  geom::Polyline open = line;
  open.closed = false;
  if (line.closed) open.points.push_back(line.points.front());
  MappedLine mapped = std::visit([&](const auto& map) { return trace(map, open); }, map_);
  if (line.closed) {
    for (geom::Polyline* side : {&mapped.before, &mapped.after}) {
      side->points.pop_back();
      side->closed = true;
    }
    mapped.names.pop_back();
    mapped.given.pop_back();
  }
  return mapped;
}

MappedLine SectionMap::through_cells(const geom::Polyline& line) const {
  return std::visit([&](const auto& map) { return trace(map, line, Traced::Cells); }, map_);
}

namespace {

template <class Map>
Gradient gradient_in(const Map& map, Cell cell, geom::Point p) {
  // Wide enough that rounding is small against it, narrow against any curvature: 1e-6 of the size.
  const double h = map.tolerances().chord;
  const auto entered = map.enter(cell);
  const auto image = [&](double x, double y) { return map.carry(entered, {p.x + x, p.y + y}).image; };
  const geom::Vector along_x = (image(h, 0.0) - image(-h, 0.0)) / (2.0 * h);
  const geom::Vector along_y = (image(0.0, h) - image(0.0, -h)) / (2.0 * h);
  return {along_x.x, along_y.x, along_x.y, along_y.y};
}

}  // namespace

Gradient SectionMap::gradient(geom::Point p) const {
  return std::visit([&](const auto& map) { return gradient_in(map, map.locate(p, Cell{}).cell, p); }, map_);
}

std::optional<Cell> SectionMap::cell_of(geom::Point p, Cell& hint) const {
  const Spot spot = std::visit([&](const auto& map) { return map.locate(p, hint); }, map_);
  hint = spot.cell;
  return spot.foot == Foot::NoColumn ? std::nullopt : std::optional(spot.cell);
}

void SectionMap::determinants(Cell cell, std::span<const geom::Point> points, std::span<double> values) const {
  DOBRA_CHECK(points.size() == values.size());
  std::visit(
      [&](const auto& map) {
        const auto entered = map.enter(cell);
        std::transform(points.begin(), points.end(), values.begin(),
                       [&](geom::Point p) { return map.determinant(entered, p); });
      },
      map_);
}

bool SectionMap::keeps_areas() const {
  const ColumnMap* by_columns = columns();
  return std::holds_alternative<ShearMap>(map_) || (by_columns != nullptr && by_columns->law() == ColumnLaw::Slip);
}

SectionMap SectionMap::swapped() const {
  return std::visit([](const auto& map) { return SectionMap(map.swapped()); }, map_);
}

const TraceTolerances& SectionMap::tolerances() const {
  return std::visit([](const auto& map) -> const TraceTolerances& { return map.tolerances(); }, map_);
}

}  // namespace recon::maps
