#pragma once
// The triangulation under construction: constrained Delaunay in flat arrays, with exact predicates. Points are inserted
// one by one (walk, split, flips), constraint edges by retriangulating the cavity they cross. The outside is covered by
// ghost triangles that join the hull to one vertex at infinity, so that no bounding triangle disturbs the result.
// Method: Lawson's flips [lawson1977], remembering stochastic walk [devillers2002walking], cavity retriangulation
// [anglada1997]. docs/algorithms/delaunay.md has the notation. Used by delaunay.h and triangulate.h only.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shared/geom/point.h"
#include "shared/geom/predicates.h"

namespace dobra::mesh::delaunay {

class DelaunayKernel {
 public:
  using Vertex = std::uint32_t;
  using Cell = std::uint32_t;  ///< A triangle or ghost triangle.
  using Half = std::uint32_t;  ///< Directed side i of cell c: 4 c + i, from vertex i to vertex i + 1.
  using Mark = std::uint8_t;

  static constexpr Vertex at_infinity = 0xffffffffU;
  static constexpr std::uint32_t none = 0xffffffffU;
  /// Marks of sides, equal on both half-edges; any mark keeps the side from being flipped.
  static constexpr Mark fixed = 1;      ///< An input edge.
  static constexpr Mark parity = 2;     ///< An odd number of boundary edges.
  static constexpr Mark interface = 4;  ///< Seeds do not flow across.

  struct Triangle {
    std::array<Vertex, 3> vertex;  ///< Anticlockwise; one is at_infinity in a ghost.
    std::array<Half, 3>
        twin;  ///< Half-edge on the other side of each side; none only in a triangulation without ghosts.
    std::int32_t region = 0;  ///< For the caller; inherited when a cell is split. Negative: not to be kept.
    std::array<Mark, 3> mark{};
  };

  enum class Where : std::uint8_t { Inside, OnSide, OnVertex, Outside, Blocked };
  struct Location {
    Where where = Where::Inside;
    Half half = none;  ///< A half-edge of the cell; the side it is on; the half-edge from the vertex; a ghost's; the
                       ///< side that blocks.
  };
  enum class Walls : std::uint8_t { Ignore, Stop };  ///< Whether a walk may cross marked sides.

  /// Decides which sides are flipped where the plane is only the chart of a surface.
  struct FlipRule {
    virtual ~FlipRule() = default;
    /// Of the side a-b with the triangles a, b, c and b, a, d, whether c-d is better. @pre endless flips do not come of
    /// it: what it favours grows with every flip. The new triangles must be anticlockwise.
    [[nodiscard]] virtual bool flips(Vertex a, Vertex b, Vertex c, Vertex d) const = 0;
  };

  /// A constraint that runs across the marked side from `from` to `to`.
  struct Crossing {
    Vertex from = none;
    Vertex to = none;
  };

  /// One triangle with its three ghosts. @pre the points turn left.
  void start(geom::Point a, geom::Point b, geom::Point c);
  /// Takes over a finished triangulation (no ghosts): anticlockwise corners; no side is marked.
  void take(std::vector<geom::Point> points, std::span<const std::array<Vertex, 3>> corners);
  void reserve(std::size_t points, std::size_t cells);

  /// Walks from cell `start`. Blocked only with Walls::Stop. @cost O(sqrt n) cells, O(1) from a near cell.
  Location locate(geom::Point p, Cell start, Walls walls);
  /// Inserts p where `locate` found it and restores the Delaunay property. @pre where is Inside, OnSide or Outside.
  Vertex insert(geom::Point p, Location at);
  /// Makes the segment a-b a chain of marked sides, split at the vertices that lie exactly on it; `chain` receives its
  /// vertices a..b. Nothing, or the marked side that it would have to cross.
  std::optional<Crossing> insert_constraint(Vertex a, Vertex b, Mark mark, std::vector<Vertex>& chain);
  /// From now on this rule decides, in the cells with region >= 0, instead of the circles of the plane; none: these.
  /// @pre it outlives the kernel and its copies.
  void set_rule(const FlipRule* rule) { rule_ = rule; }
  /// Flips every unmarked side that is not Delaunay; returns the number of flips.
  std::size_t legalise_all();
  /// The same starting from the cells round `vertices`; `changed` receives the vertices of the cells that were flipped,
  /// some several times.
  std::size_t legalise_near(std::span<const Vertex> vertices, std::vector<Vertex>& changed);
  /// Flips a side whatever the rule says: a-b with the apexes c and d becomes d-c. Twice makes it b-a, as it was.
  /// @pre not marked, no ghost beside it; the new triangles are anticlockwise
  void flip(Half e);
  /// Moves a vertex. @pre its triangles stay anticlockwise; call legalise_all afterwards.
  void move(Vertex v, geom::Point to) { points_[v] = to; }

  /// For meshers that build triangles by themselves; the triangulation is whole again when every side has its twin.
  Vertex add_vertex(geom::Point p);
  Cell add_triangle(Vertex a, Vertex b, Vertex c, std::int32_t region);
  /// The same in place of a cell to which no side of another cell leads.
  void replace_triangle(Cell cell, Vertex a, Vertex b, Vertex c, std::int32_t region);
  /// Makes `e` and `f` the two halves of one side.
  void link(Half e, Half f, Mark mark);
  /// Removes the cells of `region`, to which no side of another cell leads; others take their places.
  void remove_cells(std::int32_t region);
  /// Finds half_of again for all vertices; none for those of no cell.
  void renew_half_of();

  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] std::size_t vertex_count() const { return points_.size(); }
  [[nodiscard]] const Triangle& cell(Cell c) const { return cells_[c]; }
  [[nodiscard]] geom::Point point(Vertex v) const { return points_[v]; }
  void set_region(Cell c, std::int32_t region) { cells_[c].region = region; }
  void set_mark(Half e, Mark mark);
  /// Some half-edge that starts at v.
  [[nodiscard]] Half half_of(Vertex v) const { return half_of_[v]; }
  /// The half-edge from `a` to `b`; none if there is no such side. @cost the degree of a
  [[nodiscard]] Half find(Vertex a, Vertex b) const;
  [[nodiscard]] bool is_ghost(Cell c) const;

  static constexpr Half next(Half e) { return (e & 3U) == 2U ? e - 2U : e + 1U; }
  static constexpr Half previous(Half e) { return (e & 3U) == 0U ? e + 2U : e - 1U; }
  static constexpr Cell cell_of(Half e) { return e >> 2U; }
  static constexpr Half half(Cell c, std::uint32_t side) { return (c << 2U) | side; }
  [[nodiscard]] Half twin(Half e) const { return cells_[e >> 2U].twin[e & 3U]; }
  [[nodiscard]] Vertex origin(Half e) const { return cells_[e >> 2U].vertex[e & 3U]; }
  [[nodiscard]] Vertex target(Half e) const { return origin(next(e)); }
  [[nodiscard]] Vertex apex(Half e) const { return origin(previous(e)); }
  [[nodiscard]] Mark mark(Half e) const { return cells_[e >> 2U].mark[e & 3U]; }
  /// The next half-edge anticlockwise that starts at the same vertex; none at a border without ghosts.
  [[nodiscard]] Half around(Half e) const { return twin(previous(e)); }
  /// True if p lies strictly inside the circle of a cell (for a ghost: strictly beyond its side).
  [[nodiscard]] bool in_circle(Cell c, geom::Point p) const;

 private:
  struct Chain;
  void set_vertex(Half e, Vertex v);
  [[nodiscard]] bool must_flip(Half e) const;
  void legalise(Vertex apex);
  std::size_t legalise_stack(std::vector<Vertex>* changed);
  void split_cell(Cell c, Vertex p);
  void split_side(Half e, Vertex p);
  Cell add_cell(std::int32_t region);
  Location brute_force(geom::Point p) const;
  void mark_side(Half e, Mark mark);
  std::optional<Crossing> cut_cavity(Half first_crossed, Vertex a, Vertex b, Vertex& end);
  Half fill(Chain& chain, std::span<const Cell> spare, std::size_t& used);
  std::uint32_t random();

  std::vector<geom::Point> points_;
  std::vector<Triangle> cells_;
  std::vector<Half> half_of_;
  std::vector<Half> stack_;
  const FlipRule* rule_ = nullptr;
  std::uint32_t random_state_ = 2463534242U;
};

}  // namespace dobra::mesh::delaunay
