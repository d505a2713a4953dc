#include "recon/core/section.h"

namespace recon::core {

const Horizon* find_horizon(const Section& section, const std::string& name) {
  for (const Horizon& horizon : section.horizons) {
    if (horizon.name == name) return &horizon;
  }
  return nullptr;
}

const Horizon* find_horizon(const Section& section, HorizonId id) {
  for (const Horizon& horizon : section.horizons) {
    if (horizon.id == id) return &horizon;
  }
  return nullptr;
}

std::vector<std::string> horizon_names(const Section& section) {
  std::vector<std::string> names;
  names.reserve(section.horizons.size());
  for (const Horizon& horizon : section.horizons) names.push_back(horizon.name);
  return names;
}

base::Place place_at(geom::Point p, std::string item) {
  base::Place place;
  place.item = std::move(item);
  place.x = p.x;
  place.y = p.y;
  return place;
}

geom::Box box_of(const Section& section) {
  geom::Box box;
  for (const Horizon& horizon : section.horizons) box.add(horizon.line.box());
  return box;
}

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

}  // namespace recon::core
