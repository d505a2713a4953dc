#include "recon/inversion/shear_fit.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "recon/faults/cutoffs.h"
#include "recon/inversion/limits.h"
#include "recon/kinematics/block_map.h"
#include "recon/kinematics/shear.h"
#include "shared/geom/place.h"

namespace recon::inversion {

namespace {

/// Where slip is measured: at the uppermost cutoff of the hanging wall.
double measured_at(const section::Section& section, const std::vector<faults::Fault>& all, const faults::Fault& fault) {
  double arc = geom::length(fault.path.line);
  for (const faults::FaultCutoffs& cutoffs : faults::cutoffs_of(section, all, {})) {
    if (cutoffs.fault != fault.name) continue;
    for (const faults::CutoffPair& pair : cutoffs.pairs) {
      if (pair.hanging_wall) return pair.hanging_wall->arc;
    }
  }
  return arc;
}

}  // namespace

base::Result<ShearTask> shear_task(const section::Section& section, const std::vector<BedShape>& beds,
                                   const InvertParams& params) {
  DOBRA_TRY(const std::vector<faults::Fault> all, faults::faults_of(section, {}));
  DOBRA_TRY(const faults::Fault* fault, faults::find_fault(all, params.fault));
  if (fault->undecided) return *fault->undecided;
  const kinematics::FaultPath path = fault->path;
  if (path.level) {
    return base::Error{
        base::ErrorCode::BadSection,
        fmt::format("the ends of fault '{}' are equally high, so that up is neither way along it", fault->name),
        place_at(path.line.points.front(), "fault")};
  }
  const double arc = measured_at(section, all, *fault);
  geom::Box box;
  for (const BedShape& bed : beds) {
    for (const geom::Point p : bed.points) box.add(p);
  }
  ShearTask task;
  task.unknowns.resize(2);
  DOBRA_TRY(task.unknowns[0], unknown_of("angle", "deg", params.angle, {-60.0, 60.0}));
  DOBRA_TRY(task.unknowns[1], unknown_of("slip", "m", params.slip, {-0.5 * box.width(), 0.5 * box.width()}));
  task.model = [path, arc](std::span<const double> v, Precision) -> std::optional<Restore> {
    const base::Angle angle = base::Angle::from_degrees(v[0]);
    const auto h = kinematics::shear_heave(path, angle, arc, {kinematics::Measure::Slip, -v[1]});
    if (!h) return std::nullopt;
    const auto map = kinematics::shear_over(path, angle, *h);
    if (!map) return std::nullopt;
    return [path, block = kinematics::BlockMap(*map)](geom::Point p) {
      return wall_of(path, p) == kinematics::Wall::Hanging ? block.forward(p) : p;
    };
  };
  return task;
}

}  // namespace recon::inversion
