#pragma once
// Stresses round the vertices where they are infinite: the angular functions of Williams' field r^(lambda - 1) for
// free, clamped and sliding faces, and their amplitudes from a solution. A recovered stress made of polynomials misses
// what an element at such a vertex lacks; this one sees it.
// Page: docs/algorithms/estimate.md. Source: [williams1952], [rodenas2008].

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/angle.h"
#include "shared/fem/error/recover.h"
#include "shared/fem/stress.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem::error {

/// How a face that ends in a corner is held: not at all, across, wholly.
enum class CornerFace : std::uint8_t { Free, Roller, Clamped };

/// A node where the stresses are infinite: displacements go as r^exponent. The material lies on the left of `out`, as
/// far as `interior` anticlockwise.
struct SingularVertex {
  mesh::NodeId node;
  double exponent = 0.5;  ///< 0.5 a crack tip; corner_exponent() for others.
  geom::Vector out = {};  ///< Unit, along the boundary that leaves the corner; zero: not known, so is the field.
  base::Angle interior = {};
  CornerFace first = CornerFace::Free;  ///< Along `out`.
  CornerFace last = CornerFace::Free;
};

/// Coefficients of cos(l+1)t, sin(l+1)t, cos(l-1)t, sin(l-1)t in Airy's function r^(l+1) F(t), t from `out`.
using CornerField = std::array<double, 4>;
/// The fields that both faces allow, each of length 1: two at a crack tip, none if `exponent` is not of this corner.
std::vector<CornerField> corner_modes(const SingularVertex& vertex, const Material& material);
/// Stress of one mode, Pa. @pre at is not the vertex.
Voigt corner_stress(const SingularVertex& vertex, const CornerField& mode, geom::Vector from_vertex);

/// The stress near one singular vertex: its modes, and a polynomial beside them.
struct SingularZone {
  SingularVertex vertex;
  geom::Point at;
  std::vector<std::uint32_t> elements = {};  ///< That this stress stands for: those near the vertex.
  std::vector<CornerField> modes = {};
  std::vector<double> amplitudes = {};                 ///< One a mode, Pa m^(1 - exponent).
  std::vector<std::array<double, 3>> polynomial = {};  ///< Coefficients of xx, yy, xy a term, of (x - at) / scale.
  double scale = 1.0;                                  ///< m
  [[nodiscard]] Voigt stress(geom::Point p) const;
};

struct SingularZoneOptions {
  int rings = 3;      ///< Elements this near the vertex (1: those that touch it) may take the zone's stress.
  int fit_rings = 5;  ///< Samples of elements this near it, without those that touch it, determine the amplitudes.
};

/// Zones of the vertices whose field is known, by weighted least squares over the samples round each. The rings beyond
/// the first take the zone's stress as long as that comes nearer to their samples than the polynomials of `recovered`
/// do. A vertex whose field the samples do not show has no zone, nor has one where materials meet.
/// @cost O(n)
std::vector<SingularZone> singular_zones(const mesh::ElementMesh& mesh, const Materials& materials,
                                         const std::vector<SingularVertex>& singular, std::span<const geom::Vector> u,
                                         const RecoveredStress& recovered, const SingularZoneOptions& options = {});

}  // namespace dobra::fem::error
