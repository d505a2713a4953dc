#include "shared/io/faces/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shared/io/faces/face.h"

namespace dobra::io::faces {

namespace {

/// That edges of a wire are in another order is no fault of a file, and common: said once, at the first.
void say_orders_once(std::vector<surf::mesh::Finding>& findings) {
  const auto is_order = [](const surf::mesh::Finding& finding) { return finding.code == "loop_reordered"; };
  const auto count = std::count_if(findings.begin(), findings.end(), is_order);
  const auto first = std::find_if(findings.begin(), findings.end(), is_order);
  if (count < 2) return;
  first->message =
      fmt::format("the edges of {} wires are not in order, the first of them here; put so that ends meet", count);
  findings.erase(std::remove_if(first + 1, findings.end(), is_order), findings.end());
}

}  // namespace

base::Result<Imported> faces_of_model(const brep::Model& model, const ImportOptions& options) {
  DOBRA_TRY(const std::vector<brep::TrimmedFace> faces, brep::faces_of(model));
  Imported made;
  SharedEdges shared;
  std::map<brep::Index, std::vector<const brep::TrimmedFace*>> known;
  for (const brep::TrimmedFace& face : faces) {
    Report report(made.findings, face.place);
    std::vector<const brep::TrimmedFace*>& same = known[face.shape];
    const auto again = std::find_if(same.begin(), same.end(), [&](const brep::TrimmedFace* other) {
      return same_place(other->placement, face.placement);
    });
    if (again != same.end()) {
      report.say("face_twice", fmt::format("it is {} again, of another shell; taken once", (*again)->place.item));
      continue;
    }
    same.push_back(&face);
    auto outcome = imported(model, face, shared, options, report);
    if (auto* refusal = std::get_if<Refusal>(&outcome)) {
      ++made.refused;
      report.say(refusal->code, refusal->message, refusal->uv, refusal->at);
    } else {
      made.faces.push_back(std::get<surf::trim::TrimmedSurface>(std::move(outcome)));
    }
  }
  say_orders_once(made.findings);
  return made;
}

base::Result<Imported> faces_of_file(const std::string& path, const ImportOptions& options) {
  DOBRA_TRY(const brep::Model model, brep::read_brep(path));
  return faces_of_model(model, options);
}

}  // namespace dobra::io::faces
