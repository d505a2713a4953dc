#pragma once
// Whose every place of a section is that is drawn as polygons: the faces between their edges, faults and topographies,
// each with its unit. Gaps and overlaps that are thin belong to one of their neighbours; polygons that are pieces of
// one unit are one. Page: docs/algorithms/units.md, "Horizons from units".

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "recon/section/arrangement.h"
#include "recon/section/section.h"

namespace recon::input {

class UnitOwners {
 public:
  static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

  /// @param tolerance  gaps and overlaps thinner than this are untidy drawing, m; so are edges nearer than this to a
  ///                   fault that they run along.
  /// @error those of topo::insert and Arrangement::holders.
  /// @cost  O(n log n) for n vertices, and O(polygons^2).
  static base::Result<UnitOwners> make(const section::Section& section, double tolerance);

  [[nodiscard]] const section::Arrangement& arrangement() const { return arrangement_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Number of the unit that a face belongs to, or nobody.
  [[nodiscard]] std::size_t unit(topo::FaceId face) const;
  [[nodiscard]] bool on_barrier(topo::EdgeId edge) const;
  /// Whether all of an edge is nearer than the tolerance to one fault or topography.
  [[nodiscard]] bool near_barrier(topo::EdgeId edge) const;
  [[nodiscard]] std::vector<geom::Point> course(topo::HalfEdgeId h) const;  ///< With both ends.
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  base::Result<void> draw(const section::Section& section);
  base::Result<void> find_holders(const section::Section& section);
  [[nodiscard]] std::size_t innermost(const std::vector<std::uint32_t>& holders) const;
  [[nodiscard]] double width(topo::FaceId face) const;
  void give_faces();
  void tell_covered(const section::Section& section);
  [[nodiscard]] std::size_t first_beside(topo::FaceId gap) const;
  void give_gaps(const std::vector<topo::FaceId>& gaps);
  void unite_pieces(const section::Section& section);

  double tolerance_ = 0.0;
  section::Arrangement arrangement_;
  std::size_t polygons_ = 0;
  std::vector<geom::Polyline> barriers_;  ///< Lines `polygons_`, `polygons_` + 1, ... of the arrangement.
  std::vector<std::pair<std::size_t, std::size_t>> bridged_;  ///< Which polygons the lines behind the barriers join.
  std::vector<double> areas_;                                 ///< Of the polygons.
  std::vector<std::vector<std::uint32_t>> holders_;           ///< Polygons that a face lies in, by face.
  std::vector<std::vector<double>> common_;                   ///< Areas that two polygons have in common.
  std::vector<std::size_t> owner_;                            ///< Polygon, by face.
  std::vector<std::size_t> unit_of_polygon_;
  std::vector<std::string> names_;
  std::vector<std::string> remarks_;
};

}  // namespace recon::input
