#pragma once
// A sheet laid flat in one chart: cut open where it is no disk, or with its holes filled meanwhile. Page:
// docs/algorithms/parametrise.md.

#include <vector>

#include "shared/base/finding.h"
#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/surf/param/parametrise.h"

namespace dobra::surf::remesh {

/// A sheet with a place in the chart for each of its points.
struct Charted {
  param::Sheet before;   ///< As it was given, mended.
  param::Opened opened;  ///< And cut.
  param::Parametrisation parametrisation;
  std::vector<base::Finding> findings;  ///< "mended", "cut" or "holes", "circle", "flipped".
};

/// What is done with a sheet of several borders and no handle.
enum class Holes : std::uint8_t {
  Cut,   ///< Opened along shortest ways from border to border; so is every other sheet that is no disk.
  Stay,  ///< All but the longest border stay holes in the chart: they are filled while it is laid flat.
};

/// @error those of sheet_of and parametrise
base::Result<Charted> chart_mesh(const dobra::mesh::PolygonMesh& mesh, const param::ParametriseOptions& options = {},
                                 Holes holes = Holes::Cut);
/// @error those of parametrise
base::Result<Charted> chart_sheet(const param::SheetMade& made, const param::ParametriseOptions& options, Holes holes,
                                  double crease);

base::Place place_of(geom::Point3 p);
geom::Point3 centre(const param::Sheet& sheet, std::uint32_t triangle);
double mean_side(const param::Sheet& sheet);  ///< m.
double area_of(const param::Sheet& sheet);    ///< m2.
/// "mended", each kind once.
void tell_mended(const param::Mended& mended, std::vector<base::Finding>& findings);

/// All borders but one can be holes of a chart.
bool keeps_holes(const param::Sheet& sheet);
/// Many holes, each small: a cut through all of them would stretch the chart.
bool has_many_holes(const param::Sheet& sheet);

}  // namespace dobra::surf::remesh
