#include "recon/kinematics/block_map.h"

#include <algorithm>
#include <type_traits>

#include "shared/base/parallel.h"

namespace recon::kinematics {

namespace {

template <class Map>
constexpr bool in_pieces = requires(const Map& map, AffinePiece& piece) {
  map.piece(geom::Point{}, Wall::Foot, piece);
};

double size_of(const RigidMap&) { return 1.0; }
double size_of(const FlowMap& map) { return map.size(); }
double size_of(const PropagationMap& map) { return map.size(); }

/// Points that one task maps, each beginning with the piece of the one before.
constexpr std::size_t points_a_task = 4096;

template <class Map>
void forward_in_pieces(const Map& map, std::span<const geom::Point> points, std::span<geom::Point> images, Wall wall) {
  AffinePiece piece;
  bool known = false;
  const double tolerance = 1e-10 * size_of(map);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!known || !piece.holds(points[i])) {
      map.piece(points[i], wall, piece);
      known = piece.orient(points[i], tolerance);
    }
    images[i] = piece(points[i]);
  }
}

MovedLine without_names(maps::MappedLine mapped) {
  return {std::move(mapped.before), std::move(mapped.after), std::move(mapped.given)};
}

maps::Gradient by_differences(const TrishearMap& map, geom::Point p) {
  const double h = 1e-4 * map.size();
  const auto along = [&](geom::Vector unit) {
    const auto slope = [&](double k) { return map(p + k * h * unit) - map(p - k * h * unit); };
    return (1.0 / (60.0 * h)) * (45.0 * slope(1.0) - 9.0 * slope(2.0) + slope(3.0));
  };
  const geom::Vector x = along({1.0, 0.0});
  const geom::Vector y = along({0.0, 1.0});
  return {x.x, y.x, x.y, y.y};
}

}  // namespace

geom::Point BlockMap::forward(geom::Point p, Wall on_fault) const {
  return std::visit(
      [&](const auto& map) -> geom::Point {
        using Map = std::decay_t<decltype(map)>;
        if constexpr (in_pieces<Map>) {
          AffinePiece piece;
          map.piece(p, on_fault, piece);
          return piece(p);
        } else if constexpr (std::is_same_v<Map, maps::SectionMap>) {
          return map.forward(p).at;
        } else {
          return map(p, on_fault);
        }
      },
      map_);
}

base::Result<void> BlockMap::forward(std::span<const geom::Point> points, std::span<geom::Point> images, Wall on_fault,
                                     const base::Progress& progress) const {
  DOBRA_CHECK(points.size() == images.size());
  if (const auto* section = std::get_if<maps::SectionMap>(&map_)) return section->forward(points, images, progress);
  base::parallel_for((points.size() + points_a_task - 1) / points_a_task, [&](std::size_t task) {
    if (progress.cancelled()) return;
    const std::size_t from = task * points_a_task;
    const std::size_t count = std::min(points_a_task, points.size() - from);
    std::visit(
        [&](const auto& map) {
          if constexpr (in_pieces<std::decay_t<decltype(map)>>) {
            forward_in_pieces(map, points.subspan(from, count), images.subspan(from, count), on_fault);
          } else {
            for (std::size_t i = from; i < from + count; ++i) images[i] = forward(points[i], on_fault);
          }
        },
        map_);
  });
  DOBRA_TRY_VOID(progress.check());
  progress.report(1.0);
  return {};
}

MovedLine BlockMap::forward(const geom::Polyline& line, Wall on_fault) const {
  return std::visit(
      [&](const auto& map) -> MovedLine {
        using Map = std::decay_t<decltype(map)>;
        if constexpr (in_pieces<Map>) {
          return walk(line, size_of(map), [&](geom::Point p, AffinePiece& piece) { map.piece(p, on_fault, piece); });
        } else if constexpr (std::is_same_v<Map, maps::SectionMap>) {
          return without_names(map.forward(line));
        } else {
          return map.line(line, on_fault);
        }
      },
      map_);
}

BlockMap BlockMap::swapped() const {
  return std::visit([](const auto& map) { return BlockMap(map.swapped()); }, map_);
}

maps::Gradient BlockMap::gradient(geom::Point p) const {
  return std::visit(
      [&](const auto& map) -> maps::Gradient {
        using Map = std::decay_t<decltype(map)>;
        if constexpr (in_pieces<Map>) {
          AffinePiece piece;
          map.piece(p, Wall::Hanging, piece);
          return {piece.image.x.x, piece.image.x.y, piece.image.y.x, piece.image.y.y};
        } else if constexpr (std::is_same_v<Map, maps::SectionMap>) {
          return map.gradient(p);
        } else {
          return by_differences(map, p);
        }
      },
      map_);
}

std::optional<Tip> BlockMap::tip() const {
  return std::visit(
      [](const auto& map) -> std::optional<Tip> {
        if constexpr (requires { map.tip(); }) {
          return map.tip();
        } else {
          return std::nullopt;
        }
      },
      map_);
}

}  // namespace recon::kinematics
