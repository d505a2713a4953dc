#include "recon/section/convention.h"

namespace recon::section {

double metres_per_unit(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Kilometre:
      return 1000.0;
    case LengthUnit::Foot:
      return 0.3048;
    case LengthUnit::Metre:
      break;
  }
  return 1.0;
}

geom::Point to_section(geom::Point in_file, const Convention& convention) {
  const double factor = metres_per_unit(convention.unit);
  const double z = convention.y_axis == VerticalAxis::Up ? in_file.y : convention.reference - in_file.y;
  return {factor * in_file.x, factor * (z / convention.exaggeration)};
}

geom::Point from_section(geom::Point in_section, const Convention& convention) {
  const double factor = metres_per_unit(convention.unit);
  const double z = in_section.y / factor * convention.exaggeration;
  return {in_section.x / factor, convention.y_axis == VerticalAxis::Up ? z : convention.reference - z};
}

}  // namespace recon::section
