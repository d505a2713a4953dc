#include "shared/operations/offset_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "shared/base/text.h"
#include "shared/offset/offset.h"

namespace dobra::operations {
namespace {

using base::Result;

constexpr std::array join_names{"mitre", "bisector", "round", "bevel"};

/// The distances that are asked for.
Result<std::vector<double>> distances_of(const OffsetParams& params, const OffsetCaller& caller) {
  if (!params.distances.empty()) {
    if (!params.distance && !params.count && !params.factor) return params.distances;
    const std::string other = caller.name(params.distance ? "distance" : params.count ? "count" : "factor");
    return caller.refuse(fmt::format("{} excludes {}; leave one out", caller.name("distances"), other));
  }
  if (!params.distance) {
    return caller.refuse(fmt::format("no distance is given; give {} (with {}, {}), or {}", caller.set("distance", "D"),
                                     caller.set("count", "N"), caller.set("factor", "F"),
                                     caller.set("distances", "a,b,c")));
  }
  offset::DistanceRule rule;
  rule.count = static_cast<std::size_t>(params.count.value_or(1));
  rule.initial = std::abs(*params.distance);
  rule.factor = params.factor.value_or(1.0);
  auto distances = offset::distances(rule);
  if (!distances) {
    const std::string names =
        fmt::format("{}, {}, {}", caller.name("count"), caller.name("distance"), caller.name("factor"));
    return base::located(distances.error(), base::Place{.item = names});
  }
  for (double& d : *distances) d = std::copysign(d, *params.distance);
  return distances;
}

/// The construction is that of curves on one side, each by itself.
Result<void> check_stages(const OffsetParams& params, const OffsetCaller& caller) {
  if (params.stop_after == 0) return {};
  const auto has_no_stages = [&](const std::string& what) {
    return caller.refuse(fmt::format("{} shows how the curves on one side are made, step by step; leave out {}",
                                     caller.name("stop_after"), what));
  };
  if (params.side == OffsetSide::Both) return has_no_stages(caller.set("side", "both"));
  if (params.dissolve) return has_no_stages(caller.name("dissolve"));
  if (params.untreated) return has_no_stages(caller.name("untreated"));
  if (params.verify) return has_no_stages(caller.name("verify"));
  if (params.ends && *params.ends != offset::Ends::Paper) return has_no_stages(caller.name("ends"));
  return {};
}

/// Parameters that would have no effect are refused.
Result<void> check_together(const OffsetParams& params, const OffsetPlan& plan, const OffsetCaller& caller) {
  const bool both = plan.side == OffsetSide::Both;
  const bool areas = both || params.dissolve;
  const auto name = [&](const char* key) { return caller.name(key); };
  const std::string both_sides = caller.set("side", "both");
  if (params.mitre_limit && params.join != offset::Join::Mitre) {
    return caller.refuse(fmt::format("{} belongs to {}, not to {}; leave one out", name("mitre_limit"),
                                     caller.set("join", "mitre"),
                                     caller.set("join", join_names[static_cast<std::size_t>(params.join)])));
  }
  if (params.caps && (!areas || (plan.side && !both)))
    return caller.refuse(fmt::format("{0} belongs to {1}; give both, or leave {0} out", name("caps"), both_sides));
  if (areas && params.ends)
    return caller.refuse(
        fmt::format("{} is for curves on one side; with both sides give {}", name("ends"), name("caps")));
  if (areas && params.pieces)
    return caller.refuse(fmt::format("{} is for curves on one side of a line; leave it out", name("pieces")));
  if (areas && params.untreated)
    return caller.refuse(
        fmt::format("{} curves have no area; leave out {} and {}", name("untreated"), both_sides, name("dissolve")));
  const bool negative = std::any_of(plan.distances.begin(), plan.distances.end(), [](double d) { return d < 0.0; });
  if (negative && plan.side) {
    return caller.refuse(fmt::format("{}, {}: one below 0 says that polygons shrink; it must be above 0 with {}",
                                     name("distance"), name("distances"), name("side")));
  }
  return check_stages(params, caller);
}

}  // namespace

std::string OffsetCaller::name(const std::string& key) const {
  if (speaks == Speaks::Keys) return key;
  std::string option = "--" + key;
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

std::string OffsetCaller::set(const std::string& key, const std::string& value) const {
  return fmt::format("{}{}{}", name(key), speaks == Speaks::Keys ? " = " : " ", value);
}

std::string OffsetCaller::length(double value) const {
  return base::number_text(value) + (speaks == Speaks::Keys ? " m" : "");
}

base::Error OffsetCaller::refuse(std::string message) const {
  return {speaks == Speaks::Keys ? base::ErrorCode::BadValue : base::ErrorCode::BadUsage, std::move(message)};
}

Result<OffsetPlan> offset_plan(const OffsetParams& params, const OffsetCaller& caller) {
  OffsetPlan plan;
  DOBRA_TRY(plan.distances, distances_of(params, caller));
  plan.side = params.side;
  plan.curves.join = params.join;
  plan.curves.ends = params.ends.value_or(offset::Ends::Trimmed);
  plan.curves.keep = params.pieces.value_or(offset::Keep::LongestPiece);
  if (params.untreated) plan.curves.treatment = offset::Treatment::Untreated;
  plan.curves.mitre_limit = params.mitre_limit.value_or(plan.curves.mitre_limit);
  plan.cap = params.caps.value_or(offset::Cap::Round);
  plan.arc_tolerance = params.arc_tolerance;
  plan.dissolve = params.dissolve ? Dissolve::Yes : Dissolve::No;
  plan.closing = params.closed ? Closing::Closed : Closing::AsGiven;
  plan.verify = params.verify;
  plan.curve = params.curve;
  plan.stop_after = static_cast<std::size_t>(params.stop_after);
  DOBRA_TRY_VOID(check_together(params, plan, caller));
  return plan;
}

}  // namespace dobra::operations
