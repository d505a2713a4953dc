#include "quebra/cli/solid_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "quebra/model/model.h"
#include "quebra/solids/cap_domain.h"
#include "quebra/solids/parts.h"
#include "quebra/solids/tree_check.h"
#include "shared/base/text.h"
#include "shared/cli/commands.h"
#include "shared/cli/placement.h"
#include "shared/cli/staging.h"
#include "shared/io/file.h"
#include "shared/scenario/runner.h"

namespace quebra::cli {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Finding;
using base::Result;
using dobra::cli::Bodies;
using dobra::cli::Session;
using solid::Contact;

Result<const solids::Part*> chosen_part(const solids::Parts& parts, const std::string& name) {
  if (parts.parts.empty()) return Error{ErrorCode::BadValue, "the scenario makes no parts"};
  if (name.empty()) return &parts.parts.back();
  std::vector<std::string> known;
  for (const solids::Part& part : parts.parts) known.push_back(part.name);
  const solids::Part* const part = parts.find(name);
  if (part != nullptr) return part;
  return Error{ErrorCode::BadValue,
               fmt::format("--part: the scenario makes no part '{}'{}", name, base::did_you_mean(name, known))};
}

Finding empty_section(Contact contact) {
  if (contact == Contact::Nothing)
    return {"cut_misses", "--cut: the plane misses the solid; the section is empty and no file is written", {}};
  return {fmt::format("cut_touches_{}", solid::name(contact)),
          fmt::format("--cut: the plane only touches the solid, in {} {}; the section is empty and no file is written",
                      contact == Contact::Edge ? "an" : "a", solid::name(contact)),
          {}};
}

/// Whether QUEBRA takes the domain as it stands.
std::optional<Finding> flaw_of(const scenario::Program& program, const scenario::Document& document,
                               const std::filesystem::path& file) {
  scenario::Document named = document;
  named.file = file;
  const scenario::Run run = scenario::Runner(program).run(named);
  if (!run.error) return std::nullopt;
  return Finding{"cut_flawed", fmt::format("--cut: the section is no domain as it stands: {}", run.error->message),
                 run.error->place.value_or(base::Place{})};
}

}  // namespace

Result<Bodies> part_of_scenario(Session& session, const std::filesystem::path& file, const std::string& part,
                                const std::optional<std::string>& matrix, std::vector<Finding>& findings) {
  DOBRA_TRY(scenario::Document document, dobra::cli::load(session, {.file = file, .si = true, .assignments = {}}));
  const base::Place place{.file = file.string()};
  if (document.input.find("solids") == nullptr) {
    return Error{ErrorCode::BadValue, "is no scenario of solids: its [input] must say solids = true", place};
  }
  DOBRA_TRY_VOID(solids::check_tree(document));
  // What stands behind the parts says nothing of them.
  const auto last = std::find_if(document.steps.begin(), document.steps.end(),
                                 [](const auto& step) { return step.params.find("part") == nullptr; });
  document.steps.erase(last, document.steps.end());
  DOBRA_TRY(const scenario::Run run, dobra::cli::run_steps(session, document));
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  for (const std::string& remark : model.remarks) findings.push_back({"part_remark", remark, place});
  const auto found = chosen_part(*model.solids, part);
  if (!found) return base::located(found.error(), place);
  Bodies bodies;
  for (const solids::Body& body : (*found)->bodies) {
    if (!matrix) {
      bodies.bodies.push_back({body.material, body.solid});
      continue;
    }
    DOBRA_TRY(const solid::Matrix numbers, dobra::cli::parse_matrix(*matrix));
    DOBRA_TRY(solid::csg::Evaluated placed, solid::csg::Evaluator().evaluate(solid::csg::placed(body.tree, numbers)));
    if (placed.rounded > 0)
      findings.push_back({"placed_rounded",
                          fmt::format("points ({}) were rounded to the nearest numbers when they were placed; faces "
                                      "that are no longer plane are cut into triangles",
                                      placed.rounded),
                          place});
    bodies.bodies.push_back({body.material, std::move(placed.solid)});
  }
  return bodies;
}

nlohmann::ordered_json json_of(const CutFigures& figures) {
  const auto numbers = [](geom::Vector3 v) { return std::array<double, 3>{v.x, v.y, v.z}; };
  nlohmann::ordered_json json;
  json["area"] = figures.area;
  json["pieces"] = figures.pieces;
  json["holes"] = figures.holes;
  json["curves"] = figures.curves;
  json["regions"] = figures.regions;
  json["origin"] = numbers(figures.frame.origin - geom::Point3{});
  json["along"] = numbers(figures.frame.along);
  json["up"] = numbers(figures.frame.up);
  return json;
}

Result<CutFigures> cut_bodies(Session& session, const std::vector<Bodies::Body>& bodies, const solid::CutPlane& plane,
                              const std::optional<std::filesystem::path>& out, std::vector<Finding>& findings) {
  std::vector<solid::Solid> solids;
  std::vector<std::string> materials;
  for (const Bodies::Body& body : bodies) {
    solids.push_back(body.solid);
    materials.push_back(body.material);
  }
  DOBRA_TRY(const solid::Section section, solid::Sections(solids).cut(plane));
  const solid::Cap cap = solid::cap_of(section);
  DOBRA_TRY(const solid::PlaneContact contact, solid::contact_with(solids, plane));
  CutFigures figures;
  figures.frame = cap.frame;
  if (cap.empty()) {
    findings.push_back(empty_section(contact.most));
    return figures;
  }
  if (contact.in_face) findings.push_back({"cut_in_face", fmt::format("--cut: {}", solids::cut_in_face), {}});
  for (const solid::SectionOverlap& overlap : section.overlaps) {
    if (materials[overlap.first] == materials[overlap.second]) continue;
    const geom::Point3 at = section.frame.in_space(overlap.at);
    findings.push_back({"cut_overlap", fmt::format("--cut: {}", solids::message(overlap, materials)),
                        base::Place{.x = at.x, .y = at.y, .z = at.z}});
  }
  std::set<std::string> regions;
  for (const solid::CapRegion& region : cap.regions) {
    figures.area += region.area;
    figures.holes += region.holes;
    regions.insert(materials[region.solid]);
  }
  figures.pieces = cap.regions.size();
  figures.curves = cap.lines.size();
  figures.regions.assign(regions.begin(), regions.end());
  const scenario::Document document =
      solids::document_of(solids::sketch_of(cap, materials, materials[0]), plane, cap.frame);
  if (auto flaw = flaw_of(session.program, document, out.value_or(""))) findings.push_back(std::move(*flaw));
  if (out)
    DOBRA_TRY_VOID(dobra::cli::write_whole(session, *out, [&](const std::filesystem::path& path) {
      return io::write_text(path, scenario::document_text(document));
    }));
  return figures;
}

}  // namespace quebra::cli
