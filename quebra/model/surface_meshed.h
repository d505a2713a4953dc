#pragma once
// A mesh of surfaces that a step made, with what is known of it. Values.

#include <string>
#include <vector>

#include "quebra/model/meshed.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/surface_elements.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::model {

/// The surfaces of an input.
struct SurfaceSet {
  std::vector<dobra::surf::trim::TrimmedSurface> faces;
  std::vector<dobra::geom::Vector> chart_units;  ///< One a face: what 1 of its written u and v is in its chart.
};

struct SurfaceMeshed {
  std::string name;
  dobra::surf::mesh::SurfaceMesh mesh;          ///< Triangles, before they were joined or bent.
  dobra::surf::mesh::SurfaceElements elements;  ///< As they are, cracks opened.
  dobra::surf::mesh::SurfaceQuality quality;    ///< Of the triangles.
  double area_surface = 0.0;                    ///< Of the faces by quadrature, m2.
  std::vector<dobra::surf::mesh::Finding> findings;
  std::vector<PhaseTime> seconds;
};

}  // namespace quebra::model
