#pragma once
// What QUEBRA works on: a domain bounded by curves, internal constraints, and the meshes made so far. A value.

#include <memory>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"
#include "quebra/model/meshed.h"
#include "quebra/model/surface_meshed.h"
#include "shared/fem/fracture/rosette.h"
#include "shared/scenario/units.h"

// What steps add, whose rooms stand above this one.
namespace quebra::meshing {
struct Band;  // band.h
}
namespace quebra::analysis {
struct Analysis;       // analysis.h
struct ProblemParams;  // problem.h
}  // namespace quebra::analysis
namespace quebra::surfaces {
struct Shell;  // shell.h
}
namespace quebra::solids {
struct Parts;  // parts.h
}
namespace quebra::core {
struct ViewParams;  // result_picture.h
}
namespace dobra::operations {
struct Offsets;  // offset_step.h
}

namespace quebra::model {

/// Elements of at most `size` within `width` of a line.
struct Zone {
  std::string name;
  dobra::geom::Polyline line;
  double size = 0.0;   ///< m.
  double width = 0.0;  ///< m, to either side.
};

/// An offset curve inside the domain, along which the mesh must have edges.
struct Constraint {
  std::string name;       ///< "hole_1": base curve and number.
  double distance = 0.0;  ///< From the base, m.
  double spacing = 0.0;   ///< Wanted distance of its nodes, m.
  dobra::geom::Polyline line;
  /// Where its ends lie on curves of the domain, if they do.
  struct Foot {
    std::size_t curve = 0;
    double s = 0.0;
  };
  std::vector<Foot> feet;
};

/// The tip of a crack of which the model holds one lip, on a line of symmetry (half_crack.h).
struct HalfTip {
  std::string name;      ///< "LIP_start" or "LIP_end".
  std::size_t lip = 0;   ///< Curve behind the tip,
  std::size_t line = 0;  ///< and the one ahead.
  dobra::geom::Point at;
  dobra::geom::Vector ahead;
  dobra::fem::fracture::RosetteHalf half = dobra::fem::fracture::RosetteHalf::Left;  ///< Where the material is.
};

/// Where results are read: along a line, or at a point (results.h).
struct Samples {
  std::string name;
  std::vector<dobra::geom::Point> points;  ///< One: a probe.
  std::vector<double> s;                   ///< Distance of each from the start, m.
};

struct Model {
  domain::Domain domain;
  dobra::scenario::UnitSystem
      units;  ///< In which pictures, quantities, tables and exchange files are to be; all else is SI.
  std::vector<std::shared_ptr<const meshing::Band>> bands;  ///< In the order given.
  std::vector<Constraint> constraints;                      ///< What is left of them all.
  std::vector<Zone> zones;
  std::vector<HalfTip> half_tips;
  std::vector<std::shared_ptr<const Meshed>> meshes;                 ///< In the order made; each mesh step adds one.
  std::shared_ptr<const solids::Parts> solids;                       ///< None but in a document of solids.
  std::shared_ptr<const SurfaceSet> surfaces;                        ///< None in a plane model.
  std::vector<std::shared_ptr<const SurfaceMeshed>> surface_meshes;  ///< As `meshes`.
  std::shared_ptr<const surfaces::Shell> shell;                      ///< Sections, supports and loads of `shell_mesh`.
  std::shared_ptr<const SurfaceMeshed> shell_mesh;
  std::vector<dobra::surf::mesh::Finding> surface_findings;  ///< What was told of the surfaces before any mesh.
  std::shared_ptr<const MeshWork> work;  ///< If the last mesh step was stopped; none when a mesh is done.
  std::shared_ptr<const analysis::ProblemParams>
      problem;  ///< Materials, supports, loads; none until a step gives them.
  std::vector<std::shared_ptr<const analysis::Analysis>> analyses;  ///< In the order made.
  bool short_of_target = false;  ///< An adaptive loop ended above the error asked for; a remark says why,
  std::string why_short = {};    ///< that of the last loop here too, which a loop from its last cycle takes back.
  std::vector<Samples> samples;
  std::vector<std::shared_ptr<const core::ViewParams>>
      views;  ///< Pictures of results; one of the default if there are none.
  std::vector<std::shared_ptr<const dobra::operations::Offsets>> offsets;  ///< One for each step offset.
  std::vector<std::string> remarks;
  std::vector<sketch::Finding> findings;  ///< What was repaired, and what looks wrong and was left.
};

}  // namespace quebra::model
