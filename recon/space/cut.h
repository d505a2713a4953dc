#pragma once
// The step `cut`: the surfaces over a trace as a new section, which the steps that follow restore. Pages:
// docs/user/space.md, docs/algorithms/loft.md.

#include <string>
#include <vector>

#include "recon/space/surfaces.h"
#include "shared/scenario/value.h"

namespace recon::space {

/// Parameters of the step `cut`.
struct CutParams {
  std::vector<double> trace;
  double simplify = 0.0;
  template <class D>
  static void describe(D& d) {
    d.field("trace", &CutParams::trace,
            {.title = "Trace on the map",
             .help = "x0, y0, x1, y1 and further corners: where the new section runs, from its left end to its right.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field("simplify", &CutParams::simplify,
            {.title = "Simplify lines",
             .help = "Vertices are dropped that are nearer than this to the line without them; 0 keeps all.",
             .unit = "m",
             .at_least = 0.0});
  }
};

struct CutSection {
  dobra::scenario::Table input;  ///< The [input] that a document of the section has.
  section::Section section;      ///< What that gives.
  dobra::surf::loft::PlanTrace trace;
  std::vector<dobra::surf::loft::Finding> findings;
  std::vector<std::string> remarks;
};

/// Horizons that faults part are pieces, "A (1)", "A (2)" of A; x is the distance along the trace, z the height. Ends
/// of horizons that the surfaces leave beside a fault are moved to it (snap_to_faults), and told.
/// @error BadValue: a trace that is none; BadSection: the trace meets no horizon; those of read_section
base::Result<CutSection> cut_section(const MadeSurfaces& surfaces, const CutParams& params);

}  // namespace recon::space
