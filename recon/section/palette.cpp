#include "recon/section/palette.h"

#include <algorithm>

namespace recon::section {

namespace scene = dobra::scene;

std::vector<std::vector<const Horizon*>> whole_horizons(const Section& section) {
  std::vector<std::vector<const Horizon*>> wholes;
  for (const Horizon& horizon : section.horizons) {
    const auto same = [&](const auto& whole) { return whole_name(*whole.front()) == whole_name(horizon); };
    const auto found = std::find_if(wholes.begin(), wholes.end(), same);
    if (found != wholes.end())
      found->push_back(&horizon);
    else
      wholes.push_back({&horizon});
  }
  return wholes;
}

Palette::Palette(const Section& section) {
  for (const Horizon& horizon : section.horizons) horizons_.emplace(whole_name(horizon), horizons_.size());
  std::vector<std::string> names;
  for (const Unit& unit : section.units) names.push_back(unit.piece_of.empty() ? unit.name : unit.piece_of);
  wholes_ = scene::whole_names(names);
  for (const Unit& unit : section.units) {
    if (!unit.piece_of.empty()) wholes_[unit.id.index()] = unit.piece_of;
  }
  numbers_ = scene::numbers_of(wholes_);
}

scene::UnitStyle Palette::of(const std::string& whole_name) const {
  const auto found = horizons_.find(whole_name);
  return scene::unit_style(found == horizons_.end() ? 0 : found->second);
}

scene::UnitStyle Palette::of(UnitId unit) const { return scene::unit_style(numbers_[unit.index()]); }

}  // namespace recon::section
