#pragma once
// Restoration: everything in the section carried from the source grid to the target by a method, and the ledger of what
// that kept. Page: docs/algorithms/unfold.md

#include <optional>
#include <string>
#include <vector>

#include "recon/balance/balance.h"
#include "recon/balance/ledger.h"
#include "recon/section/section.h"
#include "recon/section/section_check.h"
#include "recon/unfold/methods.h"
#include "shared/base/progress.h"

namespace recon::unfold {

/// Parameters of the step `restore`.
struct RestoreParams {
  RestoreMethod method = RestoreMethod::Constant;
  base::Angle angle;
  std::string base;
  std::optional<double> thickness;
  double percent = 100.0;
  Doubt outside = Doubt::Limited;
  SlipBeds beds = SlipBeds::Horizons;
  section::Crossings crossings = section::Crossings::Refuse;
  double tolerance = 2.0;
  template <class D>
  static void describe(D& d) {
    d.choice("method", &RestoreParams::method,
             {"constant", "variable", "proportional", "flexural", "shear", "line_length"},
             {.title = "Method",
              .help = "What is kept: constant thickness; variable thickness with its area; the part of the thickness; "
                      "flexural slip, every bed its length; simple shear; the length of every horizon."});
    d.field("angle", &RestoreParams::angle,
            {.title = "Direction of shear",
             .help = "From the vertical, positive towards +x upwards; 0 is vertical shear.",
             .unit = "deg",
             .above = -90.0,
             .at_most = 89.999,
             .when = "method = shear"});
    d.field("base", &RestoreParams::base,
            {.title = "Base horizon",
             .help = "Of proportional thickness; by default the farthest from the top.",
             .names = "horizon",
             .when = "method = proportional"});
    d.field("thickness", &RestoreParams::thickness,
            {.title = "Restored thickness",
             .help = "Of proportional thickness; by default such that the area stays.",
             .unit = "m",
             .above = 0.0,
             .when = "method = proportional"});
    d.field("percent", &RestoreParams::percent,
            {.title = "State",
             .help = "0: deformed, 100: restored; between: on the way.",
             .unit = "%",
             .at_least = 0.0,
             .at_most = 100.0});
    d.choice("outside", &RestoreParams::outside, {"limited", "nearest", "refuse"},
             {.title = "Where the map is not single-valued",
              .help = "limited: the nearest segment of the top, with a remark, and an error where variable thickness "
                      "leaves its limits; nearest: without limits; refuse: an error with the place."});
    d.choice("beds", &RestoreParams::beds, {"horizons", "parallel"},
             {.title = "Surfaces of slip",
              .help = "Of flexural slip: every horizon keeps its length, or every parallel of the top and all areas.",
              .when = "method = flexural"});
    d.choice("crossings", &RestoreParams::crossings, {"refuse", "allow"},
             {.title = "Horizons that cross", .help = section::crossings_help});
    d.field("tolerance", &RestoreParams::tolerance,
            {.title = "Balance tolerance",
             .help = "Greatest change of a bed's length or a unit's area in a balanced section.",
             .unit = "%",
             .at_least = 0.0});
  }
};

/// Variable thickness is refused (Doubt::Limited) where an area or a bed's length changes by more than this factor.
constexpr double greatest_factor = 2.0;

/// What make_method_map takes of them.
MethodParams method_params(const RestoreParams& params);

struct Restoration {
  RestoreParams params;  ///< It was made with these.
  maps::SectionMap map;
  section::Section section;                  ///< Everything restored, with the ids and names of the section's.
  std::vector<maps::MappedLine> lines;       ///< One for each horizon, in the same order.
  std::vector<section::HorizonId> order;     ///< From the top down, by mean depth; those above the top first.
  std::vector<balance::LineLength> lengths;  ///< Likewise.
  balance::Ledger ledger;
  balance::Balance balance;
  /// How far the ends of the beds lean outwards from the top to the farthest horizon: tan of the angle from the normal
  /// of the target, to the left and to the right end.
  double lean_left = 0.0;
  double lean_right = 0.0;
  std::vector<std::string> remarks;
};

/// @error CannotRestore with the place (see make_method_map; or where the map is not single-valued, Doubt::Refuse),
///        BadSection, Cancelled.
base::Result<Restoration> restore(const section::Section& section, const SourceGrid& source, const Target& target,
                                  const RestoreParams& params, const base::Progress& progress);

}  // namespace recon::unfold
