#pragma once
// A mesh that a step made, with what is known of it, and one that is still being made. Values.

#include <memory>
#include <string>
#include <vector>

#include "shared/mesh/element_mesh.h"
#include "shared/mesh/element_quality.h"
#include "shared/mesh/quality.h"
#include "shared/mesh/sizing/size_field.h"

namespace quebra::model {

/// How long a part of the work took, s.
struct PhaseTime {
  std::string phase;
  double seconds = 0.0;
};

struct Meshed {
  std::string name;
  dobra::mesh::ElementMesh mesh;
  dobra::mesh::MeshQuality quality;      ///< Of the triangles, before they were joined to quadrilaterals or bent.
  dobra::mesh::ElementQuality elements;  ///< Of the elements as they are.
  std::shared_ptr<const dobra::mesh::sizing::SizeField> sizes;  ///< That the mesher obeyed.
  std::size_t constraints = 0;                                  ///< How many constraints it obeys.
  std::size_t constraint_edges = 0;                             ///< Sides along them.
  std::vector<PhaseTime> seconds;  ///< Not part of any report: the same run gives the same bytes.
};

/// An engine that was stopped before its mesh was done: to be looked at.
struct MeshWork {
  std::string name;
  std::size_t steps = 0;
  std::vector<dobra::geom::Point> points;
  std::vector<dobra::mesh::Corners> triangles;  ///< Those made so far; engine "delaunay": a mesh of the domain.
  std::vector<dobra::geom::Segment> front;      ///< The sides from which it would go on.
};

}  // namespace quebra::model
