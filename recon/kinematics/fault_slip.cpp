#include "recon/kinematics/fault_slip.h"

#include <cmath>

namespace recon::kinematics {

base::Result<maps::ColumnMap> flexural_slip(const FaultPath& path, double slip) {
  const bool turned = path.hanging == Side::Left;
  const geom::Polyline base = turned ? geom::reversed(path.line) : path.line;
  const double travel = turned ? -slip : slip;
  auto columns = maps::Columns::along(base);
  if (!columns) {
    base::Error error = columns.error();
    error.code = base::ErrorCode::CannotRestore;
    return error;
  }
  // Both pins lie on the straight piece that the block comes from, so that beds of all depths go equally far.
  const double length = geom::length(base);
  const double pin = travel > 0.0 ? -travel : length - travel;
  return maps::ColumnMap::slip(*columns, pin, *columns, pin + travel);
}

}  // namespace recon::kinematics
