#pragma once
// The step `surface`: horizons and faults as surfaces through the sections of a document. Pages: docs/user/space.md,
// docs/algorithms/loft.md.

#include <optional>
#include <string>
#include <vector>

#include "recon/space/placed.h"
#include "shared/base/progress.h"
#include "shared/surf/loft/cut.h"
#include "shared/surf/loft/measures.h"
#include "shared/surf/loft/through.h"

namespace recon::space {

/// Parameters of the step `surface`.
struct SurfaceParams {
  std::optional<double> mistie_tolerance;
  int rows = 8;
  double at_fault = 0.01;
  std::optional<double> contours;
  template <class D>
  static void describe(D& d) {
    d.field("mistie_tolerance", &SurfaceParams::mistie_tolerance,
            {.title = "Greatest mis-tie",
             .help = "Where two sections cross, lines of one name that are farther apart are refused, others meet "
                     "half-way; by default 0.02 of the size of all.",
             .unit = "m",
             .at_least = 0.0});
    d.field("rows", &SurfaceParams::rows,
            {.title = "Rows from section to section",
             .help = "Of triangles, in files, pictures and between the sections of a cut.",
             .at_least = 1,
             .at_most = 100});
    d.field("at_fault", &SurfaceParams::at_fault,
            {.title = "Ends at faults",
             .help = "A horizon that ends nearer to a fault than this part of its section's size ends at the fault.",
             .at_least = 0.0,
             .at_most = 0.2});
    d.field("contours", &SurfaceParams::contours,
            {.title = "Interval of contours",
             .help = "Lines of one height every so many metres.",
             .unit = "m",
             .above = 0.0});
  }
};

/// What is told of a surface.
struct SurfaceRow {
  std::string name;
  dobra::surf::loft::LineKind kind = dobra::surf::loft::LineKind::Horizon;
  dobra::surf::loft::Measures measures;
  std::size_t pieces = 0, triangles = 0;
  std::vector<dobra::surf::loft::Mistie> misties;  ///< Of its lines.
};
/// Between horizons that follow each other, from the highest down.
struct VolumeRow {
  std::string upper, lower;
  dobra::surf::loft::Volume volume;
};

struct MadeSurfaces {
  dobra::surf::loft::Surfaces made;
  std::vector<SurfaceRow> rows;  ///< One a surface.
  std::vector<VolumeRow> volumes;
  std::vector<std::vector<dobra::surf::loft::Contour>> contours;  ///< One list a surface; empty where not asked for.
};

/// @error those of surfaces_through(), with names of sections; BadSection: no surface at all; TooManyElements
base::Result<MadeSurfaces> make_surfaces(const PlacedSections& placed, const SurfaceParams& params,
                                         const base::Progress& progress = {});

}  // namespace recon::space
