#pragma once
// Places where the material is narrower than the sides beside it are long: two holes near each other, a crack's tip
// above a side, a point beside a line. Only finer sides make good elements there.  Page: docs/algorithms/size_field.md.
// Source: [ruppert1995], whose local feature size this is where it is less than the sides.

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "quebra/domain/domain.h"
#include "shared/mesh/delaunay/mesh_input.h"

namespace quebra::meshing {

struct NarrowOptions {
  double across = 1.0;     ///< Elements wanted across a narrow place, > 0.
  double enough = 1.5;     ///< Sides up to this many times the size wanted are left as they are.
  double smallest = 1e-3;  ///< So are places narrower than this fraction of a side.
  double floor = std::numeric_limits<double>::infinity();  ///< But not those that are wider than this, m.
  /// Sizes of the elements elsewhere, m. Points that are nearer to each other than 2/3 of it are a narrow place, and if
  /// several elements are wanted across so are sides, however short a bend has made them.
  std::function<double(dobra::geom::Point)> size;
  bool points = true;                       ///< Whether points ask; once is enough, as no division moves them.
  std::vector<dobra::geom::Box> only = {};  ///< Sides that touch one of these are looked at; empty: all.
  /// Two sides that meet at a smaller angle are no narrow place as far as that angle makes them near each other.
  dobra::base::Angle input_angle = dobra::base::Angle::from_degrees(40.0);
};

struct NarrowPlaces {
  std::vector<dobra::mesh::delaunay::SizeRequest> sizes;
  /// Where another look at the curves, divided by these sizes, may find more: bent ones come nearer than their chords,
  /// and what was narrower than `smallest` stands beside shorter sides. What straight sides asked for is settled.
  std::vector<dobra::geom::Box> again;
  /// A narrow place that nothing is asked for. Of each curve the narrowest, as a fraction of its side there.
  struct Left {
    std::size_t curve = 0, beside = 0;
    dobra::geom::Point at;
    double width = 0.0;  ///< m.
    double side = 0.0;   ///< Length of its side, m.
  };
  std::vector<Left> kept;    ///< Its curve keeps its subdivision.
  std::vector<Left> slight;  ///< Narrower than `smallest`.
};

/// Widths are distances through the material of sides that share no node; what lies across a hole is not near. Offset
/// constraints have sizes of their own and are passed over.
/// @param divided  the sets of its edges are first the curves of the domain, in their order and direction.
/// @param keeps    one a curve: not 0 if it keeps its subdivision, and is asked for nothing.
/// @cost O(n log n) for n sides, and O(length / width * across^2) for each narrow place
NarrowPlaces narrow_places(const domain::Domain& domain, const dobra::mesh::delaunay::MeshInput& divided,
                           std::span<const std::uint8_t> keeps, const NarrowOptions& options = {});

}  // namespace quebra::meshing
