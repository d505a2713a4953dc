#pragma once
// A plane elastic problem on a mesh: materials by region, supports, springs, ties and load cases. Places are names of
// side sets or node sets of the mesh; a name that the mesh lacks is an error with a suggestion.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/fem/material.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem {

enum class Axis : std::uint8_t { X, Y };

/// Prescribed displacements of the nodes of a set; what is not given is free.
struct Support {
  std::string where;
  std::optional<double> x = std::nullopt;  ///< m; 0 holds.
  std::optional<double> y = std::nullopt;  ///< m
  /// Along the outward normal of the sides, m; 0: symmetry. Side sets only.
  std::optional<double> normal = std::nullopt;
  std::function<geom::Vector(geom::Point)> field = {};  ///< Both components as a function of the place, m.
};

/// What the stiffness of a spring counts for.
enum class SpringKind : std::uint8_t {
  EachNode,    ///< N/m at each node of a side set; of a node set in all, as a force.
  Foundation,  ///< N/m3: a bed along the sides of the set.
};

struct Spring {
  std::string where;
  double x = 0.0;  ///< >= 0
  double y = 0.0;  ///< >= 0
  SpringKind kind = SpringKind::EachNode;
};

/// sum of coefficient * displacement = value.
struct TieTerm {
  mesh::NodeId node;
  Axis axis = Axis::X;
  double coefficient = 1.0;
};
struct Tie {
  std::string name;  ///< For messages.
  std::vector<TieTerm> terms;
  double value = 0.0;  ///< m
};
/// All nodes of a set have the same displacement along `axis`.
/// @error those of find_nodes
base::Result<std::vector<Tie>> equal_displacement(const mesh::ElementMesh& mesh, const std::string& where, Axis axis);

/// Traction at a point of a side with the outward unit normal, Pa.
using Traction = std::function<geom::Vector(geom::Point at, geom::Vector normal)>;
Traction uniform(geom::Vector traction);
/// Positive presses on the material; on both lips of a crack it opens it.
Traction pressure(double pressure);
/// From `start` at `from` to `end` at `to`, linear along that direction and beyond.
Traction linear(geom::Point from, geom::Vector start, geom::Point to, geom::Vector end);
/// sigma n of a stress field.
Traction traction_of(std::function<Voigt(geom::Point)> stress);

struct SideLoad {
  std::string where;  ///< A side set.
  Traction traction;
};
struct PointLoad {
  std::string where;   ///< A node set, or a side set.
  geom::Vector force;  ///< N: of a node set in all, of a side set at each node.
};
struct BodyForce {
  std::optional<std::int32_t> region = std::nullopt;    ///< All if none.
  std::function<geom::Vector(geom::Point)> force = {};  ///< N/m3
};

struct LoadCase {
  std::string name = "load";
  std::vector<SideLoad> sides = {};
  std::vector<PointLoad> points = {};
  std::vector<BodyForce> bodies = {};
  double settlement = 1.0;  ///< Multiplies every prescribed displacement and tie value in this case.
};

struct Problem {
  Materials materials = {};
  std::vector<Support> supports = {};
  std::vector<Spring> springs = {};
  std::vector<Tie> ties = {};
  std::vector<LoadCase> cases{LoadCase{}};
};

/// The sides of a side set.  @error InvalidOption with a suggestion.
base::Result<std::vector<mesh::ElementSide>> find_sides(const mesh::ElementMesh& mesh, const std::string& where);
/// The nodes of a node set, or of the sides of a side set, ascending.  @error InvalidOption with a suggestion.
base::Result<std::vector<mesh::NodeId>> find_nodes(const mesh::ElementMesh& mesh, const std::string& where);

/// Where a force or a spring acts, and the part of it that each node takes. A point is one place: where a crack gave it
/// several nodes they share in equal parts. Each node of a side set takes the whole.
struct Shares {
  std::vector<mesh::NodeId> nodes;
  double each = 1.0;
};
/// @error as find_nodes
base::Result<Shares> find_shares(const mesh::ElementMesh& mesh, const std::string& where);

/// Every region has a material, the materials make sense, all names exist, stiffnesses are not negative.
/// @error InvalidOption naming what is wrong, with the place of an element where a material is missing.
base::Result<void> check(const mesh::ElementMesh& mesh, const Problem& problem);

}  // namespace dobra::fem
