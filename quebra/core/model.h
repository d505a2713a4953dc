#pragma once
// What QUEBRA works on: a domain bounded by curves, internal constraints, and the meshes made so far. A value.

#include <memory>
#include <string>
#include <vector>

#include "quebra/core/curve.h"
#include "shared/mesh/quality.h"
#include "shared/mesh/triangle_mesh.h"

namespace quebra::core {

/// Curves joined into loops. Ends that meet are the same point, bit for bit.
struct Domain {
  std::vector<Curve> curves;
  /// One loop: indices of curves in order round it, and whether each is travelled backwards.
  struct Side {
    std::size_t curve = 0;
    bool backwards = false;
  };
  struct Loop {
    std::vector<Side> sides;
    int depth = 0;  ///< 0: outer boundary, 1: hole in it, 2: island in the hole ...
  };
  std::vector<Loop> loops;

  [[nodiscard]] dobra::geom::Box box() const;
};

/// An offset curve inside the domain, along which the mesh must have edges.
struct Constraint {
  std::string name;        ///< "hole_1": base curve and number.
  double distance = 0.0;   ///< From the base, m.
  double spacing = 0.0;    ///< Wanted distance of its nodes, m.
  dobra::geom::Polyline line;
  /// Where its ends lie on curves of the domain, if they do.
  struct Foot {
    std::size_t curve = 0;
    double s = 0.0;
  };
  std::vector<Foot> feet;
};

struct Meshed {
  std::string name;
  dobra::mesh::TriangleMesh mesh;
  dobra::mesh::MeshQuality quality;
  std::size_t constraints = 0;  ///< How many constraints it obeys.
};

struct Model {
  Domain domain;
  std::vector<Constraint> constraints;
  std::vector<std::shared_ptr<const Meshed>> meshes;  ///< In the order made; each mesh step adds one.
  std::vector<std::string> remarks;
};

}  // namespace quebra::core
