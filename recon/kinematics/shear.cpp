#include "recon/kinematics/shear.h"

#include <cmath>

namespace recon::kinematics {

base::Result<maps::SectionMap> shear_over(const FaultPath& path, base::Angle angle, double h) {
  DOBRA_TRY(maps::ShearMap map, maps::ShearMap::make(path.line, path.line, angle, {}, {h, 0.0}, {}, "fault"));
  return maps::SectionMap(std::move(map));
}

base::Result<double> shear_heave(const FaultPath& path, base::Angle angle, double arc, Amount amount) {
  DOBRA_TRY(const double goal, arc_after(path, arc, amount));
  const geom::Vector way = point_at(path, goal) - point_at(path, arc);
  return way.x - std::tan(angle.radians()) * way.y;
}

}  // namespace recon::kinematics
