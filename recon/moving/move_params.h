#pragma once
// Parameters of the step `move`: a block moved along a fault. Page: docs/algorithms/move.md

#include <optional>
#include <string>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/geom/point.h"
#include "shared/scenario/field.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::moving {

enum class MoveMethod { Rigid, Shear, FaultParallelFlow, FaultBendFold, FaultPropagationFold, Trishear, FlexuralSlip };
/// Forward: from the earlier to the later state; Restore: back.
enum class Direction { Restore, Forward };
/// Where up is along a fault whose ends are equally high.
enum class Towards { Auto, PlusX, MinusX };

/// "rigid", "shear", ...: in results.
const char* method_name(MoveMethod method);

struct MoveParams {
  std::string fault;
  std::optional<MoveMethod> method;
  Direction direction = Direction::Restore;
  std::optional<double> slip, heave, throw_;
  std::vector<std::string> close;
  std::string at;
  std::vector<std::string> block;
  std::optional<base::Angle> angle;
  std::optional<geom::Point> pivot;
  std::optional<base::Angle> apical;
  double propagation = 1.5;
  double concentration = 1.0;
  std::optional<base::Angle> ramp, bedding;
  double slip_before = 0.0;
  Towards towards = Towards::Auto;
  std::optional<double> tolerance;
  template <class D>
  static void describe(D& d) {
    using dobra::scenario::Presence;
    d.field(
        "fault", &MoveParams::fault,
        {.title = "Fault", .help = "Along which the block moves.", .names = "fault", .presence = Presence::Required});
    d.choice("method", &MoveParams::method,
             {"rigid", "shear", "fault_parallel_flow", "fault_bend_fold", "fault_propagation_fold", "trishear",
              "flexural_slip"},
             {.title = "Method",
              .help = "rigid: along the straight line from end to end of the fault, or turned about a pivot; shear: "
                      "inclined simple shear; fault_parallel_flow and flexural_slip: along parallels of the fault, the "
                      "latter keeps bed lengths; the folds: beds keep their thickness over the bends, or in front of "
                      "the tip; trishear: slip dies out in a triangle in front of the tip.",
              .presence = Presence::Required});
    d.choice("direction", &MoveParams::direction, {"restore", "forward"},
             {.title = "Direction", .help = "restore: to an earlier state; forward: to a later one."});
    describe_amount(d);
    d.field("block", &MoveParams::block,
            {.title = "Blocks",
             .help = "That move, or groups of them; by default all of the hanging wall.",
             .names = "block",
             .when = "method in rigid, shear, fault_parallel_flow, fault_bend_fold, flexural_slip"});
    d.field("angle", &MoveParams::angle,
            {.title = "Angle",
             .help = "Of shear: its direction from the vertical, positive leaning to +x; rigid: anticlockwise turn.",
             .unit = "deg",
             .at_least = -180.0,
             .at_most = 180.0,
             .when = "method in rigid, shear"});
    d.field("pivot", &MoveParams::pivot,
            {.title = "Pivot",
             .help = "About which a rigid block turns.",
             .unit = "m",
             .when = "method = rigid and angle is set"});
    describe_folds(d);
    d.choice("towards", &MoveParams::towards, {"auto", "x", "-x"},
             {.title = "Up along the fault",
              .help = "Of a fault with level ends: the way that its hanging wall goes for a slip above 0."});
    d.field("tolerance", &MoveParams::tolerance,
            {.title = "Tolerance of cutoffs",
             .help = "How far ends of lines are taken to the fault; by default 0.005 of the section's diagonal.",
             .unit = "m",
             .above = 0.0});
  }

 private:
  template <class D>
  static void describe_amount(D& d) {
    d.field("slip", &MoveParams::slip,
            {.title = "Slip",
             .help = "Of the hanging wall along the fault; positive raises it.",
             .unit = "m",
             .other_than = 0.0});
    d.field("heave", &MoveParams::heave,
            {.title = "Heave",
             .help = "Instead: horizontally; positive raises the hanging wall.",
             .unit = "m",
             .other_than = 0.0});
    d.field("throw", &MoveParams::throw_,
            {.title = "Throw",
             .help = "Instead: vertically; positive raises the hanging wall.",
             .unit = "m",
             .other_than = 0.0});
    d.field("close", &MoveParams::close,
            {.title = "Close",
             .help = "Instead: horizons whose cutoffs are to meet; of several by least squares.",
             .names = "horizon"});
    d.field("at", &MoveParams::at,
            {.title = "Measured at",
             .help = "Horizon at whose cutoff in the hanging wall the slip is measured; by default the uppermost.",
             .names = "horizon",
             .when = "method in shear, fault_parallel_flow, flexural_slip"});
  }
  template <class D>
  static void describe_folds(D& d) {
    d.field("apical", &MoveParams::apical,
            {.title = "Apical angle",
             .help = "Of trishear: the full angle of the triangle.",
             .unit = "deg",
             .above = 0.0,
             .at_most = 179.0,
             .when = "method = trishear"});
    d.field("propagation", &MoveParams::propagation,
            {.title = "P/S",
             .help = "Of trishear: how far the tip goes a metre of slip.",
             .at_least = 0.0,
             .when = "method = trishear"});
    d.field("concentration", &MoveParams::concentration,
            {.title = "Concentration",
             .help = "Of trishear: 1 shears evenly, more gathers strain in the middle of the triangle.",
             .above = 0.0,
             .when = "method = trishear"});
    d.field("ramp", &MoveParams::ramp,
            {.title = "Ramp angle",
             .help = "Of a fault-propagation fold whose fault has its flat alone yet.",
             .unit = "deg",
             .above = 0.0,
             .at_most = 60.0,
             .when = "method = fault_propagation_fold"});
    d.field("bedding", &MoveParams::bedding,
            {.title = "Bedding",
             .help = "Of a fault-bend fold: direction of the undeformed beds; by default along the lowest segment.",
             .unit = "deg",
             .at_least = -90.0,
             .at_most = 90.0,
             .when = "method = fault_bend_fold"});
    d.field("slip_before", &MoveParams::slip_before,
            {.title = "Slip before",
             .help = "Of a fault-bend fold: slip that the fault had at the earlier of the two states.",
             .unit = "m",
             .at_least = 0.0,
             .when = "method = fault_bend_fold"});
  }
};

/// Combinations that no field can refuse by itself.
/// @error BadValue: none or several of slip, heave, throw and close; what the method has no use for.
base::Result<void> check_params(const MoveParams& params);

}  // namespace recon::moving
