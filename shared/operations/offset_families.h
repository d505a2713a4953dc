#pragma once
// What `offset` computes: lines and polygons as bases, and the curves or areas of each.

#include "shared/operations/offset_curves.h"
#include "shared/operations/offset_params.h"

namespace dobra::operations {

/// Some open lines, or polygons, or both (parts of one feature).
struct OffsetBase {
  std::string name;
  io::lines::Feature source;  ///< Its name, kind, id and properties; no parts.
  std::vector<geom::Polyline> lines = {};
  std::vector<std::vector<geom::Polyline>> polygons = {};  ///< Each a contour anticlockwise and its holes clockwise.
};

struct OffsetInput {
  std::vector<OffsetBase> bases;
  OffsetOrigin origin = {};
  std::size_t mended = 0;  ///< Polygons that cross or touch themselves, and are taken as others.
};

/// The bases of a file, as the plan wants them: each line that goes to one side is a base of its own. What is left out
/// or mended is told.
/// @param file  which errors and notes name; empty: the lines are not of a file.
/// @error `refuse`: there is no such curve; BadFormat: there is no line.
base::Result<OffsetInput> offset_input(const OffsetCaller& caller, io::formats::LineWork read, const std::string& file,
                                       const OffsetPlan& plan);

/// Where there are polygons, open lines are left out at distances below 0, and this is told.
/// @param verdict  of the verifier, if the plan wants it.
/// @error `refuse`: a distance below 0 and no polygon; those of offset::offset with the base.
base::Result<std::vector<OffsetFamily>> offset_families(const OffsetCaller& caller, const std::string& file,
                                                        const OffsetInput& input, const OffsetPlan& plan,
                                                        OffsetVerdict& verdict);

/// A distance below 0 is for polygons: there must be one. @error `refuse`
base::Result<void> check_signs(const std::vector<OffsetBase>& bases, const OffsetPlan& plan,
                               const OffsetCaller& caller);

}  // namespace dobra::operations
