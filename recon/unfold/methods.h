#pragma once
// From a method and its parameters to the map of a section. Pages in docs/algorithms: unfold.md (constant thickness),
// thickness.md (variable, proportional, line length), flexural_slip.md, shear.md

#include <optional>
#include <string>
#include <vector>

#include "recon/maps/section_map.h"
#include "recon/unfold/grid.h"
#include "recon/unfold/target.h"
#include "shared/base/angle.h"

namespace recon::unfold {

/// What restoration keeps.
enum class RestoreMethod { Constant, Variable, Proportional, Flexural, Shear, LineLength };

/// What a map does where it is not single-valued. A shear is refused there in any case.
enum class Doubt {
  Limited,  ///< As Nearest, within the limits of variable thickness (restore.h).
  Nearest,  ///< The nearest base segment, with a remark.
  Refuse,   ///< An error with the place.
};

/// "constant", "variable", ... as in scenarios.
const char* method_name(RestoreMethod method);
/// One sentence on what the method keeps and what it does not.
std::string what_it_keeps(RestoreMethod method);

/// Along which surfaces flexural slip happens.
enum class SlipBeds {
  Horizons,  ///< Every horizon keeps its length, and every point of it its depth below the top; between them by
             ///< rulings.
  Parallel,  ///< Every parallel of the top keeps its length, and every area is kept exactly.
};

struct MethodParams {
  RestoreMethod method = RestoreMethod::Constant;
  base::Angle shear_angle;  ///< Of the direction of shear from the vertical.
  std::string base;         ///< Proportional: the horizon that bounds the layers below; the farthest by default.
  std::optional<double> thickness;  ///< Proportional: of the restored layers, m; by default such that area is kept.
  double percent = 100.0;           ///< 0: as it is; 100: restored; between: the map's own state between the two.
  Doubt doubt = Doubt::Limited;
  SlipBeds beds = SlipBeds::Horizons;  ///< Flexural; a section with one horizon has parallels only.
};

struct MethodMap {
  maps::SectionMap map;
  /// Horizons of a stack: their images are known without looking for their cells. Without names, unless the method has
  /// measured them.
  std::vector<std::pair<section::HorizonId, maps::MappedLine>> lines;
  std::vector<std::string> remarks;
  /// How the ends of units go, where not as the map says: under flexural slip along horizons the beds between two of
  /// them slip too, so that corners of the target bend the ends.
  std::optional<maps::SectionMap> ends = std::nullopt;
  [[nodiscard]] const maps::SectionMap& map_of_ends() const { return ends ? *ends : map; }
};

/// Where all horizons go, in the order of the section: as the method knows it (those lines are moved out of it), or
/// through its map.
/// @param grid  names the points of methods without columns.
std::vector<maps::MappedLine> map_horizons(MethodMap& method, const section::Section& section,
                                           const maps::ColumnMap& grid, const base::Progress& progress = {});

/// The map of a section by the method, from the grid's base to the target.
/// States between 0 and 100 % turn every piece of the base by its part of the angle between the two lines, so that the
/// lengths that the method keeps are kept in all of them; a shear takes its part of the displacement.
/// @error CannotRestore with the place: an overturned top under shear, a stack that is folded over (Doubt::Refuse), a
///        pin line that misses a horizon; BadSection: no such base, no second horizon.
base::Result<MethodMap> make_method_map(const section::Section& section, const SourceGrid& source, const Target& target,
                                        const MethodParams& params);

/// Horizons from the grid's base down (away from it on the side of the layers), by their depth (bed_order.h); those
/// above it first.
std::vector<section::HorizonId> horizons_in_order(const section::Section& section, const SourceGrid& source,
                                                  const Target& target);

/// Points `part` of the way from one line to another with as many points: lengths and directions of the segments are
/// interpolated, turned about the point `fixed`, which moves straight.  @pre sizes equal, >= 2.
std::vector<geom::Point> bent_between(const std::vector<geom::Point>& from, const std::vector<geom::Point>& to,
                                      std::size_t fixed, double part);

}  // namespace recon::unfold
