#pragma once
// A sheet: a triangle mesh in space that is one manifold piece, its triangles turned alike. It is made of the polygons
// of a file, whose small faults are mended and counted, and whose great ones are refused with their place. Sheets that
// are no disk are cut open. Page: docs/algorithms/parametrise.md. Source: [erickson2005greedy] (the cut).

#include <array>
#include <cstdint>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::surf::param {

/// Half-edge h is side h % 3 of triangle h / 3, from that corner to the next.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge no_half_edge = ~HalfEdge{0};
constexpr HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

struct Sheet {
  std::vector<geom::Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<HalfEdge> twins;                    ///< One a half-edge; none on the border.
  std::vector<std::vector<std::uint32_t>> loops;  ///< Of the border, in the order of its half-edges: sheet on the left.

  [[nodiscard]] std::uint32_t start(HalfEdge h) const { return triangles[h / 3][h % 3]; }
  [[nodiscard]] std::uint32_t end(HalfEdge h) const { return start(next(h)); }
  [[nodiscard]] std::int64_t euler() const {
    std::size_t sides = 0;
    for (const HalfEdge twin : twins) sides += twin == no_half_edge ? 2 : 1;
    return static_cast<std::int64_t>(points.size()) - static_cast<std::int64_t>(sides / 2) +
           static_cast<std::int64_t>(triangles.size());
  }
  [[nodiscard]] bool disk() const { return loops.size() == 1 && euler() == 1; }
  /// Handles of an orientable surface of one piece.
  [[nodiscard]] std::int64_t genus() const { return (2 - static_cast<std::int64_t>(loops.size()) - euler()) / 2; }
  /// A half-edge that starts in each vertex: on the border the one with no triangle on its right.
  [[nodiscard]] std::vector<HalfEdge> first_half_edges() const;
};

struct SheetOptions {
  /// A triangle whose height is below this part of its longest side has no area.
  double flat = 1e-10;
};

/// What was mended.
struct Mended {
  std::size_t merged = 0;   ///< Points at the place of another.
  std::size_t unused = 0;   ///< Points of no face.
  std::size_t dropped = 0;  ///< Triangles of two corners, and twins of another triangle.
  std::size_t flipped = 0;  ///< Triangles without area that a flip of a side, or their loss on the border, removed.
  std::size_t turned = 0;   ///< Triangles turned the way of most of their piece.
  std::size_t cut = 0;      ///< Faces of more than three corners.
  std::size_t parted = 0;   ///< Copies of points in which parts or pieces met; sheets_of alone makes them.
  std::vector<geom::Point3> parted_at;  ///< These points.
};

struct SheetMade {
  Sheet sheet;
  Mended mended;
};

/// @error NotFinite; BadMesh with the place {x, y, z}: no triangle, a face whose sides cross, a side of three
///        triangles, no way to turn the triangles alike, several pieces, a point in which parts meet, a triangle
///        without area that cannot be mended.
/// @cost  O(n log n)
base::Result<SheetMade> sheet_of(const dobra::mesh::PolygonMesh& mesh, const SheetOptions& options = {});

/// One sheet for each piece that sides join, in the order of their first triangles. A point in which parts meet gets a
/// copy for each. @error as sheet_of, but for pieces and such points  @cost O(n log n)
base::Result<std::vector<SheetMade>> sheets_of(const dobra::mesh::PolygonMesh& mesh, const SheetOptions& options = {});

/// Twins and loops of triangles that are turned alike. @error as sheet_of
base::Result<Sheet> connect(std::vector<geom::Point3> points, std::vector<std::array<std::uint32_t, 3>> triangles);
/// The same with the twins given.
base::Result<Sheet> connect(std::vector<geom::Point3> points, std::vector<std::array<std::uint32_t, 3>> triangles,
                            std::vector<HalfEdge> twins);

struct OpenOptions {
  double crease = 180.0;  ///< Degrees: sides at which the sheet folds by more are creases; 180: none.
  double beside = 2.0;    ///< So many times its length counts a side that is none, where there are creases; >= 1.
  /// The cut of a closed sheet ends where creases meet, if that is at least so far as this part of the farthest way.
  double corner_from = 0.5;
};

/// A sheet opened to a disk.
struct Opened {
  Sheet sheet;
  std::vector<std::uint32_t> origin;  ///< One a point: its number before the cut.
  /// One a half-edge: the one on the other side of the cut, none elsewhere.
  std::vector<HalfEdge> across;
  double length = 0.0;  ///< Of the cut, m.
  std::size_t sides = 0;
};

/// Cut along sides so that a disk remains: of a sheet with a border from border to border, of a closed one along loops
/// through one point, or between two points far apart where it is a sphere. Each way is the shortest of its kind, the
/// greedy choice of the source; ways may run together. Creases are preferred by counting other sides as longer. A disk
/// stays as it is.
/// @cost O(n log n)
Opened open(const Sheet& sheet, const OpenOptions& options = {});
/// The cut that open makes, one a half-edge; twins alike.
std::vector<bool> cut_to_disk(const Sheet& sheet, const OpenOptions& options = {});
/// Cut along any sides: pieces that these part are pieces of the sheet that comes out.
/// @pre one a half-edge, twins alike  @cost O(n log n)
Opened open_along(const Sheet& sheet, const std::vector<bool>& cut);

/// One a half-edge: the sheet folds there by more than so many degrees. @cost O(n)
std::vector<bool> creases_of(const Sheet& sheet, double degrees);

/// All loops but the longest closed by a fan of triangles round their middle: points and triangles behind those of the
/// sheet. A sheet without handles becomes a disk. @pre there is a loop  @cost O(n)
Sheet filled(const Sheet& sheet);

/// Each triangle in four, by the middles of its sides; old points keep their numbers. @cost O(n)
Sheet quartered(const Sheet& sheet);

/// The number of the longest loop of the border. @pre there is one
std::size_t longest_loop(const Sheet& sheet);
double loop_length(const Sheet& sheet, const std::vector<std::uint32_t>& loop);

}  // namespace dobra::surf::param
