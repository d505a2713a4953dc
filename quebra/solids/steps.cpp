#include "quebra/solids/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quebra/solids/cap_domain.h"
#include "shared/base/text.h"
#include "shared/io/formats/boundary_file.h"
#include "shared/solid/check/overlaps.h"
#include "shared/solid/shape/instance.h"
#include "shared/solid/shape/loft.h"
#include "shared/solid/shape/rounding.h"

namespace quebra::solids {
namespace {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Vector3;
using solid::Matrix;
using solid::Operation;
using solid::csg::Tree;

/// What has been evaluated in this process.
solid::csg::Evaluator& memory() {
  static solid::csg::Evaluator evaluator;
  return evaluator;
}

Vector3 vector(Point3 p) { return p - Point3{}; }

std::string label(const std::string& part) { return fmt::format("part '{}'", part); }

Result<void> check_name(const Parts& parts, const std::string& name) {
  if (name.empty()) return Error{ErrorCode::BadValue, "`part` is empty: give the result a name"};
  if (parts.find(name) == nullptr) return {};
  return Error{ErrorCode::BadValue, fmt::format("two parts are called '{}'; names must differ", name)};
}

/// Whether the step puts shapes into their places, so that it tells what was rounded; or makes them, so that it also
/// tells which of their faces are left out.
enum class Places { No, Moved, Made };

/// The model with one more part, evaluated.
Result<model::Model> with_part(const model::Model& model, Part part, Places places, const StepProgress& progress) {
  if (model.surfaces || !model.domain.curves.empty()) {
    return Error{ErrorCode::NotSupported,
                 "this document has a plane domain or surfaces; solids stand in a document whose [input] says solids = "
                 "true, and before any step `cut`"};
  }
  Parts parts = model.solids ? *model.solids : Parts{};
  DOBRA_TRY_VOID(check_name(parts, part.name));
  model::Model next = model;
  std::size_t rounded = 0;
  bool empty = true;
  for (Body& body : part.bodies) {
    auto made = memory().evaluate(body.tree, progress);
    if (!made) {
      Error error = made.error();
      error.message = fmt::format("{}: {}", label(part.name), error.message);
      return error;
    }
    rounded += made->rounded;
    for (const solid::OppositeFaces& faces : made->opposite) {
      if (places != Places::Made) break;
      next.remarks.push_back(fmt::format("{}: {}; at ({:.6g}, {:.6g}, {:.6g})", label(part.name), solid::message(faces),
                                         faces.at.x, faces.at.y, faces.at.z));
    }
    if (places == Places::Made && made->warped) {
      const Point3 at = made->warped->at;
      next.remarks.push_back(fmt::format("{}: {}; at ({:.6g}, {:.6g}, {:.6g})", label(part.name),
                                         solid::message(*made->warped), at.x, at.y, at.z));
    }
    body.solid = std::move(made->solid);
    empty = empty && body.solid.empty();
  }
  if (rounded > 0 && places != Places::No) {
    next.remarks.push_back(fmt::format("{}: points ({}) were rounded to the nearest numbers when they were placed",
                                       label(part.name), rounded));
  }
  if (empty) next.remarks.push_back(fmt::format("{} is empty", label(part.name)));
  parts.parts.push_back(std::move(part));
  next.solids = std::make_shared<const Parts>(std::move(parts));
  return next;
}

/// Turned along the axis, if there is one, then put there.
Result<Matrix> place_of(const std::string& part, Point3 at, const std::optional<Point3>& axis) {
  if (!axis) return solid::moved_by(vector(at));
  const double size = length(vector(*axis));
  if (!(size > 0.0) || !std::isfinite(size))
    return Error{ErrorCode::BadValue, fmt::format("{}: `axis` has no direction", label(part))};
  return solid::product(solid::moved_by(vector(at)), solid::along(vector(*axis)));
}

/// A shape of the library as a part.
Result<model::Model> with_shape(const model::Model& model, const PlacedPart& params, Result<solid::shape::Shape> shape,
                                const StepProgress& progress) {
  DOBRA_TRY(const Matrix matrix, place_of(params.part, params.at, params.axis));
  if (!shape) {
    Error error = shape.error();
    DOBRA_TRY_VOID(solid::put_error(error, matrix));
    error.message = fmt::format("{}: {}", label(params.part), error.message);
    return error;
  }
  for (std::string& name : shape->names) name = name.empty() ? params.part : fmt::format("{}_{}", params.part, name);
  // All that the solid depends on.
  std::string text = params.part + ':';
  for (const Point3& p : shape->mesh.points) text += fmt::format("{} {} {},", p.x, p.y, p.z);
  for (std::size_t f = 0; f < shape->mesh.faces.size(); ++f) {
    text += shape->names[f];
    for (const auto& loop : shape->mesh.faces[f]) {
      for (const std::uint32_t corner : loop) text += fmt::format(" {}", corner);
      text += ';';
    }
  }
  Tree tree = solid::csg::placed(solid::csg::leaf(std::move(text), *std::move(shape)), matrix);
  const std::string& material = params.material.empty() ? params.part : params.material;
  return with_part(model, {params.part, {{material, std::move(tree), {}}}}, Places::Made, progress);
}

/// The parts of those names. @error BadValue
Result<std::vector<const Part*>> parts_of(const model::Model& model, const std::vector<std::string>& names,
                                          const std::string& own, std::size_t least) {
  std::vector<const Part*> found;
  std::vector<std::string> known;
  if (model.solids) {
    for (const Part& part : model.solids->parts) known.push_back(part.name);
  }
  for (const std::string& name : names) {
    const Part* const part = model.solids ? model.solids->find(name) : nullptr;
    if (part != nullptr) {
      found.push_back(part);
    } else if (name == own) {
      return Error{ErrorCode::BadValue, fmt::format("part '{}' is made of itself; name parts of steps before", own)};
    } else {
      return Error{ErrorCode::BadValue,
                   fmt::format("no step before this one makes a part '{}'{}", name, base::did_you_mean(name, known))};
    }
  }
  if (found.size() < least)
    return Error{ErrorCode::BadValue,
                 fmt::format("`of` names too few parts, {}; {} or more are needed", found.size(), least)};
  return found;
}

std::vector<Tree> trees_of(std::span<const Part* const> parts) {
  std::vector<Tree> trees;
  for (const Part* part : parts) {
    for (const Body& body : part->bodies) trees.push_back(body.tree);
  }
  return trees;
}

/// Every body of the first part with all the others.
Result<model::Model> each_with_others(const model::Model& model, const OfParts& params, Operation operation,
                                      const StepProgress& progress) {
  DOBRA_TRY(const auto parts, parts_of(model, params.of, params.part, 2));
  const std::span<const Part* const> all = parts;
  Part result{params.part, {}};
  for (const Body& body : parts[0]->bodies) {
    std::vector<Tree> operands{body.tree};
    for (std::size_t i = 1; i < parts.size(); ++i) {
      std::vector<Tree> others = trees_of(all.subspan(i, 1));
      if (operation == Operation::Intersection && others.size() > 1)
        others = {solid::csg::combined(Operation::Union, std::move(others))};
      operands.insert(operands.end(), others.begin(), others.end());
    }
    result.bodies.push_back({body.material, solid::csg::combined(operation, std::move(operands)), {}});
  }
  return with_part(model, std::move(result), Places::No, progress);
}

/// What bodies of the last part have in common, which should stand side by side.
/// @param names  of the parts that they come from
Result<void> remark_overlaps(model::Model& model, std::span<const std::string> names) {
  const Part& group = model.solids->parts.back();
  std::vector<solid::Solid> solids;
  for (const Body& body : group.bodies) solids.push_back(body.solid);
  DOBRA_TRY(const solid::Combined all, solid::combine(solids, Operation::Union));
  if (all.contact != solid::Contact::Volume) return {};
  DOBRA_TRY(const auto overlaps, solid::check::overlaps(solids));
  for (const solid::check::Overlap& overlap : overlaps) {
    model.remarks.push_back(
        fmt::format("{}: '{}' and '{}' overlap: {:.6g} m3 are in both, where a section shows '{}' alone; at ({:.6g}, "
                    "{:.6g}, {:.6g})",
                    label(group.name), names[overlap.first], names[overlap.second], overlap.volume,
                    names[overlap.first], overlap.at.x, overlap.at.y, overlap.at.z));
  }
  return {};
}

solid::shape::Roundness roundness(const RoundPart& params, int rows = solid::shape::Roundness{}.rows) {
  return {.segments = params.segments, .rows = rows};
}

solid::shape::Profile profile_of(const OfProfile& params) {
  solid::shape::Profile profile{{params.points, true}, {}};
  for (const HoleParams& hole : params.holes) profile.holes.push_back({hole.points, true});
  return profile;
}

Result<Matrix> matrix_of(const PlaceParams& params) {
  Matrix matrix = solid::identity;
  if (!params.matrix.empty()) {
    if (params.matrix.size() != matrix.size()) {
      return Error{ErrorCode::BadValue,
                   fmt::format("`matrix` has {} numbers: give 16, row by row", params.matrix.size())};
    }
    if (params.scale || params.turn != 0.0 || params.by != Point3{})
      return Error{ErrorCode::BadValue, "`matrix` stands in place of scale, turn and by: give either"};
    std::copy(params.matrix.begin(), params.matrix.end(), matrix.begin());
  } else {
    const Vector3 axis = params.turn_axis ? vector(*params.turn_axis) : Vector3{0, 0, 1};
    if (!(length(axis) > 0.0)) return Error{ErrorCode::BadValue, "`turn_axis` has no direction"};
    if (params.scale) matrix = solid::scaled(params.about, vector(*params.scale));
    if (params.turn != 0.0) matrix = solid::product(solid::turned(params.about, axis, params.turn), matrix);
    matrix = solid::product(solid::moved_by(vector(params.by)), matrix);
  }
  DOBRA_TRY_VOID(solid::check_matrix(matrix));
  return matrix;
}

}  // namespace

std::size_t computed_last() { return memory().computed(); }

Result<solid::Solid> whole(const Part& part) {
  std::vector<solid::Solid> bodies;
  for (const Body& body : part.bodies) bodies.push_back(body.solid);
  if (bodies.size() == 1) return bodies[0];
  DOBRA_TRY(solid::Combined all, solid::combine(bodies, Operation::Union));
  return std::move(all.solid);
}

NextModel add_block(const model::Model& model, const BlockParams& params, const StepContext&,
                    const StepProgress& progress) {
  return with_shape(model, params, solid::shape::block(vector(params.size)), progress);
}
NextModel add_prism(const model::Model& model, const PrismParams& params, const StepContext&,
                    const StepProgress& progress) {
  return with_shape(model, params, solid::shape::prism(params.sides, params.radius, params.height), progress);
}
NextModel add_pyramid(const model::Model& model, const PyramidParams& params, const StepContext&,
                      const StepProgress& progress) {
  return with_shape(model, params, solid::shape::pyramid(params.sides, params.radius, params.height), progress);
}
NextModel add_cylinder(const model::Model& model, const CylinderParams& params, const StepContext&,
                       const StepProgress& progress) {
  return with_shape(model, params, solid::shape::cylinder(params.radius, params.height, roundness(params)), progress);
}
NextModel add_cone(const model::Model& model, const ConeParams& params, const StepContext&,
                   const StepProgress& progress) {
  return with_shape(model, params,
                    solid::shape::cone(params.radius, params.top_radius, params.height, roundness(params)), progress);
}
NextModel add_sphere(const model::Model& model, const SphereParams& params, const StepContext&,
                     const StepProgress& progress) {
  return with_shape(model, params, solid::shape::sphere(params.radius, roundness(params, params.rows)), progress);
}
NextModel add_torus(const model::Model& model, const TorusParams& params, const StepContext&,
                    const StepProgress& progress) {
  return with_shape(model, params,
                    solid::shape::torus(params.radius, params.minor_radius, roundness(params, params.rows)), progress);
}
NextModel add_extruded(const model::Model& model, const ExtrudeParams& params, const StepContext&,
                       const StepProgress& progress) {
  return with_shape(model, params, solid::shape::extrude(profile_of(params), vector(params.by)), progress);
}
NextModel add_swept(const model::Model& model, const SweepParams& params, const StepContext&,
                    const StepProgress& progress) {
  return with_shape(model, params, solid::shape::sweep(profile_of(params), params.path), progress);
}
NextModel add_revolved(const model::Model& model, const RevolveParams& params, const StepContext&,
                       const StepProgress& progress) {
  return with_shape(model, params,
                    solid::shape::revolve({params.points, true}, {.angle = params.angle, .segments = params.segments}),
                    progress);
}

NextModel add_lofted(const model::Model& model, const LoftParams& params, const StepContext&,
                     const StepProgress& progress) {
  std::vector<solid::shape::PlacedProfile> profiles;
  for (const LoftProfileParams& profile : params.profiles) {
    DOBRA_TRY(const Matrix matrix, place_of(params.part, profile.at, profile.axis));
    profiles.push_back({{{profile.points, true}, {}}, matrix});
  }
  return with_shape(model, params, solid::shape::loft(profiles), progress);
}

NextModel add_solid_file(const model::Model& model, const SolidFileParams& params, const StepContext& context,
                         const StepProgress& progress) {
  const std::string path = (context.folder / params.file).string();
  DOBRA_TRY(mesh::PolygonMesh mesh, io::formats::read_boundary(path));
  solid::shape::Shape shape;
  const double unit = context.units.to_si(1.0, "m");
  for (const Point3& p : mesh.points) shape.mesh.points.push_back({p.x * unit, p.y * unit, p.z * unit});
  for (auto& face : mesh.faces) shape.mesh.faces.push_back({std::move(face)});
  shape.names.assign(shape.mesh.faces.size(), "");
  return with_shape(model, params, std::move(shape), progress);
}

NextModel add_united(const model::Model& model, const UniteParams& params, const StepContext&,
                     const StepProgress& progress) {
  DOBRA_TRY(const auto parts, parts_of(model, params.of, params.part, 1));
  Tree tree = solid::csg::combined(Operation::Union, trees_of(parts));
  return with_part(model, {params.part, {{parts[0]->bodies[0].material, std::move(tree), {}}}}, Places::No, progress);
}
NextModel add_intersected(const model::Model& model, const IntersectParams& params, const StepContext&,
                          const StepProgress& progress) {
  return each_with_others(model, params, Operation::Intersection, progress);
}
NextModel add_subtracted(const model::Model& model, const SubtractParams& params, const StepContext&,
                         const StepProgress& progress) {
  return each_with_others(model, params, Operation::Difference, progress);
}

NextModel add_group(const model::Model& model, const GroupParams& params, const StepContext&,
                    const StepProgress& progress) {
  DOBRA_TRY(const auto parts, parts_of(model, params.of, params.part, 1));
  Part group{params.part, {}};
  std::vector<std::string> names;
  for (const Part* part : parts) {
    for (const Body& body : part->bodies) {
      group.bodies.push_back(body);
      names.push_back(part->name);
    }
  }
  DOBRA_TRY(model::Model next, with_part(model, std::move(group), Places::No, progress));
  DOBRA_TRY_VOID(remark_overlaps(next, names));
  return next;
}

NextModel add_placed(const model::Model& model, const PlaceParams& params, const StepContext&,
                     const StepProgress& progress) {
  DOBRA_TRY(const auto parts, parts_of(model, params.of, params.part, 1));
  DOBRA_TRY(const Matrix matrix, matrix_of(params));
  Part placed{params.part, {}};
  for (const Part* part : parts) {
    for (const Body& body : part->bodies)
      placed.bodies.push_back({body.material, solid::csg::placed(body.tree, matrix), {}});
  }
  return with_part(model, std::move(placed), Places::Moved, progress);
}

NextModel add_rounded(const model::Model& model, const RoundParams& params, const StepContext&,
                      const StepProgress& progress) {
  DOBRA_TRY(const auto parts, parts_of(model, params.of, params.part, 1));
  Part rounded{params.part, {}};
  for (const Part* part : parts) {
    for (const Body& body : part->bodies) {
      const solid::shape::RoundOptions options{params.radius, params.segments, params.part + "_round"};
      Tree tree = solid::csg::derived(
          fmt::format("rounded {} {} {}", options.radius, options.segments, options.name), body.tree,
          [options](const solid::Solid& of) { return solid::shape::round_convex(of, options); });
      rounded.bodies.push_back({body.material, std::move(tree), {}});
    }
  }
  return with_part(model, std::move(rounded), Places::No, progress);
}

}  // namespace quebra::solids
