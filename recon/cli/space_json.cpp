#include "recon/cli/space_json.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/space/cut.h"
#include "shared/cli/findings.h"

namespace recon::cli {

namespace {

using SpaceJson = nlohmann::ordered_json;
namespace loft = dobra::surf::loft;

/// Of the sections as they were read, then of the surfaces through them.
std::vector<loft::Finding> findings_of_surfaces(const model::Model& model) {
  std::vector<loft::Finding> findings;
  const auto add = [&](const std::vector<loft::Finding>& more) {
    findings.insert(findings.end(), more.begin(), more.end());
  };
  if (const auto* placed = model.findings.get<space::PlacedSections>()) add(placed->findings);
  if (const auto* made = model.findings.get<space::MadeSurfaces>()) add(made->made.findings);
  return findings;
}

}  // namespace

SpaceJson surfaces_json(const model::Model& model) {
  const auto& made = *model.findings.get<space::MadeSurfaces>();
  SpaceJson json;
  SpaceJson surfaces = SpaceJson::array(), volumes = SpaceJson::array();
  for (const space::SurfaceRow& row : made.rows) {
    SpaceJson misties = SpaceJson::array();
    for (const loft::Mistie& m : row.misties)
      misties.push_back({{"sections", {made.made.sections[m.first].name, made.made.sections[m.second].name}},
                         {"at", {m.at.x, m.at.y, m.at.z}},
                         {"difference", m.difference}});
    surfaces.push_back({{"name", row.name},
                        {"kind", loft::kind_name(row.kind)},
                        {"area", row.measures.area},
                        {"dip_mean", row.measures.dip_mean.degrees()},
                        {"misties", std::move(misties)},
                        {"map_area", row.measures.plan},
                        {"pieces", row.pieces},
                        {"triangles", row.triangles}});
  }
  for (const space::VolumeRow& row : made.volumes)
    volumes.push_back({{"upper", row.upper},
                       {"lower", row.lower},
                       {"volume", row.volume.value},
                       {"map_area", row.volume.plan},
                       {"exact", row.volume.exact},
                       {"below", row.volume.below},
                       {"unsure", row.volume.unsure}});
  json["surfaces"] = std::move(surfaces);
  json["volumes"] = std::move(volumes);
  json["findings"] = dobra::cli::findings_json(findings_of_surfaces(model), {});
  return json;
}

std::string surfaces_table(const model::Model& model) {
  const auto& made = *model.findings.get<space::MadeSurfaces>();
  std::string text =
      fmt::format("{:<20} {:<8} {:>14} {:>10} {:>7}\n", "surface", "kind", "area [m2]", "dip [deg]", "pieces");
  for (const space::SurfaceRow& row : made.rows)
    text += fmt::format("{:<20} {:<8} {:>14.6g} {:>10.2f} {:>7}\n", row.name, loft::kind_name(row.kind),
                        row.measures.area, row.measures.dip_mean.degrees(), row.pieces);
  for (const loft::Mistie& m : made.made.misties) {
    if (std::abs(m.difference) <= 1e-9 * made.made.size) continue;
    text += fmt::format("mis-tie of {} at ({:.6g}, {:.6g}): '{}' is {:.6g} m {} '{}'; shared out\n", m.line, m.at.x,
                        m.at.y, made.made.sections[m.first].name, std::abs(m.difference),
                        m.difference > 0.0 ? "above" : "below", made.made.sections[m.second].name);
  }
  for (const space::VolumeRow& row : made.volumes)
    text += fmt::format("between {} and {}: {:.6g} m3{}{}\n", row.upper, row.lower, row.volume.value,
                        row.volume.unsure > 0.0 ? fmt::format(" +- {:.6g} m3", row.volume.unsure) : "",
                        row.volume.below > 0.0 ? fmt::format(" ({:.6g} above, {:.6g} below)",
                                                             row.volume.value + row.volume.below, row.volume.below)
                                               : "");
  return text;
}

SpaceJson cut_json(const model::Model& model) {
  const auto& cut = *model.findings.get<space::CutSection>();
  SpaceJson json;
  json["length"] = cut.trace.length();
  json["left_end"] = cut.section.left_end;
  json["right_end"] = cut.section.right_end;
  SpaceJson lines = SpaceJson::array();
  const auto add = [&](const std::string& name, const std::string& piece_of, const char* kind,
                       const geom::Polyline& line) {
    SpaceJson points = SpaceJson::array();
    for (const geom::Point p : line.points) points.push_back({p.x, p.y});
    SpaceJson entry{{"name", name}, {"kind", kind}};
    if (!piece_of.empty()) entry["piece_of"] = piece_of;
    entry["points"] = std::move(points);
    lines.push_back(std::move(entry));
  };
  for (const section::Horizon& h : cut.section.horizons) add(h.name, h.piece_of, "horizon", h.line);
  for (const section::SectionLine& l : cut.section.lines) add(l.name, l.piece_of, kind_name(l.kind), l.line);
  json["lines"] = std::move(lines);
  std::vector<loft::Finding> findings = findings_of_surfaces(model);
  findings.insert(findings.end(), cut.findings.begin(), cut.findings.end());
  for (const std::string& remark : cut.remarks)
    findings.push_back({"section_remark", remark, {.item = "the new section"}});
  json["findings"] = dobra::cli::findings_json(findings, {});
  return json;
}

std::string cut_table(const model::Model& model) {
  const auto& cut = *model.findings.get<space::CutSection>();
  std::string text =
      fmt::format("section of {:.6g} m, {} - {}\n", cut.trace.length(), cut.section.left_end, cut.section.right_end);
  for (const section::Horizon& h : cut.section.horizons)
    text += fmt::format("horizon {:<20} {} points\n", h.name, h.line.points.size());
  for (const section::SectionLine& l : cut.section.lines)
    text += fmt::format("{:<7} {:<20} {} points\n", kind_name(l.kind), l.name, l.line.points.size());
  return text;
}

}  // namespace recon::cli
