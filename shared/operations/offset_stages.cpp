#include "shared/operations/offset_stages.h"

#include <cmath>

#include "shared/offset/stepper/stepper.h"

namespace dobra::operations {
namespace {

using base::Result;
using geom::Polyline;

std::vector<Polyline> chains(const std::vector<geom::Segment>& segments) {
  std::vector<Polyline> all;
  for (const geom::Segment& segment : segments) all.push_back({{segment.from, segment.to}, false});
  return all;
}

/// The subdivision is mirrored in y where the curve lies on the left side.
std::vector<Polyline> in_place(std::vector<Polyline> lines, offset::Side side) {
  if (side == offset::Side::RightOfTravel) return lines;
  for (Polyline& line : lines) {
    for (geom::Point& p : line.points) p.y = -p.y;
  }
  return lines;
}

class Builder {
 public:
  Builder(const OffsetCaller& caller, const OffsetPlan& plan) : caller_(caller), plan_(plan) {}

  /// The curves of one base, as far as the steps reach.
  Result<OffsetFamily> run(const OffsetBase& base) {
    OffsetFamily family{.name = base.name, .source = base.source, .bases = base.lines};
    for (const auto& polygon : base.polygons) family.bases.insert(family.bases.end(), polygon.begin(), polygon.end());
    for (const double distance : plan_.distances) {
      DrawnOffset all{.distance = distance};
      for (const Polyline& line : family.bases) {
        if (stage_ || (distance < 0.0 && !line.closed)) continue;
        DOBRA_TRY_VOID(add(base.name, line, distance, all));
      }
      family.curves.push_back(std::move(all));
    }
    return family;
  }
  [[nodiscard]] std::optional<OffsetStage> stage() && { return std::move(stage_); }

 private:
  Result<void> add(const std::string& name, const Polyline& line, double distance, DrawnOffset& all) {
    offset::OffsetOptions options = plan_.curves;
    const bool left = (plan_.side == OffsetSide::Left) != (distance < 0.0);
    options.side = left ? offset::Side::LeftOfTravel : offset::Side::RightOfTravel;
    DOBRA_TRY(offset::stepper::Stepper stepper, offset::stepper::Stepper::start(line, std::abs(distance), options));
    std::optional<offset::stepper::Stepper::Step> last;
    while (!stepper.done() && steps_ < plan_.stop_after) {
      DOBRA_TRY_VOID(caller_.progress.check());
      DOBRA_TRY(last, stepper.step());
      ++steps_;
    }
    if (stepper.done()) {
      const DrawnOffset made = drawn(stepper.result(), line, plan_.arc_tolerance);
      all.length += made.length;
      all.lines.insert(all.lines.end(), made.lines.begin(), made.lines.end());
      return {};
    }
    stage_ = OffsetStage{.steps = steps_, .curve = name, .distance = distance};
    std::vector<geom::Segment> edges;
    for (const topo::EdgeId e : stepper.subdivision().edges()) edges.push_back(stepper.subdivision().segment(e));
    stage_->so_far = in_place(chains(edges), options.side);
    if (!last) return {};  // the steps ended with the curve before
    stage_->regions = last->formed.size();
    stage_->base_segment = chains({line.segment(last->base_segment)}).front();
    stage_->raw_edge = chains({last->edge}).front();
    stage_->deleted = in_place(chains(last->deleted_edges), options.side);
    return {};
  }

  const OffsetCaller& caller_;
  const OffsetPlan& plan_;
  std::size_t steps_ = 0;
  std::optional<OffsetStage> stage_;
};

}  // namespace

Result<StagedOffsets> offset_stages(const OffsetCaller& caller, const std::string& file, const OffsetInput& input,
                                    const OffsetPlan& plan) {
  DOBRA_TRY_VOID(check_signs(input.bases, plan, caller));
  Builder builder(caller, plan);
  StagedOffsets made;
  for (const OffsetBase& base : input.bases) {
    auto family = builder.run(base);
    if (!family) return base::located(family.error(), base::Place{.file = file, .item = base.name});
    made.families.push_back(*std::move(family));
  }
  made.stage = std::move(builder).stage();
  return made;
}

}  // namespace dobra::operations
