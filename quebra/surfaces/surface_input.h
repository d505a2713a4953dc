#pragma once
// The surfaces of an input: tables of a scenario become trimmed surfaces, their common borders found. Page:
// docs/user/surfaces.md.

#include <vector>

#include "quebra/model/surface_meshed.h"
#include "quebra/surfaces/curve_params.h"
#include "quebra/surfaces/surface_params.h"
#include "quebra/surfaces/trim_params.h"
#include "shared/scenario/program.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// A base of the program's InputParams.
struct SurfaceInput {
  std::vector<SpaceCurveParams> space_curves;
  std::vector<SurfaceParams> surfaces;
  std::vector<TrimParams> trims;
  std::vector<PartParams> parts;
  std::vector<SurfacePointParams> surface_points;

  template <class P, class D>
  static void describe_in(D& d) {
    d.tables("space_curve", static_cast<std::vector<SpaceCurveParams> P::*>(&SurfaceInput::space_curves),
             {.title = "Curves in space", .help = "Borders and profiles of surfaces."});
    d.tables("surface", static_cast<std::vector<SurfaceParams> P::*>(&SurfaceInput::surfaces),
             {.title = "Surfaces", .help = "Meshed as shells; borders that coincide are one."});
    d.tables("trim", static_cast<std::vector<TrimParams> P::*>(&SurfaceInput::trims),
             {.title = "Trims of surfaces",
              .help = "Holes, outlines, lines inside and cracks, drawn in the chart or cut by others."});
    d.tables("part", static_cast<std::vector<PartParams> P::*>(&SurfaceInput::parts),
             {.title = "Parts of surfaces", .help = "That trims divide: which stay, and their regions."});
    d.tables("surface_point", static_cast<std::vector<SurfacePointParams> P::*>(&SurfaceInput::surface_points),
             {.title = "Points of surfaces", .help = "Nodes with a name."});
  }
};

struct Surfaces {
  std::vector<dobra::surf::trim::TrimmedSurface> faces;
  /// One a face: what the user's numbers of its chart are.
  std::vector<ChartUnits> units;
  std::vector<dobra::surf::mesh::Finding> findings;
  std::vector<model::SurfaceParts> parts;  ///< One a face.
  std::vector<model::ChosenPart> chosen;
  std::vector<model::ControlPoint> controls;
  std::vector<std::vector<std::size_t>> control_lines;
};

/// @param table  the table that `input` came from: its lines stand in the errors.
/// @error those of make_surface, make_space_curve and make_trim_curve; BadValue for names that are twice or unknown;
///        BadDomain with the place for what cannot be trimmed so. Each with file, line and the name of the table.
dobra::base::Result<Surfaces> make_surfaces(const SurfaceInput& input, const dobra::scenario::Table& table,
                                            const dobra::scenario::UnitSystem& units);

/// Whatever of the input can be drawn: surfaces as wide as their charts, with trims as lines that divide nothing, and
/// the control points. What is refused is left out without a word.
Surfaces drawn_surfaces(const SurfaceInput& input, const dobra::scenario::Table& table,
                        const dobra::scenario::UnitSystem& units);

}  // namespace quebra::surfaces
