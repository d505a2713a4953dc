#pragma once
// The usual colours of a section, before a table of colours is taken.

#include <map>
#include <string>
#include <vector>

#include "recon/section/section.h"

namespace recon::section {

/// Horizons with their pieces, each list in the order of the section.
std::vector<std::vector<const Horizon*>> whole_horizons(const Section& section);

/// How the horizons of a section, the rock below each, and its polygons are drawn: horizons by their places in the
/// section, polygons by those of their names; pieces of one horizon or unit alike.
class Palette {
 public:
  explicit Palette(const Section& section);

  /// Of all pieces of a horizon; the first style for what is none.
  [[nodiscard]] dobra::scene::UnitStyle of(const std::string& whole_name) const;
  [[nodiscard]] dobra::scene::UnitStyle of(UnitId unit) const;
  /// The unit that a polygon is a piece of: its own name if it is whole.
  [[nodiscard]] const std::string& whole_of(UnitId unit) const { return wholes_[unit.index()]; }

 private:
  std::map<std::string, std::size_t> horizons_;
  std::vector<std::string> wholes_;  ///< Of polygons.
  std::vector<std::size_t> numbers_;
};

}  // namespace recon::section
