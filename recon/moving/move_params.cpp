#include "recon/moving/move_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace recon::moving {

namespace {

base::Error bad(std::string message) { return {base::ErrorCode::BadValue, std::move(message), {}}; }

}  // namespace

const char* method_name(MoveMethod method) {
  constexpr std::array<const char*, 7> names{
      "rigid",    "shear",        "fault_parallel_flow", "fault_bend_fold", "fault_propagation_fold",
      "trishear", "flexural_slip"};
  return names[static_cast<std::size_t>(method)];
}

base::Result<void> check_params(const MoveParams& params) {
  const int given = int{params.slip.has_value()} + int{params.heave.has_value()} + int{params.throw_.has_value()} +
                    int{!params.close.empty()};
  const MoveMethod method = *params.method;
  const bool turns = method == MoveMethod::Rigid && params.angle;
  if (given > 1 || (given == 0 && !turns))
    return bad(fmt::format("give one of slip, heave, throw and close, not {}", given == 0 ? "none" : "several"));
  if (turns && !params.pivot) return bad("a turn by 'angle' needs the point that it is about; give 'pivot' too");
  const MoveParams unsaid;
  const auto useless = [&](bool given_key, const char* key,
                           std::initializer_list<MoveMethod> of) -> base::Result<void> {
    if (!given_key || std::find(of.begin(), of.end(), method) != of.end()) return {};
    std::string takes;
    for (const MoveMethod one : of) takes += (takes.empty() ? "" : " and ") + std::string(method_name(one));
    return bad(fmt::format("'{}' is of {}; the method {} has no use for it, so leave it out", key, takes,
                           method_name(method)));
  };
  using enum MoveMethod;
  DOBRA_TRY_VOID(useless(params.angle.has_value(), "angle", {Rigid, Shear}));
  DOBRA_TRY_VOID(useless(params.pivot.has_value(), "pivot", {Rigid}));
  DOBRA_TRY_VOID(useless(!params.at.empty(), "at", {Shear, FaultParallelFlow, FlexuralSlip}));
  DOBRA_TRY_VOID(useless(params.apical.has_value(), "apical", {Trishear}));
  DOBRA_TRY_VOID(useless(params.propagation != unsaid.propagation, "propagation", {Trishear}));
  DOBRA_TRY_VOID(useless(params.concentration != unsaid.concentration, "concentration", {Trishear}));
  DOBRA_TRY_VOID(useless(params.ramp.has_value(), "ramp", {FaultPropagationFold}));
  DOBRA_TRY_VOID(useless(params.bedding.has_value(), "bedding", {FaultBendFold}));
  DOBRA_TRY_VOID(useless(params.slip_before != 0.0, "slip_before", {FaultBendFold}));
  DOBRA_TRY_VOID(
      useless(!params.block.empty(), "block", {Rigid, Shear, FaultParallelFlow, FaultBendFold, FlexuralSlip}));
  if (params.pivot && !turns)
    return bad("'pivot' is the point that a rigid block turns about; give the turn as 'angle' too, or leave it out");
  if (method == Trishear && !params.apical) return bad("trishear needs the full angle of its triangle; give 'apical'");
  return {};
}

}  // namespace recon::moving
