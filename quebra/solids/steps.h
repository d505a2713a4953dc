#pragma once
// Steps that make parts of a model, and the one that cuts them to a plane domain. Every step evaluates its part, so
// that what is wrong is told with the step; what has been evaluated before is not computed again, in whichever document
// it stands. Pages: docs/user/solids.md, docs/algorithms/csg.md.
//
// @error BadValue: a name that is taken or that no step before has made; those of the functions of shared/solid.

#include "quebra/model/model.h"
#include "quebra/solids/cut_params.h"
#include "quebra/solids/operation_params.h"
#include "quebra/solids/parts.h"
#include "quebra/solids/profile_params.h"
#include "shared/scenario/program.h"

namespace quebra::solids {

using StepContext = dobra::scenario::Context;
using StepProgress = dobra::base::Progress;
using NextModel = dobra::base::Result<model::Model>;

NextModel add_block(const model::Model&, const BlockParams&, const StepContext&, const StepProgress&);
NextModel add_prism(const model::Model&, const PrismParams&, const StepContext&, const StepProgress&);
NextModel add_pyramid(const model::Model&, const PyramidParams&, const StepContext&, const StepProgress&);
NextModel add_cylinder(const model::Model&, const CylinderParams&, const StepContext&, const StepProgress&);
NextModel add_cone(const model::Model&, const ConeParams&, const StepContext&, const StepProgress&);
NextModel add_sphere(const model::Model&, const SphereParams&, const StepContext&, const StepProgress&);
NextModel add_torus(const model::Model&, const TorusParams&, const StepContext&, const StepProgress&);
NextModel add_extruded(const model::Model&, const ExtrudeParams&, const StepContext&, const StepProgress&);
NextModel add_swept(const model::Model&, const SweepParams&, const StepContext&, const StepProgress&);
NextModel add_revolved(const model::Model&, const RevolveParams&, const StepContext&, const StepProgress&);
NextModel add_lofted(const model::Model&, const LoftParams&, const StepContext&, const StepProgress&);
/// Lengths of the file are in the units of the document.
NextModel add_solid_file(const model::Model&, const SolidFileParams&, const StepContext&, const StepProgress&);
/// One body, of the first part's material.
NextModel add_united(const model::Model&, const UniteParams&, const StepContext&, const StepProgress&);
/// Every body of the first part, as far as it is in all the others.
NextModel add_intersected(const model::Model&, const IntersectParams&, const StepContext&, const StepProgress&);
/// Every body of the first part, without all the others.
NextModel add_subtracted(const model::Model&, const SubtractParams&, const StepContext&, const StepProgress&);
/// All bodies side by side; where they overlap, a section shows the first, and a remark tells of it.
NextModel add_group(const model::Model&, const GroupParams&, const StepContext&, const StepProgress&);
NextModel add_placed(const model::Model&, const PlaceParams&, const StepContext&, const StepProgress&);
NextModel add_rounded(const model::Model&, const RoundParams&, const StepContext&, const StepProgress&);

/// The model's domain becomes the section.
/// @error BadDomain: the plane misses the parts or only touches them; the model has a domain already; those of
///        make_domain
NextModel cut_to_domain(const model::Model&, const CutParams&, const StepContext&, const StepProgress&);

/// Volume, area, shells and genus of every part, "part.NAME.volume".
void add_part_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);
/// The last part as "solid.obj".
void add_part_outputs(const std::shared_ptr<const model::Model>& model, std::vector<dobra::scenario::Output>& outputs);

/// How many shapes and operations the last step had to compute.
std::size_t computed_last();

}  // namespace quebra::solids
