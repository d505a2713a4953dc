#include "recon/input/colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "recon/section/palette.h"
#include "shared/scenario/entries.h"

namespace recon::input {

namespace scenario = dobra::scenario;
namespace scene = dobra::scene;

namespace {

using Tables = std::vector<scenario::Table>;

std::string whole_of(const scenario::Table& horizon) {
  const std::string whole = scenario::text_in(horizon, "piece_of");
  return whole.empty() ? scenario::text_in(horizon, "name") : whole;
}

std::set<std::string> horizons_of(const scenario::Document& document) {
  std::set<std::string> names;
  for (const scenario::Table& row : scenario::entries_of(document.input, "horizon")) names.insert(whole_of(row));
  return names;
}

}  // namespace

base::Result<void> take_colors(const SectionInput& input, section::Section& section) {
  scene::ColorTable table = section.colors ? *section.colors : scene::ColorTable{};
  bool changed = false;
  for (const auto list : {&SectionInput::horizons, &SectionInput::units, &SectionInput::pins,
                          &SectionInput::loose_lines, &SectionInput::topographies, &SectionInput::datums}) {
    for (const HorizonInput& entry : input.*list) {
      if (entry.color.empty()) continue;
      const std::optional<scene::Color> color = scene::color_of_text(entry.color);
      if (!color) {
        base::Place place;
        place.item = fmt::format("'{}'", entry.name);
        return base::Error{base::ErrorCode::BadValue,
                           fmt::format("colour = \"{}\" is no colour; write it as \"#1a2b3c\"", entry.color), place};
      }
      const std::string& name = entry.piece_of.empty() ? entry.name : entry.piece_of;
      const auto known = std::find_if(table.entries.begin(), table.entries.end(),
                                      [&](const scene::ColorEntry& other) { return other.name == name; });
      if (known == table.entries.end())
        table.entries.push_back({.name = name, .color = color});
      else
        known->color = color;
      changed = true;
    }
  }
  if (changed) section.colors = std::make_shared<const scene::ColorTable>(std::move(table));
  return {};
}

std::set<std::string> horizons_gone(const scenario::Document& before, const scenario::Document& after) {
  const std::set<std::string> were = horizons_of(before), are = horizons_of(after);
  std::set<std::string> gone;
  if (are.size() < were.size())
    std::set_difference(were.begin(), were.end(), are.begin(), are.end(), std::inserter(gone, gone.end()));
  return gone;
}

scenario::Document with_colors_kept(scenario::Document document, const section::Section& section,
                                    const std::set<std::string>& gone) {
  const scenario::Value* rows = document.input.find("horizon");
  if (gone.empty() || rows == nullptr) return document;
  const std::set<std::string> left = horizons_of(document);
  std::set<std::string> behind;
  bool found = false;
  for (const std::vector<const section::Horizon*>& pieces : section::whole_horizons(section)) {
    const std::string& name = whole_name(*pieces.front());
    if (found) behind.insert(name);
    found = found || (gone.contains(name) && !left.contains(name));
  }
  const section::Palette palette(section);
  Tables horizons = std::get<Tables>(*rows);
  for (scenario::Table& horizon : horizons) {
    const std::string name = whole_of(horizon);
    const bool says = section.colors && scene::entry_for(*section.colors, name, name) != nullptr;
    if (says || !behind.contains(name)) continue;
    const scene::Color color = palette.of(name).fill;
    horizon.set("colour", fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue));
  }
  document.input.set("horizon", std::move(horizons));
  return document;
}

}  // namespace recon::input
