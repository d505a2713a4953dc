#pragma once
// A piece of a surface in space with the lattice that stands for it in files, pictures and sections. Page:
// docs/algorithms/loft.md.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "shared/surf/loft/sections.h"
#include "shared/surf/surface.h"

namespace dobra::surf::loft {

struct Patch {
  Surface surface;
  std::vector<double> u, v;                             ///< Lines of the lattice.
  std::vector<geom::Point3> points;                     ///< v running fastest: number i * v.size() + j.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Anticlockwise in the chart; none without an area.
  std::vector<std::array<std::uint32_t, 3>> collapsed;  ///< Those of which two corners are in one place.
  std::vector<std::size_t> sections;                    ///< Whose lines it holds.
  std::vector<double> sections_v;                       ///< v of those lines, of a loft; else empty.
  std::string low_fault, high_fault;                    ///< At which it ends at its first and last u; empty: none.
  [[nodiscard]] geom::Point place(std::uint32_t point) const { return {u[point / v.size()], v[point % v.size()]}; }
};

/// The lattice through all breaks of the surface and the lines given; every interval is parted in so many rows.
struct LatticeLines {
  std::vector<double> u, v;
  std::size_t rows_u = 1, rows_v = 1;
};
/// @error TooManyElements: more than 4 million triangles
base::Result<Patch> lattice(Surface surface, const LatticeLines& lines);

/// Points of the lattice round the chart, anticlockwise from its first corner, each once.
std::vector<geom::Point3> border_of(const Patch& patch);

/// Lines of a name on two sections beside each other that no patch joins, as where a fault ends above one of them.
struct Unjoined {
  std::string first, second;         ///< The sections.
  std::vector<geom::Point3> points;  ///< Of the lines.
  double plan = 0.0;                 ///< Area on the map that a patch between them would have at the most, m2.
};

/// All patches of one name.
struct NamedSurface {
  std::string name;
  LineKind kind = LineKind::Horizon;
  std::vector<Patch> patches;
  std::vector<Unjoined> unjoined = {};
};

}  // namespace dobra::surf::loft
