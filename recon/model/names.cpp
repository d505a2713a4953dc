#include "recon/model/names.h"

#include <algorithm>

#include "recon/faults/blocks.h"

namespace recon::model {
namespace {

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// Without any there are no blocks, and their outline, which costs more than all else here, is not needed.
bool has_faults(const section::Section& section) {
  return std::any_of(section.lines.begin(), section.lines.end(),
                     [](const section::SectionLine& line) { return line.kind == section::LineKind::Fault; });
}

std::vector<std::string> block_names(const section::Section& section) {
  std::vector<std::string> names;
  if (!has_faults(section)) return names;
  const auto faults = faults::faults_of(section, {});
  if (!faults || faults->empty()) return names;
  const auto blocks = faults::Blocks::make(section, *faults, {});
  if (!blocks) return names;
  for (const faults::Block& block : blocks->all()) add_once(block.name, names);
  for (const faults::Block& block : blocks->all()) add_once(block.part_of, names);
  return names;
}

std::string block_at(const section::Section& section, geom::Point at) {
  if (!has_faults(section)) return {};
  const auto faults = faults::faults_of(section, {});
  if (!faults || faults->empty()) return {};
  const auto blocks = faults::Blocks::make(section, *faults, {});
  return blocks ? blocks->all()[blocks->at(at).index()].name : std::string();
}

}  // namespace

std::string name_at(const Model& model, const std::string& what, const std::optional<dobra::scene::Pick>& line,
                    geom::Point at) {
  const section::Section& section = current_section(model);
  if (what == "block") return block_at(section, at);
  if (!line) return {};
  if (what == "horizon" && line->layer.starts_with("horizon_") && line->id < section.horizons.size())
    return whole_name(section.horizons[line->id]);
  if (!line->layer.starts_with("line_") || line->id >= section.lines.size()) return {};
  const section::SectionLine& found = section.lines[line->id];
  if (what == "fault" && found.kind == section::LineKind::Fault) return whole_name(found);
  if (what == "datum" && found.kind == section::LineKind::Datum) return found.name;
  return {};
}

std::vector<std::string> names_of(const Model& model, const std::string& what) {
  const section::Section& section = current_section(model);
  if (what == "block") return block_names(section);
  std::vector<std::string> names;
  if (what == "horizon") {
    for (const section::Horizon& horizon : section.horizons) add_once(whole_name(horizon), names);
  }
  if (what == "fault") {
    for (const section::SectionLine& line : section.lines) {
      if (line.kind == section::LineKind::Fault) add_once(whole_name(line), names);
    }
  }
  if (what == "datum") {
    for (const section::SectionLine& line : section.lines) {
      if (line.kind == section::LineKind::Datum) add_once(line.name, names);
    }
  }
  return names;
}

}  // namespace recon::model
