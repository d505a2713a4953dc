#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "quebra/solids/cap_domain.h"
#include "quebra/solids/steps.h"
#include "shared/base/text.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/solid/check/settle.h"
#include "shared/solid/measure.h"

// 1. All bodies of the parts are cut in one go. 2. The cap becomes a sketch, the cracks are drawn into it, and a domain
// is made of that as of any drawing.

namespace quebra::solids {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;

/// What is cut: the parts of those names, or the last.
Result<std::vector<const Part*>> chosen(const model::Model& model, const std::vector<std::string>& names) {
  if (!model.solids || model.solids->parts.empty())
    return Error{ErrorCode::BadValue, "there is nothing to cut: no step before makes a part"};
  std::vector<const Part*> parts;
  std::vector<std::string> known;
  for (const Part& part : model.solids->parts) known.push_back(part.name);
  for (const std::string& name : names) {
    parts.push_back(model.solids->find(name));
    if (parts.back() == nullptr) {
      return Error{ErrorCode::BadValue,
                   fmt::format("no step before this one makes a part '{}'{}", name, base::did_you_mean(name, known))};
    }
  }
  if (parts.empty()) parts.push_back(&model.solids->parts.back());
  return parts;
}

Result<solid::CutPlane> plane_of(const std::vector<double>& numbers, const StepContext& context) {
  if (numbers.size() != 4) {
    return Error{ErrorCode::BadValue,
                 fmt::format("`plane` has {} numbers: give a, b, c, d of a x + b y + c z + d = 0", numbers.size())};
  }
  return solid::CutPlane{numbers[0], numbers[1], numbers[2], numbers[3] * context.units.to_si(1.0, "m")};
}

Error missed(solid::Contact contact) {
  const auto said = [](const char* text) { return Error{ErrorCode::BadDomain, text}; };
  switch (contact) {
    case solid::Contact::Vertex:
      return said("the plane only touches the solid, in a vertex: the section is empty");
    case solid::Contact::Edge:
      return said("the plane only touches the solid, in an edge: the section is empty");
    case solid::Contact::Face:
      return said("the plane only touches the solid, in a face: the section is empty");
    case solid::Contact::Nothing:
    case solid::Contact::Volume:
      break;
  }
  return said("the plane misses the solid: the section is empty");
}

}  // namespace

NextModel cut_to_domain(const model::Model& model, const CutParams& params, const StepContext& context,
                        const StepProgress& progress) {
  if (!model.domain.curves.empty())
    return Error{ErrorCode::BadDomain, "the model has a plane domain already; one step `cut` is enough"};
  DOBRA_TRY(const auto parts, chosen(model, params.of));
  DOBRA_TRY(const solid::CutPlane plane, plane_of(params.plane, context));
  std::vector<solid::Solid> solids;
  std::vector<std::string> materials;
  for (const Part* part : parts) {
    for (const Body& body : part->bodies) {
      solids.push_back(body.solid);
      materials.push_back(body.material);
    }
  }
  DOBRA_TRY(const solid::Section section, solid::Sections(solids).cut(plane));
  DOBRA_TRY_VOID(progress.check());
  const solid::Cap cap = solid::cap_of(section);
  DOBRA_TRY(const solid::PlaneContact contact, solid::contact_with(solids, plane));
  if (cap.empty()) return missed(contact.most);
  sketch::Sketch sketch = sketch_of(cap, materials, parts[0]->name);
  std::set<std::string> names;
  for (const sketch::Curve& curve : sketch.curves) names.insert(curve.name);
  for (const CutCrackParams& crack : params.cracks) {
    if (crack.points.size() < 2)
      return Error{ErrorCode::BadValue, fmt::format("crack '{}' needs two points or more", crack.name)};
    if (!names.insert(crack.name).second)
      return Error{ErrorCode::BadValue, fmt::format("two curves are called '{}'; names must differ", crack.name)};
    sketch.curves.push_back({.name = crack.name,
                             .role = sketch::Role::Crack,
                             .shape = geom::Polyline{crack.points, false},
                             .division = {},
                             .tip_size = crack.tip_size});
    sketch.places.emplace_back();
  }
  model::Model next = model;
  const double unit = context.units.to_si(1.0, "m");
  DOBRA_TRY(next.domain, domain::make_domain(std::move(sketch), {}));
  next.domain.unit = unit;
  next.remarks.push_back(fmt::format("pieces of the section: {}, curves: {}", cap.regions.size(), cap.lines.size()));
  if (contact.in_face) next.remarks.push_back(cut_in_face);
  for (const solid::SectionOverlap& overlap : section.overlaps) {
    if (materials[overlap.first] == materials[overlap.second]) continue;
    const Point3 at = section.frame.in_space(overlap.at);
    next.remarks.push_back(
        fmt::format("{}; at ({:.6g}, {:.6g}, {:.6g})", message(overlap, materials), at.x, at.y, at.z));
  }
  return next;
}

void add_part_quantities(const model::Model& model, std::vector<scenario::Quantity>& quantities) {
  if (!model.solids) return;
  for (const Part& part : model.solids->parts) {
    const auto solid = whole(part);
    if (!solid) continue;
    const solid::Measures measures = solid::measure(*solid);
    const solid::Counts counts = solid->counts();
    const std::string stem = "part." + part.name + '.';
    quantities.push_back({stem + "volume", measures.volume, "m3"});
    quantities.push_back({stem + "surface", measures.area, "m2"});
    quantities.push_back({stem + "shells", static_cast<double>(counts.shells), ""});
    quantities.push_back({stem + "genus", static_cast<double>(counts.handles), ""});
  }
}

void add_part_outputs(const std::shared_ptr<const model::Model>& model, std::vector<scenario::Output>& outputs) {
  if (!model->solids || model->solids->parts.empty()) return;
  outputs.push_back(
      {"solid.obj",
       [model](const std::filesystem::path& path) -> Result<void> {
         DOBRA_TRY(const solid::Solid solid, whole(model->solids->parts.back()));
         if (solid.empty()) return Error{ErrorCode::NotClosed, "the last part is empty; there is no file to write"};
         DOBRA_TRY(const solid::check::SettledMesh faces, solid::check::settle(solid, {.unit = model->domain.unit}));
         if (faces.flaw) {
           Error error = *faces.flaw;
           error.message =
               fmt::format("rounded as it would be in the file, the last part bounds no solid: {}", error.message);
           return error;
         }
         return io::formats::write_boundary(path.string(), faces.mesh);
       },
       {}});
}

}  // namespace quebra::solids
