#include "recon/space/surfaces.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/input/import.h"
#include "shared/surf/loft/joined.h"

namespace recon::space {

namespace loft = dobra::surf::loft;
using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

SurfaceRow row_of(const loft::NamedSurface& surface, const loft::Surfaces& all) {
  SurfaceRow row{surface.name, surface.kind, loft::measures(surface), surface.patches.size(), 0, {}};
  row.triangles = loft::joined(surface, all.size).triangles.size();
  for (const loft::Mistie& mistie : all.misties) {
    if (mistie.line == surface.name) row.misties.push_back(mistie);
  }
  return row;
}

Result<std::vector<VolumeRow>> volumes_of(MadeSurfaces& made, const base::Progress& progress) {
  std::vector<std::size_t> horizons;
  for (std::size_t i = 0; i < made.rows.size(); ++i) {
    if (made.rows[i].kind == loft::LineKind::Horizon) horizons.push_back(i);
  }
  std::stable_sort(horizons.begin(), horizons.end(), [&](std::size_t a, std::size_t b) {
    return made.rows[a].measures.mean_z > made.rows[b].measures.mean_z;
  });
  std::vector<VolumeRow> volumes;
  for (std::size_t k = 1; k < horizons.size(); ++k) {
    const auto &upper = made.made.surfaces[horizons[k - 1]], &lower = made.made.surfaces[horizons[k]];
    DOBRA_TRY(loft::Volume volume, loft::volume_between(upper, lower, made.made.surfaces, progress));
    VolumeRow row{upper.name, lower.name, std::move(volume)};
    made.made.findings.insert(made.made.findings.end(), row.volume.findings.begin(), row.volume.findings.end());
    volumes.push_back(std::move(row));
  }
  return volumes;
}

/// A line called "A (1)" alone is a piece of A where other sections have an A and its own has none.
std::vector<loft::Finding> join_single_pieces(std::vector<loft::Section>& sections) {
  std::vector<loft::Finding> findings;
  const auto has = [](const loft::Section& section, const std::string& name) {
    return std::any_of(section.lines.begin(), section.lines.end(),
                       [&](const loft::SectionLine& line) { return line.name == name; });
  };
  const std::vector<loft::Section> given = sections;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    const loft::Section& section = given[s];
    for (loft::SectionLine& line : sections[s].lines) {
      const auto numbered = input::numbered_name(line.name);
      if (!numbered || has(section, numbered->first)) continue;
      if (std::none_of(given.begin(), given.end(), [&](const auto& other) { return has(other, numbered->first); }))
        continue;
      const std::string item = fmt::format("section '{}'", section.name);
      const auto at = section.trace.in_space(line.line.points.front());
      findings.push_back({"piece_joined",
                          fmt::format("{}: '{}' is taken for a piece of {} '{}', which other sections have; give it "
                                      "another name if it is none",
                                      item, line.name, loft::kind_name(line.kind), numbered->first),
                          {.item = item, .x = at.x, .y = at.y, .z = at.z}});
      line.name = numbered->first;
    }
  }
  return findings;
}

}  // namespace

Result<MadeSurfaces> make_surfaces(const PlacedSections& placed, const SurfaceParams& params,
                                   const base::Progress& progress) {
  std::vector<loft::Section> sections;
  for (const PlacedSection& one : placed.sections) sections.push_back(lines_of(one));
  std::vector<loft::Finding> joined = join_single_pieces(sections);
  loft::ThroughOptions options;
  options.ties.most = params.mistie_tolerance;
  options.rows = static_cast<std::size_t>(params.rows);
  options.at_fault = params.at_fault;
  MadeSurfaces made;
  DOBRA_TRY(made.made, loft::surfaces_through(std::move(sections), options));
  if (made.made.surfaces.empty()) {
    std::vector<loft::Finding> findings = made.made.findings;
    // Ends that were moved to where they belong are no reason.
    std::erase_if(findings, [](const loft::Finding& f) { return f.code == "end_moved"; });
    if (findings.empty() || findings.front().code == "single") {
      std::string message = "the sections have no line in common; call what belongs together by one name";
      if (findings.empty()) return Error{ErrorCode::BadSection, std::move(message)};
      return Error{ErrorCode::BadSection, message + ": " + findings.front().message, findings.front().place};
    }
    std::string why = findings.front().message;
    const std::string item = findings.front().place.item + ": ";  // which the place says
    if (why.starts_with(item)) why.erase(0, item.size());
    return Error{ErrorCode::BadSection, fmt::format("no surface goes through the sections: {}", why),
                 findings.front().place};
  }
  made.made.findings.insert(made.made.findings.end(), joined.begin(), joined.end());
  for (const loft::NamedSurface& surface : made.made.surfaces) {
    DOBRA_TRY_VOID(progress.check());
    made.rows.push_back(row_of(surface, made.made));
    if (!params.contours) continue;
    DOBRA_TRY(std::vector<loft::Contour> lines, loft::contours(surface, *params.contours));
    made.contours.push_back(std::move(lines));
  }
  DOBRA_TRY(made.volumes, volumes_of(made, progress));
  return made;
}

}  // namespace recon::space
