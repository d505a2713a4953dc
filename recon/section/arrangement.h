#pragma once
// The lines of a section as one planar subdivision, each edge of which knows the lines that run along it: what
// crossings, units and gaps are found with. A stretch of a line that runs free of everything else is one straight edge
// (stretches.h), whose course is asked for. Page: docs/algorithms/units.md

#include <cstdint>
#include <string>
#include <vector>

#include "recon/section/stretches.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/topo/subdivision.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
namespace topo = dobra::topo;
}  // namespace recon

namespace recon::section {

class Arrangement {
 public:
  /// All lines in; they are numbered as they stand. Vertices of the lines stay where they are, to the last bit.
  /// @error those of topo::insert.
  /// @cost  O(n) for n points, and O(log n + crossings) for every segment that runs close to another line.
  static base::Result<Arrangement> make(std::vector<geom::Polyline> lines);

  /// Further lines.
  base::Result<void> add(std::vector<geom::Polyline> lines);

  [[nodiscard]] const topo::Subdivision& subdivision() const { return subdivision_; }
  /// Numbers of the lines along an edge, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& lines_on(topo::EdgeId edge) const;
  [[nodiscard]] bool runs_along(topo::EdgeId edge, std::uint32_t line) const;
  /// Appends the course of a half-edge: its points from its origin on, without its target.
  void append(topo::HalfEdgeId h, std::vector<geom::Point>& points) const;
  /// Of a face, along the courses of its edges, m2; of the unbounded face minus that of all others.
  [[nodiscard]] double area(topo::FaceId face) const;
  /// The half-edges of a line from its first point to its last, or once round. Where rounding leads it into an edge
  /// and straight back, that is left out.
  [[nodiscard]] std::vector<topo::HalfEdgeId> path(std::uint32_t line) const;

  /// By face, which of the rings it lies within, numbered from 0, ascending: the closed lines `first`, `first` + 1,
  /// ..., named like "unit 'Q'". A ring that rounding leads back along itself has the faces that it winds round.
  /// @error CannotRestore where a ring's faces have not its area: they are wrong.
  [[nodiscard]] base::Result<std::vector<std::vector<std::uint32_t>>> holders(
      std::uint32_t first, const std::vector<std::string>& names) const;

 private:
  /// A stretch that is one edge.
  struct Chord {
    std::uint32_t line = 0;
    Stretch stretch;  ///< Empty: the edge is no chord.
  };

  base::Result<void> draw();
  void mark_chords(std::uint32_t line);
  [[nodiscard]] bool chords_stand() const;
  [[nodiscard]] geom::Point vertex_of(std::uint32_t line, std::uint32_t vertex) const;
  [[nodiscard]] topo::HalfEdgeId chord_of(std::uint32_t line, Stretch stretch) const;

  topo::Subdivision subdivision_;
  std::vector<geom::Polyline> lines_;
  Stretches stretches_;
  std::vector<std::vector<Stretch>> drawn_;           ///< Of each line.
  std::vector<std::vector<topo::HalfEdgeId>> paths_;  ///< Of each line, all that became of it.
  std::vector<std::vector<std::uint32_t>> lines_on_;  ///< By edge.
  std::vector<Chord> chords_;                         ///< By edge.
};

/// Where a first line meets a second one.
struct LineMeeting {
  std::size_t touches = 0;    ///< Places where they meet, or run together, and part on the side they came from.
  std::size_t crossings = 0;  ///< Places where the first passes from one side of the second to the other.
  geom::Point place;          ///< Of the first crossing along the first line; without one, of the first touch.
};

/// Exact: a line that ends on the other, or at its end, touches it. @pre neither line meets itself.
/// @error those of topo::insert.
base::Result<LineMeeting> meeting_of(const geom::Polyline& first, const geom::Polyline& second);

}  // namespace recon::section
