#pragma once
// Parameters of the step `predict`: a fault from a rollover, a rollover from a fault, angles of folds from dips.
// Page: docs/algorithms/rollover.md

#include <optional>
#include <string>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/scenario/field.h"

namespace recon {
namespace base = dobra::base;
}

namespace recon::inversion {

enum class Prediction { Fault, Rollover, FaultBendFold, FaultPropagationFold };

struct PredictParams {
  std::optional<Prediction> what;
  std::string fault;
  std::string horizon;
  std::optional<double> elevation;
  std::optional<double> slip, heave;
  base::Angle angle;
  base::Angle bedding;
  std::optional<base::Angle> backlimb, forelimb;
  template <class D>
  static void describe(D& d) {
    using dobra::scenario::Presence;
    d.choice("what", &PredictParams::what, {"fault", "rollover", "fault_bend_fold", "fault_propagation_fold"},
             {.title = "What",
              .help = "fault: the deep part of a normal fault from the rollover of a bed; rollover: a bed over a known "
                      "fault; the folds: their angles from the dips of their limbs.",
              .presence = Presence::Required});
    d.field("fault", &PredictParams::fault,
            {.title = "Fault",
             .help = "Of fault and rollover: its name.",
             .names = "fault",
             .when = "what in fault, rollover"});
    d.field("horizon", &PredictParams::horizon,
            {.title = "Bed",
             .help = "Horizon that has cutoffs on the fault; of rollover: that on the footwall.",
             .names = "horizon",
             .when = "what in fault, rollover"});
    d.field("elevation", &PredictParams::elevation,
            {.title = "Elevation",
             .help = "Of rollover, instead of a bed: of the regional at the fault.",
             .unit = "m",
             .names = "z",
             .when = "what = rollover"});
    d.field("slip", &PredictParams::slip,
            {.title = "Slip",
             .help = "Of rollover: along the fault at the regional; negative lets the hanging wall down.",
             .unit = "m",
             .other_than = 0.0,
             .when = "what = rollover"});
    d.field("heave", &PredictParams::heave,
            {.title = "Heave",
             .help = "Of rollover, instead: horizontally; negative lets the hanging wall down.",
             .unit = "m",
             .other_than = 0.0,
             .when = "what = rollover"});
    d.field("angle", &PredictParams::angle,
            {.title = "Angle",
             .help = "Direction of shear from the vertical, positive leaning to +x.",
             .unit = "deg",
             .at_least = -89.0,
             .at_most = 89.0,
             .when = "what in fault, rollover"});
    d.field("bedding", &PredictParams::bedding,
            {.title = "Bedding",
             .help = "Direction of the regional, anticlockwise from +x.",
             .unit = "deg",
             .at_least = -60.0,
             .at_most = 60.0,
             .when = "what in fault, rollover"});
    d.field("backlimb", &PredictParams::backlimb,
            {.title = "Dip of the backlimb",
             .help = "Of the folds: from the level beds.",
             .unit = "deg",
             .above = 0.0,
             .at_most = 89.0,
             .when = "what in fault_bend_fold, fault_propagation_fold"});
    d.field("forelimb", &PredictParams::forelimb,
            {.title = "Dip of the forelimb",
             .help = "Of the folds: from the level beds; above 90 it is overturned.",
             .unit = "deg",
             .above = 0.0,
             .at_most = 179.0,
             .when = "what in fault_bend_fold, fault_propagation_fold"});
  }
};

/// "fault", "rollover", ...: in results.
const char* name_of(Prediction what);

}  // namespace recon::inversion
