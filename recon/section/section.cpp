#include "recon/section/section.h"

#include <array>

namespace recon::section {

const std::string& whole_name(const Horizon& horizon) {
  return horizon.piece_of.empty() ? horizon.name : horizon.piece_of;
}

const std::string& whole_name(const SectionLine& line) { return line.piece_of.empty() ? line.name : line.piece_of; }

const char* hanging_wall_name(HangingWall side) {
  constexpr std::array<const char*, 5> names{"auto", "left", "right", "above", "below"};
  return names[static_cast<std::size_t>(side)];
}

const Horizon* first_piece(const Section& section, const std::string& whole) {
  for (const Horizon& horizon : section.horizons) {
    if (whole_name(horizon) == whole) return &horizon;
  }
  return nullptr;
}

bool is_outermost(const Section& section, const Horizon& horizon, LineEnd end) {
  if (horizon.piece_of.empty()) return true;
  for (const Horizon& other : section.horizons) {
    if (other.piece_of != horizon.piece_of) continue;
    if (end == LineEnd::First && other.line.points.front().x < horizon.line.points.front().x) return false;
    if (end == LineEnd::Last && other.line.points.back().x > horizon.line.points.back().x) return false;
  }
  return true;
}

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

geom::Box box_of(const Section& section) {
  geom::Box box;
  for (const Horizon& horizon : section.horizons) box.add(horizon.line.box());
  for (const SectionLine& line : section.lines) box.add(line.line.box());
  for (const Unit& unit : section.units) box.add(unit.contour.box());
  for (const Marker& marker : section.markers) box.add(geom::box_of(marker.points));
  return box;
}

const char* kind_name(LineKind kind) {
  switch (kind) {
    case LineKind::Pin:
      return "pin";
    case LineKind::Loose:
      return "loose";
    case LineKind::Topography:
      return "topography";
    case LineKind::Datum:
      return "datum";
    case LineKind::Eroded:
      return "eroded";
    case LineKind::Fault:
      break;
  }
  return "fault";
}

}  // namespace recon::section
