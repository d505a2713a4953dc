#pragma once
// A mesh of surfaces that a step made, with what is known of it. Values.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "quebra/model/meshed.h"
#include "shared/surf/mesh/assemble.h"
#include "shared/surf/mesh/surface_elements.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/recognise.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::model {

/// The parts into which trims divide a surface, and which of them are meant.
struct SurfaceParts {
  std::optional<dobra::surf::trim::Recognised> recognised = std::nullopt;  ///< Nothing: the face came as it is.
  std::vector<std::size_t> in = {};                                        ///< Numbers of faces of `recognised`.
  std::vector<std::size_t> left_out = {};  ///< That could be meant: they lie in no hole.
  std::string surface = {};                ///< By which the document knows it.
};

/// One [[input.part]], in the order of the document.
struct ChosenPart {
  std::size_t face = 0;
  dobra::geom::Point at;  ///< In the chart.
  bool keeps = true;      ///< Else it drops.
};

/// A point by which a curve or surface is given: entry `entry` of [[input.TABLE]], its point `point`.
struct ControlPoint {
  std::string table, name;
  std::size_t entry = 0, point = 0;
  dobra::geom::Point3 at;
};

/// The surfaces of an input.
struct SurfaceSet {
  std::vector<dobra::surf::trim::TrimmedSurface> faces;
  std::vector<dobra::geom::Vector> chart_units;  ///< One a face: what 1 of its written u and v is in its chart.
  std::vector<SurfaceParts> parts = {};          ///< One a face; none where they come from a file.
  std::vector<ChosenPart> chosen = {};
  std::vector<ControlPoint> controls = {};
  std::vector<std::vector<std::size_t>> control_lines = {};  ///< Numbers of controls: polygons of curves, nets.
  /// One a face: what units of its written u and v are called; empty: a parameter. None: they all are.
  std::vector<std::array<std::string, 2>> unit_names = {};
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
