#pragma once
// What the maps of sections (map.h, shear_map.h, ruled_map.h) have in common: they are made of cells (columns of a
// grid, strips of a shear, strips of a ruled band) in each of which the map has one formula. The walk that takes a line
// through the cells is in trace.cpp. Page: docs/algorithms/unfold.md

#include <cstdint>
#include <optional>
#include <vector>

#include "recon/maps/columns.h"
#include "shared/geom/polyline.h"

namespace recon::maps {

/// Where a map has one formula. What the two numbers count is the map's own affair.
struct Cell {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cell of a point.
struct Spot {
  Cell cell;
  double distance = 0.0;  ///< To what the cell stands on (its base segment), m; decides between cells that overlap.
  Foot foot = Foot::InColumn;  ///< NoColumn: no cell holds the point; the nearest one was taken.
};

/// A point in a cell: its name there, and where it goes.
struct Carried {
  ColumnPoint name;
  geom::Point image;
};

struct TraceTolerances {
  double side = 0.0;       ///< How far beyond a side a point still counts as inside, m.
  double tear = 0.0;       ///< Images farther apart than this are a tear, m.
  double chord = 0.0;      ///< Straight pieces whose image is curved are halved until the chord is this near, m ...
  int most_halvings = 12;  ///< ... but no more often than this.
};

/// A place where a line passes from one cell into another that is not its neighbour (it crosses the medial axis of the
/// base), so that its image jumps. Nothing is lost: the image is joined across the jump.
struct Tear {
  std::size_t index = 0;  ///< `before[index]` and `before[index + 1]` are the same point; their images are not.
  geom::Point place;      ///< On the line before.
  double gap = 0.0;       ///< Between the two images, m.
};

/// Where a horizon stands in a stack of lines (ruled_map.h): the line, and which of its vertices the first and the last
/// one of the horizon are (in that order, so that the first may be the greater number).
struct OnStack {
  std::size_t line = 0;
  std::size_t first = 0;
  std::size_t last = 0;
  [[nodiscard]] std::size_t vertex(std::size_t i) const { return first <= last ? first + i : first - i; }
};

/// A line and its image, vertex by vertex.
struct MappedLine {
  geom::Polyline before;           ///< The given line with a vertex wherever it crosses from cell to cell.
  geom::Polyline after;            ///< Its image, the same number of vertices.
  std::vector<ColumnPoint> names;  ///< The same number: column, along, depth.
  std::vector<std::size_t> given;  ///< Where the vertices of the given line stand in `before`.
  std::vector<Tear> tears;
  std::optional<OnStack> on_stack;       ///< Of a horizon that is a line of the map's stack, vertex by vertex.
  std::size_t without_column = 0;        ///< Given vertices that no cell holds; mapped by the nearest base segment.
  std::size_t beyond_ends = 0;           ///< Given vertices beyond the ends of the base.
  std::size_t not_reversible = 0;        ///< Given vertices that the map back does not bring home.
  std::optional<geom::Point> beyond_at;  ///< The first of those beyond the ends.
  std::optional<geom::Point> doubtful;   ///< The first place where the map is not single-valued: of a tear, or of a
                                         ///< vertex that no cell holds.
};

class ColumnMap;
class RuledMap;
class ShearMap;

/// What is wanted of a trace.
enum class Traced {
  Everything,
  Cells,  ///< Vertices where cells end; images may be bent between them, and are not carried back.
};

/// A line through a map, with a vertex wherever it crosses from cell to cell; exact in every cell up to the chord
/// tolerance. O((n + x) log m) for n vertices, x crossings, m cells; mostly O(n + x).
/// @param line open, n >= 1 points.
MappedLine trace(const ColumnMap& map, const geom::Polyline& line, Traced wanted = Traced::Everything);
MappedLine trace(const RuledMap& map, const geom::Polyline& line, Traced wanted = Traced::Everything);
MappedLine trace(const ShearMap& map, const geom::Polyline& line, Traced wanted = Traced::Everything);

/// A line through columns: names as above, images (place along the base, depth).
MappedLine measure_along(const Columns& columns, const TraceTolerances& tolerances, const geom::Polyline& line);

/// Is the column of `spot` as near to p as the nearest one?
bool columns_keep(const Columns& columns, const Spot& spot, geom::Point p, const Spot& nearest, double tolerance);

}  // namespace recon::maps
