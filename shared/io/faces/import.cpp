#include "shared/io/faces/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shared/io/faces/face.h"
#include "shared/io/faces/open_solids.h"
#include "shared/io/faces/unlike_edges.h"

namespace dobra::io::faces {

base::Result<Imported> faces_of_model(const brep::Model& model, const ImportOptions& options) {
  DOBRA_TRY(const std::vector<brep::TrimmedFace> faces, brep::faces_of(model));
  Imported made;
  SharedEdges shared;
  std::vector<base::Place> places;  // of made.faces
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
      places.push_back(face.place);
    }
  }
  part_unlike_edges(made.faces, places, made.findings);
  tell_open_solids(model, faces, made.findings);
  return made;
}

base::Result<Imported> faces_of_file(const std::string& path, const ImportOptions& options) {
  DOBRA_TRY(const brep::Model model, brep::read_brep(path));
  return faces_of_model(model, options);
}

}  // namespace dobra::io::faces
